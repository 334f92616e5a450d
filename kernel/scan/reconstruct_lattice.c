/* A structured grid over a face: lines so dense that neighbours are nowhere further apart than asked for. */
#include "scan/reconstruct_lattice.h"

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"

enum { ACROSS = 33, ALONG_MIN = 64, ALONG_MAX = 4096 };

static void reconstruct_lattice_spread(int count, const double *first, const double *last, double *at) {
    for (int i = 0; i < count; i++) at[i] = *first + (*last - *first) * i / (count - 1);
}

/* the way along u (or v) to each of `along` parameters, that of the longest of some lines at every step */
static wcut_status reconstruct_lattice_measure(const wcut_surface *surface, int by_u, int along, const double *at,
                                               const double *across, double *way) {
    wcut_vec3 *point = wcut_alloc((size_t)along * ACROSS, sizeof *point);
    if (!point) return WCUT_NO_MEMORY;
    const wcut_status status = by_u ? wcut_surface_eval_grid(surface, along, at, ACROSS, across, point)
                                    : wcut_surface_eval_grid(surface, ACROSS, across, along, at, point);
    const int step = by_u ? 1 : ACROSS, line = by_u ? along : 1;
    way[0] = 0;
    for (int i = 1; i < along && status == WCUT_OK; i++) {
        double max = 0;
        for (int k = 0; k < ACROSS; k++)
            max = fmax(max, vec3_distance(point[k * line + i * step], point[k * line + (i - 1) * step]));
        way[i] = way[i - 1] + max;
    }
    wcut_free(point);
    return status;
}

/* `count` parameters at equal steps of the way */
static void place_lines(int along, const double *at, const double *way, int count, double *line) {
    int k = 0;
    for (int i = 0; i < count; i++) {
        const double target = way[along - 1] * i / (count - 1);
        while (k < along - 2 && way[k + 1] < target) k++;
        const double step = way[k + 1] - way[k];
        line[i] = at[k] + (step > 0 ? clamp((target - way[k]) / step, 0, 1) : 0) * (at[k + 1] - at[k]);
    }
    line[0] = at[0];
    line[count - 1] = at[along - 1];
}

/* one direction measured: parameters and the way to them */
typedef struct ruler {
    int count;
    double *at, *way;
} ruler;

static wcut_status make_ruler(const wcut_surface *surface, int by_u, ruler *r) {
    double first[2], last[2], across[ACROSS];
    wcut_surface_domain(surface, first, last);
    const double control = 8.0 * (by_u ? surface->count_u : surface->count_v);
    r->count = (int)clamp(control, ALONG_MIN, ALONG_MAX);
    r->at = wcut_alloc((size_t)r->count, sizeof *r->at);
    r->way = wcut_alloc((size_t)r->count, sizeof *r->way);
    if (!r->at || !r->way) return WCUT_NO_MEMORY;
    reconstruct_lattice_spread(r->count, &first[!by_u], &last[!by_u], r->at);
    reconstruct_lattice_spread(ACROSS, &first[by_u], &last[by_u], across);
    const wcut_status status = reconstruct_lattice_measure(surface, by_u, r->count, r->at, across, r->way);
    return status == WCUT_OK && !is_positive(r->way[r->count - 1]) ? WCUT_DEGENERATE : status;
}

static void reconstruct_lattice_find_normals(const wcut_surface *surface, int threads, wcut_lattice *l) {
#pragma omp parallel for schedule(static) num_threads(wcut_threads(threads))
    for (int j = 0; j < l->rows; j++)
        for (int i = 0; i < l->columns; i++) {
            wcut_vec3 d[4];
            /* cannot fail: the surface is valid */
            (void)wcut_surface_eval(surface, l->u[i], l->v[j], 1, d);
            l->normal[j * l->columns + i] = vec3_unit(vec3_cross(d[2], d[1]));
        }
}

static wcut_status reconstruct_lattice_fill(const wcut_surface *surface, const ruler *u, const ruler *v, double spacing,
                                            int threads, wcut_lattice *l) {
    const double columns = ceil(u->way[u->count - 1] / spacing) + 1, rows = ceil(v->way[v->count - 1] / spacing) + 1;
    if (!(columns * rows <= WCUT_LATTICE_MAX)) return WCUT_BAD_ARGUMENT;
    l->columns = (int)columns;
    l->rows = (int)rows;
    const size_t nodes = (size_t)lattice_nodes(l);
    l->u = wcut_alloc((size_t)l->columns, sizeof *l->u);
    l->v = wcut_alloc((size_t)l->rows, sizeof *l->v);
    l->point = wcut_alloc(nodes, sizeof *l->point);
    l->normal = wcut_alloc(nodes, sizeof *l->normal);
    if (!l->u || !l->v || !l->point || !l->normal) return WCUT_NO_MEMORY;
    place_lines(u->count, u->at, u->way, l->columns, l->u);
    place_lines(v->count, v->at, v->way, l->rows, l->v);
    reconstruct_lattice_find_normals(surface, threads, l);
    return wcut_surface_eval_grid(surface, l->columns, l->u, l->rows, l->v, l->point);
}

wcut_status wcut_lattice_build(const wcut_surface *surface, double spacing, int threads, wcut_lattice *lattice) {
    ruler u = {0}, v = {0};
    wcut_lattice l = {0};
    wcut_status status = make_ruler(surface, 1, &u);
    if (status == WCUT_OK) status = make_ruler(surface, 0, &v);
    if (status == WCUT_OK) status = reconstruct_lattice_fill(surface, &u, &v, spacing, threads, &l);
    if (status == WCUT_OK)
        *lattice = l;
    else
        wcut_lattice_clear(&l);
    wcut_free(u.at), wcut_free(u.way);
    wcut_free(v.at), wcut_free(v.way);
    return status;
}

void wcut_lattice_clear(wcut_lattice *lattice) {
    wcut_free(lattice->u);
    wcut_free(lattice->v);
    wcut_free(lattice->point);
    wcut_free(lattice->normal);
    *lattice = (wcut_lattice){0};
}

/* the last line but one that is not above x */
static int line_before(int count, const double *line, double x) {
    int low = 0, high = count - 1;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (line[middle] > x)
            high = middle;
        else
            low = middle;
    }
    return low;
}

wcut_lattice_place wcut_lattice_locate(const wcut_lattice *l, double u, double v) {
    const int i = line_before(l->columns, l->u, u), j = line_before(l->rows, l->v, v);
    const double wide = l->u[i + 1] - l->u[i], high = l->v[j + 1] - l->v[j];
    return (wcut_lattice_place){j * l->columns + i, (float)(wide > 0 ? clamp((u - l->u[i]) / wide, 0, 1) : 0),
                                (float)(high > 0 ? clamp((v - l->v[j]) / high, 0, 1) : 0)};
}
