/* Paths corrected so that what the machine cuts comes out as it is wanted. */
#include <string.h>
#include <wirecut/compensation.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"
#include "inverse/descent.h"

#define PAYS 0.97 /* [1] more coefficients are worth it where the rms falls below this share */

#define BOW_MIN 5e-3 /* [1] of the chord: a wire that bows less has no side */

enum { COARSE_NODES = 41, COARSE_STEPS = 10, FINE_STEPS = 6, CORRECTIONS = 12, PARTS = 4 };

static wcut_status check_compensation(const wcut_design_target *target, const wcut_job *job,
                                      const wcut_design_options *o, const void *out, wcut_error *error) {
    /* the arguments, then the options that are looked at */
    if (!target || !job || !out) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a target, a job and a place are expected");
    if (!(o->tolerance >= 0 && isfinite(o->tolerance)) || o->unknowns_max < 6 || o->unknowns_max > WCUT_KNOTS_MAX ||
        o->threads < 1)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "options: a tolerance of 0 or more, 6 to %d coefficients and 1 thread or more are expected",
                         WCUT_KNOTS_MAX);
    return WCUT_OK;
}

/* ---- the search ---- */

/* first with few coefficients, then with more where they pay */
static wcut_status correct_coarsely(wcut_descent *s, wcut_trial *trial, const wcut_design_options *o,
                                    wcut_design_curves *c) {
    wcut_reached reached, there;
    wcut_status status = wcut_descent_improve(s, trial, c, COARSE_STEPS, o->tolerance / 4, &reached);
    if (status == WCUT_OK) wcut_descent_note(s, trial, c, &reached);
    while (status == WCUT_OK && !s->stopped && reached.rms > o->tolerance / 2) {
        wcut_design_curves finer = *c;
        const int more = 2 * c->coefficients - 3;
        if (more > o->unknowns_max) break;
        wcut_design_refine(&finer, more);
        status = wcut_descent_improve(s, trial, &finer, COARSE_STEPS, o->tolerance / 4, &there);
        if (status != WCUT_OK) break;
        wcut_descent_note(s, trial, &finer, &there);
        const bool pays = there.rms < PAYS * reached.rms;
        if (there.cost < reached.cost) *c = finer, reached = there;
        if (!pays) break;
    }
    return status == WCUT_NOT_CONVERGED ? WCUT_OK : status;
}

/* the job's own nodes: what it cuts without a correction, then the correction refined with the derivatives of the coarse
   runs; curves that make it worse are given up */
static wcut_status correct_finely(wcut_descent *s, wcut_trial *trial, wcut_trial *coarse, const wcut_design_options *o,
                                  wcut_design_curves *c, wcut_reached reached[2]) {
    wcut_design_curves none = *c;
    memset(none.value, 0, sizeof none.value);
    wcut_status status = wcut_trial_eval(trial, &none, NULL, NULL, &reached[0]);
    if (status == WCUT_OK) status = wcut_trial_borrow(trial, coarse, c);
    if (status != WCUT_OK) return status;

    /* where the finer run of the correction fails, or is worse, a part of it is the start */
    bool found = false;
    for (int part = PARTS; part > 0 && !found && status == WCUT_OK; part--) {
        wcut_design_curves less = *c;
        for (int f = 0; f < WCUT_DESIGN_CURVES; f++)
            for (int k = 0; k < c->coefficients; k++) less.value[f][k] *= (double)part / PARTS;
        trial->known = false;
        const wcut_status better = wcut_descent_improve(s, trial, &less, FINE_STEPS, o->tolerance / 4, &reached[1]);
        if (better == WCUT_NO_MEMORY) status = better;
        found = better == WCUT_OK && reached[1].cost < reached[0].cost;
        if (found) *c = less;
    }
    if (!found) *c = none, reached[1] = reached[0];
    wcut_descent_note(s, trial, c, &reached[1]);
    for (int k = 0; k < trial->target->count; k++) s->strays[k] = !(trial->weight[k] > 0);
    return status;
}

