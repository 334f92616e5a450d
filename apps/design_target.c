/* The target of a design as a file: a mesh, a cloud, placed in the block. */
#include "design_target.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "terminal.h"

enum { MATRIX = 12 };

/* numbers with commas; false where there are more or fewer than `count`, or other words */
static bool read_number_list(const char *text, int count, double *number) {
    for (int k = 0; k < count; k++) {
        char *end;
        number[k] = strtod(text, &end);
        if (end == text || !isfinite(number[k]) || *end != (k + 1 < count ? ',' : 0)) return false;
        text = end + 1;
    }
    return true;
}

int app_design_block(const char *text, wcut_vec3 *block) {
    double size[3];
    if (!read_number_list(text, 3, size) || !(size[0] > 0 && size[1] > 0 && size[2] > 0))
        return app_fail(APP_USAGE, "--block: found \"%.60s\", expected three positive lengths in mm: W,L,H", text);
    *block = (wcut_vec3){size[0], size[1], size[2]};
    return APP_DONE;
}

/* ---- where it stands ---- */

/* the motion that an option asks for; centred: the middle of the target's box in the middle of the block */
static int find_place(const char *text, wcut_vec3 block, int count, const wcut_vec3 *point, wcut_registration *place) {
    *place = wcut_registration_none();
    double matrix[MATRIX];
    if (strcmp(text, "identity") == 0) return APP_DONE;
    if (strcmp(text, "centred") != 0) {
        if (!read_number_list(text, MATRIX, matrix))
            return app_fail(
                APP_USAGE,
                "--place: found \"%.60s\", expected identity, centred or 12 numbers with commas, the rows of "
                "a 3 x 4 matrix",
                text);
        memcpy(place->matrix, matrix, sizeof matrix);
        return APP_DONE;
    }
    wcut_vec3 low = point[0], high = point[0];
    for (int k = 1; k < count; k++) {
        low = (wcut_vec3){fmin(low.x, point[k].x), fmin(low.y, point[k].y), fmin(low.z, point[k].z)};
        high = (wcut_vec3){fmax(high.x, point[k].x), fmax(high.y, point[k].y), fmax(high.z, point[k].z)};
    }
    place->matrix[3] = block.x / 2 - (low.x + high.x) / 2;
    place->matrix[7] = block.y / 2 - (low.y + high.y) / 2;
    place->matrix[11] = block.z / 2 - (low.z + high.z) / 2;
    return APP_DONE;
}

/* ---- the kinds of files ---- */

static bool is_named(const char *path, const char *const *ending) {
    const char *dot = strrchr(path, '.');
    for (; dot && *ending; ending++)
        if (strcasecmp(dot, *ending) == 0) return true;
    return false;
}

static int load_target_cloud(const app_call *call, const char *path, wcut_vec3 block, wcut_design_target **target) {
    wcut_error error = {0};
    wcut_cloud_options options = wcut_cloud_options_default();
    wcut_cloud *cloud = NULL;
    wcut_registration place;
    options.unit = (wcut_length_unit)app_choice(call, "unit");
    wcut_status status = wcut_cloud_read(path, &options, &cloud, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);

    /* placed, then taken */
    int code = find_place(app_text(call, "place"), block, cloud->count, cloud->point, &place);
    if (code == APP_DONE) {
        status = wcut_registration_move(&place, cloud->count, cloud->point, NULL);
        if (status == WCUT_OK)
            status = wcut_design_target_from_points(cloud->count, cloud->point, block, target, &error);
        if (status != WCUT_OK) code = app_fail_status(status, path, &error);
    }
    wcut_cloud_destroy(cloud);
    return code;
}

static int load_target_mesh(const app_call *call, const char *path, wcut_vec3 block, wcut_design_target **target) {
    wcut_error error = {0};
    wcut_mesh_read_options options = wcut_mesh_read_options_default();
    wcut_mesh *mesh = NULL;
    wcut_registration place;
    options.unit = (wcut_length_unit)app_choice(call, "unit");
    wcut_status status = wcut_mesh_read(path, &options, &mesh, NULL, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);

    /* placed, then taken */
    int code = find_place(app_text(call, "place"), block, mesh->vertex_count, mesh->vertex, &place);
    if (code == APP_DONE) {
        status = wcut_registration_move(&place, mesh->vertex_count, mesh->vertex, NULL);
        if (status == WCUT_OK) status = wcut_design_target_from_mesh(mesh, block, target, &error);
        if (status != WCUT_OK) code = app_fail_status(status, path, &error);
    }
    wcut_mesh_destroy(mesh);
    return code;
}

/* whether a PLY file has faces: the header says so within its first kilobytes */
static bool has_faces(const char *path) {
    char head[4096] = {0};
    FILE *file = fopen(path, "rb");
    if (!file) return true;
    const size_t size = fread(head, 1, sizeof head - 1, file);
    fclose(file);
    for (size_t k = 0; k < size; k++)
        if (head[k] == 0) head[k] = ' ';
    const char *element = strstr(head, "element face ");
    return element && strtol(element + 13, NULL, 10) > 0;
}

int app_design_target_load(const app_call *call, const char *path, wcut_vec3 block, wcut_design_target **target) {
    static const char *const mesh[] = {".stl", ".obj", ".off", ".glb", ".gltf", NULL}, *const ply[] = {".ply", NULL};
    static const char *const cad[] = {".step", ".stp", ".iges", ".igs", NULL};
    if (is_named(path, cad))
        return app_fail(
            APP_BAD_INPUT,
            "%s: found a CAD file, expected a mesh (.stl .obj .ply .off .glb) or a cloud (.xyz .csv .pts .ply "
            ".pcd .las); export the surface as a mesh with a fine tolerance",
            path);
    if (is_named(path, mesh) || (is_named(path, ply) && has_faces(path)))
        return load_target_mesh(call, path, block, target);
    return load_target_cloud(call, path, block, target);
}
