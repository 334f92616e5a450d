/* Within which radius of a span's query a stationary foot in it is the closest point of the whole surface.

   Let f be stationary in a block c of spans, at the distance d from the query p, and N the block and its neighbours.
   Outside N the surface is at least D from c, so further than D - d from p: no closer than f where d < D / 2. Over N,
   with parameters scaled to lengths, |S - p|^2 / 2 has the Hessian  S_i . S_j + (S - p) . S_ij >= sigma^2 - |S - p| K,
   sigma the least singular value of (S_u, S_v) and K a bound on the second derivatives; |S - p| <= d + rho, rho how far
   N reaches from c. Where  d < sigma^2 / K - rho  that is convex, and f the closest of N, on the surface's border too:
   there stationary means that no way along the surface leads closer. The smaller of the two is the block's radius, and
   a span's the largest of the blocks of 2^level spans a side that hold it. */
#include <string.h>

#include "base/alloc.h"
#include "base/vec3.h"
#include "surface/newton_spans.h"

enum { LEVELS = 20 };

/* blocks of 2^level spans a side */
typedef struct pyramid {
    int levels, columns[LEVELS], rows[LEVELS];
    wcut_span_bounds *block[LEVELS]; /* [0]: the spans' own */
    wcut_newton_foot *newton;
} pyramid;

/* blocks c0 .. c1, rows r0 .. r1 of a level, both ends within */
typedef struct range {
    int c0, c1, r0, r1;
} range;

static inline double newton_proof_larger(double a, double b) { return a > b ? a : b; }
static inline double smaller(double a, double b) { return a < b ? a : b; }

static void newton_proof_enclose(wcut_span_bounds *all, const wcut_span_bounds *one) {
    all->low = vec3(smaller(all->low.x, one->low.x), smaller(all->low.y, one->low.y), smaller(all->low.z, one->low.z));
    all->high = vec3(newton_proof_larger(all->high.x, one->high.x), newton_proof_larger(all->high.y, one->high.y),
                     newton_proof_larger(all->high.z, one->high.z));
    all->sigma = smaller(all->sigma, one->sigma);
    all->bend = newton_proof_larger(all->bend, one->bend);
}

