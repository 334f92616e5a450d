/* Least squares for a rigid motion: damped Gauss-Newton steps in the directions that data and priors determine. */
#include "scan/register_solve.h"

#include <stdbool.h>
#include <string.h>

#include "base/numbers.h"
#include "base/symmetric.h"

enum { N = WCUT_DOF_COUNT, SETTLED = 20 };

static const double MIXED = 0.01; /* [1] share of an undetermined direction in a parameter that leaves it determined */
static const double DAMPED_MAX = 1e9;
static const double ROUNDING = 1e-12;      /* [1] of the cost, a rise that is not one */
static const double SHARE_OF_ERROR = 0.01; /* [1] a step of this share of the standard error changes no answer */

/* the problem in the variables y = (t, length w), those that are not locked */
typedef struct normal {
    int m, index[N];
    int rank, by_data;
    double h[N * N], g[N]; /* m x m, m: of the data alone */
    double basis[N * N];   /* m x m by columns: `rank` determined directions, then the others */
    double prior[N];       /* m: 1 / sigma^2, 0 where there is none */
    double pull[N];        /* m: its (x - value) / sigma^2 */
} normal;

static double parameter_scale(const wcut_register_problem *p, int k) { return k < WCUT_DOF_RX ? 1 : 1 / p->length; }

static double prior_cost(const wcut_registration_options *o, const double *x) {
    double sum = 0;
    for (int k = 0; k < N; k++) {
        const double e = (x[k] - o->dof[k].value) / o->dof[k].sigma;
        if (o->dof[k].kind == WCUT_DOF_KIND_PRIOR) sum += e * e;
    }
    return sum;
}

/* from shift and turn to the six parameters: out = T^t H T, T^t g, T = (I, J) times the scale of y */
static void to_parameters(const wcut_register_problem *p, const wcut_motion *motion, const wcut_register_sums *s,
                          double *h, double *g) {
    /* T: how shift and turn follow the parameters, the turn through the left Jacobian */
    const mat3 jacobian = wcut_motion_jacobian(motion->x + WCUT_DOF_RX);
    const wcut_vec3 row[3] = {jacobian.x, jacobian.y, jacobian.z};
    double t[N * N] = {0}, ht[N * N] = {0};
    for (int k = 0; k < 3; k++) {
        t[N * k + k] = 1;
        t[N * (k + 3) + 3] = row[k].x / p->length;
        t[N * (k + 3) + 4] = row[k].y / p->length;
        t[N * (k + 3) + 5] = row[k].z / p->length;
    }

    /* H T, then T' H T and T' g */
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            for (int k = 0; k < N; k++) ht[N * i + j] += s->h[i < k ? N * i + k : N * k + i] * t[N * k + j];
    memset(h, 0, (size_t)N * N * sizeof *h);
    memset(g, 0, N * sizeof *g);
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++) {
            for (int j = 0; j < N; j++) h[N * i + j] += t[N * k + i] * ht[N * k + j];
            g[i] += t[N * k + i] * s->g[k];
        }
}

/* columns `first` .. m-1 of the basis, turned so that those that a prior sees come first; how many these are */
static int seen_by_prior(normal *n, int first, double min) {
    const int k = n->m - first;
    double seen[N * N] = {0}, value[N], vector[N * N], turned[N * N];
    for (int a = 0; a < k; a++)
        for (int b = 0; b < k; b++)
            for (int i = 0; i < n->m; i++)
                if (n->prior[i] > 0) seen[a * k + b] += n->basis[i * n->m + first + a] * n->basis[i * n->m + first + b];
    wcut_symmetric_eigen(k, seen, value, vector);
    for (int i = 0; i < n->m; i++)
        for (int b = 0; b < k; b++) {
            turned[i * k + b] = 0;
            for (int a = 0; a < k; a++) turned[i * k + b] += n->basis[i * n->m + first + a] * vector[a * k + b];
        }
    int count = 0;
    for (int i = 0; i < n->m; i++)
        for (int b = 0; b < k; b++) n->basis[i * n->m + first + b] = turned[i * k + b];
    while (count < k && value[count] > min) count++;
    return count;
}

/* what moves along which direction: by the data per unit of weight, then by the priors */
static void determine(const wcut_register_problem *p, double weight, int max, normal *n) {
    const double min = p->options->sensitivity * p->options->sensitivity;
    double a[N * N], value[N];
    for (int i = 0; i < n->m * n->m; i++) a[i] = n->h[i] / weight;
    wcut_symmetric_eigen(n->m, a, value, n->basis);
    n->by_data = 0;
    while (n->by_data < max && value[n->by_data] > min) n->by_data++;
    n->rank = n->by_data + (n->by_data < n->m ? seen_by_prior(n, n->by_data, min) : 0);
}

