/* Rills: the direction of least variation of the brightness. The covariance of its gradients (structure tensor: Bigun,
   Granlund 1987) is taken in the frame of the simulated wire, so that its curvature within a patch does not blur it. */
#include "photo/rills.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/sort.h"

/* cells a side of a patch: each is judged and left out by itself */
/* RADIUS: [1] of the filter over its standard deviation; a filter that ends at 3 turns oblique rills by up to 0.2 deg */
enum { CELLS = 5, MARGIN = 13, SCALES = 2, RADIUS = 4, RADIUS_MAX = 12 };

static const double SCALE[SCALES] = {1.5, 3}; /* [px] standard deviation of the Gauss filter: finer ones let the
                                                 picture's own grid through */
static const double CONTRAST = 0.8;           /* [grey levels] rms: rounding to whole levels alone leaves 0.29 */
static const double NOISE_RATIO = 3;          /* contrast over what the picture's noise leaves after the filter */
static const double COHERENCE = 0.25;         /* [1] of a readable patch; noise alone has below 0.1 */
static const double CELL_SHARE = 0.6;         /* of the cells must have contrast: an edge or a scratch crosses fewer */
static const double CELL_WEIGHT = 4;          /* a cell counts at most so many times the median cell */

/* ---- grey levels and their noise ---- */

/* median of |second differences| along rows, as the standard deviation of white noise: 1.4826 / sqrt(6) */
static double noise_of(const wcut_grey *g, double *room, int room_count) {
    int count = 0;
    const size_t pixels = (size_t)g->width * g->height, stride = pixels / room_count + 1;
    for (size_t k = 1; k + 1 < pixels && count < room_count; k += stride) {
        const int column = (int)(k % g->width);
        const float *at = g->level + k;
        if (column == 0 || column == g->width - 1 || at[-1] < 0 || at[0] < 0 || at[1] < 0) continue;
        room[count++] = fabs((double)at[-1] - 2.0 * at[0] + at[1]);
    }
    if (count == 0) return 0;
    wcut_sort(count, room);
    return 1.4826 / sqrt(6) * sorted_median(count, room);
}

wcut_status wcut_grey_create(const wcut_picture *picture, double resolution, wcut_grey **grey) {
    enum { ROOM = 100000 };
    wcut_grey *g = wcut_alloc(1, sizeof *g);
    double *room = wcut_alloc(ROOM, sizeof *room);
    if (g) g->level = wcut_alloc((size_t)picture->width * picture->height, sizeof *g->level);
    if (!g || !g->level || !room) {
        wcut_grey_destroy(g);
        wcut_free(room);
        return WCUT_NO_MEMORY;
    }
    g->width = picture->width;
    g->height = picture->height;
    g->resolution = resolution;

    /* luminance of Rec. 601 */
    for (size_t k = 0; k < (size_t)picture->width * picture->height; k++) {
        const unsigned char *c = picture->pixel + 4 * k;
        g->level[k] = c[3] ? (float)(0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]) : -1;
    }
    g->noise = noise_of(g, room, ROOM);
    wcut_free(room);
    *grey = g;
    return WCUT_OK;
}

void wcut_grey_destroy(wcut_grey *g) {
    if (!g) return;
    wcut_free(g->level);
    wcut_free(g);
}

/* ---- the window of a patch ---- */

/* a patch's pixels with a margin, filtered: brightness and its gradient, x to the right, y up [1/px] */
typedef struct window {
    int left, top, width, height; /* in the picture, margin included */
    float *level, *row, *smooth, *gx, *gy;
    unsigned char *known; /* all pixels that the filter saw are there */
} window;

static void window_clear(window *w) {
    wcut_free(w->level);
    wcut_free(w->row);
    wcut_free(w->smooth);
    wcut_free(w->gx);
    wcut_free(w->gy);
    wcut_free(w->known);
}

