/* A surface as triangles on a structured grid, no further from it than a chord tolerance that is measured. */
#include <limits.h>
#include <wirecut/mesh.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/chord_error.h"
#include "surface/grid.h"
#include "surface/spacing.h"

enum { ROUNDS_MAX = 24, VERTEX_MAX = INT_MAX / 6 };

/* Samples lie up to an eighth of a cell beside the largest distance, which is flat there: a parabola of height 1 has
   fallen to 0.94. What is held at the samples leaves that much room. */
static const double SAMPLED_SHARE = 0.94;

/* An area element below this share of the largest has no direction but rounding's. */
static const double AREA_MIN = 1e-10;

/* Corners nearer than this share of the largest coordinate coincide. */
static const double SAME = 1e-14;

/* raise the density of the cells that are too coarse: the error falls with the square of their size */
static void refine(wcut_spacing *lines, const double *error, double held) {
    for (int i = 0; i < lines->pieces; i++)
        if (error[i] > held) lines->density[i] *= fmax(1.05, sqrt(1.05 * error[i] / held));
}

/* put `spacing` in the place of its own grid lines */
static wcut_status lay_lines(wcut_spacing *spacing) {
    wcut_spacing lines;
    const wcut_status status = wcut_spacing_lines(spacing, VERTEX_MAX / 2, &lines);
    if (status != WCUT_OK) return status;
    wcut_spacing_clear(spacing);
    *spacing = lines;
    return WCUT_OK;
}

/* grid lines that hold the tolerance; *most: the distance measured */
static wcut_status tessellate_find_lines(const wcut_surface *s, double tolerance, wcut_spacing *u, wcut_spacing *v,
                                         double *max) {
    const double held = SAMPLED_SHARE * tolerance;

    /* a first estimate from curvature */
    wcut_status status = wcut_spacing_estimate(s, tolerance, u, v);
    for (int round = 0; status == WCUT_OK; round++) {
        if (round == ROUNDS_MAX) return WCUT_NOT_CONVERGED;

        /* lines, and the distance measured on them */
        status = lay_lines(u);
        if (status == WCUT_OK) status = lay_lines(v);
        if (status != WCUT_OK) break;
        if (u->pieces + 1 > VERTEX_MAX / (v->pieces + 1)) return WCUT_NOT_CONVERGED;
        double *error = wcut_alloc((size_t)u->pieces + v->pieces, sizeof *error);
        if (!error) return WCUT_NO_MEMORY;
        status = wcut_chord_error(s, u, v, held, error, error + u->pieces, max);
        const bool done = status == WCUT_OK && *max <= held;

        /* more lines where the distance was too large */
        if (status == WCUT_OK && !done) {
            refine(u, error, held);
            refine(v, error + u->pieces, held);
        }
        wcut_free(error);
        if (done) break;
    }

    return status;
}

/* points, parameters and S_u x S_v of every vertex; *most: the largest |S_u x S_v| */
static wcut_status fill_vertices(const wcut_surface *s, const wcut_spacing *lines_u, const wcut_spacing *lines_v,
                                 wcut_mesh *mesh, double *max) {
    const int columns = lines_u->pieces + 1, rows = lines_v->pieces + 1;

    /* basis functions of every grid line */
    wcut_axis u = {.count = 0}, v = {.count = 0};
    wcut_status status = wcut_axis_fill(s->degree_u, s->count_u, s->knots_u, columns, lines_u->at, 1, &u);
    if (status == WCUT_OK) status = wcut_axis_fill(s->degree_v, s->count_v, s->knots_v, rows, lines_v->at, 1, &v);
    wcut_homogeneous *fold = wcut_alloc((size_t)s->count_u, 2 * sizeof *fold);
    if (!fold) status = WCUT_NO_MEMORY;

    /* fold the net along v once a row, then evaluate along u */
    *max = 0;
    for (int j = 0; status == WCUT_OK && j < rows; j++) {
        wcut_grid_fold(s, &v, j, 0, fold);
        wcut_grid_fold(s, &v, j, 1, fold + s->count_u);
        for (int i = 0; i < columns; i++) {
            const ptrdiff_t at = (ptrdiff_t)j * columns + i;
            wcut_homogeneous sum[4] = {wcut_grid_along(&u, i, 0, fold), wcut_grid_along(&u, i, 0, fold + s->count_u),
                                       wcut_grid_along(&u, i, 1, fold)};
            wcut_vec3 ders[4];
            wcut_rational_surface(1, s->weights != NULL, sum, ders);

            /* normals keep their length here: the longest is the scale by which a pole is told */
            mesh->vertex[at] = ders[0];
            mesh->normal[at] = vec3_cross(ders[2], ders[1]);
            mesh->uv[2 * at] = lines_u->at[i], mesh->uv[2 * at + 1] = lines_v->at[j];
            *max = fmax(*max, vec3_length(mesh->normal[at]));
        }
    }
    wcut_free(fold);
    wcut_axis_clear(&v);
    wcut_axis_clear(&u);

    return status;
}