static void register_solve_linearise(const wcut_register_problem *p, const wcut_motion *motion,
                                     const wcut_register_sums *s, int max, normal *n) {
    double h[N * N], g[N];
    to_parameters(p, motion, s, h, g);
    n->m = 0;
    for (int k = 0; k < N; k++)
        if (p->options->dof[k].kind != WCUT_DOF_KIND_LOCKED) n->index[n->m++] = k;
    for (int i = 0; i < n->m; i++) {
        const int k = n->index[i];
        const wcut_dof *d = &p->options->dof[k];
        const double scale = parameter_scale(p, k), sigma = d->sigma / scale;
        for (int j = 0; j < n->m; j++) n->h[i * n->m + j] = h[N * k + n->index[j]];
        n->g[i] = g[k];
        n->prior[i] = d->kind == WCUT_DOF_KIND_PRIOR ? 1 / (sigma * sigma) : 0;
        n->pull[i] = n->prior[i] * (motion->x[k] - d->value) / scale;
    }
    determine(p, s->weight, max < n->m ? max : n->m, n);
}

/* the information of data, times `share`, and priors in the determined directions */
static void reduce(const normal *n, double share, double *reduced) {
    const int m = n->m, r = n->rank;
    for (int a = 0; a < r; a++)
        for (int b = 0; b < r; b++) {
            double sum = 0;
            for (int i = 0; i < m; i++)
                for (int j = 0; j < m; j++)
                    sum += n->basis[i * m + a] * (share * n->h[i * m + j] + (i == j ? n->prior[i] : 0)) *
                           n->basis[j * m + b];
            reduced[a * r + b] = sum;
        }
}

/* a step in y; its length [mm], how far points move (RMS) */
static double register_solve_step_of(const normal *n, double variance, double damping, double *y) {
    const int m = n->m, r = n->rank;
    double a[N * N], b[N] = {0}, z[N] = {0}, square = 0;
    reduce(n, 1 / variance, a);
    for (int k = 0; k < r; k++) {
        a[k * r + k] *= 1 + damping;
        for (int i = 0; i < m; i++) b[k] -= n->basis[i * m + k] * (n->g[i] / variance + n->pull[i]);
    }
    if (!wcut_symmetric_solve(r, a, b, z, NULL)) return INFINITY;
    for (int i = 0; i < m; i++) {
        y[i] = 0;
        for (int k = 0; k < r; k++) y[i] += n->basis[i * m + k] * z[k];
        square += y[i] * y[i];
    }
    return sqrt(square);
}

/* of a residual of weight 1, given or as the residuals are; never 0, for the cost is divided by it */
static double variance_of(const wcut_register_problem *p, const wcut_register_sums *s, int rank) {
    const double floor = 1e-13 * p->length;
    if (p->noise > 0) return p->noise * p->noise;
    const double over = s->used > rank ? s->weight * (s->used - rank) / s->used : s->weight / s->used;
    return fmax(s->square / over / p->consistency, floor * floor);
}

/* [mm] RMS over the points: the standard error of where the motion puts them, in the determined directions */
static double error_of(const wcut_register_problem *p, const normal *n, double variance) {
    double a[N * N], zero[N] = {0}, x[N], inverse[N * N], sum = 0;
    reduce(n, p->consistency / variance, a);
    if (!wcut_symmetric_solve(n->rank, a, zero, x, inverse)) return INFINITY;
    for (int k = 0; k < n->rank; k++) sum += inverse[k * n->rank + k];
    return sqrt(sum);
}

/* [mm] a step below this one is none */
static double settled_step(const wcut_register_problem *p, const normal *n, double variance) {
    const double error = p->held ? error_of(p, n, variance) : 0;
    return isfinite(error) ? fmax(p->options->tolerance, SHARE_OF_ERROR * error) : p->options->tolerance;
}

/* the cost at a trial: of the residuals held, or of those that the model gives there; INFINITY where it gives too few */
static wcut_status cost_at(const wcut_register_problem *p, const wcut_motion *trial, double weight,
                           wcut_register_sums *there, double *square) {
    if (p->held) {
        *square = p->held(p->data, trial);
        return WCUT_OK;
    }
    const wcut_status status = p->model(p->data, trial, there);
    *square = status == WCUT_OK ? there->square / there->weight * weight : INFINITY;
    return status == WCUT_DEGENERATE ? WCUT_OK : status;
}

/* Take a trial that lowers the cost: residuals are chosen anew there. Where too few are left, those of the motion before
   are chosen again and the trial is not taken. */
static wcut_status register_solve_accept(const wcut_register_problem *p, const wcut_motion *trial, wcut_motion *motion,
                                         wcut_register_sums *there, bool *accepted) {
    wcut_status status = WCUT_OK;
    if (p->held) {
        *there = (wcut_register_sums){.weight = 0};
        status = p->model(p->data, trial, there);
    }
    *accepted = status == WCUT_OK;
    if (status == WCUT_DEGENERATE) {
        wcut_register_sums again = {.weight = 0};
        status = p->model(p->data, motion, &again);
    }
    if (*accepted) *motion = *trial;
    return status;
}

