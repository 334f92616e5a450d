/* Whether the heater's volts times amperes are its set power. */
#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "cut/track.h"
#include "explain/redundancy.h"

/* [1] a difference in the mean, a slow variation: labelled cases with both columns differ by 4e-4 and 1e-3 at most */
#define MEAN_MAX 0.005
#define SLOW_MAX 0.007
/* [1] beyond this the column is another quantity or in another unit */
#define WRONG 1.5
/* [s] of a mean, and of the smoothing of what is used */
#define BIN 0.5
#define SMOOTH 0.6

enum { SAMPLES_MIN = 20 };

/* power over set power in a cut: mean, slow standard deviation, standard error of the mean */
typedef struct heater_ratio {
    int count;
    double mean, slow, error;
} heater_ratio;

/* [W/m] what is set at a sample: the column, or the job's programme where there is none */
static double power_set(const wcut_job *job, const wcut_recording *r, int i) {
    double heat, time = 0;
    if (wcut_sample_at(r, WCUT_CHANNEL_HEAT, i, &heat)) return heat;
    if (r->channel[WCUT_CHANNEL_HEAT].name || !wcut_sample_at(r, WCUT_CHANNEL_TIME, i, &time)) return 0;
    return wcut_job_heat_eval(job, time);
}

/* white noise by steps from sample to sample; what bins vary by beyond it is slow */
static heater_ratio ratio_of(const wcut_job *job, const wcut_recording *r) {
    heater_ratio out = {0};
    double sum = 0, steps = 0, last = 0, bin_sum = 0, bin_from = 0, bins_square = 0, bins_sum = 0;
    int step_count = 0, bin_count = 0, bins = 0, in_bins = 0;

    /* ratio of measured and set power, sample by sample */
    for (int i = 0; i < r->samples; i++) {
        double power, time;
        const double set = power_set(job, r, i);
        if (!(set > 0) || !wcut_heater_power(job, r, i, &power) || !wcut_sample_at(r, WCUT_CHANNEL_TIME, i, &time))
            continue;
        const double ratio = power / set;
        if (out.count++ > 0) steps += (ratio - last) * (ratio - last), step_count++;
        last = ratio, sum += ratio;

        /* a bin is closed by the first sample behind it */
        if (bin_count > 0 && time >= bin_from + BIN) {
            bins_sum += bin_sum / bin_count, bins_square += bin_sum / bin_count * (bin_sum / bin_count);
            bins++, in_bins += bin_count, bin_count = 0, bin_sum = 0;
        }
        if (bin_count == 0) bin_from = time;
        bin_sum += ratio, bin_count++;
    }
    if (out.count < SAMPLES_MIN || bins < 4) return (heater_ratio){0};

    /* steps between neighbours give the white noise; the bins' variance beyond it is slow variation */
    const double white = steps / step_count / 2, mean = bins_sum / bins;
    const double beyond = bins_square / bins - mean * mean - white * bins / in_bins;
    out.mean = sum / out.count, out.slow = sqrt(fmax(beyond, 0));
    out.error = sqrt(white / out.count);
    return out;
}

static bool is_off(const heater_ratio *q) {
    return q->count > 0 && (fabs(q->mean - 1) > MEAN_MAX + 4 * q->error || q->slow > SLOW_MAX);
}

static bool is_wrong_column(const heater_ratio *q) { return q->mean > WRONG || q->mean < 1 / WRONG; }

/* the measured power, smoothed against its noise, takes the set one's place; where it is missing the set one stays */
static wcut_status set_power(wcut_redundancy *all, int cut) {
    const wcut_job *job = all->cut[cut].job;
    const wcut_recording *given = all->given[cut].recording;
    const size_t n = (size_t)given->samples;
    double *heat = wcut_redundancy_column(all, cut, WCUT_CHANNEL_HEAT);
    double *room = wcut_alloc(3 * n, sizeof *room);
    int *at = wcut_alloc(n, sizeof *at), count = 0;
    if (heat && room && at) {
        double *time = room, *power = time + n, *smooth = power + n;

        /* samples with a measured power, and the set power as the default of the others */
        for (int i = 0; i < given->samples; i++) {
            heat[i] = power_set(job, given, i);
            if (!wcut_sample_at(given, WCUT_CHANNEL_TIME, i, &time[count])) continue;
            if (!wcut_heater_power(job, given, i, &power[count])) continue;
            at[count++] = i;
        }
        wcut_smooth(count, time, power, SMOOTH, smooth);
        for (int k = 0; k < count; k++)
            if (smooth[k] > 0) heat[at[k]] = smooth[k];
    }
    const bool done = heat && room && at;
    wcut_free(room);
    wcut_free(at);
    return done ? WCUT_OK : WCUT_NO_MEMORY;
}

static void tell_heater(const wcut_redundancy *all, const heater_ratio *q, bool set, wcut_contradiction *c) {
    char cuts[WCUT_CUT_LIST];
    const char *against = set ? "heat_W_per_m" : "the job's heat";
    wcut_cut_list(all, c, cuts);

    /* another quantity, a wrong level, or a level that varies: the sentence says what the diagnosis uses */
    if (is_wrong_column(q))
        snprintf(c->text, sizeof c->text,
                 "heater_V times heater_A over the wire's length is %.3g times %s in %s: one of the columns is another "
                 "quantity or in another unit. The product is not used.",
                 q->mean, against, cuts);
    else if (fabs(q->mean - 1) > MEAN_MAX)
        snprintf(c->text, sizeof c->text,
                 "The heater power is %.1f %% %s than %s in %s, by heater_V times heater_A over the wire's length. The "
                 "diagnosis uses the product.",
                 100 * fabs(q->mean - 1), q->mean < 1 ? "lower" : "higher", against, cuts);
    else
        snprintf(c->text, sizeof c->text,
                 "The heater's power varies by %.1f %% about %s in %s, by heater_V times heater_A. The diagnosis uses "
                 "the product.",
                 100 * q->slow, against, cuts);
}

wcut_status wcut_heater_compare(wcut_redundancy *all) {
    wcut_contradiction *c = NULL;
    heater_ratio sum = {0};
    bool set = false;

    /* every cut whose power is off: its own figures, and the measured power in place of the set one */
    for (int cut = 0; cut < all->cuts; cut++) {
        if (!wcut_redundancy_has(all, cut)) continue;
        const heater_ratio q = ratio_of(all->cut[cut].job, all->cut[cut].recording);
        if (!is_off(&q)) continue;
        if (!c) c = wcut_contradiction_add(all, WCUT_CONTRADICTION_HEATER, "heat_W_per_m");
        if (!c) return WCUT_OK;
        set = set || all->given[cut].recording->channel[WCUT_CHANNEL_HEAT].name;
        wcut_contradiction_add_cut(c, cut);
        sum.mean += q.mean, sum.slow += q.slow, sum.error = fmax(sum.error, q.error);
        if (!is_wrong_column(&q) && set_power(all, cut) != WCUT_OK) return WCUT_NO_MEMORY;
    }
    if (!c) return WCUT_OK;

    /* the row shows the mean over these cuts */
    sum.mean /= c->cuts, sum.slow /= c->cuts;
    c->found = sum.mean, c->expected = 1, c->error = fmax(sum.error, sum.slow / sqrt(c->cuts));
    c->fault = true, c->common = true, c->repaired = !is_wrong_column(&sum);
    snprintf(c->unit, sizeof c->unit, "share");
    tell_heater(all, &sum, set, c);
    return WCUT_OK;
}
