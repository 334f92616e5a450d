/* Faces as triangles with borders by index, and the solid between two of them: nothing is ever welded. */
#include "solid/cap.h"

#include <limits.h>
#include <stdbool.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vec3.h"
#include "solid/polygon.h"

void wcut_cap_clear(wcut_cap *cap) {
    wcut_free(cap->vertex);
    wcut_free(cap->triangle);
    for (int b = 0; b < 4; b++) wcut_free(cap->border[b]);
    *cap = (wcut_cap){.vertex_count = 0};
}

wcut_status wcut_cap_create(int vertices, int triangles, const int borders[4], wcut_cap *cap) {
    *cap = (wcut_cap){.vertex_count = vertices, .triangle_count = triangles};
    cap->vertex = wcut_alloc((size_t)vertices, sizeof *cap->vertex);
    cap->triangle = wcut_alloc((size_t)triangles, 3 * sizeof *cap->triangle);
    bool made = cap->vertex && cap->triangle;
    for (int b = 0; b < 4; b++) {
        cap->border_count[b] = borders[b];
        cap->border[b] = wcut_alloc((size_t)borders[b], sizeof *cap->border[b]);
        made = made && cap->border[b];
    }
    if (made) return WCUT_OK;
    wcut_cap_clear(cap);
    return WCUT_NO_MEMORY;
}

/* ---- the cut face ---- */

/* Columns of the grid lie in planes of x, its first and last row in those of y: what rounding made of that is undone. */
static void snap(wcut_cap *cap, int columns, int rows, wcut_sides sides) {
    for (int i = 0; i < columns; i++) {
        double x = cap->vertex[i].x;
        if (i == 0) x = sides.x[0];
        if (i == columns - 1) x = sides.x[1];
        for (int j = 0; j < rows; j++) cap->vertex[(ptrdiff_t)j * columns + i].x = x;
        cap->vertex[i].y = sides.y[0];
        cap->vertex[(ptrdiff_t)(rows - 1) * columns + i].y = sides.y[1];
    }
}

wcut_status wcut_cap_tessellate(const wcut_surface *patch, wcut_sides sides, double chord_tolerance, wcut_cap *cap,
                                double *chord_error) {
    wcut_mesh *mesh;
    wcut_tessellation_report report;
    wcut_cap l;

    /* triangles of the patch on a grid */
    wcut_status status = wcut_surface_tessellate(patch, chord_tolerance, &mesh, &report);
    if (status != WCUT_OK) return status;
    const int columns = report.columns, rows = report.rows, borders[4] = {rows, rows, columns, columns};
    status = mesh->triangle_count == 2 * (columns - 1) * (rows - 1) /* none that shrank to nothing was left out */
                 ? wcut_cap_create(mesh->vertex_count, mesh->triangle_count, borders, &l)
                 : WCUT_DEGENERATE;

    /* borders by index: two along y, two along x; coordinates exactly on the sides */
    if (status == WCUT_OK) {
        memcpy(l.vertex, mesh->vertex, (size_t)mesh->vertex_count * sizeof *l.vertex);
        memcpy(l.triangle, mesh->triangle, (size_t)mesh->triangle_count * 3 * sizeof *l.triangle);
        snap(&l, columns, rows, sides);
        for (int j = 0; j < rows; j++) l.border[0][j] = j * columns, l.border[1][j] = j * columns + columns - 1;
        for (int i = 0; i < columns; i++) l.border[2][i] = i, l.border[3][i] = (rows - 1) * columns + i;
        *cap = l;
        *chord_error = report.chord_error;
    }

    wcut_mesh_destroy(mesh);
    return status;
}

int wcut_cap_is_graph(const wcut_cap *cap) {
    for (int t = 0; t < cap->triangle_count; t++) {
        wcut_point2d f[3];
        for (int k = 0; k < 3; k++) {
            const wcut_vec3 *p = &cap->vertex[cap->triangle[3 * (ptrdiff_t)t + k]];
            f[k] = (wcut_point2d){p->x, p->y};
        }
        if (!(wcut_orient2d(f[0], f[1], f[2]) > 0)) return 0;
    }
    for (int b = 0; b < 4; b++)
        for (int k = 1; k < cap->border_count[b]; k++) {
            const wcut_vec3 *p = &cap->vertex[cap->border[b][k - 1]], *q = &cap->vertex[cap->border[b][k]];
            if (b < 2 ? !(q->y > p->y) : !(q->x > p->x)) return 0;
        }
    return 1;
}

