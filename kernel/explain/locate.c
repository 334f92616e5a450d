/* Where a residual is not noise: windows of a channel in time, and patches of the scanned faces, that a search over all
   of them would not find in noise. */
#include "explain/locate.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "base/vec3.h"

/* windows: so many lengths [bins], every quarter of one; then entry, steady part, exit and the whole cut */
enum { LENGTHS = 9, REGIMES = 3, PART_WINDOWS = REGIMES + 1, MIN = 4 };
static const int window_length[LENGTHS] = {4, 6, 8, 12, 16, 24, 32, 48, 64};
static const char *const regime_name[REGIMES] = {"entry", "steady", "exit"};

/* faces: cells along the path and across it; every rectangle of cells is a window */
enum { STRIPES = 12, LANES = 5, CELLS = STRIPES * LANES };

/* found in one channel of a cut, or one scan, before the rest is set aside */
enum { MAX = 8 };

/* response of whitening behind a window [bins]: exp(-40 x 0.5 s / 5 s) is 2 % */
enum { TAIL = 40 };

/* mean of the lower half of chi-square with one degree of freedom */
#define LOWER_HALF 0.1427
/* share of the usual engaged length from which a cut is steady */
#define STEADY 0.9

/* a window with its shift: t in standard errors that whitening promises, shift in the rows' own unit */
typedef struct window {
    int cut, signal; /* signal WCUT_SIGNALS: the scan */
    int first, last; /* bins, or stripes; `last` is the one behind */
    int left, right; /* lanes of a scan */
    int kind;        /* of its length: which dispersion is its own */
    double t, shift, p, excess;
} window;

/* one channel of a cut: its residual and what whitening does to it */
typedef struct channel {
    const wcut_evidence_cut *c;
    int signal, n, there;
    double sigma;
    double *z, *gain, *scale; /* n; scale 0 where the row is missing */
    int regime[REGIMES + 1];  /* bins at which the regimes begin, and the end */
} channel;

typedef struct search {
    const wcut_evidence *e;
    double *residual;    /* rows, whitened; what was found is taken out */
    const double *whole; /* rows, whitened, as it came */
    double *raw;         /* rows: measured less predicted, to know what is missing */
    double dispersion[LENGTHS], scan_dispersion;
    double tests;
    int count, room;
    window *found;
} search;

/* ---- channels ---- */

static int signal_kind(int signal) { return signal < 2 ? 0 : signal < WCUT_SIGNALS ? 1 + signal % 2 : 3; }

/* bins before which the wire enters, and from which it leaves: by its usual engaged length */
static void find_regimes(channel *h, double *room) {
    const wcut_evidence_cut *c = h->c;
    memcpy(room, c->engaged, (size_t)h->n * sizeof *room);
    wcut_sort(h->n, room);
    const double max = STEADY * room[3 * h->n / 4];
    int first = 0, last = h->n;
    while (first < h->n && c->engaged[first] < max) first++;
    while (last > first && c->engaged[last - 1] < max) last--;
    h->regime[0] = 0, h->regime[1] = first, h->regime[2] = last, h->regime[3] = h->n;
}

/* room: 3 x bins */
static channel channel_of(const search *s, int cut, int signal, double *room) {
    const wcut_evidence_cut *c = &s->e->cut[cut];
    const double keep = exp(-WCUT_BIN_WIDTH / WCUT_NOISE_MEMORY);
    const int row = c->row + signal * c->bins;
    channel h = {.c = c, .signal = signal, .n = c->bins, .sigma = s->e->sigma[signal]};
    h.gain = room, h.scale = room + c->bins, h.z = s->residual + row;
    find_regimes(&h, room + 2 * (ptrdiff_t)c->bins);
    const double slow = s->e->noise.slow[wcut_noise_group(signal)];
    double variance = slow;
    for (int i = 0; i < h.n; i++) {
        const double size = variance + 1;
        h.gain[i] = variance / size;
        h.scale[i] = isfinite(s->raw[row + i]) ? 1 / sqrt(size) : 0;
        h.there += h.scale[i] > 0;
        if (h.scale[i] > 0) variance /= size;
        variance = keep * keep * variance + (1 - keep * keep) * slow;
    }
    return h;
}

/* the residual before whitening, in units of sigma; absent: 0 */
static void colour(const channel *h, const double *z, double *out) {
    const double keep = exp(-WCUT_BIN_WIDTH / WCUT_NOISE_MEMORY);
    double mean = 0;
    for (int i = 0; i < h->n; i++) {
        out[i] = 0;
        if (h->scale[i] > 0) {
            const double innovation = z[i] / h->scale[i];
            out[i] = mean + innovation;
            mean += h->gain[i] * innovation;
        }
        mean *= keep;
    }
}

