/* Cuts with a closed form, and what any half must be, seen without the room's own checks. */
#ifndef WCUT_TESTS_CUTS_H
#define WCUT_TESTS_CUTS_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/mould.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "test.h"

enum { CUT_SIZE = 41 };
static const wcut_vec3 cut_block = {400, 900, 300};

/* a loft through CUT_SIZE x CUT_SIZE nodes at(s, t), s along the wire, t over the stations */
static inline wcut_surface *cut_of(wcut_vec3 (*at)(double s, double t)) {
    static wcut_vec3 x[CUT_SIZE * CUT_SIZE];
    for (int j = 0; j < CUT_SIZE; j++)
        for (int i = 0; i < CUT_SIZE; i++) x[j * CUT_SIZE + i] = at(i / (CUT_SIZE - 1.0), j / (CUT_SIZE - 1.0));
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(CUT_SIZE, CUT_SIZE, x, 0, &s, NULL, NULL), WCUT_OK);
    return s;
}

/* over the block and 50 mm beyond its sides */
static inline wcut_vec3 cut_over(double s, double t, double z) { return vec3(500 * s - 50, 1000 * t - 50, z); }

static inline wcut_vec3 cut_level(double s, double t) { return cut_over(s, t, 140); }
static inline wcut_vec3 cut_tilted(double s, double t) {
    const wcut_vec3 p = cut_over(s, t, 0);
    return vec3(p.x, p.y, 150 + 0.1 * (p.x - 200) - 0.05 * (p.y - 450));
}

/* a wire that sags backwards by 60 mm, over hills */
static inline double cut_height(double x, double y) {
    return 150 + 40 * sin(0.007 * y + 0.004 * x) + 25 * cos(0.011 * x - 0.002 * y);
}
static inline wcut_vec3 cut_hilly(double s, double t) {
    const double x = 500 * s - 50, y = 1080 * t - 60 - 240 * s * (1 - s);
    return vec3(x, y, cut_height(x, y));
}

/* a wall that leans back over the cut: for t from 0 to 1 y goes on, back and on */
static inline wcut_vec3 cut_overhanging(double s, double t) {
    const double w = 2 * t - 1;
    return vec3(500 * s - 50, 450 + 560 * (1.3 * w * w * w - 0.3 * w), 150 + 90 * w);
}

/* a loop: the path crosses itself at y = 450 */
static inline wcut_vec3 cut_looped(double s, double t) {
    const double w = 2 * t - 1;
    return vec3(500 * s - 50, 450 + 600 * w - 150 * sin(2 * WCUT_PI * w), 150 - 60 * cos(2 * WCUT_PI * w));
}

/* up through the bottom at y = 150 and out of the top at y = 750 */
static inline wcut_vec3 cut_leaving(double s, double t) {
    const wcut_vec3 p = cut_over(s, t, 0);
    return vec3(p.x, p.y, 150 + 0.5 * (p.y - 450));
}

typedef struct cut_edge {
    int from, to;
} cut_edge;

static inline int cut_compare_edges(const void *a, const void *b) {
    const cut_edge *p = a, *q = b;
    if (p->from != q->from) return p->from < q->from ? -1 : 1;
    return (p->to > q->to) - (p->to < q->to);
}

/* every directed edge once, and its opposite: sorted, not counted by corners */
static inline bool cut_is_closed(const wcut_mesh *m) {
    const int count = 3 * m->triangle_count;
    cut_edge *edge = malloc((size_t)count * sizeof *edge);
    ck_assert_ptr_nonnull(edge);
    for (int k = 0; k < count; k++) edge[k] = (cut_edge){m->triangle[k], m->triangle[k % 3 == 2 ? k - 2 : k + 1]};
    qsort(edge, (size_t)count, sizeof *edge, cut_compare_edges);
    bool closed = count > 0;
    for (int k = 0; closed && k < count; k++) {
        const cut_edge back = {edge[k].to, edge[k].from};
        closed = edge[k].from != edge[k].to && (k == 0 || cut_compare_edges(&edge[k - 1], &edge[k]) != 0) &&
                 bsearch(&back, edge, (size_t)count, sizeof *edge, cut_compare_edges);
    }
    free(edge);
    return closed;
}

static inline double cut_volume(const wcut_mesh *m) {
    double sum = 0;
    for (int t = 0; t < m->triangle_count; t++) {
        const int *c = m->triangle + 3 * (ptrdiff_t)t;
        sum += vec3_dot(m->vertex[c[0]], vec3_cross(m->vertex[c[1]], m->vertex[c[2]]));
    }
    return sum / 6;
}

/* divide, with every claim of the report held against the meshes */
static inline wcut_mould *cut_divide(const wcut_surface *s, wcut_vec3 block, const wcut_mould_options *o) {
    wcut_mould *m = NULL;
    wcut_error error = {.text = ""};
    const wcut_status status = wcut_mould_create(s, block, o, &m, &error);
    ck_assert_msg(status == WCUT_OK, "%s: %s", wcut_status_text(status), error.text);
    const wcut_half *half[2] = {&m->lower, &m->upper};
    for (int k = 0; k < 2; k++) {
        const wcut_half_report *r = &half[k]->report;
        ck_assert(r->closed && r->oriented && r->self_intersections == 0);
        ck_assert(cut_is_closed(half[k]->mesh));
        ck_assert_double_gt(r->volume, 0);
        ck_assert_double_le(fabs(cut_volume(half[k]->mesh) - r->volume), 1e-9 * r->volume);
        for (int t = 0; t < half[k]->mesh->triangle_count; t++) {
            const int *c = half[k]->mesh->triangle + 3 * (ptrdiff_t)t;
            for (int i = 0; i < 3; i++) ck_assert(c[i] >= 0 && c[i] < half[k]->mesh->vertex_count);
        }
    }
    ck_assert_double_le(m->volume_error, 1e-6);
    if (m->kerf) ck_assert(cut_is_closed(m->kerf));
    return m;
}

/* the division is refused with this status, says why, and writes nothing */
static inline void cut_refused(const wcut_surface *s, wcut_vec3 block, const wcut_mould_options *o, wcut_status wanted,
                               const char *words) {
    wcut_mould *const mark = (wcut_mould *)&cut_block, *m = mark;
    wcut_error error = {.text = ""};
    const wcut_status status = wcut_mould_create(s, block, o, &m, &error);
    ck_assert_msg(status == wanted, "%s, expected %s: %s", wcut_status_text(status), wcut_status_text(wanted),
                  error.text);
    ck_assert(m == mark);
    ck_assert_msg(strstr(error.text, words) != NULL, "expected \"%s\" in: %s", words, error.text);
    ck_assert_int_eq(error.status, wanted);
    ck_assert_int_eq(wcut_mould_create(s, block, o, &m, NULL), wanted);
}

#endif
