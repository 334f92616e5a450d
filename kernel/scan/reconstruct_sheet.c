/* The scanned part of a lattice as a mesh, cell by cell, and what of the face is left. */
#include "scan/reconstruct_sheet.h"

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "scan/reconstruct_holes.h"

enum { RING = 4, CELL_TRIANGLES = 2 };

static bool is_covered(const wcut_sheet *s, int k) { return !s->covered || s->covered[k]; }

wcut_status wcut_sheet_raise(const wcut_lattice *lattice, const wcut_field *field, const unsigned char *covered,
                             const wcut_kd_tree *tree, double support, wcut_vec3 block, int threads,
                             wcut_sheet *sheet) {
    const int nodes = lattice_nodes(lattice);

    /* the sheet borrows lattice, field and tree */
    wcut_sheet s = {
        .lattice = lattice, .field = field, .covered = covered, .tree = tree, .support = support, .block = block};
    s.vertex = wcut_alloc((size_t)nodes, sizeof *s.vertex);
    s.distance = wcut_alloc((size_t)nodes, sizeof *s.distance);
    if (!s.vertex || !s.distance) {
        wcut_sheet_clear(&s);
        return WCUT_NO_MEMORY;
    }
    /* just beyond the support, so that what is as far as that still counts */
    const double limit = nextafter(support, INFINITY);
#pragma omp parallel for schedule(dynamic, 1024) num_threads(wcut_threads(threads))
    for (int k = 0; k < nodes; k++) {
        const bool usable =
            field->active[k] && is_covered(&s, k) && vec3_dot(lattice->normal[k], lattice->normal[k]) > 0;
        s.vertex[k] = vec3_add_scaled(lattice->point[k], usable ? field->height[k] : 0, lattice->normal[k]);
        s.distance[k] = usable ? wcut_kd_tree_distance(tree, s.vertex[k], limit) : limit;
    }
    *sheet = s;

    return WCUT_OK;
}

void wcut_sheet_clear(wcut_sheet *sheet) {
    wcut_free(sheet->vertex);
    wcut_free(sheet->distance);
    *sheet = (wcut_sheet){0};
}

static bool is_measured(const wcut_sheet *s, int k) { return s->distance[k] <= s->support; }

/* the corners of a cell, counter-clockwise */
static void ring_of(const wcut_sheet *s, int cell, int ring[RING]) {
    ring[0] = cell, ring[1] = cell + 1, ring[2] = cell + s->lattice->columns + 1, ring[3] = cell + s->lattice->columns;
}

/* up to two triangles of a cell that are measured and up to two that are not, by nodes */
typedef struct split {
    int measured, unmeasured;
    int yes[CELL_TRIANGLES][3], no[CELL_TRIANGLES][3];
} split;

static void reconstruct_sheet_put(int (*triangle)[3], int *count, int a, int b, int c) {
    triangle[*count][0] = a, triangle[*count][1] = b, triangle[(*count)++][2] = c;
}

static split split_cell(const wcut_sheet *s, int cell) {
    /* the ring of the cell's corners, and the one that has no points */
    int ring[RING], count = 0, missing = 0;
    split c = {0};
    ring_of(s, cell, ring);
    for (int a = 0; a < RING; a++) {
        count += is_measured(s, ring[a]);
        if (!is_measured(s, ring[a])) missing = a;
    }

    /* the ring turned so that the missing corner is known by name */
    const int before = ring[(missing + 3) % RING], at = ring[missing], after = ring[(missing + 1) % RING],
              across = ring[(missing + 2) % RING];

    /* four corners: two triangles; three: one on either side; fewer: none is measured */
    if (count == RING) {
        reconstruct_sheet_put(c.yes, &c.measured, ring[0], ring[1], ring[2]);
        reconstruct_sheet_put(c.yes, &c.measured, ring[0], ring[2], ring[3]);
    } else {
        reconstruct_sheet_put(c.no, &c.unmeasured, before, at, after);
        if (count == RING - 1)
            reconstruct_sheet_put(c.yes, &c.measured, after, across, before);
        else
            reconstruct_sheet_put(c.no, &c.unmeasured, after, across, before);
    }

    return c;
}

