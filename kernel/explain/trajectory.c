/* A trajectory: where the mounts of a cut were when, and under which heat; and the wire driven along it. */
#include "explain/trajectory.h"

#include <string.h>
#include <wirecut/cut.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/active_effects.h"
#include "cut/track.h"

/* against 1e-10 a tension moves by 1e-5 N in the mean, a thousandth of a sensor noise */
#define TOLERANCE 1e-6
/* a step is cut into 2^this at most, and so many steps in a row that fail end the run: a wire drawn taut, by a length that
   is tried, would cost thousands of solves a sample */
enum { HALVINGS = 5, GIVE_UP = 12 };
/* [s] steps of a recorded motion: samples that come closer are stepped over and interpolated, longer waits are cut up. The
   implicit step answers for its middle, and its tensions are given that time; against steps of 0.05 s a tension moves by
   0.002 N, a tenth of a sensor's noise, and a case takes half the time. */
#define SHORTEST 0.095
#define LONGEST 0.11
/* stations that a step must advance: below, the mounts stand and the wire keeps its shape */
#define STANDING 1e-4

void wcut_trajectory_destroy(wcut_trajectory *trajectory) {
    wcut_free(trajectory->time);
    wcut_free(trajectory->station);
    wcut_free(trajectory->heat);
    wcut_free(trajectory->sample);
    *trajectory = (wcut_trajectory){0};
}

static bool trajectory_create(int count, bool sampled, wcut_trajectory *trajectory) {
    const size_t n = (size_t)count;
    *trajectory = (wcut_trajectory){.count = count,
                                    .time = wcut_alloc(n, sizeof(double)),
                                    .station = wcut_alloc(n, sizeof(double)),
                                    .heat = wcut_alloc(n, sizeof(double)),
                                    .sample = sampled ? wcut_alloc(n, sizeof(int)) : NULL};
    if (trajectory->time && trajectory->station && trajectory->heat && (!sampled || trajectory->sample)) return true;
    wcut_trajectory_destroy(trajectory);
    return false;
}

double wcut_between(int n, const double *x, const double *y, double at) {
    if (!(at > x[0])) return y[0];
    if (at >= x[n - 1]) return y[n - 1];
    int low = 0, high = n - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (x[middle] <= at)
            low = middle;
        else
            high = middle;
    }
    const double width = x[high] - x[low];
    return width > 0 ? y[low] + (y[high] - y[low]) * (at - x[low]) / width : y[low];
}

/* ---- motion ---- */

/* programmed speed over the plan's, never backwards: progress is a function of its integral */
static double programmed_pace(const wcut_job *job, double time) { return fmax(wcut_job_pace_eval(job, time), 0.05); }

wcut_status wcut_trajectory_recorded(const wcut_job *job, const wcut_recording *recording, double window,
                                     wcut_trajectory *out, wcut_error *error) {
    wcut_track track = {0};

    /* the times at which the mounts were at which station, smoothed over the window */
    const wcut_replay_options options = {.motion = WCUT_MOTION_STATION, .window = window};
    const wcut_status status = wcut_track_create(job, recording, &options, &track, error);
    if (status != WCUT_OK) return status;
    wcut_trajectory trajectory = {0};
    wcut_status made = WCUT_OK;
    if (track.count < 8)
        made = wcut_fail(error, WCUT_BAD_ARGUMENT, "found %d samples with a station, expected 8 or more", track.count);
    else if (!trajectory_create(track.count, true, &trajectory))
        made = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a motion of %d samples", track.count);

    /* heat of each sample: recorded, or the last one recorded, or the job's */
    if (made == WCUT_OK) {
        const wcut_column *heat = &recording->channel[WCUT_CHANNEL_HEAT];
        double last = wcut_job_heat_eval(job, track.time[0]);
        for (int i = 0; i < track.count; i++) {
            const int sample = track.sample[i];
            const bool there = heat->name && (!heat->present || heat->present[sample]) && heat->value[sample] > 0;
            if (!heat->name)
                last = wcut_job_heat_eval(job, track.time[i]);
            else if (there)
                last = heat->value[sample];
            trajectory.time[i] = track.time[i], trajectory.station[i] = track.station[i], trajectory.heat[i] = last;
            trajectory.sample[i] = sample;
        }
        *out = trajectory;
    }

    /* release the track */
    wcut_track_destroy(&track);
    return made;
}

