/* Evidence: what a case measured and what the simulator says of it, in bins of time and patches of the scanned face. */
#include "explain/evidence.h"

#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "cut/setup.h"
#include "foam/empirical.h"

enum { NODES_FINE = WCUT_NODES_FINE, NODES_COARSE = WCUT_NODES_COARSE, PARTS = 5 };

/* trajectories: smoothing of the encoder, of the exogenous progress, and the step of the latter [s] */
#define WINDOW 0.5
#define WIDTH 2.5
#define STEP 0.25
#define FED_BACK_STEP 0.05
/* the first two seconds after the wire is taut and the last one are the least physical part of a cut */
#define SETTLE 2.0
#define LAST 1.5

/* standard deviation of a normal distribution over its median distance from the middle */
#define NORMAL_OF_MEDIAN 1.4826

/* ---- models ---- */

/* way that a wire has gone through foam in the cuts before, at the middle of the block */
static double way_before(const wcut_evidence *e, int cut) {
    double way = 0;
    for (int k = 0; k < cut; k++)
        if (e->cut[k].job) way += e->cut[k].job->block_size.y;
    return way;
}

bool wcut_term_place(const wcut_evidence *e, int cut, bool carried, wcut_effect *effect) {
    /* the way and the time of the cuts before this one */
    double way = 0, time = 0;
    for (int k = 0; k < cut; k++) {
        if (!e->cut[k].job) continue;
        way += e->cut[k].job->block_size.y;
        if (e->cut[k].recorded.count > 0) time += e->cut[k].recorded.time[e->cut[k].recorded.count - 1];
    }

    /* write into the term what depends on the cut */
    switch (effect->choice) {
        case WCUT_TERM_ORDER:
            effect->value[WCUT_EMPIRICAL_FORCE_NUMBER] = cut;
            return true;
        case WCUT_TERM_CLOCK:
            effect->value[WCUT_EMPIRICAL_FORCE_START_TIME] = carried ? time : 0;
            return true;
        case WCUT_TERM_WAY:
            effect->value[WCUT_EMPIRICAL_FORCE_START] = carried ? way : 0;
            return true;
        case WCUT_TERM_WINDOW:
            if (WCUT_WINDOW_CUT(effect) != cut) return false;
            effect->value[WCUT_EMPIRICAL_FORCE_COSINE] = 0;
            return true;
        default:
            return true;
    }
}

wcut_job wcut_model_job(const wcut_evidence *e, const wcut_model *model, int cut, wcut_effect *effect) {
    wcut_job job = *e->cut[cut].job;
    job.force_law.a = model->a, job.force_law.b = model->b;
    job.wire_length += model->length_change + e->cut[cut].own_length;
    int count = 0;
    for (int k = 0; k < model->effects; k++) {
        effect[count] = model->effect[k];
        if (effect[count].kind == WCUT_EFFECT_WIRE_FOULING && model->carried)
            effect[count].value[WCUT_WIRE_FOULING_START] = way_before(e, cut);
        if (effect[count].kind == WCUT_EFFECT_EMPIRICAL_FORCE &&
            !wcut_term_place(e, cut, model->carried, &effect[count]))
            continue;
        count++;
    }
    job.effect_count = count, job.effect = effect;
    return job;
}

/* ---- bins ---- */

static double nan_value(void) { return (double)NAN; }

/* mean of samples in each bin; NaN where fewer than half of the usual number are there */
static void bin_samples(const wcut_evidence_cut *c, int n, const double *time, const double *value, int *count,
                        double *out) {
    int max = 0;
    for (int i = 0; i < c->bins; i++) count[i] = 0, out[i] = 0;
    for (int i = 0; i < n; i++) {
        const double place = (time[i] - c->from) / WCUT_BIN_WIDTH;
        if (!(place >= 0) || place >= c->bins || !isfinite(value[i])) continue;
        count[(int)place]++, out[(int)place] += value[i];
    }
    for (int i = 0; i < c->bins; i++) max = count[i] > max ? count[i] : max;
    for (int i = 0; i < c->bins; i++) out[i] = count[i] > 0 && 2 * count[i] >= max ? out[i] / count[i] : nan_value();
}

/* of a normal distribution */
#define NORMAL_95 1.96
/* readings beside each other, and how many spreads one may be off their median */
enum { NEIGHBOURS = 3 };
#define FAR_READING 6.0

