/* How the wire of every station changes with what moves its ends: the implicit function theorem on the step's equations,
   whose banded Jacobian is there already; one right-hand side an unknown. */
#include "cut/sensitivity.h"

#include <stddef.h>
#include <string.h>

#include "base/alloc.h"
#include "base/threads.h"
#include "wire/chain.h"

bool wcut_sensitivity_create(const wcut_setup *setup, const wcut_end_motion *motion, wcut_vec3 *by,
                             wcut_sensitivity *s) {
    const size_t count = (size_t)motion->count, n = (size_t)setup->job->nodes, size = 4 * n - 7;
    *s = (wcut_sensitivity){.motion = *motion, .nodes = setup->job->nodes, .by = by};
    s->x = wcut_alloc(count * n, sizeof *s->x);
    s->was = wcut_alloc(count * n, sizeof *s->was);
    s->end_a = wcut_alloc(count, sizeof *s->end_a);
    s->end_b = wcut_alloc(count, sizeof *s->end_b);
    s->length = wcut_alloc(count, sizeof *s->length);
    s->log_rate = wcut_alloc(count, sizeof *s->log_rate);
    s->column = wcut_alloc(count * size, sizeof *s->column);
    s->by_rate = wcut_alloc(size, sizeof *s->by_rate);
    s->ends = wcut_alloc(2 * (size_t)motion->stations, sizeof *s->ends);
    s->pattern = wcut_alloc(count * n, sizeof *s->pattern);
    if (s->ends && s->pattern && s->x && s->was && s->end_a && s->end_b && s->length && s->log_rate && s->column &&
        s->by_rate)
        return true;
    wcut_sensitivity_destroy(s);
    return false;
}

void wcut_sensitivity_destroy(wcut_sensitivity *s) {
    wcut_free(s->x);
    wcut_free(s->was);
    wcut_free(s->end_a);
    wcut_free(s->end_b);
    wcut_free(s->length);
    wcut_free(s->log_rate);
    wcut_free(s->column);
    wcut_free(s->by_rate);
    wcut_free(s->ends);
    wcut_free(s->pattern);
    *s = (wcut_sensitivity){0};
}

/* ---- how the target of a sub-step changes ---- */

typedef struct target_change {
    wcut_vec3 end_a, end_b;
    double length;
} target_change;

/* by unknown k, at the sub-step's part of the way to the next station */
static target_change change_of_target(const wcut_cut *cut, int k) {
    const wcut_end_motion *m = &cut->sensitivity->motion;
    const int to = cut->index + 1, from = cut->index;
    const size_t at = (size_t)k * (size_t)m->stations;
    const double part = cut->part;
    return (target_change){vec3_mix(m->by_a[at + (size_t)from], m->by_a[at + (size_t)to], part),
                           vec3_mix(m->by_b[at + (size_t)from], m->by_b[at + (size_t)to], part),
                           (1 - part) * m->by_length[at + (size_t)from] + part * m->by_length[at + (size_t)to]};
}

/* whether unknown k has changed nothing yet, and does not here */
static bool rests(const wcut_sensitivity *s, int k, const target_change *t) {
    const wcut_vec3 *x = s->x + (size_t)k * (size_t)s->nodes;
    const wcut_vec3 ends = vec3_add(vec3_add(t->end_a, t->end_b), vec3_add(s->end_a[k], s->end_b[k]));
    if (vec3_length(ends) > 0 || t->length != 0 || s->length[k] != 0) return false;
    if (vec3_length(t->end_a) > 0 || vec3_length(s->end_a[k]) > 0) return false;
    for (int i = 0; i < s->nodes; i++)
        if (x[i].x != 0 || x[i].y != 0 || x[i].z != 0) return false;
    return true;
}

