/* Candidate wires laid on a target: dynamic programming over lag and sag along the feed. */
#include "inverse/scan.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

#define LAG_MAX 1.2     /* [1] of the span */
#define SAG_MIN 0.01    /* [1] of the span: a straight wire under load needs endless tension */
#define SAG_MAX 0.43    /* [1] of the span: then the ends stand at 60 deg */
#define LAG_RATE 1.2    /* [1] largest change of the lag over the feed */
#define SAG_RATE 0.6    /* [1] largest gain of sag over the feed: more, and the middle would have to move back */
#define ROW_SPACING 0.1 /* [1] of the span */
#define PREFER 2e-4 /* [1] what a lag, and a sag other than SAG_BEST, cost: of wires that are alike the ordinary ones */
#define SAG_BEST 0.15 /* [1] of the span */
#define SMOOTH 1e-4   /* [1] what a change of lag and sag costs beside the bow: of wires that are alike the even ones */

enum { LAGS = 49, SAGS = 12, ROWS_MAX = 200, STATES = LAGS * SAGS };

static double lag_of_state(int state, double span) {
    const int lag = state / SAGS;
    return LAG_MAX * span * (2.0 * lag / (LAGS - 1) - 1);
}

/* squares: closer together where the wire is nearly straight */
static double sag_of_state(int state, double span) {
    const double t = (double)(state % SAGS) / (SAGS - 1);
    return span * (SAG_MIN + (SAG_MAX - SAG_MIN) * t * (0.3 + 0.7 * t));
}

double wcut_scan_y(const wcut_scan_row *row, double share) {
    return row->middle + row->lag * (0.5 - share) - 4 * row->sag * share * (1 - share);
}

/* The bow of a wire out of the target: d'' = - the normal curvature along it, its ends on the target or, free, where the
   squares inside the block are least. Gives the sum of squares inside, and how many samples that is. */
static double find_bow(const wcut_design_target *t, bool free_edges, wcut_scan_row *row, int *inside) {
    enum { N = WCUT_SCAN_SAMPLES };
    const double width = t->block.x, h = width / (N - 1);
    double curvature[N], weight[N];
    *inside = 0;
    for (int k = 0; k < N; k++) {
        const double share = (double)k / (N - 1), y = wcut_scan_y(row, share);
        const wcut_height at = wcut_heights_eval(&t->heights, share * width, y);
        const double slope = -row->lag / width - 4 * row->sag * (1 - 2 * share) / width;
        curvature[k] = (at.xx + slope * (2 * at.xy + slope * at.yy)) / sqrt(1 + at.x * at.x + at.y * at.y);
        weight[k] = y >= 0 && y <= t->block.y;
        *inside += weight[k] > 0;
    }

    /* twice the trapezoidal rule with the end correction of Numerov: exact for a cubic curvature */
    double rise = 0;
    row->bow[0] = row->bow[1] = 0;
    for (int k = 1; k + 1 < N; k++) {
        const double second = h * h * (curvature[k - 1] + 10 * curvature[k] + curvature[k + 1]) / 12;
        row->bow[k + 1] = 2 * row->bow[k] - row->bow[k - 1] - second;
    }

    /* a line through the ends, or through all that is inside */
    double low = 0;
    rise = row->bow[N - 1];
    if (free_edges && *inside > 2) {
        double s = 0, sx = 0, sxx = 0, sb = 0, sxb = 0;
        for (int k = 0; k < N; k++) {
            const double x = (double)k / (N - 1), w = weight[k] * (k == 0 || k == N - 1 ? 0.5 : 1);
            s += w, sx += w * x, sxx += w * x * x, sb += w * row->bow[k], sxb += w * x * row->bow[k];
        }
        const double det = s * sxx - sx * sx;
        if (det > 1e-6 * s * s) {
            rise = (s * sxb - sx * sb) / det;
            low = (sb - rise * sx) / s;
        }
    }
    double sum = 0;
    for (int k = 0; k < N; k++) {
        row->bow[k] -= low + rise * k / (N - 1);
        sum += weight[k] * row->bow[k] * row->bow[k];
    }
    row->rise_a = row->bow[0], row->rise_b = row->bow[N - 1];
    return sum;
}

/* whether the ends of a wire stand within the angle */
static bool is_allowed(double lag, double sag, double span, double angle_max) {
    const double steepest = (fabs(lag) + 4 * sag) / span;
    return atan(steepest) <= angle_max * (1 + 1e-9);
}

typedef struct programme { /* rows x STATES */
    double *cost;          /* of the best way to it */
    short *from;
    int rows;
    double first, spacing; /* [mm] of the rows' middles */
} programme;

