/* The implicit integrator: shape, edge tensions and rate at the new station solved together, under the complementarity
   v <= v_max, T <= k; a step that does not converge is halved. */
#include <string.h>

#include "base/fail.h"
#include "base/numbers.h"
#include "cut/run.h"
#include "wire/equilibrium.h"

/* the softest face, as a share of the wire's length: deeper than a wire hangs at first contact */
#define SOFTEST_FACE 0.1

/* a wire pulled less than this share of k hangs loose: what the foam does to it does not shape it */
#define SLACK_TENSION 1e-6

bool wcut_cut_hang(wcut_cut *cut, const wcut_target *target, const wcut_vec3 *load) {
    const int n = cut->setup->job->nodes;
    const wcut_equilibrium_options options = {.tolerance = 1e-9, .max_iterations = 100};
    const double chord = vec3_distance(target->end_a, target->end_b);
    for (int e = 0; e < n - 1; e++) cut->edge[e] = target->length / (n - 1);
    cut->hung[0] = target->end_a, cut->hung[n - 1] = target->end_b;
    if (target->length <= chord * (1 + 1e-12)) {
        for (int i = 1; i < n - 1; i++) cut->hung[i] = vec3_mix(target->end_a, target->end_b, (double)i / (n - 1));
        for (int e = 0; e < n - 1; e++) cut->hung_s[e] = 0;
        return true;
    }
    if (wcut_equilibrium_shape(n, load, cut->edge, &options, cut->hung, cut->hung_s, NULL) != WCUT_OK) return false;
    for (int e = 0; e < n - 1; e++) cut->hung_s[e] *= cut->edge[e];
    return true;
}

bool wcut_cut_touches(const wcut_cut *cut, const wcut_vec3 *x, double edge) {
    const wcut_foam *foam = &cut->setup->foam;
    const int n = cut->setup->job->nodes;
    if (foam->embedded) return true;
    wcut_vec3 unused[2];
    for (int e = 0; e < n - 1; e++)
        if (wcut_block_engagement(&foam->block, x[e], x[e + 1], unused, unused + 1) * edge > 0) return true;
    return false;
}

void wcut_cut_feed_free(wcut_cut *cut, const wcut_target *target, double reach, double *elapsed) {
    const wcut_job *job = cut->setup->job;
    const int n = job->nodes;
    wcut_wire *w = &cut->next;
    const double duration = target->duration > 0 ? target->duration : reach / job->speed_max;
    for (int i = 0; i < n; i++) {
        w->x[i] = cut->hung[i];
        w->force[i] = vec3(0, 0, 0);
        w->line[i] = w->engaged[i] = 0;
        w->speed[i] = vec3_distance(cut->hung[i], cut->was[i]) / duration;
    }
    for (int e = 0; e < n - 1; e++) w->s[e] = 0;
    w->length = target->length;
    w->loaded = false;
    w->condition = target->duration > 0 ? WCUT_BY_TIME : WCUT_BY_SPEED_MAX;
    w->front_speed = reach / duration;
    *elapsed += duration;
}

/* the solver's last evaluation becomes the wire */
static void accept(wcut_cut *cut, const wcut_target *target, double rate, double reach, wcut_condition condition,
                   double *elapsed) {
    const int n = cut->setup->job->nodes;
    wcut_wire *w = &cut->next;
    memcpy(w->x, cut->hung, sizeof *w->x * (size_t)n);
    memcpy(w->s, cut->hung_s, sizeof *w->s * (size_t)(n - 1));
    double load = 0;
    for (int i = 0; i < n; i++) {
        const wcut_resistance *f = &cut->solver.system.node[i];
        w->force[i] = f->force;
        w->line[i] = f->line;
        w->speed[i] = f->speed;
        w->engaged[i] = f->engaged;
        if (i > 0 && i < n - 1) load += vec3_length(f->force);
    }
    if (load > 0) memcpy(w->pattern, w->force, sizeof *w->pattern * (size_t)n);
    w->length = target->length;
    w->loaded = true;
    w->condition = condition;
    w->front_speed = reach * rate;
    *elapsed += 1 / rate;
}

typedef struct attempt { /* one sub-step being solved */
    wcut_cut *cut;
    const wcut_target *target;
    wcut_foam foam; /* the setup's, its faces as deep as is being tried */
    wcut_step step; /* refers to it */
    double reach;   /* [mm] way of the faster end */
    double pull;    /* [N] tension that the foam's force asks for in the last solution */
} attempt;