static bool window_create(const wcut_grey *g, wcut_vec3 middle, double block_y, double side, window *w) {
    const double half = side / 2 / g->resolution, u = middle.x / g->resolution - 0.5,
                 v = (block_y - middle.y) / g->resolution - 0.5;
    *w = (window){.left = (int)floor(u - half) - MARGIN, .top = (int)floor(v - half) - MARGIN};
    w->width = w->height = (int)ceil(2 * half) + 2 * MARGIN + 1;

    /* level, filtered level and gradient of each pixel */
    const size_t n = (size_t)w->width * w->height;
    w->level = wcut_alloc(n, sizeof *w->level);
    w->row = wcut_alloc(n, sizeof *w->row);
    w->smooth = wcut_alloc(n, sizeof *w->smooth);
    w->gx = wcut_alloc(n, sizeof *w->gx);
    w->gy = wcut_alloc(n, sizeof *w->gy);
    w->known = wcut_alloc(n, sizeof *w->known);
    if (!w->level || !w->row || !w->smooth || !w->gx || !w->gy || !w->known) {
        window_clear(w);
        return false;
    }

    /* pixels outside the picture are -1: not known */
    for (int j = 0; j < w->height; j++)
        for (int i = 0; i < w->width; i++) {
            const int c = w->left + i, r = w->top + j;
            const bool in = c >= 0 && r >= 0 && c < g->width && r < g->height;
            w->level[(size_t)j * w->width + i] = in ? g->level[(size_t)r * g->width + c] : -1;
        }
    return true;
}

/* a filter along rows (step 1) or columns (step width) of a window; pixels within the radius of its border stay 0 */
static void filter(const window *w, const float *from, int step, int radius, const double *tap, float *to) {
    const int i0 = step == 1 ? radius : 0, j0 = step == 1 ? 0 : radius;
    for (int j = j0; j < w->height - j0; j++)
        for (int i = i0; i < w->width - i0; i++) {
            const size_t at = (size_t)j * w->width + i;
            double sum = 0;
            for (int k = -radius; k <= radius; k++) sum += tap[k + radius] * from[at + (ptrdiff_t)k * step];
            to[at] = (float)sum;
        }
}

/* a pixel that is not there spoils those that its filter reaches: rows first, then columns, by the last one that is missing */
static void find_known(window *w, int radius) {
    memset(w->known, 0, (size_t)w->width * w->height);
    for (int j = 0; j < w->height; j++)
        for (int i = 0, missing = -1; i < w->width; i++) {
            if (w->level[(size_t)j * w->width + i] < 0) missing = i;
            if (i - 2 * radius > missing) w->known[(size_t)j * w->width + i - radius] = 1;
        }
    for (int i = 0; i < w->width; i++)
        for (int j = 0, missing = -1; j < w->height; j++) {
            /* what is written lies behind what is read */
            unsigned char *column = w->known + i;
            if (!(column[(size_t)j * w->width] & 1)) missing = j;
            if (j - 2 * radius > missing) column[(size_t)(j - radius) * w->width] |= 2;
        }
    for (int k = 0; k < w->width * w->height; k++) w->known[k] = w->known[k] == 3;
}

/* brightness and gradient at a scale */
static void filter_window(window *w, double scale) {
    const int radius = (int)ceil(RADIUS * scale);
    double gauss[2 * RADIUS_MAX + 1] = {0}, slope[2 * RADIUS_MAX + 1] = {0}, sum = 0, moment = 0;
    for (int k = -radius; k <= radius; k++) sum += gauss[k + radius] = exp(-0.5 * k * k / (scale * scale));
    for (int k = -radius; k <= radius; k++) {
        gauss[k + radius] /= sum;
        slope[k + radius] = k * gauss[k + radius];
        moment += k * slope[k + radius];
    }
    for (int k = 0; k <= 2 * radius; k++) slope[k] /= moment; /* the slope of a plane is exact */

    filter(w, w->level, 1, radius, gauss, w->row);
    filter(w, w->row, w->width, radius, gauss, w->smooth);
    filter(w, w->row, w->width, radius, slope, w->gy);
    filter(w, w->level, 1, radius, slope, w->row);
    filter(w, w->row, w->width, radius, gauss, w->gx);

    /* rows run down, y runs up */
    for (int k = 0; k < w->width * w->height; k++) w->gy[k] *= -1;
    find_known(w, radius);
}