/* ---- the solid ---- */

/* two caps and where their vertices stand in the mesh */
typedef struct shell {
    const wcut_cap *floor, *ceiling;
    int floor_at, ceiling_at;
} shell;

/* a shell's place in the mesh: its ceiling's vertices, then its floor's */
static shell shell_of(const wcut_cap *floor, const wcut_cap *ceiling, int at) {
    return (shell){floor, ceiling, at + ceiling->vertex_count, at};
}

static bool is_turned(int side) { return side == 0 || side == 3; } /* the plane's p runs to the right of who looks */

/* the hole that a lug makes in the block's side, clockwise seen from outside: the lug's own corners there */
static void put_hole(const shell *lug, int side, int corner[4]) {
    const int *top = lug->ceiling->border[1 - side], *bottom = lug->floor->border[1 - side];
    const int left = is_turned(side) ? 1 : 0, right = 1 - left;
    corner[0] = lug->ceiling_at + top[left], corner[1] = lug->ceiling_at + top[right];
    corner[2] = lug->floor_at + bottom[right], corner[3] = lug->floor_at + bottom[left];
}

/* places of vertices in the plane of a side, and the triangles of the region between the loops */
static wcut_status fill_side(int side, int loops, const int *size, const int *index, const wcut_vec3 *vertex,
                             int *triangle) {
    int points = 0;
    for (int l = 0; l < loops; l++) points += size[l];
    wcut_point2d *point = wcut_alloc((size_t)points, sizeof *point);
    if (!point) return WCUT_NO_MEMORY;
    for (int k = 0; k < points; k++) {
        const wcut_vec3 *x = &vertex[index[k]];
        const double along = side < 2 ? x->y : x->x;
        point[k] = (wcut_point2d){is_turned(side) ? -along : along, x->z};
    }

    /* triangles of the polygon, by the indices in the mesh */
    const wcut_status status = wcut_polygon_triangulate(loops, size, point, triangle);
    for (int k = 0; status == WCUT_OK && k < 3 * (points + 2 * loops - 4); k++) triangle[k] = index[triangle[k]];
    wcut_free(point);
    return status;
}

/* A side's region, seen from outside: along the floor's border, back along the ceiling's, around the lugs on it. */
static wcut_status enclose_side(const shell *s, int side, int lugs, const shell *lug, const int *lug_side,
                                const wcut_vec3 *vertex, int **to) {
    const int low = s->floor->border_count[side], high = s->ceiling->border_count[side];
    int *index = wcut_alloc((size_t)(low + high) + 4 * (size_t)lugs, sizeof *index);
    int *size = wcut_alloc((size_t)lugs + 1, sizeof *size);
    if (!index || !size) {
        wcut_free(size);
        wcut_free(index);
        return WCUT_NO_MEMORY;
    }

    /* floor and ceiling borders one after the other */
    const bool turned = is_turned(side);
    for (int k = 0; k < low; k++) index[k] = s->floor_at + s->floor->border[side][turned ? low - 1 - k : k];
    for (int k = 0; k < high; k++) index[low + k] = s->ceiling_at + s->ceiling->border[side][turned ? k : high - 1 - k];

    /* holes */
    int loops = 1, points = low + high;
    size[0] = points;
    for (int k = 0; k < lugs; k++) {
        if (lug_side[k] != side) continue;
        put_hole(&lug[k], side, index + points);
        size[loops++] = 4, points += 4;
    }

    const wcut_status status = fill_side(side, loops, size, index, vertex, *to);
    *to += 3 * (ptrdiff_t)(points + 2 * loops - 4);
    wcut_free(size);
    wcut_free(index);
    return status;
}

