/* Columns of a density inclusion at every place of the block that a wire has passed. Small inclusions far enough apart
   are simulated at once: each one's change is what happens while the wire is nearest to it. */
#include "explain/inclusions.h"

#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"

enum { NODES = WCUT_NODES_COARSE, COLUMNS = 4, PHASES = 3, BLOBS_MAX = 60, PLACES_X = 6 };

/* shares of the block's width at which small inclusions are simulated, and places are tried */
static const double blob_share[COLUMNS] = {0.12, 0.37, 0.63, 0.88};
static const double place_share[PLACES_X] = {0.1, 0.25, 0.4, 0.55, 0.7, 0.9};

#define PITCH 50.0  /* [mm] of small inclusions along the feed; those of one run stand PHASES of it apart */
#define RADIUS 40.0 /* [mm] of a small one */
#define WIDE_X 60.0 /* [mm] how a place takes its share of small ones */
#define WIDE_Y 40.0
#define AMPLITUDE 0.1

void wcut_inclusions_destroy(wcut_inclusions *i) {
    wcut_free(i->effect);
    wcut_free(i->column);
    *i = (wcut_inclusions){0};
}

/* the changes by the small inclusions of a cut, in its bins */
typedef struct blobs {
    int count;
    double *x, *y;  /* count [mm] */
    double *change; /* count x 6 bins */
} blobs;

static void blobs_destroy(blobs *b) {
    wcut_free(b->x);
    wcut_free(b->y);
    wcut_free(b->change);
}

/* where the wire is at x, at a sample; false where it does not reach there */
static bool wire_place_at(const wcut_response *d, int sample, double x, double *y, double *z) {
    const wcut_vec3 *p = d->position + (size_t)sample * (size_t)d->nodes;
    for (int i = 0; i + 1 < d->nodes; i++) {
        if (!(p[i].x <= x && p[i + 1].x > x)) continue;
        const double t = (x - p[i].x) / (p[i + 1].x - p[i].x);
        *y = (1 - t) * p[i].y + t * p[i + 1].y, *z = (1 - t) * p[i].z + t * p[i + 1].z;
        return true;
    }
    return false;
}

/* height of the wire when it passes (x, y); the block's middle where it never does */
static double height_at(const wcut_evidence_cut *c, const wcut_response *d, double x, double y) {
    double best = HUGE_VAL, height = c->job->block_size.z / 2, wire_y, wire_z;
    for (int i = 0; i < d->count; i += 5)
        if (d->present[i] && wire_place_at(d, i, x, &wire_y, &wire_z) && fabs(wire_y - y) < best)
            best = fabs(wire_y - y), height = wire_z;
    return height;
}

/* the last blob column's run: `bins` is room for 6 x bins of the cut, `plain` the reference with positions */
static wcut_status run_column(const wcut_evidence *e, const wcut_model *about, int cut, const wcut_response *plain,
                              const double *plain_bins, int column, int phase, double *bins, blobs *b) {
    const wcut_evidence_cut *c = &e->cut[cut];

    /* the job under the model, with as many inclusions as there is room for */
    wcut_effect effect[BLOBS_MAX + WCUT_DIAGNOSIS_EFFECTS];
    wcut_job job = wcut_model_job(e, about, cut, effect);
    const double x = blob_share[column] * c->job->block_size.x;

    /* a row of small inclusions along y, far enough apart that the wire meets one at a time */
    const int known = job.effect_count, begun = b->count;
    for (double y = PITCH * (0.5 + phase); y < c->job->block_size.y && b->count - begun < BLOBS_MAX;
         y += PITCH * PHASES) {
        wcut_effect *blob = &effect[job.effect_count++];
        *blob = wcut_effect_default(WCUT_EFFECT_FOAM_INCLUSION);
        blob->value[WCUT_FOAM_INCLUSION_AMPLITUDE] = AMPLITUDE, blob->value[WCUT_FOAM_INCLUSION_RADIUS] = RADIUS;
        double *at = &blob->value[WCUT_FOAM_INCLUSION_POSITION];
        at[0] = x, at[1] = y, at[2] = height_at(c, plain, x, y);
        b->x[b->count] = x, b->y[b->count++] = y;
    }
    if (job.effect_count == known) return WCUT_OK;

    /* one simulation for all of them */
    wcut_response d = {0};
    wcut_status status = wcut_response_run(&job, NODES, &c->exogenous, false, e->stop, &d, NULL);
    if (status == WCUT_OK) status = wcut_evidence_bin_exogenous(c, about, &d, bins);

    /* assign the change in each bin to the inclusion that the wire is nearest to */
    const int last = plain->count - 1;
    for (int i = 0; status == WCUT_OK && i < c->bins; i++) {
        const double place = (c->middle[i] - c->exogenous.time[0]) / (c->exogenous.time[1] - c->exogenous.time[0]);
        double y, z;
        if (!wire_place_at(plain, (int)clamp(place, 0, last), x, &y, &z)) continue;
        int nearest = begun;
        for (int k = begun; k < b->count; k++)
            if (fabs(b->y[k] - y) < fabs(b->y[nearest] - y)) nearest = k;
        for (int s = 0; s < WCUT_SIGNALS; s++) {
            const size_t at = (size_t)s * (size_t)c->bins + (size_t)i;
            b->change[(size_t)nearest * WCUT_SIGNALS * (size_t)c->bins + at] = (bins[at] - plain_bins[at]) / AMPLITUDE;
        }
    }

    /* release the run */
    wcut_response_destroy(&d);
    return status;
}

