/* The paper's integrator as printed: accumulated forces by Euler predictor and trapezoidal corrector, the rate by the
   secant method (Rust et al. 2016, 9-11). Each step keeps half of what was accumulated before, so its memory is two
   steps long, not a time: right at 32 mm a step, wrong below 11 mm. Kept for comparison. */
#include <string.h>

#include "base/fail.h"
#include "base/numbers.h"
#include "cut/active_effects.h"
#include "cut/contact.h"
#include "cut/run.h"

typedef struct moment { /* the wire at the new station, as far as it is known */
    wcut_cut *cut;
    const wcut_target *target;
    double reach;        /* [mm] way of the faster end */
    wcut_vec3 *total;    /* n: accumulated force [N s] that shapes the wire */
    wcut_resistance *at; /* n: forces at a rate */
    double pull;         /* [N] tension that they ask for */
} moment;

/* (3) on the hanging wire at a speed of the faster end; the left side of (11) over |t_0 + t_{n-1}|, less k */
static double excess_at(moment *m, double speed) {
    wcut_cut *cut = m->cut;
    const wcut_step step = {.foam = &cut->setup->foam,
                            .heat = m->target->heat,
                            .tension = cut->setup->job->tension,
                            .edge = m->target->length / (cut->setup->job->nodes - 1),
                            .n = cut->setup->job->nodes,
                            .was = cut->was};
    wcut_system_eval(&cut->solver.system, &step, cut->hanging_shape, cut->hanging_tension, log(speed / m->reach),
                     false);
    m->pull = cut->solver.system.pull;
    return m->pull - step.tension;
}

/* (11) by the secant method, kept inside a bracket (Illinois); the speed where it holds, or a limit */
static double find_speed(moment *m, wcut_condition *condition, int *rounds) {
    const wcut_job *job = m->cut->setup->job;

    /* the excess of the foam's force over the tension at both limits of the speed */
    double low = job->speed_min, high = job->speed_max;
    double at_high = excess_at(m, high), at_low = at_high > 0 ? excess_at(m, low) : 0;
    *condition = at_high <= 0 ? WCUT_CONDITION_SPEED_MAX : WCUT_CONDITION_SPEED_MIN;
    if (at_high <= 0) return excess_at(m, high), high;
    if (at_low >= 0) return low;

    /* between them the secant method, which halves a value that has stayed too long (Illinois) */
    *condition = WCUT_CONDITION_TENSION;
    double speed = high;
    int side = 0;
    for (*rounds = 0; *rounds < 200; ++*rounds) {
        speed = (low * at_high - high * at_low) / (at_high - at_low);
        const double excess = excess_at(m, speed);
        if (fabs(excess) <= 1e-12 * job->tension || high - low <= 1e-15 * high) break;
        if (excess > 0) {
            high = speed, at_high = excess;
            if (side > 0) at_low /= 2;
            side = 1;
        } else {
            low = speed, at_low = excess;
            if (side < 0) at_high /= 2;
            side = -1;
        }
    }

    return speed;
}

/* accumulated + h (share_now F_j + share_next F at the hanging wire) */
static void accumulate(moment *m, double h, double share_now, double share_next) {
    const wcut_wire *w = &m->cut->next;
    for (int i = 0; i < m->cut->setup->job->nodes; i++) {
        m->total[i] = vec3_add_scaled(w->accumulated[i], h * share_now, w->force[i]);
        if (share_next > 0) m->total[i] = vec3_add_scaled(m->total[i], h * share_next, m->at[i].force);
    }
}

/* The accumulated force is scaled so that it meets (4), then multiplied by h. */
static void keep_moment(moment *m, double speed, wcut_condition condition, double *elapsed) {
    wcut_cut *cut = m->cut;
    wcut_wire *w = &cut->next;
    const int n = cut->setup->job->nodes;

    /* (11) gave the speed, so that h is the time of the step */
    const double h = m->reach / speed;
    wcut_vec3 sum = {0, 0, 0}, now = {0, 0, 0};
    for (int i = 0; i < n; i++) {
        sum = vec3_add(sum, m->total[i]);
        now = vec3_add(now, m->at[i].force);
    }

    /* scale: the present force over the accumulated one */
    const double scale = vec3_length(sum) > 0 ? vec3_length(now) / vec3_length(sum) : 0;

    /* the wire as it hangs, the force as it acts, the accumulated force times the time */
    for (int i = 0; i < n; i++) {
        w->x[i] = cut->hanging_shape[i];
        w->force[i] = m->at[i].force;
        w->line[i] = m->at[i].line;
        w->speed[i] = m->at[i].speed;
        w->engaged[i] = m->at[i].engaged;
        w->pattern[i] = m->total[i];
        w->accumulated[i] = vec3_scale(scale * h, m->total[i]);
    }
    for (int e = 0; e < n - 1; e++) w->s[e] = cut->hanging_tension[e] * scale;

    /* what the next step starts from */
    w->length = m->target->length;
    w->loaded = true;
    w->condition = condition;
    w->front_speed = speed;
    w->step_duration = h;
    wcut_cut_remember(cut, m->target, 1 / h);
    *elapsed += h;
}

wcut_status wcut_heun_advance(wcut_cut *cut, const wcut_target *target, double *elapsed, wcut_error *error) {
    const int n = cut->setup->job->nodes;
    wcut_wire *w = &cut->next;

    /* the way of the faster mount, and where the wire was */
    moment m = {.cut = cut, .target = target, .total = cut->softer, .at = cut->solver.system.node};
    m.reach = fmax(vec3_distance(target->end_a, w->x[0]), vec3_distance(target->end_b, w->x[n - 1]));
    memcpy(cut->was, w->x, sizeof *w->x * (size_t)n);
    cut->substeps = 1;

    if (!wcut_cut_hang(cut, target, w->pattern))
        return wcut_fail(error, WCUT_NOT_CONVERGED, "heun: the wire has no shape under its accumulated force");
    if (!wcut_cut_touches(cut, cut->hanging_shape)) {
        wcut_cut_feed_free(cut, target, m.reach, elapsed);
        w->step_duration = *elapsed;
        return WCUT_OK;
    }

    /* predictor, as soon as there has been a step under load */
    wcut_condition condition;
    int rounds = 0;
    if (w->loaded && w->step_duration > 0) {
        accumulate(&m, w->step_duration, 1, 0); /* (9) */
        if (!wcut_cut_hang(cut, target, m.total))
            return wcut_fail(error, WCUT_NOT_CONVERGED, "heun: the predicted force (9) gives the wire no shape");
    }

    /* rate at the predicted shape */
    double speed = find_speed(&m, &condition, &rounds);
    cut->iterations += rounds;

    /* corrector: the mean of both forces, and the rate at the corrected shape */
    accumulate(&m, w->step_duration > 0 ? w->step_duration : m.reach / speed, 0.5, 0.5); /* (10) */
    if (!wcut_cut_hang(cut, target, m.total))
        return wcut_fail(error, WCUT_NOT_CONVERGED, "heun: the corrected force (10) gives the wire no shape");
    speed = find_speed(&m, &condition, &rounds);
    cut->iterations += rounds;

    /* residual of (4), where the tension decides */
    if (condition == WCUT_CONDITION_TENSION) cut->residual = fabs(m.pull / cut->setup->job->tension - 1);
    keep_moment(&m, speed, condition, elapsed);

    return WCUT_OK;
}
