/* Force and tension law of a foam from steady test cuts (Rust et al. 2016, 1, 2 and figure 2). */
#include <math.h>
#include <string.h>
#include <wirecut/calibration.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "foam/force_law.h"
#include "foam/law_fit.h"

double wcut_test_cut_force(const wcut_test_cut *cut) {
    return (cut->tension_a * sin(cut->alpha_a) + cut->tension_b * sin(cut->alpha_b)) / cut->engaged;
}

double wcut_test_cut_tension(const wcut_test_cut *cut) { return (cut->tension_a + cut->tension_b) / 2 / cut->engaged; }

wcut_calibration_options wcut_calibration_options_default(void) {
    return (wcut_calibration_options){
        .noise = WCUT_NOISE_RELATIVE, .loss = WCUT_LOSS_SQUARE, .confidence = 0.95, .alpha_large = 10 * WCUT_PI / 180};
}

static bool is_option(const wcut_calibration_options *o) {
    return (unsigned)o->noise <= WCUT_NOISE_ABSOLUTE && (unsigned)o->loss <= WCUT_LOSS_TUKEY && o->confidence > 0 &&
           o->confidence < 1 && isfinite(o->reference_force) && o->reference_force >= 0 &&
           isfinite(o->reference_heat) && o->reference_heat >= 0 && isfinite(o->alpha_large) && o->alpha_large >= 0;
}

/* which value of a cut is outside its range; NULL where none is */
static const char *find_fault(const wcut_test_cut *cut) {
    if (!is_positive(cut->heat)) return "heat must be positive";
    if (!is_positive(cut->speed)) return "speed must be positive";
    if (!is_positive(cut->engaged)) return "engaged length must be positive";
    if (!is_positive(cut->tension_a) || !is_positive(cut->tension_b)) return "tension must be positive";
    if (!(fabs(cut->alpha_a) < WCUT_PI / 2 && fabs(cut->alpha_b) < WCUT_PI / 2))
        return "the deflection must be less than a right angle";
    if (!is_positive(cut->weight)) return "weight must be positive";
    bool sane = is_positive(wcut_q_eff_eval(cut->heat, cut->speed)) && isfinite(wcut_test_cut_force(cut)) &&
                is_positive(wcut_test_cut_tension(cut));
    return sane ? NULL : "Q_eff, force and tension per length must be finite";
}

static wcut_status check_cuts(int n, const wcut_test_cut *cut, wcut_error *error) {
    for (int i = 0; i < n; i++) {
        const char *fault = find_fault(&cut[i]);
        if (fault && cut[i].line > 0) return wcut_fail(error, WCUT_BAD_ARGUMENT, "line %d: %s", cut[i].line, fault);
        if (fault) return wcut_fail(error, WCUT_BAD_ARGUMENT, "cut %d: %s", i, fault);
    }
    return WCUT_OK;
}

/* levels that differ by more than 1e-6 of themselves; sorts x, whose values are logarithms */
static int count_levels(int n, double *x) {
    wcut_sort(n, x);
    int levels = 1;
    double level = x[0];
    for (int i = 1; i < n; i++)
        if (x[i] - level > 1e-6) level = x[i], levels++;
    return levels;
}

/* what the table spans, before any fit; scratch: n */
static void describe_cuts(int n, const wcut_test_cut *cut, const wcut_law_data *d, double alpha_large, double *scratch,
                          wcut_calibration *c) {
    c->q_eff_low = c->q_eff_high = d->q[0];
    for (int i = 0; i < n; i++) {
        c->q_eff_low = fmin(c->q_eff_low, d->q[i]);
        c->q_eff_high = fmax(c->q_eff_high, d->q[i]);
        c->large_angles += fabs(cut[i].alpha_a) > alpha_large || fabs(cut[i].alpha_b) > alpha_large;
        scratch[i] = log(d->q[i]);
    }
    c->q_effs = count_levels(n, scratch);
    memcpy(scratch, d->log_speed, (size_t)n * sizeof *scratch);
    c->speeds = count_levels(n, scratch);
    memcpy(scratch, d->log_heat, (size_t)n * sizeof *scratch);
    c->heats = count_levels(n, scratch);
    c->reference_heat = exp((scratch[(n - 1) / 2] + scratch[n / 2]) / 2); /* now sorted */
}

/* V0 = b Q_I / ln(a/F0) and 1/ln(a/F0) with errors by the delta method */
static wcut_status find_reference(int n, const wcut_calibration_point *point, const wcut_calibration_options *o,
                                  wcut_calibration *c, wcut_error *error) {
    const wcut_law_fit *f = &c->force;

    /* the reference force: given, or the geometric mean of the fitted forces */
    double sum = 0;
    for (int i = 0; i < n; i++) sum += log(point[i].force.fitted) / n;
    c->reference_force = o->reference_force > 0 ? o->reference_force : exp(sum);
    if (o->reference_heat > 0) c->reference_heat = o->reference_heat;

    /* the law reaches the reference force only below a */
    if (!(c->reference_force < f->a))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "reference force: found %g N/mm, expected less than a = %g N/mm",
                         c->reference_force, f->a);

    /* V0 and the exponent by solving (2) for the speed */
    double log_ratio = log(f->a / c->reference_force);
    c->exponent = 1 / log_ratio;
    c->reference_speed = f->b * c->reference_heat * MM_PER_M / log_ratio;

    /* errors by first derivatives and the covariance of a and b */
    const double da = -1 / (f->a * log_ratio), db = 1 / f->b; /* d ln V0 / da, d ln V0 / db; d ln m / da = da too */
    double variance = da * da * f->covariance[0] + 2 * da * db * f->covariance[1] + db * db * f->covariance[4];
    c->reference_speed_error = c->reference_speed * sqrt(fmax(0, variance));
    c->exponent_error = c->exponent * fabs(da) * f->standard_error[0];

    /* a and b can be told apart where the interval of b is narrower than b */
    c->correlation = f->correlation[1];
    c->separable = f->high[1] - f->low[1] < f->b;

    return WCUT_OK;
}

