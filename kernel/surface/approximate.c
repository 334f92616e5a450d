/* A bicubic surface through samples of any map of two parameters, refined until it is as near as asked.

   On a line of the grid along u the surface is the spline through that line's samples alone: what it misses there is due
   to the spacing in u, and only that is refined (and in v likewise). Between joints the knots are averages of parameters
   (de Boor 1978); a joint is a triple knot. */
#include "surface/approximate.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/interpolate.h"
#include "surface/rational.h"

enum { CELLS_FIRST = 4, ROUNDS_MAX = 40, SAMPLES_MAX = 1 << 24, QUARTERS = 4 };

/* what each direction alone may miss the map by, of the tolerance */
static const double SHARE = 0.4;

/* of the largest coordinate: nearer than this rounding does not let two points be */
static const double ROUNDED = 1e-14;

/* [1] largest ratio of the widths of neighbouring cells */
static const double GRADING = 4;

/* parameters of one direction */
typedef struct lines {
    int count;
    double *at;
    bool *joint;  /* count */
    bool *coarse; /* count - 1: cells to be halved */
} lines;

static void lines_clear(lines *l) {
    wcut_free(l->at);
    wcut_free(l->joint);
    wcut_free(l->coarse);
    *l = (lines){.count = 0};
}

static wcut_status lines_new(int count, lines *l) {
    lines n = {.count = count};
    n.at = wcut_alloc((size_t)count, sizeof *n.at);
    n.joint = wcut_alloc((size_t)count, sizeof *n.joint);
    n.coarse = wcut_alloc((size_t)count, sizeof *n.coarse);
    if (!n.at || !n.joint || !n.coarse) {
        lines_clear(&n);
        return WCUT_NO_MEMORY;
    }
    *l = n;
    return WCUT_OK;
}

static wcut_status lines_begin(const wcut_map_axis *axis, lines *l) {
    const wcut_status status = lines_new((axis->joints - 1) * CELLS_FIRST + 1, l);
    if (status != WCUT_OK) return status;
    for (int s = 0; s + 1 < axis->joints; s++)
        for (int k = 0; k < CELLS_FIRST; k++) {
            const double share = (double)k / CELLS_FIRST;
            l->at[s * CELLS_FIRST + k] = (1 - share) * axis->joint[s] + share * axis->joint[s + 1];
            l->joint[s * CELLS_FIRST + k] = k == 0;
        }
    l->at[l->count - 1] = axis->joint[axis->joints - 1];
    l->joint[l->count - 1] = true;
    return WCUT_OK;
}

/* halve the coarse cells, and those much wider than a neighbour will be */
static wcut_status lines_refine(lines *l) {
    int more = 0;

    /* mark neighbours until no cell is much wider than the next */
    for (bool changed = true; changed;) {
        changed = false;
        for (int i = 0; i + 1 < l->count; i++) {
            if (l->coarse[i]) continue;
            const double width = l->at[i + 1] - l->at[i];
            for (int k = -1; k <= 1; k += 2) {
                const int n = i + k;
                if (n < 0 || n + 1 >= l->count) continue;
                const double next = (l->at[n + 1] - l->at[n]) / (l->coarse[n] ? 2 : 1);
                if (width > GRADING * next * 1.01) l->coarse[i] = changed = true;
            }
        }
    }

    /* the new lines: a middle in every marked cell */
    for (int i = 0; i + 1 < l->count; i++) more += l->coarse[i];
    lines n;
    const wcut_status status = lines_new(l->count + more, &n);
    if (status != WCUT_OK) return status;

    /* old and new ones in order; a middle is no joint */
    for (int i = 0, to = 0; i < l->count; i++) {
        n.at[to] = l->at[i], n.joint[to++] = l->joint[i];
        if (i + 1 < l->count && l->coarse[i]) n.at[to++] = (l->at[i] + l->at[i + 1]) / 2;
    }
    lines_clear(l);
    *l = n;

    return WCUT_OK;
}

static bool is_within_rounding(const wcut_surface *s, double tolerance) {
    double size = 0;
    for (int k = 0; k < s->count_u * s->count_v; k++) size = fmax(size, vec3_length(s->control[k]));
    return tolerance < ROUNDED * size;
}

