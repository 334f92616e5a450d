/* Deviations spread over the grid of a face: hats of one step, and windows where points are few. */
#include <limits.h>
#include <wirecut/face.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

static const double FLAT = 1e-9; /* [mm^2] twice the area of a triangle that is none */
static const double MIN = 3;     /* points that a value is the mean of, where a window may grow to find them */

/* in 0 .. 1; NaN gives 0 */
static double clamped_share(double x) { return x > 0 ? fmin(x, 1) : 0; }

void wcut_face_locate(const wcut_face *face, double u, double v, double *row, double *column) {
    int low = 0, high = face->stations - 1;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (face->parameter[middle] <= v)
            low = middle;
        else
            high = middle;
    }
    const double step = face->parameter[high] - face->parameter[low];
    const double t = step > 0 ? clamped_share((v - face->parameter[low]) / step) : 0;
    const double begin = face->begin[low] + t * (face->begin[high] - face->begin[low]);
    const double width = face->end[low] + t * (face->end[high] - face->end[low]) - begin;
    *row = low + t;
    *column = clamped_share(width > 0 ? (u - begin) / width : 0) * (face->nodes - 1);
}

double wcut_face_kerf(const wcut_face *face) {
    double sum = 0;
    int count = 0;
    for (size_t i = 0; i < (size_t)face->stations * face->nodes; i++)
        if (face->inside[i]) sum += 2 * face->half_kerf[i], count++;
    return count > 0 ? sum / count : 0;
}

static bool is_flat(wcut_vec3 a, wcut_vec3 b, wcut_vec3 c) {
    return vec3_length(vec3_cross(vec3_sub(b, a), vec3_sub(c, a))) < FLAT;
}

wcut_status wcut_face_mesh(const wcut_face *face, wcut_mesh **mesh) {
    if (!face || !mesh) return WCUT_BAD_ARGUMENT;

    /* two triangles a cell at most */
    const size_t cells = ((size_t)face->stations - 1) * ((size_t)face->nodes - 1);
    wcut_mesh *m = NULL;
    if (cells > INT_MAX / 6) return WCUT_BAD_ARGUMENT;
    const wcut_status status = wcut_mesh_create(face->stations * face->nodes, (int)(2 * cells), 0, &m);
    if (status != WCUT_OK) return status;

    /* split each cell along the same diagonal; triangles without an area are left out */
    int count = 0;
    for (int r = 0; r + 1 < face->stations; r++)
        for (int c = 0; c + 1 < face->nodes; c++) {
            const int i = r * face->nodes + c, j = i + face->nodes;
            const int corner[2][3] = {{i, i + 1, j + 1}, {i, j + 1, j}};
            for (int k = 0; k < 2; k++) {
                const int *v = corner[k];
                if (is_flat(face->point[v[0]], face->point[v[1]], face->point[v[2]])) continue;
                for (int n = 0; n < 3; n++) m->triangle[3 * (size_t)count + n] = v[n];
                count++;
            }
        }

    for (int i = 0; i < m->vertex_count; i++) m->vertex[i] = face->point[i];
    m->triangle_count = count;
    *mesh = m;

    return WCUT_OK;
}

wcut_status wcut_face_map_create(const wcut_face *face, wcut_face_map **map) {
    if (!face || !map) return WCUT_BAD_ARGUMENT;
    wcut_face_map *m = wcut_alloc(1, sizeof *m);
    const size_t count = (size_t)face->stations * face->nodes;
    if (!m) return WCUT_NO_MEMORY;
    m->rows = face->stations, m->columns = face->nodes;
    m->sum = wcut_alloc(count, sizeof *m->sum);
    m->weight = wcut_alloc(count, sizeof *m->weight);
    if (!m->sum || !m->weight) {
        wcut_face_map_destroy(m);
        return WCUT_NO_MEMORY;
    }
    *map = m;
    return WCUT_OK;
}

void wcut_face_map_destroy(wcut_face_map *map) {
    if (!map) return;
    wcut_free(map->sum);
    wcut_free(map->weight);
    wcut_free(map);
}

void wcut_face_map_add(wcut_face_map *map, const wcut_face *face, int count, const wcut_deviation *deviation) {
    for (int i = 0; i < count; i++) {
        const wcut_deviation *d = &deviation[i];
        if (d->place > WCUT_PLACE_BORDER || !isfinite(d->u) || !isfinite(d->v) || !isfinite(d->distance)) continue;
        double row, column;
        wcut_face_locate(face, d->u, d->v, &row, &column);
        const int r = row < map->rows - 2 ? (int)row : map->rows - 2;
        const int c = column < map->columns - 2 ? (int)column : map->columns - 2;
        for (int k = 0; k < 4; k++) {
            const double weight = (k & 1 ? column - c : 1 - (column - c)) * (k & 2 ? row - r : 1 - (row - r));
            const size_t to = (size_t)(r + k / 2) * map->columns + c + k % 2;
            map->sum[to] += weight * d->distance;
            map->weight[to] += weight;
        }
    }
}