static wcut_status run_cut(const wcut_evidence *e, const wcut_model *about, int cut, blobs *b) {
    /* room for all inclusions of this cut, of all columns and phases */
    const wcut_evidence_cut *c = &e->cut[cut];
    const size_t size = WCUT_SIGNALS * (size_t)c->bins;
    const size_t max = COLUMNS * (size_t)(c->job->block_size.y / PITCH + PHASES + 1);

    /* the plain run, with positions: where the wire is when */
    wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
    const wcut_job job = wcut_model_job(e, about, cut, effect);
    wcut_response plain = {0};
    double *bins = wcut_alloc(2 * size, sizeof *bins);
    *b = (blobs){.x = wcut_alloc(max, sizeof(double)),
                 .y = wcut_alloc(max, sizeof(double)),
                 .change = wcut_alloc(max * size, sizeof(double))};
    wcut_status status = bins && b->x && b->y && b->change ? WCUT_OK : WCUT_NO_MEMORY;

    /* its signals in the bins, as the reference */
    if (status == WCUT_OK) status = wcut_response_run(&job, NODES, &c->exogenous, true, e->stop, &plain, NULL);
    if (status == WCUT_OK) status = wcut_evidence_bin_exogenous(c, about, &plain, bins + size);

    /* every column and phase is a run of its own */
    for (int task = 0; status == WCUT_OK && task < COLUMNS * PHASES; task++)
        status = run_column(e, about, cut, &plain, bins + size, task / PHASES, task % PHASES, bins, b);

    wcut_response_destroy(&plain);
    wcut_free(bins);
    return status;
}

/* a place's column from the small inclusions around it; false where no wire has felt it */
static bool spread_column(const wcut_evidence *e, const blobs *b, double x, double y, double *column) {
    bool felt = false;
    for (int cut = 0; cut < e->cuts; cut++) {
        const wcut_evidence_cut *c = &e->cut[cut];
        const int size = WCUT_SIGNALS * c->bins;
        for (int k = 0; k < b[cut].count; k++) {
            const double dx = (b[cut].x[k] - x) / WIDE_X, dy = (b[cut].y[k] - y) / WIDE_Y;
            const double weight = exp(-(dx * dx + dy * dy) / 2);
            if (weight < 0.02) continue;
            const double *change = b[cut].change + (size_t)k * (size_t)size;
            for (int i = 0; i < size; i++) {
                column[c->row + i] += weight * change[i];
                felt = felt || fabs(change[i]) > 1e-6;
            }
        }
    }
    return felt;
}

static wcut_status list_places(const wcut_evidence *e, const blobs *b, wcut_inclusions *out) {
    /* places over the narrowest width and the longest block */
    double width = HUGE_VAL, length = 0;
    const wcut_evidence_cut *first = NULL;
    for (int k = 0; k < e->cuts; k++) {
        if (e->cut[k].bins == 0) continue;
        if (!first) first = &e->cut[k];
        width = fmin(width, e->cut[k].job->block_size.x), length = fmax(length, e->cut[k].job->block_size.y);
    }

    /* a column of rows for each place, PITCH apart along y */
    const int along = (int)fmin(length / PITCH, 200);
    out->effect = wcut_alloc((size_t)PLACES_X * (size_t)along, sizeof *out->effect);
    out->column = wcut_alloc((size_t)PLACES_X * (size_t)along * (size_t)e->rows, sizeof(double));
    if (!out->effect || !out->column) return WCUT_NO_MEMORY;
    if (!first) return WCUT_OK; /* no cut with bins: no places */

    /* a Gaussian blend of the simulated inclusions around the place; a place that changes no bin drops out */
    for (int i = 0; i < PLACES_X * along; i++) {
        const double x = place_share[i / along] * width, y = PITCH * (i % along + 0.5);
        double *column = out->column + (size_t)out->count * (size_t)e->rows;
        memset(column, 0, (size_t)e->rows * sizeof *column);
        if (!spread_column(e, b, x, y, column)) continue;

        /* the effect of this place, as wide as its blended column */
        wcut_effect *effect = &out->effect[out->count++];
        *effect = wcut_effect_default(WCUT_EFFECT_FOAM_INCLUSION);
        double *at = &effect->value[WCUT_FOAM_INCLUSION_POSITION];
        effect->value[WCUT_FOAM_INCLUSION_AMPLITUDE] = 1;
        effect->value[WCUT_FOAM_INCLUSION_RADIUS] = hypot(RADIUS, WIDE_Y);
        at[0] = x, at[1] = y;
        at[2] = first->job->mount_a[first->job->stations / 2].z;
    }

    return WCUT_OK;
}

wcut_status wcut_inclusions_create(const wcut_evidence *e, const wcut_model *about, wcut_inclusions *out,
                                   wcut_error *error) {
    /* every cut by itself; failures are collected in order */
    blobs *b = wcut_alloc((size_t)e->cuts, sizeof *b);
    wcut_status *failed = wcut_alloc((size_t)e->cuts, sizeof *failed);
    wcut_inclusions found = {0};
    wcut_status status = b && failed ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
        for (int cut = 0; cut < e->cuts; cut++)
            if (e->cut[cut].bins > 0) failed[cut] = run_cut(e, about, cut, &b[cut]);
        for (int cut = 0; cut < e->cuts; cut++)
            if (status == WCUT_OK) status = failed[cut];
    }

    /* then the columns of the places, over all cuts */
    if (status == WCUT_OK) status = list_places(e, b, &found);

    /* release the simulated inclusions, and hand the places over */
    for (int cut = 0; b && cut < e->cuts; cut++) blobs_destroy(&b[cut]);
    wcut_free(b);
    wcut_free(failed);
    if (status == WCUT_OK)
        *out = found;
    else
        wcut_inclusions_destroy(&found);

    return status == WCUT_OK ? status : wcut_fail(error, status, "inclusions: %s", wcut_status_text(status));
}