/* one accepted step from motion, or none: how far points moved, INFINITY where no step of any length was better */
static wcut_status register_solve_advance(const wcut_register_problem *p, const normal *n, double variance,
                                          double *damping, wcut_motion *motion, wcut_register_sums *sums,
                                          double settled, double *moved) {
    /* try steps of growing damping until one lowers the cost */
    const double cost = sums->square / variance + prior_cost(p->options, motion->x);
    for (; *damping < DAMPED_MAX; *damping = fmax(1e-3, 10 * *damping)) {
        double y[N] = {0}, x[N], square = 0;
        *moved = register_solve_step_of(n, variance, *damping, y);

        /* small, and not only for its damping */
        if (*moved <= settled && *damping > 1) break;
        if (*moved <= settled) return WCUT_OK;
        if (!isfinite(*moved)) continue;

        /* the cost at the end of the step, of the same residuals */
        memcpy(x, motion->x, sizeof x);
        for (int i = 0; i < n->m; i++) x[n->index[i]] += y[i] * parameter_scale(p, n->index[i]);
        const wcut_motion trial = wcut_motion_of(motion->pivot, x);
        wcut_register_sums there = {.weight = 0};
        wcut_status status = cost_at(p, &trial, sums->weight, &there, &square);
        if (status != WCUT_OK) return status;
        if (!(square / variance + prior_cost(p->options, x) <= cost * (1 + ROUNDING))) continue;

        /* choose the residuals of the next step there */
        bool accepted;
        status = register_solve_accept(p, &trial, motion, &there, &accepted);
        if (status != WCUT_OK) return status;
        if (!accepted) continue;
        *sums = there;
        *damping = *damping > 1e-6 ? *damping / 10 : 0;
        return WCUT_OK;
    }
    *moved = INFINITY;

    return WCUT_OK;
}

/* parameters that hardly mix with a direction that is not determined */
static void tell_determined(const normal *n, wcut_registration *r) {
    for (int i = 0; i < n->m; i++) {
        double lost = 0;
        for (int k = n->rank; k < n->m; k++) lost += n->basis[i * n->m + k] * n->basis[i * n->m + k];
        r->determined[n->index[i]] = lost < MIXED;
    }
}

static wcut_status tell_covariance(const wcut_register_problem *p, const normal *n, double variance,
                                   wcut_registration *reg) {
    const int m = n->m, r = n->rank;
    double a[N * N], zero[N] = {0}, x[N], inverse[N * N];
    reduce(n, p->consistency / variance, a);
    if (!wcut_symmetric_solve(r, a, zero, x, inverse)) return WCUT_DEGENERATE;
    for (int i = 0; i < m; i++)
        for (int j = 0; j < m; j++) {
            const int k = n->index[i], l = n->index[j];
            double sum = 0;
            for (int c = 0; c < r; c++)
                for (int d = 0; d < r; d++) sum += n->basis[i * m + c] * inverse[c * r + d] * n->basis[j * m + d];
            if (reg->determined[k] && reg->determined[l])
                reg->covariance[N * k + l] = sum * parameter_scale(p, k) * parameter_scale(p, l);
        }
    return WCUT_OK;
}

static wcut_status report(const wcut_register_problem *p, const normal *n, const wcut_register_sums *s,
                          const wcut_motion *motion, wcut_registration *r) {
    const double variance = variance_of(p, s, n->rank);
    if (!(p->noise > 0) && s->used <= n->rank) return WCUT_DEGENERATE;
    r->pivot = motion->pivot;
    memcpy(r->parameter, motion->x, sizeof r->parameter);
    r->free = n->m;
    r->rank = n->rank;
    r->kept = s->used;
    r->overlap = s->overlap;
    r->noise = sqrt(variance);
    r->rms = sqrt(p->held ? s->square / s->weight : s->plain / s->used);
    r->doubt = error_of(p, n, variance);
    tell_determined(n, r);
    return tell_covariance(p, n, variance, r);
}

wcut_status wcut_register_solve(const wcut_register_problem *p, wcut_motion *motion, wcut_registration *registration) {
    /* residuals and normal equations at the start */
    wcut_motion at = wcut_motion_of(motion->pivot, motion->x);
    wcut_registration r = *registration;
    wcut_register_sums sums = {.weight = 0};
    normal n;
    double damping = 0, moved = INFINITY;
    int max = N;
    bool converged = false;
    wcut_status status = p->model(p->data, &at, &sums);

    /* linearise, step, until a step is within the tolerance */
    for (r.iterations = 0; status == WCUT_OK;) {
        register_solve_linearise(p, &at, &sums, max, &n);
        if (n.by_data == 0) return WCUT_DEGENERATE;

        /* what is at the edge of being determined ends on one side */
        if (r.iterations >= SETTLED) max = n.by_data;
        if (r.iterations >= p->max_iterations) break;
        const double variance = variance_of(p, &sums, n.rank), settled = settled_step(p, &n, variance);

        /* an accepted step moves the points by `moved`; INFINITY where none was better */
        status = register_solve_advance(p, &n, variance, &damping, &at, &sums, settled, &moved);
        converged = moved <= settled;
        if (isfinite(moved)) r.step = moved;
        if (converged || !isfinite(moved)) break;
        r.iterations++;
    }

    if (status == WCUT_OK) status = report(p, &n, &sums, &at, &r);
    if (status != WCUT_OK) return status;
    r.converged = converged;
    *motion = at;
    *registration = r;

    return converged ? WCUT_OK : WCUT_NOT_CONVERGED;
}
