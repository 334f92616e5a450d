/* The distance between a surface and the triangles of its grid, measured by dense sampling. */
#include "surface/chord_error.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/grid.h"

enum { CELL_MIN = 4 }; /* steps from sample to sample across a cell, at least */

/* parameters to sample at: the grid lines and those between */
typedef struct samples {
    int count;
    int widest; /* most steps of a cell */
    double *at; /* count */
    int *start; /* cells + 1: where each grid line stands in `at` */
} samples;

static void samples_clear(samples *s) {
    wcut_free(s->at);
    wcut_free(s->start);
}

/* Steps to take between neighbouring breaks of a cell that `inside` knots divide. A bump of odd degree peaks at a knot,
   one of even degree between two. */
static int steps_between(int degree, int inside) {
    const int even = (CELL_MIN + inside) / (inside + 1), min = degree % 2 ? 1 : 2;
    return even > min ? even : min;
}

/* the distinct knots inside (a, b), from knots[*next] on, which is moved along */
static int knots_inside(const double *knots, int last, double a, double b, int *next) {
    int inside = 0;
    while (*next < last && knots[*next] <= a) ++*next;
    for (int k = *next; k < last && knots[k] < b; k++) inside += knots[k] > knots[k - 1] && knots[k] > a;
    return inside;
}

static wcut_status place_samples(int degree, int control_count, const double *knots, const wcut_spacing *lines,
                                 samples *out) {
    samples s = {.count = 1};

    /* how many samples each cell has */
    for (int c = 0, next = degree; c < lines->pieces; c++) {
        const int inside = knots_inside(knots, control_count, lines->at[c], lines->at[c + 1], &next);
        const int steps = (inside + 1) * steps_between(degree, inside);
        s.count += steps;
        if (steps > s.widest) s.widest = steps;
    }

    /* room for the samples, and for the number at which each cell begins */
    s.at = wcut_alloc((size_t)s.count, sizeof *s.at);
    s.start = wcut_alloc((size_t)lines->pieces + 1, sizeof *s.start);
    if (!s.at || !s.start) {
        samples_clear(&s);
        return WCUT_NO_MEMORY;
    }

    /* samples, evenly between the knots inside each cell */
    int made = 0;
    for (int c = 0, next = degree; c < lines->pieces; c++) {
        const double end = lines->at[c + 1];
        const int inside = knots_inside(knots, control_count, lines->at[c], end, &next);
        const int steps = steps_between(degree, inside);
        double from = lines->at[c];
        s.start[c] = made;
        for (int piece = 0, k = next; piece <= inside; piece++) {
            while (k < control_count && knots[k] <= from) k++;
            const double to = piece < inside ? knots[k] : end;
            for (int i = 0; i < steps; i++) s.at[made++] = from + (to - from) * i / steps;
            from = to;
        }
    }
    s.start[lines->pieces] = made;
    s.at[made] = lines->at[lines->pieces];
    *out = s;

    return WCUT_OK;
}

static double segment_distance(wcut_vec3 p, wcut_vec3 a, wcut_vec3 b) {
    const wcut_vec3 edge = vec3_sub(b, a), to = vec3_sub(p, a);
    const double square = vec3_dot(edge, edge);
    const double t = square > 0 ? clamp(vec3_dot(to, edge) / square, 0, 1) : 0;
    return vec3_length(vec3_add_scaled(to, -t, edge));
}

double wcut_triangle_distance(wcut_vec3 p, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c) {
    const wcut_vec3 ab = vec3_sub(b, a), ac = vec3_sub(c, a), ap = vec3_sub(p, a), n = vec3_cross(ab, ac);
    const double square = vec3_dot(n, n);
    if (square > 0) {
        const double s = vec3_dot(vec3_cross(ap, ac), n), t = vec3_dot(vec3_cross(ab, ap), n);
        if (s >= 0 && t >= 0 && s + t <= square) return fabs(vec3_dot(ap, n)) / sqrt(square);
    }
    return fmin(segment_distance(p, a, b), fmin(segment_distance(p, b, c), segment_distance(p, c, a)));
}

/* the samples of one cell: its columns from..to of `rows` rows of points */
typedef struct cell {
    const wcut_vec3 *point;
    ptrdiff_t stride;
    int columns, rows;
    const double *u, *v;
} cell;

