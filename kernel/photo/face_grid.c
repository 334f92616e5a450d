/* The simulated face as heights over the block, by rasterising the triangles between wires. */
#include "photo/face_grid.h"

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

enum { CELLS_MAX = 4000000 };

/* [mm] heights between nodes are linear: at a radius of 100 mm the error is 1e-3 mm */
static const double CELL = 1;

/* a node of the history with what the grid keeps of it */
typedef struct face_corner {
    wcut_vec3 place;
    double station;
    wcut_vec3 tangent;
} face_corner;

static face_corner corner_of(const wcut_history *h, int station, int node) {
    const wcut_vec3 *row = h->position + (size_t)station * h->nodes;
    const int before = node > 0 ? node - 1 : 0, after = node < h->nodes - 1 ? node + 1 : node;
    return (face_corner){row[node], station, vec3_unit(vec3_sub(row[after], row[before]))};
}

/* z of the face, or that of another sheet over the same node: the one that the camera's side sees */
static void put_node(wcut_face_grid *g, size_t at, bool upper, const face_corner c[3], const double w[3]) {
    const double z = w[0] * c[0].place.z + w[1] * c[1].place.z + w[2] * c[2].place.z;
    if (g->station[at] >= 0 && (upper ? z >= g->z[at] : z <= g->z[at])) return;
    const double x = w[0] * c[0].tangent.x + w[1] * c[1].tangent.x + w[2] * c[2].tangent.x,
                 y = w[0] * c[0].tangent.y + w[1] * c[1].tangent.y + w[2] * c[2].tangent.y, length = hypot(x, y);
    if (!(length > 1e-9)) return; /* a wire that stands upright has no direction seen from above */
    g->z[at] = (float)z;
    g->station[at] = (float)(w[0] * c[0].station + w[1] * c[1].station + w[2] * c[2].station);
    g->tangent_x[at] = (float)(x / length);
    g->tangent_y[at] = (float)(y / length);
}

/* the nodes of the grid that a triangle covers, seen from above */
static void fill_triangle(wcut_face_grid *g, double height, bool upper, const face_corner c[3]) {
    const wcut_vec3 a = c[0].place, b = vec3_sub(c[1].place, a), d = vec3_sub(c[2].place, a);
    const double area = b.x * d.y - b.y * d.x;
    if (!(fabs(area) > 1e-12)) return;

    /* its bounding box, in nodes */
    const double low_x = fmin(a.x, fmin(c[1].place.x, c[2].place.x)),
                 high_x = fmax(a.x, fmax(c[1].place.x, c[2].place.x));
    const double low_y = fmin(a.y, fmin(c[1].place.y, c[2].place.y)),
                 high_y = fmax(a.y, fmax(c[1].place.y, c[2].place.y));
    const double last_column = g->columns - 1, last_row = g->rows - 1;
    if (high_x < 0 || high_y < 0 || low_x > last_column * g->cell || low_y > last_row * g->cell) return;
    const int first = (int)clamp(ceil(low_x / g->cell), 0, last_column),
              last = (int)clamp(floor(high_x / g->cell), 0, last_column);
    const int bottom = (int)clamp(ceil(low_y / g->cell), 0, last_row),
              top = (int)clamp(floor(high_y / g->cell), 0, last_row);

    for (int row = bottom; row <= top; row++)
        for (int column = first; column <= last; column++) {
            const double x = column * g->cell - a.x, y = row * g->cell - a.y;
            const double v = (x * d.y - y * d.x) / area, w = (b.x * y - b.y * x) / area;
            const double edge = -1e-9;
            if (v < edge || w < edge || 1 - v - w < edge) continue;
            const double weight[3] = {1 - v - w, v, w}, z = a.z + v * b.z + w * d.z;
            if (z >= 0 && z <= height) put_node(g, (size_t)row * g->columns + column, upper, c, weight);
        }
}

