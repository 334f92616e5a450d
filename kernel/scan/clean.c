/* Cleaning: which points of a scan do not belong to the face, each with its cause. */
#include <string.h>
#include <wirecut/cloud.h>

#include "base/alloc.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "scan/duplicates.h"
#include "scan/kd_tree.h"

/* points of a block; blocks are summed in order, so threads change no byte */
enum { BLOCK = 1024 };

static const double FAR = 1e12, MIN_VOXEL = 1e-3, MAD_TO_SIGMA = 1.4826;

wcut_clean_options wcut_clean_options_default(void) {
    return (wcut_clean_options){.duplicate = 0,
                                .radius = 0,
                                .radius_min = 4,
                                .neighbours = 10,
                                .deviations = 6,
                                .factor_min = 3,
                                .robust = 1,
                                .voxel = 0};
}

static bool clean_options_are_usable(const wcut_clean_options *o) {
    return isfinite(o->duplicate) && isfinite(o->radius) && o->radius >= 0 && o->radius_min >= 1 &&
           o->neighbours >= 0 && o->neighbours <= WCUT_KD_NEAREST_MAX && isfinite(o->deviations) &&
           o->deviations >= 0 && isfinite(o->factor_min) && o->factor_min >= 0 && isfinite(o->voxel) &&
           (o->voxel == 0 || o->voxel >= MIN_VOXEL);
}

static bool points_are_usable(int count, const wcut_vec3 *point) {
    for (int k = 0; k < count; k++)
        if (!(fabs(point[k].x) <= FAR && fabs(point[k].y) <= FAR && fabs(point[k].z) <= FAR)) return false;
    return true;
}

/* what is being cleaned */
typedef struct cleaning {
    const wcut_clean_options *options;
    int count, threads;
    const wcut_vec3 *point;
    unsigned char *removal; /* count */
    int left;               /* points of `some` */
    int *which;             /* left: their numbers */
    wcut_vec3 *some;        /* left: the points that are still kept */
    double *distance;       /* left, in the tree's order: mean distance to the neighbours */
    wcut_kd_tree tree;
    wcut_clean_report report;
} cleaning;

/* the points kept so far, in their order */
static void clean_gather(cleaning *c) {
    c->left = 0;
    for (int k = 0; k < c->count; k++) {
        if (c->removal[k] != WCUT_REMOVAL_KEPT) continue;
        c->which[c->left] = k;
        c->some[c->left++] = c->point[k];
    }
}

/* ---- outliers ---- */

/* the value of a rank, by partition (Hoare 1961); the values are left partly sorted */
static double clean_select_rank(int n, double *value, int rank) {
    for (int first = 0, last = n - 1; first < last;) {
        /* part the range about its middle value; equal values stop both sides */
        const double pivot = value[first + (last - first) / 2];
        int i = first, j = last;
        while (i <= j) {
            while (value[i] < pivot) i++;
            while (value[j] > pivot) j--;
            if (i > j) break;
            const double keep = value[i];
            value[i++] = value[j];
            value[j--] = keep;
        }

        /* go on in the part that holds the rank */
        if (rank <= j)
            last = j;
        else if (rank >= i)
            first = i;
        else
            break;
    }

    return value[rank];
}

/* the middle one, or the mean of the middle two */
static double clean_median(int n, double *value) {
    const double upper = clean_select_rank(n, value, n / 2);
    return n % 2 ? upper : clean_select_rank(n, value, n / 2 - 1) / 2 + upper / 2;
}

static void measure_robust(cleaning *c, double *work) {
    memcpy(work, c->distance, (size_t)c->left * sizeof *work);
    c->report.centre = clean_median(c->left, work);
    for (int k = 0; k < c->left; k++) work[k] = fabs(c->distance[k] - c->report.centre);
    c->report.scale = MAD_TO_SIGMA * clean_median(c->left, work);
}

static double sum(int n, const double *value) {
    double total = 0;
    for (int k = 0; k < n; k++) total += value[k];
    return total;
}

static void measure_moments(cleaning *c, double *work) {
    c->report.centre = sum(c->left, c->distance) / c->left;
    for (int k = 0; k < c->left; k++) {
        const double d = c->distance[k] - c->report.centre;
        work[k] = d * d;
    }
    c->report.scale = c->left > 1 ? sqrt(sum(c->left, work) / (c->left - 1)) : 0;
}

/* for the points of a block: mean distance to the neighbours, and who is isolated */
static void look_around(cleaning *c, int first, int end) {
    const wcut_clean_options *o = c->options;
    wcut_kd_nearest nearest;
    for (int k = first; k < end; k++) {
        unsigned char *removal = &c->removal[c->which[c->tree.index[k]]];
        if (o->radius > 0 && wcut_kd_tree_within(&c->tree, k, o->radius, o->radius_min) < o->radius_min)
            *removal = WCUT_REMOVAL_ISOLATED;
        if (o->neighbours == 0) continue;
        wcut_kd_tree_nearest(&c->tree, k, o->neighbours, &nearest);
        double total = 0;
        for (int j = 0; j < nearest.count; j++) total += sqrt(nearest.square[j]);
        c->distance[k] = total / nearest.count;
    }
}

