/* Cells on a plane, around a cylinder and on a surface; blocks turned in them by quarters and turned over. */
#include "facade/lattice.h"

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* ---- a block in its cell ---- */

void wcut_cell_share(int turn, bool mirrored, double i, double j, double share[2]) {
    if (mirrored) i = 1 - i;
    share[0] = turn == 0 ? i : turn == 1 ? 1 - j : turn == 2 ? 1 - i : j;
    share[1] = turn == 0 ? j : turn == 1 ? i : turn == 2 ? 1 - j : 1 - i;
}

int wcut_cell_side(int turn, bool mirrored, int border, bool *reversed) {
    /* both ends of the border, in shares of the cell */
    double from[2], to[2];
    const double low = border % 2;
    wcut_cell_share(turn, mirrored, border < 2 ? low : 0, border < 2 ? 0 : low, from);
    wcut_cell_share(turn, mirrored, border < 2 ? low : 1, border < 2 ? 1 : low, to);

    /* the share that both have in common is the side */
    const int along = from[0] == to[0] ? 1 : 0;
    *reversed = to[along] < from[along];
    return (along ? 0 : 2) + (from[1 - along] > 0.5);
}

wcut_cell wcut_cell_turn(const wcut_cell *cell, wcut_vec3 block, int turn, bool mirrored) {
    /* the cell's own size is that of the turned block */
    wcut_cell c = *cell;
    const double wide = turn % 2 ? block.y : block.x, deep = turn % 2 ? block.x : block.y;
    const wcut_vec3 far_x = vec3_add_scaled(c.origin, wide, c.x), far_y = vec3_add_scaled(c.origin, deep, c.y);
    switch (turn) {
        case 1:
            c = (wcut_cell){far_x, cell->y, vec3_scale(-1, cell->x), cell->z};
            break;
        case 2:
            c = (wcut_cell){vec3_add_scaled(far_x, deep, cell->y), vec3_scale(-1, cell->x), vec3_scale(-1, cell->y),
                            cell->z};
            break;
        case 3:
            c = (wcut_cell){far_y, vec3_scale(-1, cell->y), cell->x, cell->z};
            break;
        default:
            break;
    }
    if (!mirrored) return c;

    /* half a turn about the block's feed axis */
    c.origin = vec3_add_scaled(vec3_add_scaled(c.origin, block.x, c.x), block.z, c.z);
    c.x = vec3_scale(-1, c.x);
    c.z = vec3_scale(-1, c.z);
    return c;
}

/* ---- plane and cylinder ---- */

static void fill_plane(const wcut_facade_plan *p, wcut_vec3 size, wcut_cell *cell) {
    for (int r = 0; r < p->rows; r++)
        for (int c = 0; c < p->columns; c++)
            *cell++ = (wcut_cell){vec3(c * (size.x + p->joint), r * (size.y + p->joint), 0), vec3(1, 0, 0),
                                  vec3(0, 1, 0), vec3(0, 0, 1)};
}

/* The base of a block is a chord of the cylinder, or its top where faces look inside: neighbours meet there and open
   towards the other side. The middle of all columns looks along +z, or along -z from inside. */
static wcut_status fill_cylinder(const wcut_facade_plan *p, wcut_vec3 size, wcut_cell *cell, wcut_error *error) {
    const double radius = fabs(p->radius), side = p->radius < 0 ? -1 : 1;
    if (!(radius > size.x / 2) || !(radius > p->joint / 2))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "lattice: found a radius of %.6g mm, expected more than half the block's width of %.6g mm",
                         p->radius, size.x);

    /* the angle of a block and of a joint, both as chords */
    const double block = 2 * asin(size.x / 2 / radius), gap = 2 * asin(p->joint / 2 / radius);
    const double whole = p->columns * block + (p->columns - 1) * gap;
    if (whole + gap > 2 * WCUT_PI * (1 + 1e-12))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "lattice: found %d columns around %.4g deg, expected no more than 360 deg: two elements would "
                         "claim one place",
                         p->columns, (whole + gap) * 180 / WCUT_PI);

    /* the frame on the chord */
    const double foot = radius * cos(block / 2) + (side < 0 ? size.z : 0);
    for (int r = 0; r < p->rows; r++)
        for (int c = 0; c < p->columns; c++) {
            const double middle = side * (c * (block + gap) + (block - whole) / 2);
            const wcut_vec3 out = vec3(sin(middle), 0, cos(middle));
            const wcut_vec3 x = vec3(side * cos(middle), 0, -side * sin(middle));
            wcut_vec3 origin = vec3_add_scaled(vec3_scale(foot, out), -size.x / 2, x);
            origin.y = r * (size.y + p->joint);
            *cell++ = (wcut_cell){origin, x, vec3(0, 1, 0), vec3_scale(side, out)};
        }
    return WCUT_OK;
}

/* ---- surface ---- */

/* parameters at even arc lengths along the middle of a surface, borders of `cells` cells */
static wcut_status even_parameters(const wcut_surface *s, int cells, bool along_v, double *parameter) {
    enum { STEPS = 2000 };
    double first[2], last[2];
    wcut_surface_domain(s, first, last);
    const int k = along_v ? 1 : 0;
    const double middle = (first[1 - k] + last[1 - k]) / 2, wide = last[k] - first[k];

    /* lengths of a fine polyline */
    double *length = wcut_alloc(STEPS + 1, sizeof *length);
    if (!length) return WCUT_NO_MEMORY;
    wcut_vec3 before = {0, 0, 0}, at;
    for (int i = 0; i <= STEPS; i++) {
        const double t = first[k] + wide * i / STEPS;
        const wcut_status status = wcut_surface_eval(s, along_v ? middle : t, along_v ? t : middle, 0, &at);
        if (status != WCUT_OK) {
            wcut_free(length);
            return status;
        }
        length[i] = i > 0 ? length[i - 1] + vec3_distance(before, at) : 0;
        before = at;
    }

    /* the places between them, linearly */
    int i = 1;
    for (int c = 0; c <= cells; c++) {
        const double asked = length[STEPS] * c / cells;
        while (i < STEPS && length[i] < asked) i++;
        const double step = length[i] - length[i - 1], rest = step > 0 ? (asked - length[i - 1]) / step : 0;
        parameter[c] = first[k] + wide * (i - 1 + clamp(rest, 0, 1)) / STEPS;
    }
    wcut_free(length);
    return WCUT_OK;
}