/* where the material of the nodes comes from: of a plan whose length changes, as find_material in implicit.c has it */
static void change_of_origin(const wcut_cut *cut, const wcut_target *target, int k, double length_change) {
    const wcut_sensitivity *s = cut->sensitivity;
    const int n = s->nodes;
    const wcut_wire *w = &cut->next;
    const wcut_vec3 *x = s->x + (size_t)k * (size_t)n;
    wcut_vec3 *was = s->was + (size_t)k * (size_t)n;
    memcpy(was, x, (size_t)n * sizeof *was);
    if (!cut->setup->foam.embedded) return;

    /* way = i r - (n - 1)(r - 1)/2 edges from end A, r the new length over the old one */
    const double ratio = target->length / w->length;
    const double ratio_change = (length_change - ratio * s->length[k]) / w->length;
    if (ratio == 1 && ratio_change == 0) return;
    for (int i = 0; i < n; i++) {
        const double way = i * ratio - (n - 1) * (ratio - 1) / 2;
        const double floor_way = floor(way);
        const int e = floor_way < 0 ? 0 : floor_way > n - 2 ? n - 2 : (int)floor_way;
        was[i] = vec3_add_scaled(vec3_mix(x[e], x[e + 1], way - e), (i - (n - 1) / 2.0) * ratio_change,
                                 vec3_sub(w->x[e + 1], w->x[e]));
    }
}

/* ---- what the equations have by ends, length and the wire before ---- */

static wcut_vec3 matrix_product(const mat3 *a, wcut_vec3 v) {
    return vec3(vec3_dot(a->x, v), vec3_dot(a->y, v), vec3_dot(a->z, v));
}

static void subtract_vector(double *at, wcut_vec3 v) { at[0] -= v.x, at[1] -= v.y, at[2] -= v.z; }

/* - dR of the lengths and of equilibrium; dead: how a dead load changes, n, or NULL */
static void put_column(const wcut_system *y, const wcut_step *step, const wcut_vec3 *x, const double *tension,
                       const target_change *t, const wcut_vec3 *was, const wcut_vec3 *dead, double *column) {
    const int n = y->n;
    const double l = step->edge, by_l = t->length / (n - 1);
    memset(column, 0, (size_t)y->size * sizeof *column);
    for (int e = 0; e < n - 1; e++) column[(ptrdiff_t)4 * e] = (1 + y->residual[(ptrdiff_t)4 * e] / l) * by_l;
    column[0] += vec3_dot(vec3_sub(x[1], x[0]), t->end_a) / l;
    column[(ptrdiff_t)4 * (n - 2)] -= vec3_dot(vec3_sub(x[n - 1], x[n - 2]), t->end_b) / l;

    for (int i = 1; i < n - 1; i++) {
        /* force per length of wire, and edges as directions over their length */
        const wcut_resistance *f = &y->node[i];
        const wcut_vec3 front = vec3_scale(tension[i] / l, vec3_sub(x[i + 1], x[i]));
        const wcut_vec3 back = vec3_scale(tension[i - 1] / l, vec3_sub(x[i], x[i - 1]));
        double *row = column + (ptrdiff_t)4 * i - 3;
        subtract_vector(row, vec3_scale(by_l / l, vec3_sub(f->force, vec3_sub(front, back))));
        subtract_vector(row, matrix_product(&f->by_was, was[i]));
        if (dead) subtract_vector(row, dead[i]);
    }
    const wcut_vec3 a = t->end_a, b = t->end_b;
    subtract_vector(column + 1, vec3_add_scaled(matrix_product(&y->node[1].by_before, a), tension[0] / l, a));
    subtract_vector(column + (ptrdiff_t)4 * (n - 2) - 3,
                    vec3_add_scaled(matrix_product(&y->node[n - 2].by_after, b), tension[n - 2] / l, b));
}

