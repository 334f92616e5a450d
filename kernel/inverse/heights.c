/* A smooth height z(x, y) through scattered points: penalised least squares on a uniform bicubic B-spline. */
#include "inverse/heights.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

#define STIFFNESS 1e-4 /* [1] of the plate, over the points' weight in a cell */
#define BEND 0.1       /* [1] of the rectangle: so far beyond it the height keeps its curvature */
#define LEVELS 3       /* cells across: COARSEST, twice, four times as many */
#define COARSEST 6
#define WORTH 0.8 /* [1] smaller cells are worth it where the scatter falls below this share */
#define ROUNDS 6  /* of reweighting */

/* values, slopes and second derivatives of the four cubic B-splines of a cell, at t in 0 .. 1 */
static void spline_basis(double t, double b[3][4]) {
    const double s = 1 - t;
    b[0][0] = s * s * s / 6, b[0][3] = t * t * t / 6;
    b[0][1] = (3 * t * t * t - 6 * t * t + 4) / 6, b[0][2] = (3 * s * s * s - 6 * s * s + 4) / 6;
    b[1][0] = -s * s / 2, b[1][3] = t * t / 2;
    b[1][1] = (3 * t * t - 4 * t) / 2, b[1][2] = -(3 * s * s - 4 * s) / 2;
    b[2][0] = s, b[2][1] = 3 * t - 2, b[2][2] = 3 * s - 2, b[2][3] = t;
}

/* the cell of a coordinate and where in it */
static int spline_cell_of(double x, double low, double step, int cells, double *t) {
    const double u = (x - low) / step;
    const int i = (int)clamp(floor(u), 0, cells - 1);
    *t = u - i;
    return i;
}

/* The basis at a coordinate, with derivatives by it. Beyond the rectangle the spline goes on with its second derivative as
   it is at the border, over BEND of the rectangle's size, then straight. Gives the first coefficient. */
static int spline_basis_at(double x, double low, double high, double step, int cells, double b[3][4]) {
    const double at = clamp(x, low, high), reach = BEND * (high - low);
    double t;
    const int first = spline_cell_of(at, low, step, cells, &t);
    spline_basis(t, b);
    const double off = x - at, bent = clamp(off, -reach, reach);
    for (int k = 0; k < 4; k++) {
        const double slope = b[1][k] / step, second = b[2][k] / (step * step);
        b[0][k] += slope * off + second * bent * (off - bent / 2);
        b[1][k] = slope + second * bent;
        b[2][k] = off == bent ? second : 0;
    }
    return first;
}

wcut_height wcut_heights_eval(const wcut_heights *h, double x, double y) {
    double bx[3][4], by[3][4], d[3][3] = {{0}};
    const int i = spline_basis_at(x, h->low.x, h->high.x, h->step_x, h->cells_x, bx);
    const int j = spline_basis_at(y, h->low.y, h->high.y, h->step_y, h->cells_y, by);
    const double *c = h->coefficient + (size_t)j * (size_t)(h->cells_x + 3) + i;
    for (int l = 0; l < 4; l++, c += h->cells_x + 3)
        for (int p = 0; p < 3; p++) {
            const double along = bx[p][0] * c[0] + bx[p][1] * c[1] + bx[p][2] * c[2] + bx[p][3] * c[3];
            for (int q = 0; p + q < 3; q++) d[p][q] += along * by[q][l];
        }
    return (wcut_height){d[0][0], d[1][0], d[0][1], d[2][0], d[1][1], d[0][2]};
}

/* ---- the fit ---- */

typedef struct normal { /* equations of one level: lower band, row by row */
    int n, band;
    double *entry; /* n x (band + 1): entry [r][band - (r - c)] is (r, c) */
    double *right; /* n */
} normal;

static void add_normal_entry(normal *m, int r, int c, double value) {
    if (c > r) return;
    m->entry[(size_t)r * (size_t)(m->band + 1) + (size_t)(m->band - (r - c))] += value;
}

/* weight (sum of coefficients)^2, coefficients at steps from `at` */
static void add_square(normal *m, int at, int count, const int *offset, const double *factor, double weight) {
    for (int p = 0; p < count; p++)
        for (int q = 0; q < count; q++)
            add_normal_entry(m, at + offset[p], at + offset[q], weight * factor[p] * factor[q]);
}

/* bending of the plate from second differences of the coefficients */
static void add_plate(normal *m, const wcut_heights *h, double weight) {
    const int nx = h->cells_x + 3, ny = h->cells_y + 3;
    const double second[3] = {1, -2, 1}, mixed[4] = {1, -1, -1, 1};
    const int along_x[3] = {0, 1, 2}, along_y[3] = {0, nx, 2 * nx}, both[4] = {0, 1, nx, nx + 1};
    const double ratio = h->step_x / h->step_y;
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++) {
            const int at = j * nx + i;
            if (i + 2 < nx) add_square(m, at, 3, along_x, second, weight);
            if (j + 2 < ny) add_square(m, at, 3, along_y, second, weight * ratio * ratio * ratio * ratio);
            if (i + 1 < nx && j + 1 < ny) add_square(m, at, 4, both, mixed, 2 * weight * ratio * ratio);
        }
}

static void add_height_point(normal *m, const wcut_heights *h, wcut_vec3 p, double weight) {
    double bx[3][4], by[3][4], t, value[16];
    const int nx = h->cells_x + 3;
    const int i = spline_cell_of(p.x, h->low.x, h->step_x, h->cells_x, &t);
    spline_basis(t, bx);
    const int j = spline_cell_of(p.y, h->low.y, h->step_y, h->cells_y, &t);
    spline_basis(t, by);
    int index[16];
    for (int k = 0; k < 16; k++) {
        index[k] = (j + k / 4) * nx + i + k % 4;
        value[k] = bx[0][k % 4] * by[0][k / 4];
        m->right[index[k]] += weight * value[k] * p.z;
    }
    for (int k = 0; k < 16; k++)
        for (int l = 0; l <= k; l++) add_normal_entry(m, index[k], index[l], weight * value[k] * value[l]);
}

