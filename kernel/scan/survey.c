/* Deviations in the zones and along the sections that a user lays over a face. */
#include <wirecut/survey.h>

#include <math.h>
#include <stdbool.h>

#include "base/alloc.h"

#define STEPS_MAX 1000000

/* sums of a zone */
typedef struct zone_sums {
    int count, within, in_band[WCUT_BANDS_MAX];
    double sum, sizes, squares, min, max;
} zone_sums;

/* sums of a section: by step the feet's heights, the points' heights, the deviations */
typedef struct profile {
    double length; /* [mm] of the line */
    int steps;
    int *count;
    double *sum; /* 3 steps */
    wcut_section_row *row;
} profile;

struct wcut_survey {
    const wcut_regions *of;
    int bands;
    double band[WCUT_BANDS_MAX];
    zone_sums *zone;
    profile *profile;
    wcut_region_result *region;
    wcut_section_result *section;
    wcut_survey_result result;
};

/* ---- begin, end ---- */

static double side_length(const double *a) { return hypot(a[2] - a[0], a[3] - a[1]); }

static wcut_status make_profile(const wcut_section *s, profile *p) {
    for (int k = 0; k + 1 < s->points; k++) p->length += side_length(&s->point[2 * (size_t)k]);
    const double steps = ceil(p->length / s->step * (1 - 1e-12));
    if (!(p->length > 0) || !(steps <= STEPS_MAX)) return WCUT_BAD_ARGUMENT;
    p->steps = steps < 1 ? 1 : (int)steps;
    p->count = wcut_alloc((size_t)p->steps, sizeof *p->count);
    p->sum = wcut_alloc(3 * (size_t)p->steps, sizeof *p->sum);
    p->row = wcut_alloc((size_t)p->steps, sizeof *p->row);
    return p->count && p->sum && p->row ? WCUT_OK : WCUT_NO_MEMORY;
}

static bool regions_are_usable(const wcut_regions *r) {
    if (!r || r->regions < 0 || r->sections < 0 || r->regions > WCUT_REGIONS_MAX || r->sections > WCUT_SECTIONS_MAX ||
        (r->regions > 0 && !r->region) || (r->sections > 0 && !r->section))
        return false;
    for (int k = 0; k < r->regions; k++)
        if (r->region[k].corners < 0 || (r->region[k].corners > 0 && !r->region[k].corner)) return false;
    for (int k = 0; k < r->sections; k++) {
        const wcut_section *s = &r->section[k];
        if (s->points < 2 || !s->point || !(s->width > 0) || !(s->step > 0)) return false;
    }
    return true;
}

wcut_status wcut_survey_create(const wcut_regions *regions, int bands, const double *band, wcut_survey **survey) {
    if (!regions_are_usable(regions) || !survey || bands < 0 || bands > WCUT_BANDS_MAX || (bands > 0 && !band))
        return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < bands; k++)
        if (!(band[k] > 0) || !isfinite(band[k])) return WCUT_BAD_ARGUMENT;
    wcut_survey *s = wcut_alloc(1, sizeof *s);
    if (!s) return WCUT_NO_MEMORY;
    s->of = regions;
    s->bands = bands;
    for (int k = 0; k < bands; k++) s->band[k] = band[k];
    s->zone = wcut_alloc((size_t)regions->regions, sizeof *s->zone);
    s->region = wcut_alloc((size_t)regions->regions, sizeof *s->region);
    s->profile = wcut_alloc((size_t)regions->sections, sizeof *s->profile);
    s->section = wcut_alloc((size_t)regions->sections, sizeof *s->section);
    wcut_status status = s->zone && s->region && s->profile && s->section ? WCUT_OK : WCUT_NO_MEMORY;
    for (int k = 0; k < regions->sections && status == WCUT_OK; k++)
        status = make_profile(&regions->section[k], &s->profile[k]);
    if (status != WCUT_OK) {
        wcut_survey_destroy(s);
        return status;
    }
    *survey = s;
    return WCUT_OK;
}

void wcut_survey_destroy(wcut_survey *s) {
    if (!s) return;
    for (int k = 0; s->profile && k < s->of->sections; k++) {
        wcut_free(s->profile[k].count);
        wcut_free(s->profile[k].sum);
        wcut_free(s->profile[k].row);
    }
    wcut_free(s->zone);
    wcut_free(s->region);
    wcut_free(s->profile);
    wcut_free(s->section);
    wcut_free(s);
}

/* ---- points ---- */

