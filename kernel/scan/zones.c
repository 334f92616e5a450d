/* Deviations by zone: the parts of the cut and the patches of the block. */
#include <stdio.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "scan/deviation_summary.h"

double wcut_moments_mean(const wcut_moments *m) { return m->count > 0 ? m->shift + m->sum / m->count : 0; }

double wcut_moments_variance(const wcut_moments *m) {
    if (m->count < 2) return 0;
    const double n = m->count;
    return fmax(m->squares - m->sum * m->sum / n, 0) / (n - 1);
}

void wcut_zone_add(wcut_zone_sums *zone, const wcut_deviation_summary_options *options,
                   const wcut_deviation *deviation) {
    const wcut_vec3 p = deviation->foot;
    if (zone->of.count == 0) zone->low = zone->high = p;
    zone->low = vec3(fmin(zone->low.x, p.x), fmin(zone->low.y, p.y), fmin(zone->low.z, p.z));
    zone->high = vec3(fmax(zone->high.x, p.x), fmax(zone->high.y, p.y), fmax(zone->high.z, p.z));
    wcut_moments_add(&zone->of, deviation->distance);
    for (int k = 0; k < options->bands; k++) zone->within[k] += fabs(deviation->distance) <= options->band[k];
}

static void zones_fill(const wcut_deviation_summary_options *o, const wcut_zone_sums *sums, wcut_zone *zone) {
    const wcut_moments *m = &sums->of;
    zone->count = m->count;
    zone->low = sums->low, zone->high = sums->high;
    if (m->count == 0) return;
    zone->mean = wcut_moments_mean(m);
    zone->std = sqrt(wcut_moments_variance(m));
    zone->rms = sqrt(m->plain_squares / m->count);
    zone->mae = m->sizes / m->count;
    zone->min = m->min, zone->max = m->max;
    for (int k = 0; k < o->bands; k++) zone->within[k] = sums->within[k] / (double)m->count;
}

void wcut_zones_fill(const wcut_deviation_summary *summary, wcut_zone *zone) {
    static const char *const part[WCUT_PARTS] = {"entry", "steady", "exit"};

    /* the parts of the cut */
    const wcut_deviation_summary_options *o = &summary->options;
    for (int k = 0; k < summary->parts && k < WCUT_PARTS; k++) {
        zone[k] = (wcut_zone){.is_patch = 0};
        snprintf(zone[k].name, sizeof zone[k].name, "%s", part[k]);
        zones_fill(o, &summary->zone[k], &zone[k]);
    }

    /* the patches, row by row, with their rectangles */
    const double wide = (o->high.x - o->low.x) / summary->patch_columns;
    const double long_side = (o->high.y - o->low.y) / summary->patch_rows;
    for (int r = 0; r < summary->patch_rows; r++)
        for (int c = 0; c < summary->patch_columns; c++) {
            const int k = summary->parts + r * summary->patch_columns + c;
            zone[k] = (wcut_zone){.is_patch = 1};
            snprintf(zone[k].name, sizeof zone[k].name, "patch %d %d", c + 1, r + 1);
            zones_fill(o, &summary->zone[k], &zone[k]);
            zone[k].low.x = o->low.x + c * wide, zone[k].high.x = o->low.x + (c + 1) * wide;
            zone[k].low.y = o->low.y + r * long_side, zone[k].high.y = o->low.y + (r + 1) * long_side;
        }
}
