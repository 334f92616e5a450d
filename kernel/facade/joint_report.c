/* What is left between two faces at their joint, and the points of all faces in space. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "facade/layout.h"

enum { COUNT = WCUT_FACADE_SAMPLES, END = COUNT - 1 };

/* both sides' points meet in one where they are no further apart [mm] */
static const double ONE_POINT = 1e-9;

/* ---- a joint ---- */

static int by_angle(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* the height of a face's border above the facade's base, as it is or as it was cut */
static double border_height(const wcut_facade_element *e, const wcut_element_face *f, int border, int k, bool cut) {
    const wcut_vec3 p = border < 2 ? f->point[(ptrdiff_t)k * COUNT + (border ? END : 0)]
                                   : f->point[(ptrdiff_t)(border == 3 ? END : 0) * COUNT + k];
    const double z = cut ? f->cut[border][k] : p.z;
    return e->mirrored ? f->block.z - z : z;
}

/* the face's normal at a sample of a border, in space, away from the facade's base */
static wcut_status border_normal(const wcut_facade_element *e, const wcut_element_face *f, int border, int k,
                                 wcut_vec3 *normal) {
    const double share = (double)k / END;
    wcut_vec3 ders[4];
    const wcut_status status =
        wcut_surface_eval(f->surface, border < 2 ? border : share, border < 2 ? share : border - 2, 1, ders);
    const wcut_vec3 n = vec3_unit(vec3_cross(ders[2], ders[1]));
    const wcut_vec3 turned = vec3_add_scaled(vec3_add_scaled(vec3_scale(n.x, e->x), n.y, e->y), n.z, e->z);
    *normal = e->mirrored ? vec3_scale(-1, turned) : turned;
    return status;
}

wcut_status wcut_joint_eval(const wcut_facade *facade, int joint, const wcut_element_face *first,
                            const wcut_element_face *second, wcut_joint_report *report) {
    if (!facade || joint < 0 || joint >= facade->joints || !first || !second || !report) return WCUT_BAD_ARGUMENT;
    const wcut_facade_joint *j = &facade->joint[joint];
    const wcut_facade_element *e[2] = {&facade->element[j->element[0]], &facade->element[j->element[1]]};
    const wcut_element_face *f[2] = {first, second};

    /* heights and normals at every sample */
    wcut_joint_report r = {0};
    double angle[COUNT];
    for (int k = 0; k < COUNT; k++) {
        const int other = j->reversed ? END - k : k;
        wcut_vec3 n[2];
        const double gap =
            border_height(e[0], f[0], j->border[0], k, false) - border_height(e[1], f[1], j->border[1], other, false);
        const double step =
            border_height(e[0], f[0], j->border[0], k, true) - border_height(e[1], f[1], j->border[1], other, true);
        for (int s = 0; s < 2; s++) {
            const wcut_status status = border_normal(e[s], f[s], j->border[s], s ? other : k, &n[s]);
            if (status != WCUT_OK) return status;
        }
        r.gap_max = fmax(r.gap_max, fabs(gap));
        r.step_max = fmax(r.step_max, fabs(step));
        angle[k] = atan2(vec3_length(vec3_cross(n[0], n[1])), vec3_dot(n[0], n[1]));
    }
    qsort(angle, COUNT, sizeof *angle, by_angle);
    r.angle_min = angle[0], r.angle_median = angle[COUNT / 2], r.angle_max = angle[END];
    *report = r;
    return WCUT_OK;
}

/* ---- all points ---- */

static wcut_vec3 *border_sample(wcut_vec3 *point, int element, int border, int k) {
    wcut_vec3 *p = point + (ptrdiff_t)element * COUNT * COUNT;
    return border < 2 ? p + (ptrdiff_t)k * COUNT + (border ? END : 0)
                      : p + (ptrdiff_t)(border == 3 ? END : 0) * COUNT + k;
}

/* where both have one edge without a gap, the second element takes the first one's points */
static void take_joint_points(const wcut_facade *facade, int element, wcut_vec3 *point) {
    for (int b = 0; b < 4; b++) {
        const int joint = facade->element[element].joint[b];
        if (joint < 0 || facade->joint[joint].element[1] != element) continue;
        const wcut_facade_joint *j = &facade->joint[joint];
        for (int k = 0; k < COUNT; k++) {
            const wcut_vec3 *from = border_sample(point, j->element[0], j->border[0], k);
            wcut_vec3 *to = border_sample(point, element, b, j->reversed ? END - k : k);
            if (vec3_distance(*from, *to) <= ONE_POINT) *to = *from;
        }
    }
}

wcut_status wcut_facade_points(const wcut_facade *facade, const wcut_element_face *const *face, wcut_vec3 *point) {
    if (!facade || !face || !point) return WCUT_BAD_ARGUMENT;
    for (int e = 0; e < facade->elements; e++) {
        const wcut_facade_element *element = &facade->element[e];
        const wcut_vec3 block = element->job->block_size;
        for (int k = 0; k < COUNT * COUNT; k++) {
            const int row = k / COUNT, column = k % COUNT;
            const wcut_vec3 flat = vec3(block.x * column / END, block.y * row / END, element->mirrored ? block.z : 0);
            point[(ptrdiff_t)e * COUNT * COUNT + k] = wcut_element_point(element, face[e] ? face[e]->point[k] : flat);
        }
        take_joint_points(facade, e, point);
    }
    return WCUT_OK;
}
