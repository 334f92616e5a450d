/* The cut that comes nearest to a target: starts from a scan, Levenberg-Marquardt (Marquardt 1963) from coarse runs to
   fine ones, more coefficients where they pay. */
#include <string.h>
#include <wirecut/compensation.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"
#include "inverse/descent.h"
#include "inverse/prepare.h"

enum { FIRST_COEFFICIENTS = 8, STARTS = 3, BORROWED_MIN = 121 };

#define WORTH 0.95 /* [1] more coefficients are worth it where the rms falls below this share */

/* ---- levels ---- */

static wcut_status open_trial(const wcut_design_target *t, const wcut_job *job, const wcut_design_options *o,
                              int stations, int nodes, wcut_trial *out) {
    return wcut_trial_create(t, job, o->angle_max, o->threads, stations, nodes, WCUT_DESIGN_CURVES * o->unknowns_max,
                             out);
}

/* wires from scans with fixed and with free edges, and ordinary ones; gives how many */
static wcut_status make_starts(const wcut_design_target *t, const wcut_design_options *o,
                               wcut_design_curves start[STARTS], int *starts) {
    *starts = 0;
    for (int edges = 0; edges < (o->free_edges ? 2 : 1); edges++) {
        wcut_scan scan = {0};
        const wcut_status status = wcut_scan_create(t, edges == 1, o->angle_max, &scan);
        if (status != WCUT_OK) return status;
        if (wcut_design_start(t, &scan, edges == 1, FIRST_COEFFICIENTS, &start[*starts])) ++*starts;
        wcut_scan_clear(&scan);
    }
    wcut_design_start_flat(t, FIRST_COEFFICIENTS, &start[(*starts)++]);
    for (int k = 0; k < *starts; k++) start[k].free_edges = o->free_edges != 0;
    return WCUT_OK;
}

/* coarse runs: the starts by what they cost at first, the two lowest improved a little, the better of them kept */
static wcut_status choose_start(wcut_descent *s, wcut_trial *coarse, const wcut_design_options *o, double *start_rms,
                                wcut_design_curves *best) {
    wcut_design_curves start[STARTS];
    double cost[STARTS], lowest = HUGE_VAL;
    int starts, found = -1;
    wcut_status status = make_starts(coarse->target, o, start, &starts);
    *start_rms = HUGE_VAL;
    for (int k = 0; status == WCUT_OK && k < starts; k++) {
        wcut_reached reached;
        coarse->known = false;
        const wcut_status run = wcut_trial_eval(coarse, &start[k], NULL, NULL, &reached);
        cost[k] = run == WCUT_OK ? reached.cost : HUGE_VAL;
        if (run == WCUT_OK) *start_rms = fmin(*start_rms, reached.rms);
        if (run == WCUT_NO_MEMORY) status = run;
        s->runs++;
    }

    /* the lowest, then the next one */
    for (int turn = 0; status == WCUT_OK && turn < 2 && !s->stopped; turn++) {
        wcut_reached reached;
        int next = 0;
        for (int k = 1; k < starts; k++)
            if (cost[k] < cost[next]) next = k;
        if (!(cost[next] < HUGE_VAL)) break;
        cost[next] = HUGE_VAL;
        coarse->known = false;
        const wcut_status run = wcut_descent_improve(s, coarse, &start[next], 6, o->tolerance / 4, &reached);
        if (run == WCUT_NO_MEMORY) status = run;
        if (run != WCUT_OK) continue;
        wcut_descent_note(s, coarse, &start[next], &reached);
        if (reached.cost < lowest) lowest = reached.cost, found = next;
        if (reached.rms < o->tolerance) break;
    }
    if (found >= 0) *best = start[found];
    return status != WCUT_OK || found >= 0 ? status : WCUT_NOT_CONVERGED;
}