/* distance of reading i from the median of those about it; they are the last ones there are */
static double off_neighbours(int count, const double *value, int i) {
    double about[NEIGHBOURS];
    const int half = NEIGHBOURS / 2, last = count - NEIGHBOURS;
    const int from = i < half ? 0 : i - half > last ? last : i - half;
    memcpy(about, value + from, sizeof about);
    wcut_sort(NEIGHBOURS, about);
    return fabs(value[i] - about[half]);
}

/*
 * Leave out single readings that lie far from those before and after them (Hampel 1974): they become NaN. A signal that
 * steps takes its neighbours along, and keeps its readings. room: 2 n.
 */
static void drop_outliers(int n, double *value, double *room) {
    double *kept = room, *off = room + n;
    int count = 0;
    for (int i = 0; i < n; i++)
        if (isfinite(value[i])) kept[count++] = value[i];
    if (count < NEIGHBOURS) return;

    /* the spread that neighbours have, but for one in twenty: a signal that is quiet and then moves keeps what it shows */
    for (int i = 0; i < count; i++) off[i] = off_neighbours(count, kept, i);
    wcut_sort(count, off);
    const double limit = FAR_READING / NORMAL_95 * sorted_quantile(count, off, 0.95);
    if (!(limit > 0)) return;
    for (int i = 0, k = 0; i < n; i++) {
        if (!isfinite(value[i])) continue;
        if (off_neighbours(count, kept, k++) > limit) value[i] = nan_value();
    }
}

/* mean of the broken line through a trajectory's values over each bin */
static void bin_line(const wcut_evidence_cut *c, const wcut_trajectory *t, const double *value, double *out) {
    for (int i = 0; i < c->bins; i++) {
        double sum = 0;
        for (int k = 0; k < PARTS; k++)
            sum += wcut_between(t->count, t->time, value, c->from + (i + (k + 0.5) / PARTS) * WCUT_BIN_WIDTH);
        out[i] = sum / PARTS;
    }
}

/* signals of a run as faulty instruments would show them; room: 6 x count */
static wcut_status sense_response(const wcut_model *model, const double *time, const wcut_response *d, double *room) {
    double *value[WCUT_SENSED_COUNT] = {NULL};
    for (int k = 0; k < WCUT_SIGNALS; k++) {
        value[WCUT_SENSED_TENSION_A + k] = room + (size_t)k * (size_t)d->count;
        memcpy(room + (size_t)k * (size_t)d->count, d->signal[k], (size_t)d->count * sizeof *room);
    }
    return wcut_sensors_eval(model->effects, model->effect, d->count, time, d->present, value);
}

wcut_status wcut_evidence_bin_recorded(const wcut_evidence_cut *c, const wcut_model *model, const wcut_response *d,
                                       double *out) {
    const size_t n = (size_t)d->count;
    double *room = wcut_alloc(WCUT_SIGNALS * n, sizeof *room);
    int *count = wcut_alloc((size_t)c->bins, sizeof *count);
    wcut_status status = room && count ? sense_response(model, c->recorded.time, d, room) : WCUT_NO_MEMORY;
    for (int k = 0; status == WCUT_OK && k < WCUT_SIGNALS; k++) {
        for (size_t i = 0; i < n; i++)
            if (!d->present[i]) room[(size_t)k * n + i] = nan_value();
        bin_samples(c, d->count, c->recorded.time, room + (size_t)k * n, count, out + (size_t)k * (size_t)c->bins);
    }
    wcut_free(room);
    wcut_free(count);
    return status;
}

/* ---- rows ---- */

/* a trajectory's place of a station: the sample before it and the way to the next */
static int sample_of_station(const wcut_trajectory *t, double station, double *way) {
    int low = 0, high = t->count - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (t->station[middle] <= station)
            low = middle;
        else
            high = middle;
    }
    const double step = t->station[high] - t->station[low];
    *way = step > 0 ? clamp((station - t->station[low]) / step, 0, 1) : 0;
    return low;
}

static int across_node(int nodes, double across, double *way) {
    const double place = clamp(across, 0, 1) * (nodes - 1);
    const int node = (int)fmin(floor(place), nodes - 2);
    *way = place - node;
    return node;
}

