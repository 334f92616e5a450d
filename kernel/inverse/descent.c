/* Levenberg-Marquardt on the curves of a trial. */
#include "inverse/descent.h"

#include <string.h>

#include "base/alloc.h"
#include "base/dense.h"
#include "base/numbers.h"

#define FLOOR 1e-1  /* [1] of the mean diagonal: what hardly matters is damped as if it did so much */
#define LITTLE 0.01 /* [1] two steps that lower the cost by less end a round */

enum { UNKNOWNS_MAX = WCUT_DESIGN_CURVES * WCUT_KNOTS_MAX, FAILURES = 6 };

bool wcut_descent_create(int points, wcut_design_progress progress, void *context, wcut_descent *s) {
    const size_t n = UNKNOWNS_MAX;
    *s = (wcut_descent){.progress = progress, .context = context};
    s->strays = wcut_alloc((size_t)points, 1);
    s->normal = wcut_alloc(n * n, sizeof(double));
    s->trial_normal = wcut_alloc(n * n, sizeof(double));
    s->matrix = wcut_alloc(n * n, sizeof(double));
    s->gradient = wcut_alloc(n, sizeof(double));
    s->trial_gradient = wcut_alloc(n, sizeof(double));
    s->step = wcut_alloc(n, sizeof(double));
    return s->strays && s->normal && s->trial_normal && s->matrix && s->gradient && s->trial_gradient && s->step;
}

void wcut_descent_destroy(wcut_descent *s) {
    wcut_free(s->normal);
    wcut_free(s->trial_normal);
    wcut_free(s->matrix);
    wcut_free(s->gradient);
    wcut_free(s->trial_gradient);
    wcut_free(s->step);
    wcut_free(s->strays);
}

/* the bounds that a step would break join the equations; gives how many they are */
static int join_bounds(wcut_descent *s, int n, int bounds, const wcut_bound *bound) {
    int active = 0;
    for (int k = 0; k < bounds; k++) {
        const wcut_bound *b = &bound[k];
        double excess = b->excess;
        for (int r = 0; r < 4; r++) excess += b->row[r] * s->step[b->first + r];
        s->active[k] = excess > 0;
        active += s->active[k];
    }
    for (int p = 0; p < n; p++) s->step[p] = -s->gradient[p];
    for (int k = 0; k < bounds; k++) {
        const wcut_bound *b = &bound[k];
        for (int p = 0; p < 4 && s->active[k]; p++) {
            s->step[b->first + p] -= b->row[p] * b->excess;
            for (int q = 0; q < 4; q++) s->matrix[(b->first + p) * n + b->first + q] += b->row[p] * b->row[q];
        }
    }
    return active;
}

/* (A + damping diag A) step = - gradient, with the bounds that the step would break (an active set), and no unknown by
   more than `longest` */
static bool find_design_step(wcut_descent *s, int n, double damping, double longest, int bounds,
                             const wcut_bound *bound) {
    double largest = 0, mean = 0;
    int active = -1;
    for (int p = 0; p < n; p++) {
        largest = fmax(largest, s->normal[p * n + p]);
        mean += s->normal[p * n + p] / n;
    }
    memset(s->step, 0, (size_t)n * sizeof *s->step);
    for (int turn = 0; turn < 8; turn++) {
        memcpy(s->matrix, s->normal, (size_t)n * (size_t)n * sizeof(double));
        for (int p = 0; p < n; p++)
            s->matrix[p * n + p] += damping * fmax(s->normal[p * n + p], FLOOR * mean) + 1e-12 * largest;
        const int now = join_bounds(s, n, bounds, bound);
        if (!wcut_cholesky_factor(n, s->matrix, 0)) return false;
        wcut_cholesky_solve(n, s->matrix, s->step);
        if (now == active) break;
        active = now;
    }
    double most = 0;
    for (int p = 0; p < n; p++) most = fmax(most, fabs(s->step[p]));
    for (int p = 0; p < n && most > longest; p++) s->step[p] *= longest / most;
    return isfinite(most);
}

static void take_design_step(const wcut_design_curves *from, const double *step, wcut_design_curves *to) {
    *to = *from;
    for (int k = 0; k < wcut_design_unknowns(from); k++)
        to->value[k / from->coefficients][k % from->coefficients] += step[k];
}