static int refinements(const lines *l) {
    int sum = 0;
    for (int i = 0; i + 1 < l->count; i++) sum += l->coarse[i];
    return sum;
}

/* count + 4 knots, triple at joints, averages in between; a segment without lines inside it has none */
static void approximate_lay_knots(const lines *l, double *knots) {
    int made = 0;
    for (int k = 0; k < 4; k++) knots[made++] = l->at[0];
    for (int from = 0, to; from + 1 < l->count; from = to) {
        to = from + 1;
        while (!l->joint[to]) to++;
        for (int i = from + 1; i + 2 < to; i++) knots[made++] = (l->at[i] + l->at[i + 1] + l->at[i + 2]) / 3;
        for (int k = 0; k < 3; k++) knots[made++] = l->at[to];
    }
    knots[made] = l->at[l->count - 1];
}

static wcut_status approximate_interpolate(wcut_grid_map map, const void *data, const lines *u, const lines *v,
                                           wcut_surface **out) {
    if (u->count > SAMPLES_MAX / v->count) return WCUT_NOT_CONVERGED;
    wcut_surface *s;
    wcut_status status = wcut_surface_new(3, 3, u->count, v->count, false, &s);
    if (status != WCUT_OK) return status;
    approximate_lay_knots(u, s->knots_u);
    approximate_lay_knots(v, s->knots_v);
    status = map(data, u->count, u->at, v->count, v->at, s->control);
    if (status == WCUT_OK && !vec3_all_finite(u->count * v->count, s->control)) status = WCUT_DEGENERATE;
    if (status == WCUT_OK) status = wcut_interpolate_rows(3, u->count, s->knots_u, u->at, v->count, s->control);
    if (status == WCUT_OK) status = wcut_interpolate_columns(3, v->count, s->knots_v, v->at, u->count, s->control);
    if (status == WCUT_OK) {
        *out = s;
    } else {
        wcut_surface_destroy(s);
    }
    return status == WCUT_SINGULAR ? WCUT_DEGENERATE : status; /* cells lost to rounding */
}

/* distances of map and surface on a grid, count_v x count_u */
static wcut_status approximate_measure(wcut_grid_map map, const void *data, const wcut_surface *s, int count_u,
                                       const double *u, int count_v, const double *v, double *distance) {
    const size_t row = (size_t)count_u;
    wcut_vec3 *a = wcut_alloc(row, 2 * sizeof *a);
    wcut_status status = a ? WCUT_OK : WCUT_NO_MEMORY;
    for (int j = 0; j < count_v && status == WCUT_OK; j++) {
        status = map(data, count_u, u, 1, &v[j], a);
        if (status == WCUT_OK) status = wcut_surface_eval_grid(s, count_u, u, 1, &v[j], a + row);
        for (size_t i = 0; i < row && status == WCUT_OK; i++)
            distance[(size_t)j * row + i] = vec3_distance(a[i], a[i + row]);
    }
    wcut_free(a);
    return status;
}

/* mark the cells of `fine` in whose middles a line of `across` misses the map; `turned`: fine is the direction v */
static wcut_status mark_coarse(wcut_grid_map map, const void *data, const wcut_surface *s, lines *fine,
                               const lines *across, bool turned, double held) {
    const int cells = fine->count - 1;
    double *middle = wcut_alloc((size_t)cells, sizeof *middle);
    double *off = wcut_alloc((size_t)cells, (size_t)across->count * sizeof *off);
    wcut_status status = middle && off ? WCUT_OK : WCUT_NO_MEMORY;
    for (int i = 0; i < cells && status == WCUT_OK; i++) middle[i] = (fine->at[i] + fine->at[i + 1]) / 2;
    if (status == WCUT_OK)
        status = turned ? approximate_measure(map, data, s, across->count, across->at, cells, middle, off)
                        : approximate_measure(map, data, s, cells, middle, across->count, across->at, off);
    for (int i = 0; i < cells && status == WCUT_OK; i++)
        for (int k = 0; k < across->count; k++)
            if (!(off[turned ? (size_t)i * across->count + k : (size_t)k * cells + i] <= held)) fine->coarse[i] = true;
    wcut_free(off);
    wcut_free(middle);
    return status;
}

