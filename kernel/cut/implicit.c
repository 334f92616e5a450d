/* The implicit integrator: shape, edge tensions and rate at the new station solved together, under the complementarity
   v <= v_max, T <= k; a step that does not converge is halved. */
#include <string.h>

#include "base/fail.h"
#include "base/numbers.h"
#include "cut/active_effects.h"
#include "cut/contact.h"
#include "cut/run.h"
#include "cut/sensitivity.h"

/* the softest face, as a share of the wire's length: deeper than a wire hangs at first contact */
#define SOFTEST_FACE 0.1

/* a wire pulled less than this share of k hangs loose: what the foam does to it does not shape it */
#define SLACK_TENSION 1e-6

/* A wire that touches without tension is given a weight of WEIGHT k (a wire of 0.15 mm and 600 mm weighs 4e-4 of 2 N):
   leaning without load, how it lies would be a matter of chance. The air drags as much on it at v_max: where the weight's
   equilibrium ends (a part of the wire falls over an edge of the block), a drag lets the wire move on at a finite speed,
   and every short step has a solution. Both fade until the least tension along the wire is LOOSE k, not the pull of the
   foam: that may come from one side while the other hangs loose. While the wire is loose so, a part of a step moves it by
   LOOSE_WAY of its length at most, so that the cut converges in stations; parts may become up to 2^SLOWER times shorter
   than others. */
#define LOOSE 1e-2
#define WEIGHT 1e-4
#define SLOWER 4
#define LOOSE_WAY 1e-3

/* times its drag that a loose wire is held with at first where Newton does not converge */
#define STRONGEST_DRAG 100

/* the least tension of an edge [N]: where there is none, a part of the wire hangs loose, whatever pulls the rest */
static double least_tension(int n, const double *s) {
    double least = s[0];
    for (int e = 1; e < n - 1; e++) least = fmin(least, s[e]);
    return least;
}

/* the solver's last evaluation becomes the wire */
static void accept(wcut_cut *cut, const wcut_target *target, double rate, double reach, double pull,
                   wcut_condition condition, double *elapsed) {
    /* shape and tensions of the solution */
    const int n = cut->setup->job->nodes;
    wcut_wire *w = &cut->next;
    memcpy(w->x, cut->hanging_shape, sizeof *w->x * (size_t)n);
    memcpy(w->s, cut->hanging_tension, sizeof *w->s * (size_t)(n - 1));

    /* forces, speeds and engagement at the nodes */
    for (int i = 0; i < n; i++) {
        const wcut_resistance *f = &cut->solver.system.node[i];
        w->force[i] = f->force;
        w->line[i] = f->line;
        w->speed[i] = f->speed;
        w->engaged[i] = f->engaged;
    }

    /* the load pattern is kept for times without load; a mere weight does not become the pattern */
    const bool pulls = !cut->weighted || least_tension(n, w->s) > LOOSE * cut->setup->job->tension;
    if (pulls && wcut_load_sum(n, w->force) > 0) memcpy(w->pattern, w->force, sizeof *w->pattern * (size_t)n);

    /* scalars of the step */
    w->length = target->length;
    w->loaded = true;
    w->required_tension = pull;
    w->condition = condition;
    w->front_speed = reach * rate;
    wcut_cut_remember(cut, target, rate);
    *elapsed += 1 / rate;
}

typedef struct attempt { /* one sub-step being solved */
    wcut_cut *cut;
    const wcut_target *target;
    wcut_foam foam; /* the setup's, its faces as deep as is being tried */
    wcut_step step; /* refers to it */
    double reach;   /* [mm] way of the faster end */
    double weight;  /* [1] share of the pattern that a loose wire has for a weight */
    double pull;    /* [N] tension that the foam's force asks for in the last solution */
    bool brief;     /* a loose wire, fed at v_max: no other ways are tried before the part is halved */
} attempt;

