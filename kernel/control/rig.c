/* A controller in closed loop with the time-driven simulation: delayed and noisy readings in, speeds out, recorded. */
#include <wirecut/rig.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/random.h"
#include "base/vec3.h"
#include "control/rig_run.h"
#include "cut/setup.h"
#include "cut/track.h"

#define MOST_OF_WIRE 0.5 /* [1] share of the plan's longest engagement from which excitation runs */
#define PATIENCE 20      /* times the plan's duration */

typedef struct reading {
    double a, b; /* [N] */
} reading;

typedef struct rig {
    const wcut_job *job;
    const wcut_history *plan;
    wcut_rig_options o;
    wcut_setup *setup; /* the plant's own: its force law is changed between steps, as the wire meets other foam */
    wcut_cut *cut;
    wcut_control *control;
    wcut_random random;
    reading *line; /* delays: as many readings as the delay lasts */
    int delays, next;
    double time, station;
    double speed; /* [mm/s] of the faster mount, actual */
    double way_a; /* [mm] of mount A in the last step */
    double way_b; /* [mm] */
    wcut_vec3 at_a, at_b;
    double command; /* [mm/s] of the faster mount: plan x controller x excitation */
    double heat;    /* [W/m] */
    double beyond;  /* [1] share of the engaged wire beyond density_from */
    double longest; /* [mm] the plan's longest engagement */
} rig;

wcut_rig_options wcut_rig_options_default(const wcut_job *job) {
    return (wcut_rig_options){.law_a = 1,
                              .law_b = 1,
                              .density = 1,
                              .density_from = job->block_size.y / 2,
                              .delay = 0.05,
                              .lag = 0.05,
                              .noise_tension = 0.02,
                              .noise_angle = 0.05 * WCUT_PI / 180,
                              .noise_speed = 0.1,
                              .noise_position = 0.05,
                              .seed = 1,
                              .period = 0.025,
                              .decimation = 0,
                              .excitation = true};
}

static wcut_status check_rig(const wcut_rig_options *o, wcut_error *error) {
    const double zero_or_more[] = {o->delay,       o->lag,         o->noise_tension,
                                   o->noise_angle, o->noise_speed, o->noise_position};
    const double positive[] = {o->law_a, o->law_b, o->density, o->period};
    for (size_t i = 0; i < sizeof zero_or_more / sizeof *zero_or_more; i++)
        if (!(zero_or_more[i] >= 0 && isfinite(zero_or_more[i])))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "delay, lag and noise: found %g, expected 0 or more",
                             zero_or_more[i]);
    for (size_t i = 0; i < sizeof positive / sizeof *positive; i++)
        if (!is_positive(positive[i]))
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "law_a, law_b, density and period: found %g, expected a number greater than 0",
                             positive[i]);
    if (!isfinite(o->density_from) || o->decimation < 0 || o->period < 1e-4 || o->period > 1 || o->delay > 10)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a finite density_from, a decimation of 0 or more, a period of 1e-4 .. 1 s and a delay of at "
                         "most 10 s are expected");
    return WCUT_OK;
}

/* ---- the plant ---- */

static double mount_way(const wcut_vec3 *mount, int j) { return vec3_distance(mount[j], mount[j + 1]); }

/* the segment that a station lies in */
static int segment_of(const rig *r) {
    const int j = (int)r->station, last = r->job->stations - 2;
    return j < last ? j : last;
}

/* a mount's place on the smooth curve through its stations: on chords its direction would jump at each, and a nearly
   straight wire answers that with a fifth of its tension */
static wcut_vec3 mount_at(const rig *r, const wcut_vec3 *mount) {
    return wcut_path_at(r->job->stations, mount, r->station);
}

