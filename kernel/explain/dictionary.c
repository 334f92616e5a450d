/* The dictionary: empirical terms that the foam's force may follow, as a case is searched for them. */
#include "explain/dictionary.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "foam/empirical.h"
#include "foam/force_law.h"

/* ---- what is fitted ---- */

/* [1] a relative change of the force: prior, step, and what is plausible at all */
static const wcut_coordinate coefficient = {0, WCUT_COORDINATE_SCALE_LINEAR, 0, 0.5, 0.03, -1.5, 1.5};

int wcut_term_coordinates(const wcut_effect *effect) {
    /* waves, bands and windows: a coefficient and two shape parameters */
    switch (effect->choice) {
        case WCUT_TERM_WAVE_X:
        case WCUT_TERM_WAVE_Y:
        case WCUT_TERM_WAVE_Z:
        case WCUT_TERM_BAND_X:
        case WCUT_TERM_BAND_Y:
        case WCUT_TERM_BAND_Z:
        case WCUT_TERM_WINDOW:
            return 3;

        /* a step, a hinge, a relaxation or a memory: a coefficient and its one scale */
        case WCUT_TERM_HEAT_STEP:
        case WCUT_TERM_HEAT_HINGE:
        case WCUT_TERM_ENTRY:
        case WCUT_TERM_SPEED_MEMORY:
        case WCUT_TERM_HEAT_MEMORY:
            return 2;

        /* all others are linear in their coefficient */
        default:
            return 1;
    }
}

wcut_coordinate wcut_term_coordinate(const wcut_effect *effect, int k) {
    /* the coefficient is the same for all terms */
    if (k == 0) return coefficient;

    /* shape parameters: where in value[], scale, start, prior width, step of differences, bounds */
    switch (effect->choice) {
        case WCUT_TERM_WAVE_X:
        case WCUT_TERM_WAVE_Y:
        case WCUT_TERM_WAVE_Z:
            if (k == 1)
                return (wcut_coordinate){
                    WCUT_EMPIRICAL_FORCE_COSINE, WCUT_COORDINATE_SCALE_LINEAR, 0, 0.5, 0.03, -3, 3};
            return (wcut_coordinate){
                WCUT_EMPIRICAL_FORCE_SHAPE, WCUT_COORDINATE_SCALE_LOG, 4.5 /* ln 90 mm */, 1.5, 0.004, 2.7, 7.6};

        /* bands and windows: both ends, in mm or s, bounded by the data alone */
        case WCUT_TERM_BAND_X:
        case WCUT_TERM_BAND_Y:
        case WCUT_TERM_BAND_Z:
            return (wcut_coordinate){
                WCUT_EMPIRICAL_FORCE_SHAPE + k - 1, WCUT_COORDINATE_SCALE_LINEAR, 0, 1e4, 3, -500, 5000};
        case WCUT_TERM_WINDOW:
            return (wcut_coordinate){
                WCUT_EMPIRICAL_FORCE_SHAPE + k - 1, WCUT_COORDINATE_SCALE_LINEAR, 0, 1e4, 0.2, -1e4, 1e5};
        case WCUT_TERM_HEAT_STEP:
        case WCUT_TERM_HEAT_HINGE:
            return (wcut_coordinate){
                WCUT_EMPIRICAL_FORCE_SHAPE, WCUT_COORDINATE_SCALE_LOG, 8.5 /* ln 5000 J/m^2 */, 1.5, 0.02, 5, 14};

        /* time constants, around e^0.5 = 1.6 s */
        default:
            return (wcut_coordinate){WCUT_EMPIRICAL_FORCE_SHAPE, WCUT_COORDINATE_SCALE_LOG, 0.5, 1.5, 0.1, -2.3, 5};
    }
}

/* ---- what is tried ---- */

typedef struct ranges {
    wcut_vec3 size, low, high;         /* of the blocks; of the wire in them [mm] */
    double q_low, q_high, speed, heat; /* Q_eff of the bins [J/m^2], medians would do */
} ranges;