/* the triangles of both caps, the ceiling as it is, the floor turned */
static void put_caps(const shell *s, int **to) {
    for (int k = 0; k < 3 * s->ceiling->triangle_count; k++) *(*to)++ = s->ceiling_at + s->ceiling->triangle[k];
    for (int t = 0; t < s->floor->triangle_count; t++) { /* seen from below */
        const int *c = s->floor->triangle + 3 * (ptrdiff_t)t;
        *(*to)++ = s->floor_at + c[0], *(*to)++ = s->floor_at + c[2], *(*to)++ = s->floor_at + c[1];
    }
}

static void put_cap_vertices(const shell *s, wcut_vec3 *vertex) {
    memcpy(vertex + s->ceiling_at, s->ceiling->vertex, (size_t)s->ceiling->vertex_count * sizeof *vertex);
    memcpy(vertex + s->floor_at, s->floor->vertex, (size_t)s->floor->vertex_count * sizeof *vertex);
}

/* the sides of the block with holes where lugs are, then the lugs without the side that they stand on */
static wcut_status put_sides(const shell *block, int lugs, const shell *lug, const int *lug_side,
                             const wcut_vec3 *vertex, int *to) {
    wcut_status status = WCUT_OK;
    for (int b = 0; status == WCUT_OK && b < 4; b++) status = enclose_side(block, b, lugs, lug, lug_side, vertex, &to);
    for (int k = 0; k < lugs; k++) {
        put_caps(&lug[k], &to);
        for (int b = 0; status == WCUT_OK && b < 4; b++)
            if (b != 1 - lug_side[k]) status = enclose_side(&lug[k], b, 0, NULL, NULL, vertex, &to);
    }
    return status;
}

wcut_status wcut_cap_enclose(const wcut_cap *floor, const wcut_cap *ceiling, int lugs, const wcut_cap_lug *lug,
                             wcut_mesh **mesh) {
    /* triangles of both faces and of four sides; a hole has four corners and two triangles more */
    size_t triangles = (size_t)floor->triangle_count + (size_t)ceiling->triangle_count;
    size_t vertices = (size_t)floor->vertex_count + (size_t)ceiling->vertex_count;
    for (int b = 0; b < 4; b++) triangles += (size_t)floor->border_count[b] + (size_t)ceiling->border_count[b] - 2;
    for (int k = 0; k < lugs; k++) {
        const wcut_cap *low = &lug[k].floor, *high = &lug[k].ceiling;
        vertices += (size_t)low->vertex_count + (size_t)high->vertex_count;
        triangles += (size_t)low->triangle_count + (size_t)high->triangle_count + 6;
        for (int b = 0; b < 4; b++)
            if (b != 1 - lug[k].side) triangles += (size_t)low->border_count[b] + (size_t)high->border_count[b] - 2;
    }
    if (triangles > INT_MAX / 3 || vertices > INT_MAX) return WCUT_BAD_ARGUMENT;

    wcut_mesh *m;
    wcut_status status = wcut_mesh_create((int)vertices, (int)triangles, 0, &m);
    if (status != WCUT_OK) return status;
    shell *of = wcut_alloc((size_t)lugs + 1, sizeof *of);
    int *side = wcut_alloc((size_t)lugs + 1, sizeof *side);
    if (!of || !side) status = WCUT_NO_MEMORY;

    /* vertices: ceiling, then floor, then those of the lugs */
    if (status == WCUT_OK) {
        const shell block = shell_of(floor, ceiling, 0);
        int at = ceiling->vertex_count + floor->vertex_count, *to = m->triangle;
        put_cap_vertices(&block, m->vertex);
        for (int k = 0; k < lugs; k++) {
            of[k] = shell_of(&lug[k].floor, &lug[k].ceiling, at), side[k] = lug[k].side;
            put_cap_vertices(&of[k], m->vertex);
            at += lug[k].floor.vertex_count + lug[k].ceiling.vertex_count;
        }

        /* both faces, then what is around */
        put_caps(&block, &to);
        status = put_sides(&block, lugs, of, side, m->vertex, to);
    }
    wcut_free(side);
    wcut_free(of);
    if (status == WCUT_OK) {
        *mesh = m;
    } else {
        wcut_mesh_destroy(m);
    }

    return status;
}
