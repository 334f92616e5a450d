/* Small dense least squares: Householder QR (Golub 1965), Levenberg-Marquardt, iterated reweighting. */
#include "base/least_squares.h"

#include <float.h>
#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/sort.h"

static double sum_of_squares(int n, const double *x, int stride) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += x[(size_t)i * stride] * x[(size_t)i * stride];
    return sum;
}

static void swap(double *x, double *y) {
    double t = *x;
    *x = *y;
    *y = t;
}

/* bring the longest remaining column to place k; return its remaining length */
static double pivot_column(int m, int n, double *a, int k, int *order) {
    int best = k;
    double max = -1;
    for (int j = k; j < n; j++) {
        double length = sum_of_squares(m - k, a + (size_t)k * n + j, n);
        if (length > max) max = length, best = j;
    }

    /* exchange the columns and their numbers */
    if (best != k) {
        for (int i = 0; i < m; i++) swap(a + (size_t)i * n + k, a + (size_t)i * n + best);
        int t = order[k];
        order[k] = order[best];
        order[best] = t;
    }
    return sqrt(max);
}

/* reflect column k onto its diagonal, and the later columns and b with it */
static void reflect(int m, int n, double *a, double *b, int k, double length) {
    double head = a[(size_t)k * n + k], diagonal = head > 0 ? -length : length;
    double *v = a + (size_t)k * n + k; /* the reflector takes the column's place, stride n */
    v[0] = head - diagonal;
    double half = -diagonal * v[0]; /* |v|^2 / 2 */
    for (int j = k + 1; j <= n; j++) {
        double *y = j < n ? a + (size_t)k * n + j : b + k, dot = 0;
        int stride = j < n ? n : 1;
        for (int i = 0; i < m - k; i++) dot += v[(size_t)i * n] * y[(size_t)i * stride];
        for (int i = 0; i < m - k; i++) y[(size_t)i * stride] -= dot / half * v[(size_t)i * n];
    }
    v[0] = diagonal;
}

/* row k of R^-1 into u, by back substitution for the unit vector k (u has n entries) */
static void solve_upper(int n, const double *a, const double *rhs, double *u) {
    for (int i = n - 1; i >= 0; i--) {
        double sum = rhs[i];
        for (int j = i + 1; j < n; j++) sum -= a[(size_t)i * n + j] * u[j];
        u[i] = sum / a[(size_t)i * n + i];
    }
}

/* (A^T A)^-1 = P D^-1 R^-1 R^-T D^-1 P^T; column c of R^-1 goes to work[c] */
static void normal_inverse(int n, const double *a, const int *order, const double *scale, double *work,
                           double *inverse) {
    double *unit = work + (size_t)n * n;
    for (int c = 0; c < n; c++) {
        memset(unit, 0, (size_t)n * sizeof *unit);
        unit[c] = 1;
        solve_upper(n, a, unit, work + (size_t)c * n);
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            double sum = 0;
            for (int c = 0; c < n; c++) sum += work[(size_t)c * n + i] * work[(size_t)c * n + j];
            inverse[(size_t)order[i] * n + order[j]] = sum / (scale[order[i]] * scale[order[j]]);
        }
    }
}

wcut_status wcut_qr_solve(int m, int n, double *a, double *b, double *x, double *inverse) {
    if (m < n || n < 1 || !a || !b || !x) return WCUT_BAD_ARGUMENT;
    double *work = wcut_alloc((size_t)n * (n + 3), sizeof *work);
    int *order = wcut_alloc(n, sizeof *order);
    wcut_status status = work && order ? WCUT_OK : WCUT_NO_MEMORY;
    if (status != WCUT_OK) goto done;

    /* scale every column to length 1 */
    double *scale = work + (size_t)n * (n + 1), *u = scale + n;
    for (int j = 0; j < n; j++) {
        order[j] = j;
        scale[j] = sqrt(sum_of_squares(m, a + j, n));
        if (!is_positive(scale[j])) status = WCUT_SINGULAR;
        for (int i = 0; i < m && status == WCUT_OK; i++) a[(size_t)i * n + j] /= scale[j];
    }

    /* reduce to triangular form; a short remaining column means that columns are dependent */
    for (int k = 0; k < n && status == WCUT_OK; k++) {
        double length = pivot_column(m, n, a, k, order);
        if (length > 1e-13)
            reflect(m, n, a, b, k, length);
        else
            status = WCUT_SINGULAR;
    }
    if (status != WCUT_OK) goto done;

    /* back substitution, then columns and scales as they were */
    if (inverse) normal_inverse(n, a, order, scale, work, inverse);
    solve_upper(n, a, b, u);
    for (int j = 0; j < n; j++) x[order[j]] = u[j] / scale[order[j]];

done:
    wcut_free(order);
    wcut_free(work);
    return status;
}