static ranges ranges_of(const wcut_evidence *e) {
    ranges r = {.low = {1e9, 1e9, 1e9}, .high = {-1e9, -1e9, -1e9}, .q_low = 1e12, .q_high = 0};
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        if (c->bins == 0) continue;
        const wcut_job *job = c->job;
        r.size = vec3(fmax(r.size.x, job->block_size.x), fmax(r.size.y, job->block_size.y),
                      fmax(r.size.z, job->block_size.z));
        for (int j = 0; j < job->stations; j++) {
            const wcut_vec3 at[2] = {job->mount_a[j], job->mount_b[j]};
            for (int m = 0; m < 2; m++) r.low.z = fmin(r.low.z, at[m].z), r.high.z = fmax(r.high.z, at[m].z);
        }
        for (int i = 0; i < c->bins; i++) {
            const double q = MM_PER_M * c->heat[i] / fmax(c->pace[i], 0.1);
            r.q_low = fmin(r.q_low, q), r.q_high = fmax(r.q_high, q);
        }
    }
    return r;
}

typedef struct list {
    wcut_entry *out;
    int count;
} list;

static void add_entry(list *l, wcut_term term, double shape0, double shape1, bool carried) {
    if (l->count == WCUT_ENTRIES_MAX) return;
    wcut_entry *entry = &l->out[l->count++];
    *entry = (wcut_entry){.effect = wcut_effect_choose(WCUT_EFFECT_EMPIRICAL_FORCE, term), .carried = carried};
    entry->effect.value[WCUT_EMPIRICAL_FORCE_COEFFICIENT] = 1;
    if (shape0 != 0) entry->effect.value[WCUT_EMPIRICAL_FORCE_SHAPE] = shape0;
    if (shape1 != 0) entry->effect.value[WCUT_EMPIRICAL_FORCE_SHAPE + 1] = shape1;
}

static void add_wave(list *l, wcut_term term, double wavelength) {
    if (l->count + 2 > WCUT_ENTRIES_MAX) return;
    add_entry(l, term, wavelength, 0, false);
    l->out[l->count - 1].pair = true;
    add_entry(l, term, wavelength, 0, false);
    l->out[l->count - 1].effect.value[WCUT_EMPIRICAL_FORCE_COEFFICIENT] = 0;
    l->out[l->count - 1].effect.value[WCUT_EMPIRICAL_FORCE_COSINE] = 1;
}

/* evenly in frequency, close enough for none to fall between two: a third of a turn over the extent */
static void add_waves(list *l, wcut_term term, double extent, double shortest, double longest, int max) {
    const int count = (int)clamp(ceil(3 * extent * (1 / shortest - 1 / longest)), 2, max);
    for (int k = 0; k < count; k++) {
        const double share = k / (count - 1.0);
        add_wave(l, term, 1 / ((1 - share) / longest + share / shortest));
    }
}

static void add_bands(list *l, wcut_term term, double from, double to, const double *width, int widths) {
    for (int k = 0; k < widths; k++)
        for (double at = from; at < to; at += width[k] / 2) add_entry(l, term, fmax(at, 1e-3), at + width[k], false);
}

/* cuts that follow each other against the others, two at least on either side: another batch, another wire */
static void add_ranges(list *l, int cuts) {
    for (int from = 0; from < cuts && cuts <= 12; from++)
        for (int to = from + 1; to < cuts && to - from + 3 <= cuts; to++) {
            add_entry(l, WCUT_TERM_ORDER, 0, 0, false);
            l->out[l->count - 1].effect.value[WCUT_EMPIRICAL_FORCE_SHAPE + 1] = from;
            l->out[l->count - 1].effect.value[WCUT_EMPIRICAL_FORCE_SHAPE + 2] = to;
        }
}