/* runs of few nodes, then of the job's own */
static wcut_status find_correction(wcut_descent *s, const wcut_design_target *target, const wcut_setup *setup,
                                   const wcut_design_options *o, wcut_design_curves *c, wcut_reached reached[2]) {
    wcut_trial coarse, fine;
    const int nodes = setup->job->nodes < COARSE_NODES ? setup->job->nodes : COARSE_NODES;
    const int unknowns = WCUT_DESIGN_CURVES * o->unknowns_max;
    wcut_status status = wcut_trial_create_path(target, setup, o->threads, nodes, unknowns, &coarse);
    if (status != WCUT_OK) return status;
    status = correct_coarsely(s, &coarse, o, c);
    if (status == WCUT_OK)
        status = wcut_trial_create_path(target, setup, o->threads, setup->job->nodes, unknowns, &fine);
    if (status == WCUT_OK) {
        status = correct_finely(s, &fine, &coarse, o, c, reached);
        wcut_trial_destroy(&fine);
    }
    wcut_trial_destroy(&coarse);
    return status;
}

/* ---- the answer ---- */

/* the middle of a wire from that of its chord, and the chord */
static wcut_vec3 bow_of_wire(const wcut_history *h, int station, wcut_vec3 *chord) {
    const wcut_vec3 *x = h->position + (size_t)station * (size_t)h->nodes;
    *chord = vec3_sub(x[h->nodes - 1], x[0]);
    const int middle = h->nodes / 2;
    return vec3_sub(x[middle], vec3_mix(x[0], x[h->nodes - 1], middle / (h->nodes - 1.0)));
}

/* the first station at which a wire that is in the foam bows to the other side than before; -1: none */
static int find_branch(const wcut_history *before, const wcut_history *after, double depth) {
    const int stations = before->stations < after->stations ? before->stations : after->stations;
    for (int j = 0; j < stations; j++) {
        wcut_vec3 chord[2];
        const wcut_vec3 a = bow_of_wire(before, j, &chord[0]), b = bow_of_wire(after, j, &chord[1]);
        const double least = BOW_MIN * vec3_length(chord[0]);
        if (before->row[j].engaged_length <= depth || after->row[j].engaged_length <= depth) continue;
        if (vec3_length(a) > least && vec3_length(b) > least && vec3_dot(a, b) < 0) return j;
    }
    return -1;
}

/* Whether the corrected paths are a job: the search bends paths without the checks of one, such as a wire that is longer than
   the distance of its ends; and whether its wire is another solution of first contact than that of the job. WCUT_NO_MEMORY,
   or WCUT_OK with the answers. */
static wcut_status is_runnable(const wcut_setup *setup, const wcut_design_curves *c, bool *answer, int *branch) {
    wcut_job *job = NULL;
    wcut_setup *made = NULL;
    wcut_history *before = NULL, *after = NULL;
    wcut_status status = wcut_setup_path_job(setup, &job);
    if (status != WCUT_OK) return status;
    wcut_design_correct(c, setup->stations, setup->end_a, setup->end_b, job->mount_a, job->mount_b, NULL, NULL, NULL);
    status = wcut_setup_create(job, NULL, &made, NULL);
    *answer = status == WCUT_OK;
    if (status == WCUT_OK) status = wcut_setup_run(setup, NULL, NULL, &before, NULL);
    if (status == WCUT_OK) status = wcut_setup_run(made, NULL, NULL, &after, NULL);
    if (status == WCUT_OK) *branch = find_branch(before, after, job->wire_diameter);
    wcut_history_destroy(before);
    wcut_history_destroy(after);
    wcut_setup_destroy(made);
    wcut_job_destroy(job);
    return status == WCUT_NO_MEMORY ? status : WCUT_OK;
}

static wcut_status keep_correction(const wcut_setup *setup, const wcut_design_curves *c, const wcut_descent *s,
                                   wcut_compensation *out) {
    const size_t m = (size_t)setup->stations;
    wcut_status status = wcut_setup_path_job(setup, &out->job);
    if (status != WCUT_OK) return status;
    double **curve[WCUT_DESIGN_CURVES] = {&out->nearer, &out->lag, &out->rise_a, &out->rise_b};
    out->stations = setup->stations;
    out->round = wcut_copy(s->round, (size_t)s->rounds, sizeof *out->round);
    if (!out->round) return WCUT_NO_MEMORY;

    /* the curves at the stations, and the paths that they lead to */
    for (int f = 0; f < WCUT_DESIGN_CURVES; f++) {
        *curve[f] = wcut_alloc(m, sizeof(double));
        if (!*curve[f]) return WCUT_NO_MEMORY;
        for (size_t j = 0; j < m; j++)
            (*curve[f])[j] = wcut_design_curve_at(c, (wcut_design_curve)f, (double)j / (double)(m - 1), NULL);
    }
    wcut_design_correct(c, setup->stations, setup->end_a, setup->end_b, out->job->mount_a, out->job->mount_b, NULL,
                        NULL, NULL);
    return WCUT_OK;
}