wcut_status wcut_trajectory_exogenous(const wcut_job *job, const wcut_trajectory *recorded, double width, double step,
                                      wcut_trajectory *out) {
    const int n = recorded->count;

    /* samples evenly in time */
    const double begun = recorded->time[0], length = recorded->time[n - 1] - begun;
    const int count = (int)fmin(floor(length / step), 1e7) + 1;
    double *programme = wcut_alloc((size_t)n, sizeof *programme), *smooth = wcut_alloc((size_t)n, sizeof *smooth);
    wcut_trajectory trajectory = {0};
    if (!programme || !smooth || count < 2 || !trajectory_create(count, false, &trajectory)) {
        wcut_free(programme);
        wcut_free(smooth);
        return count < 2 ? WCUT_BAD_ARGUMENT : WCUT_NO_MEMORY;
    }

    /* programmed progress: the integral of the programmed pace */
    for (int i = 1; i < n; i++) {
        const double middle = (recorded->time[i] + recorded->time[i - 1]) / 2;
        programme[i] = programme[i - 1] + (recorded->time[i] - recorded->time[i - 1]) * programmed_pace(job, middle);
    }

    /* smooth the recorded progress as a function of the programmed one, so that the programme's part stays */
    wcut_smooth(n, programme, recorded->station, width, smooth);

    /* progress never runs backwards */
    double furthest = 0;
    for (int i = 0; i < n; i++) furthest = smooth[i] = clamp(smooth[i], furthest, job->stations - 1);

    /* sample it */
    for (int i = 0; i < count; i++) {
        trajectory.time[i] = begun + i * step;
        trajectory.station[i] = wcut_between(n, recorded->time, smooth, trajectory.time[i]);
        trajectory.heat[i] = wcut_between(n, recorded->time, recorded->heat, trajectory.time[i]);
    }
    wcut_free(programme);
    wcut_free(smooth);
    *out = trajectory;

    return WCUT_OK;
}

wcut_status wcut_trajectory_thin(const wcut_trajectory *recorded, double step, wcut_trajectory *out) {
    const int n = recorded->count;
    const int count = (int)fmin(floor((recorded->time[n - 1] - recorded->time[0]) / step), 1e7) + 1;
    wcut_trajectory trajectory = {0};
    if (count < 2) return WCUT_BAD_ARGUMENT;
    if (!trajectory_create(count, false, &trajectory)) return WCUT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        trajectory.time[i] = recorded->time[0] + i * step;
        trajectory.station[i] = wcut_between(n, recorded->time, recorded->station, trajectory.time[i]);
        trajectory.heat[i] = wcut_between(n, recorded->time, recorded->heat, trajectory.time[i]);
    }
    *out = trajectory;
    return WCUT_OK;
}

/* ---- driving ---- */

void wcut_response_destroy(wcut_response *driven) {
    for (int k = 0; k < WCUT_SIGNALS; k++) wcut_free(driven->signal[k]);
    wcut_free(driven->engaged);
    wcut_free(driven->present);
    wcut_free(driven->position);
    wcut_free(driven->speed);
    *driven = (wcut_response){0};
}

static bool response_create(int count, int nodes, bool positions, wcut_response *d) {
    const size_t n = (size_t)count, all = n * (size_t)nodes;
    *d = (wcut_response){.count = count, .nodes = nodes};
    bool whole = true;
    for (int k = 0; k < WCUT_SIGNALS; k++) whole = (d->signal[k] = wcut_alloc(n, sizeof(double))) && whole;
    d->engaged = wcut_alloc(n, sizeof(double));
    d->present = wcut_alloc(n, 1);
    if (positions) d->position = wcut_alloc(all, sizeof *d->position), d->speed = wcut_alloc(all, sizeof *d->speed);
    if (whole && d->engaged && d->present && (!positions || (d->position && d->speed))) return true;
    wcut_response_destroy(d);
    return false;
}