/* d |sum f| - k d |t_0 + t_(n-1)| by the same */
static double change_of_condition(const wcut_system *y, const wcut_step *step, const wcut_vec3 *x,
                                  const target_change *t, const wcut_vec3 *was) {
    const int n = y->n;
    wcut_vec3 sum = {0, 0, 0}, by = {0, 0, 0};
    for (int i = 0; i < n; i++) {
        sum = vec3_add(sum, y->node[i].force);
        by = vec3_add(by, matrix_product(&y->node[i].by_was, was[i]));
    }
    by = vec3_add(
        by, vec3_add(matrix_product(&y->node[0].by_here, t->end_a), matrix_product(&y->node[1].by_before, t->end_a)));
    by = vec3_add(by, vec3_add(matrix_product(&y->node[n - 1].by_here, t->end_b),
                               matrix_product(&y->node[n - 2].by_after, t->end_b)));
    by = vec3_add_scaled(by, t->length / (n - 1) / step->edge, sum);

    double scale_a, scale_b;
    const wcut_vec3 a = wcut_chain_outward(x[0], x[1], x[2], &scale_a);
    const wcut_vec3 b = wcut_chain_outward(x[n - 1], x[n - 2], x[n - 3], &scale_b);
    const wcut_vec3 w = vec3_unit(vec3_add(a, b));
    const double opening = 3 * scale_a * (vec3_dot(w, t->end_a) - vec3_dot(a, w) * vec3_dot(a, t->end_a)) +
                           3 * scale_b * (vec3_dot(w, t->end_b) - vec3_dot(b, w) * vec3_dot(b, t->end_b));
    return vec3_dot(vec3_unit(sum), by) - step->tension * opening;
}

/* the rate of a step at a given speed follows the way of its faster end */
static double change_of_given_rate(const wcut_cut *cut, const wcut_target *target, int k, const target_change *t) {
    const wcut_sensitivity *s = cut->sensitivity;
    const wcut_vec3 way_a = vec3_sub(target->end_a, cut->next.end_a), way_b = vec3_sub(target->end_b, cut->next.end_b);
    const double a = vec3_length(way_a), b = vec3_length(way_b);
    if (a >= b) return -vec3_dot(way_a, vec3_sub(t->end_a, s->end_a[k])) / (a * a);
    return -vec3_dot(way_b, vec3_sub(t->end_b, s->end_b[k])) / (b * b);
}

/* ---- a step ---- */

static void keep_derivative(wcut_sensitivity *s, int k, const target_change *t, const double *column, double log_rate) {
    const int n = s->nodes;
    wcut_vec3 *x = s->x + (size_t)k * (size_t)n;
    x[0] = t->end_a, x[n - 1] = t->end_b;
    for (int i = 1; i < n - 1; i++) x[i] = vec3(column[4 * i - 3], column[4 * i - 2], column[4 * i - 1]);
    s->end_a[k] = t->end_a, s->end_b[k] = t->end_b;
    s->length[k] = t->length;
    s->log_rate[k] = log_rate;
}

/* whether a solution is so much larger than what it comes from */
static bool is_beyond_limit(const wcut_sensitivity *s, int k, const target_change *t, const double *column) {
    const wcut_vec3 *was = s->was + (size_t)k * (size_t)s->nodes;
    double before = vec3_length(t->end_a) + vec3_length(t->end_b) + fabs(t->length), after = 0;
    for (int i = 1; i < s->nodes - 1; i++) {
        before = fmax(before, vec3_length(was[i]));
        after = fmax(after, vec3_length(vec3(column[4 * i - 3], column[4 * i - 2], column[4 * i - 1])));
    }
    return s->motion.limit > 0 && after > s->motion.limit * before;
}

/* the wire carried along with its ends, in the place of a solution */
static void carry_along(const wcut_sensitivity *s, int k, const target_change *t, double *column) {
    const int n = s->nodes;
    const wcut_vec3 *was = s->was + (size_t)k * (size_t)n;
    const wcut_vec3 a = vec3_sub(t->end_a, was[0]), b = vec3_sub(t->end_b, was[n - 1]);
    for (int i = 1; i < n - 1; i++) {
        const wcut_vec3 x = vec3_add(was[i], vec3_mix(a, b, (double)i / (n - 1)));
        column[4 * i - 3] = x.x, column[4 * i - 2] = x.y, column[4 * i - 1] = x.z;
    }
}

/* the force on the nodes, which the wire keeps as its pattern */
static void keep_pattern(wcut_sensitivity *s, const wcut_system *y, const wcut_step *step, int k,
                         const target_change *t, double log_rate) {
    const int n = s->nodes;
    const wcut_vec3 *x = s->x + (size_t)k * (size_t)n, *was = s->was + (size_t)k * (size_t)n;
    wcut_vec3 *pattern = s->pattern + (size_t)k * (size_t)n;
    const double by_l = t->length / (n - 1) / step->edge;
    for (int i = 0; i < n; i++) {
        const wcut_resistance *f = &y->node[i];
        wcut_vec3 by = vec3_add(matrix_product(&f->by_was, was[i]), matrix_product(&f->by_here, x[i]));
        if (i > 0) by = vec3_add(by, matrix_product(&f->by_before, x[i - 1]));
        if (i < n - 1) by = vec3_add(by, matrix_product(&f->by_after, x[i + 1]));
        by = vec3_add_scaled(by, log_rate, f->by_log_rate);
        pattern[i] = vec3_add_scaled(by, by_l, f->force);
    }
}