/* the whitened constant 1 in a window, times `factor`, added to z; gives its products with z before and itself */
static void respond(const channel *h, int first, int last, double factor, double *product, double *square) {
    const double keep = exp(-WCUT_BIN_WIDTH / WCUT_NOISE_MEMORY);
    const int end = last + TAIL < h->n ? last + TAIL : h->n;
    double mean = 0;
    *product = *square = 0;
    for (int i = first; i < end; i++) {
        if (h->scale[i] > 0) {
            const double innovation = (i < last) - mean, w = innovation * h->scale[i];
            *product += w * h->z[i], *square += w * w;
            h->z[i] += factor * w;
            mean += h->gain[i] * innovation;
        }
        mean *= keep;
    }
}

static double mean_square(const channel *h) {
    double sum = 0;
    for (int i = 0; i < h->n; i++) sum += h->z[i] * h->z[i];
    return h->there > 0 ? sum / h->there : 0;
}

/* the k-th window of a channel; false behind the last */
static bool window_at(const channel *h, int k, window *w) {
    for (int l = 0; l < LENGTHS; l++) {
        const int length = window_length[l], stride = length / 4;
        const int count = h->n >= length ? (h->n - length) / stride + 1 : 0;
        if (k < count) {
            w->first = k * stride, w->last = w->first + length, w->kind = l;
            return true;
        }
        k -= count;
    }
    if (k >= PART_WINDOWS) return false;
    w->first = k < REGIMES ? h->regime[k] : 0;
    w->last = k < REGIMES ? h->regime[k + 1] : h->n;
    w->kind = 0;
    while (w->kind < LENGTHS - 1 && window_length[w->kind + 1] <= w->last - w->first) w->kind++;
    return true;
}

/* test a window; false where it holds too little */
static bool test_window(const channel *h, window *w) {
    double product, square;
    if (w->last - w->first < MIN) return false;
    respond(h, w->first, w->last, 0, &product, &square);
    if (!(square > 0.02 * MIN)) return false;
    w->t = product / sqrt(square), w->shift = product / square;
    return true;
}

/* ---- what the case's quiet half shows ---- */

static double lower_half(int n, double *square) {
    double sum = 0;
    if (n < 2 * MIN) return 1;
    wcut_sort(n, square);
    for (int i = 0; i < n / 2; i++) sum += square[i];
    const int half = n / 2;
    return fmax(1, sum / half / LOWER_HALF);
}

/* dispersion of windows by length, that of the two quietest of the six channels: an effect in the others is not to pass
   for noise; and how many tests there are. room: for a channel; square: all windows of a length in a channel */
static void find_dispersion(search *s, double *room, double *square) {
    /* windows of each length, in every channel of every cut */
    for (int l = 0; l < LENGTHS; l++) {
        double shown[WCUT_SIGNALS];
        for (int signal = 0; signal < WCUT_SIGNALS; signal++) {
            int n = 0;
            for (int k = 0; k < s->e->cuts; k++) {
                if (s->e->cut[k].bins == 0) continue;
                const channel h = channel_of(s, k, signal, room);
                window w;
                for (int i = 0; window_at(&h, i, &w); i++)
                    if (w.kind == l && w.last - w.first == window_length[l] && test_window(&h, &w))
                        square[n++] = w.t * w.t;
            }

            /* a channel's dispersion is the mean of the lower half of t^2, which a local effect leaves as it is */
            s->tests += n;
            shown[signal] = lower_half(n, square);
        }

        /* the two quietest channels count */
        wcut_sort(WCUT_SIGNALS, shown);
        s->dispersion[l] = (shown[0] + shown[1]) / 2;
    }

    /* windows of whole regimes and cuts are tests too */
    for (int k = 0; k < s->e->cuts; k++) s->tests += s->e->cut[k].bins > 0 ? WCUT_SIGNALS * PART_WINDOWS : 0;
}

static double sidak(double tests, double t) {
    const double p = fmin(2 * wcut_gaussian_tail(fabs(t)), 1);
    return p < 1 ? -expm1(tests * log1p(-p)) : 1;
}

/* ---- channels searched ---- */

/* Whether neighbours err alike: windows of some length, side by side, against the mean square of all bins. Values that
   are large but in no order are not a place. */