/* Newton from the wire in cut->hanging_shape, at a given depth of the block's faces */
static bool newton(attempt *a, double depth, bool by_tension, double log_rate, wcut_solution *solution) {
    wcut_cut *cut = a->cut;
    const wcut_cut_options *o = &cut->setup->options;
    a->foam.block.depth = depth;
    solution->log_rate = log_rate;
    wcut_solver_run(&cut->solver, &a->step, by_tension, o->tolerance, o->max_iterations, cut->hanging_shape,
                    cut->hanging_tension, solution);
    cut->iterations += solution->iterations;
    return solution->converged;
}

/* while something is changed step by step, the last wire that solved it */
static void keep_guess(attempt *a) {
    const size_t n = (size_t)a->step.n;
    memcpy(a->cut->softer, a->cut->hanging_shape, sizeof *a->cut->softer * n);
    memcpy(a->cut->softer_tension, a->cut->hanging_tension, sizeof *a->cut->softer_tension * (n - 1));
}

static void restore_guess(attempt *a) {
    const size_t n = (size_t)a->step.n;
    memcpy(a->cut->hanging_shape, a->cut->softer, sizeof *a->cut->softer * n);
    memcpy(a->cut->hanging_tension, a->cut->softer_tension, sizeof *a->cut->softer_tension * (n - 1));
}

/* Where the wire comes to lie flat against a face, its load sets in at once over the whole width: too sudden for Newton
   from the wire before. Then the face is made soft at first, over a depth that the wire notices early, and hardened. */
static bool harden(attempt *a, bool by_tension, double log_rate, wcut_solution *solution) {
    const double hard = a->cut->setup->foam.block.depth;
    double depth = SOFTEST_FACE * a->cut->next.length, shrink = 0.5;
    if (a->foam.embedded || !newton(a, depth, by_tension, log_rate, solution)) return false;
    while (depth > hard) {
        const double trial = fmax(depth * shrink, hard), rate = solution->log_rate;
        keep_guess(a);
        if (newton(a, trial, by_tension, rate, solution)) {
            depth = trial;
            continue;
        }
        restore_guess(a);
        solution->log_rate = rate;
        shrink = sqrt(shrink);
        if (shrink > 0.95) return false;
    }
    return true;
}

/* A loose wire may be swept aside quickly: too far from how it was carried along for Newton. A strong drag keeps it
   there; from that solution the drag is taken back step by step. */
static bool release(attempt *a, bool by_tension, double log_rate, wcut_solution *solution) {
    const double depth = a->cut->setup->foam.block.depth, drag = a->step.drag;
    double excess = STRONGEST_DRAG, shrink = 0.1;
    a->step.drag = drag * excess;
    bool solved = newton(a, depth, by_tension, log_rate, solution);
    while (solved && excess > 1) {
        const double trial = fmax(excess * shrink, 1), rate = solution->log_rate;
        keep_guess(a);
        a->step.drag = drag * trial;
        if (newton(a, depth, by_tension, rate, solution)) {
            excess = trial;
            continue;
        }
        restore_guess(a);
        solution->log_rate = rate;
        shrink = sqrt(shrink);
        if (shrink > 0.95) solved = false;
    }
    a->step.drag = drag;
    return solved;
}

/* the wire as it was, carried along with its ends: the better guess the shorter the step */
static void carry(attempt *a) {
    wcut_cut *cut = a->cut;
    const int n = a->step.n;
    const wcut_vec3 *was = cut->was;
    const wcut_vec3 way_a = vec3_sub(a->target->end_a, cut->next.end_a);
    const wcut_vec3 way_b = vec3_sub(a->target->end_b, cut->next.end_b);
    for (int i = 1; i < n - 1; i++)
        cut->hanging_shape[i] = vec3_add(was[i], vec3_mix(way_a, way_b, (double)i / (n - 1)));
    memcpy(cut->hanging_tension, cut->next.s, sizeof *cut->hanging_tension * (size_t)(n - 1));
    if (!a->step.frame) return;

    /* a frame closed as it was */
    const double closing = wcut_bow_frame_closing(a->step.frame, was[0], was[n - 1]);
    cut->hanging_shape[0] = wcut_bow_frame_end(a->step.frame, closing, 0);
    cut->hanging_shape[n - 1] = wcut_bow_frame_end(a->step.frame, closing, 1);
}