/* what one solve works on: everything is weighted by root = sqrt(prior weight x loss weight) */
typedef struct solver {
    const wcut_lsq_problem *p;
    wcut_lsq_options o;
    double *root, *r, *r_trial, *jacobian, *x, *x_trial, *step, *column; /* m m m m*n n n n n */
    double *a, *b, *omega, *magnitude;                                   /* (m+n)*n m+n m m */
    double cost;
    int iterations;
} solver;

/* weighted residuals (and Jacobian) at x; false outside the domain */
static bool least_squares_evaluate(solver *s, const double *x, double *r, double *jacobian, double *cost) {
    int m = s->p->m, n = s->p->n;
    if (!s->p->model(s->p->data, x, r, jacobian)) return false;
    for (int i = 0; i < m; i++) r[i] *= s->root[i];
    for (int i = 0; jacobian && i < m; i++)
        for (int j = 0; j < n; j++) jacobian[(size_t)i * n + j] *= s->root[i];
    *cost = sum_of_squares(m, r, 1);
    return isfinite(*cost) && (!jacobian || all_finite(m * n, jacobian));
}

/* the largest cosine between the residual and a column of the Jacobian: 0 at a minimum */
static double steepness(const solver *s) {
    int m = s->p->m, n = s->p->n;
    double max = 0;
    for (int j = 0; j < n && s->cost > 0; j++) {
        double dot = 0;
        for (int i = 0; i < m; i++) dot += s->jacobian[(size_t)i * n + j] * s->r[i];
        double length = sqrt(sum_of_squares(m, s->jacobian + j, n) * s->cost);
        if (length > 0) max = fmax(max, fabs(dot) / length);
    }
    return max;
}

/* step = argmin |J step + r|^2 + damping |D step|^2, and the fall of the cost that the linear model promises */
static wcut_status damped_step(solver *s, double damping, double *promised) {
    int m = s->p->m, n = s->p->n;
    size_t entries = (size_t)m * n;

    /* the rows of J, then those of sqrt(damping) D */
    memcpy(s->a, s->jacobian, entries * sizeof *s->a);
    memset(s->a + entries, 0, (size_t)n * n * sizeof *s->a);
    for (int i = 0; i < m; i++) s->b[i] = -s->r[i];
    for (int j = 0; j < n; j++) {
        s->column[j] = fmax(s->column[j], sqrt(sum_of_squares(m, s->jacobian + j, n)));
        s->a[entries + (size_t)j * n + j] = sqrt(damping) * s->column[j];
        s->b[m + j] = 0;
    }

    wcut_status status = wcut_qr_solve(m + n, n, s->a, s->b, s->step, NULL);
    if (status != WCUT_OK) return status;

    /* the cost that the linear model gives after the step */
    double linear = 0;
    for (int i = 0; i < m; i++) {
        double r = s->r[i];
        for (int j = 0; j < n; j++) r += s->jacobian[(size_t)i * n + j] * s->step[j];
        linear += r * r;
    }
    *promised = s->cost - linear;

    return WCUT_OK;
}

/* is the step too small to change x? */
static bool step_is_nothing(const solver *s) {
    for (int j = 0; j < s->p->n; j++)
        if (fabs(s->step[j]) > 2 * DBL_EPSILON * fabs(s->x[j])) return false;
    return true;
}

/* Levenberg-Marquardt with the weights as they stand */
static wcut_status minimise(solver *s) {
    double damping = 1e-3, growth = 2, promised, cost;

    /* cost and Jacobian at the start */
    if (!least_squares_evaluate(s, s->x, s->r, s->jacobian, &s->cost)) return WCUT_BAD_ARGUMENT;
    memset(s->column, 0, (size_t)s->p->n * sizeof *s->column);

    /* a step, a trial, and the damping for the next */
    for (int k = 0; k < s->o.max_iterations; k++) {
        if (steepness(s) <= s->o.tolerance) return WCUT_OK;
        wcut_status status = damped_step(s, damping, &promised);
        if (status != WCUT_OK) return status;
        if (step_is_nothing(s)) return WCUT_OK;
        s->iterations++;

        /* the trial step; a trial outside the domain counts as a rise */
        for (int j = 0; j < s->p->n; j++) s->x_trial[j] = s->x[j] + s->step[j];
        bool inside = least_squares_evaluate(s, s->x_trial, s->r_trial, NULL, &cost);
        /* near the minimum the fall drowns in rounding: there the linear model is trusted */
        double gain = inside ? (s->cost - cost) / promised : -1;
        bool level = inside && promised < 1e-12 * s->cost && cost <= s->cost * (1 + 1e-13);
        if (gain > 1e-4 || level) {
            memcpy(s->x, s->x_trial, (size_t)s->p->n * sizeof *s->x);
            if (!least_squares_evaluate(s, s->x, s->r, s->jacobian, &s->cost)) return WCUT_BAD_ARGUMENT;
            damping = level ? damping / 10 : damping * fmax(1.0 / 10, 1 - pow(2 * gain - 1, 3));
            growth = 2;
        } else {
            damping *= growth;
            growth *= 2;
            if (damping > 1e200) return WCUT_NOT_CONVERGED;
        }
    }

    return WCUT_NOT_CONVERGED;
}