/* ---- moments of a cell ---- */

/* sums over the pixels of a cell: gradient along and across the wire, brightness and its plane */
typedef struct cell {
    double n, t, c, tt, cc, tc;
    double i, ii, x, y, xx, yy, xy, ix, iy;
} cell;

static void add_to_cell(cell *s, double t, double c, double level, double x, double y) {
    s->n += 1;
    s->t += t, s->c += c;
    s->tt += t * t, s->cc += c * c, s->tc += t * c;
    s->i += level, s->ii += level * level;
    s->x += x, s->y += y;
    s->xx += x * x, s->yy += y * y, s->xy += x * y;
    s->ix += level * x, s->iy += level * y;
}

/* variance of the brightness about its best plane */
static double detrended(const cell *s) {
    const double n = s->n, xx = s->xx / n - s->x / n * (s->x / n), yy = s->yy / n - s->y / n * (s->y / n),
                 xy = s->xy / n - s->x / n * (s->y / n), ix = s->ix / n - s->i / n * (s->x / n),
                 iy = s->iy / n - s->i / n * (s->y / n), ii = s->ii / n - s->i / n * (s->i / n),
                 det = xx * yy - xy * xy;
    if (!(det > 0)) return 0;
    return fmax(ii - (ix * ix * yy - 2 * ix * iy * xy + iy * iy * xx) / det, 0);
}

/* covariance of the gradient: along the wire, across it, both; slowly changing light has none */
typedef struct tensor {
    double along, across, both, weight;
} tensor;

static tensor tensor_of(const cell *s) {
    const double n = s->n;
    return (tensor){s->tt / n - s->t / n * (s->t / n), s->cc / n - s->c / n * (s->c / n),
                    s->tc / n - s->t / n * (s->c / n), 1};
}

/* direction of least variation against the wire: 1/2 atan2(-2 C, B - A) */
static double angle_of(const tensor *t) { return 0.5 * atan2(-2 * t->both, t->across - t->along); }

static tensor sum_of(const tensor *t, int without) {
    tensor s = {0};
    for (int k = 0; k < CELLS * CELLS; k++)
        if (k != without) {
            s.along += t[k].weight * t[k].along;
            s.across += t[k].weight * t[k].across;
            s.both += t[k].weight * t[k].both;
            s.weight += t[k].weight;
        }
    return s;
}

/* a cell with far more variation than the median one counts as the median's multiple: a scratch is no rill */
static void weigh_cells(tensor *t, int count) {
    double energy[CELLS * CELLS];
    int at = 0;
    for (int k = 0; k < CELLS * CELLS; k++)
        if (t[k].weight > 0) energy[at++] = t[k].along + t[k].across;
    wcut_sort(count, energy);
    const double limit = CELL_WEIGHT * sorted_median(count, energy);
    for (int k = 0; k < CELLS * CELLS; k++) {
        const double own = t[k].along + t[k].across;
        if (t[k].weight > 0 && own > limit) t[k].weight = limit / own;
    }
}

/* ---- a patch at one scale ---- */

typedef struct reading {
    bool readable;
    double angle, sigma, coherence, contrast;
} reading;

/* the standard deviation of the angle: each cell left out in turn (jackknife) */
static double angle_sigma(const tensor *t, int count, double angle) {
    double sum = 0;
    for (int k = 0; k < CELLS * CELLS; k++) {
        if (!(t[k].weight > 0)) continue;
        const tensor rest = sum_of(t, k);
        double d = angle_of(&rest) - angle;
        d -= WCUT_PI * floor(d / WCUT_PI + 0.5);
        sum += d * d;
    }
    return sqrt(sum * (count - 1) / count);
}

