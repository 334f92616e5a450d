/* What the tension sensors read in the air, where a slack wire pulls nothing. */
#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/track.h"
#include "explain/redundancy.h"

/* [N] a zero that returns within less is a load cell's own repeatability; labelled cases read 0.023 N at most */
#define ZERO_MAX 0.05
/* standard errors that it must stand out by */
#define STANDS 5.0
/* [N] of the mean over cuts: zeros differ from cut to cut by their repeatability */
#define REPEATS 0.015
/* noise of neighbouring samples is alike: the error of a mean is so much larger than that of white noise */
#define COLOUR 1.5
/* [mm] before the block, [1] wire over the distance of the mounts: surely slack, surely in the air */
#define BEFORE 2.0
#define SLACK 1.003

enum { SAMPLES_MIN = 3 };

typedef struct reading {
    int count;
    double sum, square, mean, error;
} reading;

/* both mounts before the block: the wire trails behind them and touches nothing */
static bool is_in_air(const wcut_job *job, double station) {
    const double s = clamp(station, 0, job->stations - 1);
    const wcut_vec3 a = wcut_path_at(job->stations, job->mount_a, s), b = wcut_path_at(job->stations, job->mount_b, s);
    return fmax(a.y, b.y) < -BEFORE && job->wire_length > SLACK * vec3_distance(a, b);
}

static reading read_air(const wcut_job *job, const wcut_recording *r, wcut_channel channel) {
    reading out = {0};
    for (int i = 0; i < r->samples; i++) {
        double station, tension;
        if (!wcut_sample_at(r, WCUT_CHANNEL_STATION, i, &station) || !wcut_sample_at(r, channel, i, &tension)) continue;
        if (!is_in_air(job, station)) continue;
        out.count++, out.sum += tension, out.square += tension * tension;
    }
    if (out.count > 0) out.mean = out.sum / out.count;
    return out;
}

/* errors by the noise about each cut's own mean; gives the mean over cuts */
static reading pool(int cuts, reading *of) {
    reading all = {0};
    double spread = 0, error = 0;
    int freedom = 0;
    for (int k = 0; k < cuts; k++)
        if (of[k].count > 1) spread += of[k].square - of[k].sum * of[k].mean, freedom += of[k].count - 1;
    const double noise = freedom > 0 ? sqrt(fmax(spread, 0) / freedom) : 0;
    for (int k = 0, of_cuts = 0; k < cuts; k++) {
        if (of[k].count < SAMPLES_MIN) continue;
        of[k].error = COLOUR * noise / sqrt(of[k].count);
        all.count += of[k].count, all.sum += of[k].sum;
        error = REPEATS * REPEATS / ++of_cuts;
    }
    if (all.count == 0) return all;
    all.mean = all.sum / all.count;
    all.error = sqrt(COLOUR * COLOUR * noise * noise / all.count + error);
    return all;
}

static bool stands_out(const reading *q) { return fabs(q->mean) > ZERO_MAX && fabs(q->mean) > STANDS * q->error; }

static wcut_status subtract(wcut_redundancy *all, int cut, wcut_channel channel, double zero) {
    double *tension = wcut_redundancy_column(all, cut, channel);
    if (!tension) return WCUT_NO_MEMORY;
    for (int i = 0; i < all->recording[cut].samples; i++) tension[i] -= zero;
    return WCUT_OK;
}

/* a sensor in a record at rest: its mean, and the error that noise and the repeatability of a load cell leave */
static reading read_still(const wcut_recording *r, wcut_channel channel) {
    reading out = {0};
    for (int i = 0; i < r->samples; i++) {
        double tension;
        if (!wcut_sample_at(r, channel, i, &tension)) continue;
        out.count++, out.sum += tension, out.square += tension * tension;
    }
    if (out.count < SAMPLES_MIN) return (reading){0};
    out.mean = out.sum / out.count;
    const double noise = sqrt(fmax(out.square - out.sum * out.mean, 0) / (out.count - 1));
    out.error = hypot(COLOUR * noise / sqrt(out.count), REPEATS / sqrt(3));
    return out;
}

