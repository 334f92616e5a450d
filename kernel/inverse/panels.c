/* A target in panels: which division, a design for each panel, and how their faces meet. */
#include <wirecut/design_panels.h>

#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"
#include "inverse/prepare.h"
#include "inverse/trial.h"

#define HOPE 4.0   /* [1] a design may come so much nearer than its map promises */
#define BESIDE 1.0 /* [mm] a face that ends so far from a place of a joint is not there */

enum { JOINT_PLACES = 41 };

/* ---- a division ---- */

static void put_panel_place(const wcut_design_target *t, const wcut_design_panels *p, int k, wcut_design_panel *panel) {
    const int i = k % p->across, j = k / p->across;
    panel->low = vec3(t->block.x * i / p->across, t->block.y * j / p->along, 0);
    panel->high = vec3(t->block.x * (i + 1) / p->across, t->block.y * (j + 1) / p->along, t->block.z);
}

/* a division without designs; NULL: no memory */
static wcut_design_panels *create_division(const wcut_design_target *t, int across, int along) {
    wcut_design_panels *p = wcut_alloc(1, sizeof *p);
    if (!p) return NULL;
    p->across = across, p->along = along, p->count = across * along;
    p->joints = (across - 1) * along + across * (along - 1);
    p->panel = wcut_alloc((size_t)p->count, sizeof *p->panel);
    p->joint = wcut_alloc((size_t)p->joints, sizeof *p->joint);
    if (!p->panel || !p->joint) {
        wcut_design_panels_destroy(p);
        return NULL;
    }

    /* places, and who meets whom */
    int n = 0;
    for (int k = 0; k < p->count; k++) {
        put_panel_place(t, p, k, &p->panel[k]);
        if (k % across + 1 < across) p->joint[n++] = (wcut_design_joint){.first = k, .second = k + 1};
        if (k / across + 1 < along) p->joint[n++] = (wcut_design_joint){.first = k, .second = k + across};
    }
    return p;
}

void wcut_design_panels_destroy(wcut_design_panels *p) {
    if (!p) return;
    for (int k = 0; p->panel && k < p->count; k++) wcut_design_destroy(p->panel[k].design);
    wcut_free(p->panel);
    wcut_free(p->joint);
    wcut_free(p);
}

/* what its maps promise: the rms of all panels */
static wcut_status predict_division(const wcut_design_target *t, const wcut_design_options *o, wcut_design_panels *p,
                                    double *rms) {
    double sum = 0;
    for (int k = 0; k < p->count; k++) {
        wcut_design_panel *panel = &p->panel[k];
        wcut_design_target *part = NULL;
        wcut_design_feed feed;
        double by_feed[5];
        wcut_status status = wcut_design_target_window(t, panel->low, panel->high, &part);
        if (status == WCUT_OK) status = wcut_design_choose_feed(part, o, by_feed, &feed);
        wcut_design_target_destroy(part);
        if (status != WCUT_OK) return status;
        panel->predicted_rms = by_feed[feed];
        sum += by_feed[feed] * by_feed[feed];
    }
    *rms = sqrt(sum / p->count);
    return WCUT_OK;
}

/* of the divisions into so many panels the one that promises the least */
static wcut_status choose_division(const wcut_design_target *t, const wcut_design_options *o, int count,
                                   wcut_design_panels **best, double *lowest) {
    wcut_status status = WCUT_OK;
    *lowest = HUGE_VAL;
    for (int across = count; across >= 1 && status == WCUT_OK; across--) {
        double rms = HUGE_VAL;
        if (count % across) continue;
        wcut_design_panels *p = create_division(t, across, count / across);
        status = p ? predict_division(t, o, p, &rms) : WCUT_NO_MEMORY;
        if (status == WCUT_OK && (!*best || rms < *lowest)) {
            wcut_design_panels *other = *best;
            *best = p, p = other;
            *lowest = rms;
        }
        wcut_design_panels_destroy(p);
    }
    return status;
}

/* ---- its designs ---- */

