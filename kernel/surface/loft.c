/* The bicubic surface through a wire's stations: skinning by two banded sweeps (Piegl, Tiller 1997, 9.2.5). */
#include "surface/loft.h"

#include <limits.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/interpolate.h"
#include "surface/rational.h"

/* Steps of v below this share of the whole carry rounding, not shape: such sections are dropped whatever `merge` is. */
static const double STEP_MIN = 1e-10;

/* mean distance of two sections; *most: the largest */
static double section_distance(int nodes, const wcut_vec3 *a, const wcut_vec3 *b, double *max) {
    double sum = 0;
    *max = 0;
    for (int i = 0; i < nodes; i++) {
        const double distance = vec3_distance(a[i], b[i]);
        sum += distance;
        *max = fmax(*max, distance);
    }
    return sum / nodes;
}

/* Pick the sections that differ from the one kept before: keep[] their stations, step[] the mean distances between
   them. Returns how many, 0 where lengths overflow. */
static int pick_sections(int stations, int nodes, const wcut_vec3 *position, double merge, int *keep, double *step) {
    double total = 0, max;
    for (int j = 1; j < stations; j++)
        total += section_distance(nodes, position + (ptrdiff_t)(j - 1) * nodes, position + (ptrdiff_t)j * nodes, &max);
    if (!isfinite(total)) return 0;
    int kept = 1;
    keep[0] = 0;
    for (int j = 1; j < stations; j++) {
        const wcut_vec3 *before = position + (ptrdiff_t)keep[kept - 1] * nodes;
        const double mean = section_distance(nodes, before, position + (ptrdiff_t)j * nodes, &max);
        if (max < merge || mean <= STEP_MIN * total) continue;
        step[kept - 1] = mean;
        keep[kept++] = j;
    }
    return kept;
}

void wcut_sections_clear(wcut_sections *sections) {
    wcut_free(sections->station);
    wcut_free(sections->v);
    *sections = (wcut_sections){.kept = 0};
}

wcut_status wcut_sections_pick(int stations, int nodes, const wcut_vec3 *position, double merge,
                               wcut_sections *sections) {
    wcut_sections s = {.kept = 0};
    s.station = wcut_alloc((size_t)stations, sizeof *s.station);
    s.v = wcut_alloc((size_t)stations, sizeof *s.v);
    double *step = wcut_alloc((size_t)stations, sizeof *step);
    wcut_status status = s.station && s.v && step ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        s.kept = pick_sections(stations, nodes, position, merge, s.station, step);
        status = s.kept >= 2 ? wcut_parameters_from_lengths(s.kept, step, s.v) : WCUT_DEGENERATE;
    }
    wcut_free(step);
    if (status == WCUT_OK) {
        *sections = s;
    } else {
        wcut_sections_clear(&s);
    }
    return status;
}

void wcut_sections_spread(const wcut_sections *s, int stations, double *parameter) {
    for (int j = 0, k = 0; j < stations; j++) {
        if (k + 1 < s->kept && s->station[k + 1] == j) k++;
        parameter[j] = s->v[k];
    }
}

/* fill a surface through the kept sections */
static wcut_status interpolate_grid(int nodes, const wcut_vec3 *position, const wcut_sections *sections,
                                    wcut_surface *s) {
    const int kept = sections->kept, *keep = sections->station;
    const double *v = sections->v;
    double *u = wcut_alloc((size_t)nodes, sizeof *u);
    if (!u) return WCUT_NO_MEMORY;
    for (int i = 0; i < nodes; i++) u[i] = (double)i / (nodes - 1);
    for (int j = 0; j < kept; j++)
        for (int i = 0; i < nodes; i++) s->control[(ptrdiff_t)j * nodes + i] = position[(ptrdiff_t)keep[j] * nodes + i];
    wcut_knots_average(s->degree_u, nodes, u, s->knots_u);
    wcut_knots_average(s->degree_v, kept, v, s->knots_v);
    wcut_status status = wcut_interpolate_rows(s->degree_u, nodes, s->knots_u, u, kept, s->control);
    if (status == WCUT_OK) status = wcut_interpolate_columns(s->degree_v, kept, s->knots_v, v, nodes, s->control);
    wcut_free(u);
    return status;
}

wcut_status wcut_surface_loft(int stations, int nodes, const wcut_vec3 *position, double merge, wcut_surface **surface,
                              double *parameter, wcut_loft_report *report) {
    if (stations < 2 || nodes < 2 || nodes > INT_MAX / 8 / stations || !position || !surface ||
        !(isfinite(merge) && merge >= 0) || !vec3_all_finite(stations * nodes, position))
        return WCUT_BAD_ARGUMENT;

    /* sections that move by more than `merge` */
    wcut_sections sections;
    wcut_surface *s = NULL;
    wcut_status status = wcut_sections_pick(stations, nodes, position, merge, &sections);
    if (status != WCUT_OK) return status;

    /* cubic in both directions, or of lower degree where there are few points */
    const int kept = sections.kept;
    status = wcut_surface_new(nodes > 3 ? 3 : nodes - 1, kept > 3 ? 3 : kept - 1, nodes, kept, false, &s);
    if (status == WCUT_OK) status = interpolate_grid(nodes, position, &sections, s);
    if (status == WCUT_SINGULAR) status = WCUT_DEGENERATE; /* steps so unequal that a pivot is lost to rounding */
    if (status == WCUT_OK && !vec3_all_finite(kept * nodes, s->control)) status = WCUT_DEGENERATE;

    /* parameters of the stations, and the report */
    if (status == WCUT_OK) {
        if (parameter) wcut_sections_spread(&sections, stations, parameter);
        if (report) *report = (wcut_loft_report){.used = kept, .dropped = stations - kept};
        *surface = s;
        s = NULL;
    }
    wcut_surface_destroy(s);
    wcut_sections_clear(&sections);

    return status;
}