wcut_vec3 wcut_response_position(const wcut_trajectory *t, const wcut_response *d, double station, double across) {
    double along, beside;
    const int i = sample_of_station(t, station, &along), j = across_node(d->nodes, across, &beside);
    const wcut_vec3 *low = d->position + (size_t)i * (size_t)d->nodes + j, *high = low + d->nodes;
    return vec3_mix(vec3_mix(low[0], low[1], beside), vec3_mix(high[0], high[1], beside), along);
}

double wcut_response_speed(const wcut_trajectory *t, const wcut_response *d, double station, double across) {
    double along, beside;
    const int i = sample_of_station(t, station, &along), j = across_node(d->nodes, across, &beside);
    const double *low = d->speed + (size_t)i * (size_t)d->nodes + j, *high = low + d->nodes;
    return (1 - along) * ((1 - beside) * low[0] + beside * low[1]) +
           along * ((1 - beside) * high[0] + beside * high[1]);
}

static wcut_status patch_rows(const wcut_evidence_cut *c, const wcut_model *model, const wcut_response *d,
                              double *out) {
    const wcut_patches *p = &c->patch;
    wcut_vec3 *moved = wcut_copy(p->point, (size_t)p->count, sizeof *moved);
    if (!moved) return WCUT_NO_MEMORY;
    const wcut_status status =
        wcut_face_eval(model->effects, model->effect, c->job->block_size, p->count, p->normal, p->q_eff, moved);
    for (int k = 0; status == WCUT_OK && k < p->count; k++) {
        const wcut_vec3 now = wcut_response_position(&c->exogenous, d, p->station[k], p->across[k]);
        const wcut_vec3 then = wcut_response_position(&c->exogenous, &c->reference, p->station[k], p->across[k]);
        const wcut_vec3 way = vec3_add(vec3_sub(now, then), vec3_sub(moved[k], p->point[k]));
        out[k] = vec3_dot(p->normal[k], way);
    }
    wcut_free(moved);
    return status;
}

wcut_status wcut_evidence_bin_exogenous(const wcut_evidence_cut *c, const wcut_model *model, const wcut_response *d,
                                        double *out) {
    double *room = wcut_alloc((size_t)WCUT_SIGNALS * (size_t)d->count, sizeof *room);
    const wcut_status status = room ? sense_response(model, c->exogenous.time, d, room) : WCUT_NO_MEMORY;
    for (int k = 0; status == WCUT_OK && k < WCUT_SIGNALS; k++)
        bin_line(c, &c->exogenous, room + (size_t)k * (size_t)d->count, out + (size_t)k * (size_t)c->bins);
    wcut_free(room);
    return status;
}

wcut_status wcut_evidence_rows(const wcut_evidence *e, int cut, const wcut_model *model, const wcut_response *d,
                               double *out) {
    const wcut_evidence_cut *c = &e->cut[cut];
    if (c->bins == 0) return WCUT_OK;
    const wcut_status status = wcut_evidence_bin_exogenous(c, model, d, out + c->row);
    if (status != WCUT_OK || c->patch.count == 0) return status;
    return patch_rows(c, model, d, out + c->row + (ptrdiff_t)WCUT_SIGNALS * c->bins);
}

void wcut_evidence_residual(const wcut_evidence *e, double *out) {
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int s = 0; s < WCUT_SIGNALS; s++)
            for (int i = 0; i < c->bins; i++) out[c->row + s * c->bins + i] = c->measured[s][i] - c->predicted[s][i];
        for (int i = 0; i < c->patch.count; i++) out[c->row + WCUT_SIGNALS * c->bins + i] = c->patch.distance[i];
    }
    for (int i = 0; e->own_rows && i < e->rows; i++) out[i] += e->own_rows[i];
}

/* variance of what is new in the next sample, in units of the white noise; the filter of white and slow noise */
typedef struct innovations {
    double keep, slow, mean, variance;
} innovations;

static innovations begin_innovations(double slow) {
    return (innovations){.keep = exp(-WCUT_BIN_WIDTH / WCUT_NOISE_MEMORY), .slow = slow, .variance = slow};
}

static void pass_bin(innovations *f) {
    f->mean *= f->keep;
    f->variance = f->keep * f->keep * f->variance + (1 - f->keep * f->keep) * f->slow;
}

