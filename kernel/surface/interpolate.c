/* Parameters and knots for interpolation, and the sweeps that turn points into control points. */
#include "surface/interpolate.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include "base/alloc.h"
#include "surface/collocation.h"

enum { BLOCK = 8 }; /* curves that are swept together: 24 doubles a row, a few cache lines */

wcut_status wcut_parameters_from_lengths(int count, const double *length, double *parameter) {
    double total = 0;
    for (int i = 0; i < count - 1; i++) total += length[i];
    if (!(total > 0) || total * 0 != 0) return WCUT_DEGENERATE;
    double sum = 0;
    parameter[0] = 0;
    for (int i = 1; i < count; i++) {
        sum += length[i - 1];
        parameter[i] = i < count - 1 ? sum / total : 1;
        if (!(parameter[i] > parameter[i - 1])) return WCUT_DEGENERATE;
    }
    return WCUT_OK;
}

void wcut_knots_average(int degree, int count, const double *parameter, double *knots) {
    for (int i = 0; i <= degree; i++) {
        knots[i] = parameter[0];
        knots[count + i] = parameter[count - 1];
    }
    for (int i = 1; i < count - degree; i++) {
        double sum = 0;
        for (int k = 0; k < degree; k++) sum += parameter[i + k];
        knots[i + degree] = sum / degree;
    }
}

/* move `rows` curves of `count` points into count x rows points, or back */
static void interpolate_turn(int rows, int count, wcut_vec3 *curve, wcut_vec3 *turned, bool back) {
    for (int r = 0; r < rows; r++)
        for (int i = 0; i < count; i++) {
            wcut_vec3 *a = &curve[(ptrdiff_t)r * count + i], *b = &turned[(ptrdiff_t)i * rows + r];
            if (back) {
                *a = *b;
            } else {
                *b = *a;
            }
        }
}

wcut_status wcut_interpolate_rows(int degree, int count, const double *knots, const double *parameter, int rows,
                                  wcut_vec3 *point) {
    /* factor once for all rows */
    wcut_collocation system;
    wcut_status status = wcut_collocation_factor(degree, count, knots, parameter, 0, &system);
    if (status != WCUT_OK) return status;
    wcut_vec3 *block = wcut_alloc((size_t)count, BLOCK * sizeof *block);
    if (block) {
        /* in each curve the next value waits for the one before: eight side by side keep the processor busy */
        for (int r = 0; r < rows; r += BLOCK) {
            const int together = rows - r < BLOCK ? rows - r : BLOCK;
            wcut_vec3 *curve = point + (ptrdiff_t)r * count;
            interpolate_turn(together, count, curve, block, false);
            wcut_collocation_solve(&system, 3 * together, &block->x);
            interpolate_turn(together, count, curve, block, true);
        }
    } else {
        status = WCUT_NO_MEMORY;
    }

    wcut_free(block);
    wcut_free(system.entry);
    return status;
}

wcut_status wcut_interpolate_columns(int degree, int count, const double *knots, const double *parameter, int columns,
                                     wcut_vec3 *point) {
    wcut_collocation system;
    const wcut_status status = wcut_collocation_factor(degree, count, knots, parameter, 0, &system);
    if (status != WCUT_OK) return status;
    wcut_collocation_solve(&system, 3 * columns, &point->x);
    wcut_free(system.entry);
    return WCUT_OK;
}