/* more coefficients as long as they pay */
static wcut_status grow_curves(wcut_descent *s, wcut_trial *search, const wcut_design_options *o, wcut_design_curves *c,
                               wcut_reached *reached) {
    wcut_status status = WCUT_OK;
    while (status == WCUT_OK && !s->stopped && reached->rms > o->tolerance / 2) {
        wcut_design_curves finer = *c;
        wcut_reached there;
        const int more = c->coefficients + (c->coefficients - 3); /* spans halved: the new curves hold the old ones */
        if (more > o->unknowns_max) break;
        wcut_design_refine(&finer, more);
        status = wcut_descent_improve(s, search, &finer, 6, o->tolerance / 4, &there);
        if (status != WCUT_OK) return status == WCUT_NO_MEMORY ? status : WCUT_OK;
        wcut_descent_note(s, search, &finer, &there);
        const bool worth = there.rms < WORTH * reached->rms;
        if (there.cost < reached->cost) *c = finer, *reached = there;
        if (!worth) break;
    }
    return status;
}

/* a level's search, which may borrow from the one before; at first it chooses a start */
static wcut_status search_level(wcut_descent *s, wcut_trial *search, wcut_trial *before, int steps,
                                const wcut_design_options *o, double *start_rms, wcut_design_curves *best,
                                wcut_reached *reached) {
    wcut_status status = WCUT_OK;
    if (!before->target) {
        status = choose_start(s, search, o, start_rms, best);
        search->known = false;
    } else if (before->stations >= BORROWED_MIN) {
        status = wcut_trial_borrow(search, before, best);
    }
    if (status == WCUT_OK) status = wcut_descent_improve(s, search, best, steps, o->tolerance / 4, reached);
    if (status == WCUT_OK) wcut_descent_note(s, search, best, reached);
    return status;
}

static wcut_status climb_levels(wcut_descent *s, const wcut_design_target *t, const wcut_job *job,
                                const wcut_design_options *o, double *start_rms, wcut_design_curves *best,
                                wcut_reached *reached) {
    const struct { int stations, nodes, steps; } level[3] = {{61, 31, 6}, {121, 61, 4}, {job->stations, job->nodes, 8}};
    wcut_status status = WCUT_OK;
    wcut_trial before = {0};
    bool grown = false;

    /* coarse runs first; levels that are finer than the job are passed over */
    for (int l = 0; l < 3 && status == WCUT_OK && !s->stopped; l++) {
        wcut_trial search;
        if (l < 2 && level[l].stations >= job->stations && level[l].nodes >= job->nodes) continue;
        status = open_trial(t, job, o, level[l].stations, level[l].nodes, &search);
        if (status != WCUT_OK) break;
        status = search_level(s, &search, &before, level[l].steps, o, start_rms, best, reached);
        if (status == WCUT_OK && !grown && l >= 1) status = grow_curves(s, &search, o, best, reached);
        for (int k = 0; status == WCUT_OK && k < t->count; k++) s->strays[k] = !(search.weight[k] > 0);
        wcut_trial_destroy(&before);
        before = search;
        grown = l >= 1;
    }
    wcut_trial_destroy(&before);
    return status;
}

/* ---- the answer ---- */

/* a cubic through the ends of every station at even parameters: at the stations it is exact */
static wcut_status make_design_edge(int stations, const wcut_vec3 *end, const double *t, wcut_curve **curve) {
    return wcut_curve_interpolate_at(stations, end, t, NULL, NULL, curve);
}