static reading read_cells(const cell *s, double enough, double noise, double scale) {
    tensor t[CELLS * CELLS] = {{0}};
    double contrast[CELLS * CELLS];
    int count = 0, strong = 0;

    /* what white noise of the picture leaves of its brightness after the filter: 1 / (2 sqrt(pi) scale) */
    const double least = fmax(CONTRAST, NOISE_RATIO * noise / (2 * sqrt(WCUT_PI) * scale));
    for (int k = 0; k < CELLS * CELLS; k++) {
        if (s[k].n < enough) continue;
        t[k] = tensor_of(&s[k]);
        contrast[count] = sqrt(detrended(&s[k]));
        strong += contrast[count++] >= least;
    }
    reading r = {0};
    if (count < CELLS * CELLS / 2) return r;

    weigh_cells(t, count);
    wcut_sort(count, contrast);
    const tensor all = sum_of(t, -1);
    const double sum = all.along + all.across;
    r.contrast = sorted_median(count, contrast);
    r.coherence = sum > 0 ? hypot(all.across - all.along, 2 * all.both) / sum : 0;

    /* without contrast the direction is that of rounded grey levels */
    if (strong < CELL_SHARE * count) r.coherence = 0;
    if (r.coherence < COHERENCE) return r;

    r.readable = true;
    r.angle = angle_of(&all);
    r.sigma = angle_sigma(t, count, r.angle);
    return r;
}

/* sums over the patch's cells at the scale of a filtered window */
static void fill_cells(const window *w, const wcut_grey *g, const wcut_face_grid *grid, double block_y, double side,
                       wcut_vec3 middle, cell *s) {
    memset(s, 0, sizeof *s * CELLS * CELLS);
    for (int j = MARGIN; j < w->height - MARGIN; j++)
        for (int i = MARGIN; i < w->width - MARGIN; i++) {
            const size_t at = (size_t)j * w->width + i;
            if (!w->known[at]) continue;
            const double x = (w->left + i + 0.5) * g->resolution, y = block_y - (w->top + j + 0.5) * g->resolution;
            const int a = (int)floor(CELLS * ((x - middle.x) / side + 0.5)),
                      b = (int)floor(CELLS * ((y - middle.y) / side + 0.5));
            if (a < 0 || b < 0 || a >= CELLS || b >= CELLS) continue;
            const wcut_face_place f = wcut_face_grid_locate(grid, x, y);
            if (!f.there) continue;
            const double length = hypot(f.tangent_x, f.tangent_y), tx = f.tangent_x / length, ty = f.tangent_y / length;
            add_to_cell(&s[b * CELLS + a], tx * w->gx[at] + ty * w->gy[at], -ty * w->gx[at] + tx * w->gy[at],
                        w->smooth[at], i, j);
        }
}

wcut_status wcut_rills_measure(const wcut_grey *grey, const wcut_face_grid *grid, wcut_vec3 block, double side,
                               wcut_rill_patch *patch) {
    /* the patch with its surroundings, so that filters have no border in it */
    window w;
    if (!window_create(grey, patch->place, block.y, side, &w)) return WCUT_NO_MEMORY;
    const double pixels = side / grey->resolution, of_cell = pixels * pixels / (CELLS * CELLS);
    cell s[CELLS * CELLS];
    reading best = {0};

    /* a reading at each scale; the one with the smallest standard deviation is kept */
    for (int k = 0; k < SCALES; k++) {
        filter_window(&w, SCALE[k]);
        fill_cells(&w, grey, grid, block.y, side, patch->place, s);
        const reading r = read_cells(s, of_cell / 2, grey->noise, SCALE[k]);
        if (k == 0) {
            for (int c = 0; c < CELLS * CELLS; c++) patch->covered += fmin(s[c].n / of_cell, 1) / (CELLS * CELLS);
        }
        if (k == 0 || (r.readable && (!best.readable || r.sigma < best.sigma))) best = r;
    }
    window_clear(&w);

    /* the reading, or what was seen of the patch where it is not readable */
    patch->readable = best.readable;
    patch->angle = best.angle;
    patch->sigma = best.sigma;
    patch->coherence = best.coherence;
    patch->contrast = best.contrast;
    return WCUT_OK;
}
