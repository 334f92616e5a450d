/* Whether a recording follows its job's excitation: the dither in the commanded speed, the steps in the heater's power. */
#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "cut/track.h"
#include "explain/redundancy.h"

/* [s] what is slower than this in speed and programme is the plan's and the controller's */
#define PASS 4.0
/* [s] blocks that count as independent */
#define APART 2.0
/* [1] of the programme that a recording shows at least: of 97 cuts with a dither 0.24 and more, since a tension loop fights
   it; of four that had none 0.006 at most */
#define SHOWN_MIN 0.15
/* [1] the same of heater steps, which nothing fights */
#define HEATED_MIN 0.5
/* samples and blocks of time that a comparison needs */
enum { SAMPLES_MIN = 40, BLOCKS_MIN = 6 };

/* how much of a programme is in a recording: a regression's slope with its standard error */
typedef struct share {
    bool told;
    double value, error;
    const char *column;
} share;

/* samples of a cut while most of the wire is in the foam: times, logarithms of speed and of the programme */
typedef struct series {
    int count;
    double *time, *speed, *programme;
} series;

static bool is_in_foam(const wcut_job *job, double station) {
    const double last = job->stations - 1, s = clamp(station, 0, last);
    const double y =
        (wcut_path_at(job->stations, job->mount_a, s).y + wcut_path_at(job->stations, job->mount_b, s).y) / 2;
    return y > 0.3 * job->block_size.x && y < job->block_size.y;
}

static void series_fill(const wcut_job *job, const wcut_recording *r, wcut_channel channel, series *s) {
    s->count = 0;
    for (int i = 0; i < r->samples; i++) {
        double time, station, speed;
        if (!wcut_sample_at(r, WCUT_CHANNEL_TIME, i, &time) || !wcut_sample_at(r, WCUT_CHANNEL_STATION, i, &station) ||
            !wcut_sample_at(r, channel, i, &speed) || !is_in_foam(job, station) || !(speed > 0.1))
            continue;
        s->time[s->count] = time;
        s->speed[s->count] = log(speed);
        s->programme[s->count++] = log(fmax(wcut_job_pace_eval(job, time), 0.05));
    }
}

/* y less its mean over PASS about each time; room: count */
static void pass_fast(int n, const double *time, double *y, double *room) {
    double sum = 0;
    for (int i = 0, low = 0, high = 0; i < n; i++) {
        while (high < n && time[high] <= time[i] + PASS / 2) sum += y[high++];
        while (time[low] < time[i] - PASS / 2) sum -= y[low++];
        room[i] = y[i] - sum / (high - low);
    }
    for (int i = 0; i < n; i++) y[i] = room[i];
}

/* slope of speed on programme, its error from what blocks of time say; the ends, where the mean is lopsided, left out */
static share regress(const series *s) {
    share found = {0};
    double product = 0, square = 0, spread = 0;
    const int n = s->count;
    int blocks = 0;
    if (n < SAMPLES_MIN) return found;

    /* least squares through the origin; half a window of the running mean is left out at each end */
    const double from = s->time[0] + PASS / 2, to = s->time[n - 1] - PASS / 2;
    for (int i = 0; i < n; i++)
        if (s->time[i] >= from && s->time[i] <= to)
            product += s->speed[i] * s->programme[i], square += s->programme[i] * s->programme[i];
    if (!(square > 0)) return found;
    found.value = product / square;

    /* sums of the residual times the programme, block by block */
    double sum = 0, block = from;
    for (int i = 0; i < n; i++) {
        if (s->time[i] < from || s->time[i] > to) continue;
        if (s->time[i] >= block + APART) spread += sum * sum, sum = 0, block = s->time[i], blocks++;
        sum += (s->speed[i] - found.value * s->programme[i]) * s->programme[i];
    }
    spread += sum * sum;
    found.error = sqrt(spread) / square;
    found.told = blocks >= BLOCKS_MIN;
    return found;
}

/* the dither in the commanded speed, or in the speed itself where no command is recorded */
static wcut_status share_of_dither(const wcut_job *job, const wcut_recording *r, share *out) {
    const bool command = r->channel[WCUT_CHANNEL_SPEED_COMMAND].name != NULL;
    const wcut_channel channel = command ? WCUT_CHANNEL_SPEED_COMMAND : WCUT_CHANNEL_SPEED_A;
    const size_t n = (size_t)r->samples;
    *out = (share){0};
    if (job->dither_count == 0) return WCUT_OK;
    double *room = wcut_alloc(4 * n, sizeof *room);
    if (!room) return WCUT_NO_MEMORY;
    series s = {.time = room, .speed = room + n, .programme = room + 2 * n};
    series_fill(job, r, channel, &s);
    if (s.count > 0) {
        pass_fast(s.count, s.time, s.speed, room + 3 * n);
        pass_fast(s.count, s.time, s.programme, room + 3 * n);
        *out = regress(&s);
    }
    out->column = wcut_channel_name(channel);
    wcut_free(room);
    return WCUT_OK;
}