int wcut_dictionary_list(const wcut_evidence *e, wcut_entry *out) {
    static const double time[] = {0.4, 0.8, 1.6, 3.2, 6.4, 12.8}, y_width[] = {50, 100, 200}, z_width[] = {25, 50};
    const ranges r = ranges_of(e);

    /* the number of cuts that are there decides which terms can be told apart */
    int cuts = 0;
    for (int k = 0; k < e->cuts; k++) cuts += e->cut[k].bins > 0;
    list l = {out, 0};

    /* polynomials in the position of the node, and the direction of its motion */
    for (int axis = 0; axis < 3; axis++)
        for (int degree = 1; degree <= 4; degree++) add_entry(&l, WCUT_TERM_POSITION_X + axis, degree, 0, false);
    for (int axis = 0; axis < 3; axis++)
        for (int order = 1; order <= 2; order++) add_entry(&l, WCUT_TERM_DIRECTION_X + axis, order, 0, false);

    /* thresholds in Q_eff at seven places of its range, where that range is wide enough */
    const double q_range = log(r.q_high / r.q_low);
    for (int k = 1; k <= 7 && q_range > 0.05; k++) {
        const double q = r.q_low * exp(q_range * k / 8);
        add_entry(&l, WCUT_TERM_HEAT_STEP, q, 0.05 * q, false);
        add_entry(&l, WCUT_TERM_HEAT_HINGE, q, 0.05 * q, false);
    }

    /* other functions of heat, speed and shape */
    add_entry(&l, WCUT_TERM_HEAT_INVERSE, sqrt(r.q_low * r.q_high), 0, false);
    add_entry(&l, WCUT_TERM_LOG_SPEED, 0, 0, false);
    add_entry(&l, WCUT_TERM_CURVATURE, 0, 0, false);

    /* what decays after entry, and what grows with the way and the time, from zero in each cut or carried over */
    for (int k = 1; k < 6; k++) add_entry(&l, WCUT_TERM_ENTRY, time[k], 0, false);
    for (int carried = 0; carried < (cuts > 1 ? 2 : 1); carried++) {
        add_entry(&l, WCUT_TERM_WAY, 0, 0, carried);
        add_entry(&l, WCUT_TERM_CLOCK, 0, 0, carried);
    }

    /* between cuts: their number, and ranges of them */
    if (cuts > 1) add_entry(&l, WCUT_TERM_ORDER, 0, 0, false);
    add_ranges(&l, e->cuts);

    /* memories of speed and heat, by time constant */
    for (int k = 0; k < 6; k++) {
        add_entry(&l, WCUT_TERM_SPEED_MEMORY, time[k], 0, false);
        add_entry(&l, WCUT_TERM_HEAT_MEMORY, time[k], 0, false);
    }

    /* periodic in space along each axis, and bands across y and z */
    add_waves(&l, WCUT_TERM_WAVE_Y, r.size.y, 35, 500, 80);
    add_waves(&l, WCUT_TERM_WAVE_Z, fmax(r.high.z - r.low.z, 50), 30, 300, 20);
    add_waves(&l, WCUT_TERM_WAVE_X, r.size.x, 60, 600, 20);
    add_bands(&l, WCUT_TERM_BAND_Z, r.low.z, r.high.z, z_width, 2);
    add_bands(&l, WCUT_TERM_BAND_Y, 0, r.size.y, y_width, 3);

    return l.count;
}

/* ---- its phi along a response ---- */

/* small, so that the sum stays on its straight part */
#define UNIT 1e-3

typedef struct walk {
    const wcut_evidence_cut *c;
    const wcut_response *d;
    wcut_effect effect;
    wcut_node_state *state; /* nodes */
    double age;
} walk;

static bool is_inside_block(wcut_vec3 block, wcut_vec3 p) {
    return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x <= block.x && p.y <= block.y && p.z <= block.z;
}