typedef struct driver {
    const wcut_job *job;
    const wcut_trajectory *trajectory;
    wcut_cut *cut;
    double time, station;
    double *middle; /* count [s] of a sample's last step; NULL for an exogenous trajectory, where differences count */
    int last;       /* the sample before that was driven */
} driver;

/* mean heat of the samples behind the last one that was driven */
static double heat_of(const driver *d, int i) {
    double sum = 0;
    for (int k = d->last + 1; k <= i; k++) sum += d->trajectory->heat[k];
    return sum / (i - d->last);
}

static bool driver_advance(driver *d, int i) {
    const wcut_trajectory *t = d->trajectory;
    const double wait = t->sample ? (t->time[i] - d->time) / LONGEST : 1; /* an exogenous one is for differences */
    const int steps = (int)clamp(ceil(fmax(wait, t->station[i] - d->station)), 1, 1e6);
    const double from = d->station, begun = d->time, duration = (t->time[i] - begun) / steps, heat = heat_of(d, i);
    for (int k = 1; k <= steps; k++) {
        const double s = k == steps ? t->station[i] : from + (t->station[i] - from) * k / steps;
        const wcut_vec3 a = wcut_path_at(d->job->stations, d->job->mount_a, s);
        const wcut_vec3 b = wcut_path_at(d->job->stations, d->job->mount_b, s);
        if (wcut_cut_drive(d->cut, a, b, duration, heat, NULL) != WCUT_OK) return false;
        d->station = s, d->time = begun + k * duration;
    }
    if (d->middle) d->middle[i] = t->time[i] - duration / 2;
    d->last = i;
    return true;
}

static void keep_response(const driver *d, int i, wcut_response *out) {
    wcut_station s;
    wcut_cut_view(d->cut, &s);
    const double value[WCUT_SIGNALS] = {s.tension_a, s.tension_b, s.alpha_a, s.beta_a, s.alpha_b, s.beta_b};
    for (int k = 0; k < WCUT_SIGNALS; k++) out->signal[k][i] = value[k];
    out->engaged[i] = s.engaged_length;
    out->present[i] = 1;
    if (!out->position) return;
    memcpy(out->position + (size_t)i * (size_t)out->nodes, s.position, (size_t)out->nodes * sizeof *s.position);
    memcpy(out->speed + (size_t)i * (size_t)out->nodes, s.speed, (size_t)out->nodes * sizeof *s.speed);
}

/* the wire leaves station 0 so early that it reaches the first sample at the pace of the first second */
static void driver_begin(driver *d) {
    const wcut_trajectory *t = d->trajectory;
    int i = 1;
    while (i < t->count - 1 && t->time[i] - t->time[0] < 1) i++;
    const double pace = (t->station[i] - t->station[0]) / (t->time[i] - t->time[0]);
    d->station = 0;
    d->time = t->time[0] - fmax(t->station[0], 0.2) / fmax(pace, 0.1);
}

/* a sample between two that were driven: on the line between them */
static void response_between(const driver *d, int low, int high, int i, wcut_response *out) {
    const double *time = d->trajectory->time, share = (time[i] - time[low]) / (time[high] - time[low]);
    for (int k = 2; k < WCUT_SIGNALS; k++)
        out->signal[k][i] = (1 - share) * out->signal[k][low] + share * out->signal[k][high];
    out->engaged[i] = (1 - share) * out->engaged[low] + share * out->engaged[high];
    out->present[i] = 1;
    if (!out->position) return;
    const size_t n = (size_t)out->nodes;
    for (size_t k = 0; k < n; k++) {
        out->position[(size_t)i * n + k] =
            vec3_mix(out->position[(size_t)low * n + k], out->position[(size_t)high * n + k], share);
        out->speed[(size_t)i * n + k] =
            (1 - share) * out->speed[(size_t)low * n + k] + share * out->speed[(size_t)high * n + k];
    }
}

