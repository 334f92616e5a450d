/* One process law fitted to steady test cuts: generalised least squares (Carroll, Ruppert 1988) and its tests. */
#include "foam/law_fit.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/least_squares.h"
#include "base/numbers.h"

/* more cuts are left out one at a time by leverage, to first order, instead of by refitting */
enum { REFIT_MAX = 200 };

/* what the residual function sees: the data, the standard deviations as they stand, and the parameters in use */
typedef struct trial {
    const wcut_law_data *d;
    int parameters; /* 2: a, b with c = 0; 3: a, b, c */
    double *sigma;  /* n */
} trial;

static double law_at(const double *x, int parameters, double q) {
    return x[0] * exp(-x[1] * q) + (parameters > 2 ? x[2] : 0);
}

/* the slopes of the law in a, b, c */
static void law_slopes(const double *x, int parameters, double q, double *slope) {
    slope[0] = exp(-x[1] * q);
    slope[1] = -q * x[0] * slope[0];
    if (parameters > 2) slope[2] = 1;
}

static bool residuals(void *data, const double *x, double *r, double *jacobian) {
    const trial *t = data;
    for (int i = 0; i < t->d->n; i++) {
        double slope[3] = {0};
        law_slopes(x, t->parameters, t->d->q[i], slope);
        r[i] = (law_at(x, t->parameters, t->d->q[i]) - t->d->y[i]) / t->sigma[i];
        for (int j = 0; jacobian && j < t->parameters; j++)
            jacobian[(size_t)i * t->parameters + j] = slope[j] / t->sigma[i];
    }
    return x[0] > 0;
}

/* ---- start ---- */

/* ln a - b q - ln y, x = {ln a, b}; cuts without a positive y have no weight here */
static bool log_residuals(void *data, const double *x, double *r, double *jacobian) {
    const wcut_law_data *d = *(const wcut_law_data **)data;
    for (int i = 0; i < d->n; i++) {
        r[i] = d->y[i] > 0 ? x[0] - x[1] * d->q[i] - log(d->y[i]) : 0;
        if (!jacobian) continue;
        jacobian[2 * (size_t)i] = 1;
        jacobian[2 * (size_t)i + 1] = -d->q[i];
    }
    return true;
}

/* the straight line through the logarithms, by the loss that is asked for: an outlier must not lead the start astray;
   loss_weight: n, what the loss left of each cut; work: n */
static wcut_status start_from_logs(const wcut_law_data *d, wcut_loss loss, const double *weight, double *work,
                                   double *loss_weight, double *x) {
    wcut_lsq_options o = wcut_lsq_options_default();
    wcut_lsq_problem problem = {d->n, 2, log_residuals, &d, work};
    double line[2] = {0, 0};
    for (int i = 0; i < d->n; i++) work[i] = d->y[i] > 0 ? weight[i] : 0;
    /* least squares first: from a line that is nowhere near, no residual tells an outlier */
    wcut_status status = wcut_lsq_solve(&problem, &o, line, NULL, loss_weight, NULL);
    o.loss = loss;
    if (status == WCUT_OK && loss != WCUT_LOSS_SQUARE)
        status = wcut_lsq_solve(&problem, &o, line, NULL, loss_weight, NULL);
    if (status == WCUT_SINGULAR) return WCUT_DEGENERATE;
    if (status != WCUT_OK && status != WCUT_NOT_CONVERGED) return status; /* a start need not be at rest */
    x[0] = exp(line[0]);
    x[1] = line[1];
    return isfinite(x[0]) && x[0] > 0 ? WCUT_OK : WCUT_DEGENERATE;
}

/* the best a and c for a given b, and the cost that is left; cuts count by root^2 */
static double cost_at_decay(const wcut_law_data *d, const double *root, double b, double *work, double *x) {
    double cost = 0, *rhs = work + 2 * (size_t)d->n, ac[2];
    int m = 0;
    for (int i = 0; i < d->n; i++) {
        if (!(root[i] > 0)) continue;
        work[2 * (size_t)m] = root[i] * exp(-b * d->q[i]);
        work[2 * (size_t)m + 1] = root[i];
        rhs[m++] = root[i] * d->y[i];
    }
    if (m < 3 || wcut_qr_solve(m, 2, work, rhs, ac, NULL) != WCUT_OK || !(ac[0] > 0)) return INFINITY;
    for (int k = 2; k < m; k++) cost += rhs[k] * rhs[k];
    x[0] = ac[0];
    x[1] = b;
    x[2] = ac[1];
    return cost;
}