/* the arrays that both laws are fitted to, in one block of 8n */
static wcut_law_data lay_out_data(int n, const wcut_test_cut *cut, double *block, double **tension) {
    size_t m = (size_t)n;
    double *q = block, *force = q + m, *weight = force + m, *log_heat = weight + m, *log_speed = log_heat + m;
    *tension = log_speed + m;
    for (int i = 0; i < n; i++) {
        q[i] = wcut_q_eff_eval(cut[i].heat, cut[i].speed);
        force[i] = wcut_test_cut_force(&cut[i]);
        (*tension)[i] = wcut_test_cut_tension(&cut[i]);
        weight[i] = cut[i].weight;
        log_heat[i] = log(cut[i].heat);
        log_speed[i] = log(cut[i].speed);
    }
    return (wcut_law_data){n, false, q, force, weight, log_heat, log_speed};
}

/* why equation (2) does not come out of these cuts */
static wcut_status explain_no_law(wcut_status status, const wcut_calibration *c, const wcut_law_data *d,
                                  wcut_error *error) {
    /* the causes one by one, the most specific first */
    int positive = 0;
    for (int i = 0; i < d->n; i++) positive += d->y[i] > 0;
    if (status == WCUT_NOT_CONVERGED)
        return wcut_fail(error, status,
                         "force law: the repeated fit does not come to rest; the forces scatter too much for the law");
    if (status != WCUT_DEGENERATE) return wcut_fail(error, status, "%s", wcut_status_text(status));
    if (c->q_effs < 2)
        return wcut_fail(error, status,
                         "force law: found one level of Q_eff (%g J/m^2), expected at least two: a and b cannot be "
                         "separated; vary the speed or the heat",
                         d->q[0]);
    if (positive < 2)
        return wcut_fail(error, status, "force law: found %d cuts with a positive force, expected at least two",
                         positive);
    return wcut_fail(error, status, "force law: the force does not fall with Q_eff between %g and %g J/m^2",
                     c->q_eff_low, c->q_eff_high);
}

wcut_status wcut_calibration_fit(int n, const wcut_test_cut *cut, const wcut_calibration_options *options,
                                 wcut_calibration *calibration, wcut_calibration_point *point, wcut_error *error) {
    /* check options, number of cuts and each cut */
    wcut_calibration_options o = options ? *options : wcut_calibration_options_default();
    if (!cut || !calibration || !is_option(&o))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    if (n < 3) return wcut_fail(error, WCUT_BAD_ARGUMENT, "found %d test cuts, expected at least 3", n);
    wcut_status status = check_cuts(n, cut, error);
    if (status != WCUT_OK) return status;

    double *block = wcut_alloc(7 * (size_t)n, sizeof *block), *tension;
    wcut_law_fit_point *of_law = wcut_alloc((size_t)n, sizeof *of_law);
    wcut_calibration_point *found = wcut_alloc((size_t)n, sizeof *found);
    wcut_calibration c = {.separable = 0};
    if (!block || !of_law || !found) {
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
        goto done;
    }

    /* columns of the table as arrays; what the cuts span */
    wcut_law_data data = lay_out_data(n, cut, block, &tension);
    describe_cuts(n, cut, &data, o.alpha_large, block + 6 * (size_t)n, &c);

    /* equation (2): at least two levels of Q_eff are needed */
    status = c.q_effs < 2 ? WCUT_DEGENERATE : wcut_law_fit_solve(&data, &o, &c.force, of_law);
    if (status != WCUT_OK) {
        explain_no_law(status, &c, &data, error);
        goto done;
    }

    /* fitted forces, and the tensions that belong to them */
    for (int i = 0; i < n; i++) {
        found[i].q_eff = data.q[i];
        found[i].force = of_law[i];
        found[i].tension.measured = tension[i];
    }
    status = find_reference(n, found, &o, &c, error);
    if (status != WCUT_OK) goto done;

    /* the tension of a test cut hangs on its deflection too: a table may well not determine (1) and yet give (2) */
    data.y = tension;
    data.with_c = true;
    wcut_status of_tension = wcut_law_fit_solve(&data, &o, &c.tension, of_law);
    if (of_tension == WCUT_NO_MEMORY) {
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
        goto done;
    }
    c.tension_fitted = of_tension == WCUT_OK;
    for (int i = 0; i < n && c.tension_fitted; i++) found[i].tension = of_law[i];

    /* write everything at once */
    *calibration = c;
    if (point) memcpy(point, found, (size_t)n * sizeof *found);

done:
    wcut_free(found);
    wcut_free(of_law);
    wcut_free(block);
    return status;
}