static wcut_status find_outliers(cleaning *c) {
    const wcut_clean_options *o = c->options;

    /* both tests off: nothing to do */
    if (o->radius == 0 && o->neighbours == 0) return WCUT_OK;
    clean_gather(c);
    if (c->left <= o->neighbours) return WCUT_DEGENERATE;

    /* a tree over the points that are left, walked in blocks of neighbours */
    double *work = wcut_alloc((size_t)c->left, sizeof *work);
    wcut_status status = work ? wcut_kd_tree_build(c->left, c->some, c->threads, &c->tree) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        const int blocks = c->left / BLOCK + (c->left % BLOCK > 0);
#pragma omp parallel for schedule(dynamic) num_threads(wcut_threads(c->threads))
        for (int b = 0; b < blocks; b++) look_around(c, b * BLOCK, b == blocks - 1 ? c->left : (b + 1) * BLOCK);
    }

    /* the limit from the mean distances: centre and scale, robust or by moments, and no less than a factor of the
       centre */
    if (status == WCUT_OK && o->neighbours > 0) {
        o->robust ? measure_robust(c, work) : measure_moments(c, work);
        c->report.limit = fmax(c->report.centre + o->deviations * c->report.scale, o->factor_min * c->report.centre);

        /* points beyond the limit are outliers, unless they have another cause already */
        for (int k = 0; k < c->left; k++) {
            unsigned char *removal = &c->removal[c->which[c->tree.index[k]]];
            if (*removal == WCUT_REMOVAL_KEPT && c->distance[k] > c->report.limit) *removal = WCUT_REMOVAL_OUTLIER;
        }
    }
    wcut_free(work);
    wcut_kd_tree_clear(&c->tree);

    return status;
}

/* ---- the steps ---- */

static wcut_status clean_thin(cleaning *c) {
    if (c->options->voxel == 0) return WCUT_OK;
    clean_gather(c);
    wcut_thinning *thinning = NULL;
    unsigned char *keep = wcut_alloc((size_t)c->left, 1);
    wcut_status status = keep ? wcut_thinning_create(c->options->voxel, &thinning) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_thinning_add(thinning, c->left, c->some, keep);
    for (int k = 0; status == WCUT_OK && k < c->left; k++)
        if (!keep[k]) c->removal[c->which[k]] = WCUT_REMOVAL_THINNED;
    wcut_thinning_destroy(thinning);
    wcut_free(keep);
    return status;
}

static wcut_status clean(cleaning *c) {
    wcut_status status = WCUT_OK;
    if (c->options->duplicate >= 0)
        status = wcut_duplicates_find(c->count, c->point, c->options->duplicate, c->removal);
    if (status == WCUT_OK) status = find_outliers(c);
    if (status == WCUT_OK) status = clean_thin(c);
    for (int k = 0; k < c->count; k++) c->report.removed[c->removal[k]]++;
    return status == WCUT_OK && c->report.removed[WCUT_REMOVAL_KEPT] == 0 ? WCUT_DEGENERATE : status;
}

wcut_status wcut_cloud_clean(int count, const wcut_vec3 *point, const wcut_clean_options *options, int threads,
                             unsigned char *removal, wcut_clean_report *report) {
    const wcut_clean_options o = options ? *options : wcut_clean_options_default();

    /* check everything before the first allocation */
    if (count < 1 || !point || threads < 1 || !removal) return WCUT_BAD_ARGUMENT;
    if (!clean_options_are_usable(&o) || !points_are_usable(count, point)) return WCUT_BAD_ARGUMENT;

    /* the working arrays of all tests */
    cleaning c = {.options = &o, .count = count, .threads = threads, .point = point};
    c.removal = wcut_alloc((size_t)count, 1);
    c.which = wcut_alloc((size_t)count, sizeof *c.which);
    c.some = wcut_alloc((size_t)count, sizeof *c.some);
    c.distance = wcut_alloc((size_t)count, sizeof *c.distance);
    const wcut_status status = c.removal && c.which && c.some && c.distance ? clean(&c) : WCUT_NO_MEMORY;

    /* outputs only once all tests have been made */
    if (status == WCUT_OK) {
        memcpy(removal, c.removal, (size_t)count);
        if (report) *report = c.report;
    }

    wcut_free(c.removal);
    wcut_free(c.which);
    wcut_free(c.some);
    wcut_free(c.distance);
    return status;
}

int wcut_cloud_keep(int count, const unsigned char *removal, wcut_vec3 *row) {
    int kept = 0;
    if (!removal || !row) return 0;
    for (int k = 0; k < count; k++)
        if (removal[k] == WCUT_REMOVAL_KEPT) row[kept++] = row[k];
    return kept;
}