/* the wire hung in its last load; a loose one is pulled by its weight only */
static bool hang(attempt *a) {
    wcut_cut *cut = a->cut;
    if (!wcut_cut_hang(cut, a->target, cut->next.pattern)) return false;
    if (a->weight > 0)
        for (int e = 0; e < a->step.n - 1; e++) cut->hanging_tension[e] *= a->weight;
    return true;
}

/* Solve with the rate as an unknown, or given: from the wire hung in its last load, from the wire carried along, from a
   softened block. A loose wire that touches is carried along first: its shape is not that of its pattern. */
static bool solve_attempt(attempt *a, bool by_tension, double speed, wcut_solution *solution) {
    wcut_cut *cut = a->cut;
    const double log_rate = log(speed / a->reach), depth = cut->setup->foam.block.depth;
    const bool carry_first = cut->next.loaded && (a->weight > 0 || cut->taut > 0);
    bool solved = false;
    for (int turn = 0; turn < 2 && !solved; turn++) {
        if ((turn == 0) == carry_first) {
            if (!cut->next.loaded) continue;
            carry(a);
        } else if (!hang(a)) {
            continue;
        }
        solved = newton(a, depth, by_tension, log_rate, solution);
    }
    if (!solved && a->step.drag > 0 && cut->next.loaded) {
        carry(a);
        solved = release(a, by_tension, log_rate, solution);
    }
    if (!solved && !a->brief && hang(a)) solved = harden(a, by_tension, log_rate, solution);
    if (solved) cut->residual = fmax(cut->residual, solution->residual);
    a->pull = solution->pull;
    return solved;
}

/* v = limit: a solution where the tension is on the right side of k */
static bool solve_at_limit(attempt *a, double limit, bool upper, double *speed) {
    wcut_solution out = {0};
    const double k = a->cut->setup->job->tension;
    if (!solve_attempt(a, false, limit, &out)) return false;
    *speed = limit;
    return upper ? out.pull <= k * (1 + 1e-12) : out.pull >= k * (1 - 1e-12);
}

/* T = k: a solution where the speed is inside its limits */
static bool solve_at_tension(attempt *a, double guess, double *speed) {
    const wcut_job *job = a->cut->setup->job;
    wcut_solution out = {0};
    if (!solve_attempt(a, true, guess, &out)) return false;
    *speed = a->reach * exp(out.log_rate);
    return *speed <= job->speed_max && *speed >= job->speed_min;
}

/* T = k once more, from the wire at v_max that is pulled by more than k: slower step by step, until it is not. Where the
   wire lies along a face most of it hardly moves, and (2) has next to no slope there: too little for Newton in the rate. */
static bool slow_down(attempt *a, double *speed) {
    const wcut_job *job = a->cut->setup->job;
    const double k = job->tension, depth = a->cut->setup->foam.block.depth;
    const double slowest = log(job->speed_min / a->reach);
    wcut_solution out = {0};
    if (!solve_attempt(a, false, job->speed_max, &out) || out.pull <= k) return false;

    /* longer steps while they are solved, shorter ones where they are not */
    double log_rate = out.log_rate, pull = out.pull, step = 0.02;
    while (pull > k && log_rate > slowest) {
        keep_guess(a);
        const double trial = fmax(log_rate - step, slowest);
        if (newton(a, depth, false, trial, &out)) {
            log_rate = trial;
            pull = out.pull;
            step *= 2;
            continue;
        }
        restore_guess(a);
        step /= 4;
        if (step < 1e-4) return false;
    }

    /* close to T = k: with the rate as an unknown */
    if (!newton(a, depth, true, log_rate, &out)) return false;
    a->cut->residual = fmax(a->cut->residual, out.residual);
    a->pull = out.pull;
    *speed = a->reach * exp(out.log_rate);
    return *speed <= job->speed_max && *speed >= job->speed_min;
}