void wcut_evidence_whiten(const wcut_evidence *e, const double *residual, const double *in, double *out) {
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int s = 0; s < WCUT_SIGNALS; s++) {
            /* each channel has its own filter, begun anew in each cut */
            innovations f = begin_innovations(e->noise.slow[wcut_noise_group(s)]);

            /* a reading: the innovation of the Kalman filter with unit variance, then the update of the slow part */
            for (int i = 0; i < c->bins; i++) {
                const int row = c->row + s * c->bins + i;
                if (isfinite(residual[row])) {
                    const double innovation = in[row] / e->sigma[s] - f.mean, size = f.variance + 1;
                    out[row] = innovation / sqrt(size);
                    f.mean += f.variance / size * innovation;
                    f.variance /= size;
                } else {
                    /* a gap: no innovation, the variance grows */
                    out[row] = 0;
                }
                pass_bin(&f);
            }
        }

        /* patches of a scan are white */
        for (int i = 0; i < c->patch.count; i++) {
            const int row = c->row + WCUT_SIGNALS * c->bins + i;
            out[row] = in[row] / c->patch.sigma[i];
        }
    }
}

double wcut_evidence_log_det(const wcut_evidence *e, const double *residual) {
    double sum = 0;
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int s = 0; s < WCUT_SIGNALS; s++) {
            innovations f = begin_innovations(e->noise.slow[wcut_noise_group(s)]);
            for (int i = 0; i < c->bins; i++) {
                if (isfinite(residual[c->row + s * c->bins + i])) {
                    const double size = f.variance + 1;
                    sum += log(size);
                    f.variance /= size;
                }
                pass_bin(&f);
            }
        }
    }
    return sum;
}

void wcut_evidence_whiten_scatter(wcut_evidence *e, const double *residual) {
    for (int k = 0; k < e->scatter.count; k++) {
        const size_t at = (size_t)k * (size_t)e->rows;
        wcut_evidence_whiten(e, residual, e->scatter.column + at, e->scatter.white + at);
    }
}

/* ---- creation ---- */

static void destroy_cut(wcut_evidence_cut *c) {
    wcut_trajectory_destroy(&c->recorded);
    wcut_trajectory_destroy(&c->exogenous);
    wcut_response_destroy(&c->reference);
    wcut_patches_destroy(&c->patch);
    wcut_free(c->middle);
    for (int s = 0; s < WCUT_SIGNALS; s++) wcut_free(c->measured[s]), wcut_free(c->predicted[s]);
    wcut_free(c->station);
    wcut_free(c->heat);
    wcut_free(c->pace);
    wcut_free(c->engaged);
}

void wcut_evidence_destroy(wcut_evidence *e) {
    if (!e) return;
    for (int k = 0; e->cut && k < e->cuts; k++) destroy_cut(&e->cut[k]);
    wcut_scatter_destroy(&e->scatter);
    wcut_free(e->own_rows);
    wcut_free(e->cut);
    wcut_free(e);
}

/* when the wire is taut, and when most of it has left; false where it never is */
static bool find_taut_span(wcut_evidence_cut *c, const wcut_response *d) {
    const wcut_trajectory *t = &c->exogenous;
    double max = 0;
    int first = -1, last = -1;
    for (int i = 0; i < d->count; i++) max = fmax(max, d->engaged[i]);
    for (int i = 0; i < d->count; i++) {
        if (first < 0 && d->present[i] && d->signal[0][i] > 0.25 * c->job->tension) first = i;
        if (first >= 0 && d->engaged[i] > 0.3 * max) last = i;
    }
    if (first < 0 || last < first) return false;
    c->contact = t->time[first], c->leave = t->time[last];
    return true;
}

static bool make_bins(wcut_evidence_cut *c) {
    const double end = fmin(c->recorded.time[c->recorded.count - 1] - LAST, c->leave - 0.5);
    c->from = c->contact + SETTLE;
    const double bins = floor((end - c->from) / WCUT_BIN_WIDTH);
    c->bins = bins >= 8 ? (int)fmin(bins, 100000) : 0;
    const size_t n = (size_t)c->bins;
    bool whole = (c->middle = wcut_alloc(n, sizeof(double))) != NULL;
    for (int s = 0; s < WCUT_SIGNALS; s++) {
        c->measured[s] = wcut_alloc(n, sizeof(double));
        c->predicted[s] = wcut_alloc(n, sizeof(double));
        whole = whole && c->measured[s] && c->predicted[s];
    }
    c->station = wcut_alloc(n, sizeof(double));
    c->heat = wcut_alloc(n, sizeof(double));
    c->pace = wcut_alloc(n, sizeof(double));
    c->engaged = wcut_alloc(n, sizeof(double));
    return whole && c->station && c->heat && c->pace && c->engaged;
}

