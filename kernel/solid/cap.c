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

/* A side's region, seen from outside: along the floor's border, back along the ceiling's. */
static wcut_status enclose_side(const wcut_cap *floor, const wcut_cap *ceiling, int side, const wcut_vec3 *vertex,
                                int *triangle) {
    const int low = floor->border_count[side], high = ceiling->border_count[side], points = low + high;
    const bool along_y = side < 2, turned = side == 0 || side == 3; /* the plane's p runs to the right of who looks */

    /* the polygon's vertices in space */
    wcut_point2d *point = wcut_alloc((size_t)points, sizeof *point);
    int *index = wcut_alloc((size_t)points, sizeof *index);
    wcut_status status = point && index ? WCUT_OK : WCUT_NO_MEMORY;

    /* floor and ceiling borders one after the other */
    if (status == WCUT_OK) {
        for (int k = 0; k < low; k++) index[k] = ceiling->vertex_count + floor->border[side][turned ? low - 1 - k : k];
        for (int k = 0; k < high; k++) index[low + k] = ceiling->border[side][turned ? k : high - 1 - k];

        /* their places in the plane of the side */
        for (int k = 0; k < points; k++) {
            const wcut_vec3 *x = &vertex[index[k]];
            const double p = along_y ? x->y : x->x;
            point[k] = (wcut_point2d){turned ? -p : p, x->z};
        }

        /* triangles of the polygon, by the indices in the mesh */
        status = wcut_polygon_triangulate(1, &points, point, triangle);
        for (int k = 0; status == WCUT_OK && k < 3 * (points - 2); k++) triangle[k] = index[triangle[k]];
    }

    wcut_free(index);
    wcut_free(point);
    return status;
}

wcut_status wcut_cap_enclose(const wcut_cap *floor, const wcut_cap *ceiling, wcut_mesh **mesh) {
    /* triangles of both faces and of four sides */
    size_t triangles = (size_t)floor->triangle_count + (size_t)ceiling->triangle_count;
    for (int b = 0; b < 4; b++) triangles += (size_t)floor->border_count[b] + (size_t)ceiling->border_count[b] - 2;
    if (triangles > INT_MAX / 3 || ceiling->vertex_count > INT_MAX - floor->vertex_count) return WCUT_BAD_ARGUMENT;
    wcut_mesh *m;
    wcut_status status = wcut_mesh_create(ceiling->vertex_count + floor->vertex_count, (int)triangles, 0, &m);
    if (status != WCUT_OK) return status;

    /* vertices: ceiling, then floor */
    memcpy(m->vertex, ceiling->vertex, (size_t)ceiling->vertex_count * sizeof *m->vertex);
    memcpy(m->vertex + ceiling->vertex_count, floor->vertex, (size_t)floor->vertex_count * sizeof *m->vertex);

    /* triangles: the ceiling as it is, the floor turned */
    int *to = m->triangle;
    memcpy(to, ceiling->triangle, (size_t)ceiling->triangle_count * 3 * sizeof *to);
    to += 3 * (ptrdiff_t)ceiling->triangle_count;
    for (int t = 0; t < floor->triangle_count; t++) { /* seen from below */
        const int *c = floor->triangle + 3 * (ptrdiff_t)t;
        *to++ = ceiling->vertex_count + c[0];
        *to++ = ceiling->vertex_count + c[2];
        *to++ = ceiling->vertex_count + c[1];
    }

    /* sides between the borders */
    for (int b = 0; status == WCUT_OK && b < 4; b++) {
        status = enclose_side(floor, ceiling, b, m->vertex, to);
        to += 3 * (ptrdiff_t)(floor->border_count[b] + ceiling->border_count[b] - 2);
    }
    if (status == WCUT_OK) {
        *mesh = m;
    } else {
        wcut_mesh_destroy(m);
    }

    return status;
}
