/* What can be said of a target before anything is simulated: the bow that no wire can follow, and why. */
#include <string.h>
#include <wirecut/design.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "inverse/prepare.h"

enum { MAP_COLUMNS = 41, MAP_ROWS_MAX = 201 };

/* [1] a Gauss curvature this small over the square of the larger principal one, or of what bends 1 mm over the block, is
   flat */
#define DOMED_SHARE 1e-3

const char *wcut_design_reason_name(wcut_design_reason reason) {
    static const char *const text[] = {"", "domed", "tight", "angle", "pattern"};
    return (unsigned)reason < sizeof text / sizeof *text ? text[reason] : "";
}

/* ---- the target's curvature ---- */

/* Gauss curvature and the larger principal one of a graph (do Carmo 1976, 3.3) */
static double gauss_of(const wcut_height *h, double *larger) {
    const double w = 1 + h->x * h->x + h->y * h->y;
    const double gauss = (h->xx * h->yy - h->xy * h->xy) / (w * w);
    const double mean =
        ((1 + h->y * h->y) * h->xx - 2 * h->x * h->y * h->xy + (1 + h->x * h->x) * h->yy) / (2 * w * sqrt(w));
    *larger = fabs(mean) + sqrt(fmax(mean * mean - gauss, 0));
    return gauss;
}

/* ---- the bow at a place ---- */

/* of the scanned wires, by linear interpolation along the feed and along the wire; NaN where no wire is */
static double bow_at_place(const wcut_scan *scan, double width, double x, double y, wcut_scan_row *nearest) {
    const double share = clamp(x / width, 0, 1), at = share * (WCUT_SCAN_SAMPLES - 1);
    const int k = (int)clamp(floor(at), 0, WCUT_SCAN_SAMPLES - 2);
    for (int r = 0; r + 1 < scan->rows; r++) {
        const wcut_scan_row *a = &scan->row[r], *b = a + 1;
        const double before = wcut_scan_y(a, share), behind = wcut_scan_y(b, share);
        if (!(before <= y && y <= behind)) continue;
        const double t = behind > before ? (y - before) / (behind - before) : 0, f = at - k;
        *nearest = t < 0.5 ? *a : *b;
        const double first = (1 - f) * a->bow[k] + f * a->bow[k + 1], second = (1 - f) * b->bow[k] + f * b->bow[k + 1];
        return (1 - t) * first + t * second;
    }
    return NAN;
}

/* why the bow is there: the strongest cause that applies */
static wcut_design_reason find_reason(const wcut_design_target *t, const wcut_job *job, double angle_max, wcut_height h,
                                      const wcut_scan_row *wire) {
    double larger;
    const double width = t->block.x, gauss = gauss_of(&h, &larger), flat = 8 / (width * width);
    if (gauss > DOMED_SHARE * fmax(larger * larger, flat * flat)) return WCUT_DESIGN_REASON_DOMED;

    /* the force on a wire in the foam bends it to T/F at the tightest, where it is fed at its largest speed */
    const double bend = 8 * wire->sag / (width * width);
    if (bend * job->tension > 0.98 * wcut_force_law_eval(&job->force_law, job->heat, job->speed_max))
        return WCUT_DESIGN_REASON_TIGHT;
    const double steepest = (fabs(wire->lag) + 4 * wire->sag) / width;
    if (atan(steepest) > 0.97 * angle_max) return WCUT_DESIGN_REASON_ANGLE;
    return WCUT_DESIGN_REASON_PATTERN;
}

static bool make_map_room(const wcut_design_target *t, wcut_design_map *m) {
    m->columns = MAP_COLUMNS;
    m->rows = (int)clamp(ceil(MAP_COLUMNS * t->block.y / t->block.x), 5, MAP_ROWS_MAX);
    const size_t cells = (size_t)m->rows * (size_t)m->columns;
    m->point = wcut_alloc(cells, sizeof *m->point);
    m->bow = wcut_alloc(cells, sizeof *m->bow);
    m->gauss = wcut_alloc(cells, sizeof *m->gauss);
    m->reason = wcut_alloc(cells, sizeof *m->reason);
    return m->point && m->bow && m->gauss && m->reason;
}

/* the map of the target's own block from a scan of the turned one */
static void fill_map_cells(const wcut_design_target *t, const wcut_job *job, const wcut_design_options *o,
                           const wcut_scan *scan, double width, wcut_design_map *m) {
    int count[5] = {0}, domed = 0;
    for (int j = 0; j < m->rows; j++)
        for (int i = 0; i < m->columns; i++) {
            const int at = j * m->columns + i;
            const double x = t->block.x * i / (m->columns - 1), y = t->block.y * j / (m->rows - 1);
            const wcut_height h = wcut_heights_eval(&t->heights, x, y);
            wcut_scan_row wire = {0};
            double larger;
            m->point[at] = vec3(x, y, h.z);
            const wcut_vec3 turned = wcut_design_turn(m->feed, t->block, m->point[at]);
            m->bow[at] = bow_at_place(scan, width, turned.x, turned.y, &wire);
            m->gauss[at] = gauss_of(&h, &larger);
            domed += m->gauss[at] > DOMED_SHARE * fmax(larger * larger, pow(8 / (width * width), 2));
            if (!isfinite(m->bow[at])) m->bow[at] = 0;
            if (fabs(m->bow[at]) > o->tolerance)
                m->reason[at] = (unsigned char)find_reason(t, job, o->angle_max, h, &wire);
            count[m->reason[at]]++;
        }
    const double cells = (double)m->rows * m->columns;
    for (int r = 0; r < 5; r++) m->share[r] = count[r] / cells;
    m->domed_share = domed / cells;
}

wcut_status wcut_design_map_create(const wcut_design_target *target, const wcut_job *job,
                                   const wcut_design_options *options, wcut_design_map **map, wcut_error *error) {
    const wcut_design_options o = options ? *options : wcut_design_options_default();
    wcut_status status = wcut_design_check(target, job, &o, map, error);
    if (status != WCUT_OK) return status;
    wcut_design_map *m = wcut_alloc(1, sizeof *m);
    wcut_design_target *turned = NULL;
    wcut_scan scan = {0};
    status = m && make_map_room(target, m) ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_design_choose_feed(target, &o, m->feed_rms, &m->feed);
    if (status == WCUT_OK) status = wcut_design_target_turn(target, m->feed, &turned);
    if (status == WCUT_OK) status = wcut_scan_create(turned, o.free_edges != 0, o.angle_max, &scan);
    if (status == WCUT_OK) {
        m->predicted_rms = scan.rms, m->predicted_max = scan.max;
        fill_map_cells(target, job, &o, &scan, turned->block.x, m);
        *map = m;
    } else {
        wcut_design_map_destroy(m);
        wcut_fail(error, status, "no memory for the map of a target");
    }
    wcut_scan_clear(&scan);
    wcut_design_target_destroy(turned);
    return status;
}

void wcut_design_map_destroy(wcut_design_map *m) {
    if (!m) return;
    wcut_free(m->point);
    wcut_free(m->bow);
    wcut_free(m->gauss);
    wcut_free(m->reason);
    wcut_free(m);
}