/* 1.4826 median |r| of the residuals that have a weight, widened for the n parameters; r already by sqrt(prior) */
static double least_squares_spread(solver *s, const double *r, const double *prior, int degrees) {
    int count = 0;
    for (int i = 0; i < s->p->m; i++)
        if (!prior || prior[i] > 0) s->magnitude[count++] = fabs(r[i]);
    wcut_sort(count, s->magnitude);
    double median = sorted_median(count, s->magnitude);
    /* more than half of the residuals vanish: any positive scale calls the others outliers */
    double min = 1e-12 * s->magnitude[count - 1];
    return fmax(1.4826 * median * sqrt((double)count / (degrees > 0 ? degrees : 1)), min);
}

/* psi(u)/u */
static double loss_weight_of(wcut_loss loss, double u) {
    if (loss == WCUT_LOSS_HUBER) return fabs(u) <= 1.345 ? 1 : 1.345 / fabs(u);
    double v = u / 4.685;
    return fabs(v) < 1 ? (1 - v * v) * (1 - v * v) : 0;
}

/* psi'(u) */
static double loss_slope(wcut_loss loss, double u) {
    if (loss == WCUT_LOSS_HUBER) return fabs(u) <= 1.345;
    double v = u / 4.685;
    return fabs(v) < 1 ? (1 - v * v) * (1 - 5 * v * v) : 0;
}

static double prior_weight(const solver *s, int i) { return s->p->weight ? s->p->weight[i] : 1; }

/* r at x by the prior weights alone, into r_trial, and their cost; false outside the domain */
static bool plain_residuals(solver *s, double *cost) {
    *cost = 0;
    if (!s->p->model(s->p->data, s->x, s->r_trial, NULL)) return false;
    for (int i = 0; i < s->p->m; i++) {
        s->r_trial[i] *= sqrt(prior_weight(s, i));
        *cost += s->r_trial[i] * s->r_trial[i];
    }
    return isfinite(*cost);
}

/* minimise, reweight, until the weights stand still; the scale is frozen after 20 rounds so that they must */
static wcut_status reweight(solver *s, wcut_loss loss, int degrees, double *scale, int *rounds) {
    /* redescending: the scale comes from Huber's fit */
    bool frozen = loss == WCUT_LOSS_TUKEY || s->o.scale > 0;
    if (s->o.scale > 0) *scale = s->o.scale;
    for (int k = 0; k < s->o.max_rounds; k++, (*rounds)++) {
        double cost;
        if (!plain_residuals(s, &cost)) return WCUT_BAD_ARGUMENT;
        if (!frozen) *scale = least_squares_spread(s, s->r_trial, s->p->weight, degrees);
        frozen = frozen || k >= 20;

        /* new weights, and how much they changed */
        double change = 0;
        for (int i = 0; i < s->p->m; i++) {
            double omega = *scale > 0 ? loss_weight_of(loss, s->r_trial[i] / *scale) : 1;
            change = fmax(change, fabs(omega - s->omega[i]));
            s->omega[i] = omega;
            s->root[i] = sqrt(prior_weight(s, i) * omega);
        }
        if (change < 1e-11 && k > 0) return WCUT_OK;

        /* minimise with the new weights */
        wcut_status status = minimise(s);
        if (status != WCUT_OK) return status;
    }

    return WCUT_NOT_CONVERGED;
}

/* Huber (1981, 7.6.4): factor on (J^T W J)^-1, W the prior weights */
static double robust_variance(const solver *s, double scale, int degrees) {
    double psi2 = 0, slope = 0, slope2 = 0;
    int count = 0;
    for (int i = 0; i < s->p->m; i++) {
        if (!(prior_weight(s, i) > 0)) continue;
        double u = scale > 0 ? s->r_trial[i] / scale : 0, d = loss_slope(s->o.loss, u), w = u * s->omega[i];
        count++;
        psi2 += w * w;
        slope += d;
        slope2 += d * d;
    }

    /* Huber's factor from the mean and the variance of psi' */
    double mean = slope / count, variance = fmax(0, slope2 / count - mean * mean);
    double k = 1 + (double)s->p->n / count * variance / (mean * mean);
    return k * k * scale * scale * psi2 / degrees / (mean * mean);
}

