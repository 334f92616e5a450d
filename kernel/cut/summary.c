/* A cut in a few figures. */
#include <wirecut/summary.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/sort.h"

static double front_speed(const wcut_history_row *r) { return fmax(r->speed_a, r->speed_b); }

static void widen(wcut_range *range, double a, double b) {
    range->min = fmin(range->min, fmin(a, b));
    range->max = fmax(range->max, fmax(a, b));
}

static void add_summary_row(wcut_summary *s, const wcut_history_row *r) {
    widen(&s->speed, front_speed(r), front_speed(r));
    widen(&s->alpha, r->alpha_a, r->alpha_b);
    widen(&s->beta, r->beta_a, r->beta_b);
    widen(&s->tension, r->tension_a, r->tension_b);
    s->residual_max = fmax(s->residual_max, r->residual);
    s->iterations_mean += r->iterations;
    s->substeps_mean += r->substeps;
    if (r->iterations > s->iterations_max) s->iterations_max = r->iterations;
    if (r->substeps > s->substeps_max) s->substeps_max = r->substeps;
    s->conditions[r->condition]++;
    s->phases[r->phase]++;
}

wcut_status wcut_summary_eval(const wcut_history *h, wcut_summary *summary) {
    if (!h || h->stations < 1 || h->nodes < 1 || !h->row || !h->force_line || !summary) return WCUT_BAD_ARGUMENT;
    const int first = h->stations > 1, count = h->stations - first; /* nothing moved to station 0 */

    /* medians need the speeds in an array of their own */
    double *speed = wcut_alloc((size_t)count, sizeof *speed);
    if (!speed) return WCUT_NO_MEMORY;

    /* extremes start outside of every value */
    const wcut_range none = {INFINITY, -INFINITY};
    wcut_summary s = {
        .duration = h->row[h->stations - 1].time, .speed = none, .alpha = none, .beta = none, .tension = none};

    /* sums and extremes over the stations */
    for (int j = 0; j < count; j++) {
        add_summary_row(&s, &h->row[first + j]);
        speed[j] = front_speed(&h->row[first + j]);
    }

    /* means, the largest force along the wire, and the median speed */
    s.iterations_mean /= count;
    s.substeps_mean /= count;
    for (size_t i = 0; i < (size_t)h->stations * (size_t)h->nodes; i++)
        s.force_line_max = fmax(s.force_line_max, h->force_line[i]);
    wcut_sort(count, speed);
    s.speed_median = sorted_median(count, speed);
    wcut_free(speed);
    *summary = s;

    return WCUT_OK;
}