/* Noise of a bin's mean by the median step from reading to reading, which nothing slow reaches; readings that repeat
   themselves more often than not say nothing: 0. room: n. */
static double noise_within(const wcut_evidence_cut *c, int n, const double *value, double *room) {
    int steps = 0, readings = 0;
    for (int i = 0; i < n; i++) {
        const double place = (c->recorded.time[i] - c->from) / WCUT_BIN_WIDTH;
        if (!(place >= 0) || place >= c->bins || !isfinite(value[i])) continue;
        readings++;
        if (i > 0 && isfinite(value[i - 1])) room[steps++] = fabs(value[i] - value[i - 1]);
    }
    if (steps < 2 * c->bins) return 0;
    wcut_sort(steps, room);
    return NORMAL_OF_MEDIAN * sorted_median(steps, room) / sqrt(2) / sqrt((double)readings / c->bins);
}

static wcut_status measure_cut(wcut_evidence_cut *c, const wcut_response *d) {
    const int n = c->recorded.count;
    double *value = wcut_alloc(3 * (size_t)n, sizeof *value); /* and room */
    int *count = wcut_alloc((size_t)c->bins, sizeof *count);

    /* the recorded signals, averaged in each bin; gaps become NaN */
    if (value && count) {
        for (int s = 0; s < WCUT_SIGNALS; s++) {
            const wcut_column *column = &c->recording->channel[WCUT_CHANNEL_TENSION_A + s];
            for (int i = 0; i < n; i++) {
                const int sample = c->recorded.sample[i];
                value[i] = !column->present || column->present[sample] ? column->value[sample] : nan_value();
            }
            drop_outliers(n, value, value + n);
            bin_samples(c, n, c->recorded.time, value, count, c->measured[s]);
            if (c->bins > 0) c->within[s] = noise_within(c, n, value, value + n);
        }

        /* station, heat and engaged length in the same bins */
        bin_line(c, &c->exogenous, c->exogenous.station, c->station);
        bin_line(c, &c->exogenous, c->exogenous.heat, c->heat);
        bin_line(c, &c->exogenous, d->engaged, c->engaged);

        /* the pace: way of the faster mount over a bin, from the progress at its two ends */
        for (int i = 0; i < c->bins; i++) {
            c->middle[i] = c->from + (i + 0.5) * WCUT_BIN_WIDTH;
            const int j = (int)clamp(floor(c->station[i]), 0, c->job->stations - 2);
            const double way = fmax(vec3_distance(c->job->mount_a[j], c->job->mount_a[j + 1]),
                                    vec3_distance(c->job->mount_b[j], c->job->mount_b[j + 1]));
            const double half = WCUT_BIN_WIDTH / 2;
            const wcut_trajectory *t = &c->exogenous;
            c->pace[i] = way / WCUT_BIN_WIDTH *
                         (wcut_between(t->count, t->time, t->station, c->middle[i] + half) -
                          wcut_between(t->count, t->time, t->station, c->middle[i] - half));
        }
    }

    /* release the scratch */
    const wcut_status status = value && count ? WCUT_OK : WCUT_NO_MEMORY;

    wcut_free(value);
    wcut_free(count);
    return status;
}

static wcut_status fill_evidence_cut(wcut_evidence_cut *c, bool fed_back, wcut_stop *stop, wcut_error *error) {
    wcut_status status = wcut_trajectory_recorded(c->job, c->recording, WINDOW, &c->recorded, error);
    if (status != WCUT_OK) return status;
    status = fed_back ? wcut_trajectory_thin(&c->recorded, FED_BACK_STEP, &c->exogenous)
                      : wcut_trajectory_exogenous(c->job, &c->recorded, WIDTH, STEP, &c->exogenous);
    if (status == WCUT_BAD_ARGUMENT) return WCUT_OK; /* too short to say anything: no bins */
    wcut_response d = {0};
    if (status == WCUT_OK) status = wcut_response_run(c->job, NODES_COARSE, &c->exogenous, false, stop, &d, error);
    if (status != WCUT_OK) return status;
    if (find_taut_span(c, &d)) status = make_bins(c) ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK && c->bins > 0) status = measure_cut(c, &d);
    wcut_response_destroy(&d);
    return status == WCUT_NO_MEMORY ? wcut_fail(error, status, "no memory for cut %d", c->index + 1) : status;
}