static wcut_status covariance_at(solver *s, double variance, double *covariance) {
    int m = s->p->m, n = s->p->n;
    for (int i = 0; i < m; i++) s->root[i] = sqrt(prior_weight(s, i));
    double cost;
    if (!least_squares_evaluate(s, s->x, s->r, s->jacobian, &cost)) return WCUT_BAD_ARGUMENT;
    memcpy(s->b, s->r, (size_t)m * sizeof *s->b);
    wcut_status status = wcut_qr_solve(m, n, s->jacobian, s->b, s->step, s->a);
    for (int k = 0; k < n * n && status == WCUT_OK; k++) covariance[k] = variance * s->a[k];
    return status;
}

wcut_lsq_options wcut_lsq_options_default(void) {
    return (wcut_lsq_options){.loss = WCUT_LOSS_SQUARE, .tolerance = 1e-11, .max_iterations = 200, .max_rounds = 500};
}

/* the arrays of a solve, in one block */
static double *least_squares_lay_out(solver *s) {
    size_t m = s->p->m, n = s->p->n;
    double *block = wcut_alloc(6 * m + 5 * n + m * n + (m + n) * n + n * n, sizeof *block);
    if (!block) return NULL;
    s->root = block, s->r = s->root + m, s->r_trial = s->r + m, s->omega = s->r_trial + m;
    s->magnitude = s->omega + m, s->b = s->magnitude + m, s->x = s->b + m + n, s->x_trial = s->x + n;
    s->step = s->x_trial + n, s->column = s->step + n, s->jacobian = s->column + n, s->a = s->jacobian + m * n;
    return block;
}

wcut_status wcut_lsq_solve(const wcut_lsq_problem *p, const wcut_lsq_options *options, double *x, double *covariance,
                           double *loss_weight, wcut_lsq_report *report) {
    solver s = {.p = p, .o = options ? *options : wcut_lsq_options_default()};
    if (!p || !p->model || p->n < 1 || p->m < p->n || !x || !all_finite(p->n, x)) return WCUT_BAD_ARGUMENT;
    if (!(s.o.tolerance > 0) || s.o.max_iterations < 1 || s.o.max_rounds < 1 ||
        !(s.o.scale >= 0 && isfinite(s.o.scale)) || (unsigned)s.o.loss > WCUT_LOSS_TUKEY)
        return WCUT_BAD_ARGUMENT;

    /* degrees of freedom: residuals that have a weight, less the parameters */
    int degrees = -p->n;
    for (int i = 0; i < p->m; i++) {
        if (p->weight && !(p->weight[i] >= 0 && isfinite(p->weight[i]))) return WCUT_BAD_ARGUMENT;
        degrees += !p->weight || p->weight[i] > 0;
    }
    if (degrees < 0) return WCUT_SINGULAR;

    double *block = least_squares_lay_out(&s), *answer = wcut_alloc((size_t)p->n * p->n, sizeof *answer);
    wcut_status status = block && answer ? WCUT_OK : WCUT_NO_MEMORY;
    if (status != WCUT_OK) goto done;

    /* start at the caller's x with the prior weights */
    wcut_lsq_report at = {.degrees = degrees};
    memcpy(s.x, x, (size_t)p->n * sizeof *x);
    for (int i = 0; i < p->m; i++) s.root[i] = sqrt(prior_weight(&s, i)), s.omega[i] = 1;
    /* a robust fit does not begin with least squares: an outlier could lead it far from the start that was given */
    if (s.o.loss == WCUT_LOSS_SQUARE)
        status = minimise(&s);
    else
        status = reweight(&s, WCUT_LOSS_HUBER, degrees, &at.scale, &at.rounds);
    if (status == WCUT_OK && s.o.loss == WCUT_LOSS_TUKEY)
        status = reweight(&s, WCUT_LOSS_TUKEY, degrees, &at.scale, &at.rounds);
    if (status != WCUT_OK && status != WCUT_NOT_CONVERGED) goto done;

    /* the report at the solution */
    plain_residuals(&s, &at.cost); /* inside the domain, or there would be no answer */
    at.iterations = s.iterations;
    double variance = degrees > 0 ? at.cost / degrees : 0;
    if (s.o.loss == WCUT_LOSS_SQUARE)
        at.scale = sqrt(variance);
    else if (degrees > 0)
        variance = robust_variance(&s, at.scale, degrees);
    wcut_status solvable = covariance ? covariance_at(&s, variance, answer) : WCUT_OK;
    if (solvable != WCUT_OK) {
        status = solvable;
        goto done;
    }

    /* hand out */
    memcpy(x, s.x, (size_t)p->n * sizeof *x);
    if (covariance) memcpy(covariance, answer, (size_t)p->n * p->n * sizeof *answer);
    if (loss_weight) memcpy(loss_weight, s.omega, (size_t)p->m * sizeof *s.omega);
    if (report) *report = at;

done:
    wcut_free(answer);
    wcut_free(block);
    return status;
}