static bool has_order(const search *s, const channel *h, double own) {
    double min = 1;
    for (int l = 0; l < LENGTHS; l++) {
        double sum = 0;
        int n = 0;
        for (int first = 0; first + window_length[l] <= h->n; first += window_length[l]) {
            window w = {.first = first, .last = first + window_length[l]};
            if (test_window(h, &w)) sum += w.t * w.t, n++;
        }
        if (n > 0) min = fmin(min, wcut_chi_square_tail(sum / fmax(own, s->dispersion[l]), n));
    }
    const double tests = (double)s->e->cuts * WCUT_SIGNALS * LENGTHS;
    return min < WCUT_LOCATE_LEVEL / tests;
}

static bool overlaps(const search *s, const window *w) {
    for (int k = 0; k < s->count; k++) {
        const window *f = &s->found[k];
        if (f->cut == w->cut && f->signal == w->signal && w->first < f->last && f->first < w->last &&
            w->left < f->right && f->left < w->right)
            return true;
    }
    return false;
}

/* mean square of a channel beside a window; of all of it where less than a quarter is beside */
static double variance_outside(const channel *h, const window *w) {
    double sum = 0;
    int n = 0;
    for (int i = 0; i < h->n; i++)
        if ((i < w->first || i >= w->last) && h->scale[i] > 0) sum += h->z[i] * h->z[i], n++;
    return 4 * n >= h->there && n > 0 ? sum / n : mean_square(h);
}

/* the window that stands out most, found again and again with what was found taken out */
static void search_channel(search *s, int cut, int signal, double *room) {
    const channel h = channel_of(s, cut, signal, room);
    for (int found = 0; found < MAX && s->count < s->room; found++) {
        /* where neighbours do not err alike, a window is also held against the mean square beside it */
        const bool order = has_order(s, &h, mean_square(&h));
        window best = {.t = 0}, w = {.cut = cut, .signal = signal, .left = 0, .right = 1};
        double max = 0;

        /* the largest t of all windows that do not overlap with one already found */
        for (int k = 0; window_at(&h, k, &w); k++) {
            if (overlaps(s, &w) || !test_window(&h, &w)) continue;
            double t = fabs(w.t) / sqrt(s->dispersion[w.kind]);
            if (!order && t > max) t = fmin(t, fabs(w.t) / sqrt(variance_outside(&h, &w)));
            if (t > max) max = t, best = w;
        }

        /* its probability among all tests (Sidak 1967); end where nothing stands out */
        best.p = sidak(s->tests, max);
        if (!(best.p <= WCUT_LOCATE_LEVEL)) return;

        /* its share of the misfit */
        double product, response, sum = 0;
        const double *z = s->whole + h.c->row + (ptrdiff_t)signal * h.n;
        for (int i = best.first; i < best.last; i++) sum += z[i] * z[i] - (h.scale[i] > 0);
        best.excess = fmax(best.t * best.t - 1, sum);

        /* take the shift out of the channel, before the next window is sought */
        respond(&h, best.first, best.last, -best.shift, &product, &response);
        s->found[s->count++] = best;
    }
}

/* ---- scans ---- */

/* the cell of each patch of a cut: stripe x LANES + lane */
static int cell_of(const wcut_evidence_cut *c, int patch) {
    const wcut_patches *p = &c->patch;
    double low = p->station[0], high = low;
    for (int i = 1; i < p->count; i++) low = fmin(low, p->station[i]), high = fmax(high, p->station[i]);
    const double width = fmax(high - low, 1e-9);
    const int stripe = (int)clamp((p->station[patch] - low) / width * STRIPES, 0, STRIPES - 1);
    return stripe * LANES + (int)clamp(p->point[patch].x / c->job->block_size.x * LANES, 0, LANES - 1);
}

typedef struct cells {
    double sum[CELLS];
    int count[CELLS];
} cells;

static double *scan_rows(const search *s, int cut) {
    return s->residual + s->e->cut[cut].row + (ptrdiff_t)WCUT_SIGNALS * s->e->cut[cut].bins;
}

static cells sum_cells(const search *s, int cut) {
    const wcut_evidence_cut *c = &s->e->cut[cut];
    const double *z = scan_rows(s, cut);
    cells out = {.count = {0}};
    for (int i = 0; i < c->patch.count; i++) {
        const int cell = cell_of(c, i);
        out.sum[cell] += z[i], out.count[cell]++;
    }
    return out;
}

