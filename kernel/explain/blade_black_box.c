/* A mere fit beside the physics of a blade: ridge regression on its motion, with a memory, and no foam. */
#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/dense.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "explain/blade_fit.h"

/* constant; way in the pass and its square; place up; advance, slide and their ratio; number of the pass; and the means of
   advance and ratio over the bins before */
enum { COLUMNS = 10, MEMORY = 8, RIDGES = 6 };
static const double ridge_of[RIDGES] = {1e-3, 1e-2, 0.1, 1, 10, 100};

/* columns of all bins, cut after cut, and what they are scaled by */
typedef struct regression {
    const wcut_blade_case *c;
    double **x; /* cuts arrays of bins x COLUMNS */
    double mean[COLUMNS], deviation[COLUMNS];
    double low, high; /* [scale] of all forces: a regression is not believed beyond them */
} regression;

static void fill_columns(const wcut_blade_cut *cut, double *x) {
    double way = 0;
    for (int b = 0; b < cut->bins; b++, x += COLUMNS) {
        if (b > 0 && cut->pass[b] != cut->pass[b - 1]) way = 0;
        way += cut->way[b];
        const double ratio = fmin(cut->slide[b] / fmax(cut->advance[b], 0.05), 20);
        double advance = 0, slid = 0;
        int n = 0;
        for (int k = b; k >= 0 && b - k < MEMORY && cut->pass[k] == cut->pass[b]; k--, n++)
            advance += cut->advance[k], slid += fmin(cut->slide[k] / fmax(cut->advance[k], 0.05), 20);
        const double row[COLUMNS] = {1,     way,          way * way,   cut->place[b].z, cut->advance[b], cut->slide[b],
                                     ratio, cut->pass[b], advance / n, slid / n};
        memcpy(x, row, sizeof row);
    }
}

static void scale_columns(regression *r) {
    /* sums for the mean in the first pass, for the deviation in the second */
    double n = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < r->c->cuts; k++)
            for (int b = 0; b < r->c->cut[k].bins; b++)
                for (int j = 1; j < COLUMNS; j++) {
                    double *x = &r->x[k][(size_t)b * COLUMNS + (size_t)j];
                    if (pass == 0)
                        r->mean[j] += *x, n += j == 1;
                    else
                        r->deviation[j] += (*x - r->mean[j] / n) * (*x - r->mean[j] / n);
                }

    /* then every column has mean 0 and deviation 1 */
    for (int k = 0; k < r->c->cuts; k++)
        for (int b = 0; b < r->c->cut[k].bins; b++)
            for (int j = 1; j < COLUMNS; j++) {
                double *x = &r->x[k][(size_t)b * COLUMNS + (size_t)j];
                const double deviation = sqrt(r->deviation[j] / n);
                *x = deviation > 0 ? (*x - r->mean[j] / n) / deviation : 0;
            }
}

/* weights learnt from all cuts but two; false where they are not determined */
static bool learn_weights(const regression *r, int but, int and_but, double ridge, double w[COLUMNS]) {
    double a[COLUMNS * COLUMNS] = {0};
    memset(w, 0, sizeof(double) * COLUMNS);
    double weights = 0;

    /* normal equations, every cut with the same weight */
    for (int k = 0; k < r->c->cuts; k++) {
        const wcut_blade_cut *cut = &r->c->cut[k];
        if (k == but || k == and_but || cut->bins == 0) continue;
        weights++;
        for (int b = 0; b < cut->bins; b++) {
            const double *x = &r->x[k][(size_t)b * COLUMNS], y = wcut_blade_transform(r->c, cut->force[b]);
            for (int i = 0; i < COLUMNS; i++) {
                w[i] += x[i] * y / cut->bins;
                for (int j = 0; j <= i; j++) a[i * COLUMNS + j] += x[i] * x[j] / cut->bins;
            }
        }
    }

    /* the ridge shrinks all but the constant */
    for (int i = 1; i < COLUMNS; i++) a[i * COLUMNS + i] += ridge * weights;
    if (weights == 0 || !wcut_cholesky_factor(COLUMNS, a, 0)) return false;
    wcut_cholesky_solve(COLUMNS, a, w);

    return true;
}

static double answer(const regression *r, int k, int b, const double w[COLUMNS]) {
    double z = 0;
    for (int j = 0; j < COLUMNS; j++) z += w[j] * r->x[k][(size_t)b * COLUMNS + (size_t)j];
    return r->c->scale * sinh(clamp(z / r->c->scale, r->low, r->high));
}

/* the ridge that predicts the others best, each of them left out beside the cut in question */
static double choose_blade_ridge(const regression *r, int but) {
    double best = ridge_of[RIDGES - 1], min = HUGE_VAL;
    for (int l = 0; l < RIDGES; l++) {
        double sum = 0, w[COLUMNS];
        bool whole = true;
        for (int k = 0; whole && k < r->c->cuts; k++) {
            const wcut_blade_cut *cut = &r->c->cut[k];
            if (k == but || cut->bins == 0) continue;
            whole = learn_weights(r, but, k, ridge_of[l], w);
            for (int b = 0; whole && b < cut->bins; b++) {
                const double d =
                    wcut_blade_transform(r->c, cut->force[b]) - wcut_blade_transform(r->c, answer(r, k, b, w));
                sum += d * d / cut->bins;
            }
        }
        if (whole && sum < min) min = sum, best = ridge_of[l];
    }
    return best;
}

static void predict_cuts(const regression *r, bool left_out, double **to) {
    double w[COLUMNS] = {0};
    bool known = !left_out && learn_weights(r, -1, -1, choose_blade_ridge(r, -1), w);
    for (int k = 0; k < r->c->cuts; k++) {
        if (left_out) known = learn_weights(r, k, k, choose_blade_ridge(r, k), w);
        for (int b = 0; b < r->c->cut[k].bins; b++) to[k][b] = known ? answer(r, k, b, w) : 0;
    }
}

wcut_status wcut_blade_black_box(const wcut_blade_case *c, double **in_sample, double **held_out) {
    regression r = {.c = c, .x = wcut_alloc((size_t)c->cuts, sizeof *r.x)};
    bool whole = r.x != NULL;
    for (int k = 0; whole && k < c->cuts; k++) {
        r.x[k] = wcut_alloc((size_t)c->cut[k].bins * COLUMNS, sizeof(double));
        whole = r.x[k] != NULL;
        if (whole) fill_columns(&c->cut[k], r.x[k]);
    }

    /* learn on one scale, believe within the forces that were seen */
    if (whole) {
        scale_columns(&r);
        for (int k = 0; k < c->cuts; k++)
            for (int b = 0; b < c->cut[k].bins; b++) {
                const double z = wcut_blade_transform(c, c->cut[k].force[b]) / c->scale;
                r.low = fmin(r.low, z), r.high = fmax(r.high, z);
            }
        predict_cuts(&r, false, in_sample);
        predict_cuts(&r, true, held_out);
    }
    wcut_blade_rows_destroy(c, r.x);
    return whole ? WCUT_OK : WCUT_NO_MEMORY;
}