/* quarters of the cells and watched parameters, in rising order; returns how many, cell[k] the cell of each */
static int place_watch(const lines *l, const wcut_map_axis *axis, double *at, int *cell) {
    int made = 0, next = 0;
    for (int i = 0; i + 1 < l->count; i++)
        for (int q = 0; q < QUARTERS; q++) {
            const double share = (double)q / QUARTERS;
            const double here = (1 - share) * l->at[i] + share * l->at[i + 1];
            for (; next < axis->watched && axis->watch[next] < here; next++) {
                cell[made] = i;
                at[made++] = axis->watch[next];
            }
            cell[made] = i;
            at[made++] = here;
        }
    for (; next < axis->watched; next++) {
        cell[made] = l->count - 2;
        at[made++] = axis->watch[next];
    }
    return made;
}

/* look closely everywhere; cells that miss are marked in both directions */
static wcut_status approximate_check(wcut_grid_map map, const void *data, const wcut_surface *s, lines *u, lines *v,
                                     const wcut_map_axis *axis_u, const wcut_map_axis *axis_v, double tolerance,
                                     double *max) {
    /* the places to look at along both directions, and the cell that each is in */
    const size_t room_u = (size_t)QUARTERS * (size_t)u->count + (size_t)axis_u->watched,
                 room_v = (size_t)QUARTERS * (size_t)v->count + (size_t)axis_v->watched;
    double *at = wcut_alloc(2 * room_u + room_v, sizeof *at);
    int *cell = wcut_alloc(room_u + room_v, sizeof *cell);
    wcut_status status = at && cell ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        double *at_v = at + room_u, *off = at_v + room_v;
        int *cell_v = cell + room_u;
        const int count_u = place_watch(u, axis_u, at, cell), count_v = place_watch(v, axis_v, at_v, cell_v);

        /* one row of places at a time */
        *max = 0;
        for (int j = 0; j < count_v && status == WCUT_OK; j++) {
            status = approximate_measure(map, data, s, count_u, at, 1, &at_v[j], off);
            for (int i = 0; i < count_u && status == WCUT_OK; i++) {
                *max = fmax(*max, off[i]);
                if (!(off[i] <= tolerance)) u->coarse[cell[i]] = v->coarse[cell_v[j]] = true;
            }
        }
    }

    wcut_free(cell);
    wcut_free(at);
    return status;
}

wcut_status wcut_approximate(wcut_grid_map map, const void *data, const wcut_map_axis *axis_u,
                             const wcut_map_axis *axis_v, double tolerance, wcut_surface **surface, double *error) {
    /* both directions begin with their joints */
    lines u = {.count = 0}, v = {.count = 0};
    wcut_surface *s = NULL;
    double max = 0;
    wcut_status status = lines_begin(axis_u, &u);
    if (status == WCUT_OK) status = lines_begin(axis_v, &v);

    /* interpolate, look between the lines, refine; when nothing is coarse, check densely */
    for (int round = 0; status == WCUT_OK; round++) {
        if (round == ROUNDS_MAX) status = WCUT_NOT_CONVERGED;
        wcut_surface_destroy(s);
        s = NULL;
        if (status == WCUT_OK) status = approximate_interpolate(map, data, &u, &v, &s);
        if (status == WCUT_OK && is_within_rounding(s, tolerance)) status = WCUT_NOT_CONVERGED;
        if (status == WCUT_OK) status = mark_coarse(map, data, s, &u, &v, false, SHARE * tolerance);
        if (status == WCUT_OK) status = mark_coarse(map, data, s, &v, &u, true, SHARE * tolerance);
        if (status == WCUT_OK && refinements(&u) + refinements(&v) == 0)
            status = approximate_check(map, data, s, &u, &v, axis_u, axis_v, tolerance, &max);
        if (status != WCUT_OK || refinements(&u) + refinements(&v) == 0) break;
        status = lines_refine(&u);
        if (status == WCUT_OK) status = lines_refine(&v);
    }

    /* the caller gets a surface whose error was measured, or none */
    if (status == WCUT_OK) {
        *surface = s;
        *error = max;
        s = NULL;
    }
    wcut_surface_destroy(s);
    lines_clear(&v);
    lines_clear(&u);

    return status;
}
