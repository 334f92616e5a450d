/* Quantities along the exogenous trajectory that the foam's force might follow: nothing that a tension loop feeds back. */
#include "explain/features.h"

#include <stdio.h>
#include <string.h>
#include <wirecut/force_law.h>

#include "base/numbers.h"
#include "base/vec3.h"

/* wavelengths over the block [mm], evenly in frequency */
#define SHORTEST 40.0
#define LONGEST 400.0

/* of the bins, then of the wire's nodes */
enum what {
    LN_HEAT,
    LN_SPEED,
    ACCELERATION,
    SPEED_SQUARED,
    SPEED_HEAT,
    TIME,
    NUMBER,
    DIRECTION,
    ENGAGED,
    TURNING,
    SPAN,
    RECIPROCAL_FORCE,
    ENTRY,
    MEMORY_SPEED,
    MEMORY_HEAT,
    OF_NODES,
    ACROSS = OF_NODES,
    ALONG,
    UP,
    SINE,
    COSINE
};

static void add(wcut_feature *list, int *n, int what, double constant, const char *name) {
    list[*n] = (wcut_feature){.what = what, .constant = constant, .wave = what == SINE};
    list[*n].latency = (what == MEMORY_SPEED || what == MEMORY_HEAT) && constant < WCUT_BIN_WIDTH;
    snprintf(list[*n].name, sizeof list[*n].name, "%.39s", name);
    ++*n;
}

int wcut_features_list(bool several, wcut_feature *out) {
    static const char *const plain[] = {"ln heat",          "ln speed",  "acceleration",  "(ln speed)^2",
                                        "ln speed ln heat", "time",      "cut number",    "direction",
                                        "engaged length",   "curvature", "span / length", "1 / force"};
    static const double memory[] = {0.4, 0.8, 1.6, 3.2, 6.4, 12.8};
    static const char axis[] = "xyz", size[] = "WLH";
    char name[64];
    int n = 0;
    for (int k = LN_HEAT; k <= RECIPROCAL_FORCE; k++)
        if (several || (k != NUMBER && k != DIRECTION)) add(out, &n, k, 0, plain[k]);
    for (int k = 1; k < 6; k++) {
        snprintf(name, sizeof name, "exp(-t / %.1f s) since entry", memory[k]);
        add(out, &n, ENTRY, memory[k], name);
    }
    for (int k = 0; k < 6; k++) {
        snprintf(name, sizeof name, "memory of %.1f s of ln speed", memory[k]);
        add(out, &n, MEMORY_SPEED, memory[k], name);
        snprintf(name, sizeof name, "memory of %.1f s of ln heat", memory[k]);
        add(out, &n, MEMORY_HEAT, memory[k], name);
    }
    for (int k = 0; k < 3; k++) {
        snprintf(name, sizeof name, "%c / %c - 1/2", axis[k], size[k]);
        add(out, &n, ACROSS + k, 1, name);
        snprintf(name, sizeof name, "(%c / %c - 1/2)^2", axis[k], size[k]);
        add(out, &n, ACROSS + k, 2, name);
    }
    for (int k = 0; k < WCUT_WAVES; k++) {
        const double share = k / (WCUT_WAVES - 1.0), wave = 1 / ((1 - share) / LONGEST + share / SHORTEST);
        snprintf(name, sizeof name, "sin(2 pi y / %.0f mm%%s)", wave);
        add(out, &n, SINE, wave, name);
        add(out, &n, COSINE, wave, name);
    }
    return n;
}

/* ---- of bins ---- */

static double ln_speed(const wcut_evidence_cut *c, int i) { return log(fmax(c->pace[i], 0.1)); }
static double ln_heat(const wcut_evidence_cut *c, int i) { return log(fmax(c->heat[i], 1e-3)); }

/* the mounts' directions and their change per way at a station; the mean of both mounts */
static double turning(const wcut_job *job, double station) {
    const int j = (int)clamp(round(station), 1, job->stations - 2);
    const wcut_vec3 *mount[2] = {job->mount_a, job->mount_b};
    double sum = 0;
    for (int side = 0; side < 2 && job->stations > 2; side++) {
        const wcut_vec3 before = vec3_sub(mount[side][j], mount[side][j - 1]);
        const wcut_vec3 behind = vec3_sub(mount[side][j + 1], mount[side][j]);
        const double way = (vec3_length(before) + vec3_length(behind)) / 2;
        if (way > 0) sum += vec3_distance(vec3_unit(before), vec3_unit(behind)) / way / 2;
    }
    return sum;
}

static double span(const wcut_job *job, double station) {
    const int j = (int)clamp(floor(station), 0, job->stations - 2);
    const double way = clamp(station - j, 0, 1);
    return vec3_distance(vec3_mix(job->mount_a[j], job->mount_a[j + 1], way),
                         vec3_mix(job->mount_b[j], job->mount_b[j + 1], way)) /
           job->wire_length;
}