/* the largest distance in a cell; those not above `enough` need not be known, and count as 0 */
static double cell_error(const cell *c, double enough) {
    /* corners of the cell; lengths of its sides in parameters */
    const wcut_vec3 p00 = c->point[0], p10 = c->point[c->columns];
    const wcut_vec3 p01 = c->point[c->rows * c->stride], p11 = c->point[c->rows * c->stride + c->columns];
    const double scale_u = 1 / (c->u[c->columns] - c->u[0]), scale_v = 1 / (c->v[c->rows] - c->v[0]);
    double max = 0, bar = enough * enough;
    for (int j = 0; j <= c->rows; j++) {
        /* on p00 p10 p11 where s >= t, else on p00 p11 p01, the linear point is p00 + s side + t other side */
        const double t = (c->v[j] - c->v[0]) * scale_v;
        const wcut_vec3 side[2] = {vec3_sub(p10, p00), vec3_sub(p11, p01)};
        const wcut_vec3 start[2] = {vec3_add_scaled(p00, t, vec3_sub(p11, p10)),
                                    vec3_add_scaled(p00, t, vec3_sub(p01, p00))};

        /* samples: far from the linear point only where the distance may exceed the largest so far */
        const wcut_vec3 *row = c->point + j * c->stride;
        for (int i = 0; i <= c->columns; i++) {
            const double s = (c->u[i] - c->u[0]) * scale_u;
            const int upper = s < t;
            const wcut_vec3 off = vec3_sub(row[i], vec3_add_scaled(start[upper], s, side[upper]));
            if (vec3_dot(off, off) <= bar) continue;
            max = fmax(max, wcut_triangle_distance(row[i], p00, upper ? p01 : p10, p11));
            bar = fmax(bar, max * max);
        }
    }

    return max;
}

/* one row of cells; `point` holds its rows of samples */
static void row_error(const samples *su, const samples *sv, int j, const wcut_vec3 *point, double held, int cells,
                      double *error_u, double *error_v, double *max) {
    for (int i = 0; i < cells; i++) {
        const cell c = {.point = point + su->start[i],
                        .stride = su->count,
                        .columns = su->start[i + 1] - su->start[i],
                        .rows = sv->start[j + 1] - sv->start[j],
                        .u = su->at + su->start[i],
                        .v = sv->at + sv->start[j]};
        /* below `held` only the largest of all is of interest, above it each row's and column's own */
        const double error = cell_error(&c, fmax(fmin(*max, held), fmin(error_u[i], error_v[j])));
        error_u[i] = fmax(error_u[i], error);
        error_v[j] = fmax(error_v[j], error);
        *max = fmax(*max, error);
    }
}

wcut_status wcut_chord_error(const wcut_surface *s, const wcut_spacing *lines_u, const wcut_spacing *lines_v,
                             double held, double *error_u, double *error_v, double *max) {
    samples su = {.count = 0}, sv = {.count = 0};
    wcut_axis u = {.count = 0}, v = {.count = 0};
    wcut_homogeneous *fold = NULL;
    wcut_vec3 *point = NULL;

    /* samples along both directions, and basis functions there */
    wcut_status status = place_samples(s->degree_u, s->count_u, s->knots_u, lines_u, &su);
    if (status == WCUT_OK) status = place_samples(s->degree_v, s->count_v, s->knots_v, lines_v, &sv);
    if (status == WCUT_OK) status = wcut_axis_fill(s->degree_u, s->count_u, s->knots_u, su.count, su.at, 0, &u);
    if (status == WCUT_OK) status = wcut_axis_fill(s->degree_v, s->count_v, s->knots_v, sv.count, sv.at, 0, &v);
    if (status != WCUT_OK) goto done;

    /* one strip of cells at a time */
    fold = wcut_alloc((size_t)s->count_u, sizeof *fold);
    point = wcut_alloc((size_t)su.count, ((size_t)sv.widest + 1) * sizeof *point);
    if (!fold || !point) {
        status = WCUT_NO_MEMORY;
        goto done;
    }

    /* rows of the strip; the last one is the first of the next */
    *max = 0;
    for (int i = 0; i < lines_u->pieces; i++) error_u[i] = 0;
    for (int j = 0; j < lines_v->pieces; j++) {
        const int rows = sv.start[j + 1] - sv.start[j];
        error_v[j] = 0;
        for (int k = j > 0; k <= rows; k++) /* the first row is the last of the cells before */
            wcut_grid_row(s, &u, &v, sv.start[j] + k, fold, point + (ptrdiff_t)k * su.count);
        row_error(&su, &sv, j, point, held, lines_u->pieces, error_u, error_v, max);
        memcpy(point, point + (ptrdiff_t)rows * su.count, (size_t)su.count * sizeof *point);
    }

done:
    wcut_free(point);
    wcut_free(fold);
    wcut_axis_clear(&v);
    wcut_axis_clear(&u);
    samples_clear(&sv);
    samples_clear(&su);

    return status;
}