/* whether a foot is in a zone; each end of a polygon's side belongs to the side above it */
static bool is_in_region(const wcut_region *r, wcut_vec3 p) {
    bool inside = false;
    if (!(p.x >= r->low.x && p.x <= r->high.x && p.y >= r->low.y && p.y <= r->high.y)) return false;
    if (r->corners == 0) return p.z >= r->low.z && p.z <= r->high.z;
    for (int k = 0, last = r->corners - 1; k < r->corners; last = k++) {
        const double *a = &r->corner[2 * (size_t)last], *b = &r->corner[2 * (size_t)k];
        if ((a[1] > p.y) != (b[1] > p.y)) inside ^= p.x < a[0] + (p.y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    }
    return inside;
}

static void add_to_zone(const wcut_survey *s, zone_sums *z, double tolerance, double d) {
    z->min = z->count == 0 || d < z->min ? d : z->min;
    z->max = z->count == 0 || d > z->max ? d : z->max;
    z->count++;
    z->within += fabs(d) <= tolerance;
    for (int k = 0; k < s->bands; k++) z->in_band[k] += fabs(d) <= s->band[k];
    z->sum += d;
    z->sizes += fabs(d);
    z->squares += d * d;
}

/* the way along a line to the place that is nearest to (x, y); -1: further from it than half the width */
static double way_along(const wcut_section *s, double x, double y) {
    double nearest = s->width / 2, along = -1, before = 0;
    for (int k = 0; k + 1 < s->points; k++) {
        const double *a = &s->point[2 * (size_t)k], dx = a[2] - a[0], dy = a[3] - a[1], size = hypot(dx, dy);
        const double t = size > 0 ? ((x - a[0]) * dx + (y - a[1]) * dy) / size : 0;

        /* in front of the line and behind it is no section */
        const bool outside = (k == 0 && t < 0) || (k + 2 == s->points && t > size);
        const double clamped = fmin(fmax(t, 0), size), ux = size > 0 ? dx / size : 0, uy = size > 0 ? dy / size : 0;
        const double away = hypot(x - a[0] - clamped * ux, y - a[1] - clamped * uy);
        if (!outside && away <= nearest) nearest = away, along = before + clamped;
        before += size;
    }
    return along;
}

static void add_to_profile(const wcut_section *s, profile *p, wcut_vec3 point, const wcut_deviation *d) {
    const double along = way_along(s, d->foot.x, d->foot.y);
    if (along < 0) return;
    const int step = along / s->step < p->steps ? (int)(along / s->step) : p->steps - 1;
    double *sum = &p->sum[3 * (size_t)step];
    p->count[step]++;
    sum[0] += d->foot.z;
    sum[1] += point.z;
    sum[2] += d->distance;
}

wcut_status wcut_survey_add(wcut_survey *s, int count, const wcut_vec3 *point, const wcut_deviation *deviation) {
    if (!s || count < 0 || (count > 0 && (!point || !deviation))) return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < count; k++) {
        const wcut_deviation *d = &deviation[k];
        if (d->place > WCUT_PLACE_BORDER || !isfinite(d->distance)) continue;
        for (int r = 0; r < s->of->regions; r++)
            if (is_in_region(&s->of->region[r], d->foot))
                add_to_zone(s, &s->zone[r], s->of->region[r].tolerance, d->distance);
        for (int c = 0; c < s->of->sections; c++) add_to_profile(&s->of->section[c], &s->profile[c], point[k], d);
    }
    return WCUT_OK;
}

/* ---- results ---- */

static wcut_region_result region_result(const wcut_survey *s, const wcut_region *r, const zone_sums *z) {
    wcut_region_result found = {.count = z->count, .passed = r->tolerance > 0 ? 0 : -1};
    if (z->count == 0) return found;
    found.mean = z->sum / z->count;
    found.mae = z->sizes / z->count;
    for (int k = 0; k < s->bands; k++) found.within_band[k] = (double)z->in_band[k] / z->count;
    found.rms = sqrt(z->squares / z->count);
    const double variance = z->count > 1 ? (z->squares - z->count * found.mean * found.mean) / (z->count - 1) : 0;
    found.std = variance > 0 ? sqrt(variance) : 0;
    found.min = z->min, found.max = z->max;
    if (r->tolerance > 0) {
        found.within = (double)z->within / z->count;
        found.passed = found.within >= r->share;
    }
    return found;
}

/* the middle of a step on its line */
static void place_row(const wcut_section *s, double along, wcut_section_row *row) {
    double before = 0;
    row->along = along;
    for (int k = 0; k + 1 < s->points; k++) {
        const double *a = &s->point[2 * (size_t)k], size = side_length(a);
        if (along > before + size && k + 2 < s->points) {
            before += size;
            continue;
        }
        const double share = size > 0 ? fmin((along - before) / size, 1) : 0;
        row->x = a[0] + share * (a[2] - a[0]);
        row->y = a[1] + share * (a[3] - a[1]);
        return;
    }
}

const wcut_survey_result *wcut_survey_eval(wcut_survey *s) {
    if (!s) return NULL;

    /* zones: one that fails fails the whole */
    s->result =
        (wcut_survey_result){.of = s->of, .bands = s->bands, .region = s->region, .section = s->section, .passed = 1};
    for (int k = 0; k < s->of->regions; k++) {
        s->region[k] = region_result(s, &s->of->region[k], &s->zone[k]);
        if (s->region[k].passed == 0) s->result.passed = 0;
    }

    /* sections: the means of each step, empty where nothing was measured */
    for (int c = 0; c < s->of->sections; c++) {
        const wcut_section *of = &s->of->section[c];
        const profile *p = &s->profile[c];
        s->section[c] = (wcut_section_result){p->steps, p->row};
        for (int k = 0; k < p->steps; k++) {
            wcut_section_row *row = &p->row[k];
            const double from = k * of->step, to = fmin(from + of->step, p->length), *sum = &p->sum[3 * (size_t)k];
            *row = (wcut_section_row){.count = p->count[k]};
            place_row(of, (from + to) / 2, row);
            if (row->count == 0) continue;
            row->nominal = sum[0] / row->count;
            row->measured = sum[1] / row->count;
            row->deviation = sum[2] / row->count;
        }
    }
    return &s->result;
}