static void tell_zero(const wcut_redundancy *all, const reading *q, wcut_contradiction *c) {
    char cuts[WCUT_CUT_LIST];
    wcut_cut_list(all, c, cuts);
    c->found = q->mean, c->error = q->error, c->fault = c->repaired = true;
    snprintf(c->unit, sizeof c->unit, "N");
    const char *where = all->still ? "at rest, which is taken from" : "in the air, where the wire is slack, in";
    snprintf(c->text, sizeof c->text,
             "%s reads %+.3f +- %.3f N %s %s: the zero of this sensor is off. It is subtracted.", c->column, q->mean,
             1.96 * q->error, where, cuts);
}

/* one zero in all cuts, those too that have no air in them */
static wcut_status subtract_common(wcut_redundancy *all, wcut_channel channel, const reading *q) {
    wcut_contradiction *c = wcut_contradiction_add(all, WCUT_CONTRADICTION_TENSION_ZERO, wcut_channel_name(channel));
    for (int cut = 0; c && cut < all->cuts; cut++) {
        if (!wcut_redundancy_has(all, cut)) continue;
        wcut_contradiction_add_cut(c, cut);
        const wcut_status status = subtract(all, cut, channel, q->mean);
        if (status != WCUT_OK) return status;
    }
    if (c) c->common = true, tell_zero(all, q, c);
    return WCUT_OK;
}

/* zeros of single cuts, each said by itself */
static wcut_status subtract_own(wcut_redundancy *all, wcut_channel channel, const reading *of) {
    for (int cut = 0; cut < all->cuts; cut++) {
        if (of[cut].count < SAMPLES_MIN || !stands_out(&of[cut])) continue;
        wcut_contradiction *c =
            wcut_contradiction_add(all, WCUT_CONTRADICTION_TENSION_ZERO, wcut_channel_name(channel));
        if (!c) return WCUT_OK;
        wcut_contradiction_add_cut(c, cut);
        tell_zero(all, &of[cut], c);
        const wcut_status status = subtract(all, cut, channel, of[cut].mean);
        if (status != WCUT_OK) return status;
    }
    return WCUT_OK;
}

wcut_status wcut_zero_compare(wcut_redundancy *all) {
    reading *of = wcut_alloc((size_t)all->cuts, sizeof *of);
    wcut_status status = of ? WCUT_OK : WCUT_NO_MEMORY;

    /* each sensor by itself: readings in the air of every cut, and their mean */
    for (int sensor = 0; status == WCUT_OK && sensor < 2; sensor++) {
        const wcut_channel channel = sensor ? WCUT_CHANNEL_TENSION_B : WCUT_CHANNEL_TENSION_A;

        /* a record at rest is the better measurement */
        const reading rest = all->still ? read_still(all->still, channel) : (reading){0};
        if (rest.count > 0) {
            if (stands_out(&rest)) status = subtract_common(all, channel, &rest);
            continue;
        }

        /* else what the cuts themselves read in the air */
        for (int cut = 0; cut < all->cuts; cut++)
            of[cut] = wcut_redundancy_has(all, cut) ? read_air(all->cut[cut].job, all->cut[cut].recording, channel)
                                                    : (reading){0};
        const reading q = pool(all->cuts, of);

        /* one zero where no cut contradicts it */
        bool alike = true;
        for (int cut = 0; cut < all->cuts; cut++)
            if (of[cut].count >= SAMPLES_MIN)
                alike = alike && fabs(of[cut].mean - q.mean) < fmax(ZERO_MAX, STANDS * of[cut].error);
        status =
            alike && q.count > 0 && stands_out(&q) ? subtract_common(all, channel, &q) : subtract_own(all, channel, of);
    }
    wcut_free(of);
    return status;
}