/* Two triangles a cell along the diagonal from (0, 0) to (1, 1). Those with coinciding corners are left out: at a pole
   rounding alone keeps them apart. */
static void fill_triangles(int columns, int rows, wcut_mesh *mesh) {
    const wcut_vec3 *x = mesh->vertex;
    double size = 0;
    for (int k = 0; k < mesh->vertex_count; k++) size = fmax(size, vec3_length(x[k]));
    const double same = SAME * size;
    int *to = mesh->triangle;
    for (int j = 0; j + 1 < rows; j++)
        for (int i = 0; i + 1 < columns; i++) {
            const int a = j * columns + i, b = a + 1, d = a + columns, c = d + 1;
            if (vec3_distance(x[a], x[c]) <= same) continue;
            if (vec3_distance(x[a], x[b]) > same && vec3_distance(x[b], x[c]) > same) *to++ = a, *to++ = b, *to++ = c;
            if (vec3_distance(x[c], x[d]) > same && vec3_distance(x[d], x[a]) > same) *to++ = a, *to++ = c, *to++ = d;
        }
    mesh->triangle_count = (int)((to - mesh->triangle) / 3);
}

/* the sum of the unit normals around (i, j) */
static wcut_vec3 sum_around(int columns, int rows, const wcut_vec3 *normal, int i, int j) {
    wcut_vec3 sum = {0, 0, 0};
    for (int b = j > 0 ? j - 1 : 0; b <= j + 1 && b < rows; b++)
        for (int a = i > 0 ? i - 1 : 0; a <= i + 1 && a < columns; a++)
            sum = vec3_add(sum, normal[(ptrdiff_t)b * columns + a]);
    return sum;
}

/* Make normals unit. Where the area element vanishes the neighbours' mean stands in, from the border of such a patch
   inwards: forth and back over the grid until nothing changes. False where no vertex has a normal. */
static bool complete_normals(int columns, int rows, double max, wcut_vec3 *normal) {
    const int count = columns * rows;

    /* normals where the area element is not negligible */
    int missing = 0;
    for (int k = 0; k < count; k++) {
        const double length = vec3_length(normal[k]);
        const bool has = length > AREA_MIN * max;
        normal[k] = has ? vec3_scale(1 / length, normal[k]) : vec3(0, 0, 0);
        missing += !has;
    }
    if (missing == count) return false;

    /* fill the rest from their neighbours, forth and back */
    for (bool forth = true; missing > 0; forth = !forth) {
        const int before = missing;
        for (int n = 0; n < count; n++) {
            const int k = forth ? n : count - 1 - n;
            if (normal[k].x != 0 || normal[k].y != 0 || normal[k].z != 0) continue;
            normal[k] = vec3_unit(sum_around(columns, rows, normal, k % columns, k / columns));
            missing -= normal[k].x != 0 || normal[k].y != 0 || normal[k].z != 0;
        }
        if (missing == before) return false; /* neighbours that cancel: folded flat, no side is up */
    }

    return true;
}

wcut_status wcut_surface_tessellate(const wcut_surface *surface, double chord_tolerance, wcut_mesh **mesh,
                                    wcut_tessellation_report *report) {
    if (!surface || !mesh || !is_positive(chord_tolerance)) return WCUT_BAD_ARGUMENT;
    wcut_spacing u = {.pieces = 0}, v = {.pieces = 0};
    wcut_mesh *m = NULL;
    double max = 0, area;

    /* lines, vertices, triangles, normals */
    wcut_status status = tessellate_find_lines(surface, chord_tolerance, &u, &v, &max);
    if (status != WCUT_OK) goto done;
    const int columns = u.pieces + 1, rows = v.pieces + 1;

    /* a vertex at every crossing of two lines, two triangles in every cell */
    status = wcut_mesh_create(columns * rows, 2 * u.pieces * v.pieces, WCUT_MESH_NORMAL | WCUT_MESH_UV, &m);
    if (status == WCUT_OK) status = fill_vertices(surface, &u, &v, m, &area);
    if (status != WCUT_OK) goto done;

    /* triangles without an area are left out; a surface without any normal has no sides */
    fill_triangles(columns, rows, m);
    if (!complete_normals(columns, rows, area, m->normal) || m->triangle_count == 0) {
        status = WCUT_DEGENERATE;
        goto done;
    }

    if (report) *report = (wcut_tessellation_report){.chord_error = max, .rows = rows, .columns = columns};
    *mesh = m;
    m = NULL;

done:
    wcut_mesh_destroy(m);
    wcut_spacing_clear(&v);
    wcut_spacing_clear(&u);

    return status;
}