void wcut_evidence_know(wcut_evidence *e, const wcut_rig_prior *prior) {
    wcut_scatter_know(prior, e->known);
    e->noise.known = e->known;
    e->delay_spread[0] = prior->tension_delay, e->delay_spread[1] = prior->angle_delay;
}

wcut_status wcut_evidence_create(int cuts, const wcut_diagnosis_cut *cut, bool fed_back, int threads, wcut_stop *stop,
                                 wcut_evidence **out, wcut_error *error) {
    wcut_evidence *e = wcut_alloc(1, sizeof *e);
    wcut_error *failed = wcut_alloc((size_t)cuts, sizeof *failed);
    wcut_status status = WCUT_OK;

    /* the borrowed inputs and the options of the whole case */
    if (e)
        *e = (wcut_evidence){.cuts = cuts,
                             .cut = wcut_alloc((size_t)cuts, sizeof *e->cut),
                             .threads = wcut_threads(threads),
                             .stop = stop};
    if (!e || !failed || !e->cut) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d cuts", cuts);

    /* take the cuts that are whole; one without a job or a recording stays empty */
    const wcut_job *first = NULL;
    for (int k = 0; status == WCUT_OK && k < cuts; k++) {
        const bool whole = cut[k].job && cut[k].recording;
        e->cut[k].index = k;
        if (!whole) continue;
        e->cut[k].job = cut[k].job, e->cut[k].recording = cut[k].recording, e->cut[k].scan = cut[k].scan;
        if (!first) first = cut[k].job;
    }
    if (status == WCUT_OK && !first)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "found no cut with a job and a recording, expected one at least");

    /* the model is the first job's own; every channel begins with the usual slow noise */
    if (status == WCUT_OK) {
        e->at = (wcut_model){.a = first->force_law.a, .b = first->force_law.b};
        const wcut_rig_prior usual = wcut_rig_prior_default();
        wcut_evidence_know(e, &usual);
        for (int g = 0; g < WCUT_NOISE_GROUPS; g++) e->noise.slow[g] = WCUT_SLOW_NOISE;
#pragma omp parallel for num_threads(wcut_threads(threads)) schedule(dynamic, 1)
        for (int k = 0; k < cuts; k++)
            if (e->cut[k].job) failed[k].status = fill_evidence_cut(&e->cut[k], fed_back, stop, &failed[k]);
    }

    /* rows of the cuts one after the other */
    for (int k = 0; status == WCUT_OK && k < cuts; k++) {
        if (failed[k].status != WCUT_OK)
            status = wcut_fail(error, failed[k].status, "cut %d: %s", k + 1, failed[k].text);
        e->cut[k].row = e->rows;
        e->rows += WCUT_SIGNALS * e->cut[k].bins;
    }
    if (status == WCUT_OK && e->rows == 0)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "found no cut that is 4 s in the foam, expected one at least");
    wcut_free(failed);

    /* hand over, or release */
    if (status == WCUT_OK)
        *out = e;
    else
        wcut_evidence_destroy(e);

    return status;
}

/* ---- prediction along the recorded motion ---- */

static double median(int n, double *value) {
    if (n == 0) return 0;
    wcut_sort(n, value);
    return sorted_median(n, value);
}

/* white part of a channel's noise in a bin: from the median of steps between neighbours, which no slow misfit reaches */
static double white_noise(const wcut_evidence *e, int s, double *room) {
    int n = 0;
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int i = 1; i < c->bins; i++) {
            const double step =
                c->measured[s][i] - c->predicted[s][i] - (c->measured[s][i - 1] - c->predicted[s][i - 1]);
            if (isfinite(step)) room[n++] = fabs(step);
        }
    }
    const double floor = s < 2 ? 1e-4 : 1e-5; /* [N], [rad]: channels without noise, of simulated recordings */
    return fmax(NORMAL_OF_MEDIAN * median(n, room) / sqrt(2), floor);
}