/* Newton from the wire in cut->hung, at a given depth of the block's faces */
static bool newton(attempt *a, double depth, bool by_tension, double log_rate, wcut_solution *solution) {
    wcut_cut *cut = a->cut;
    const wcut_cut_options *o = &cut->setup->options;
    a->foam.block.depth = depth;
    solution->log_rate = log_rate;
    wcut_solver_run(&cut->solver, &a->step, by_tension, o->tolerance, o->max_iterations, cut->hung, cut->hung_s,
                    solution);
    cut->iterations += solution->iterations;
    return solution->converged;
}

/* Where the wire comes to lie flat against a face, its load sets in at once over the whole width: too sudden for Newton
   from the wire before. Then the face is made soft at first, over a depth that the wire notices early, and hardened. */
static bool harden(attempt *a, bool by_tension, double log_rate, wcut_solution *solution) {
    wcut_cut *cut = a->cut;
    const double hard = cut->setup->foam.block.depth;
    double depth = SOFTEST_FACE * cut->next.length, shrink = 0.5;
    if (cut->setup->foam.embedded) return false;
    if (!newton(a, depth, by_tension, log_rate, solution)) return false;
    while (depth > hard) {
        const double trial = fmax(depth * shrink, hard);
        memcpy(cut->softer, cut->hung, sizeof *cut->softer * (size_t)a->step.n);
        memcpy(cut->softer_s, cut->hung_s, sizeof *cut->softer_s * (size_t)(a->step.n - 1));
        const double rate = solution->log_rate;
        if (newton(a, trial, by_tension, rate, solution)) {
            depth = trial;
            continue;
        }
        memcpy(cut->hung, cut->softer, sizeof *cut->softer * (size_t)a->step.n);
        memcpy(cut->hung_s, cut->softer_s, sizeof *cut->softer_s * (size_t)(a->step.n - 1));
        solution->log_rate = rate;
        shrink = sqrt(shrink);
        if (shrink > 0.95) return false;
    }
    return true;
}

/* the wire as it was, carried along with its ends: the better guess the shorter the step */
static void carry(attempt *a) {
    wcut_cut *cut = a->cut;
    const int n = a->step.n;
    const wcut_vec3 *was = cut->was;
    const wcut_vec3 way_a = vec3_sub(a->target->end_a, was[0]), way_b = vec3_sub(a->target->end_b, was[n - 1]);
    for (int i = 1; i < n - 1; i++) cut->hung[i] = vec3_add(was[i], vec3_mix(way_a, way_b, (double)i / (n - 1)));
    memcpy(cut->hung_s, cut->next.s, sizeof *cut->hung_s * (size_t)(n - 1));
}

/* Solve with the rate as an unknown, or given: from the wire hung in its last load, from the wire carried along, from a
   softened block. */
static bool solve(attempt *a, bool by_tension, double speed, wcut_solution *solution) {
    wcut_cut *cut = a->cut;
    const double log_rate = log(speed / a->reach), depth = cut->setup->foam.block.depth;
    bool solved = newton(a, depth, by_tension, log_rate, solution);
    if (!solved && cut->next.loaded) {
        carry(a);
        solved = newton(a, depth, by_tension, log_rate, solution);
    }
    if (!solved) {
        if (!wcut_cut_hang(cut, a->target, cut->next.pattern)) return false;
        solved = harden(a, by_tension, log_rate, solution);
    }
    if (solved) cut->residual = fmax(cut->residual, solution->residual);
    a->pull = solution->pull;
    return solved;
}

/* v = limit: a solution where the tension is on the right side of k */
static bool solve_at_limit(attempt *a, double limit, bool upper, double *speed) {
    wcut_solution out;
    const double k = a->cut->setup->job->tension;
    if (!wcut_cut_hang(a->cut, a->target, a->cut->next.pattern) || !solve(a, false, limit, &out)) return false;
    *speed = limit;
    return upper ? out.pull <= k * (1 + 1e-12) : out.pull >= k * (1 - 1e-12);
}

/* T = k: a solution where the speed is inside its limits */
static bool solve_at_tension(attempt *a, double guess, double *speed) {
    const wcut_job *job = a->cut->setup->job;
    wcut_solution out;
    if (!wcut_cut_hang(a->cut, a->target, a->cut->next.pattern) || !solve(a, true, guess, &out)) return false;
    *speed = a->reach * exp(out.log_rate);
    return *speed <= job->speed_max && *speed >= job->speed_min;
}

