/* A cut predicted before it is made: the mounts moved over time as the plan and its programme have it, and what would be measured. */
#include "explain/predicted_cut.h"

#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"
#include "cut/track.h"

/* of the solver; two runs are subtracted, and what is left of it is far below any sensor's noise */
#define TOLERANCE 1e-7

/* ---- the schedule ---- */

typedef struct planned {
    wcut_job *job; /* without effects, with few nodes */
    wcut_setup *setup;
    wcut_history *history;
    double longest; /* [mm] engagement */
} planned;

static void destroy_planned(planned *p) {
    wcut_history_destroy(p->history);
    wcut_setup_destroy(p->setup);
    wcut_job_destroy(p->job);
}

static wcut_status plan(const wcut_job *job, planned *p, wcut_error *error) {
    *p = (planned){.job = wcut_job_copy(job)};
    if (!p->job) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a copy of a job");
    p->job->effect_count = 0;
    if (p->job->nodes > WCUT_PREDICTED_CUT_NODES) p->job->nodes = WCUT_PREDICTED_CUT_NODES;
    wcut_cut_options o = wcut_cut_options_default();
    o.tolerance = TOLERANCE;
    wcut_status status = wcut_setup_create(p->job, &o, &p->setup, error);
    if (status == WCUT_OK) status = wcut_setup_run(p->setup, NULL, NULL, &p->history, error);
    if (status != WCUT_OK) return status;
    for (int j = 0; j < p->history->stations; j++) p->longest = fmax(p->longest, p->history->row[j].engaged_length);
    if (p->longest > 0) return WCUT_OK;
    return wcut_fail(error, WCUT_DEGENERATE, "the planned run never touches the block, expected a cut");
}

/* a schedule ends, whatever was programmed */
static double pace_dither(const wcut_job *job, double time) { return fmax(wcut_job_pace_eval(job, time), 0.05); }

void wcut_schedule_destroy(wcut_schedule *s) {
    wcut_free(s->station);
    wcut_free(s->heat);
    wcut_free(s->engaged);
    wcut_free(s->speed);
    wcut_free(s->held);
    *s = (wcut_schedule){0};
}

static bool make_schedule(size_t room, wcut_schedule *s) {
    *s = (wcut_schedule){.station = wcut_alloc(room, sizeof *s->station),
                         .heat = wcut_alloc(room, sizeof *s->heat),
                         .engaged = wcut_alloc(room, sizeof *s->engaged),
                         .speed = wcut_alloc(room, sizeof *s->speed),
                         .held = wcut_alloc(room, sizeof *s->held)};
    return s->station && s->heat && s->engaged && s->speed && s->held;
}

/* where the mounts are a step later: each segment takes the plan's time, less or more by the dither */
static double next_mount_station(const planned *p, double station, double pace) {
    const int last = p->history->stations - 1;
    double left = WCUT_PREDICTED_CUT_STEP * pace;
    while (station < last) {
        const int j = (int)station;
        const double duration = p->history->row[j + 1].duration, rest = (j + 1 - station) * duration;
        if (left < rest) return station + left / duration;
        left -= rest;
        station = j + 1;
    }
    return last;
}

static double engaged_at(const planned *p, double station) {
    const int last = p->history->stations - 1, j = (int)fmin(station, last - 1);
    const wcut_history_row *row = p->history->row;
    return (row[j].engaged_length + (station - j) * (row[j + 1].engaged_length - row[j].engaged_length)) / p->longest;
}

/* walk the plan; false where `room` steps do not reach its end */
static bool walk_plan(const planned *p, int room, wcut_schedule *s) {
    const int last = p->history->stations - 1;
    double station = 0;
    for (s->count = 0; station < last; s->count++) {
        if (s->count == room) return false;
        const double time = s->count * WCUT_PREDICTED_CUT_STEP;
        const double pace = engaged_at(p, station) >= WCUT_MOST_OF_WIRE ? pace_dither(p->job, time) : 1;
        station = next_mount_station(p, station, pace);
        const wcut_history_row *row = &p->history->row[(int)fmin(station, last - 1) + 1];
        s->station[s->count] = station;
        s->heat[s->count] = wcut_job_heat_eval(p->job, time + WCUT_PREDICTED_CUT_STEP / 2);
        s->engaged[s->count] = engaged_at(p, station);
        s->speed[s->count] = fmax(row->speed_a, row->speed_b);
        s->held[s->count] = row->condition == WCUT_CONDITION_TENSION;
    }
    return true;
}

wcut_status wcut_schedule_create(const wcut_job *job, wcut_schedule *schedule, wcut_error *error) {
    if (!job || !schedule || job->mode != WCUT_MODE_PATH)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a job with the mounts' path is expected");
    planned p;
    wcut_schedule made = {0};

    /* the plan gives the speed at each place */
    wcut_status status = plan(job, &p, error);
    if (status == WCUT_OK) {
        /* room: twice the planned time is usual; a twentieth of the speed is the slowest that is walked */
        const double max = p.history->row[p.history->stations - 1].time / WCUT_PREDICTED_CUT_STEP / 0.05 + 2;
        const double usual = p.history->row[p.history->stations - 1].time / WCUT_PREDICTED_CUT_STEP * 2 + 100;
        if (!(max < 1e8))
            status = wcut_fail(error, WCUT_DEGENERATE, "the planned run takes %.3g s, expected a day at most",
                               p.history->row[p.history->stations - 1].time);
        else if (!make_schedule((size_t)fmin(max, usual), &made))
            status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for the schedule of a cut");
        else if (!walk_plan(&p, (int)fmin(max, usual), &made))
            status = wcut_fail(error, WCUT_DEGENERATE,
                               "the programmed speed takes more than twice the plan's time, expected a dither about 1");
    }

    /* hand over, or release */
    destroy_planned(&p);
    if (status == WCUT_OK)
        *schedule = made;
    else
        wcut_schedule_destroy(&made);

    return status;
}

