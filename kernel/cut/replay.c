/* A recording predicted sample by sample: from a plan by its stations, and by driving the wire along its motion. */
#include <wirecut/replay.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/active_effects.h"
#include "cut/setup.h"
#include "cut/track.h"

enum { SPEED_A, SPEED_B, TENSION_A, TENSION_B, ALPHA_A, BETA_A, ALPHA_B, BETA_B };

/* mounts slower than this share of the job's least speed stand: the step is left to the next sample */
#define STANDING 0.01

wcut_replay_options wcut_replay_options_default(void) {
    return (wcut_replay_options){.motion = WCUT_MOTION_STATION, .window = 0.5};
}

void wcut_prediction_destroy(wcut_prediction *p) {
    if (!p) return;
    wcut_free(p->present);
    for (int k = 0; k < WCUT_SIGNAL_COUNT; k++) wcut_free(p->value[k]);
    wcut_free(p);
}

static wcut_prediction *create_prediction(int samples) {
    wcut_prediction *p = wcut_alloc(1, sizeof *p);
    if (!p) return NULL;
    *p = (wcut_prediction){.samples = samples, .first_failed = -1};
    p->present = wcut_alloc((size_t)samples, sizeof *p->present);
    bool whole = p->present != NULL;
    for (int k = 0; k < WCUT_SIGNAL_COUNT; k++) {
        p->value[k] = wcut_alloc((size_t)samples, sizeof *p->value[k]);
        whole = whole && p->value[k];
    }
    if (whole) return p;
    wcut_prediction_destroy(p);
    return NULL;
}

static void note_failure(wcut_prediction *p, int sample, const wcut_error *cause) {
    if (p->failed++ > 0) return;
    p->first_failed = sample;
    p->cause = *cause;
}

static wcut_status check_replay(const void *from, const wcut_recording *recording, const void *to, wcut_error *error) {
    if (from && recording && recording->samples > 0 && recording->further && to) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "a plan or setup, a recording and a place for the prediction expected");
}

/* ---- planned ---- */

static double lerp(double a, double b, double t) { return (1 - t) * a + t * b; }

static void plan_signals_at(const wcut_history *plan, double station, double value[WCUT_SIGNAL_COUNT]) {
    const int last = plan->stations - 1;
    const int j = (int)clamp(floor(station), 0, last), k = j < last ? j + 1 : j;
    const wcut_history_row *a = &plan->row[j], *b = &plan->row[k];
    const double t = station - j;
    value[TENSION_A] = lerp(a->tension_a, b->tension_a, t);
    value[TENSION_B] = lerp(a->tension_b, b->tension_b, t);
    value[ALPHA_A] = lerp(a->alpha_a, b->alpha_a, t);
    value[BETA_A] = lerp(a->beta_a, b->beta_a, t);
    value[ALPHA_B] = lerp(a->alpha_b, b->alpha_b, t);
    value[BETA_B] = lerp(a->beta_b, b->beta_b, t);
    /* the speed of row j is that of the step from j-1 to j */
    const double middle = clamp(station + 0.5, 1, last > 1 ? last : 1);
    const int i = (int)fmin(floor(middle), last), next = i < last ? i + 1 : i;
    value[SPEED_A] = lerp(plan->row[i].speed_a, plan->row[next].speed_a, middle - i);
    value[SPEED_B] = lerp(plan->row[i].speed_b, plan->row[next].speed_b, middle - i);
}

wcut_status wcut_prediction_plan(const wcut_history *plan, const wcut_recording *recording,
                                 wcut_prediction **prediction, wcut_error *error) {
    /* check the plan and the stations of the recording */
    wcut_status status = check_replay(plan, recording, prediction, error);
    if (status == WCUT_OK && (plan->stations < 1 || plan->planned < 2 || !plan->row))
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "found a plan without stations, expected at least one");
    if (status == WCUT_OK) status = wcut_track_check(plan->planned, recording, error);
    if (status != WCUT_OK) return status;

    /* a prediction with as many samples as the recording */
    wcut_prediction *p = create_prediction(recording->samples);
    if (!p) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d samples", recording->samples);
    const wcut_column *station = &recording->channel[WCUT_CHANNEL_STATION];
    wcut_error cause = {0};
    wcut_fail(&cause, WCUT_NOT_CONVERGED, "the planned run ended at station %d of %d", plan->stations - 1,
              plan->planned - 1);

    /* each sample: none without a station, a failure beyond the plan's end, else interpolated between stations */
    for (int i = 0; i < recording->samples; i++) {
        if (station->present && !station->present[i]) {
            p->without_motion++;
            continue;
        }
        const double s = clamp(station->value[i], 0, plan->planned - 1);
        if (s > plan->stations - 1) {
            note_failure(p, i, &cause);
            continue;
        }
        double value[WCUT_SIGNAL_COUNT];
        plan_signals_at(plan, s, value);
        for (int k = 0; k < WCUT_SIGNAL_COUNT; k++) p->value[k][i] = value[k];
        p->present[i] = 1;
    }

    *prediction = p;

    return WCUT_OK;
}