static double of_bin(const wcut_evidence_cut *c, int what, int i) {
    const double first = ln_speed(c, i > 0 ? i - 1 : i), last = ln_speed(c, i + 1 < c->bins ? i + 1 : i);
    switch (what) {
        case LN_HEAT:
            return ln_heat(c, i);
        case LN_SPEED:
            return ln_speed(c, i);
        case ACCELERATION:
            return (last - first) / (2 * WCUT_BIN_WIDTH);
        case SPEED_SQUARED:
            return pow(ln_speed(c, i), 2);
        case SPEED_HEAT:
            return ln_speed(c, i) * ln_heat(c, i);
        case TIME:
            return c->middle[i];
        case NUMBER:
            return c->index;
        case DIRECTION:
            return c->job->mount_a[c->job->stations - 1].y > c->job->mount_a[0].y ? 1 : -1;
        case ENGAGED:
            return c->engaged[i];
        case TURNING:
            return turning(c->job, c->station[i]);
        case SPAN:
            return span(c->job, c->station[i]);
        default:
            return 1 / fmax(c->engaged[i] * wcut_force_law_eval(&c->job->force_law, c->heat[i], fmax(c->pace[i], 0.1)),
                            0.01);
    }
}

/* what a first-order memory holds of a quantity, less the quantity */
static void remember(const wcut_evidence_cut *c, double (*quantity)(const wcut_evidence_cut *, int), double memory,
                     double *out) {
    const double keep = exp(-WCUT_BIN_WIDTH / memory);
    double held = quantity(c, 0);
    for (int i = 0; i < c->bins; i++) {
        held = keep * held + (1 - keep) * quantity(c, i);
        out[i] = held - quantity(c, i);
    }
}

/* ---- of nodes ---- */

static double of_node(const wcut_feature *f, wcut_vec3 block, wcut_vec3 p) {
    switch (f->what) {
        case ACROSS:
            return pow(p.x / block.x - 0.5, f->constant);
        case ALONG:
            return pow(p.y / block.y - 0.5, f->constant);
        case UP:
            return pow(p.z / block.z - 0.5, f->constant);
        case SINE:
            return sin(2 * WCUT_PI * p.y / f->constant);
        default:
            return cos(2 * WCUT_PI * p.y / f->constant);
    }
}

/* means over the nodes in the block of one sample of the trajectory, added up; false where none is */
static bool add_nodes(const wcut_evidence_cut *c, const wcut_response *d, const wcut_feature *f, int sample,
                      double sum[WCUT_WEIGHTS]) {
    const wcut_vec3 block = c->job->block_size, *node = d->position + (size_t)sample * (size_t)d->nodes;
    double total[WCUT_WEIGHTS] = {0}, weight[WCUT_WEIGHTS] = {0};
    for (int j = 0; j < d->nodes; j++) {
        const wcut_vec3 p = node[j];
        if (!(p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x <= block.x && p.y <= block.y && p.z <= block.z)) continue;
        const double value = of_node(f, block, p), across = j / (d->nodes - 1.0);
        const double w[WCUT_WEIGHTS] = {1, 1 - across, across};
        for (int k = 0; k < WCUT_WEIGHTS; k++) total[k] += w[k] * value, weight[k] += w[k];
    }
    if (!(weight[1] > 0 && weight[2] > 0)) return false;
    for (int k = 0; k < WCUT_WEIGHTS; k++) sum[k] += total[k] / weight[k];
    return true;
}

static void eval_nodes(const wcut_evidence_cut *c, const wcut_response *d, const wcut_feature *f, double *out) {
    const wcut_trajectory *t = &c->exogenous;
    int sample = 0;
    for (int i = 0; i < c->bins; i++) {
        double sum[WCUT_WEIGHTS] = {0};
        int count = 0;
        while (sample < d->count && t->time[sample] < c->middle[i] - WCUT_BIN_WIDTH / 2) sample++;
        for (; sample < d->count && t->time[sample] < c->middle[i] + WCUT_BIN_WIDTH / 2; sample++)
            if (d->present[sample]) count += add_nodes(c, d, f, sample, sum);
        for (int k = 0; k < WCUT_WEIGHTS; k++) out[k * c->bins + i] = count > 0 ? sum[k] / count : 0;
    }
}

void wcut_feature_eval(const wcut_evidence_cut *c, const wcut_response *d, const wcut_feature *f, double *out) {
    if (f->what >= OF_NODES) {
        eval_nodes(c, d, f, out);
        return;
    }
    if (c->bins > 0 && f->what == MEMORY_SPEED) {
        remember(c, ln_speed, f->constant, out);
    } else if (c->bins > 0 && f->what == MEMORY_HEAT) {
        remember(c, ln_heat, f->constant, out);
    } else {
        for (int i = 0; i < c->bins; i++)
            out[i] = f->what == ENTRY ? exp(-(c->middle[i] - c->contact) / f->constant) : of_bin(c, f->what, i);
    }
    for (int k = 1; k < WCUT_WEIGHTS; k++)
        memcpy(out + (size_t)k * (size_t)c->bins, out, (size_t)c->bins * sizeof *out);
}
