/* Fields over a facade: what drives the heights of edges and the length of the wire. */
#include "facade/field.h"

#include <stddef.h>

#include "base/numbers.h"

enum { POINTS_MAX = 100000, GRID_MAX = 1 << 26 };

/* ---- one kind each ---- */

/* a cubic through four values at -1, 0, 1, 2 whose slopes are central differences (Catmull, Rom 1974) */
static double catmull_rom(const double p[4], double t) {
    return p[1] +
           0.5 * t *
               (p[2] - p[0] + t * (2 * p[0] - 5 * p[1] + 4 * p[2] - p[3] + t * (3 * (p[1] - p[2]) + p[3] - p[0])));
}

/* where a share of a side lies among `count` values: the one before, and the rest of the way */
static int grid_place(double share, int count, double *rest) {
    const double at = clamp(share, 0, 1) * (count - 1);
    int k = (int)at;
    if (k > count - 2) k = count - 2;
    *rest = at - k;
    return k;
}

/* beyond the border a line goes on straight: the cubic there is that of a line */
static double grid_value(const wcut_facade_field *f, int row, int column) {
    const int r = row < 0 ? 0 : row > f->rows - 1 ? f->rows - 1 : row;
    if (column < 0) return 2 * grid_value(f, r, 0) - grid_value(f, r, 1);
    if (column > f->columns - 1) return 2 * grid_value(f, r, f->columns - 1) - grid_value(f, r, f->columns - 2);
    return f->grid[(size_t)r * (size_t)f->columns + (size_t)column];
}

static double grid_eval(const wcut_facade_field *f, const double size[2], double u, double v) {
    /* the cell, and the four columns and rows about it */
    double across, along, row[4];
    const int column = grid_place(u / size[0], f->columns, &across), first = grid_place(v / size[1], f->rows, &along);
    for (int r = 0; r < 4; r++) {
        double p[4];
        for (int c = 0; c < 4; c++) p[c] = grid_value(f, first - 1 + r, column - 1 + c);
        row[r] = catmull_rom(p, across);
    }

    /* rows beyond the border by the same rule as columns */
    if (first == 0) row[0] = 2 * row[1] - row[2];
    if (first == f->rows - 2) row[3] = 2 * row[2] - row[1];
    return catmull_rom(row, along);
}

/* the distance from a line of points, or from one */
static double distance_of_line(const wcut_facade_field *f, double u, double v) {
    double min = hypot(u - f->place[0], v - f->place[1]);
    for (int k = 1; k < f->points; k++) {
        const double *a = f->place + 2 * (size_t)(k - 1), *b = a + 2;
        const double du = b[0] - a[0], dv = b[1] - a[1], length2 = du * du + dv * dv;
        const double t = length2 > 0 ? clamp(((u - a[0]) * du + (v - a[1]) * dv) / length2, 0, 1) : 0;
        min = fmin(min, hypot(u - a[0] - t * du, v - a[1] - t * dv));
    }
    return min;
}

static double field_eval(const wcut_facade_field *f, const double size[2], double u, double v) {
    switch (f->kind) {
        case WCUT_FACADE_FIELD_LINEAR:
            return f->value + f->slope[0] * u + f->slope[1] * v;
        case WCUT_FACADE_FIELD_SINE: {
            const double s = u * cos(f->direction) + v * sin(f->direction);
            return f->value + f->amplitude * sin(2 * WCUT_PI * s / f->period + f->phase);
        }
        case WCUT_FACADE_FIELD_GRID:
            return grid_eval(f, size, u, v);
        case WCUT_FACADE_FIELD_ATTRACTOR: {
            const double d = distance_of_line(f, u, v) / f->radius;
            return f->value + f->amplitude * exp(-d * d);
        }
        case WCUT_FACADE_FIELD_CONSTANT:
        default:
            return f->value;
    }
}

/* ---- for the caller ---- */

bool wcut_facade_field_is_valid(const wcut_facade_field *f) {
    if ((unsigned)f->kind > WCUT_FACADE_FIELD_ATTRACTOR || !isfinite(f->value)) return false;
    switch (f->kind) {
        case WCUT_FACADE_FIELD_LINEAR:
            return all_finite(2, f->slope);
        case WCUT_FACADE_FIELD_SINE:
            return isfinite(f->amplitude) && is_positive(f->period) && isfinite(f->direction) && isfinite(f->phase);

        /* arrays as large as their counts say */
        case WCUT_FACADE_FIELD_GRID:
            return f->rows >= 2 && f->columns >= 2 && f->rows <= GRID_MAX / f->columns && f->grid &&
                   all_finite(f->rows * f->columns, f->grid);
        case WCUT_FACADE_FIELD_ATTRACTOR:
            return isfinite(f->amplitude) && is_positive(f->radius) && f->points >= 1 && f->points <= POINTS_MAX &&
                   f->place && all_finite(2 * f->points, f->place);
        default:
            return true;
    }
}

double wcut_facade_field_sum(int count, const wcut_facade_field *field, const double size[2], double u, double v) {
    double sum = 0;
    for (int k = 0; k < count; k++) sum += field_eval(&field[k], size, u, v);
    return sum;
}

wcut_status wcut_facade_field_eval(int count, const wcut_facade_field *field, const double size[2], double u, double v,
                                   double *value) {
    if (count < 1 || !field || !size || !all_positive(2, size) || !isfinite(u) || !isfinite(v) || !value)
        return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < count; k++)
        if (!wcut_facade_field_is_valid(&field[k])) return WCUT_BAD_ARGUMENT;
    const double sum = wcut_facade_field_sum(count, field, size, u, v);
    if (!isfinite(sum)) return WCUT_BAD_ARGUMENT;
    *value = sum;
    return WCUT_OK;
}
