/* The scatter of a rig as a table: what differs from cut to cut, each with its interval. */
#include "explain/rig.h"

#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/numbers.h"

/* how a row is said, and from where on it is worth a word */
typedef struct phrase {
    const char *format;
    double unit, min;
} phrase;

static const phrase scatter_phrase[WCUT_SCATTER_COUNT] = {
    [WCUT_SCATTER_LEVEL] = {"block to block %.1f %%", 100, 0.01},
    [WCUT_SCATTER_LEVEL_B] = {"response to heat %.1f %%", 100, 0.01},
    [WCUT_SCATTER_LENGTH] = {"wire length %.1f mm", 1, 0.3},
    [WCUT_SCATTER_TENSION_ZERO] = {"zeros of the tension sensors %.3f N", 1, 0.02},
    [WCUT_SCATTER_ENCODER_ZERO] = {"zeros of the encoders %.2f deg", 1, 0.08},
    [WCUT_SCATTER_FRICTION] = {"friction in the joints %.2f deg", 1, 0.1},
    [WCUT_SCATTER_FACE] = {"faces off their path %.2f mm", 1, 0.2},
    [WCUT_SCATTER_SCAN_SHIFT] = {"scans shifted %.1f mm", 1, 0.5},
    [WCUT_SCATTER_SCAN_TURN] = {"scans turned %.2f deg", 1, 0.03},
};

/* names of the rows behind the scatter, and how they are said */
enum { TENSION_DELAY, ANGLE_DELAY, PATH_ERROR, FURTHER };
static const char *const further_name[FURTHER] = {"tension_delay_s", "angle_delay_s", "path_error_mm"};
static const phrase further_phrase[FURTHER] = {{"tension readings %.3f s late", 1, 0.03},
                                               {"angle readings %.3f s late", 1, 0.06},
                                               {"mounts off their path %.2f mm", 1, 0.1}};

/* ---- rows ---- */

/* A standard deviation of n coefficients, each known to its error: the interval of a chi-square with as many degrees of
   freedom as are told from their errors. */
static wcut_estimate deviation_interval(double sd, double sum_square, double sum_error, int n) {
    const double told = clamp(n * (1 - sum_error / fmax(sum_square + sum_error, 1e-300)), 1, n);
    wcut_estimate e = {sd, 0, 0};
    e.low = sd * sqrt(told / wcut_chi_square_quantile(0.975, told));
    e.high = sd * sqrt(told / wcut_chi_square_quantile(0.025, told));
    if (sum_square < 2 * sum_error) e.low = 0;
    return e;
}

/* What a cut's value is beside what its own coefficient says: the common value it is measured from, known to an error, and
   what two simulators of the same physics differ by (a 1.2 %, b 0.4 %, a length 0.05 mm and 4 % of itself). */
static wcut_estimate of_cut(const wcut_fitted *f, wcut_scatter_kind kind, double value, double wide) {
    double common = 0, model = 0;
    if (kind == WCUT_SCATTER_LEVEL) common = f->error[0], model = 0.012;
    if (kind == WCUT_SCATTER_LEVEL_B) common = f->error[1], model = 0.004;
    if (kind == WCUT_SCATTER_LENGTH) value += f->x[2], common = f->error[2], model = hypot(0.05, 0.04 * value);
    const double half = 1.96 * hypot(wide, hypot(common, model));
    return (wcut_estimate){value, value - half, value + half};
}

/* What the levels of all blocks have in common is a and b, not scatter: the columns of the scatter are those of the plain model,
   so that the fit of an effect may leave a part of a in them. 0 of other kinds. */
static double common_value(const wcut_evidence *e, const wcut_fitted *f, wcut_scatter_kind kind) {
    double sum = 0;
    int n = 0;
    if (kind != WCUT_SCATTER_LEVEL && kind != WCUT_SCATTER_LEVEL_B) return 0;
    for (int cut = 0; cut < e->cuts; cut++)
        for (int k = 0; k < e->scatter.count && e->cut[cut].bins > 0; k++)
            if (e->scatter.kind[k] == kind) sum += f->scatter[cut * e->scatter.count + k], n++;
    return n > 1 ? sum / n : 0;
}

