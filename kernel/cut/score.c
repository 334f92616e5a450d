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
    const double least = 1e-24 * n;
    if (!(xx > least * mx * mx) || !(yy > least * my * my)) return false;
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

wcut_status wcut_score_mean(int n, const wcut_score *score, wcut_score *mean) {
    if (n < 0 || !mean || (n > 0 && !score)) return WCUT_BAD_ARGUMENT;
    wcut_score m = {0};
    int ranges = 0, correlations = 0;
    for (int i = 0; i < n; i++) {
        const wcut_score *s = &score[i];
        if (s->count < 1) continue;
        m.count++;
        m.bias += s->bias, m.rmsd += s->rmsd, m.rmse += s->rmse;
        if (s->correlated) m.correlation += s->correlation, correlations++;
        if (!(s->range > 0)) continue;
        m.range += s->range, m.nrmsd += s->nrmsd, m.rmse_over_range += s->rmse_over_range, ranges++;
    }
    if (m.count > 0) m.bias /= m.count, m.rmsd /= m.count, m.rmse /= m.count;
    if (ranges > 0) m.range /= ranges, m.nrmsd /= ranges, m.rmse_over_range /= ranges;
    if (correlations > 0) m.correlation /= correlations, m.correlated = true;
    *mean = m;
    return WCUT_OK;
}