/* unknown k of a loaded step; the Jacobian is factored, s->by_rate is what it makes of the rate's column */
static void solve_unknown(wcut_cut *cut, const wcut_step *step, const wcut_target *target, bool by_tension,
                          double slope, int k) {
    wcut_sensitivity *s = cut->sensitivity;
    const wcut_system *y = &cut->solver.system;
    const target_change t = change_of_target(cut, k);
    if (rests(s, k, &t)) return;
    const wcut_vec3 *x = cut->hanging_shape, *was = s->was + (size_t)k * (size_t)s->nodes;
    double *column = s->column + (size_t)k * (size_t)y->size;
    change_of_origin(cut, target, k, t.length);
    put_column(y, step, x, cut->hanging_tension, &t, was, NULL, column);
    wcut_banded_solve(&y->jacobian, column);

    /* the rate: given, or an unknown that the condition finds */
    double log_rate;
    if (by_tension) {
        double gap = -change_of_condition(y, step, x, &t, was);
        for (int r = 0; r < y->size; r++) gap -= y->border[r] * column[r];
        log_rate = gap / slope;
    } else {
        log_rate = change_of_given_rate(cut, target, k, &t);
    }
    for (int r = 0; r < y->size; r++) column[r] -= log_rate * s->by_rate[r];
    if (is_beyond_limit(s, k, &t, column)) carry_along(s, k, &t, column);
    keep_derivative(s, k, &t, column, log_rate);
    keep_pattern(s, y, step, k, &t, log_rate);
}

void wcut_sensitivity_step(wcut_cut *cut, const wcut_step *step, const wcut_target *target, wcut_condition condition) {
    wcut_sensitivity *s = cut->sensitivity;
    wcut_system *y = &cut->solver.system;
    const bool by_tension = condition == WCUT_CONDITION_TENSION;

    /* the Jacobian of the solution, and what the rate does */
    if (!wcut_banded_factor(&y->jacobian)) {
        s->failed = true;
        return;
    }
    memcpy(s->by_rate, y->by_log_rate, (size_t)y->size * sizeof *s->by_rate);
    wcut_banded_solve(&y->jacobian, s->by_rate);
    double slope = y->condition_by_log_rate;
    for (int r = 0; r < y->size; r++) slope -= y->border[r] * s->by_rate[r];
    if (by_tension && !(fabs(slope) > 0)) s->failed = true;

        /* each unknown by itself: no result depends on the number of threads */
#pragma omp parallel for schedule(static) num_threads(wcut_threads(s->motion.threads))
    for (int k = 0; k < s->motion.count; k++) solve_unknown(cut, step, target, by_tension, slope, k);
}

/* ---- a wire that hangs ---- */

/* unknown k of a wire that hangs under its pattern */
static void hang_unknown(wcut_cut *cut, const wcut_step *step, const target_change *t, int k) {
    wcut_sensitivity *s = cut->sensitivity;
    const wcut_system *y = &cut->solver.system;
    wcut_vec3 *was = s->was + (size_t)k * (size_t)s->nodes;
    double *column = s->column + (size_t)k * (size_t)y->size;
    memset(was, 0, (size_t)s->nodes * sizeof *was); /* no foam acts on it */
    put_column(y, step, cut->hanging_shape, cut->hanging_tension, t, was, s->pattern + (size_t)k * (size_t)s->nodes,
               column);
    wcut_banded_solve(&y->jacobian, column);
    keep_derivative(s, k, t, column, 0);
}