/* ---- replayed ---- */

typedef struct replay {
    const wcut_job *job;
    const wcut_recording *recording;
    const wcut_track *track;
    wcut_cut *cut;
    wcut_prediction *out;
    /* where the wire is */
    double time, station, heat;
    wcut_vec3 mount_a, mount_b;
} replay;

/* heat over the step that ends at a sample: recorded, or the last one recorded, or the job's */
static double recorded_heat(const replay *r, int sample) {
    const wcut_column *heat = &r->recording->channel[WCUT_CHANNEL_HEAT];
    const double time = r->recording->channel[WCUT_CHANNEL_TIME].value[sample];
    if (!heat->name) return wcut_job_heat_eval(r->job, time);
    return !heat->present || heat->present[sample] ? heat->value[sample] : r->heat;
}

/* how far a mount is beside its path: 0 but for measured positions */
static wcut_vec3 path_offset(const replay *r, const wcut_vec3 *path, double station, wcut_vec3 mount) {
    return vec3_sub(mount, wcut_path_at(r->job->stations, path, station));
}

/* Lead the wire to the track's sample i, by one station of the path at most at once; where the solver fails, it stays
   at the last place that was reached. */
static wcut_status lead_mounts(replay *r, int i, wcut_error *error) {
    const wcut_track *t = r->track;
    const wcut_job *job = r->job;

    /* as many sub-steps as there are stations to pass */
    const int steps = (int)fmax(1, ceil(t->station[i] - r->station));
    const double from = r->station, begun = r->time, duration = (t->time[i] - begun) / steps;

    /* how far the mounts are beside the path at both ends */
    const wcut_vec3 side_a[2] = {path_offset(r, job->mount_a, from, r->mount_a),
                                 path_offset(r, job->mount_a, t->station[i], t->mount_a[i])};
    const wcut_vec3 side_b[2] = {path_offset(r, job->mount_b, from, r->mount_b),
                                 path_offset(r, job->mount_b, t->station[i], t->mount_b[i])};

    /* lead: along the path, and beside it by the share of the way */
    for (int k = 1; k <= steps; k++) {
        const bool there = k == steps;
        const double share = (double)k / steps, s = there ? t->station[i] : lerp(from, t->station[i], share);
        const wcut_vec3 a =
            vec3_add(wcut_path_at(job->stations, job->mount_a, s), vec3_mix(side_a[0], side_a[1], share));
        const wcut_vec3 b =
            vec3_add(wcut_path_at(job->stations, job->mount_b, s), vec3_mix(side_b[0], side_b[1], share));
        const wcut_status status =
            wcut_cut_drive(r->cut, there ? t->mount_a[i] : a, there ? t->mount_b[i] : b, duration, r->heat, error);
        if (status != WCUT_OK) return status;

        /* the last place that was reached is where the next step begins */
        wcut_station view;
        wcut_cut_view(r->cut, &view);
        r->out->iterations += view.iterations;
        r->station = s;
        r->mount_a = view.mount_a, r->mount_b = view.mount_b;
        r->time = there ? t->time[i] : begun + k * duration;
    }

    return WCUT_OK;
}

static void keep_sample(replay *r, int sample) {
    wcut_station s;
    wcut_cut_view(r->cut, &s);
    const double value[WCUT_SIGNAL_COUNT] = {s.speed_a, s.speed_b, s.tension_a, s.tension_b,
                                             s.alpha_a, s.beta_a,  s.alpha_b,   s.beta_b};
    for (int k = 0; k < WCUT_SIGNAL_COUNT; k++) r->out->value[k][sample] = value[k];
    r->out->present[sample] = 1;
}