wcut_status wcut_mesh_spread(const wcut_mesh *mesh, int count, const wcut_deviation *deviation, double *sum,
                             double *weight) {
    if (!mesh || count < 0 || (count > 0 && (!deviation || !sum || !weight))) return WCUT_BAD_ARGUMENT;
    for (int i = 0; i < count; i++)
        if (deviation[i].triangle < 0 || deviation[i].triangle >= mesh->triangle_count) return WCUT_BAD_ARGUMENT;

    /* the sums change only now that every triangle is known to be there */
    for (int i = 0; i < count; i++) {
        const wcut_deviation *d = &deviation[i];
        if (d->place > WCUT_PLACE_BORDER) continue;
        const double share[3] = {1 - d->u - d->v, d->u, d->v};
        for (int k = 0; k < 3; k++) {
            const int to = mesh->triangle[3 * (size_t)d->triangle + k];
            sum[to] += share[k] * d->distance;
            weight[to] += share[k];
        }
    }
    return WCUT_OK;
}

/* ---- values ---- */

/* sums over all rows and columns before: (rows + 1) x (columns + 1), so that a window is four of them */
static void deviation_map_add_up(const wcut_face_map *m, const double *from, double *to) {
    const size_t wide = (size_t)m->columns + 1;
    for (int r = 0; r < m->rows; r++) {
        double row = 0;
        for (int c = 0; c < m->columns; c++) {
            row += from[(size_t)r * m->columns + c];
            to[(size_t)(r + 1) * wide + c + 1] = to[(size_t)r * wide + c + 1] + row;
        }
    }
}

static double window(const wcut_face_map *m, const double *sums, int r, int c, int up, int side) {
    const int r0 = r > up ? r - up : 0, r1 = r + up < m->rows ? r + up + 1 : m->rows;
    const int c0 = c > side ? c - side : 0, c1 = c + side < m->columns ? c + side + 1 : m->columns;
    const size_t wide = (size_t)m->columns + 1;
    return sums[r1 * wide + c1] - sums[r0 * wide + c1] - sums[r1 * wide + c0] + sums[r0 * wide + c0];
}

/* the mean length of the grid's steps in a direction, where it has any */
static double deviation_map_step_of(const wcut_face *f, bool along_row) {
    double length = 0;
    int count = 0;
    for (int r = 0; r + !along_row < f->stations; r++)
        for (int c = 0; c + along_row < f->nodes; c++) {
            const size_t i = (size_t)r * f->nodes + c, j = along_row ? i + 1 : i + (size_t)f->nodes;
            if (!f->inside[i] || !f->inside[j]) continue;
            length += vec3_distance(f->point[i], f->point[j]);
            count++;
        }
    return length > 0 ? length / count : 1;
}

/* how many steps a support reaches */
static int deviation_map_reach_of(double support, double step, int max) { return (int)clamp(support / step, 0, max); }

static double deviation_map_missing_area(const wcut_face *f, const unsigned char *present) {
    double area = 0;
    for (int r = 0; r + 1 < f->stations; r++)
        for (int c = 0; c + 1 < f->nodes; c++) {
            const size_t i = (size_t)r * f->nodes + c, j = i + (size_t)f->nodes;
            const wcut_vec3 p = f->point[i], q = f->point[i + 1], s = f->point[j], t = f->point[j + 1];
            const double cell = (vec3_length(vec3_cross(vec3_sub(q, p), vec3_sub(s, p))) +
                                 vec3_length(vec3_cross(vec3_sub(q, t), vec3_sub(s, t)))) /
                                2;
            area += cell * (4 - present[i] - present[i + 1] - present[j] - present[j + 1]) / 4;
        }
    return area;
}

wcut_status wcut_face_map_eval(const wcut_face_map *map, const wcut_face *face, double support, double *value,
                               unsigned char *present, double *area) {
    if (!map || !face || !value || !present || !isfinite(support) || support < 0 || map->rows != face->stations ||
        map->columns != face->nodes)
        return WCUT_BAD_ARGUMENT;
    const size_t corners = ((size_t)map->rows + 1) * ((size_t)map->columns + 1);
    double *sums = wcut_alloc(corners, sizeof *sums), *weights = wcut_alloc(corners, sizeof *weights);
    const wcut_status status = sums && weights ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        /* running sums, so that any window is four terms */
        deviation_map_add_up(map, map->sum, sums);
        deviation_map_add_up(map, map->weight, weights);

        /* [cells] how far the windows may grow */
        const int up_max = deviation_map_reach_of(support, deviation_map_step_of(face, false), map->rows),
                  side_max = deviation_map_reach_of(support, deviation_map_step_of(face, true), map->columns);
        const int max = up_max > side_max ? up_max : side_max;

        /* the smallest window of each cell that holds enough weight */
        for (int r = 0; r < map->rows; r++)
            for (int c = 0; c < map->columns; c++) {
                double sum = 0, weight = 0;
                for (int k = 0; k <= max && weight < MIN; k++) {
                    const int up = k < up_max ? k : up_max, side = k < side_max ? k : side_max;
                    sum = window(map, sums, r, c, up, side);
                    weight = window(map, weights, r, c, up, side);
                }
                const size_t i = (size_t)r * map->columns + c;
                present[i] = weight > 1e-3;
                value[i] = present[i] ? sum / weight : 0;
            }
        if (area) *area = deviation_map_missing_area(face, present);
    }

    wcut_free(weights);
    wcut_free(sums);
    return status;
}