static int sum_rectangle(const cells *in, const window *w, double *sum) {
    int count = 0;
    *sum = 0;
    for (int i = w->first; i < w->last; i++)
        for (int j = w->left; j < w->right; j++) *sum += in->sum[i * LANES + j], count += in->count[i * LANES + j];
    return count;
}

/* next rectangle in order; the first is from the empty one */
static bool next_rectangle(window *w) {
    if (w->right < LANES) return w->right++, true;
    if (w->left < LANES - 1) return w->left++, w->right = w->left + 1, true;
    w->left = 0, w->right = 1;
    if (w->last < STRIPES) return w->last++, true;
    if (w->first == STRIPES - 1) return false;
    w->first++, w->last = w->first + 1;
    return true;
}

/* what whole stripes of all scans show in their quiet half: encoder noise moves a stripe as a whole */
static void find_scan_dispersion(search *s, double *square) {
    int n = 0;
    for (int k = 0; k < s->e->cuts; k++) {
        if (s->e->cut[k].patch.count == 0) continue;
        const cells in = sum_cells(s, k);
        for (int i = 0; i < STRIPES; i++) {
            const window w = {.first = i, .last = i + 1, .left = 0, .right = LANES};
            double sum;
            const int count = sum_rectangle(&in, &w, &sum);
            if (count > 0) square[n++] = sum * sum / count;
        }
        window w = {.first = 0, .last = 1};
        while (next_rectangle(&w)) s->tests++;
    }
    s->scan_dispersion = lower_half(n, square);
}

static void search_scan(search *s, int cut) {
    /* rows of the scan: those searched, from which findings are taken out, and the whole */
    const wcut_evidence_cut *c = &s->e->cut[cut];
    double *z = scan_rows(s, cut);
    const double *whole = s->whole + (z - s->residual);
    for (int found = 0; found < MAX && s->count < s->room && c->patch.count > 0; found++) {
        /* sums over the cells, for sums over rectangles */
        const cells in = sum_cells(s, cut);
        double own = 0, max = 0;
        for (int i = 0; i < c->patch.count; i++) own += z[i] * z[i] / c->patch.count;

        /* the rectangle that stands out most */
        window best = {.t = 0}, w = {.cut = cut, .signal = WCUT_SIGNALS, .first = 0, .last = 1};
        while (next_rectangle(&w)) {
            double sum;
            const int count = sum_rectangle(&in, &w, &sum);
            if (count < MIN || overlaps(s, &w)) continue;
            w.t = sum / sqrt(count), w.shift = sum / count;
            const double t = fabs(w.t) / sqrt(fmax(s->scan_dispersion, own));
            if (t > max) max = t, best = w;
        }

        /* its probability among all tests; end where nothing stands out */
        best.p = sidak(s->tests, max);
        if (!(best.p <= WCUT_LOCATE_LEVEL)) return;

        /* its share of the misfit, and the shift taken out of its patches */
        double sum = 0;
        for (int i = 0; i < c->patch.count; i++) {
            const int cell = cell_of(c, i), stripe = cell / LANES, lane = cell % LANES;
            if (stripe < best.first || stripe >= best.last || lane < best.left || lane >= best.right) continue;
            sum += whole[i] * whole[i] - 1;
            z[i] -= best.shift;
        }
        best.excess = fmax(best.t * best.t - 1, sum);
        s->found[s->count++] = best;
    }
}

/* ---- what was found, told ---- */

typedef struct box {
    wcut_vec3 low, high;
    bool any;
} box;

static void box_add(box *b, wcut_vec3 p) {
    b->low = b->any ? vec3(fmin(b->low.x, p.x), fmin(b->low.y, p.y), fmin(b->low.z, p.z)) : p;
    b->high = b->any ? vec3(fmax(b->high.x, p.x), fmax(b->high.y, p.y), fmax(b->high.z, p.z)) : p;
    b->any = true;
}

/* where the wire was in the foam meanwhile; where none of it was, where its middle was */
static box swept(const wcut_evidence_cut *c, const wcut_response *d, double from, double to) {
    const wcut_trajectory *t = &c->exogenous;
    const wcut_vec3 size = c->job->block_size;
    box inside = {.any = false}, beside = {.any = false};
    for (int i = 0; i < d->count; i++) {
        if (!d->present[i] || t->time[i] < from || t->time[i] > to) continue;
        const wcut_vec3 *node = d->position + (size_t)i * (size_t)d->nodes;
        box_add(&beside, node[d->nodes / 2]);
        for (int j = 0; j < d->nodes; j++) {
            const wcut_vec3 p = node[j];
            if (p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x <= size.x && p.y <= size.y && p.z <= size.z)
                box_add(&inside, p);
        }
    }
    return inside.any ? inside : beside;
}