/* One side of the complementarity after the other, the one that held last first. */
static bool solve_complementary(attempt *a, double *speed, wcut_condition *condition) {
    const wcut_job *job = a->cut->setup->job;
    const wcut_wire *last = &a->cut->next;
    const double guess = clamp(last->front_speed, job->speed_min, job->speed_max);
    const bool max_first = !last->loaded || last->condition == WCUT_BY_SPEED_MAX;
    *condition = WCUT_BY_SPEED_MAX;
    if (max_first && solve_at_limit(a, job->speed_max, true, speed)) return true;
    *condition = WCUT_BY_TENSION;
    if (solve_at_tension(a, guess, speed)) return true;
    *condition = WCUT_BY_SPEED_MAX;
    if (!max_first && solve_at_limit(a, job->speed_max, true, speed)) return true;
    *condition = WCUT_BY_SPEED_MIN;
    return solve_at_limit(a, job->speed_min, false, speed);
}

/* The load of the foam on whatever touches, at v_max against the motion, into cut->contact; false where nothing does.
 */
static bool find_contact(wcut_cut *cut, const wcut_target *target) {
    const wcut_setup *setup = cut->setup;
    const int n = setup->job->nodes;
    const wcut_wire *w = &cut->next;
    const double edge = target->length / (n - 1);
    const wcut_vec3 move = vec3_add(vec3_sub(target->end_a, w->x[0]), vec3_sub(target->end_b, w->x[n - 1]));
    const double force = wcut_force_law_eval(&setup->foam.law, target->heat, setup->job->speed_max);
    double load = 0;
    for (int i = 0; i < n; i++) {
        wcut_resistance f;
        wcut_resistance_eval(&setup->foam, target->heat, edge, 1, n, cut->hung, cut->was, i, false, &f);
        cut->contact[i] = vec3_scale(-force * f.engaged * edge, vec3_unit(move));
        if (i > 0 && i < n - 1) load += vec3_length(cut->contact[i]);
    }
    return load > 0;
}

static double sum_of(int n, const wcut_vec3 *load) {
    double sum = 0;
    for (int i = 1; i < n - 1; i++) sum += vec3_length(load[i]);
    return sum;
}

/* hang the wire under its old pattern and a share of the contact, both of the contact's size; whether it still touches
 */
static bool touches_leaning(wcut_cut *cut, const wcut_target *target, double share) {
    const int n = cut->setup->job->nodes;
    const double scale = (1 - share) * sum_of(n, cut->contact) / sum_of(n, cut->kept);
    for (int i = 0; i < n; i++)
        cut->next.pattern[i] = vec3_add_scaled(vec3_scale(share, cut->contact[i]), scale, cut->kept[i]);
    return wcut_cut_hang(cut, target, cut->next.pattern) && wcut_cut_touches(cut, cut->hung, target->length);
}

/* A wire that has lost its load in parts goes slack there and has no one shape under the rest; an even load of a
   hundredth of it, against the motion, gives it one. */
static bool hang_slack(wcut_cut *cut, const wcut_target *target) {
    const int n = cut->setup->job->nodes;
    wcut_wire *w = &cut->next;
    const wcut_vec3 move = vec3_add(vec3_sub(target->end_a, w->x[0]), vec3_sub(target->end_b, w->x[n - 1]));
    double load = 0;
    for (int i = 0; i < n; i++) load += vec3_length(w->pattern[i]);
    for (int i = 0; i < n; i++) w->pattern[i] = vec3_add_scaled(w->pattern[i], -0.01 * load / n, vec3_unit(move));
    return wcut_cut_hang(cut, target, w->pattern);
}

typedef enum carriage { NO_SHAPE, FREE, SLACK, LOADED } carriage;

/* A hanging wire that comes to touch the foam has slack: what touches leans on the face, without force to speak of, and
   holds back until the rest has been pulled straight. Only a wire that touches even when it hangs on nothing but its
   contact is loaded by it (and that contact is the load to begin with); before, it leans just so far that it does not
   enter. */
static carriage lean(wcut_cut *cut, const wcut_target *target) {
    const double most = 0.999; /* a wire on its contact alone may have parts without any load, hence without a shape */
    if (!find_contact(cut, target)) return FREE;
    if (touches_leaning(cut, target, most)) return SLACK;
    double low = 0, high = most;
    for (int i = 0; i < 20; i++) {
        const double middle = (low + high) / 2;
        if (touches_leaning(cut, target, middle))
            low = middle;
        else
            high = middle;
    }
    touches_leaning(cut, target, high);
    return FREE;
}

/* Whether the foam loads the wire at the target; cut->hung and the pattern are the guess to solve from, or the shape if
   the wire is free. SLACK: it may, but the wire hung loose so far. */