/* the faster mount goes `way`, the other one keeps step; stops at the path's end */
static void move_mounts(rig *r, double way) {
    const wcut_vec3 from_a = mount_at(r, r->job->mount_a), from_b = mount_at(r, r->job->mount_b);
    while (way > 0 && r->station < r->job->stations - 1) {
        const int j = segment_of(r);
        const double longer = fmax(mount_way(r->job->mount_a, j), mount_way(r->job->mount_b, j));
        const double left = (j + 1 - r->station) * longer;
        r->station = way < left ? r->station + way / longer : j + 1;
        way -= left;
    }
    r->at_a = mount_at(r, r->job->mount_a);
    r->at_b = mount_at(r, r->job->mount_b);
    r->way_a = vec3_distance(from_a, r->at_a);
    r->way_b = vec3_distance(from_b, r->at_b);
}

/* the speed dither of an identification cut, while most of the wire is in the foam */
static double excitation_dither(const rig *r, double engaged) {
    if (!r->o.excitation || engaged < MOST_OF_WIRE * r->longest) return 1;
    return fmax(wcut_job_pace_eval(r->job, r->time), 0);
}

/* the foam that the wire is in now, for the next step */
static void meet_foam(rig *r) {
    wcut_station s;
    wcut_cut_view(r->cut, &s);
    double sum = 0, beyond = 0;
    for (int i = 0; i < s.nodes; i++) {
        sum += s.engaged[i];
        beyond += s.position[i].y > r->o.density_from ? s.engaged[i] : 0;
    }
    r->beyond = sum > 0 ? beyond / sum : 0;
    r->setup->foam.law.a = r->job->force_law.a * r->o.law_a * (1 + (r->o.density - 1) * r->beyond);
}

/* ---- the loop ---- */

/* what the sensors gave a delay ago; before there was anything to read, the first reading */
static reading delay_reading(rig *r, reading now) {
    if (r->delays == 0) return now;
    const reading before = r->line[r->next];
    r->line[r->next] = now;
    r->next = (r->next + 1) % r->delays;
    return before;
}

static double noisy(rig *r, double value, double deviation) {
    return value + deviation * wcut_random_normal(&r->random); /* drawn at 0, too: one noise has no say in another */
}

static reading read_sensors(rig *r, const wcut_station *s) {
    const double a = noisy(r, s->tension_a, r->o.noise_tension), b = noisy(r, s->tension_b, r->o.noise_tension);
    return delay_reading(r, (reading){a, b});
}

static wcut_vec3 noisy_position(rig *r, wcut_vec3 p) {
    const double x = noisy(r, p.x, r->o.noise_position), y = noisy(r, p.y, r->o.noise_position);
    return vec3(x, y, noisy(r, p.z, r->o.noise_position));
}

static bool record(rig *r, const wcut_station *s, reading tension, wcut_rig_run *run) {
    /* a growing record, and the control's state at this time */
    if (!wcut_rig_run_grow(run)) return false;
    const int j = segment_of(r);
    const double a = mount_way(r->job->mount_a, j), b = mount_way(r->job->mount_b, j), share = a / fmax(a, b);
    const wcut_history_row *row = &r->plan->row[j + 1];
    wcut_control_view control;

    wcut_control_look(r->control, &control);

    /* readings with noise; the command is the share of mount A */
    const int i = run->recording.samples++;
    wcut_column *c = run->recording.channel;
    c[WCUT_CHANNEL_TIME].value[i] = r->time;
    c[WCUT_CHANNEL_STATION].value[i] = r->station;
    c[WCUT_CHANNEL_SPEED_A].value[i] = noisy(r, r->way_a / r->o.period, r->o.noise_speed);
    c[WCUT_CHANNEL_SPEED_B].value[i] = noisy(r, r->way_b / r->o.period, r->o.noise_speed);
    c[WCUT_CHANNEL_TENSION_A].value[i] = tension.a;
    c[WCUT_CHANNEL_TENSION_B].value[i] = tension.b;
    c[WCUT_CHANNEL_ALPHA_A].value[i] = noisy(r, s->alpha_a, r->o.noise_angle);
    c[WCUT_CHANNEL_BETA_A].value[i] = noisy(r, s->beta_a, r->o.noise_angle);
    c[WCUT_CHANNEL_ALPHA_B].value[i] = noisy(r, s->alpha_b, r->o.noise_angle);
    c[WCUT_CHANNEL_BETA_B].value[i] = noisy(r, s->beta_b, r->o.noise_angle);
    c[WCUT_CHANNEL_SPEED_COMMAND].value[i] = r->command * share;
    c[WCUT_CHANNEL_HEAT].value[i] = r->heat;

    /* measured positions of both mounts */
    const wcut_vec3 at_a = noisy_position(r, s->mount_a), at_b = noisy_position(r, s->mount_b);
    c[WCUT_CHANNEL_A_X].value[i] = at_a.x;
    c[WCUT_CHANNEL_A_Y].value[i] = at_a.y;
    c[WCUT_CHANNEL_A_Z].value[i] = at_a.z;
    c[WCUT_CHANNEL_B_X].value[i] = at_b.x;
    c[WCUT_CHANNEL_B_Y].value[i] = at_b.y;
    c[WCUT_CHANNEL_B_Z].value[i] = at_b.z;

    /* beside the recording: true tension, planned speed, phase, state */
    run->tension[i] = (s->tension_a + s->tension_b) / 2;
    run->planned[i] = row->speed_a;
    /* steady is what is steady at both ends of the segment */
    run->phase[i] = row->phase == WCUT_PHASE_STEADY ? r->plan->row[j].phase : row->phase;
    run->state[i] = control.state;
    run->beyond[i] = r->beyond;

    return true;
}