/* Cholesky's factor of the band and the solution in the place of the right side; false where it is singular */
static bool solve_normal(normal *m) {
    const size_t width = (size_t)m->band + 1;
    for (int r = 0; r < m->n; r++) {
        double *row = m->entry + (size_t)r * width;
        const int first = r > m->band ? r - m->band : 0;
        for (int c = first; c <= r; c++) {
            const double *other = m->entry + (size_t)c * width;
            const int from = c > m->band ? c - m->band : 0;
            double sum = row[m->band - (r - c)];
            for (int k = from > first ? from : first; k < c; k++)
                sum -= row[m->band - (r - k)] * other[m->band - (c - k)];
            if (c == r && !(sum > 0)) return false;
            row[m->band - (r - c)] = c == r ? sqrt(sum) : sum / other[m->band];
        }
    }

    /* forward, then backward */
    for (int r = 0; r < m->n; r++) {
        const double *row = m->entry + (size_t)r * width;
        for (int k = r > m->band ? r - m->band : 0; k < r; k++) m->right[r] -= row[m->band - (r - k)] * m->right[k];
        m->right[r] /= row[m->band];
    }
    for (int r = m->n - 1; r >= 0; r--) {
        const double *row = m->entry + (size_t)r * width;
        m->right[r] /= row[m->band];
        for (int k = r > m->band ? r - m->band : 0; k < r; k++) m->right[k] -= row[m->band - (r - k)] * m->right[r];
    }
    return true;
}

static int compare_heights(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* 1.4826 times the median size of z - h; room: count */
static double scatter_of(const wcut_heights *h, int count, const wcut_vec3 *point, double *room) {
    for (int k = 0; k < count; k++) room[k] = fabs(point[k].z - wcut_heights_eval(h, point[k].x, point[k].y).z);
    qsort(room, (size_t)count, sizeof *room, compare_heights);
    return 1.4826 * room[count / 2];
}

/* Tukey's biweight at 4.685 times the scatter */
static double biweight_of(double distance, double scatter) {
    const double u = distance / (4.685 * fmax(scatter, 1e-9));
    return fabs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
}

/* one level: fitted anew, with the weights that the heights before it give, or all 1 where there are none */
static wcut_status fit_level(int count, const wcut_vec3 *point, const wcut_heights *before, double *room,
                             wcut_heights *h) {
    const int nx = h->cells_x + 3, ny = h->cells_y + 3, n = nx * ny;
    normal m = {.n = n, .band = 3 * nx + 3};
    m.entry = wcut_alloc((size_t)n * (size_t)(m.band + 1), sizeof *m.entry);
    m.right = wcut_alloc((size_t)n, sizeof *m.right);
    wcut_status status = m.entry && m.right ? WCUT_OK : WCUT_NO_MEMORY;

    /* the points by their weights, and the plate */
    if (status == WCUT_OK) {
        for (int k = 0; k < count; k++) {
            const wcut_vec3 p = point[k];
            add_height_point(&m, h, p,
                             before ? biweight_of(p.z - wcut_heights_eval(before, p.x, p.y).z, before->scatter) : 1);
        }
        add_plate(&m, h, STIFFNESS * count / n);
        if (!solve_normal(&m)) status = WCUT_DEGENERATE;
    }
    wcut_free(m.entry);
    if (status == WCUT_OK) {
        wcut_free(h->coefficient);
        h->coefficient = m.right;
        h->scatter = scatter_of(h, count, point, room);
    } else {
        wcut_free(m.right);
    }
    return status;
}

static wcut_heights heights_level(wcut_vec3 low, wcut_vec3 high, int across) {
    wcut_heights h = {.low = low, .high = high, .cells_x = across};
    h.cells_y = (int)clamp(ceil(across * (high.y - low.y) / (high.x - low.x)), 2, 20.0 * across);
    h.step_x = (high.x - low.x) / h.cells_x;
    h.step_y = (high.y - low.y) / h.cells_y;
    return h;
}

wcut_status wcut_heights_fit(int count, const wcut_vec3 *point, wcut_vec3 low, wcut_vec3 high, bool robust,
                             wcut_heights *out) {
    double *room = wcut_alloc((size_t)count, sizeof *room);
    wcut_heights best = {0};
    wcut_status status = room ? WCUT_OK : WCUT_NO_MEMORY;
    for (int l = 0, across = COARSEST; status == WCUT_OK && l < LEVELS; l++, across *= 2) {
        wcut_heights next = heights_level(low, high, across);
        status = fit_level(count, point, NULL, room, &next);
        for (int k = 0; status == WCUT_OK && robust && k < ROUNDS; k++) {
            wcut_heights again = heights_level(low, high, across);
            status = fit_level(count, point, &next, room, &again);
            if (status != WCUT_OK) break;
            wcut_heights_clear(&next);
            next = again;
        }

        /* no more cells than the points ask for */
        const bool worth = !best.coefficient || next.scatter < WORTH * best.scatter;
        if (status == WCUT_OK && worth) {
            wcut_heights_clear(&best);
            best = next;
        } else {
            wcut_heights_clear(&next);
            break;
        }
        if (best.scatter < 1e-9 * vec3_distance(low, high)) break;
    }
    wcut_free(room);
    if (status == WCUT_OK)
        *out = best;
    else
        wcut_heights_clear(&best);
    return status;
}

void wcut_heights_clear(wcut_heights *h) {
    wcut_free(h->coefficient);
    *h = (wcut_heights){0};
}
