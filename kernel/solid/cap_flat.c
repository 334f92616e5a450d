/* A flat face with registration keys: circles and their flanks, the rest triangulated around them. */
#include "solid/cap_flat.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "solid/keys.h"
#include "solid/polygon.h"

static void add_circle(const wcut_key *key, int arcs, double radius, double z, wcut_vec3 *to) {
    for (int k = 0; k < arcs; k++) {
        const double turn = 2 * WCUT_PI * k / arcs;
        to[k] = vec3(key->x + radius * cos(turn), key->y + radius * sin(turn), z);
    }
}

/* triangulate loops of vertices seen from above: runs of loop sizes, holes stored counter-clockwise are turned */
static wcut_status add_region(const wcut_vec3 *vertex, int loops, const int *size, const int *start, int *triangle) {
    /* room for all loops together */
    int points = 0;
    for (int l = 0; l < loops; l++) points += size[l];
    wcut_point2d *point = wcut_alloc((size_t)points, sizeof *point);
    int *index = wcut_alloc((size_t)points, sizeof *index);
    wcut_status status = point && index ? WCUT_OK : WCUT_NO_MEMORY;

    /* vertices of the loops; holes are turned */
    if (status == WCUT_OK) {
        int made = 0;
        for (int l = 0; l < loops; l++)
            for (int k = 0; k < size[l]; k++, made++) {
                index[made] = start[l] + (l == 0 ? k : size[l] - 1 - k);
                point[made] = (wcut_point2d){vertex[index[made]].x, vertex[index[made]].y};
            }

        /* triangulate in the plane, then back to indices of the cap */
        status = wcut_polygon_triangulate(loops, size, point, triangle);
        const int corners = 3 * (points + 2 * loops - 4);
        for (int k = 0; status == WCUT_OK && k < corners; k++) triangle[k] = index[triangle[k]];
    }

    wcut_free(index);
    wcut_free(point);
    return status;
}

/* the flank between two circles, from `base` to `tip`; gives the end */
static int *add_flank(int arcs, int base, int tip, int *to) {
    for (int k = 0; k < arcs; k++) {
        const int next = (k + 1) % arcs;
        *to++ = base + k, *to++ = base + next, *to++ = tip + next;
        *to++ = base + k, *to++ = tip + next, *to++ = tip + k;
    }
    return to;
}

/* circles inside the sides and apart from each other */
static bool keys_fit(wcut_sides sides, int count, const wcut_key *key) {
    for (int k = 0; k < count; k++) {
        const double r = key[k].radius;
        if (!(key[k].x - r > sides.x[0] && key[k].x + r < sides.x[1] && key[k].y - r > sides.y[0] &&
              key[k].y + r < sides.y[1]))
            return false;
        for (int o = 0; o < k; o++)
            if (!(hypot(key[k].x - key[o].x, key[k].y - key[o].y) > r + key[o].radius)) return false;
    }
    return true;
}

/* vertices of corners and circles, then triangles; size and start have room for count + 1 loops */
static wcut_status fill_flat(wcut_sides s, double z, int count, const wcut_key *key, int *size, int *start,
                             wcut_cap *l) {
    /* four corners and the borders between them */
    size[0] = 4, start[0] = 0;
    for (int k = 0; k < 4; k++)
        l->vertex[k] = vec3(s.x[k == 1 || k == 2], s.y[k >= 2], z); /* around, counter-clockwise */
    const int border[4][2] = {{0, 3}, {1, 2}, {0, 1}, {3, 2}};
    for (int b = 0; b < 4; b++) memcpy(l->border[b], border[b], sizeof border[b]);

    /* each key: circle, flank and tip */
    int made = 4, points = 4;
    int *to = l->triangle;
    for (int k = 0; k < count; k++) {
        const int arcs = size[k + 1];
        start[k + 1] = made;
        points += arcs;
        add_circle(&key[k], arcs, key[k].radius, z, l->vertex + made);
        add_circle(&key[k], arcs, key[k].tip_radius, z + wcut_key_rise(&key[k]), l->vertex + made + arcs);
        to = add_flank(arcs, made, made + arcs, to);
        const int tip = made + arcs;
        const wcut_status status = add_region(l->vertex, 1, &arcs, &tip, to);
        if (status != WCUT_OK) return status;
        to += 3 * (ptrdiff_t)(arcs - 2);
        made += 2 * arcs;
    }

    /* the rest of the face, around the circles */
    l->triangle_count = (int)((to - l->triangle) / 3) + points + 2 * (count + 1) - 4;

    return add_region(l->vertex, count + 1, size, start, to);
}

wcut_status wcut_cap_flat(wcut_sides sides, double z, int count, const wcut_key *key, double chord_tolerance,
                          wcut_cap *cap) {
    /* each border has two vertices; circles have as many as the chord tolerance asks for */
    if (!keys_fit(sides, count, key)) return WCUT_BAD_ARGUMENT;
    const int borders[4] = {2, 2, 2, 2};
    int *size = wcut_alloc(2 * ((size_t)count + 1), sizeof *size), *start = size ? size + count + 1 : NULL;
    if (!size) return WCUT_NO_MEMORY;
    int arcs = 0;
    for (int k = 0; k < count; k++) arcs += size[k + 1] = wcut_key_arcs(&key[k], chord_tolerance);

    wcut_cap l;
    wcut_status status = wcut_cap_create(4 + 2 * arcs, 4 + 4 * arcs + 2 * count, borders, &l);
    if (status == WCUT_OK) {
        status = fill_flat(sides, z, count, key, size, start, &l);
        if (status == WCUT_OK) {
            *cap = l;
        } else {
            wcut_cap_clear(&l);
        }
    }

    wcut_free(size);
    return status;
}