static const wcut_span_bounds nothing = {
    {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, INFINITY, 0};

/* the levels above the spans; false without memory */
static bool build_pyramid(pyramid *p) {
    for (int l = 0; p->columns[l] > 1 || p->rows[l] > 1; l++) {
        const int columns = (p->columns[l] + 1) / 2, rows = (p->rows[l] + 1) / 2;
        wcut_span_bounds *to = wcut_alloc((size_t)columns * (size_t)rows, sizeof *to);
        if (!to) return false;
        for (int k = 0; k < columns * rows; k++) to[k] = nothing;
        for (int r = 0; r < p->rows[l]; r++)
            for (int c = 0; c < p->columns[l]; c++)
                newton_proof_enclose(&to[r / 2 * columns + c / 2], &p->block[l][r * p->columns[l] + c]);
        p->block[l + 1] = to, p->columns[l + 1] = columns, p->rows[l + 1] = rows;
        p->levels = l + 2;
    }
    return true;
}

static const wcut_span_bounds *block_at(const pyramid *p, int level, int column, int row) {
    return &p->block[level][row * p->columns[level] + column];
}

/* ---- distances between boxes ---- */

static double newton_proof_gap_of(double low, double high, double other_low, double other_high) {
    return newton_proof_larger(newton_proof_larger(other_low - high, low - other_high), 0);
}

static double box_distance(const wcut_span_bounds *a, const wcut_span_bounds *b) {
    return vec3_length(vec3(newton_proof_gap_of(a->low.x, a->high.x, b->low.x, b->high.x),
                            newton_proof_gap_of(a->low.y, a->high.y, b->low.y, b->high.y),
                            newton_proof_gap_of(a->low.z, a->high.z, b->low.z, b->high.z)));
}

/* between their furthest points */
static double box_reach(const wcut_span_bounds *a, const wcut_span_bounds *b) {
    return vec3_length(vec3(newton_proof_larger(b->high.x - a->low.x, a->high.x - b->low.x),
                            newton_proof_larger(b->high.y - a->low.y, a->high.y - b->low.y),
                            newton_proof_larger(b->high.z - a->low.z, a->high.z - b->low.z)));
}

static range neighbours(const pyramid *p, int level, int column, int row) {
    return (range){column > 0 ? column - 1 : 0, column + 1 < p->columns[level] ? column + 1 : column,
                   row > 0 ? row - 1 : 0, row + 1 < p->rows[level] ? row + 1 : row};
}

/* the nearest of the four blocks just beyond the neighbours: no proof, but a limit for one, and it saves most of the
   tree; infinite where there are none */
static double newton_proof_beside(const pyramid *p, int level, int column, int row) {
    const int at[4][2] = {{column - 2, row}, {column + 2, row}, {column, row - 2}, {column, row + 2}};
    double best = INFINITY;
    for (int k = 0; k < 4; k++)
        if (at[k][0] >= 0 && at[k][0] < p->columns[level] && at[k][1] >= 0 && at[k][1] < p->rows[level])
            best = smaller(best, box_distance(block_at(p, level, column, row), block_at(p, level, at[k][0], at[k][1])));
    return best;
}

/* No span outside a range is closer to a block than this; more than `enough` is as good as any. */
static double outer_distance(const pyramid *p, int level, range of, const wcut_span_bounds *from, double enough) {
    struct {
        int level, column, row;
    } stack[4 * LEVELS];

    /* depth first from the top of the pyramid */
    int depth = 1;
    stack[0].level = p->levels - 1, stack[0].column = stack[0].row = 0;
    double best = enough;
    while (depth > 0) {
        depth--;
        const int l = stack[depth].level, c = stack[depth].column, r = stack[depth].row;

        /* blocks inside the range are not outside it */
        if (l == level && c >= of.c0 && c <= of.c1 && r >= of.r0 && r <= of.r1) continue;

        /* a block farther than the best cannot improve it */
        const double away = box_distance(from, block_at(p, l, c, r));
        if (away >= best) continue;
        if (l == 0) {
            best = away;
            continue;
        }

        for (int i = 0; i < 4; i++) {
            const int column = 2 * c + i % 2, row = 2 * r + i / 2;
            if (column >= p->columns[l - 1] || row >= p->rows[l - 1]) continue;
            stack[depth].level = l - 1, stack[depth].column = column, stack[depth].row = row;
            depth++;
        }
    }

    return best;
}

/* ---- radii ---- */

/* what a block and its neighbours prove */
static double radius_of(const pyramid *p, int level, int column, int row) {
    const wcut_span_bounds *c = block_at(p, level, column, row);
    const range of = neighbours(p, level, column, row);
    wcut_span_bounds all = nothing;
    for (int r = of.r0; r <= of.r1; r++)
        for (int k = of.c0; k <= of.c1; k++) newton_proof_enclose(&all, block_at(p, level, k, r));
    if (!(all.sigma > 0)) return -1;
    const double convex = all.bend > 0 ? all.sigma * all.sigma / all.bend - box_reach(c, &all) : INFINITY;
    if (!(convex > 0)) return -1;
    const double guess = smaller(newton_proof_beside(p, level, column, row), 2 * convex);
    return smaller(convex, outer_distance(p, level, of, c, guess) / 2);
}

static void newton_proof_settle(const pyramid *p, int level, int column, int row, double radius) {
    wcut_newton_foot *q = p->newton;
    const int side = 1 << level, left = column * side, top = row * side;
    for (int r = top; r < top + side && r < q->rows; r++)
        for (int c = left; c < left + side && c < q->columns; c++) q->span[r * q->columns + c].radius = radius;
}

/* can a smaller block prove more than this? */
static bool may_improve(const pyramid *p, int level, int column, int row, double radius) {
    return newton_proof_beside(p, level, column, row) / 2 > radius;
}

/* `radius` is what larger blocks have proven */
static void newton_proof_refine(const pyramid *p, int level, int column, int row, double radius) {
    radius = newton_proof_larger(radius, radius_of(p, level, column, row));
    bool further = false;
    const int below = level - 1;
    for (int i = 0; i < 4 && level > 0; i++) {
        const int c = 2 * column + i % 2, r = 2 * row + i / 2;
        if (c < p->columns[below] && r < p->rows[below]) further |= may_improve(p, below, c, r, radius);
    }
    if (!further) {
        newton_proof_settle(p, level, column, row,
                            radius - 1e5 * p->newton->tolerance); /* rounding, a last step out of the span */
        return;
    }
    for (int i = 0; i < 4; i++) {
        const int c = 2 * column + i % 2, r = 2 * row + i / 2;
        if (c < p->columns[below] && r < p->rows[below]) newton_proof_refine(p, below, c, r, radius);
    }
}

wcut_status wcut_newton_foot_prove(wcut_newton_foot *newton, wcut_span_bounds *bounds) {
    pyramid p = {.levels = 1, .columns = {newton->columns}, .rows = {newton->rows}, .newton = newton};
    p.block[0] = bounds;
    const bool there = build_pyramid(&p);
    if (there) newton_proof_refine(&p, p.levels - 1, 0, 0, -1);
    for (int l = 1; l < LEVELS; l++) wcut_free(p.block[l]);
    return there ? WCUT_OK : WCUT_NO_MEMORY;
}
