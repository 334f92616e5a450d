/* Cuts of a calibration table that lie far off the law of the others, and the slip of a decimal point that explains one. */
#include <math.h>
#include <stdbool.h>
#include <wirecut/calibration.h>

#include "base/alloc.h"
#include "base/fail.h"

/* a cut that keeps less than this of its weight is an outlier; a corrected one lies within so many standard deviations */
#define WEIGHT_MIN 0.1
#define DEVIATIONS_MAX 3.0
#define USUAL_MARGIN 1.5
#define SCALE_MIN 0.01 /* of the scatter, relative: no table is better */

static void scale_column(wcut_test_cut *cut, wcut_slip_column column, double factor) {
    if (column == WCUT_SLIP_COLUMN_HEAT) cut->heat *= factor;
    if (column == WCUT_SLIP_COLUMN_SPEED) cut->speed *= factor;
    if (column == WCUT_SLIP_COLUMN_ENGAGED) cut->engaged *= factor;
    if (column == WCUT_SLIP_COLUMN_TENSION) cut->tension_a *= factor, cut->tension_b *= factor;
    if (column == WCUT_SLIP_COLUMN_ALPHA) cut->alpha_a *= factor, cut->alpha_b *= factor;
}

static double value_of(const wcut_test_cut *cut, wcut_slip_column column) {
    const double value[] = {0, cut->heat, cut->speed, cut->engaged, cut->tension_a, fabs(cut->alpha_a)};
    return value[column];
}

/* whether a value is like those of the other cuts: a slip leaves their range, and its mending comes back into it */
static bool is_usual(int n, const wcut_test_cut *cut, int index, wcut_slip_column column, double value) {
    double low = INFINITY, high = 0;
    for (int i = 0; i < n; i++) {
        if (i == index) continue;
        low = fmin(low, value_of(&cut[i], column));
        high = fmax(high, value_of(&cut[i], column));
    }
    return value > low / USUAL_MARGIN && value < high * USUAL_MARGIN;
}

/* [1] how far a cut lies off a fitted law, in the standard deviations of the fit */
static double deviation_of(const wcut_law_fit *law, double measured, double q_eff, bool relative) {
    const double fitted = law->a * exp(-law->b * q_eff) + law->c;
    const double scale = relative ? fmax(law->scale, SCALE_MIN) * fitted : fmax(law->scale, SCALE_MIN * fitted);
    return fabs(measured - fitted) / scale;
}

/* the worse of both laws; infinite where the angle would be none */
static double deviation_of_cut(const wcut_calibration *fit, const wcut_test_cut *cut, bool relative) {
    const double q_eff = wcut_q_eff_eval(cut->heat, cut->speed), limit = acos(0);
    if (!(fabs(cut->alpha_a) < limit && fabs(cut->alpha_b) < limit)) return INFINITY;
    const double force = deviation_of(&fit->force, wcut_test_cut_force(cut), q_eff, relative);
    if (!fit->tension_fitted) return force;
    return fmax(force, deviation_of(&fit->tension, wcut_test_cut_tension(cut), q_eff, relative));
}

/* which column, moved by one or two places, brings the cut back to the law */
static wcut_slip explain(const wcut_calibration *fit, int n, const wcut_test_cut *all, int index, bool relative) {
    static const double factor[] = {0.1, 10, 0.01, 100};

    /* where the cut lies, against the law of the others */
    const wcut_test_cut *cut = &all[index];
    const double q_eff = wcut_q_eff_eval(cut->heat, cut->speed);
    wcut_slip slip = {.cut = index, .column = WCUT_SLIP_COLUMN_NONE, .factor = 1};
    slip.ratio = wcut_test_cut_force(cut) / (fit->force.a * exp(-fit->force.b * q_eff) + fit->force.c);

    /* each column moved by each factor: the one that brings the cut nearest to the law */
    double best = DEVIATIONS_MAX;
    for (int column = WCUT_SLIP_COLUMN_HEAT; column < WCUT_SLIP_COLUMN_COUNT; column++)
        for (int k = 0; k < 4; k++) {
            wcut_test_cut moved = *cut;
            scale_column(&moved, (wcut_slip_column)column, factor[k]);

            /* a moved value must be usual in its column */
            const double deviation = deviation_of_cut(fit, &moved, relative);
            const double value = value_of(&moved, (wcut_slip_column)column);
            if (!(deviation < best) || !is_usual(n, all, index, (wcut_slip_column)column, value)) continue;
            best = deviation;
            slip.column = (wcut_slip_column)column;
            slip.factor = factor[k];
        }

    return slip;
}

wcut_status wcut_calibration_slips(int n, const wcut_test_cut *cut, const wcut_calibration_options *options, int *count,
                                   wcut_slip *slip, wcut_error *error) {
    if (n < 1 || !cut || !count || !slip)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));

    /* a robust fit, so that a slip does not bend the law it is measured by */
    wcut_calibration_options robust = options ? *options : wcut_calibration_options_default();
    const bool relative = robust.noise == WCUT_NOISE_RELATIVE;
    robust.loss = WCUT_LOSS_TUKEY;
    wcut_calibration fit;
    wcut_calibration_point *point = wcut_alloc((size_t)n, sizeof *point);
    wcut_status status = point ? wcut_calibration_fit(n, cut, &robust, &fit, point, error)
                               : wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));

    /* an outlier of either law; the robust law is that of the others */
    if (status == WCUT_OK) {
        *count = 0;
        for (int i = 0; i < n; i++) {
            const bool light = point[i].force.loss_weight < WEIGHT_MIN ||
                               (fit.tension_fitted && point[i].tension.loss_weight < WEIGHT_MIN);
            if (light && deviation_of_cut(&fit, &cut[i], relative) > DEVIATIONS_MAX)
                slip[(*count)++] = explain(&fit, n, cut, i, relative);
        }
    }

    wcut_free(point);
    return status;
}
