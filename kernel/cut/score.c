/* How far predictions are from measurements: RMSD over the range of the measured data (Rust et al. 2016, note 4), and
   beside it the figures that a bias does not escape. */
#include "cut/score.h"

#include "base/numbers.h"

#define NAME_ENTRY(name, text, unit, first, last) text,
#define UNIT_ENTRY(name, text, unit, first, last) unit,
static const char *const scored_name[] = {WCUT_SCORED_LIST(NAME_ENTRY)};
static const char *const scored_unit[] = {WCUT_SCORED_LIST(UNIT_ENTRY)};

const char *wcut_scored_name(wcut_scored scored) {
    return (unsigned)scored < WCUT_SCORED_COUNT ? scored_name[scored] : "";
}

const char *wcut_scored_unit(wcut_scored scored) {
    return (unsigned)scored < WCUT_SCORED_COUNT ? scored_unit[scored] : "";
}

const char *wcut_part_name(wcut_part part) {
    static const char *const name[] = {"all", "entry", "steady", "exit"};
    return (unsigned)part < WCUT_PART_COUNT ? name[part] : "";
}

/* ---- figures ---- */

static double range_of(int n, const double *x) {
    double low = x[0], high = x[0];
    for (int i = 1; i < n; i++) low = fmin(low, x[i]), high = fmax(high, x[i]);
    return high - low;
}

/* Pearson's, from deviations of the means */
static bool correlate(int n, const double *x, const double *y, double *correlation) {
    double mx = 0, my = 0, xx = 0, yy = 0, xy = 0;
    for (int i = 0; i < n; i++) mx += x[i] / n, my += y[i] / n;
    for (int i = 0; i < n; i++) {
        const double dx = x[i] - mx, dy = y[i] - my;
        xx += dx * dx, yy += dy * dy, xy += dx * dy;
    }
    /* values that differ by rounding alone do not vary */
    const double min = 1e-24 * n;
    if (!(xx > min * mx * mx) || !(yy > min * my * my)) return false;
    *correlation = clamp(xy / sqrt(xx) / sqrt(yy), -1, 1);
    return true;
}

wcut_score wcut_score_of(int n, const double *x, const double *y, double range) {
    wcut_score s = {.count = n};
    if (n == 0) return s;
    for (int i = 0; i < n; i++) s.bias += (x[i] - y[i]) / n;
    double about = 0, square = 0;
    for (int i = 0; i < n; i++) {
        const double d = x[i] - y[i];
        about += (d - s.bias) * (d - s.bias), square += d * d;
    }
    s.rmsd = n > 1 ? sqrt(about / (n - 1)) : 0;
    s.rmse = sqrt(square / n);
    s.range = range > 0 ? range : range_of(n, x);
    s.nrmsd = s.range > 0 ? s.rmsd / s.range : 0;
    s.rmse_over_range = s.range > 0 ? s.rmse / s.range : 0;
    s.correlated = correlate(n, x, y, &s.correlation);
    return s;
}

wcut_status wcut_score_eval(int n, const double *measured, const double *predicted, double range, wcut_score *score) {
    if (n < 0 || !score || !(range >= 0 && isfinite(range)) || (n > 0 && (!measured || !predicted)))
        return WCUT_BAD_ARGUMENT;
    if (!all_finite(n, measured) || !all_finite(n, predicted)) return WCUT_BAD_ARGUMENT;
    *score = wcut_score_of(n, measured, predicted, range);
    return WCUT_OK;
}

/* ---- means ---- */

typedef struct mean {
    wcut_score sum;
    int ranges, correlations; /* scores that have them */
} mean;

static void add_to_mean(mean *m, const wcut_score *s) {
    if (s->count < 1) return;
    m->sum.count++;
    m->sum.bias += s->bias, m->sum.rmsd += s->rmsd, m->sum.rmse += s->rmse;
    if (s->correlated) m->sum.correlation += s->correlation, m->correlations++;
    if (!(s->range > 0)) return;
    m->sum.range += s->range, m->sum.nrmsd += s->nrmsd, m->sum.rmse_over_range += s->rmse_over_range;
    m->ranges++;
}

static wcut_score mean_score(const mean *m) {
    wcut_score s = m->sum;
    const int n = s.count > 0 ? s.count : 1, ranges = m->ranges > 0 ? m->ranges : 1;
    s.bias /= n, s.rmsd /= n, s.rmse /= n;
    s.range /= ranges, s.nrmsd /= ranges, s.rmse_over_range /= ranges;
    s.correlated = m->correlations > 0;
    if (s.correlated) s.correlation /= m->correlations;
    return s;
}

wcut_status wcut_score_mean(int n, const wcut_score *score, wcut_score *out) {
    if (n < 0 || !out || (n > 0 && !score)) return WCUT_BAD_ARGUMENT;
    mean m = {0};
    for (int i = 0; i < n; i++) add_to_mean(&m, &score[i]);
    *out = mean_score(&m);
    return WCUT_OK;
}

wcut_status wcut_scores_mean(int n, const wcut_comparison *const *comparison, wcut_scores *planned,
                             wcut_scores *replayed) {
    if (n < 0 || !planned || !replayed || (n > 0 && !comparison)) return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < WCUT_SCORED_COUNT; k++)
        for (int part = 0; part < WCUT_PART_COUNT; part++) {
            mean of_plans = {0}, of_replays = {0};
            for (int i = 0; i < n; i++) {
                if (!comparison[i]) continue;
                add_to_mean(&of_plans, &comparison[i]->planned_score.of[k][part]);
                add_to_mean(&of_replays, &comparison[i]->replayed_score.of[k][part]);
            }
            planned->of[k][part] = mean_score(&of_plans);
            replayed->of[k][part] = mean_score(&of_replays);
        }
    return WCUT_OK;
}
