/* Newton on shape, edge tensions and rate together: banded LU, bordered by the rate, with backtracking. */
#include "cut/solve.h"

#include <stddef.h>
#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"

bool wcut_solver_create(int n, wcut_solver *o) {
    bool whole = wcut_system_create(n, &o->system);
    o->step_by_residual = wcut_alloc((size_t)o->system.size, sizeof(double));
    o->step_by_rate = wcut_alloc((size_t)o->system.size, sizeof(double));
    o->trial_x = wcut_alloc((size_t)n, sizeof(wcut_vec3));
    o->trial_s = wcut_alloc((size_t)n, sizeof(double));
    return whole && o->step_by_residual && o->step_by_rate && o->trial_x && o->trial_s;
}

void wcut_solver_destroy(wcut_solver *o) {
    wcut_system_destroy(&o->system);
    wcut_free(o->step_by_residual);
    wcut_free(o->step_by_rate);
    wcut_free(o->trial_x);
    wcut_free(o->trial_s);
}

/* Merit of the line search: squares of forces over k, lengths over an edge, the condition over k. */
static double merit_of(const wcut_system *y, const wcut_step *step, bool bordered) {
    const double force = 1 / step->tension, length = 1 / step->edge, unit = step->frame ? length : force;
    double sum = bordered ? y->condition * y->condition * unit * unit : 0;
    for (int k = 0; k < y->size; k++) {
        const double r = y->residual[k] * (k % 4 == 0 ? length : force);
        sum += r * r;
    }
    return sum;
}

static double worst_misfit(wcut_misfit m, bool bordered) {
    const double worst = fmax(m.balance, m.strain);
    return bordered ? fmax(worst, m.condition) : worst;
}

/* Newton direction in unknowns and what borders them, ln r or a bow's closing; false where the matrix is singular */
static bool find_direction(wcut_solver *o, bool bordered, double *log_rate_step) {
    wcut_system *y = &o->system;

    /* solve J dx = -r for a fixed rate */
    const size_t bytes = sizeof(double) * (size_t)y->size;
    *log_rate_step = 0;
    if (!wcut_banded_factor(&y->jacobian)) return false;
    for (int k = 0; k < y->size; k++) o->step_by_residual[k] = -y->residual[k];
    wcut_banded_solve(&y->jacobian, o->step_by_residual);
    if (!bordered) return all_finite(y->size, o->step_by_residual);

    /* solve for the border: how the unknowns follow ln r */
    memcpy(o->step_by_rate, y->by_log_rate, bytes);
    wcut_banded_solve(&y->jacobian, o->step_by_rate);

    /* the condition (4) gives the step of ln r (Schur complement) */
    double gap = -y->condition, slope = y->condition_by_log_rate;
    for (int k = 0; k < y->size; k++) {
        gap -= y->border[k] * o->step_by_residual[k];
        slope -= y->border[k] * o->step_by_rate[k];
    }
    if (!(fabs(slope) > 0)) return false;
    *log_rate_step = gap / slope;

    /* the step of the unknowns at that rate */
    for (int k = 0; k < y->size; k++) o->step_by_residual[k] -= *log_rate_step * o->step_by_rate[k];

    return isfinite(*log_rate_step) && all_finite(y->size, o->step_by_residual);
}

/* x + t dx, s + t ds */
static void try_step(wcut_solver *o, double t, const wcut_vec3 *x, const double *s) {
    const int n = o->system.n;
    const double *d = o->step_by_residual;
    for (int e = 0; e < n - 1; e++) o->trial_s[e] = s[e] + t * d[(ptrdiff_t)4 * e];
    o->trial_x[0] = x[0], o->trial_x[n - 1] = x[n - 1];
    for (int i = 1; i < n - 1; i++)
        o->trial_x[i] = vec3_add_scaled(x[i], t, vec3(d[4 * i - 3], d[4 * i - 2], d[4 * i - 1]));
}

/* Take the longest of halving steps that lowers the merit; false where none does. A rate is not let change by more than
   a factor of e at once: (2) is exponential. */
static bool backtrack(wcut_solver *o, const wcut_step *step, bool bordered, double merit, double log_rate_step,
                      wcut_vec3 *x, double *s, double *log_rate) {
    const int n = o->system.n;
    const wcut_bow_frame *frame = step->frame;
    const double closing = frame ? wcut_bow_frame_closing(frame, x[0], x[n - 1]) : 0;
    const double longest = !frame && fabs(log_rate_step) > 1 ? 1 / fabs(log_rate_step) : 1;
    for (double t = longest; t > 1e-4 * longest; t /= 2) {
        const double trial_rate = *log_rate + (frame ? 0 : t * log_rate_step);
        try_step(o, t, x, s);
        for (int end = 0; end < 2 && frame; end++)
            o->trial_x[end == 0 ? 0 : n - 1] = wcut_bow_frame_end(frame, closing + t * log_rate_step, end);
        wcut_system_place_ends(step, o->trial_s, trial_rate, o->trial_x);

        /* as long a step as lowers the merit */
        wcut_system_eval(&o->system, step, o->trial_x, o->trial_s, trial_rate, false);
        if (!(merit_of(&o->system, step, bordered) < (1 - 0.1 * t) * merit)) continue;
        memcpy(x, o->trial_x, sizeof *x * (size_t)n);
        memcpy(s, o->trial_s, sizeof *s * (size_t)(n - 1));
        *log_rate = trial_rate;
        return true;
    }
    return false;
}

/* (4) has absolute values on both sides: it is also met by an arch under compression, which no wire can be */
static bool is_pulled(int n, const double *s, double tolerance, double tension) {
    for (int e = 0; e < n - 1; e++)
        if (s[e] < -tolerance * tension) return false;
    return true;
}

void wcut_solver_run(wcut_solver *o, const wcut_step *step, bool by_tension, double tolerance, int max_iterations,
                     wcut_vec3 *x, double *s, wcut_solution *out) {
    wcut_system *y = &o->system;
    const bool bordered = by_tension || step->frame;
    out->converged = false;
    wcut_system_place_ends(step, s, out->log_rate, x);
    for (out->iterations = 0;; out->iterations++) {
        wcut_system_eval(y, step, x, s, out->log_rate, true);
        out->residual = worst_misfit(wcut_system_misfit(y, step), bordered);
        out->pull = y->pull;
        const bool met = out->residual <= tolerance;
        out->converged = met && is_pulled(y->n, s, 1e-6, step->tension);
        if (met || out->iterations >= max_iterations || !isfinite(out->residual)) return;
        double log_rate_step;
        if (!find_direction(o, bordered, &log_rate_step)) return;
        const double merit = merit_of(y, step, bordered);
        if (!backtrack(o, step, bordered, merit, log_rate_step, x, s, &out->log_rate)) return;
    }
}
