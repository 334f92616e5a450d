/* Any bytes as a mesh; the first says in which format: refused in one printable line, or triangles of its vertices. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "io/mesh/mesh_formats.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

static void check_refusal(const wcut_error *error, wcut_status status, const wcut_mesh *mesh) {
    check(mesh == NULL && status == WCUT_BAD_FORMAT && error->status == status && error->text[0] != '\0');
    for (const char *p = error->text; *p; p++) check((unsigned char)*p >= 0x20 && *p != 0x7f);
}

static void check_mesh(const wcut_mesh *m, const wcut_mesh_read_info *info) {
    check(m->triangle_count > 0 && m->vertex_count > 1);
    for (int i = 0; i < m->vertex_count; i++) {
        const wcut_vec3 p = m->vertex[i];
        check(fabs(p.x) <= 1e12 && fabs(p.y) <= 1e12 && fabs(p.z) <= 1e12);
        check(p.x >= info->low.x && p.y >= info->low.y && p.z >= info->low.z);
        check(p.x <= info->high.x && p.y <= info->high.y && p.z <= info->high.z);
    }
    for (int t = 0; t < m->triangle_count; t++) {
        const int *v = m->triangle + 3 * (size_t)t;
        for (int k = 0; k < 3; k++) check(v[k] >= 0 && v[k] < m->vertex_count && v[k] != v[(k + 1) % 3]);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const wcut_mesh_format format[] = {WCUT_MESH_FORMAT_STL, WCUT_MESH_FORMAT_PLY, WCUT_MESH_FORMAT_OBJ};
    wcut_mesh_read_options options = wcut_mesh_read_options_default();
    wcut_mesh *mesh = NULL;
    wcut_mesh_read_info info;
    wcut_error error = {WCUT_OK, ""};
    if (size < 1) return 0;
    options.format = format[data[0] % 3];
    const wcut_status status = wcut_mesh_read_memory(data + 1, size - 1, 1024, "fuzz", &options, &mesh, &info, &error);
    if (status == WCUT_OK)
        check_mesh(mesh, &info);
    else
        check_refusal(&error, status, mesh);
    wcut_mesh_destroy(mesh);
    return 0;
}