/* ---- the run ---- */

void wcut_predicted_cut_destroy(wcut_predicted_cut *predicted) {
    wcut_free(predicted->present);
    for (int k = 0; k < WCUT_SENSED_COUNT; k++) wcut_free(predicted->value[k]);
    wcut_free(predicted->position);
    wcut_free(predicted->speed);
    wcut_free(predicted->inside);
    *predicted = (wcut_predicted_cut){0};
}

static bool make_predicted_cut(int count, int nodes, wcut_predicted_cut *r) {
    const size_t n = (size_t)count, all = n * (size_t)nodes;
    *r = (wcut_predicted_cut){.count = count,
                              .nodes = nodes,
                              .present = wcut_alloc(n, 1),
                              .position = wcut_alloc(all, sizeof *r->position),
                              .speed = wcut_alloc(all, sizeof *r->speed),
                              .inside = wcut_alloc(all, sizeof *r->inside)};
    bool whole = r->present && r->position && r->speed && r->inside;
    for (int k = 0; k < WCUT_SENSED_COUNT; k++) {
        r->value[k] = wcut_alloc(n, sizeof *r->value[k]);
        whole = whole && r->value[k];
    }
    return whole;
}

static void keep_reading(const wcut_cut *cut, int i, wcut_predicted_cut *r) {
    wcut_station s;
    wcut_cut_view(cut, &s);
    const double value[WCUT_SENSED_COUNT] = {s.speed_a, s.speed_b, s.tension_a, s.tension_b,
                                             s.alpha_a, s.beta_a,  s.alpha_b,   s.beta_b};
    const size_t n = (size_t)r->nodes, at = (size_t)i * n;
    for (int k = 0; k < WCUT_SENSED_COUNT; k++) r->value[k][i] = value[k];
    memcpy(r->position + at, s.position, n * sizeof *s.position);
    memcpy(r->speed + at, s.speed, n * sizeof *s.speed);
    memcpy(r->inside + at, s.engaged, n * sizeof *s.engaged);
    r->present[i] = 1;
}

/* false where it was stopped; a step that the solver does not take is missing, and the next one begins where the wire still is */
static bool follow_schedule(const wcut_job *job, const wcut_schedule *s, wcut_cut *cut, wcut_stop *stop,
                            wcut_predicted_cut *r) {
    double time = 0;
    for (int i = 0; i < s->count; i++) {
        if (wcut_stop_asked(stop)) return false;
        time += WCUT_PREDICTED_CUT_STEP;
        const wcut_vec3 a = wcut_path_at(job->stations, job->mount_a, s->station[i]);
        const wcut_vec3 b = wcut_path_at(job->stations, job->mount_b, s->station[i]);
        if (wcut_cut_drive(cut, a, b, time, s->heat[i], NULL) != WCUT_OK) continue;
        keep_reading(cut, i, r);
        time = 0;
    }
    return true;
}

static wcut_status sense_readings(const wcut_job *job, const wcut_predicted_cut *r, wcut_error *error) {
    double *time = wcut_alloc((size_t)r->count, sizeof *time);
    if (!time) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d samples", r->count);
    for (int i = 0; i < r->count; i++) time[i] = (i + 1) * WCUT_PREDICTED_CUT_STEP;
    const wcut_status status = wcut_sensors_eval(job->effect_count, job->effect, r->count, time, r->present, r->value);
    wcut_free(time);
    return status == WCUT_OK ? WCUT_OK : wcut_fail(error, status, "instruments: %s", wcut_status_text(status));
}

wcut_status wcut_predicted_cut_run(const wcut_job *job, const wcut_schedule *schedule, wcut_stop *stop,
                                   wcut_predicted_cut *predicted, wcut_error *error) {
    wcut_job *few = wcut_job_copy(job);
    wcut_setup *setup = NULL;
    wcut_cut *cut = NULL;
    wcut_predicted_cut made = {0};

    /* the wire needs few nodes, because only the readings count */
    if (!few) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a copy of a job");
    if (few->nodes > WCUT_PREDICTED_CUT_NODES) few->nodes = WCUT_PREDICTED_CUT_NODES;

    /* set up the cut without a record */
    wcut_cut_options o = wcut_cut_options_default();
    o.tolerance = TOLERANCE;
    wcut_status status = wcut_setup_create(few, &o, &setup, error);
    if (status == WCUT_OK) status = wcut_cut_create(setup, &cut, error);

    /* lead the mounts along the schedule, then turn the states into readings */
    if (status == WCUT_OK && !make_predicted_cut(schedule->count, few->nodes, &made))
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d samples", schedule->count);
    if (status == WCUT_OK && !follow_schedule(few, schedule, cut, stop, &made))
        status = wcut_fail(error, WCUT_INTERRUPTED, "interrupted");
    if (status == WCUT_OK) status = sense_readings(few, &made, error);

    /* release in the order opposite to the creation */
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    wcut_job_destroy(few);
    if (status == WCUT_OK)
        *predicted = made;
    else
        wcut_predicted_cut_destroy(&made);

    return status;
}
