/* A summary of deviations as they come: each goes into the histogram, its zones, its cell and the relations. */
#include "scan/deviation_summary.h"

#include <limits.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

enum { PATCHES_MAX = 10000, PIECE = 4096 };

wcut_deviation_summary_options wcut_deviation_summary_options_default(void) {
    return (wcut_deviation_summary_options){.patch = 100, .cell = 1};
}

static bool deviation_summary_is_usable(const wcut_deviation_summary_options *o) {
    return o && vec3_is_finite(o->low) && vec3_is_finite(o->high) && o->low.x < o->high.x && o->low.y < o->high.y &&
           is_positive(o->patch) && is_positive(o->cell) && o->bands >= 0 && o->bands <= WCUT_BANDS_MAX &&
           all_positive(o->bands, o->band);
}

/* how many patches a side has; more than are allowed where it would be beyond them */
static int parts_of(double length, double patch) { return (int)clamp(round(length / patch), 1, PATCHES_MAX + 1); }

void wcut_deviation_summary_destroy(wcut_deviation_summary *summary) {
    if (!summary) return;
    wcut_histogram_destroy(summary->histogram);
    wcut_free(summary->zone);
    wcut_free(summary->found_zone);
    wcut_free(summary->lattice.cell);
    wcut_free(summary);
}

wcut_status wcut_deviation_summary_create(const wcut_deviation_summary_options *options, const wcut_face *face,
                                          wcut_deviation_summary **summary) {
    /* patches are squares of about the same size over the window */
    if (!summary || !deviation_summary_is_usable(options)) return WCUT_BAD_ARGUMENT;
    const int columns = parts_of(options->high.x - options->low.x, options->patch);
    const int rows = parts_of(options->high.y - options->low.y, options->patch);
    if ((double)columns * rows > PATCHES_MAX) return WCUT_BAD_ARGUMENT;
    wcut_deviation_summary *s = wcut_alloc(1, sizeof *s);
    if (!s) return WCUT_NO_MEMORY;

    /* the face adds zones by part of the cut: entry, steady, exit */
    s->options = *options, s->face = face;
    s->patch_columns = columns, s->patch_rows = rows, s->parts = face ? WCUT_PARTS : 0;
    const size_t zones = (size_t)s->parts + (size_t)columns * rows;
    s->zone = wcut_alloc(zones, sizeof *s->zone);
    s->found_zone = wcut_alloc(zones, sizeof *s->found_zone);
    wcut_status status = s->zone && s->found_zone ? WCUT_OK : WCUT_NO_MEMORY;

    /* cells for offset, form and noise; bins for the quantiles */
    if (status == WCUT_OK) status = wcut_lattice_create(options, &s->lattice);
    if (status == WCUT_OK) status = wcut_histogram_create(options->bands, options->band, &s->histogram);
    if (status == WCUT_OK)
        *summary = s;
    else
        wcut_deviation_summary_destroy(s);

    return status;
}

/* ---- taking in ---- */

static void pair_add(wcut_pair_sums *p, double x, double y) {
    p->n++, p->x += x, p->y += y, p->xx += x * x, p->yy += y * y, p->xy += x * y;
}

static int patch_of(const wcut_deviation_summary *s, wcut_vec3 foot) {
    const wcut_deviation_summary_options *o = &s->options;
    const double x = (foot.x - o->low.x) / (o->high.x - o->low.x), y = (foot.y - o->low.y) / (o->high.y - o->low.y);
    const int column = (int)clamp(floor(x * s->patch_columns), 0, s->patch_columns - 1);
    const int row = (int)clamp(floor(y * s->patch_rows), 0, s->patch_rows - 1);
    return s->parts + row * s->patch_columns + column;
}

/* 0 entry, 1 steady, 2 exit; what was approached or left belongs to the part next to it */
static int deviation_summary_part_of(wcut_phase phase) {
    return phase <= WCUT_PHASE_ENTRY ? 0 : phase == WCUT_PHASE_STEADY ? 1 : 2;
}

static double deviation_summary_between(const double *field, int low, int high, double t) {
    return field[low] + t * (field[high] - field[low]);
}