/* c bends the logarithm: the best of 80 decays that the range of Q_eff can show, a and c linear in each, and every cut
   weighted by the straight line's own value there; x: that line in, the start out; root: n */
static wcut_status start_with_c(const wcut_law_data *d, const double *weight, const double *loss_weight, double *root,
                                double *work, double *x) {
    double low = d->q[0], high = low, best = INFINITY, candidate[3];
    for (int i = 0; i < d->n; i++) {
        low = fmin(low, d->q[i]);
        high = fmax(high, d->q[i]);
        root[i] = sqrt(weight[i] * loss_weight[i]) / law_at(x, 2, d->q[i]);
        if (!isfinite(root[i])) return WCUT_DEGENERATE;
    }
    const double min = 0.05 / (high - low), max = 50 / (high - low);
    for (int k = 0; k < 80; k++) {
        double cost = cost_at_decay(d, root, min * pow(max / min, k / 79.0), work, candidate);
        if (cost < best) best = cost, memcpy(x, candidate, sizeof candidate);
    }
    return best < INFINITY ? WCUT_OK : WCUT_DEGENERATE;
}

/* ---- fit ---- */

/* what a fit hands back to itself */
typedef struct solution {
    double x[3], covariance[9];
    int parameters;
    wcut_lsq_report report;
} solution;

/* repeat the weighted fit until the standard deviations, which are the law's own values, stand still */
static wcut_status fit_from(trial *t, wcut_noise noise, wcut_loss loss, const double *weight, double *loss_weight,
                            solution *s) {
    /* weighted least squares under the chosen loss */
    wcut_lsq_options o = wcut_lsq_options_default();
    o.loss = loss;
    wcut_lsq_problem problem = {t->d->n, s->parameters, residuals, t, weight};
    t->parameters = s->parameters;

    /* weights from the law's present values, until they stand still */
    for (int round = 0; round < 60; round++) {
        for (int i = 0; i < t->d->n; i++) {
            t->sigma[i] = noise == WCUT_NOISE_ABSOLUTE ? 1 : law_at(s->x, s->parameters, t->d->q[i]);
            if (!is_positive(t->sigma[i])) return WCUT_DEGENERATE;
        }
        /* a median of residuals moves by jumps: once it is about right it stays, so that the rest can come to rest */
        if (loss != WCUT_LOSS_SQUARE && round == 5) o.scale = s->report.scale;

        double before[3];
        memcpy(before, s->x, sizeof before);
        wcut_status status = wcut_lsq_solve(&problem, &o, s->x, s->covariance, loss_weight, &s->report);
        if (status != WCUT_OK)
            return status == WCUT_NO_MEMORY || status == WCUT_NOT_CONVERGED ? status : WCUT_DEGENERATE;

        /* change against the standard errors of the parameters */
        double change = 0;
        for (int j = 0; j < s->parameters; j++) {
            double error = sqrt(s->covariance[(size_t)j * (size_t)(s->parameters + 1)]);
            double floor = 1e-5 * fabs(s->x[j == 1]); /* data on the law itself have no error to compare with */
            change = fmax(change, fabs(s->x[j] - before[j]) / fmax(error, floor));
        }
        if (round > 0 && (noise == WCUT_NOISE_ABSOLUTE || change < 1e-9)) return WCUT_OK;
    }

    return WCUT_NOT_CONVERGED;
}

/* start and fit; with c where the data determine one that is not negative, else with c = 0 */
static wcut_status fit_law(trial *t, const wcut_calibration_options *o, wcut_loss loss, const double *weight,
                           double *loss_weight, double *work, solution *s) {
    double line[3] = {0, 0, 0}; /* the start for two parameters */
    wcut_status status = start_from_logs(t->d, loss, weight, work, loss_weight, line);
    if (status != WCUT_OK) return status;
    if (t->d->with_c) {
        s->parameters = 3;
        memcpy(s->x, line, sizeof line);
        status = start_with_c(t->d, weight, loss_weight, work + 3 * (size_t)t->d->n, work, s->x);
        if (status == WCUT_OK) status = fit_from(t, o->noise, loss, weight, loss_weight, s);
        if (status == WCUT_NO_MEMORY || (status == WCUT_OK && s->x[2] >= 0 && s->x[1] > 0)) return status;
    }
    s->parameters = 2;
    memcpy(s->x, line, sizeof line);
    status = fit_from(t, o->noise, loss, weight, loss_weight, s);
    if (status == WCUT_OK && !(s->x[1] > 0)) status = WCUT_DEGENERATE;
    return status;
}

/* ---- what is known about the fit ---- */