static double triangle_area(const wcut_vec3 *p, const int t[3]) {
    return vec3_length(vec3_cross(vec3_sub(p[t[1]], p[t[0]]), vec3_sub(p[t[2]], p[t[0]]))) / 2;
}

/* whether a triangle of the lattice counts: the face is there, and its middle in the block */
static bool in_block(const wcut_sheet *s, const int t[3]) {
    const wcut_vec3 *p = s->lattice->point, b = s->block;
    if (!is_covered(s, t[0]) || !is_covered(s, t[1]) || !is_covered(s, t[2])) return false;
    if (!(b.x > 0)) return true;
    const wcut_vec3 m = vec3_scale(1.0 / 3, vec3_add(vec3_add(p[t[0]], p[t[1]]), p[t[2]]));
    return m.x >= 0 && m.x <= b.x && m.y >= 0 && m.y <= b.y && m.z >= 0 && m.z <= b.z;
}

/* [1] share of a cell that is within the support: four places inside it */
static double supported_share(const wcut_sheet *s, int cell) {
    int ring[RING], count = 0;
    ring_of(s, cell, ring);
    for (int a = 0; a < RING; a++)
        if (!s->field->active[ring[a]] || !is_covered(s, ring[a])) return 0;
    for (int a = 0; a < RING; a++) {
        const double x = a % 2 ? 0.75 : 0.25, y = a / 2 ? 0.75 : 0.25;
        const wcut_vec3 low = vec3_mix(s->vertex[ring[0]], s->vertex[ring[1]], x);
        const wcut_vec3 high = vec3_mix(s->vertex[ring[3]], s->vertex[ring[2]], x);
        const double limit = nextafter(s->support, INFINITY);
        count += wcut_kd_tree_distance(s->tree, vec3_mix(low, high, y), limit) < limit;
    }
    return count / 4.0;
}

/* ---- meshes ---- */

/* a list of triangles, by their nodes, in the order in which they are found */
typedef struct list {
    int count;
    int *triangle; /* room for 2 x cells */
} list;

static void reconstruct_sheet_add(list *l, const int t[3]) {
    for (int a = 0; a < 3; a++) l->triangle[3 * l->count + a] = t[a];
    l->count++;
}

double wcut_sheet_normals(wcut_mesh *mesh) {
    double area = 0;
    for (int k = 0; k < mesh->vertex_count; k++) mesh->normal[k] = vec3(0, 0, 0);
    for (int k = 0; k < mesh->triangle_count; k++) {
        const int *t = mesh->triangle + 3 * (size_t)k;
        const wcut_vec3 n = vec3_cross(vec3_sub(mesh->vertex[t[1]], mesh->vertex[t[0]]),
                                       vec3_sub(mesh->vertex[t[2]], mesh->vertex[t[0]]));
        area += vec3_length(n) / 2;
        for (int a = 0; a < 3; a++) mesh->normal[t[a]] = vec3_add(mesh->normal[t[a]], n);
    }
    for (int k = 0; k < mesh->vertex_count; k++) mesh->normal[k] = vec3_unit(mesh->normal[k]);
    return area;
}

/* a mesh of some triangles of the lattice: raised to the scan, or on the face */
static wcut_status make_mesh(const wcut_sheet *s, const list *l, bool raised, wcut_mesh **mesh) {
    const int columns = s->lattice->columns, nodes = lattice_nodes(s->lattice);

    /* number the nodes that are used */
    int count = 0, *place = wcut_alloc((size_t)nodes, sizeof *place);
    if (!place) return WCUT_NO_MEMORY;
    for (int k = 0; k < 3 * l->count; k++) place[l->triangle[k]] = 1;
    for (int k = 0; k < nodes; k++)
        if (place[k]) place[k] = ++count;

    /* a mesh of those nodes, with parameters and normals, and heights where it was raised */
    wcut_mesh *m = NULL;
    const unsigned parts = WCUT_MESH_NORMAL | WCUT_MESH_UV | (raised ? WCUT_MESH_SCALAR : 0);
    const wcut_status status = wcut_mesh_create(count, l->count, parts, &m);
    for (int k = 0; k < nodes && status == WCUT_OK; k++) {
        if (!place[k]) continue;
        const size_t to = (size_t)place[k] - 1;
        m->vertex[to] = raised ? s->vertex[k] : s->lattice->point[k];
        m->normal[to] = s->lattice->normal[k];
        m->uv[2 * to] = s->lattice->u[k % columns];
        m->uv[2 * to + 1] = s->lattice->v[k / columns];
        if (raised) m->scalar[to] = s->field->height[k];
    }

    for (int k = 0; k < 3 * l->count && status == WCUT_OK; k++) m->triangle[k] = place[l->triangle[k]] - 1;
    wcut_free(place);
    if (status == WCUT_OK) *mesh = m;

    return status;
}