/* samples that were stepped over, and tensions at the middle of their steps; room: count */
static void fill_between(const driver *d, double *room, int *driven, wcut_response *out) {
    int count = 0;
    for (int i = 0; i < out->count; i++)
        if (out->present[i]) driven[count++] = i;
    for (int k = 0; k + 1 < count; k++) /* behind a failure nothing is known */
        for (int i = driven[k] + 1; i < driven[k + 1] && out->present[i] == 0; i++)
            if (d->trajectory->time[driven[k + 1]] - d->trajectory->time[driven[k]] < 2 * LONGEST)
                response_between(d, driven[k], driven[k + 1], i, out);

    /* tensions on the line through the middles of the steps, both mounts */
    for (int s = 0; s < 2 && count > 1; s++) {
        double *value = out->signal[s];
        for (int k = 0; k < count; k++) room[k] = value[driven[k]];
        for (int i = 0, k = 0; i < out->count; i++) {
            if (!out->present[i]) continue;
            while (k < count - 2 && d->middle[driven[k + 1]] <= d->trajectory->time[i]) k++;
            const double from = d->middle[driven[k]], to = d->middle[driven[k + 1]];
            const double share = to > from ? fmin((d->trajectory->time[i] - from) / (to - from), 1.5) : 1;
            value[i] = share <= 0 ? room[k] : (1 - share) * room[k] + share * room[k + 1];
        }
    }
}

/* false where it was stopped */
static bool drive(driver *d, wcut_stop *stop, wcut_response *out) {
    const wcut_trajectory *t = d->trajectory;
    driver_begin(d);
    wcut_cut_set_clock(d->cut, d->time);
    d->last = -1;
    for (int i = 0, failed = 0; i < t->count && failed < GIVE_UP; i++) {
        if (wcut_stop_asked(stop)) return false;
        if (d->middle && i > 0 && i < t->count - 1 && t->time[i] - d->time < SHORTEST) continue;
        if (d->middle) d->middle[i] = t->time[i];
        const bool there = t->station[i] - d->station < STANDING ? i > 0 : driver_advance(d, i);
        if (there) keep_response(d, i, out);
        failed = there ? 0 : failed + 1;
    }
    return true;
}

wcut_status wcut_response_run(const wcut_job *job, int nodes, const wcut_trajectory *trajectory, bool positions,
                              wcut_stop *stop, wcut_response *out, wcut_error *error) {
    /* the same job with fewer nodes and looser tolerances */
    wcut_job coarse = *job; /* borrowed arrays: the setup copies them */
    coarse.nodes = nodes;
    wcut_cut_options options = wcut_cut_options_default();
    options.tolerance = TOLERANCE;
    options.max_halvings = HALVINGS;
    wcut_setup *setup = NULL;
    driver d = {.job = job, .trajectory = trajectory};
    wcut_response driven = {0};

    /* a cut that is led along the trajectory */
    wcut_status status = wcut_setup_create(&coarse, &options, &setup, error);
    if (status == WCUT_OK) status = wcut_cut_create(setup, &d.cut, error);
    if (status == WCUT_OK && !response_create(trajectory->count, nodes, positions, &driven))
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d samples", trajectory->count);

    /* along the recorded motion tensions count at the middle of each step */
    double *room = NULL;
    int *index = NULL;
    if (status == WCUT_OK && trajectory->sample) {
        d.middle = wcut_alloc((size_t)trajectory->count, sizeof *d.middle);
        room = wcut_alloc((size_t)trajectory->count, sizeof *room);
        index = wcut_alloc((size_t)trajectory->count, sizeof *index);
        if (!d.middle || !room || !index) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a motion");
    }

    /* drive, then fill in the samples between */
    if (status == WCUT_OK && !drive(&d, stop, &driven)) status = wcut_fail(error, WCUT_INTERRUPTED, "interrupted");
    if (status == WCUT_OK && d.middle && room && index) fill_between(&d, room, index, &driven);
    wcut_free(index);
    wcut_free(room);
    wcut_free(d.middle);

    /* hand over, or release */
    if (status == WCUT_OK)
        *out = driven;
    else
        wcut_response_destroy(&driven);

    wcut_cut_destroy(d.cut);
    wcut_setup_destroy(setup);
    return status;
}