/* log likelihood of normal noise, relative or absolute, at its own least squares fit, but for a constant */
static wcut_status log_likelihood(trial *t, wcut_noise noise, int parameters, const double *x, double *work,
                                  double *likelihood) {
    const wcut_law_data *d = t->d;
    solution s = {.parameters = parameters};
    memcpy(s.x, x, sizeof s.x);
    wcut_status status = fit_from(t, noise, WCUT_LOSS_SQUARE, d->weight, work, &s);
    if (status != WCUT_OK) return status;
    *likelihood = -0.5 * d->n * log(s.report.cost / d->n);
    for (int i = 0; i < d->n; i++) *likelihood -= log(t->sigma[i]);
    return isfinite(*likelihood) ? WCUT_OK : WCUT_DEGENERATE;
}

/* scaled residuals e (their squares sum to the misfit) and the scaled Jacobian with `extra` more columns */
static void linearise(const trial *t, const solution *s, const double *loss_weight, int extra, double *jacobian,
                      double *e) {
    const wcut_law_data *d = t->d;
    int p = s->parameters, columns = p + extra;
    double mean = 0, spread = 0;
    for (int i = 0; i < d->n; i++) mean += d->q[i] / d->n;
    for (int i = 0; i < d->n; i++) spread = fmax(spread, fabs(d->q[i] - mean));
    for (int i = 0; i < d->n; i++) {
        double *row = jacobian + (size_t)i * columns, root = sqrt(d->weight[i] * loss_weight[i]) / t->sigma[i];
        double value = law_at(s->x, p, d->q[i]), u = (d->q[i] - mean) / spread;
        law_slopes(s->x, p, d->q[i], row);
        if (extra > 0) row[p] = value * u * u;
        if (extra > 1) row[p + 1] = value * d->log_speed[i];
        for (int j = 0; j < columns; j++) row[j] *= root;
        e[i] = root * (d->y[i] - value);
    }
}

/* the F test of a misfit that a richer law lowers to `rest`; exact data leave rounding alone, nothing to test */
static void keep_test(wcut_law_fit *fit, wcut_lack_of_fit kind, double misfit, int dof1, double rest, int dof2) {
    if (!(fit->scale > 1e-12) || !(rest > 0)) return;
    fit->lack = kind;
    fit->lack_degrees[0] = dof1;
    fit->lack_degrees[1] = dof2;
    fit->lack_f = fmax(0, (misfit - rest) / dof1 / (rest / dof2));
    fit->lack_p = wcut_f_tail(fit->lack_f, dof1, dof2);
}

static bool same_setting(const wcut_law_data *d, int i, int k) {
    return fabs(d->log_heat[i] - d->log_heat[k]) < 1e-6 && fabs(d->log_speed[i] - d->log_speed[k]) < 1e-6;
}

/* the scatter of repeated cuts about their own means against the misfit; false where too few are repeated */
static bool test_replicates(const trial *t, const solution *s, const double *loss_weight, const double *e,
                            wcut_law_fit *fit) {
    const wcut_law_data *d = t->d;
    double misfit = 0, pure = 0;
    int levels = 0;

    /* each cut against the mean of those with the same setting */
    for (int i = 0; i < d->n; i++) {
        double mass = 0, mean = 0;
        bool first = true;

        for (int k = 0; k < d->n; k++) {
            if (!same_setting(d, i, k)) continue;
            first = first && k >= i;
            mass += d->weight[k] * loss_weight[k];
            mean += d->weight[k] * loss_weight[k] * d->y[k];
        }
        levels += first;

        /* pure scatter about the mean, and misfit to the law */
        double off = mass > 0 ? (d->y[i] - mean / mass) / t->sigma[i] : 0;
        pure += d->weight[i] * loss_weight[i] * off * off;
        misfit += e[i] * e[i];
    }

    /* both need degrees of freedom */
    if (d->n - levels < 2 || levels <= s->parameters) return false;
    keep_test(fit, WCUT_LACK_OF_FIT_REPLICATE, misfit, levels - s->parameters, pure, d->n - levels);

    return true;
}

/* against two more terms; one where the second is not independent */
static wcut_status test_flexible(const trial *t, const solution *s, const double *loss_weight, double *work,
                                 wcut_law_fit *fit) {
    int n = t->d->n;
    double *jacobian = work, *e = work + 5 * (size_t)n, term[5];
    for (int extra = 2; extra > 0; extra--) {
        int columns = s->parameters + extra;
        if (n <= columns) continue;
        linearise(t, s, loss_weight, extra, jacobian, e);
        double misfit = 0, rest = 0;
        for (int i = 0; i < n; i++) misfit += e[i] * e[i];
        wcut_status status = wcut_qr_solve(n, columns, jacobian, e, term, NULL);
        if (status == WCUT_SINGULAR) continue;
        if (status != WCUT_OK) return status;
        for (int i = columns; i < n; i++) rest += e[i] * e[i]; /* Q^T e: its tail is what no column explains */
        keep_test(fit, WCUT_LACK_OF_FIT_FLEXIBLE, misfit, extra, rest, n - columns);
        return WCUT_OK;
    }
    return WCUT_OK;
}