/* One period: the mounts move by the command of the step before, then the sensors are read and the speed is set. */
static wcut_status rig_advance(rig *r, reading *tension, wcut_error *error) {
    const double dt = r->o.period;

    /* the machine follows the command with a lag of first order */
    r->speed += (r->command - r->speed) * dt / (r->o.lag + dt);
    r->time += dt;
    r->heat = r->o.excitation ? wcut_job_heat_eval(r->job, r->time) : r->job->heat;
    move_mounts(r, r->speed * dt);

    /* the simulated wire is led to where the mounts are */
    wcut_status status = WCUT_OK;
    if (r->way_a > 0 || r->way_b > 0) {
        wcut_error cause = {0};
        status = wcut_cut_drive(r->cut, r->at_a, r->at_b, dt, r->heat, &cause);
        if (status != WCUT_OK)
            return wcut_fail(error, status, "at %.2f s, station %.2f: %s", r->time, r->station, cause.text);
    }

    /* contact, then readings with noise and delay */
    meet_foam(r);
    wcut_station s;
    wcut_cut_view(r->cut, &s);
    *tension = read_sensors(r, &s);

    /* the controller sets the next command, with the excitation of the programme upon it */
    double speed;
    status = wcut_control_step(r->control, r->time, r->station, tension->a, tension->b, &speed);
    r->command = fmin(speed * excitation_dither(r, s.engaged_length), r->job->speed_max);

    return status;
}

static wcut_status run_loop(rig *r, wcut_progress progress, void *context, wcut_rig_run *run, wcut_error *error) {
    /* a run may take PATIENCE times its planned time; a sample is recorded every 0.05 s unless asked otherwise */
    const wcut_history *plan = r->plan;
    const double max = 1 + PATIENCE * plan->row[plan->stations - 1].time;
    const int every = r->o.decimation > 0 ? r->o.decimation : (int)fmax(1, floor(0.05 / r->o.period + 0.5));
    wcut_control_view control = {.state = WCUT_CONTROL_STATE_RUN};

    /* periods until the last station */
    for (long step = 1; r->station < plan->stations - 1; step++) {
        reading tension = {0, 0};
        wcut_status status = rig_advance(r, &tension, error);
        if (status != WCUT_OK) return status;

        /* record before the figures are updated, so that a sample holds what was known then */
        wcut_station s;
        wcut_cut_view(r->cut, &s);
        if (step % every == 0 && !record(r, &s, tension, run))
            return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a recording of more than %d samples",
                             run->recording.samples);

        /* largest tension over the target, and whether the controller stopped the cut */
        wcut_control_look(r->control, &control);
        run->overshoot = fmax(run->overshoot, (s.tension_a + s.tension_b) / 2 / run->target - 1);
        run->duration = r->time;
        run->ended = control.state >= WCUT_CONTROL_STATE_STOP_TENSION ? control.state : WCUT_CONTROL_STATE_RUN;
        if (run->ended != WCUT_CONTROL_STATE_RUN && control.speed == 0) return WCUT_OK;

        /* a request to stop, and a run that comes no further */
        if (progress && progress((int)r->station + 1, plan->stations, context) != 0)
            return wcut_fail(error, WCUT_INTERRUPTED, "station %.1f: stopped on request", r->station);
        if (r->time > max)
            return wcut_fail(error, WCUT_NOT_CONVERGED, "station %.1f of %d after %.0f s, the plan ends at %.0f s",
                             r->station, plan->stations - 1, r->time, plan->row[plan->stations - 1].time);
    }
    run->complete = run->ended == WCUT_CONTROL_STATE_RUN;

    return WCUT_OK;
}