/* what the station and the place of a foot say */
static void relate(wcut_deviation_summary *s, const wcut_deviation *d) {
    const wcut_face *f = s->face;
    double row, column;
    wcut_face_locate(f, d->u, d->v, &row, &column);
    const int low = (int)row, high = low + 1 < f->stations ? low + 1 : low, near = (int)round(row);
    const size_t nearest = (size_t)near * f->nodes + (size_t)round(column);
    const double value[WCUT_RELATIONS] = {deviation_summary_between(f->time, low, high, row - low),
                                          deviation_summary_between(f->path_bend, low, high, row - low),
                                          fabs(f->curvature[nearest])};
    for (int k = 0; k < WCUT_RELATIONS; k++) {
        pair_add(&s->relation[k][0], value[k], d->distance);
        pair_add(&s->relation[k][1], value[k], fabs(d->distance));
    }
    wcut_zone_add(&s->zone[deviation_summary_part_of(f->phase[near])], &s->options, d);
}

wcut_status wcut_deviation_summary_add(wcut_deviation_summary *summary, int count, const wcut_deviation *deviation) {
    if (!summary || count < 0 || (count > 0 && !deviation)) return WCUT_BAD_ARGUMENT;

    /* counts are int: refuse more than fit */
    long total = count;
    for (int k = 0; k < WCUT_PLACE_COUNT; k++) total += summary->place[k];
    if (total > INT_MAX) return WCUT_BAD_ARGUMENT;

    /* check all before any is added */
    for (int i = 0; i < count; i++)
        if (!isfinite(deviation[i].distance) || !vec3_is_finite(deviation[i].foot) ||
            (unsigned)deviation[i].place >= WCUT_PLACE_COUNT)
            return WCUT_BAD_ARGUMENT;

    /* distances go into the histogram in pieces; one beyond the border is counted and not used */
    double used[PIECE];
    int filled = 0;
    for (int i = 0; i < count; i++) {
        const wcut_deviation *d = &deviation[i];
        summary->place[d->place]++;
        if (d->place > WCUT_PLACE_BORDER) continue;

        /* by part of the cut and by relation, by patch, by cell */
        if (summary->face) relate(summary, d);
        wcut_zone_add(&summary->zone[patch_of(summary, d->foot)], &summary->options, d);
        wcut_lattice_add(&summary->lattice, d);
        used[filled++] = d->distance;
        if (filled < PIECE) continue;
        wcut_histogram_add(summary->histogram, filled, used); /* finite, and no more than fit: checked above */
        filled = 0;
    }

    /* the last piece */
    wcut_histogram_add(summary->histogram, filled, used);

    return WCUT_OK;
}

/* ---- what was found ---- */

static double correlation(const wcut_pair_sums *p) {
    if (p->n < 3) return 0;
    const double xx = p->xx - p->x * p->x / p->n, yy = p->yy - p->y * p->y / p->n, xy = p->xy - p->x * p->y / p->n;
    /* what rounding leaves of something constant is no change */
    if (!(xx > 1e-12 * p->xx) || !(yy > 1e-12 * p->yy)) return 0;
    return clamp(xy / sqrt(xx * yy), -1, 1);
}

static wcut_relation relation_of(const wcut_deviation_summary *s, int k) {
    return (wcut_relation){correlation(&s->relation[k][0]), correlation(&s->relation[k][1])};
}

wcut_status wcut_deviation_summary_eval(wcut_deviation_summary *summary, const wcut_deviation_summary_result **result) {
    if (!summary || !result) return WCUT_BAD_ARGUMENT;

    /* cells are doubled until enough of them hold points */
    wcut_deviation_summary_result *r = &summary->result;
    wcut_lattice coarse;
    wcut_status status = wcut_lattice_coarsen(&summary->lattice, &coarse);
    if (status != WCUT_OK) return status;

    /* worst areas, then offset, form and noise */
    status = wcut_worst_list(&coarse, &r->worsts, summary->found_worst);
    if (status == WCUT_OK) status = wcut_lattice_split(&coarse, &r->split);

    /* statistics, counts by place, zones, relations */
    if (status == WCUT_OK) {
        wcut_histogram_eval(summary->histogram, &r->statistics); /* its arguments are there */
        for (int k = 0; k < WCUT_PLACE_COUNT; k++) r->place[k] = summary->place[k];
        wcut_zones_fill(summary, summary->found_zone);
        r->zones = summary->parts + summary->patch_columns * summary->patch_rows;
        r->zone = summary->found_zone, r->worst = summary->found_worst;
        r->related = summary->face != NULL;
        r->time = relation_of(summary, 0), r->path = relation_of(summary, 1), r->bend = relation_of(summary, 2);
        *result = r;
    }

    wcut_free(coarse.cell);
    return status;
}