/* the share of each cut in its own fitted value: the diagonal of J (J^T J)^-1 J^T, J scaled and weighted */
static wcut_status find_leverages(const trial *t, const solution *s, const double *loss_weight, double *work,
                                  wcut_law_fit_point *point) {
    const wcut_law_data *d = t->d;
    int n = d->n, p = s->parameters;
    double inverse[9] = {0}, x[3];
    linearise(t, s, loss_weight, 0, work, work + 5 * (size_t)n);
    wcut_status status = wcut_qr_solve(n, p, work, work + 5 * (size_t)n, x, inverse);
    for (int i = 0; i < n && status == WCUT_OK; i++) {
        double slope[3] = {0}, leverage = 0;
        law_slopes(s->x, p, d->q[i], slope);
        for (int j = 0; j < p * p; j++) leverage += slope[j / p] * slope[j % p] * inverse[j];
        point[i].leverage = leverage * d->weight[i] * loss_weight[i] / (t->sigma[i] * t->sigma[i]);
    }
    return status;
}

/* each cut predicted by the law of the others */
static wcut_status leave_out(trial *t, const solution *s, const wcut_calibration_options *o, double *work,
                             wcut_law_fit *fit, wcut_law_fit_point *point) {
    const wcut_law_data *d = t->d;
    int n = d->n, p = s->parameters;

    /* weights are a copy: one of them is 0 at a time */
    double sum = 0, *weight = work + 6 * (size_t)n, *loss_weight = weight + n;
    memcpy(weight, d->weight, (size_t)n * sizeof *weight);
    for (int i = 0; i < n; i++) {
        solution other = *s;
        wcut_status status = WCUT_OK;

        /* many cuts: one step by the leverage instead of a new fit (Cook 1977) */
        if (n > REFIT_MAX) {
            double off = point[i].measured - point[i].fitted;
            point[i].left_out = point[i].measured - off / fmax(1 - point[i].leverage, 1e-9);
        } else {
            /* few cuts: fit without this one, from the present solution */
            weight[i] = 0;
            status = fit_from(t, o->noise, o->loss, weight, loss_weight, &other);
            weight[i] = d->weight[i];
            if (status == WCUT_NO_MEMORY) return status;
            if (status == WCUT_OK) point[i].left_out = law_at(other.x, p, d->q[i]);
        }
        if (status != WCUT_OK) continue;

        /* error of the prediction, relative where the noise is */
        double off = point[i].measured - point[i].left_out;
        off /= o->noise == WCUT_NOISE_RELATIVE ? point[i].left_out : 1;
        sum += off * off;
        fit->left_out++;
    }
    fit->leave_one_out = fit->left_out ? sqrt(sum / fit->left_out) : 0;

    return WCUT_OK;
}

double wcut_law_fit_error(const wcut_law_fit *fit, double q) {
    const double x[3] = {fit->a, fit->b, fit->c};
    double slope[3], variance = 0;
    law_slopes(x, 3, q, slope);
    for (int j = 0; j < 9; j++) variance += slope[j / 3] * slope[j % 3] * fit->covariance[j];
    return sqrt(fmax(0, variance));
}

/* what a reader should look at twice; data on the law itself leave rounding alone, nothing unusual */
static void mark_unusual(const wcut_law_data *d, int parameters, const wcut_law_fit *fit, wcut_law_fit_point *point) {
    const double share = (double)parameters / d->n;
    for (int i = 0; i < d->n && fit->scale > 1e-12; i++) {
        wcut_law_fit_point *at = &point[i];
        double error = wcut_law_fit_error(fit, d->q[i]);
        at->influence = error > 0 ? (at->fitted - at->left_out) / error : 0;
        at->unusual = (fabs(at->residual) > 3 ? WCUT_UNUSUAL_OUTLIER : 0) +
                      (at->leverage > 2 * share ? WCUT_UNUSUAL_LEVERAGE : 0) +
                      (fabs(at->influence) > 2 * sqrt(share) ? WCUT_UNUSUAL_INFLUENTIAL : 0);
    }
}