double wcut_evidence_swiftness(const wcut_evidence *e) {
    double most = 0;
    for (int s = 0; s < 2; s++) {
        double square = 0;
        int cuts = 0;
        for (int k = 0; k < e->cuts; k++)
            if (e->cut[k].bins > 0 && e->cut[k].within[s] > 0) square += pow(e->cut[k].within[s], 2), cuts++;
        if (cuts > 0) most = fmax(most, e->sigma[s] / sqrt(square / cuts));
    }

    return most;
}

static wcut_status predict_cut(wcut_evidence *e, int k, bool scans, wcut_error *error) {
    wcut_evidence_cut *c = &e->cut[k];

    /* the job under this model; its effects stand in `effect` */
    const bool scan = scans && c->scan;
    wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
    const wcut_job job = wcut_model_job(e, &e->at, k, effect);
    double *out = wcut_alloc((size_t)WCUT_SIGNALS * (size_t)c->bins, sizeof *out);
    wcut_response d = {0}, reference = {0};

    /* the fine wire along the recorded motion: what the measured values are compared with */
    wcut_status status = out ? wcut_response_run(&job, NODES_FINE, &c->recorded, scan, e->stop, &d, error)
                             : wcut_fail(error, WCUT_NO_MEMORY, "no memory");
    if (status == WCUT_OK) status = wcut_evidence_bin_recorded(c, &e->at, &d, out);

    /* the coarse wire along the exogenous motion: the reference of all differences */
    if (status == WCUT_OK)
        status = wcut_response_run(&job, NODES_COARSE, &c->exogenous, scan, e->stop, &reference, error);

    /* copy and replace only once both runs have succeeded */
    for (int s = 0; status == WCUT_OK && s < WCUT_SIGNALS; s++)
        memcpy(c->predicted[s], out + (size_t)s * (size_t)c->bins, (size_t)c->bins * sizeof *out);
    if (status == WCUT_OK) {
        wcut_response_destroy(&c->reference);
        c->reference = reference;
        reference = (wcut_response){0};

        /* patches of the scan belong to the face of this run */
        if (scan) {
            wcut_patches_destroy(&c->patch);
            status = wcut_patches_create(c, &d, &c->patch, error);
        }
    }

    wcut_response_destroy(&reference);
    wcut_response_destroy(&d);
    wcut_free(out);
    return status;
}

wcut_status wcut_evidence_predict(wcut_evidence *e, const wcut_model *model, bool scans, wcut_error *error) {
    wcut_error *failed = wcut_alloc((size_t)e->cuts, sizeof *failed);
    if (!failed) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d cuts", e->cuts);

    /* every cut is driven by itself */
    e->at = *model;
    wcut_free(e->own_rows);
    e->own_rows = NULL;
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
    for (int k = 0; k < e->cuts; k++)
        if (e->cut[k].bins > 0) failed[k].status = predict_cut(e, k, scans, &failed[k]);

    /* rows anew, because the number of patches may have changed */
    wcut_status status = WCUT_OK;
    e->rows = 0;
    for (int k = 0; k < e->cuts; k++) {
        if (status == WCUT_OK && failed[k].status != WCUT_OK)
            status = wcut_fail(error, failed[k].status, "cut %d: %s", k + 1, failed[k].text);
        e->cut[k].row = e->rows;
        e->rows += WCUT_SIGNALS * e->cut[k].bins + e->cut[k].patch.count;
    }
    wcut_free(failed);
    if (status != WCUT_OK) return status;

    /* the white part of the noise from steps between neighbouring bins */
    double *room = wcut_alloc((size_t)e->rows, sizeof *room);
    if (!room) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", e->rows);
    for (int s = 0; s < WCUT_SIGNALS; s++) e->sigma[s] = white_noise(e, s, room);

    wcut_free(room);
    return WCUT_OK;
}

/* [mm] that a wire keeps over the distance of its mounts */
#define SLACK_MIN 0.02

double wcut_model_shortest(const wcut_evidence *e) {
    double shortest = -HUGE_VAL;

    /* cuts without samples are not simulated */
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        double chord = 0;
        if (c->bins == 0) continue;

        /* the longest distance of the mounts on the way */
        for (int j = 0; j < c->job->stations; j++)
            chord = fmax(chord, vec3_distance(c->job->mount_a[j], c->job->mount_b[j]));
        shortest = fmax(shortest, chord + SLACK_MIN - c->job->wire_length - c->own_length);
    }

    return fmin(shortest, 0);
}
