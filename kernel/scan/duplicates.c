/* Points that come again: kept points in a hash of cubes twice the tolerance wide, so that eight cubes hold all that is
   near enough. Kept points are further apart than the tolerance, so a cube holds but a few. */
#include "scan/duplicates.h"

#include <stdint.h>

#include "base/alloc.h"
#include "base/vec3.h"

typedef struct table {
    int bits;
    int *head; /* 2^bits: the last point kept of a place, plus 1; 0 for none */
    int *next; /* count: the one before it */
    const wcut_vec3 *point;
    double side; /* [mm] of a cube */
} table;

static size_t duplicates_place_of(const table *t, double x, double y, double z) {
    /* whole numbers below 2^53 in doubles */
    uint64_t h = (uint64_t)(int64_t)x * 0x9e3779b97f4a7c15u;
    h = (h ^ h >> 29 ^ (uint64_t)(int64_t)y) * 0xbf58476d1ce4e5b9u;
    h = (h ^ h >> 32 ^ (uint64_t)(int64_t)z) * 0x94d049bb133111ebu;
    return (size_t)((h ^ h >> 31) * 0x9e3779b97f4a7c15u >> (64 - t->bits));
}

static bool duplicates_is_near(const table *t, size_t place, wcut_vec3 p, double tolerance) {
    for (int k = t->head[place]; k > 0; k = t->next[k - 1]) {
        const wcut_vec3 d = vec3_sub(t->point[k - 1], p);
        if (vec3_dot(d, d) <= tolerance * tolerance) return true;
    }
    return false;
}

/* the cube a point is in, and on each axis the neighbour that is nearer */
static bool has_earlier(const table *t, wcut_vec3 p, double tolerance, size_t *own) {
    const double c[3] = {p.x / t->side, p.y / t->side, p.z / t->side};
    double f[3], other[3];
    for (int a = 0; a < 3; a++) {
        f[a] = floor(c[a]);
        other[a] = c[a] - f[a] < 0.5 ? f[a] - 1 : f[a] + 1;
    }
    *own = duplicates_place_of(t, f[0], f[1], f[2]);
    if (duplicates_is_near(t, *own, p, tolerance)) return true;
    for (int corner = 1; tolerance > 0 && corner < 8; corner++) {
        const size_t place = duplicates_place_of(t, corner & 1 ? other[0] : f[0], corner & 2 ? other[1] : f[1],
                                                 corner & 4 ? other[2] : f[2]);
        if (duplicates_is_near(t, place, p, tolerance)) return true;
    }
    return false;
}

/* [mm] cubes so wide that their numbers stay below 2^50, and with a margin for rounding wider than the
   tolerance asks */
static double duplicates_side_of(int count, const wcut_vec3 *point, double tolerance) {
    double max = 0;
    for (int k = 0; k < count; k++) max = fmax(max, fmax(fabs(point[k].x), fmax(fabs(point[k].y), fabs(point[k].z))));
    const double side = fmax(2.001 * tolerance, ldexp(max, -50));
    return side > 0 ? side : 1;
}

wcut_status wcut_duplicates_find(int count, const wcut_vec3 *point, double tolerance, unsigned char *duplicate) {
    table t = {.bits = 4, .point = point, .side = duplicates_side_of(count, point, tolerance)};
    while (t.bits < 31 && (size_t)1 << t.bits < (size_t)count) t.bits++;
    t.head = wcut_alloc((size_t)1 << t.bits, sizeof *t.head);
    t.next = wcut_alloc((size_t)count, sizeof *t.next);
    const wcut_status status = t.head && t.next ? WCUT_OK : WCUT_NO_MEMORY;
    for (int k = 0; status == WCUT_OK && k < count; k++) {
        size_t own;
        if (has_earlier(&t, point[k], tolerance, &own)) {
            duplicate[k] = 1;
        } else {
            t.next[k] = t.head[own];
            t.head[own] = k + 1;
        }
    }
    wcut_free(t.head);
    wcut_free(t.next);
    return status;
}