static double station_at(const wcut_evidence_cut *c, double time) {
    return wcut_between(c->exogenous.count, c->exogenous.time, c->exogenous.station, time);
}

static void tell_channel(const search *s, const window *w, const wcut_response *d, double *room, wcut_mismatch *out) {
    /* back from whitened values to the unit of the channel */
    const wcut_evidence_cut *c = &s->e->cut[w->cut];
    channel h = channel_of(s, w->cut, w->signal, room);
    double *value = room + 3 * (ptrdiff_t)c->bins, sum = 0;
    int n = 0;
    colour(&h, s->whole + c->row + (ptrdiff_t)w->signal * c->bins, value);
    for (int i = w->first; i < w->last; i++)
        if (h.scale[i] > 0) sum += value[i], n++;
    const double unit = w->signal < 2 ? 1 : 180 / WCUT_PI;

    /* mean over the window, and which channel it is */
    out->mean = unit * h.sigma * sum / (n > 0 ? n : 1);
    out->channel = (wcut_evidence_channel)(WCUT_EVIDENCE_CHANNEL_TENSION + signal_kind(w->signal));
    snprintf(out->column, sizeof out->column, "%s",
             wcut_channel_name((wcut_channel)(WCUT_CHANNEL_TENSION_A + w->signal)));

    /* where it is in time, on the path, and in the block */
    out->time[0] = c->from + w->first * WCUT_BIN_WIDTH, out->time[1] = c->from + w->last * WCUT_BIN_WIDTH;
    for (int k = 0; k < 2; k++) out->station[k] = station_at(c, out->time[k]), out->wire[k] = (double)NAN;
    const box where = swept(c, d, out->time[0], out->time[1]);
    out->block[0] = where.low, out->block[1] = where.high;

    /* the regime that the window lies in */
    for (int k = 0; k < REGIMES; k++)
        if (w->first >= h.regime[k] && w->last <= h.regime[k + 1])
            snprintf(out->regime, sizeof out->regime, "%s", regime_name[k]);
}

/* share of the wire's length at which it enters the block: the line of least squares of share over x, at 0 */
static double entering(const wcut_patches *p) {
    double x = 0, share = 0, xx = 0, xs = 0;
    for (int i = 0; i < p->count; i++) x += p->point[i].x / p->count, share += p->across[i] / p->count;
    for (int i = 0; i < p->count; i++) {
        const double dx = p->point[i].x - x;
        xx += dx * dx, xs += dx * (p->across[i] - share);
    }
    return xx > 0 ? share - xs / xx * x : 0;
}

static void tell_scan(const search *s, const window *w, wcut_mismatch *out) {
    const wcut_evidence_cut *c = &s->e->cut[w->cut];
    const wcut_patches *p = &c->patch;
    const double *z = s->whole + c->row + (ptrdiff_t)WCUT_SIGNALS * c->bins, length = c->job->wire_length;

    /* patches of the rectangle: mean deviation, and the boxes they lie in */
    box where = {.any = false}, range = {.any = false};
    double sum = 0;
    int n = 0;
    for (int i = 0; i < p->count; i++) {
        const int cell = cell_of(c, i), stripe = cell / LANES, lane = cell % LANES;
        if (stripe < w->first || stripe >= w->last || lane < w->left || lane >= w->right) continue;
        sum += z[i] * p->sigma[i], n++;
        box_add(&where, p->point[i]);
        box_add(&range, vec3(p->station[i], (p->across[i] - entering(p)) * length, 0));
    }

    /* the mean in mm; the range of stations and of the wire */
    out->mean = n > 0 ? sum / n : 0;
    out->channel = WCUT_EVIDENCE_CHANNEL_SCAN;
    snprintf(out->column, sizeof out->column, "scan");
    out->station[0] = range.low.x, out->station[1] = range.high.x;
    out->wire[0] = range.low.y, out->wire[1] = range.high.y;
    out->block[0] = where.low, out->block[1] = where.high;

    /* times at which the wire was there */
    for (int k = 0; k < 2; k++)
        out->time[k] = wcut_between(c->exogenous.count, c->exogenous.station, c->exogenous.time, out->station[k]);
}

static int compare_excess(const void *a, const void *b) {
    const window *x = a, *y = b;
    if (x->excess != y->excess) return x->excess < y->excess ? 1 : -1;
    if (x->cut != y->cut) return x->cut - y->cut;
    return x->signal != y->signal ? x->signal - y->signal : x->first - y->first;
}