/* the job of one panel: its own block, a name with its number */
static wcut_status design_panel(const wcut_design_target *t, const wcut_job *job, const wcut_design_options *o,
                                wcut_design_progress progress, void *context, wcut_design_panel *panel,
                                wcut_error *error) {
    wcut_design_target *part = NULL;
    wcut_job *own = wcut_job_copy(job);
    wcut_status status = own ? wcut_design_target_window(t, panel->low, panel->high, &part) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        own->block_size = part->block;
        status = wcut_design_fit(part, own, o, progress, context, &panel->design, error);
    }
    wcut_design_target_destroy(part);
    wcut_job_destroy(own);
    return status;
}

/* WCUT_INTERRUPTED: stopped; *whole where all panels have a design even so */
static wcut_status design_panels(const wcut_design_target *t, const wcut_job *job, const wcut_design_options *o,
                                 wcut_design_progress progress, void *context, wcut_design_panels *p, bool *whole,
                                 wcut_error *error) {
    double sum = 0;
    long used = 0;
    wcut_status status = WCUT_OK;
    *whole = false;
    for (int k = 0; k < p->count; k++) {
        if (status == WCUT_OK) status = design_panel(t, job, o, progress, context, &p->panel[k], error);
        const wcut_design *d = p->panel[k].design;
        if (!d) return status;
        p->runs += d->runs;
        sum += d->path_rms * d->path_rms * d->used;
        used += d->used;
        p->max = fmax(p->max, d->path_max);
    }
    p->rms = used > 0 ? sqrt(sum / (double)used) : HUGE_VAL;
    *whole = true;
    return status;
}

/* ---- joints ---- */

/* places along a joint, on the target's height */
static void lay_joint(const wcut_design_target *t, const wcut_design_panel *first, const wcut_design_panel *second,
                      wcut_vec3 place[JOINT_PLACES]) {
    const bool beside = second->low.x > first->low.x;
    for (int k = 0; k < JOINT_PLACES; k++) {
        const double share = (k + 0.5) / JOINT_PLACES;
        const double x = beside ? second->low.x : first->low.x + share * (first->high.x - first->low.x);
        const double y = beside ? first->low.y + share * (first->high.y - first->low.y) : second->low.y;
        place[k] = vec3(x, y, wcut_heights_eval(&t->heights, x, y).z);
    }
}

/* a direction of a design's frame in that of the panel's block */
static wcut_vec3 turn_panel_back(wcut_design_feed feed, wcut_vec3 v) {
    if (feed == WCUT_DESIGN_FEED_MINUS_Y) return vec3(-v.x, -v.y, v.z);
    if (feed == WCUT_DESIGN_FEED_PLUS_X) return vec3(v.y, -v.x, v.z);
    if (feed == WCUT_DESIGN_FEED_MINUS_X) return vec3(-v.y, v.x, v.z);
    return v;
}

/* the feet of places of the target's block on the face that a panel's path cuts */
static wcut_status find_panel_feet(const wcut_design_panel *panel, int threads, int count, const wcut_vec3 *place,
                                   wcut_wire_foot *foot) {
    const wcut_design *d = panel->design;
    wcut_vec3 point[JOINT_PLACES];
    wcut_design_target only = {.block = d->path->block_size, .count = count, .point = point};
    for (int k = 0; k < count; k++)
        point[k] = wcut_design_turn(d->feed, vec3_sub(panel->high, panel->low), vec3_sub(place[k], panel->low));

    /* a trial without a correction */
    wcut_setup *setup = NULL;
    wcut_trial trial;
    wcut_reached reached;
    const wcut_design_curves none = {.coefficients = 4, .free_edges = true};
    wcut_status status = wcut_setup_create(d->path, NULL, &setup, NULL);
    if (status != WCUT_OK) return status;
    status = wcut_trial_create_path(&only, setup, threads, d->path->nodes, 4 * WCUT_DESIGN_CURVES, &trial);
    if (status == WCUT_OK) {
        status = wcut_trial_eval(&trial, &none, NULL, NULL, &reached);
        if (status == WCUT_OK) memcpy(foot, trial.foot, (size_t)count * sizeof *foot);
        wcut_trial_destroy(&trial);
    }
    wcut_setup_destroy(setup);
    return status;
}

