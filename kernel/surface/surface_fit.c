/* A surface with few control points near a grid of nodes: least squares along v, then along u, and measured. */
#include <limits.h>
#include <string.h>
#include <wirecut/surface_fit.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/line_fit.h"
#include "surface/loft.h"
#include "surface/rational.h"

enum { ROUNDS_MAX = 8 };

/* Of the tolerance, for each direction at first: their errors seldom come together. */
static const double SHARE = 0.6;

/* rows x columns -> columns x rows */
static void surface_fit_turn(int rows, int columns, const wcut_vec3 *from, wcut_vec3 *to) {
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++) to[(ptrdiff_t)i * rows + j] = from[(ptrdiff_t)j * columns + i];
}

/* kept x nodes points on a grid of parameters -> a surface that each direction misses by `share` at most */
static wcut_status fit_grid(int nodes, const double *u, int kept, const double *v, const wcut_vec3 *point, double share,
                            wcut_surface **surface) {
    /* along v for every node */
    wcut_line_fit along_v = {.count = 0}, along_u = {.count = 0};
    wcut_vec3 *turned = NULL;
    wcut_surface *s = NULL;
    wcut_status status = wcut_line_fit_points(kept, v, nodes, point, share, &along_v);

    /* turned, so that the control points of the first fit are data of the second */
    if (status == WCUT_OK) {
        turned = wcut_alloc((size_t)nodes, (size_t)along_v.count * sizeof *turned);
        if (!turned) status = WCUT_NO_MEMORY;
    }
    if (status == WCUT_OK) {
        surface_fit_turn(along_v.count, nodes, along_v.control, turned);
        status = wcut_line_fit_points(nodes, u, along_v.count, turned, share, &along_u);
    }

    if (status == WCUT_OK) status = wcut_surface_new(3, 3, along_u.count, along_v.count, false, &s);
    if (status == WCUT_OK) {
        memcpy(s->knots_u, along_u.knots, ((size_t)along_u.count + 4) * sizeof *s->knots_u);
        memcpy(s->knots_v, along_v.knots, ((size_t)along_v.count + 4) * sizeof *s->knots_v);
        surface_fit_turn(along_u.count, along_v.count, along_u.control, s->control);
        *surface = s;
    }
    wcut_free(turned);
    wcut_line_fit_clear(&along_u);
    wcut_line_fit_clear(&along_v);

    return status;
}

/* largest distances at the nodes, and from the loft through them half way between */
static wcut_status surface_fit_measure(const wcut_surface *s, const wcut_surface *loft, int nodes, const double *u,
                                       int kept, const double *v, const wcut_vec3 *point, double *at_nodes,
                                       double *between) {
    /* the nodes and the middles between them */
    const int wide = 2 * nodes - 1;
    double *at = wcut_alloc((size_t)wide, sizeof *at);
    wcut_vec3 *a = wcut_alloc((size_t)wide, sizeof *a), *b = wcut_alloc((size_t)wide, sizeof *b);
    wcut_status status = at && a && b ? WCUT_OK : WCUT_NO_MEMORY;
    double max = 0, max_between = 0;
    for (int i = 0; i < wide && status == WCUT_OK; i++) at[i] = i % 2 ? (u[i / 2] + u[i / 2 + 1]) / 2 : u[i / 2];

    /* at nodes against the points, between them against the loft */
    for (int j = 0; j < 2 * kept - 1 && status == WCUT_OK; j++) {
        const double here = j % 2 ? (v[j / 2] + v[j / 2 + 1]) / 2 : v[j / 2];
        status = wcut_surface_eval_grid(s, wide, at, 1, &here, a);
        if (status == WCUT_OK) status = wcut_surface_eval_grid(loft, wide, at, 1, &here, b);
        for (int i = 0; i < wide && status == WCUT_OK; i++) {
            if (i % 2 == 0 && j % 2 == 0) {
                max = fmax(max, vec3_distance(a[i], point[(ptrdiff_t)(j / 2) * nodes + i / 2]));
            } else {
                max_between = fmax(max_between, vec3_distance(a[i], b[i]));
            }
        }
    }

    /* both figures or none */
    wcut_free(b);
    wcut_free(a);
    wcut_free(at);
    if (status == WCUT_OK) *at_nodes = max, *between = max_between;

    return status;
}

