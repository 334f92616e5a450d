/* Triangles to binary PLY: exact doubles, a scalar by name and as a vertex colour. */
#include <stdint.h>
#include <string.h>
#include <wirecut/version.h>
#include <wirecut/write.h>

#include "base/fail.h"
#include "io/mesh/colour.h"
#include "io/mesh/mesh_write.h"

static const char *const letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

/* a property's name is one word, and not one that the file has already */
static bool is_ply_name(const char *name) {
    static const char *const taken[] = {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"};
    if (!name || !*name || strlen(name) > 100 || name[strspn(name, letters)] != '\0') return false;
    for (size_t k = 0; k < sizeof taken / sizeof *taken; k++)
        if (strcmp(name, taken[k]) == 0) return false;
    return true;
}

static void put_ply_header(wcut_text *text, const wcut_mesh *mesh, const char *name, double min, double greatest) {
    wcut_text_print(text, "ply\nformat binary_little_endian 1.0\ncomment wirecut %s\ncomment units: mm, z up\n",
                    WCUT_VERSION);
    if (mesh->scalar) {
        wcut_text_print(text, "comment colour: viridis over %s from ", name);
        wcut_text_number(text, min);
        wcut_text_print(text, " to ");
        wcut_text_number(text, greatest);
        wcut_text_put(text, "\n", 1);
    }
    wcut_text_print(text, "element vertex %d\nproperty double x\nproperty double y\nproperty double z\n",
                    mesh->vertex_count);
    if (mesh->normal) wcut_text_print(text, "property double nx\nproperty double ny\nproperty double nz\n");
    if (mesh->scalar)
        wcut_text_print(text, "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double %s\n",
                        name);
    wcut_text_print(text, "element face %d\nproperty list uchar int vertex_indices\nend_header\n",
                    mesh->triangle_count);
}

static void put_scalar(wcut_text *text, double value, double min, double greatest) {
    double rgb[3];
    unsigned char byte[3];
    wcut_colour(wcut_colour_parameter(value, min, greatest), rgb);
    for (int k = 0; k < 3; k++) byte[k] = (unsigned char)(rgb[k] + 0.5);
    wcut_text_put(text, byte, sizeof byte);
    wcut_text_put(text, &value, sizeof value);
}

static void put_plain_ply(wcut_text *text, const wcut_mesh *mesh, const void *context) {
    double min = 0, greatest = 0;
    if (mesh->scalar) wcut_range(mesh->vertex_count, mesh->scalar, &min, &greatest);
    put_ply_header(text, mesh, context, min, greatest);
    for (int i = 0; i < mesh->vertex_count; i++) {
        wcut_text_put(text, &mesh->vertex[i], sizeof(wcut_vec3));
        if (mesh->normal) wcut_text_put(text, &mesh->normal[i], sizeof(wcut_vec3));
        if (mesh->scalar) put_scalar(text, mesh->scalar[i], min, greatest);
    }
    for (size_t t = 0; t < (size_t)mesh->triangle_count; t++) {
        int32_t corner[3] = {mesh->triangle[3 * t], mesh->triangle[3 * t + 1], mesh->triangle[3 * t + 2]};
        char *room = wcut_text_room(text);
        room[0] = 3;
        memcpy(room + 1, corner, sizeof corner);
        text->count += 1 + sizeof corner;
    }
}

wcut_status wcut_mesh_write_ply(const wcut_mesh *mesh, const char *name, const char *path, wcut_error *error) {
    char quote[WCUT_QUOTE_SIZE];
    if (mesh && mesh->scalar && !is_ply_name(name))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a PLY property: found the name \"%s\", expected letters, digits and _, not one that the "
                         "file has already",
                         name ? wcut_quote(quote, name, WCUT_FOUND_MAX, 0) : "");
    return wcut_mesh_write(mesh, put_plain_ply, name, path, error);
}
