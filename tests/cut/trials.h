/* What the tests of replay and score share: a short cut, and recordings of it made in place. */
#ifndef WCUT_TESTS_CUT_TRIALS_H
#define WCUT_TESTS_CUT_TRIALS_H

#include <wirecut/replay.h>

#include "cut/cuts.h"
#include "cut/track.h"

/* A wire of 380 mm across a block of 240 x 160 mm, in and out: 25 nodes, 81 stations, 6 mm apart. */
static inline wcut_job *short_job(void) {
    wcut_job *job = straight_job(240, 60, 380, 25, 81, 10, 490);
    job->block_size.y = 160;
    job->speed_max = 40;
    return job;
}

/* a recording whose channels are all there, and zero but for its line numbers and a clock of `step` seconds */
static inline wcut_recording *blank_recording(int samples, double step) {
    const size_t n = (size_t)samples;
    wcut_recording *r = calloc(1, sizeof *r);
    r->samples = samples;
    for (int k = 0; k < WCUT_CHANNEL_HEAT; k++) {
        const char *name = wcut_channel_name((wcut_channel)k);
        r->channel[k].name = strcpy(calloc(strlen(name) + 1, 1), name);
        r->channel[k].value = calloc(n, sizeof(double));
    }
    r->further = calloc(1, sizeof *r->further);
    r->further->rows = samples;
    r->further->line = calloc(n, sizeof(int));
    for (int i = 0; i < samples; i++) {
        r->further->line[i] = i + 2;
        r->channel[WCUT_CHANNEL_TIME].value[i] = step * i;
    }
    return r;
}

static inline double *values(wcut_recording *r, wcut_channel channel) { return r->channel[channel].value; }

/* let a channel be there that blank_recording left out */
static inline double *add_channel(wcut_recording *r, wcut_channel channel) {
    const char *name = wcut_channel_name(channel);
    r->channel[channel].name = strcpy(calloc(strlen(name) + 1, 1), name);
    return r->channel[channel].value = calloc((size_t)r->samples, sizeof(double));
}

static inline void lose_sample(wcut_recording *r, wcut_channel channel, int sample) {
    wcut_column *c = &r->channel[channel];
    if (!c->present) c->present = memset(malloc((size_t)r->samples), 1, (size_t)r->samples);
    c->missing += c->present[sample];
    c->present[sample] = 0;
    c->value[sample] = 0;
}

/* What a machine that moves evenly, `pace` stations a second, would record on short_job, by driving the wire: the
   replay's own steps, so that it has to give the same numbers. */
static inline wcut_recording *driven_recording(const wcut_job *job, double pace, double step, int samples) {
    wcut_setup *setup = setup_of(job, NULL);
    wcut_cut *cut = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
    wcut_recording *r = blank_recording(samples, step);
    for (int i = 0; i < samples; i++) {
        const double station = pace * step * (i + 1);
        const wcut_vec3 a = wcut_path_at(job->stations, job->mount_a, station);
        const wcut_vec3 b = wcut_path_at(job->stations, job->mount_b, station);
        wcut_station s;
        const wcut_status status = wcut_cut_drive(cut, a, b, step, job->heat, &error);
        ck_assert_msg(status == WCUT_OK, "sample %d: %s", i, error.text);
        wcut_cut_view(cut, &s);
        const double value[WCUT_SIGNAL_COUNT] = {s.speed_a, s.speed_b, s.tension_a, s.tension_b,
                                                 s.alpha_a, s.beta_a,  s.alpha_b,   s.beta_b};
        values(r, WCUT_CHANNEL_STATION)[i] = station;
        for (int k = 0; k < WCUT_SIGNAL_COUNT; k++) values(r, (wcut_channel)(WCUT_CHANNEL_SPEED_A + k))[i] = value[k];
    }
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    return r;
}

/* the largest difference of a signal from the recording where it is predicted; gives how many are */
static inline int compare_signal(wcut_recording *r, const wcut_prediction *p, int signal, double *worst) {
    int count = 0;
    *worst = 0;
    for (int i = 0; i < r->samples; i++) {
        if (!p->present[i]) continue;
        const double d = fabs(p->value[signal][i] - values(r, (wcut_channel)(WCUT_CHANNEL_SPEED_A + signal))[i]);
        *worst = fmax(*worst, d);
        count++;
    }
    return count;
}

#endif