wcut_status wcut_compensation_fit(const wcut_design_target *target, const wcut_job *job,
                                  const wcut_design_options *options, wcut_design_progress progress, void *context,
                                  wcut_compensation **out, wcut_error *error) {
    const wcut_design_options o = options ? *options : wcut_design_options_default();
    wcut_status status = check_compensation(target, job, &o, out, error);
    if (status != WCUT_OK) return status;
    wcut_setup *setup = NULL;
    status = wcut_setup_create(job, NULL, &setup, error);
    if (status != WCUT_OK) return status;

    /* the search from no correction at all */
    wcut_descent s;
    wcut_design_curves c = {.coefficients = o.unknowns_max < CORRECTIONS ? o.unknowns_max : CORRECTIONS,
                            .free_edges = true};
    wcut_reached reached[2] = {{.rms = 0}, {.rms = 0}};
    wcut_compensation *made = wcut_alloc(1, sizeof *made);
    const bool room = wcut_descent_create(target->count, progress, context, &s) && made;
    if (!room) status = WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = find_correction(&s, target, setup, &o, &c, reached);

    /* paths that no job may have are no correction */
    bool runnable = true;
    int branch = -1;
    if (status == WCUT_OK) status = is_runnable(setup, &c, &runnable, &branch);
    if (status == WCUT_OK && !runnable) {
        memset(c.value, 0, sizeof c.value);
        reached[1] = reached[0];
    }
    if (status == WCUT_OK) status = keep_correction(setup, &c, &s, made);

    /* what it is worth */
    if (status == WCUT_OK) {
        made->before_rms = reached[0].rms, made->before_max = reached[0].max;
        made->after_rms = reached[1].rms, made->after_max = reached[1].max;
        made->used = reached[1].used, made->strays = reached[1].strays, made->uncovered = reached[1].uncovered;
        made->branch = branch;
        made->runs = s.runs;
        made->rounds = s.rounds;
        *out = made;
        if (s.stopped) status = wcut_fail(error, WCUT_INTERRUPTED, "stopped on request after %d runs", s.runs);
    } else {
        wcut_compensation_destroy(made);
        wcut_fail(error, status, status == WCUT_NO_MEMORY ? "no memory for a compensation" : "the job cannot be run");
    }
    wcut_descent_destroy(&s);
    wcut_setup_destroy(setup);
    return status;
}

wcut_status wcut_compensation_measure(const wcut_design_target *target, const wcut_job *job, int threads, double *rms,
                                      double *max, wcut_error *error) {
    if (!target || !job || threads < 1 || !rms || !max)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a target, a job, threads and places are expected");
    wcut_setup *setup = NULL;
    wcut_trial trial;
    wcut_reached reached;
    const wcut_design_curves none = {.coefficients = 4, .free_edges = true};
    wcut_status status = wcut_setup_create(job, NULL, &setup, error);
    if (status != WCUT_OK) return status;

    /* a trial without a correction */
    status = wcut_trial_create_path(target, setup, threads, setup->job->nodes, 4 * WCUT_DESIGN_CURVES, &trial);
    if (status == WCUT_OK) {
        status = wcut_trial_eval(&trial, &none, NULL, NULL, &reached);
        wcut_trial_destroy(&trial);
    }
    wcut_setup_destroy(setup);
    if (status != WCUT_OK) return wcut_fail(error, status, "measuring: %s", wcut_status_text(status));
    *rms = reached.rms, *max = reached.max;
    return WCUT_OK;
}

void wcut_compensation_destroy(wcut_compensation *c) {
    if (!c) return;
    wcut_job_destroy(c->job);
    wcut_free(c->round);
    wcut_free(c->nearer);
    wcut_free(c->lag);
    wcut_free(c->rise_a);
    wcut_free(c->rise_b);
    wcut_free(c);
}