/* means over the nodes in the block at one sample, added up; false where none is */
static bool add_nodes(walk *w, int sample, double sum[WCUT_WEIGHTS]) {
    const wcut_trajectory *t = &w->c->exogenous;
    const wcut_block block = {.size = w->c->job->block_size};
    const size_t n = (size_t)w->d->nodes, at = (size_t)sample * n;

    /* the step from the sample before to this one */
    const double step = t->time[sample] - t->time[sample - 1], heat = t->heat[sample];
    double total[WCUT_WEIGHTS] = {0}, weight[WCUT_WEIGHTS] = {0};
    const wcut_locality local = {.count = 1,
                                 .effect = &w->effect,
                                 .state = w->state,
                                 .age = w->age,
                                 .clock = t->time[sample - 1],
                                 .was = w->d->position + at - n};

    /* each node: its factor phi, if it is in the block, under three weights (even, towards A, towards B) */
    for (int j = 0; j < w->d->nodes; j++) {
        const wcut_vec3 p = w->d->position[at + (size_t)j];
        const double speed = fmax(w->d->speed[at + (size_t)j], 0.05), across = j / (w->d->nodes - 1.0);
        const wcut_term_node node = {
            .block = &block, .x = p, .n = w->d->nodes, .i = j, .rate = 1 / step, .speed = speed, .heat = heat};
        wcut_term_factor factor;
        const bool inside = is_inside_block(block.size, p);
        if (inside && wcut_term_factor_eval(&local, &node, &factor)) {
            const double share[WCUT_WEIGHTS] = {1, 1 - across, across}, phi = (factor.value - 1) / UNIT;
            for (int k = 0; k < WCUT_WEIGHTS; k++) total[k] += share[k] * phi, weight[k] += share[k];
        }

        /* memories run on inside and outside the foam */
        double held[WCUT_TERM_MEMORIES] = {0};
        wcut_term_remember(&local, 1 / step, speed, heat, j, held);
        w->state[j].set = true, w->state[j].way += inside ? speed * step : 0;
        memcpy(w->state[j].held, held, sizeof held);
    }

    /* without a node in the block on either side of the wire the sample says nothing */
    if (!(weight[1] > 0 && weight[2] > 0)) return false;

    /* time in the foam, and the means over the nodes */
    w->age += step;
    for (int k = 0; k < WCUT_WEIGHTS; k++) sum[k] += total[k] / weight[k];

    return true;
}

wcut_status wcut_dictionary_eval(const wcut_evidence *e, int cut, const wcut_response *response,
                                 const wcut_entry *entry, double *out) {
    const wcut_evidence_cut *c = &e->cut[cut];
    walk w = {.c = c, .d = response, .effect = entry->effect};

    /* no term: 0 in every bin */
    memset(out, 0, (size_t)(WCUT_WEIGHTS * c->bins) * sizeof *out);
    w.effect.value[WCUT_EMPIRICAL_FORCE_COEFFICIENT] *= UNIT, w.effect.value[WCUT_EMPIRICAL_FORCE_COSINE] *= UNIT;
    if (!wcut_term_place(e, cut, entry->carried, &w.effect)) return WCUT_OK;

    /* state of the nodes: their memories and the way that each has gone */
    w.state = wcut_alloc((size_t)response->nodes, sizeof *w.state);
    if (!w.state) return WCUT_NO_MEMORY;
    for (int i = -1, sample = 1; i < c->bins; i++) {
        /* what comes before the first bin is walked for its memory alone */
        const double end = i < 0 ? c->middle[0] - WCUT_BIN_WIDTH / 2 : c->middle[i] + WCUT_BIN_WIDTH / 2;

        /* mean over the samples of the bin */
        double sum[WCUT_WEIGHTS] = {0};
        int count = 0;
        for (; sample < response->count && c->exogenous.time[sample] < end; sample++)
            if (response->present[sample] && response->present[sample - 1]) count += add_nodes(&w, sample, sum);
        for (int k = 0; k < WCUT_WEIGHTS && i >= 0; k++) out[k * c->bins + i] = count > 0 ? sum[k] / count : 0;
    }

    wcut_free(w.state);
    return WCUT_OK;
}