static void swap_rows_of(double **a, double **b) {
    double *t = *a;
    *a = *b;
    *b = t;
}

void wcut_descent_note(wcut_descent *s, const wcut_trial *search, const wcut_design_curves *c,
                       const wcut_reached *reached) {
    if (s->rounds == WCUT_ROUNDS_MAX) s->rounds--;
    s->round[s->rounds++] = (wcut_design_round){.stations = search->stations,
                                                .nodes = search->nodes,
                                                .unknowns = wcut_design_unknowns(c),
                                                .runs = s->runs,
                                                .rms = reached->rms,
                                                .max = reached->max};
    if (s->progress && s->progress(&s->round[s->rounds - 1], s->context) != 0) s->stopped = true;
}

/* A step's curves with their derivatives. After one that has failed the next may fail too: its cost first, and derivatives
   where it is below the limit. */
static wcut_status try_design_curves(wcut_descent *s, wcut_trial *search, const wcut_design_curves *c, double limit,
                                     wcut_reached *there) {
    if (limit < HUGE_VAL && !search->borrowed) {
        const wcut_status status = wcut_trial_eval(search, c, NULL, NULL, there);
        if (status != WCUT_OK || !(there->cost < limit)) return status;
    }
    return wcut_trial_eval(search, c, s->trial_normal, s->trial_gradient, there);
}

wcut_status wcut_descent_improve(wcut_descent *s, wcut_trial *search, wcut_design_curves *c, int steps, double goal,
                                 wcut_reached *reached) {
    const int n = wcut_design_unknowns(c), before = search->runs;
    double damping = 1e-3;
    wcut_status status = wcut_trial_eval(search, c, s->normal, s->gradient, reached);
    if (status == WCUT_NOT_CONVERGED) {
        search->options.max_halvings = wcut_cut_options_default().max_halvings;
        status = wcut_trial_eval(search, c, s->normal, s->gradient, reached);
    }
    if (status == WCUT_OK && search->target->robust) {
        wcut_trial_weigh(search);
        status = wcut_trial_eval(search, c, s->normal, s->gradient, reached);
    }
    for (int k = 0, failed = 0, little = 0; status == WCUT_OK && k < steps && failed < FAILURES && !s->stopped;) {
        if (reached->rms <= goal && reached->uncovered == 0) break;
        wcut_design_curves trial;
        wcut_reached there;
        wcut_bound bound[WCUT_BOUNDS_MAX];
        const int bounds = wcut_trial_bounds(search, c, bound);

        /* a step that heeds the bounds; where there is none, a shorter one */
        if (!find_design_step(s, n, damping, search->longest, bounds, bound)) {
            damping = fmax(10 * damping, 1e-6), failed++;
            continue;
        }
        take_design_step(c, s->step, &trial);
        const wcut_status tried = try_design_curves(s, search, &trial, failed > 0 ? reached->cost : HUGE_VAL, &there);
        if (tried == WCUT_NO_MEMORY) status = tried;
        const bool lower = tried == WCUT_OK && there.cost < reached->cost;
        if (search->borrowed && !lower) {
            /* borrowed derivatives lead no further; where they lead nowhere those of this size may */
            if (k > 0) break;
            search->borrowed = false;
            if (status == WCUT_OK) status = wcut_trial_eval(search, c, s->normal, s->gradient, reached);
            continue;
        }
        if (!lower) {
            damping = fmax(8 * damping, 1e-5), failed++;
            continue;
        }

        /* it is taken */
        little = there.cost > (1 - LITTLE) * reached->cost ? little + 1 : 0;
        *c = trial, *reached = there;
        swap_rows_of(&s->normal, &s->trial_normal);
        swap_rows_of(&s->gradient, &s->trial_gradient);
        damping = fmax(damping / (failed ? 2 : 8), 1e-9); /* no further down where a longer step has just failed */
        k++, failed = 0;
        if (search->target->robust && k < steps) {
            wcut_trial_weigh(search);
            status = wcut_trial_eval(search, c, s->normal, s->gradient, reached);
        }
        if (little == 2) break;
    }
    s->runs += search->runs - before;
    return status;
}