wcut_status wcut_face_grid_create(wcut_vec3 block, const wcut_history *h, bool upper, wcut_face_grid **grid) {
    wcut_face_grid *g = wcut_alloc(1, sizeof *g);
    if (!g) return WCUT_NO_MEMORY;

    /* whole cells in both directions; the last may reach past the block, where the wire goes on */
    g->cell = fmax(fmin(CELL, fmin(block.x, block.y) / 100), sqrt(block.x * block.y / CELLS_MAX));
    g->columns = (int)ceil(block.x / g->cell) + 1;
    g->rows = (int)ceil(block.y / g->cell) + 1;
    const size_t count = (size_t)g->columns * g->rows;
    g->z = wcut_alloc(count, sizeof *g->z);
    g->station = wcut_alloc(count, sizeof *g->station);
    g->tangent_x = wcut_alloc(count, sizeof *g->tangent_x);
    g->tangent_y = wcut_alloc(count, sizeof *g->tangent_y);
    g->hidden = wcut_alloc(count, sizeof *g->hidden);
    if (!g->z || !g->station || !g->tangent_x || !g->tangent_y || !g->hidden) {
        wcut_face_grid_destroy(g);
        return WCUT_NO_MEMORY;
    }
    for (size_t k = 0; k < count; k++) g->station[k] = -1;

    /* two triangles between neighbouring nodes of neighbouring wires */
    for (int s = 0; s + 1 < h->stations; s++)
        for (int n = 0; n + 1 < h->nodes; n++) {
            const face_corner a = corner_of(h, s, n), b = corner_of(h, s, n + 1), c = corner_of(h, s + 1, n),
                              d = corner_of(h, s + 1, n + 1);
            fill_triangle(g, block.z, upper, (const face_corner[]){a, b, d});
            fill_triangle(g, block.z, upper, (const face_corner[]){a, d, c});
        }

    size_t there = 0;
    for (size_t k = 0; k < count; k++) there += g->station[k] >= 0;
    if (there == 0) {
        wcut_face_grid_destroy(g);
        return WCUT_DEGENERATE;
    }
    *grid = g;
    return WCUT_OK;
}

void wcut_face_grid_destroy(wcut_face_grid *g) {
    if (!g) return;
    wcut_free(g->z);
    wcut_free(g->station);
    wcut_free(g->tangent_x);
    wcut_free(g->tangent_y);
    wcut_free(g->hidden);
    wcut_free(g);
}

wcut_face_place wcut_face_grid_locate(const wcut_face_grid *g, double x, double y) {
    const double u = x / g->cell, v = y / g->cell;
    wcut_face_place p = {0};
    if (!(u >= 0 && v >= 0 && u <= g->columns - 1 && v <= g->rows - 1)) return p;
    const int i = (int)fmin(u, g->columns - 2), j = (int)fmin(v, g->rows - 2);
    const double fu = u - i, fv = v - j;
    const size_t at[4] = {(size_t)j * g->columns + i, (size_t)j * g->columns + i + 1, (size_t)(j + 1) * g->columns + i,
                          (size_t)(j + 1) * g->columns + i + 1};
    const double w[4] = {(1 - fu) * (1 - fv), fu * (1 - fv), (1 - fu) * fv, fu * fv};

    /* all four must be there: what lies beyond the last wire is not guessed */
    p.there = true;
    for (int k = 0; k < 4; k++) {
        if (g->station[at[k]] < 0) return (wcut_face_place){0};
        p.z += w[k] * g->z[at[k]];
        p.station += w[k] * g->station[at[k]];
        p.tangent_x += w[k] * g->tangent_x[at[k]];
        p.tangent_y += w[k] * g->tangent_y[at[k]];
        p.hidden = p.hidden || g->hidden[at[k]];
    }
    return p;
}

/* whether the face rises above the line from a node to the eye */
static bool is_hidden(const wcut_face_grid *g, int column, int row, double highest, wcut_vec3 eye, double side) {
    const size_t at = (size_t)row * g->columns + column;
    const wcut_vec3 from = vec3(column * g->cell, row * g->cell, g->z[at]), way = vec3_sub(eye, from);
    const double across = hypot(way.x, way.y);
    if (!(across > g->cell)) return false;

    /* steps of a cell from two cells on, until the line is above all of the face */
    const wcut_vec3 step = vec3_scale(g->cell / across, way);
    for (int k = 2; k * g->cell < across; k++) {
        const wcut_vec3 p = vec3_add_scaled(from, k, step);
        if (side * p.z > highest) return false;
        const int i = (int)floor(p.x / g->cell + 0.5), j = (int)floor(p.y / g->cell + 0.5);
        if (i < 0 || j < 0 || i >= g->columns || j >= g->rows) return false;
        const size_t there = (size_t)j * g->columns + i;

        /* half a cell beside the line the face may be higher by its slope: one cell of doubt */
        if (g->station[there] >= 0 && side * g->z[there] > side * p.z + g->cell) return true;
    }
    return false;
}

void wcut_face_grid_hide(wcut_face_grid *g, wcut_vec3 eye, bool upper) {
    const double side = upper ? -1 : 1;
    double highest = -INFINITY;
    const size_t count = (size_t)g->columns * g->rows;
    for (size_t k = 0; k < count; k++)
        if (g->station[k] >= 0) highest = fmax(highest, side * g->z[k]);
    for (int row = 0; row < g->rows; row++)
        for (int column = 0; column < g->columns; column++) {
            const size_t at = (size_t)row * g->columns + column;
            g->hidden[at] = g->station[at] >= 0 && is_hidden(g, column, row, highest, eye, side);
        }
}