/* misfit beyond noise of the whole case: of its rows, but not less than that of what was found */
static double whole_excess(const search *s) {
    double sum = 0, found = 0;
    for (int i = 0; i < s->e->rows; i++) sum += s->whole[i] * s->whole[i] - (s->whole[i] != 0);
    for (int k = 0; k < s->count; k++) found += s->found[k].excess;
    return fmax(sum, found);
}

/* the wire's positions along the exogenous trajectory of the cuts that have findings; d: cuts */
static wcut_status drive_cuts(const search *s, int count, wcut_response *d, wcut_error *error) {
    for (int k = 0; k < count; k++) {
        const int cut = s->found[k].cut;
        if (d[cut].position || s->found[k].signal == WCUT_SIGNALS) continue;
        wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
        const wcut_job job = wcut_model_job(s->e, &s->e->at, cut, effect);
        const wcut_status status =
            wcut_response_run(&job, WCUT_NODES_COARSE, &s->e->cut[cut].exogenous, true, s->e->stop, &d[cut], error);
        if (status != WCUT_OK) return status;
    }
    return WCUT_OK;
}

static wcut_status tell_mismatch(search *s, double *room, int *count, wcut_mismatch *out, wcut_error *error) {
    const double whole = whole_excess(s);
    qsort(s->found, (size_t)s->count, sizeof *s->found, compare_excess);
    const int max = s->count < WCUT_MISMATCHES ? s->count : WCUT_MISMATCHES;
    wcut_response *d = wcut_alloc((size_t)s->e->cuts, sizeof *d);
    wcut_status status = d ? drive_cuts(s, max, d, error) : wcut_fail(error, WCUT_NO_MEMORY, "no memory");
    for (int k = 0; status == WCUT_OK && k < max; k++) {
        const window *w = &s->found[k];
        out[k] = (wcut_mismatch){.cut = s->e->cut[w->cut].index, .p_value = w->p, .share = w->excess / whole};
        if (w->signal < WCUT_SIGNALS)
            tell_channel(s, w, &d[w->cut], room, &out[k]);
        else
            tell_scan(s, w, &out[k]);
    }
    for (int k = 0; d && k < s->e->cuts; k++) wcut_response_destroy(&d[k]);
    wcut_free(d);
    if (status == WCUT_OK) *count = max;
    return status;
}

wcut_status wcut_mismatch_locate(const wcut_evidence *e, const double *residual, int *count, wcut_mismatch *out,
                                 wcut_error *error) {
    /* the largest cut decides the room */
    int bins = 0, scans = 0;
    for (int k = 0; k < e->cuts; k++) {
        bins = e->cut[k].bins > bins ? e->cut[k].bins : bins;
        scans += e->cut[k].patch.count > 0;
    }

    /* copies: what is found is taken out of `residual`, while `whole` stays */
    search s = {.e = e, .whole = residual, .room = MAX * (WCUT_SIGNALS * e->cuts + scans)};
    s.residual = wcut_copy(residual, (size_t)e->rows, sizeof *residual);
    s.raw = wcut_alloc((size_t)e->rows, sizeof(double));
    s.found = wcut_alloc((size_t)s.room, sizeof *s.found);
    double *room = wcut_alloc(4 * (size_t)bins, sizeof *room);
    /* windows of a length start every bin at most */
    double *square = wcut_alloc((size_t)e->cuts * (size_t)(bins + 1 + STRIPES), sizeof *square);
    wcut_status status = WCUT_NO_MEMORY;

    /* dispersions first, because every test is divided by them */
    if (s.residual && s.raw && s.found && room && square) {
        wcut_evidence_residual(e, s.raw);
        find_dispersion(&s, room, square);
        find_scan_dispersion(&s, square);

        /* then channel by channel and scan by scan */
        for (int k = 0; k < e->cuts; k++) {
            if (e->cut[k].bins == 0) continue;
            for (int signal = 0; signal < WCUT_SIGNALS; signal++) search_channel(&s, k, signal, room);
            search_scan(&s, k);
        }

        /* findings of all cuts, sorted and written out */
        status = tell_mismatch(&s, room, count, out, error);
    } else {
        wcut_fail(error, status, "no memory for %d rows", e->rows);
    }

    wcut_free(square);
    wcut_free(room);
    wcut_free(s.found);
    wcut_free(s.raw);
    wcut_free(s.residual);
    return status;
}