/* a wire that is straight follows its ends */
static void follow_ends(wcut_sensitivity *s, int k, const target_change *t) {
    wcut_vec3 *x = s->x + (size_t)k * (size_t)s->nodes;
    for (int i = 0; i < s->nodes; i++) x[i] = vec3_mix(t->end_a, t->end_b, (double)i / (s->nodes - 1));
    s->end_a[k] = t->end_a, s->end_b[k] = t->end_b;
    s->length[k] = t->length;
    s->log_rate[k] = 0;
}

/* the Jacobian of the hanging wire: the same equations with a dead load and without foam */
static bool factor_hanging(wcut_cut *cut, wcut_step *step) {
    wcut_system *y = &cut->solver.system;
    if (!(cut->hanging_tension[0] > 0)) return false;
    wcut_system_eval(y, step, cut->hanging_shape, cut->hanging_tension, 0, true);
    return wcut_banded_factor(&y->jacobian);
}

static wcut_step hanging_step(const wcut_cut *cut, double length, const wcut_vec3 *load) {
    const wcut_job *job = cut->setup->job;
    return (wcut_step){.foam = &cut->setup->foam,
                       .heat = job->heat,
                       .tension = job->tension,
                       .edge = length / (job->nodes - 1),
                       .n = job->nodes,
                       .was = cut->hanging_shape,
                       .dead_load = load};
}

void wcut_sensitivity_hang(wcut_cut *cut, const wcut_target *target, const wcut_vec3 *load) {
    wcut_sensitivity *s = cut->sensitivity;
    wcut_step step = hanging_step(cut, target->length, load);
    const bool bent = factor_hanging(cut, &step);
    for (int k = 0; k < s->motion.count; k++) {
        const target_change t = change_of_target(cut, k);
        if (bent)
            hang_unknown(cut, &step, &t, k);
        else
            follow_ends(s, k, &t);
    }
}

/* how the feed, which loads the wire of station 0, turns with unknown k: by central differences of the ends */
static wcut_vec3 change_of_feed(const wcut_cut *cut, int k, wcut_vec3 *room) {
    const wcut_end_motion *m = &cut->sensitivity->motion;
    const size_t stations = (size_t)m->stations, at = (size_t)k * stations;
    const double h = 1e-3;
    wcut_vec3 feed[2];
    for (int side = 0; side < 2; side++) {
        wcut_setup moved = *cut->setup;
        double length = cut->setup->length[0] + (side ? h : -h) * m->by_length[at]; /* the only one that it looks at */
        moved.end_a = room, moved.end_b = room + stations, moved.length = &length;
        for (size_t j = 0; j < stations; j++) {
            moved.end_a[j] = vec3_add_scaled(cut->setup->end_a[j], side ? h : -h, m->by_a[at + j]);
            moved.end_b[j] = vec3_add_scaled(cut->setup->end_b[j], side ? h : -h, m->by_b[at + j]);
        }
        feed[side] = wcut_setup_feed(&moved);
    }
    return vec3_scale(1 / (2 * h), vec3_sub(feed[1], feed[0]));
}

/* station 0: the wire hangs under an even load against the feed, as begin in cut.c has it */
void wcut_sensitivity_begin(wcut_cut *cut) {
    wcut_sensitivity *s = cut->sensitivity;
    const wcut_end_motion *m = &s->motion;
    const wcut_job *job = cut->setup->job;
    const int n = job->nodes;
    wcut_step step = hanging_step(cut, cut->now.length, cut->now.pattern);
    const bool bent = factor_hanging(cut, &step);
    for (int k = 0; k < m->count; k++) {
        const size_t at = (size_t)k * (size_t)m->stations;
        const target_change t = {m->by_a[at], m->by_b[at], m->by_length[at]};
        const wcut_vec3 turn = vec3_scale(-job->tension / n, change_of_feed(cut, k, s->ends));
        for (int i = 0; i < n; i++) s->pattern[k * n + i] = turn;
        if (bent)
            hang_unknown(cut, &step, &t, k);
        else
            follow_ends(s, k, &t);
    }
}

void wcut_sensitivity_store(const wcut_sensitivity *s, int station) {
    const size_t n = (size_t)s->nodes, row = (size_t)s->motion.stations * n;
    for (size_t k = 0; k < (size_t)s->motion.count; k++)
        memcpy(s->by + k * row + (size_t)station * n, s->x + k * n, n * sizeof *s->x);
}