static carriage find_carriage(wcut_cut *cut, const wcut_target *target) {
    bool slack = !cut->next.loaded;
    if (!wcut_cut_hang(cut, target, cut->next.pattern)) {
        if (!hang_slack(cut, target)) return NO_SHAPE;
        slack = true;
    }
    memcpy(cut->kept, cut->next.pattern, sizeof *cut->kept * (size_t)cut->setup->job->nodes);
    if (!wcut_cut_touches(cut, cut->hung, target->length)) return FREE;
    return slack && !cut->setup->foam.embedded ? lean(cut, target) : LOADED;
}

/* feed the wire without load as it hangs, keeping the pattern it had before the foam was tried on it */
static bool feed_free(wcut_cut *cut, const wcut_target *target, double reach, double *elapsed) {
    wcut_cut_feed_free(cut, target, reach, elapsed);
    memcpy(cut->next.pattern, cut->kept, sizeof *cut->kept * (size_t)cut->setup->job->nodes);
    return true;
}

/* a slack wire without an equilibrium under load is loose still; one that lies in the foam by half its span is not */
static bool hangs_loose(const wcut_cut *cut) {
    const wcut_setup *setup = cut->setup;
    double inside = 0;
    for (int i = 0; i < setup->job->nodes; i++) {
        wcut_vec3 unused[2];
        const wcut_vec3 x = cut->was[i];
        inside += wcut_block_engagement(&setup->foam.block, x, x, unused, unused + 1);
    }
    return inside * cut->next.length / setup->job->nodes < setup->job->block_size.x / 2;
}

static bool try_substep(wcut_cut *cut, const wcut_target *target, double *elapsed) {
    const wcut_setup *setup = cut->setup;
    const int n = setup->job->nodes;
    wcut_wire *w = &cut->next;
    memcpy(cut->was, w->x, sizeof *w->x * (size_t)n);
    const double reach = fmax(vec3_distance(target->end_a, w->x[0]), vec3_distance(target->end_b, w->x[n - 1]));
    const carriage load = find_carriage(cut, target);
    if (load == NO_SHAPE) return false;
    if (load == FREE) return feed_free(cut, target, reach, elapsed);
    attempt a = {.cut = cut, .target = target, .foam = setup->foam, .reach = reach};
    a.step = (wcut_step){.foam = &a.foam,
                         .heat = target->heat,
                         .tension = setup->job->tension,
                         .edge = target->length / (n - 1),
                         .n = n,
                         .was = cut->was};
    double speed = target->duration > 0 ? reach / target->duration : 0;
    wcut_condition condition = WCUT_BY_TIME;
    wcut_solution out;
    const bool solved =
        target->duration > 0 ? solve(&a, false, speed, &out) : solve_complementary(&a, &speed, &condition);
    if (solved && a.pull >= SLACK_TENSION * setup->job->tension) {
        accept(cut, target, speed / reach, reach, condition, elapsed);
        return true;
    }
    if (!solved && !(load == SLACK && hangs_loose(cut))) return false;
    return wcut_cut_hang(cut, target, w->pattern) && feed_free(cut, target, reach, elapsed);
}

wcut_status wcut_implicit_advance(wcut_cut *cut, const wcut_target *target, double *elapsed, wcut_error *error) {
    const int n = cut->setup->job->nodes;
    const wcut_vec3 from_a = cut->next.x[0], from_b = cut->next.x[n - 1];
    const double from_length = cut->next.length;
    const double smallest = ldexp(1, -cut->setup->options.max_halvings);
    double done = 0, size = 1;
    while (done < 1) {
        const double to = done + size;
        const wcut_target part = {.end_a = to < 1 ? vec3_mix(from_a, target->end_a, to) : target->end_a,
                                  .end_b = to < 1 ? vec3_mix(from_b, target->end_b, to) : target->end_b,
                                  .length = to < 1 ? from_length + to * (target->length - from_length) : target->length,
                                  .duration = size * target->duration,
                                  .heat = target->heat};
        if (try_substep(cut, &part, elapsed)) {
            cut->substeps++;
            done = to;
            size = fmin(2 * size, 1 - done);
            continue;
        }
        size /= 2;
        if (size < smallest)
            return wcut_fail(error, WCUT_NOT_CONVERGED,
                             "no equilibrium of wire and foam found, with the step cut into %.0f parts; expected a "
                             "residual below %g",
                             1 / smallest, cut->setup->options.tolerance);
    }
    return WCUT_OK;
}