/* [mm] of the furthest vertex that is in a triangle */
static double farthest_of(const wcut_sheet *s, const list *l) {
    double max = 0;
    for (int k = 0; k < 3 * l->count; k++) max = fmax(max, s->distance[l->triangle[k]]);
    return max;
}

/* every cell into one list or the other or both; areas of the face */
static void cut_cells(const wcut_sheet *s, list *yes, list *no, double *open_area, unsigned char *outside,
                      wcut_reconstruction *r) {
    const int columns = s->lattice->columns;
    double meshed = 0;

    /* each cell: measured triangles, open ones, and those beyond the block */
    for (int j = 0; j < s->lattice->rows - 1; j++)
        for (int i = 0; i < columns - 1; i++) {
            const int cell = j * columns + i;
            const split c = split_cell(s, cell);
            double own = 0, all = 0, open = 0;

            /* triangles that points support */
            for (int k = 0; k < c.measured; k++) {
                own += triangle_area(s->lattice->point, c.yes[k]);
                reconstruct_sheet_add(yes, c.yes[k]);
            }

            /* triangles without points: open where they are inside the block */
            all = own;
            for (int k = 0; k < c.unmeasured; k++) {
                const double area = triangle_area(s->lattice->point, c.no[k]);
                all += area;
                if (!in_block(s, c.no[k])) {
                    outside[cell] = 1;
                    continue;
                }
                open += area;
                reconstruct_sheet_add(no, c.no[k]);
            }

            /* areas of the cell and of the face */
            open_area[cell] = open;
            meshed += own;
            r->supported_area += c.unmeasured ? fmax(own, all * supported_share(s, cell)) : own;
            r->unmeasured_area += open;
        }

    /* the share of the supported area that has no mesh */
    r->lost = r->supported_area > 0 ? 1 - meshed / r->supported_area : 0;
}

wcut_status wcut_sheet_cut(const wcut_sheet *s, double hole_min, wcut_reconstruction *r) {
    const size_t nodes = (size_t)lattice_nodes(s->lattice);

    /* two lists of triangles: measured and open */
    list yes = {0, wcut_alloc(CELL_TRIANGLES * nodes, 3 * sizeof *yes.triangle)};
    list no = {0, wcut_alloc(CELL_TRIANGLES * nodes, 3 * sizeof *no.triangle)};
    double *open_area = wcut_alloc(nodes, sizeof *open_area);
    unsigned char *outside = wcut_alloc(nodes, 1);
    wcut_status status = yes.triangle && no.triangle && open_area && outside ? WCUT_OK : WCUT_NO_MEMORY;

    /* sort the cells, and mesh the measured ones */
    if (status == WCUT_OK) {
        cut_cells(s, &yes, &no, open_area, outside, r);
        r->farthest = farthest_of(s, &yes);
        status = yes.count ? make_mesh(s, &yes, true, &r->mesh) : WCUT_DEGENERATE;
    }

    /* normals and area of the mesh, then the open part and its holes */
    if (status == WCUT_OK) {
        r->area = wcut_sheet_normals(r->mesh);
        status = make_mesh(s, &no, false, &r->unmeasured);
    }
    if (status == WCUT_OK) status = wcut_holes_find(s->lattice, open_area, outside, hole_min, &r->hole_count, &r->hole);

    wcut_free(yes.triangle);
    wcut_free(no.triangle);
    wcut_free(open_area);
    wcut_free(outside);
    return status;
}