static wcut_status measure_joint(const wcut_design_target *t, const wcut_design_panels *p, int threads,
                                 wcut_design_joint *joint) {
    wcut_vec3 place[JOINT_PLACES];
    wcut_wire_foot foot[2][JOINT_PLACES];
    const wcut_design_panel *panel[2] = {&p->panel[joint->first], &p->panel[joint->second]};
    lay_joint(t, panel[0], panel[1], place);
    for (int side = 0; side < 2; side++) {
        const wcut_status status = find_panel_feet(panel[side], threads, JOINT_PLACES, place, foot[side]);
        if (status != WCUT_OK) return status;
    }

    /* heights of the same place over both faces, and their normals in one frame */
    double steps = 0, angles = 0;
    for (int k = 0; k < JOINT_PLACES; k++) {
        if (foot[0][k].beside > BESIDE || foot[1][k].beside > BESIDE) continue;
        const wcut_vec3 a = turn_panel_back(panel[0]->design->feed, foot[0][k].normal);
        const wcut_vec3 b = turn_panel_back(panel[1]->design->feed, foot[1][k].normal);
        const double step = foot[0][k].height - foot[1][k].height;
        const double angle = atan2(vec3_length(vec3_cross(a, b)), vec3_dot(a, b));
        steps += step * step, angles += angle * angle;
        joint->step_max = fmax(joint->step_max, fabs(step));
        joint->angle_max = fmax(joint->angle_max, angle);
        joint->places++;
    }
    if (joint->places > 0) {
        joint->step_rms = sqrt(steps / joint->places);
        joint->angle_rms = sqrt(angles / joint->places);
    }
    return WCUT_OK;
}

/* ---- the search ---- */

wcut_status wcut_design_panels_fit(const wcut_design_target *target, const wcut_job *job,
                                   const wcut_design_options *options, int most, double held,
                                   wcut_design_progress progress, void *context, wcut_design_panels **panels,
                                   wcut_error *error) {
    const wcut_design_options o = options ? *options : wcut_design_options_default();
    wcut_status status = wcut_design_check(target, job, &o, panels, error);
    if (status != WCUT_OK) return status;
    if (most < 1 || most > WCUT_DESIGN_PANELS_MAX || !is_positive(held))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "1 to %d panels and a positive tolerance are expected",
                         WCUT_DESIGN_PANELS_MAX);

    /* numbers of panels one after the other, the last one in any case */
    wcut_design_panels *best = NULL;
    int runs = 0;
    for (int count = 1; count <= most && status == WCUT_OK && !(best && best->rms <= held); count++) {
        wcut_design_panels *next = NULL;
        double promised;
        bool whole = false;
        status = choose_division(target, &o, count, &next, &promised);
        const bool hopeless = promised > HOPE * held && (count < most || best);
        if (status == WCUT_OK && next && !hopeless)
            status = design_panels(target, job, &o, progress, context, next, &whole, error);
        if (next) runs += next->runs;

        /* a division of which a panel has no cut is none; the last one is the answer where there is no other */
        const bool none = status == WCUT_NOT_CONVERGED || status == WCUT_DEGENERATE || status == WCUT_SINGULAR;
        if (none && (count < most || best)) status = WCUT_OK, whole = false;
        if (whole && next && !(best && best->rms <= next->rms)) {
            wcut_design_panels *other = best;
            best = next, next = other;
        }
        wcut_design_panels_destroy(next);
    }

    /* a search that is stopped hands out what is whole */
    const bool stopped = status == WCUT_INTERRUPTED;
    if (stopped && best) status = WCUT_OK;
    if (status == WCUT_OK && !best) status = WCUT_NOT_CONVERGED;
    for (int k = 0; status == WCUT_OK && best && k < best->joints; k++)
        status = measure_joint(target, best, o.threads, &best->joint[k]);
    if (status != WCUT_OK || !best) {
        wcut_design_panels_destroy(best);
        return status == WCUT_NO_MEMORY ? wcut_fail(error, status, "no memory for panels") : status;
    }
    best->runs = runs;
    *panels = best;
    return stopped ? wcut_fail(error, WCUT_INTERRUPTED, "stopped on request after %d runs", runs) : WCUT_OK;
}