/* fit, measure, and ask each direction for less where both together miss too much */
static wcut_status fit_until_held(const wcut_surface *loft, int nodes, const double *u, int kept, const double *v,
                                  const wcut_vec3 *point, double tolerance, wcut_surface **surface,
                                  wcut_surface_fit_report *report) {
    double share = SHARE * tolerance;
    for (int round = 0;; round++) {
        /* each direction may miss by `share` */
        wcut_surface *s;
        double at_nodes = 0, between = 0;

        wcut_status status = fit_grid(nodes, u, kept, v, point, share, &s);
        if (status != WCUT_OK) return status;
        status = surface_fit_measure(s, loft, nodes, u, kept, v, point, &at_nodes, &between);

        /* hold the tolerance together, or try again with less */
        const double max = fmax(at_nodes, between);
        if (status == WCUT_OK && max <= tolerance) {
            report->node_error = at_nodes, report->between_error = between;
            *surface = s;
            return WCUT_OK;
        }
        wcut_surface_destroy(s);
        if (status != WCUT_OK) return status;
        /* a tolerance that rounding alone exceeds leaves the loft itself: with nothing to miss all is interpolated */
        share = round < ROUNDS_MAX ? share * clamp(0.9 * tolerance / max, 0.1, 0.8) : 0;
        if (round > ROUNDS_MAX) return WCUT_NOT_CONVERGED;
    }
}

/* the loft itself, where there are too few nodes to save any, or rounding alone misses more than the tolerance */
static void report_loft(const wcut_surface *loft, wcut_surface_fit_report *report) {
    report->node_error = report->between_error = 0;
    report->control_count = loft->count_u * loft->count_v;
}

wcut_status wcut_surface_fit(int stations, int nodes, const wcut_vec3 *position, double merge, double tolerance,
                             wcut_surface **surface, double *parameter, wcut_surface_fit_report *report) {
    if (!surface || !is_positive(tolerance)) return WCUT_BAD_ARGUMENT;
    wcut_surface *loft = NULL, *s = NULL;
    wcut_sections sections = {.kept = 0};
    wcut_surface_fit_report r = {.node_error = 0};
    double *u = NULL;
    wcut_vec3 *point = NULL;
    wcut_status status = wcut_surface_loft(stations, nodes, position, merge, &loft, NULL, NULL);
    if (status == WCUT_OK) status = wcut_sections_pick(stations, nodes, position, merge, &sections);
    if (status != WCUT_OK) goto done;

    /* few nodes: the loft through them is the fit */
    const int kept = sections.kept;
    if (nodes < 5 || kept < 5) {
        s = loft, loft = NULL;
        report_loft(s, &r);
    } else {
        /* the nodes of the sections used, then fits with more knots until the tolerance holds */
        u = wcut_alloc((size_t)nodes, sizeof *u);
        point = wcut_alloc((size_t)kept, (size_t)nodes * sizeof *point);
        status = u && point ? WCUT_OK : WCUT_NO_MEMORY;
        for (int i = 0; i < nodes && status == WCUT_OK; i++) u[i] = (double)i / (nodes - 1);
        for (int j = 0; j < kept && status == WCUT_OK; j++)
            memcpy(point + (ptrdiff_t)j * nodes, position + (ptrdiff_t)sections.station[j] * nodes,
                   (size_t)nodes * sizeof *point);
        if (status == WCUT_OK) status = fit_until_held(loft, nodes, u, kept, sections.v, point, tolerance, &s, &r);
        if (status != WCUT_OK) goto done;
        r.control_count = s->count_u * s->count_v;
    }

    /* hand out */
    if (parameter) wcut_sections_spread(&sections, stations, parameter);
    r.used = kept, r.dropped = stations - kept, r.node_count = kept * nodes;
    if (report) *report = r;
    *surface = s;

done:
    wcut_free(point);
    wcut_free(u);
    wcut_sections_clear(&sections);

    wcut_surface_destroy(loft);
    return status;
}
