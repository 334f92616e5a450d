/* A polygon cut into triangles: ears cut off in its mean plane (Meisters 1975; the plane: Newell 1972). */
#include "io/mesh/polygon.h"

#include <math.h>
#include <stdbool.h>

typedef struct flat {
    double x, y;
} flat;

/* the two axes of the plane that loses least area, so that the polygon winds counter-clockwise in it */
static void find_axes(int count, const wcut_vec3 *corner, int axis[2]) {
    double n[3] = {0, 0, 0};
    for (int i = 0; i < count; i++) {
        const wcut_vec3 a = corner[i], b = corner[(i + 1) % count];
        n[0] += (a.y - b.y) * (a.z + b.z);
        n[1] += (a.z - b.z) * (a.x + b.x);
        n[2] += (a.x - b.x) * (a.y + b.y);
    }
    int max = fabs(n[1]) > fabs(n[0]) ? 1 : 0;
    if (fabs(n[2]) > fabs(n[max])) max = 2;
    axis[0] = (max + 1) % 3;
    axis[1] = (max + 2) % 3;
    if (n[max] < 0) {
        axis[0] = (max + 2) % 3;
        axis[1] = (max + 1) % 3;
    }
}

static flat project(wcut_vec3 p, const int axis[2]) {
    const double value[3] = {p.x, p.y, p.z};
    return (flat){value[axis[0]], value[axis[1]]};
}

/* twice the signed area */
static double turn_polygon(flat a, flat b, flat c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/* whether the corner at place k of the ring of `left` corners is convex, and no other one lies in its triangle */
static bool is_ear(int left, const int *ring, int k, const wcut_vec3 *corner, const int axis[2]) {
    const int before = ring[(k + left - 1) % left], at = ring[k], after = ring[(k + 1) % left];
    const flat a = project(corner[before], axis), b = project(corner[at], axis), c = project(corner[after], axis);
    if (!(turn_polygon(a, b, c) > 0)) return false;
    for (int j = 0; j < left; j++) {
        if (ring[j] == before || ring[j] == at || ring[j] == after) continue;
        const flat p = project(corner[ring[j]], axis);
        if (turn_polygon(a, b, p) >= 0 && turn_polygon(b, c, p) >= 0 && turn_polygon(c, a, p) >= 0) return false;
    }
    return true;
}

void wcut_polygon_split(int count, const wcut_vec3 *corner, int *triangle) {
    int ring[WCUT_POLYGON_MAX], axis[2], left = count;
    if (count < 3 || count > WCUT_POLYGON_MAX) return;
    find_axes(count, corner, axis);
    for (int i = 0; i < count; i++) ring[i] = i;
    while (left > 3) {
        int k = 0;
        while (k < left && !is_ear(left, ring, k, corner, axis)) k++;
        if (k == left) k = 0; /* crosses itself or is flat: any cut is as good */
        *triangle++ = ring[(k + left - 1) % left];
        *triangle++ = ring[k];
        *triangle++ = ring[(k + 1) % left];
        left--;
        for (int j = k; j < left; j++) ring[j] = ring[j + 1];
    }
    for (int k = 0; k < 3; k++) *triangle++ = ring[k];
}
