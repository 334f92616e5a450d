/* Triangles to binary STL and OBJ, and the frame that all mesh writers share. */
#include "io/mesh/mesh_write.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>
#include <wirecut/write.h>

#include "base/fail.h"
#include "io/file/number.h"
#include "io/mesh/stl.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "binary files are written as they lie in memory");

/* ---- the frame ---- */

/* beyond it single precision and squares of products are in danger; no wire gets there */
#define COORDINATE_MAX 1e30

static bool is_mesh_sound(double x) { return fabs(x) <= COORDINATE_MAX; /* false for nan, too */ }

static bool is_sound_point(wcut_vec3 a) { return is_mesh_sound(a.x) && is_mesh_sound(a.y) && is_mesh_sound(a.z); }

/* the vertex at which something is not finite, -1 where none is */
static int find_odd_vertex(const wcut_mesh *mesh) {
    for (int i = 0; i < mesh->vertex_count; i++) {
        bool ok = is_sound_point(mesh->vertex[i]) && (!mesh->normal || is_sound_point(mesh->normal[i])) &&
                  (!mesh->scalar || is_mesh_sound(mesh->scalar[i])) &&
                  (!mesh->uv || (is_mesh_sound(mesh->uv[2 * (size_t)i]) && is_mesh_sound(mesh->uv[2 * (size_t)i + 1])));
        if (!ok) return i;
    }
    return -1;
}

static int find_odd_triangle(const wcut_mesh *mesh) {
    for (int t = 0; t < mesh->triangle_count; t++) {
        const int *v = mesh->triangle + 3 * (size_t)t;
        for (int k = 0; k < 3; k++)
            if (v[k] < 0 || v[k] >= mesh->vertex_count) return t;
    }
    return -1;
}

wcut_status wcut_mesh_check(const wcut_mesh *mesh, const char *path, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    if (!path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "the path of a mesh is NULL");
    wcut_quote(name, path, WCUT_LABEL_MAX, 1);
    if (!mesh || mesh->vertex_count < 3 || mesh->triangle_count < 1 || !mesh->vertex || !mesh->triangle)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found no mesh, expected at least one triangle", name);
    int v = find_odd_vertex(mesh), t = find_odd_triangle(mesh);
    if (v >= 0)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "%s: vertex %d: found nan, inf or more than 1e30, expected finite numbers", name, v);
    if (t >= 0)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: triangle %d: found a vertex outside 0 .. %d", name, t,
                         mesh->vertex_count - 1);
    return WCUT_OK;
}

/* a mesh in a format */
typedef struct meshed {
    const wcut_mesh *mesh;
    wcut_mesh_put *put;
    const void *context; /* of put */
} meshed;

static bool put_mesh(wcut_text *text, const void *context) {
    const meshed *m = context;
    m->put(text, m->mesh, m->context);
    return true;
}

wcut_status wcut_mesh_write(const wcut_mesh *mesh, wcut_mesh_put *put, const void *context, const char *path,
                            wcut_error *error) {
    const meshed whole = {mesh, put, context};
    const wcut_status status = wcut_mesh_check(mesh, path, error);
    return status == WCUT_OK ? wcut_text_write_file(path, put_mesh, &whole, error) : status;
}

void wcut_range(int count, const double *value, double *min, double *greatest) {
    *min = *greatest = value[0];
    for (int i = 1; i < count; i++) {
        if (value[i] < *min) *min = value[i];
        if (value[i] > *greatest) *greatest = value[i];
    }
}

/* ---- STL ---- */

static void put_stl(wcut_text *text, const wcut_mesh *mesh, const void *context) {
    (void)context;
    wcut_stl_put_header(text, (uint32_t)mesh->triangle_count);
    wcut_stl_put_facets(text, (size_t)mesh->triangle_count, mesh->vertex, mesh->triangle);
}

wcut_status wcut_mesh_write_stl(const wcut_mesh *mesh, const char *path, wcut_error *error) {
    return wcut_mesh_write(mesh, put_stl, NULL, path, error);
}

/* ---- OBJ ---- */

/* "v 1 2.5 3\n" */
static void put_mesh_line(wcut_text *text, const char *word, int count, const double *value) {
    char *room = wcut_text_room(text);
    size_t used = strlen(word);
    memcpy(room, word, used);
    for (int k = 0; k < count; k++) {
        room[used++] = ' ';
        used += (size_t)wcut_number_print(value[k], room + used);
    }
    room[used++] = '\n';
    text->count += used;
}

static size_t print_index(char *room, int index) {
    char reversed[12];
    size_t n = 0;
    for (unsigned rest = (unsigned)index; rest > 0; rest /= 10) reversed[n++] = (char)('0' + rest % 10);
    for (size_t i = 0; i < n; i++) room[i] = reversed[n - 1 - i];
    return n;
}

/* "f 1/1/1 2/2/2 3/3/3": position, texture and normal of a vertex have one index */
static void put_mesh_face(wcut_text *text, const wcut_mesh *mesh, const int *v) {
    char *room = wcut_text_room(text);
    size_t used = 0;
    room[used++] = 'f';
    for (int k = 0; k < 3; k++) {
        room[used++] = ' ';
        used += print_index(room + used, v[k] + 1);
        if (!mesh->uv && !mesh->normal) continue;
        room[used++] = '/';
        if (mesh->uv) used += print_index(room + used, v[k] + 1);
        if (!mesh->normal) continue;
        room[used++] = '/';
        used += print_index(room + used, v[k] + 1);
    }
    room[used++] = '\n';
    text->count += used;
}

static void put_plain_obj(wcut_text *text, const wcut_mesh *mesh, const void *context) {
    (void)context;
    wcut_text_print(text, "# wirecut %s\n# units: mm, z up\n# %d vertices, %d triangles\no surface\n", WCUT_VERSION,
                    mesh->vertex_count, mesh->triangle_count);
    for (int i = 0; i < mesh->vertex_count; i++) put_mesh_line(text, "v", 3, &mesh->vertex[i].x);
    for (int i = 0; mesh->uv && i < mesh->vertex_count; i++) put_mesh_line(text, "vt", 2, mesh->uv + 2 * (size_t)i);
    for (int i = 0; mesh->normal && i < mesh->vertex_count; i++) put_mesh_line(text, "vn", 3, &mesh->normal[i].x);
    for (size_t t = 0; t < (size_t)mesh->triangle_count; t++) put_mesh_face(text, mesh, mesh->triangle + 3 * t);
}

wcut_status wcut_mesh_write_obj(const wcut_mesh *mesh, const char *path, wcut_error *error) {
    return wcut_mesh_write(mesh, put_plain_obj, NULL, path, error);
}