/* One side of the complementarity after the other, the one that held last first. */
static bool solve_complementary(attempt *a, double *speed, wcut_condition *condition) {
    const wcut_job *job = a->cut->setup->job;
    const wcut_wire *last = &a->cut->next;
    const double guess = clamp(last->front_speed, job->speed_min, job->speed_max);
    const bool max_first = !last->loaded || last->condition == WCUT_CONDITION_SPEED_MAX;
    *condition = WCUT_CONDITION_SPEED_MAX;
    if (max_first && solve_at_limit(a, job->speed_max, true, speed)) return true;
    if (a->brief) return false;
    *condition = WCUT_CONDITION_TENSION;
    if (solve_at_tension(a, guess, speed)) return true;
    *condition = WCUT_CONDITION_SPEED_MAX;
    if (!max_first && solve_at_limit(a, job->speed_max, true, speed)) return true;
    *condition = WCUT_CONDITION_TENSION;
    if (slow_down(a, speed)) return true;
    *condition = WCUT_CONDITION_SPEED_MIN;
    return solve_at_limit(a, job->speed_min, false, speed);
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

/* what a loose wire weighs, in the pattern that shaped it last; NULL where it is not loose */
static const wcut_vec3 *find_dead_load(wcut_cut *cut, double *weight) {
    const int n = cut->setup->job->nodes;
    const wcut_wire *w = &cut->next;

    /* one with a weight of its own needs none for want of another, and its shape is that of the foam's force */
    *weight = 0;
    if (cut->setup->weight > 0) {
        wcut_cut_weigh(cut, cut->dead_load);
        return cut->dead_load;
    }

    /* else a share of what shaped it last, which fades */
    const double k = cut->setup->job->tension;
    const double load = wcut_load_sum(n, w->pattern);
    const double fade = w->loaded ? clamp(1 - least_tension(n, w->s) / (LOOSE * k), 0, 1) : 1;
    *weight = cut->weighted && load > 0 ? fade * WEIGHT * k / load : 0;
    if (!(*weight > 0)) return NULL;
    for (int i = 0; i < n; i++) cut->dead_load[i] = vec3_scale(*weight, w->pattern[i]);
    return cut->dead_load;
}

/* a wire whose mounts stand still in the given time cuts nothing and is pulled by nothing */
static void stand_still(wcut_cut *cut, const wcut_target *target, double *elapsed) {
    const int n = cut->setup->job->nodes;
    wcut_wire *w = &cut->next;
    for (int i = 0; i < n; i++) {
        w->force[i] = vec3(0, 0, 0);
        w->line[i] = w->speed[i] = 0;
    }
    for (int e = 0; e < n - 1 && cut->setup->weight == 0; e++) w->s[e] = cut->taut;
    memcpy(w->engaged, cut->now.engaged, sizeof *w->engaged * (size_t)n);
    w->required_tension = 0;
    w->condition = WCUT_CONDITION_TIME;
    wcut_cut_remember(cut, target, 1 / target->duration);
    *elapsed += target->duration;
}

/* Where the material of a plan's nodes comes from: the wire slides through its ends by half the change of its length at
   each, and before them it is straight. */
static void find_material(const wcut_cut *cut, const wcut_target *target) {
    const wcut_wire *w = &cut->next;
    const int n = cut->setup->job->nodes;
    const double change = target->length - w->length, edge = w->length / (n - 1);
    for (int i = 0; i < n; i++) {
        const double way = (i * target->length / (n - 1) - change / 2) / edge;
        const int e = (int)clamp(floor(way), 0, n - 2);
        cut->was[i] = vec3_mix(w->x[e], w->x[e + 1], way - e);
    }
}

/* brief: see attempt */
static bool try_substep(wcut_cut *cut, const wcut_target *target, bool brief, double *elapsed) {
    const wcut_setup *setup = cut->setup;
    const int n = setup->job->nodes;
    wcut_wire *w = &cut->next;

    /* where the material comes from: the shape before, or in a plan the wire slid through its ends */
    memcpy(cut->was, w->x, sizeof *w->x * (size_t)n);
    if (setup->foam.embedded && target->length != w->length) find_material(cut, target);
    const double reach = fmax(vec3_distance(target->end_a, w->end_a), vec3_distance(target->end_b, w->end_b));
    if (reach == 0) {
        stand_still(cut, target, elapsed);
        return true;
    }

    /* what touches, and whether it can pull the wire taut */
    const wcut_contact_state load = wcut_contact_find(cut, target);
    if (load == WCUT_CONTACT_NO_SHAPE) return false;
    if (load == WCUT_CONTACT_FREE) return feed_free(cut, target, reach, elapsed);

    /* Newton: at the given speed, or under the complementarity of speed and tension */
    attempt a = {.cut = cut, .target = target, .foam = setup->foam, .reach = reach, .brief = brief};
    a.step = (wcut_step){.foam = &a.foam,
                         .heat = target->heat,
                         .tension = setup->job->tension,
                         .edge = target->length / (n - 1),
                         .n = n,
                         .was = cut->was,
                         .dead_load = find_dead_load(cut, &a.weight),
                         .heavy = setup->weight > 0};
    if (a.step.dead_load) a.step.drag = a.weight * wcut_load_sum(n, w->pattern) / ((n - 2) * setup->job->speed_max);

    /* effects change the ends, the lengths and the law */
    wcut_extension extension;
    wcut_extension_apply(cut, target, &extension, &a.foam, &a.step);

    /* under a given duration the speed is known; else it is an unknown beside the tension */
    double speed = target->duration > 0 ? reach / target->duration : 0;
    wcut_condition condition = WCUT_CONDITION_TIME;
    wcut_solution out = {0};
    const bool solved =
        target->duration > 0 ? solve_attempt(&a, false, speed, &out) : solve_complementary(&a, &speed, &condition);

    /* a solution counts if the wire is taut or carries a weight */
    if (solved && (cut->weighted || a.pull >= SLACK_TENSION * setup->job->tension)) {
        if (cut->sensitivity) wcut_sensitivity_step(cut, &a.step, target, condition);
        accept(cut, target, speed / reach, reach, a.pull, condition, elapsed);
        return true;
    }

    /* without a solution only a loose wire may go on */
    if (!solved && !(load == WCUT_CONTACT_SLACK && hangs_loose(cut))) return false;

    /* it touches and has no tension */
    const bool may_weigh = cut->contact_rule == WCUT_CONTACT_BY_WEIGHT && setup->weight == 0;
    if (may_weigh && !cut->weighted && target->duration == 0) {
        cut->weighted = true;
        memcpy(w->pattern, cut->kept, sizeof *w->pattern * (size_t)n);
        return false;
    }

    return wcut_cut_hang(cut, target, w->pattern) && feed_free(cut, target, reach, elapsed);
}

/* how far a wire sags when it is a little longer than the distance of its ends [mm] (a flat parabola) */
static double sag_of(wcut_vec3 a, wcut_vec3 b, double length) {
    const double chord = vec3_distance(a, b);
    return sqrt(0.375 * chord * fmax(length - chord, 0));
}

/* by how much the mounts' mean motion turns at the station that the run is at [deg]; 0 where it has not moved yet */
static double turn_of_path(const wcut_cut *cut, const wcut_target *target) {
    const wcut_setup *setup = cut->setup;
    const int j = cut->index;
    if (j < 1 || j >= setup->stations || target->duration > 0) return 0;
    const wcut_vec3 before =
        vec3_add(vec3_sub(setup->end_a[j], setup->end_a[j - 1]), vec3_sub(setup->end_b[j], setup->end_b[j - 1]));
    const wcut_vec3 after =
        vec3_add(vec3_sub(target->end_a, setup->end_a[j]), vec3_sub(target->end_b, setup->end_b[j]));
    const double size = vec3_length(before) * vec3_length(after);
    return size > 0 ? acos(clamp(vec3_dot(before, after) / size, -1, 1)) * 180 / WCUT_PI : 0;
}

/* why no sub-step could be solved, as far as can be told */
static wcut_status explain_no_step(const wcut_cut *cut, const wcut_target *target, wcut_error *error) {
    const wcut_cut_options *o = &cut->setup->options;
    const wcut_vec3 *from = cut->now.x;
    const int n = cut->setup->job->nodes;

    /* a path that turns back would cut in its own slot */
    const double turn = turn_of_path(cut, target);
    if (cut->now.loaded && turn > 90)
        return wcut_fail(
            error, WCUT_NOT_CONVERGED,
            "the path turns back by %.0f deg at station %d: the wire would run in the slot that it has cut, "
            "which the model does not know; expected turns of 90 deg at most",
            turn, cut->index);

    /* a straight wire has no sag to carry a load with */
    const double slack = target->length - vec3_distance(target->end_a, target->end_b);
    if (slack <= 1e-7 * target->length)
        return wcut_fail(
            error, WCUT_NOT_CONVERGED,
            "the wire is straight (%.3g mm longer than the distance of its ends): under load it would need "
            "endless tension; expected a longer wire or mounts nearer to each other (in a design, a larger "
            "extra_length_mm)",
            slack);

    /* sag that grows faster than the feed would push the middle back */
    const double feed = fmax(vec3_distance(target->end_a, from[0]), vec3_distance(target->end_b, from[n - 1]));
    const double sag =
        sag_of(target->end_a, target->end_b, target->length) - sag_of(from[0], from[n - 1], cut->now.length);
    if (cut->now.loaded && sag > feed)
        return wcut_fail(
            error, WCUT_NOT_CONVERGED,
            "the wire gains %.3g mm of sag while its ends move %.3g mm: its middle would have to move back; "
            "expected a wire that gains length more slowly (in a design, a design.extra_length_mm that grows more "
            "slowly "
            "or begins with more than 0)",
            sag, feed);

    /* no cause found: say how far the steps were halved */
    return wcut_fail(
        error, WCUT_NOT_CONVERGED,
        "no equilibrium of wire and foam found, with the step cut into %.0f parts; expected a residual below %g",
        ldexp(1, o->max_halvings), o->tolerance);
}

/* The largest part of a step, a power of 1/2, that a wire with a weight is tried with while it hangs loose: how often a
   part is halved then is no matter of rounding. */
static double part_of_step(const wcut_cut *cut, double reach) {
    const wcut_wire *w = &cut->next;
    const bool loose = !w->loaded || least_tension(cut->setup->job->nodes, w->s) < LOOSE * cut->setup->job->tension;
    if (cut->contact_rule != WCUT_CONTACT_BY_WEIGHT || !cut->weighted || !loose) return 1;
    double part = 1;
    while (part * reach > LOOSE_WAY * w->length && part > 1.0 / 1024) part /= 2;
    return part;
}

wcut_status wcut_implicit_advance(wcut_cut *cut, const wcut_target *target, double *elapsed, wcut_error *error) {
    const wcut_vec3 from_a = cut->next.end_a, from_b = cut->next.end_b;
    const double from_length = cut->next.length;
    const double reach = fmax(vec3_distance(target->end_a, from_a), vec3_distance(target->end_b, from_b));
    double done = 0, size = 1, longest = 1;

    while (done < 1) {
        /* part of the step: mounts and length evenly from where it began */
        size = fmin(size, fmin(longest * part_of_step(cut, reach), 1 - done));
        const double to = done + size;
        const wcut_target part = {.end_a = to < 1 ? vec3_mix(from_a, target->end_a, to) : target->end_a,
                                  .end_b = to < 1 ? vec3_mix(from_b, target->end_b, to) : target->end_b,
                                  .length = to < 1 ? from_length + to * (target->length - from_length) : target->length,
                                  .duration = size * target->duration,
                                  .heat = target->heat};
        const bool weighted = cut->weighted;
        cut->part = to;
        const double limit = part_of_step(cut, reach);
        if (try_substep(cut, &part, limit < 1 && size > limit / 64, elapsed)) {
            cut->substeps++;
            done = to;
            size = fmin(2 * size, 1 - done);
            continue;
        }

        /* once more: with a weight that it did not have, or half as far */
        if (cut->weighted != weighted) continue;
        size /= 2;
        if (size >= ldexp(1, -(cut->setup->options.max_halvings + (cut->weighted ? SLOWER : 0)))) continue;

        /* a loose wire's branch of equilibria may end: the next one is further off than short parts reach */
        if (longest * part_of_step(cut, reach) >= 1) return explain_no_step(cut, target, error);
        longest *= 4;
        size = 1;
    }

    return WCUT_OK;
}