static wcut_scan_row wire_of_state(const programme *p, const wcut_design_target *t, int row, int state) {
    const double span = t->block.x;
    return (wcut_scan_row){
        .middle = p->first + p->spacing * row, .lag = lag_of_state(state, span), .sag = sag_of_state(state, span)};
}

/* one row of the programme from the one before; `own` is what each state costs by itself */
static void advance_programme(programme *p, int row, double span, const double *own) {
    const double lag_step = 2 * LAG_MAX * span / (LAGS - 1);
    const int reach = (int)ceil(LAG_RATE * p->spacing / lag_step - 0.5);
    const double *before = p->cost + (size_t)(row - 1) * STATES;
    for (int s = 0; s < STATES; s++) {
        double best = HUGE_VAL;
        int from = -1;
        const int lag = s / SAGS;
        for (int l = lag - reach < 0 ? 0 : lag - reach; l <= lag + reach && l < LAGS; l++)
            for (int g = 0; g < SAGS; g++) {
                const int q = l * SAGS + g;
                const double gain = sag_of_state(s, span) - sag_of_state(q, span);
                if (gain > SAG_RATE * p->spacing || !(before[q] < best)) continue;
                const double change = (lag_of_state(s, span) - lag_of_state(q, span)) / span, sags = gain / span;
                const double cost = before[q] + SMOOTH * span * (change * change + sags * sags);
                if (cost < best) best = cost, from = q;
            }
        p->cost[(size_t)row * STATES + (size_t)s] = best + own[s];
        p->from[(size_t)row * STATES + (size_t)s] = (short)from;
    }
}

/* the best way through the programme becomes the scan's rows, with the bow of each wire */
static void trace_wires(const programme *p, const wcut_design_target *t, bool free_edges, wcut_scan *out) {
    const double *last = p->cost + (size_t)(p->rows - 1) * STATES;
    int state = 0, count = 0;
    for (int s = 1; s < STATES; s++)
        if (last[s] < last[state]) state = s;
    double sum = 0;
    out->max = 0;
    for (int r = p->rows - 1; r >= 0; r--) {
        wcut_scan_row *row = &out->row[r];
        int inside;
        *row = wire_of_state(p, t, r, state);
        sum += find_bow(t, free_edges, row, &inside);
        count += inside;
        for (int k = 0; k < WCUT_SCAN_SAMPLES; k++) {
            const double y = wcut_scan_y(row, (double)k / (WCUT_SCAN_SAMPLES - 1));
            if (y >= 0 && y <= t->block.y) out->max = fmax(out->max, fabs(row->bow[k]));
        }
        state = p->from[(size_t)r * STATES + (size_t)state];
    }
    out->rms = count > 0 ? sqrt(sum / count) : 0;
}

wcut_status wcut_scan_create(const wcut_design_target *t, bool free_edges, double angle_max, wcut_scan *out) {
    /* rows from before the block to behind it, as far as lag and sag reach */
    const double span = t->block.x;
    programme p = {.spacing = ROW_SPACING * span, .first = -LAG_MAX / 2 * span};
    const double last = t->block.y + (LAG_MAX / 2 + SAG_MAX) * span;
    p.rows = (int)ceil((last - p.first) / p.spacing) + 1;
    if (p.rows > ROWS_MAX) p.rows = ROWS_MAX, p.spacing = (last - p.first) / (ROWS_MAX - 1);
    const size_t rows = (size_t)p.rows;
    p.cost = wcut_alloc(rows * STATES, sizeof *p.cost);
    p.from = wcut_alloc(rows * STATES, sizeof *p.from);
    double *own = wcut_alloc(STATES, sizeof *own);
    wcut_scan_row *row = wcut_alloc(rows, sizeof *row);
    const bool whole = p.cost && p.from && own && row;

    /* row by row: what each wire costs by itself, then the best way to it */
    for (int r = 0; whole && r < p.rows; r++) {
        for (int s = 0; s < STATES; s++) {
            wcut_scan_row wire = wire_of_state(&p, t, r, s);
            int inside;
            own[s] =
                is_allowed(wire.lag, wire.sag, span, angle_max) ? find_bow(t, free_edges, &wire, &inside) : HUGE_VAL;
        }
        if (r == 0)
            memcpy(p.cost, own, STATES * sizeof *own);
        else
            advance_programme(&p, r, span, own);
    }
    if (whole) {
        *out = (wcut_scan){.rows = p.rows, .row = row};
        trace_wires(&p, t, free_edges, out);
    } else {
        wcut_free(row);
    }
    wcut_free(own);
    wcut_free(p.cost);
    wcut_free(p.from);
    return whole ? WCUT_OK : WCUT_NO_MEMORY;
}

void wcut_scan_clear(wcut_scan *scan) {
    wcut_free(scan->row);
    *scan = (wcut_scan){0};
}