static wcut_status make_design_job(const wcut_job *job, const wcut_design_target *t, const wcut_design_curves *c,
                                   const char *name, wcut_design *d) {
    const size_t m = (size_t)job->stations;
    wcut_job *out = NULL;
    wcut_status status = wcut_job_create(&out);
    if (status != WCUT_OK) return status;
    d->job = out;
    wcut_job *copy = wcut_job_copy(job);
    if (!copy) return WCUT_NO_MEMORY;

    /* what the job had of paths and designs gives way */
    wcut_job_destroy(out);
    d->job = out = copy;
    wcut_free(out->mount_a);
    wcut_free(out->mount_b);
    wcut_curve_destroy(out->edge_a);
    wcut_curve_destroy(out->edge_b);
    wcut_free(out->extra_u);
    wcut_free(out->extra_length);
    out->mount_a = out->mount_b = NULL;
    out->edge_a = out->edge_b = NULL;
    out->mode = WCUT_MODE_DESIGN;
    if (name) {
        wcut_free(out->name);
        out->name = wcut_copy_text(name);
        if (!out->name) return WCUT_NO_MEMORY;
    }
    out->block_size = t->block;
    out->overrun = t->block.x; /* the sagging wire covers the block */
    out->extra_count = job->stations;
    out->extra_u = wcut_alloc(m, sizeof *out->extra_u);
    out->extra_length = wcut_alloc(m, sizeof *out->extra_length);
    d->lag = wcut_alloc(m, sizeof *d->lag);
    d->sag = wcut_alloc(m, sizeof *d->sag);
    d->extra = wcut_alloc(m, sizeof *d->extra);
    wcut_vec3 *a = wcut_alloc(m, sizeof *a), *b = wcut_alloc(m, sizeof *b);
    if (!out->extra_u || !out->extra_length || !d->lag || !d->sag || !d->extra || !a || !b) status = WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        wcut_design_place(c, t, job->stations, a, b, out->extra_length, NULL, NULL, NULL);
        for (size_t j = 0; j < m; j++) {
            const double at = (double)j / (double)(m - 1);
            out->extra_u[j] = at;
            out->extra_length[j] -= vec3_distance(a[j], b[j]);
            d->lag[j] = wcut_design_curve_at(c, WCUT_DESIGN_CURVE_LAG, at, NULL);
            d->sag[j] = wcut_design_curve_at(c, WCUT_DESIGN_CURVE_SAG, at, NULL);
            d->extra[j] = out->extra_length[j];
        }
        d->stations = job->stations;
        status = make_design_edge(job->stations, a, out->extra_u, &out->edge_a);
    }
    if (status == WCUT_OK) status = make_design_edge(job->stations, b, out->extra_u, &out->edge_b);
    wcut_free(a);
    wcut_free(b);
    return status;
}

/* the points that are no strays */
static wcut_status keep_points(const wcut_design_target *t, const unsigned char *strays, wcut_design *d) {
    d->point = wcut_alloc((size_t)t->count, sizeof *d->point);
    if (!d->point) return WCUT_NO_MEMORY;
    for (int k = 0; k < t->count; k++)
        if (!strays[k]) d->point[d->points++] = t->point[k];
    return WCUT_OK;
}

/* the job's own paths, for who does not want to wait */
static wcut_status take_paths(const wcut_design_target *t, const wcut_design_options *o, wcut_design *d,
                              wcut_error *error) {
    wcut_setup *setup = NULL;
    wcut_status status = wcut_setup_create(d->job, NULL, &setup, error);
    if (status == WCUT_OK) status = wcut_setup_path_job(setup, &d->path);
    wcut_setup_destroy(setup);
    if (status == WCUT_OK)
        status = wcut_compensation_measure(t, d->path, o->threads, &d->path_rms, &d->path_max, error);
    d->unpolished_rms = d->path_rms;
    return status;
}

/* What the robots do: the paths of the job, polished until their own face is nearest to the target. Strays are those of the
   plan: where the wire comes into the block the paths' face may be further off than any noise, and is to come nearer. */