/* slope of the recorded heat on the programme's factors, over the whole recording */
static share share_of_steps(const wcut_job *job, const wcut_recording *r) {
    share found = {.column = wcut_channel_name(WCUT_CHANNEL_HEAT)};
    const bool set = r->channel[WCUT_CHANNEL_HEAT].name != NULL;
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    if (!set) found.column = "heater_V times heater_A";

    /* sums over the samples that have a time and a power, set or measured */
    for (int i = 0; i < r->samples && job->heat_step_count > 0; i++) {
        double time, heat;
        if (!wcut_sample_at(r, WCUT_CHANNEL_TIME, i, &time)) continue;
        if (!(set ? wcut_sample_at(r, WCUT_CHANNEL_HEAT, i, &heat) : wcut_heater_power(job, r, i, &heat))) continue;
        const double factor = wcut_job_heat_eval(job, time) / job->heat, shown = heat / job->heat;
        n++, x += factor, y += shown, xx += factor * factor, xy += factor * shown;
    }

    /* steps that lie outside the recording say nothing */
    const double square = xx - x * x / fmax(n, 1);
    if (n < SAMPLES_MIN || square < 1e-5 * n) return found;
    found.told = true;
    found.value = (xy - x * y / n) / square;
    return found;
}

/* what was not followed, over the cuts that did not */
typedef struct broken {
    int dithers, steps;
    double dither, error, step;
    const char *dither_column, *step_column;
} broken;

static wcut_status compare_cut(wcut_redundancy *all, int cut, broken *b, bool *missed) {
    const wcut_job *job = all->cut[cut].job;
    const wcut_recording *r = all->cut[cut].recording;
    share dither, step = share_of_steps(job, r);
    const wcut_status status = share_of_dither(job, r, &dither);
    if (status != WCUT_OK) return status;
    const bool no_dither = dither.told && dither.value + 3 * dither.error < SHOWN_MIN;
    const bool no_step = step.told && step.value < HEATED_MIN;
    *missed = no_dither || no_step;
    if (no_dither) b->dithers++, b->dither += dither.value, b->error += dither.error, b->dither_column = dither.column;
    if (no_step) b->steps++, b->step += step.value, b->step_column = step.column;

    /* a part that cannot be judged goes with the other */
    wcut_job *own = &all->job[cut];
    if (no_dither || (no_step && !dither.told)) own->dither_count = 0;
    if (no_step || (no_dither && !step.told)) own->heat_step_count = 0;
    if (*missed) all->cut[cut].job = own;
    return WCUT_OK;
}

static void tell_excitation(const wcut_redundancy *r, const broken *b, wcut_contradiction *c) {
    char cuts[WCUT_CUT_LIST], dither[100] = "", step[90] = "";
    wcut_cut_list(r, c, cuts);
    if (b->dithers > 0)
        snprintf(dither, sizeof dither, "%s shows %.0f +- %.0f %% of the dither of the speed", b->dither_column,
                 100 * b->dither / b->dithers, 196 * b->error / b->dithers);
    if (b->steps > 0)
        snprintf(step, sizeof step, "%s shows %.0f %% of the heater steps", b->step_column, 100 * b->step / b->steps);
    snprintf(c->text, sizeof c->text,
             "The recording%s of %s do%s not follow the job's excitation: %s%s%s. It is left out of %s.",
             c->cuts > 1 ? "s" : "", cuts, c->cuts > 1 ? "" : "es", dither, dither[0] && step[0] ? ", " : "", step,
             c->cuts > 1 ? "these jobs" : "this job");
}

wcut_status wcut_excitation_compare(wcut_redundancy *all) {
    broken b = {0};
    wcut_contradiction *c = NULL;

    /* one contradiction lists every cut that does not follow */
    for (int cut = 0; cut < all->cuts; cut++) {
        bool missed = false;
        if (!wcut_redundancy_has(all, cut)) continue;
        const wcut_status status = compare_cut(all, cut, &b, &missed);
        if (status != WCUT_OK) return status;
        if (missed && !c) c = wcut_contradiction_add(all, WCUT_CONTRADICTION_EXCITATION, "");
        if (missed && c) wcut_contradiction_add_cut(c, cut);
    }
    if (!c) return WCUT_OK;

    /* one row for all of them, by the dither where there is one */
    const bool speed = b.dithers > 0;
    snprintf(c->column, sizeof c->column, "%s", speed ? b.dither_column : b.step_column);
    c->found = speed ? b.dither / b.dithers : b.step / b.steps;
    c->error = speed ? b.error / b.dithers : 0;
    c->expected = 1, c->repaired = true;
    snprintf(c->unit, sizeof c->unit, "share");
    tell_excitation(all, &b, c);
    return WCUT_OK;
}