static void scatter_row(const wcut_evidence *e, const wcut_fitted *f, wcut_scatter_kind kind, wcut_rig_row *row) {
    double square = 0, error = 0;
    int n = 0;
    snprintf(row->name, sizeof row->name, "%s", wcut_scatter_name(kind));

    /* coefficients of this kind in all cuts; a kind with one column has a value for every cut */
    int columns = 0;
    for (int k = 0; k < e->scatter.count; k++) columns += e->scatter.kind[k] == kind;
    const double middle = common_value(e, f, kind);
    double centred = 0;
    for (int cut = 0; cut < e->cuts; cut++)
        for (int k = 0; k < e->scatter.count && e->cut[cut].bins > 0; k++) {
            if (e->scatter.kind[k] != kind) continue;
            const double value = f->scatter[cut * e->scatter.count + k];
            const double wide = f->scatter_error[cut * e->scatter.count + k];
            if (!(wide > 0)) continue;
            square += value * value, error += wide * wide, n++;
            centred += (value - middle) * (value - middle);
            if (columns > 1 || row->cuts == WCUT_RIG_CUTS) continue;
            row->cut[row->cuts] = cut;
            row->of_cut[row->cuts++] = of_cut(f, kind, value - middle, wide);
        }

    /* the spread of the rig, from the variance and from the values, without what all cuts have in common */
    const double share = square > 0 ? sqrt((centred + error) / (square + error)) : 1;
    row->value = deviation_interval(share * f->noise.scatter[kind], centred, error, n > 0 ? n : 1);
}

/* The misplacement of mounts that would make the slow noise beyond a sensor's own. Long waves are not in it, lengths and faces
   take them: 0.09 to 0.13 mm came out where mounts were 0.3 mm off. */
static wcut_estimate path_error(const wcut_evidence *e, const wcut_fitted *f) {
    double sum = 0;
    int count = 0;
    for (int s = 0; s < WCUT_SIGNALS; s++) {
        const int group = wcut_noise_group(s);
        const double beyond = fmax(f->noise.slow[group] - WCUT_SLOW_NOISE, 0) * e->sigma[s] * e->sigma[s];
        if (!(e->path_response[group] > 0)) continue;
        sum += beyond / (e->path_response[group] * e->path_response[group]), count++;
    }
    const double value = count ? sqrt(sum / count) : 0;
    return (wcut_estimate){value, 0.6 * value, 3.5 * value};
}

wcut_status wcut_rig_fill(const wcut_evidence *e, const wcut_fitted *f, wcut_diagnosis *d) {
    wcut_rig_row *row = wcut_alloc(WCUT_SCATTER_COUNT + FURTHER, sizeof *row);
    if (!row) return WCUT_NO_MEMORY;

    /* scan kinds are there where there is a scan */
    int rows = 0;
    bool scans = false;
    for (int k = 0; k < e->cuts; k++) scans = scans || e->cut[k].patch.count > 0;
    for (int k = 0; k < WCUT_SCATTER_COUNT && e->scatter.count > 0; k++)
        if (scans || k < WCUT_SCATTER_FACE) scatter_row(e, f, (wcut_scatter_kind)k, &row[rows++]);

    /* delays of readings, and mounts beside their path */
    for (int k = 0; k < WCUT_DELAYS; k++) {
        const double half = 1.96 * hypot(f->delay_error[k], 0.01);
        snprintf(row[rows].name, sizeof row[rows].name, "%s", further_name[k]);
        row[rows++].value = (wcut_estimate){f->delay[k], f->delay[k] - half, f->delay[k] + half};
    }

    snprintf(row[rows].name, sizeof row[rows].name, "%s", further_name[PATH_ERROR]);
    row[rows++].value = path_error(e, f);
    d->rig_rows = rows, d->rig = row;

    return WCUT_OK;
}

/* ---- words ---- */

static const phrase *phrase_of(const char *name) {
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++)
        if (strcmp(name, wcut_scatter_name((wcut_scatter_kind)k)) == 0) return &scatter_phrase[k];
    for (int k = 0; k < FURTHER; k++)
        if (strcmp(name, further_name[k]) == 0) return &further_phrase[k];
    return NULL;
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
void wcut_rig_sentence(const wcut_diagnosis *d, int size, char *text) {
    int at = 0;
    text[0] = 0;
    for (int k = 0; k < d->rig_rows && at < size - 1; k++) {
        const phrase *p = phrase_of(d->rig[k].name);
        if (!p || fabs(d->rig[k].value.value) < p->min) continue;
        at += snprintf(text + at, (size_t)(size - at), "%s", at ? ", " : "");
        if (at < size - 1) at += snprintf(text + at, (size_t)(size - at), p->format, p->unit * d->rig[k].value.value);
    }
}
#pragma GCC diagnostic pop