static wcut_status polish_paths(const wcut_design_target *target, const wcut_design_options *o, wcut_descent *s,
                                wcut_design *d, wcut_error *error) {
    wcut_compensation *polished = NULL;
    wcut_design_target kept = *target;
    const wcut_design_target *t = &kept;
    kept.count = d->points, kept.point = d->point, kept.robust = false;
    if (s->stopped) return take_paths(t, o, d, error);
    const wcut_status status = wcut_compensation_fit(t, d->job, o, s->progress, s->context, &polished, error);
    if (status != WCUT_OK && status != WCUT_INTERRUPTED) return status;
    s->stopped = s->stopped || status == WCUT_INTERRUPTED;
    s->runs += polished->runs;
    d->path = polished->job;
    polished->job = NULL;
    d->path_rms = polished->after_rms, d->path_max = polished->after_max;
    d->unpolished_rms = polished->before_rms;
    wcut_compensation_destroy(polished);
    return WCUT_OK;
}

/* 3 x 4: the matrix of wcut_design_turn */
static void put_turn(wcut_design_feed feed, wcut_vec3 block, double turn[12]) {
    const wcut_vec3 zero = wcut_design_turn(feed, block, vec3(0, 0, 0));
    const wcut_vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int k = 0; k < 3; k++) {
        const wcut_vec3 v = vec3_sub(wcut_design_turn(feed, block, unit[k]), zero);
        turn[k] = v.x, turn[4 + k] = v.y, turn[8 + k] = v.z;
    }
    turn[3] = zero.x, turn[7] = zero.y, turn[11] = zero.z;
}

wcut_status wcut_design_fit(const wcut_design_target *target, const wcut_job *job, const wcut_design_options *options,
                            wcut_design_progress progress, void *context, wcut_design **design, wcut_error *error) {
    const wcut_design_options o = options ? *options : wcut_design_options_default();
    wcut_status status = wcut_design_check(target, job, &o, design, error);
    if (status != WCUT_OK) return status;

    /* the feed, then the search in its frame */
    wcut_descent s;
    wcut_design *d = wcut_alloc(1, sizeof *d);
    wcut_design_target *turned = NULL;
    wcut_design_curves best;
    wcut_reached reached = {0};
    double feed_rms[5];
    wcut_error cause = {0};
    if (!wcut_descent_create(target->count, progress, context, &s) || !d) status = WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_design_choose_feed(target, &o, feed_rms, &d->feed);
    if (status == WCUT_OK) status = wcut_design_target_turn(target, d->feed, &turned);
    if (status == WCUT_OK) status = climb_levels(&s, turned, job, &o, &d->start_rms, &best, &reached);
    if (status == WCUT_OK) status = make_design_job(job, turned, &best, o.name, d);
    if (status == WCUT_OK) status = keep_points(turned, s.strays, d);
    if (status == WCUT_OK) status = polish_paths(turned, &o, &s, d, &cause);
    if (status == WCUT_OK) {
        d->round = wcut_copy(s.round, (size_t)s.rounds, sizeof *d->round);
        if (!d->round) status = WCUT_NO_MEMORY;
    }
    if (status == WCUT_OK) {
        put_turn(d->feed, target->block, d->turn);
        d->rms = reached.rms, d->max = reached.max;
        d->used = reached.used, d->strays = reached.strays, d->uncovered = reached.uncovered;
        d->runs = s.runs;
        d->rounds = s.rounds;
        *design = d;
        if (s.stopped) status = wcut_fail(error, WCUT_INTERRUPTED, "stopped on request after %d runs", s.runs);
    } else {
        wcut_design_destroy(d);
        wcut_fail(error, status, "%s",
                  status == WCUT_NO_MEMORY ? "no memory for a design"
                  : cause.text[0]          ? cause.text
                                           : "no wire could be run along the target's scan");
    }
    wcut_descent_destroy(&s);
    wcut_design_target_destroy(turned);
    return status;
}

void wcut_design_destroy(wcut_design *d) {
    if (!d) return;
    wcut_job_destroy(d->job);
    wcut_job_destroy(d->path);
    wcut_free(d->round);
    wcut_free(d->lag);
    wcut_free(d->sag);
    wcut_free(d->extra);
    wcut_free(d->point);
    wcut_free(d);
}