/* stations a second over the first second of the track; 0 where it stands */
static double first_pace(const wcut_track *t) {
    int i = 0;
    while (i < t->count - 1 && t->time[i] - t->time[0] < 1) i++;
    return i > 0 ? (t->station[i] - t->station[0]) / (t->time[i] - t->time[0]) : 0;
}

/* Station 0, where the wire hangs, at such a time that the way to the first sample is gone at the first second's pace:
   the recording does not say when it left. */
static void replay_begin(replay *r) {
    const wcut_track *t = r->track;
    const double pace = first_pace(t);
    r->mount_a = r->job->mount_a[0], r->mount_b = r->job->mount_b[0];
    r->heat = wcut_job_heat_eval(r->job, t->time[0]);
    const double way = fmax(vec3_distance(r->mount_a, t->mount_a[0]), vec3_distance(r->mount_b, t->mount_b[0]));
    r->time = t->time[0] - (pace > 0 && t->station[0] > 0 ? t->station[0] / pace : way / r->job->speed_max);
}

static wcut_status check_heat(const wcut_recording *recording, wcut_error *error) {
    const wcut_column *heat = &recording->channel[WCUT_CHANNEL_HEAT];
    for (int i = 0; heat->name && i < recording->samples; i++)
        if ((!heat->present || heat->present[i]) && !is_positive(heat->value[i]))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "line %d: heat_W_per_m: found %.6g, expected a positive power",
                             recording->further->line[i], heat->value[i]);
    return WCUT_OK;
}

/* whether the mounts have hardly moved since the last step: that step is left to a later sample */
static bool stands(const replay *r, int i) {
    const wcut_track *t = r->track;
    const double way = fmax(vec3_distance(r->mount_a, t->mount_a[i]), vec3_distance(r->mount_b, t->mount_b[i]));
    const double duration = t->time[i] - r->time;
    return !(duration > 0) || way < STANDING * r->job->speed_min * duration;
}

static void run_replay(replay *r) {
    replay_begin(r);
    wcut_cut_set_clock(r->cut, r->time);
    for (int i = 0; i < r->track->count; i++) {
        const int sample = r->track->sample[i];
        wcut_error cause = {0};
        r->heat = recorded_heat(r, sample);
        if (stands(r, i))
            r->out->standing++;
        else if (lead_mounts(r, i, &cause) == WCUT_OK)
            keep_sample(r, sample);
        else
            note_failure(r->out, sample, &cause);
    }
}

wcut_status wcut_prediction_replay(const wcut_setup *setup, const wcut_recording *recording,
                                   const wcut_replay_options *options, wcut_prediction **prediction,
                                   wcut_error *error) {
    /* check everything before the first allocation */
    const wcut_replay_options o = options ? *options : wcut_replay_options_default();
    wcut_status status = check_replay(setup, recording, prediction, error);
    if (status == WCUT_OK && (!(o.window >= 0 && isfinite(o.window)) || (unsigned)o.motion > WCUT_MOTION_POSITION))
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "a window of 0 s or more and a known motion are expected");
    if (status == WCUT_OK && setup->job->rig.kind == WCUT_RIG_KIND_BLADE)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT,
                           "found a blade, expected a wire: a blade has forces in place of tensions, see diagnose");
    if (status == WCUT_OK) status = check_heat(recording, error);

    /* the track of the mounts, smoothed */
    wcut_track track = {0};
    if (status == WCUT_OK) status = wcut_track_create(setup->job, recording, &o, &track, error);
    if (status != WCUT_OK) return status;

    /* a cut that is driven along it */
    replay r = {.job = setup->job, .recording = recording, .track = &track};
    status = wcut_cut_create(setup, &r.cut, error);
    if (status == WCUT_OK) {
        r.out = create_prediction(recording->samples);
        if (!r.out) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d samples", recording->samples);
    }

    /* run, then report what had no motion and what was smoothed away */
    if (status == WCUT_OK) {
        run_replay(&r);
        r.out->without_motion = recording->samples - track.count;
        r.out->scatter = track.scatter;
        *prediction = r.out;
    } else {
        wcut_prediction_destroy(r.out);
    }

    wcut_cut_destroy(r.cut);
    wcut_track_destroy(&track);
    return status;
}
