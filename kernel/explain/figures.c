/* Figures of a forecast with intervals from resampled blocks (Kuensch 1989): neighbours in time err alike. */
#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/random.h"
#include "base/sort.h"
#include "cut/score.h"
#include "explain/cross_validation.h"

/* bins of a mean: one second, which the sensors' own noise hardly reaches; block [means, patches]: the memory of the slow
   noise; draws, of which the interval holds 95 % */
enum { MEAN = 2, BLOCK = 5, PATCH_BLOCK = 20, DRAWS = 400 };

/* the pairs of a channel, and the block of each */
typedef struct pairs {
    int count, blocks;
    double *measured, *predicted;
    int *block;
} pairs;

static void add_pair(pairs *p, double measured, double predicted, int block) {
    if (!isfinite(measured) || !isfinite(predicted)) return;
    p->measured[p->count] = measured, p->predicted[p->count] = predicted, p->block[p->count++] = block;
}

/* mean of MEAN bins; NaN where one is missing */
static double bin_mean(const double *bin) {
    double sum = 0;
    for (int i = 0; i < MEAN; i++) sum += bin[i];
    return sum / MEAN;
}

/* both mounts of a second are in one block */
static void gather_blocks(const wcut_evidence *e, wcut_evidence_channel channel, const wcut_forecast *measured,
                          const wcut_forecast *predicted, pairs *p) {
    /* the two rows of each channel (mounts A and B); angles in degrees */
    static const int signal[WCUT_EVIDENCE_CHANNEL_COUNT][2] = {{0, 1}, {0, 1}, {2, 4}, {3, 5}, {0, 0}, {0, 0}};
    const double unit =
        channel == WCUT_EVIDENCE_CHANNEL_ALPHA || channel == WCUT_EVIDENCE_CHANNEL_BETA ? 180 / WCUT_PI : 1;
    size_t speed = 0;
    p->count = p->blocks = 0;

    /* rows and blocks of each cut, in one list */
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        const size_t row = (size_t)c->row, bins = (size_t)c->bins, face = row + WCUT_SIGNALS * bins;
        const bool is_scan = channel == WCUT_EVIDENCE_CHANNEL_SCAN;
        const int length = is_scan ? PATCH_BLOCK : BLOCK, n = is_scan ? c->patch.count : c->bins / MEAN;

        /* of scans every patch, of signals means over one second */
        for (int i = 0; i < n; i++) {
            const int block = p->blocks + i / length;
            if (is_scan) add_pair(p, measured->row[face + (size_t)i], predicted->row[face + (size_t)i], block);
            for (int side = 0; !is_scan && side < 2; side++) {
                const size_t at = (size_t)signal[channel][side] * bins + (size_t)(MEAN * i);
                if (channel == WCUT_EVIDENCE_CHANNEL_SPEED)
                    add_pair(p, bin_mean(measured->speed + speed + at), bin_mean(predicted->speed + speed + at), block);
                else
                    add_pair(p, unit * bin_mean(measured->row + row + at), unit * bin_mean(predicted->row + row + at),
                             block);
            }
        }

        /* blocks do not reach over the end of a cut */
        p->blocks += (n + length - 1) / length;
        speed += 2 * bins;
    }
}

/* 95 % of rmse over range; sum, number: blocks + 1 each */
static void bootstrap(const pairs *p, double range, wcut_random *random, double *sum, int *number,
                      wcut_evidence_score *fit) {
    double draw[DRAWS];
    fit->low = fit->high = (double)NAN;

    /* squared deviations and their number, by block */
    memset(sum, 0, (size_t)p->blocks * sizeof *sum);
    memset(number, 0, (size_t)p->blocks * sizeof *number);
    for (int i = 0; i < p->count; i++) {
        const double d = p->measured[i] - p->predicted[i];
        sum[p->block[i]] += d * d, number[p->block[i]]++;
    }

    /* blocks without any value drop out */
    int used = 0;
    for (int k = 0; k < p->blocks; k++)
        if (number[k] > 0) sum[used] = sum[k], number[used++] = number[k];
    if (used < 2 || !(range > 0)) return;

    /* draw as many blocks as there are, with replacement, and take the RMSE of each drawing */
    for (int k = 0; k < DRAWS; k++) {
        double square = 0, count = 0;
        for (int i = 0; i < used; i++) {
            const int block = wcut_random_below(random, used);
            square += sum[block], count += number[block];
        }
        draw[k] = sqrt(square / count) / range;
    }

    /* 2.5 and 97.5 % of the drawings */
    wcut_sort(DRAWS, draw);
    fit->low = draw[DRAWS / 40], fit->high = draw[DRAWS - 1 - DRAWS / 40];
}

wcut_status wcut_forecast_score(const wcut_evidence *e, const wcut_forecast *measured, const wcut_forecast *predicted,
                                unsigned long long seed, wcut_evidence_score *fit) {
    /* room for the pairs of any channel over all cuts */
    size_t max = 0;
    for (int k = 0; k < e->cuts; k++) max += (size_t)(2 * e->cut[k].bins + e->cut[k].patch.count) + 2;
    pairs p = {.measured = wcut_alloc(max, sizeof(double)),
               .predicted = wcut_alloc(max, sizeof(double)),
               .block = wcut_alloc(max, sizeof(int))};
    double *sum = wcut_alloc(max, sizeof *sum);
    int *number = wcut_alloc(max, sizeof *number);
    const bool whole = p.measured && p.predicted && p.block && sum && number;

    /* a blade's force is not among the rows */
    fit[WCUT_EVIDENCE_CHANNEL_FORCE] = (wcut_evidence_score){.count = 0};

    /* each channel: pairs of values, their score, and its interval from a random seed of its own */
    for (int k = 0; whole && k < WCUT_EVIDENCE_CHANNEL_FORCE; k++) {
        gather_blocks(e, (wcut_evidence_channel)k, measured, predicted, &p);
        const wcut_score s = wcut_score_of(p.count, p.measured, p.predicted, 0);
        fit[k] = (wcut_evidence_score){
            .count = s.count, .rmsd = s.rmsd, .rmse = s.rmse, .nrmsd = s.nrmsd, .rmse_over_range = s.rmse_over_range};
        wcut_random random = wcut_random_seed(seed + (unsigned)k);
        bootstrap(&p, s.range, &random, sum, number, &fit[k]);
    }

    /* release in the order opposite to the allocation */
    wcut_free(number);
    wcut_free(sum);
    wcut_free(p.block);
    wcut_free(p.predicted);
    wcut_free(p.measured);
    return whole ? WCUT_OK : WCUT_NO_MEMORY;
}
