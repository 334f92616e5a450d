/* Triangle meshes: ownership, and a nodal field carried over to the vertices. */
#include <limits.h>
#include <wirecut/mesh.h>

#include "base/alloc.h"
#include "base/numbers.h"

void wcut_mesh_destroy(wcut_mesh *mesh) {
    if (!mesh) return;
    wcut_free(mesh->vertex);
    wcut_free(mesh->normal);
    wcut_free(mesh->uv);
    wcut_free(mesh->scalar);
    wcut_free(mesh->triangle);
    wcut_free(mesh);
}

wcut_status wcut_mesh_create(int vertex_count, int triangle_count, unsigned parts, wcut_mesh **mesh) {
    const unsigned all = WCUT_MESH_NORMAL | WCUT_MESH_UV | WCUT_MESH_SCALAR;
    if (vertex_count < 0 || triangle_count < 0 || triangle_count > INT_MAX / 3 || (parts & ~all) || !mesh)
        return WCUT_BAD_ARGUMENT;

    /* room for the parts asked for */
    wcut_mesh *m = wcut_alloc(1, sizeof *m);
    if (!m) return WCUT_NO_MEMORY;
    m->vertex_count = vertex_count;
    m->triangle_count = triangle_count;
    m->vertex = wcut_alloc((size_t)vertex_count, sizeof *m->vertex);
    m->triangle = wcut_alloc((size_t)triangle_count, 3 * sizeof *m->triangle);
    if (parts & WCUT_MESH_NORMAL) m->normal = wcut_alloc((size_t)vertex_count, sizeof *m->normal);
    if (parts & WCUT_MESH_UV) m->uv = wcut_alloc((size_t)vertex_count, 2 * sizeof *m->uv);
    if (parts & WCUT_MESH_SCALAR) m->scalar = wcut_alloc((size_t)vertex_count, sizeof *m->scalar);

    /* all or nothing */
    if (!m->vertex || !m->triangle || (!m->normal && (parts & WCUT_MESH_NORMAL)) ||
        (!m->uv && (parts & WCUT_MESH_UV)) || (!m->scalar && (parts & WCUT_MESH_SCALAR))) {
        wcut_mesh_destroy(m);
        return WCUT_NO_MEMORY;
    }
    *mesh = m;

    return WCUT_OK;
}

/* the last station whose parameter is not above v, such that there is one after it */
static int station_before(int stations, const double *parameter, double v) {
    int low = 0, high = stations - 1;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (parameter[middle] > v) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return low;
}

static double bilinear(int stations, int nodes, const double *parameter, const double *field, double u, double v) {
    const int j = station_before(stations, parameter, v);
    const double wide = parameter[j + 1] - parameter[j];
    const double t = wide > 0 ? clamp((v - parameter[j]) / wide, 0, 1) : 0;
    const double place = clamp(u, 0, 1) * (nodes - 1);
    const int i = place < nodes - 2 ? (int)place : nodes - 2;
    const double s = place - i;
    const double *row = field + (ptrdiff_t)j * nodes + i, *next = row + nodes;
    return (1 - t) * ((1 - s) * row[0] + s * row[1]) + t * ((1 - s) * next[0] + s * next[1]);
}

wcut_status wcut_mesh_sample(wcut_mesh *mesh, int stations, int nodes, const double *parameter, const double *field) {
    if (!mesh || !mesh->uv || stations < 2 || nodes < 2 || nodes > INT_MAX / stations || !parameter || !field ||
        !all_finite(stations, parameter) || !all_finite(stations * nodes, field) ||
        !all_finite(2 * mesh->vertex_count, mesh->uv))
        return WCUT_BAD_ARGUMENT;
    for (int j = 1; j < stations; j++)
        if (parameter[j] < parameter[j - 1]) return WCUT_BAD_ARGUMENT;
    if (!mesh->scalar) mesh->scalar = wcut_alloc((size_t)mesh->vertex_count, sizeof *mesh->scalar);
    if (!mesh->scalar) return WCUT_NO_MEMORY;
    for (int k = 0; k < mesh->vertex_count; k++)
        mesh->scalar[k] =
            bilinear(stations, nodes, parameter, field, mesh->uv[2 * (size_t)k], mesh->uv[2 * (size_t)k + 1]);
    return WCUT_OK;
}
