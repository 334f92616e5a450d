/* Faces as triangles with borders by index, and the solid between two of them: nothing is ever welded. */
#include "solid/cap.h"

#include <limits.h>
#include <stdbool.h>
#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "solid/keys.h"
#include "solid/polygon.h"

void wcut_cap_clear(wcut_cap *cap) {
    wcut_free(cap->vertex);
    wcut_free(cap->triangle);
    for (int b = 0; b < 4; b++) wcut_free(cap->border[b]);
    *cap = (wcut_cap){.vertex_count = 0};
}

static wcut_status cap_new(int vertices, int triangles, const int borders[4], wcut_cap *cap) {
    *cap = (wcut_cap){.vertex_count = vertices, .triangle_count = triangles};
    cap->vertex = wcut_alloc((size_t)vertices, sizeof *cap->vertex);
    cap->triangle = wcut_alloc((size_t)triangles, 3 * sizeof *cap->triangle);
    bool made = cap->vertex && cap->triangle;
    for (int b = 0; b < 4; b++) {
        cap->border_count[b] = borders[b];
        cap->border[b] = wcut_alloc((size_t)borders[b], sizeof *cap->border[b]);
        made = made && cap->border[b];
    }
    if (made) return WCUT_OK;
    wcut_cap_clear(cap);
    return WCUT_NO_MEMORY;
}

/* ---- the cut face ---- */

/* Columns of the grid lie in planes of x, its first and last row in those of y: what rounding made of that is undone. */
static void snap(wcut_cap *cap, int columns, int rows, wcut_sides sides) {
    for (int i = 0; i < columns; i++) {
        double x = cap->vertex[i].x;
        if (i == 0) x = sides.x[0];
        if (i == columns - 1) x = sides.x[1];
        for (int j = 0; j < rows; j++) cap->vertex[(ptrdiff_t)j * columns + i].x = x;
        cap->vertex[i].y = sides.y[0];
        cap->vertex[(ptrdiff_t)(rows - 1) * columns + i].y = sides.y[1];
    }
}

wcut_status wcut_cap_tessellate(const wcut_surface *patch, wcut_sides sides, double chord_tolerance, wcut_cap *cap,
                                double *chord_error) {
    wcut_mesh *mesh;
    wcut_tessellation_report report;
    wcut_cap l;
    wcut_status status = wcut_surface_tessellate(patch, chord_tolerance, &mesh, &report);
    if (status != WCUT_OK) return status;
    const int columns = report.columns, rows = report.rows, borders[4] = {rows, rows, columns, columns};
    status = mesh->triangle_count == 2 * (columns - 1) * (rows - 1) /* none that shrank to nothing was left out */
                 ? cap_new(mesh->vertex_count, mesh->triangle_count, borders, &l)
                 : WCUT_DEGENERATE;
    if (status == WCUT_OK) {
        memcpy(l.vertex, mesh->vertex, (size_t)mesh->vertex_count * sizeof *l.vertex);
        memcpy(l.triangle, mesh->triangle, (size_t)mesh->triangle_count * 3 * sizeof *l.triangle);
        snap(&l, columns, rows, sides);
        for (int j = 0; j < rows; j++) l.border[0][j] = j * columns, l.border[1][j] = j * columns + columns - 1;
        for (int i = 0; i < columns; i++) l.border[2][i] = i, l.border[3][i] = (rows - 1) * columns + i;
        *cap = l;
        *chord_error = report.chord_error;
    }
    wcut_mesh_destroy(mesh);
    return status;
}

int wcut_cap_is_graph(const wcut_cap *cap) {
    for (int t = 0; t < cap->triangle_count; t++) {
        wcut_point2d f[3];
        for (int k = 0; k < 3; k++) {
            const wcut_vec3 *p = &cap->vertex[cap->triangle[3 * (ptrdiff_t)t + k]];
            f[k] = (wcut_point2d){p->x, p->y};
        }
        if (!(wcut_orient2d(f[0], f[1], f[2]) > 0)) return 0;
    }
    for (int b = 0; b < 4; b++)
        for (int k = 1; k < cap->border_count[b]; k++) {
            const wcut_vec3 *p = &cap->vertex[cap->border[b][k - 1]], *q = &cap->vertex[cap->border[b][k]];
            if (b < 2 ? !(q->y > p->y) : !(q->x > p->x)) return 0;
        }
    return 1;
}

/* ---- the flat face with keys ---- */

static void add_circle(const wcut_key *key, int arcs, double radius, double z, wcut_vec3 *to) {
    for (int k = 0; k < arcs; k++) {
        const double turn = 2 * WCUT_PI * k / arcs;
        to[k] = vec3(key->x + radius * cos(turn), key->y + radius * sin(turn), z);
    }
}