static void keep_solution(const trial *t, const solution *s, const wcut_calibration_options *o, wcut_law_fit *fit) {
    int p = s->parameters;
    *fit = (wcut_law_fit){.a = s->x[0], .b = s->x[1], .c = p > 2 ? s->x[2] : 0, .c_held = p < 3, .lack_p = 1};
    fit->scale = s->report.scale;
    fit->degrees = t->d->n - p;
    double t_quantile = wcut_student_quantile(0.5 + o->confidence / 2, fit->degrees);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3 && i < p && j < p; j++) fit->covariance[3 * i + j] = s->covariance[i * p + j];
        double value = i < p ? s->x[i] : 0;
        fit->standard_error[i] = sqrt(fit->covariance[(size_t)4 * (size_t)i]);
        fit->low[i] = value - t_quantile * fit->standard_error[i];
        fit->high[i] = value + t_quantile * fit->standard_error[i];
    }
    for (int j = 0; j < 9; j++) {
        double size = fit->standard_error[j / 3] * fit->standard_error[j % 3];
        fit->correlation[j] = size > 0 ? fit->covariance[j] / size : 0;
    }
}

/* all that is known beside the parameters; t->sigma is that of the solution */
static wcut_status examine(trial *t, const solution *s, const wcut_calibration_options *o, double *work,
                           wcut_law_fit *fit, wcut_law_fit_point *point) {
    const wcut_law_data *d = t->d;

    /* fitted values and standardised residuals */
    double *loss_weight = work + 7 * (size_t)d->n, *e = work + 5 * (size_t)d->n, relative, absolute;
    for (int i = 0; i < d->n; i++) {
        double fitted = law_at(s->x, s->parameters, d->q[i]), off = (d->y[i] - fitted) * sqrt(d->weight[i]);
        double unit = s->report.scale * t->sigma[i];
        point[i] = (wcut_law_fit_point){.measured = d->y[i],
                                        .fitted = fitted,
                                        .residual = unit > 0 ? off / unit : 0,
                                        .loss_weight = loss_weight[i],
                                        .left_out = fitted,
                                        .relative = d->y[i] / fitted - 1};
    }

    /* lack of fit by replicates, or by a more flexible law where there are none */
    linearise(t, s, loss_weight, 0, work, e);
    wcut_status status = WCUT_OK;
    if (!test_replicates(t, s, loss_weight, e, fit)) status = test_flexible(t, s, loss_weight, work, fit);

    /* leverages, each cut left out, marks */
    if (status == WCUT_OK) status = find_leverages(t, s, loss_weight, work, point);
    if (status == WCUT_OK) status = leave_out(t, s, o, work, fit, point);
    if (status == WCUT_OK) mark_unusual(d, s->parameters, fit, point);

    /* which noise model is likelier: log likelihoods of relative and absolute */
    if (status == WCUT_OK) status = log_likelihood(t, WCUT_NOISE_RELATIVE, s->parameters, s->x, work, &relative);
    if (status == WCUT_OK) status = log_likelihood(t, WCUT_NOISE_ABSOLUTE, s->parameters, s->x, work, &absolute);
    if (status == WCUT_OK) fit->evidence = relative - absolute;

    return status == WCUT_NO_MEMORY ? status : WCUT_OK; /* a comparison that cannot be made says nothing: 0 */
}

wcut_status wcut_law_fit_solve(const wcut_law_data *d, const wcut_calibration_options *o, wcut_law_fit *fit,
                               wcut_law_fit_point *point) {
    /* room for all scratch of the fit */
    size_t n = (size_t)d->n;
    double *work = wcut_alloc(9 * n, sizeof *work);
    wcut_law_fit_point *found = wcut_alloc(n, sizeof *found);
    wcut_status status = work && found ? WCUT_OK : WCUT_NO_MEMORY;
    if (status != WCUT_OK) goto done;

    trial t = {.d = d, .sigma = work + 8 * n};
    solution s = {.parameters = 0};
    wcut_law_fit at;

    /* the fit itself; more cuts than parameters are needed */
    status = fit_law(&t, o, o->loss, d->weight, work + 7 * n, work, &s);
    if (status == WCUT_OK && d->n <= s.parameters) status = WCUT_DEGENERATE;
    if (status != WCUT_OK) goto done;
    keep_solution(&t, &s, o, &at);

    /* tests and marks, then write everything at once */
    status = examine(&t, &s, o, work, &at, found);
    if (status != WCUT_OK) goto done;
    *fit = at;
    memcpy(point, found, n * sizeof *found);

done:
    wcut_free(found);
    wcut_free(work);
    return status;
}