/* the frame between four corners of a cell; WCUT_DEGENERATE where the block does not fit or the cell is folded */
static wcut_status place_on_corners(const wcut_facade_plan *p, wcut_vec3 size, int row, int column,
                                    const wcut_vec3 corner[4], wcut_cell *cell, wcut_error *error) {
    const wcut_vec3 *q = corner;
    const wcut_vec3 across = vec3_sub(vec3_add(q[1], q[2]), vec3_add(q[0], q[3]));
    const wcut_vec3 along = vec3_sub(vec3_add(q[2], q[3]), vec3_add(q[0], q[1]));
    const wcut_vec3 z = vec3_unit(vec3_cross(across, along)),
                    middle = vec3_scale(0.25, vec3_add(vec3_add(q[0], q[1]), vec3_add(q[2], q[3])));

    /* every corner turns the same way, or the cell is folded */
    for (int k = 0; k < 4; k++) {
        const wcut_vec3 turn = vec3_cross(vec3_sub(q[(k + 1) % 4], q[k]), vec3_sub(q[(k + 3) % 4], q[k]));
        if (!(vec3_dot(turn, z) > 0))
            return wcut_fail(error, WCUT_DEGENERATE,
                             "lattice: the surface folds in row %d, column %d, near (%.6g, %.6g, %.6g) mm; expected "
                             "cells that turn one way",
                             row, column, q[k].x, q[k].y, q[k].z);
    }

    /* the block and half a joint about it fit between the middles of the sides */
    const double wide = vec3_length(across) / 2, deep = vec3_length(along) / 2, slack = 1e-9 * (size.x + size.y);
    if (wide < size.x + p->joint - slack || deep < size.y + p->joint - slack)
        return wcut_fail(
            error, WCUT_DEGENERATE,
            "lattice: the cell in row %d, column %d is %.6g x %.6g mm, expected at least a block of %.6g x "
            "%.6g mm and a joint of %.6g mm: neighbours would claim one place",
            row, column, wide, deep, size.x, size.y, p->joint);

    /* axes with equal angles to the diagonals of the cell's sides */
    const wcut_vec3 u = vec3_unit(across), v = vec3_unit(vec3_cross(z, u));
    const wcut_vec3 lean = vec3_unit(vec3_add(v, vec3_unit(along))), y = vec3_unit(lean), x = vec3_cross(y, z);
    cell->x = x;
    cell->y = y;
    cell->z = z;
    cell->origin = vec3_add_scaled(vec3_add_scaled(middle, -size.x / 2, x), -size.y / 2, y);
    return WCUT_OK;
}

static wcut_status fill_surface(const wcut_facade_plan *p, wcut_vec3 size, wcut_cell *cell, wcut_error *error) {
    /* corners of the cells, at even arc lengths along both middles */
    const size_t wide = (size_t)p->columns + 1, deep = (size_t)p->rows + 1;
    double *parameter = wcut_alloc(wide + deep, sizeof *parameter);
    wcut_vec3 *corner = wcut_alloc(wide * deep, sizeof *corner);
    wcut_status status = parameter && corner ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = even_parameters(p->surface, p->columns, false, parameter);
    if (status == WCUT_OK) status = even_parameters(p->surface, p->rows, true, parameter + wide);
    if (status == WCUT_OK)
        status = wcut_surface_eval_grid(p->surface, (int)wide, parameter, (int)deep, parameter + wide, corner);
    if (status != WCUT_OK) wcut_fail(error, status, "lattice: the surface: %s", wcut_status_text(status));

    /* a frame for each; neighbours must look to the same side */
    for (int k = 0; k < p->rows * p->columns && status == WCUT_OK; k++) {
        const int r = k / p->columns, c = k % p->columns;
        const wcut_vec3 *low = corner + (size_t)r * wide + (size_t)c, *high = low + wide;
        const wcut_vec3 four[4] = {low[0], low[1], high[1], high[0]};
        status = place_on_corners(p, size, r, c, four, &cell[k], error);
        const bool left = c > 0 && status == WCUT_OK && !(vec3_dot(cell[k].z, cell[k - 1].z) > 0);
        const bool below = r > 0 && status == WCUT_OK && !(vec3_dot(cell[k].z, cell[k - p->columns].z) > 0);
        if (left || below)
            status = wcut_fail(error, WCUT_DEGENERATE,
                               "lattice: the surface folds between row %d, column %d and its neighbour, near (%.6g, "
                               "%.6g, %.6g) mm; expected less than 90 deg between them",
                               r, c, low->x, low->y, low->z);
    }
    wcut_free(parameter);
    wcut_free(corner);
    return status;
}

wcut_status wcut_lattice_fill(const wcut_facade_plan *plan, wcut_vec3 size, wcut_cell *cell, wcut_error *error) {
    if (plan->lattice == WCUT_FACADE_LATTICE_CYLINDER) return fill_cylinder(plan, size, cell, error);
    if (plan->lattice == WCUT_FACADE_LATTICE_SURFACE) return fill_surface(plan, size, cell, error);
    fill_plane(plan, size, cell);
    return WCUT_OK;
}