static wcut_status rig_begin(rig *r, const wcut_control_settings *settings, wcut_error *error) {
    wcut_status status = wcut_control_create(settings, r->plan, &r->control, error);
    if (status == WCUT_OK) status = wcut_setup_create(r->job, NULL, &r->setup, error);
    if (status == WCUT_OK) status = wcut_cut_create(r->setup, &r->cut, error);
    if (status != WCUT_OK) return status;
    r->delays = (int)(r->o.delay / r->o.period + 0.5);
    r->line = wcut_alloc((size_t)r->delays, sizeof *r->line);
    if (!r->line) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a delay of %d readings", r->delays);
    for (int j = 0; j < r->plan->stations; j++) r->longest = fmax(r->longest, r->plan->row[j].engaged_length);
    r->setup->foam.law.b *= r->o.law_b;
    r->heat = r->job->heat;
    meet_foam(r);
    return WCUT_OK;
}

static wcut_status check_match(const wcut_job *job, const wcut_history *plan, wcut_error *error) {
    if (job->mode != WCUT_MODE_PATH)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "the loop runs on a path; a design's path curves make one");
    if (plan->stations != job->stations || plan->planned != plan->stations)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "plan: found %d of %d stations, expected the job's %d",
                         plan->stations, plan->planned, job->stations);
    return WCUT_OK;
}

wcut_status wcut_rig_run_create(const wcut_job *job, const wcut_history *plan, const wcut_control_settings *control,
                                const wcut_rig_options *options, wcut_progress progress, void *context,
                                wcut_rig_run **out, wcut_error *error) {
    /* check options and that job and plan belong together */
    if (!job || !plan || !control || !out)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a job, a plan, settings and a place for the run are expected");
    rig r = {.job = job, .plan = plan, .o = options ? *options : wcut_rig_options_default(job)};
    wcut_rig_run *run = NULL;
    wcut_status status = check_rig(&r.o, error);
    if (status == WCUT_OK) status = check_match(job, plan, error);
    if (status == WCUT_OK) status = rig_begin(&r, control, error);

    /* noise comes from the seed alone */
    if (status == WCUT_OK) {
        r.random = wcut_random_seed(r.o.seed);
        run = wcut_alloc(1, sizeof *run);
        if (!run) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a run");
    }

    /* run, and close the recording whatever ended it */
    if (run) {
        run->target = control->tension;
        status = run_loop(&r, progress, context, run, error);
        wcut_rig_run_finish(run);
        if (status == WCUT_OK && run->recording.samples == 0)
            status = wcut_fail(error, WCUT_BAD_ARGUMENT, "the cut is over before its first sample");
    }

    /* a run that has samples is handed over, also when it ended early */
    const bool handed = run && run->recording.samples > 0 &&
                        (status == WCUT_OK || status == WCUT_NOT_CONVERGED || status == WCUT_INTERRUPTED);
    if (handed)
        *out = run;
    else
        wcut_rig_run_destroy(run);

    wcut_cut_destroy(r.cut);
    wcut_setup_destroy(r.setup);
    wcut_control_destroy(r.control);
    wcut_free(r.line);
    return status;
}