/* triangulate loops of vertices seen from above: runs of loop sizes, holes stored counter-clockwise are turned */
static wcut_status add_region(const wcut_vec3 *vertex, int loops, const int *size, const int *start, int *triangle) {
    int points = 0;
    for (int l = 0; l < loops; l++) points += size[l];
    wcut_point2d *point = wcut_alloc((size_t)points, sizeof *point);
    int *index = wcut_alloc((size_t)points, sizeof *index);
    wcut_status status = point && index ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        int made = 0;
        for (int l = 0; l < loops; l++)
            for (int k = 0; k < size[l]; k++, made++) {
                index[made] = start[l] + (l == 0 ? k : size[l] - 1 - k);
                point[made] = (wcut_point2d){vertex[index[made]].x, vertex[index[made]].y};
            }
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
    size[0] = 4, start[0] = 0;
    for (int k = 0; k < 4; k++)
        l->vertex[k] = vec3(s.x[k == 1 || k == 2], s.y[k >= 2], z); /* around, counter-clockwise */
    const int border[4][2] = {{0, 3}, {1, 2}, {0, 1}, {3, 2}};
    for (int b = 0; b < 4; b++) memcpy(l->border[b], border[b], sizeof border[b]);
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
    l->triangle_count = (int)((to - l->triangle) / 3) + points + 2 * (count + 1) - 4;
    return add_region(l->vertex, count + 1, size, start, to);
}

wcut_status wcut_cap_flat(wcut_sides sides, double z, int count, const wcut_key *key, double chord_tolerance,
                          wcut_cap *cap) {
    if (!keys_fit(sides, count, key)) return WCUT_BAD_ARGUMENT;
    const int borders[4] = {2, 2, 2, 2};
    int *size = wcut_alloc(2 * ((size_t)count + 1), sizeof *size), *start = size ? size + count + 1 : NULL;
    if (!size) return WCUT_NO_MEMORY;
    int arcs = 0;
    for (int k = 0; k < count; k++) arcs += size[k + 1] = wcut_key_arcs(&key[k], chord_tolerance);
    wcut_cap l;
    wcut_status status = cap_new(4 + 2 * arcs, 4 + 4 * arcs + 2 * count, borders, &l);
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

/* ---- the solid ---- */

/* A side's region, seen from outside: along the floor's border, back along the ceiling's. */
static wcut_status enclose_side(const wcut_cap *floor, const wcut_cap *ceiling, int side, const wcut_vec3 *vertex,
                                int *triangle) {
    const int low = floor->border_count[side], high = ceiling->border_count[side], points = low + high;
    const bool along_y = side < 2, turned = side == 0 || side == 3; /* the plane's p runs to the right of who looks */
    wcut_point2d *point = wcut_alloc((size_t)points, sizeof *point);
    int *index = wcut_alloc((size_t)points, sizeof *index);
    wcut_status status = point && index ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        for (int k = 0; k < low; k++) index[k] = ceiling->vertex_count + floor->border[side][turned ? low - 1 - k : k];
        for (int k = 0; k < high; k++) index[low + k] = ceiling->border[side][turned ? k : high - 1 - k];
        for (int k = 0; k < points; k++) {
            const wcut_vec3 *x = &vertex[index[k]];
            const double p = along_y ? x->y : x->x;
            point[k] = (wcut_point2d){turned ? -p : p, x->z};
        }
        status = wcut_polygon_triangulate(1, &points, point, triangle);
        for (int k = 0; status == WCUT_OK && k < 3 * (points - 2); k++) triangle[k] = index[triangle[k]];
    }
    wcut_free(index);
    wcut_free(point);
    return status;
}

wcut_status wcut_cap_enclose(const wcut_cap *floor, const wcut_cap *ceiling, wcut_mesh **mesh) {
    size_t triangles = (size_t)floor->triangle_count + (size_t)ceiling->triangle_count;
    for (int b = 0; b < 4; b++) triangles += (size_t)floor->border_count[b] + (size_t)ceiling->border_count[b] - 2;
    if (triangles > INT_MAX / 3 || ceiling->vertex_count > INT_MAX - floor->vertex_count) return WCUT_BAD_ARGUMENT;
    wcut_mesh *m;
    wcut_status status = wcut_mesh_create(ceiling->vertex_count + floor->vertex_count, (int)triangles, 0, &m);
    if (status != WCUT_OK) return status;
    memcpy(m->vertex, ceiling->vertex, (size_t)ceiling->vertex_count * sizeof *m->vertex);
    memcpy(m->vertex + ceiling->vertex_count, floor->vertex, (size_t)floor->vertex_count * sizeof *m->vertex);
    int *to = m->triangle;
    memcpy(to, ceiling->triangle, (size_t)ceiling->triangle_count * 3 * sizeof *to);
    to += 3 * (ptrdiff_t)ceiling->triangle_count;
    for (int t = 0; t < floor->triangle_count; t++) { /* seen from below */
        const int *c = floor->triangle + 3 * (ptrdiff_t)t;
        *to++ = ceiling->vertex_count + c[0];
        *to++ = ceiling->vertex_count + c[2];
        *to++ = ceiling->vertex_count + c[1];
    }
    for (int b = 0; status == WCUT_OK && b < 4; b++) {
        status = enclose_side(floor, ceiling, b, m->vertex, to);
        to += 3 * (ptrdiff_t)(floor->border_count[b] + ceiling->border_count[b] - 2);
    }
    if (status == WCUT_OK) {
        *mesh = m;
    } else {
        wcut_mesh_destroy(m);
    }
    return status;
}
