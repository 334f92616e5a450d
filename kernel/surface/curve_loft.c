/* A loft through unlike curves: each at the same points of equal arc length, as many as the most demanding one needs. */
#include <limits.h>
#include <stddef.h>
#include <wirecut/curve_loft.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/arc_table.h"
#include "surface/interpolate.h"

enum { NODES_FIRST = 9, NODES_MAX = 4097 };

/* of a section's length: ends nearer than this are one */
static const double SAME = 1e-9;

typedef struct sections {
    int count, nodes;
    wcut_arc_table *table; /* count */
    wcut_vec3 *point;      /* count x nodes */
} sections;

static void sections_clear(sections *s) {
    for (int j = 0; s->table && j < s->count; j++) wcut_arc_table_clear(&s->table[j]);
    wcut_free(s->table);
    wcut_free(s->point);
}

static wcut_status sections_fill(int count, const wcut_curve *const *curve, sections *s) {
    *s = (sections){.count = count};
    s->table = wcut_alloc((size_t)count, sizeof *s->table);
    wcut_status status = s->table ? WCUT_OK : WCUT_NO_MEMORY;
    for (int j = 0; j < count && status == WCUT_OK; j++) status = wcut_arc_table_fill(curve[j], &s->table[j]);
    return status;
}

static wcut_status sample_sections(sections *s, int nodes) {
    if (s->count > INT_MAX / 8 / nodes) return WCUT_NOT_CONVERGED;
    wcut_free(s->point);
    s->nodes = nodes;
    s->point = wcut_alloc((size_t)s->count, (size_t)nodes * sizeof *s->point);
    if (!s->point) return WCUT_NO_MEMORY;
    for (int j = 0; j < s->count; j++) wcut_arc_table_points(&s->table[j], nodes, s->point + (ptrdiff_t)j * nodes);
    return WCUT_OK;
}

/* the largest distance of the cubics through the nodes from their curves, at quarters between the nodes */
static wcut_status curve_loft_measure(const sections *s, double *max) {
    /* the cubic's parameters, even in arc length */
    const int n = s->nodes, fine = 4 * (n - 1) + 1;
    double *u = wcut_alloc((size_t)n, sizeof *u), *knots = wcut_alloc((size_t)n + 4, sizeof *knots);
    wcut_vec3 *control = wcut_alloc((size_t)n, sizeof *control), *exact = wcut_alloc((size_t)fine, sizeof *exact);
    wcut_status status = u && knots && control && exact ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        for (int i = 0; i < n; i++) u[i] = (double)i / (n - 1);
        wcut_knots_average(3, n, u, knots);
    }
    *max = 0;

    /* of each section the cubic through its nodes beside points of equal arc length */
    for (int j = 0; j < s->count && status == WCUT_OK; j++) {
        for (int i = 0; i < n; i++) control[i] = s->point[(ptrdiff_t)j * n + i];
        status = wcut_interpolate_rows(3, n, knots, u, 1, control);
        const wcut_curve c = {.degree = 3, .control_count = n, .knots = knots, .control = control};
        wcut_arc_table_points(&s->table[j], fine, exact);
        for (int i = 0; i < fine && status == WCUT_OK; i++) {
            wcut_vec3 p;
            wcut_curve_eval(&c, (double)i / (fine - 1), 0, &p);
            *max = fmax(*max, vec3_distance(p, exact[i]));
        }
    }

    wcut_free(exact);
    wcut_free(control);
    wcut_free(knots);
    wcut_free(u);
    return status;
}

static double mean_distance(int nodes, const wcut_vec3 *a, const wcut_vec3 *b, bool backwards) {
    double sum = 0;
    for (int i = 0; i < nodes; i++) sum += vec3_distance(a[i], b[backwards ? nodes - 1 - i : i]);
    return sum / nodes;
}

static void curve_loft_describe(const sections *s, wcut_curve_loft_report *r) {
    r->nodes = s->nodes, r->first_turned = -1;
    for (int j = 0; j < s->count; j++) {
        const wcut_vec3 *p = s->point + (ptrdiff_t)j * s->nodes;
        const double length = s->table[j].length[s->table[j].count - 1];
        const bool closed = length > 0 && vec3_distance(p[0], p[s->nodes - 1]) <= SAME * length;
        r->closed += closed;
        /* that a closed one runs the other way round is as much a twist */
        if (j == 0 || mean_distance(s->nodes, p - s->nodes, p, true) >= mean_distance(s->nodes, p - s->nodes, p, false))
            continue;
        if (r->turned++ == 0) r->first_turned = j;
    }
}

wcut_status wcut_surface_loft_curves(int count, const wcut_curve *const *curve, double merge, double tolerance,
                                     wcut_surface **surface, double *parameter, wcut_curve_loft_report *report) {
    /* check all arguments before any work */
    if (count < 2 || !curve || !surface || !(isfinite(merge) && merge >= 0) || !is_positive(tolerance))
        return WCUT_BAD_ARGUMENT;
    for (int j = 0; j < count; j++)
        if (!curve[j]) return WCUT_BAD_ARGUMENT;

    /* twice as many nodes until the sections are within the tolerance */
    sections s;
    wcut_curve_loft_report r = {.used = 0};
    wcut_loft_report loft = {.used = 0};
    wcut_status status = sections_fill(count, curve, &s);
    for (int nodes = NODES_FIRST; status == WCUT_OK; nodes = 2 * nodes - 1) {
        if (nodes > NODES_MAX) status = WCUT_NOT_CONVERGED;
        if (status == WCUT_OK) status = sample_sections(&s, nodes);
        if (status == WCUT_OK) status = curve_loft_measure(&s, &r.section_error);
        if (status == WCUT_OK && r.section_error <= tolerance) break;
    }

    /* the loft through the nodes, and the report */
    if (status == WCUT_OK) status = wcut_surface_loft(count, s.nodes, s.point, merge, surface, parameter, &loft);
    if (status == WCUT_OK && report) {
        curve_loft_describe(&s, &r);
        r.used = loft.used, r.dropped = loft.dropped;
        *report = r;
    }
    sections_clear(&s);

    return status;
}
