/* The target of a design as a file: faces of CAD, a mesh, a cloud, placed in the block. */
#include "design_target.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "terminal.h"

enum { MATRIX = 12 };

#define BOX_MM 0.01 /* a surface's box is wider than it by no more */

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
static int find_place(const char *text, wcut_vec3 block, wcut_box box, wcut_registration *place) {
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
    place->matrix[3] = block.x / 2 - (box.low.x + box.high.x) / 2;
    place->matrix[7] = block.y / 2 - (box.low.y + box.high.y) / 2;
    place->matrix[11] = block.z / 2 - (box.low.z + box.high.z) / 2;
    return APP_DONE;
}

/* a box that holds points too; one without any is {HUGE_VAL, -HUGE_VAL} */
static void hold_points(wcut_box *box, int count, const wcut_vec3 *point) {
    for (int k = 0; k < count; k++) {
        const wcut_vec3 p = point[k];
        box->low = (wcut_vec3){fmin(box->low.x, p.x), fmin(box->low.y, p.y), fmin(box->low.z, p.z)};
        box->high = (wcut_vec3){fmax(box->high.x, p.x), fmax(box->high.y, p.y), fmax(box->high.z, p.z)};
    }
}

static const wcut_box no_box = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};

static int place_points(const app_call *call, wcut_vec3 block, int count, wcut_vec3 *point) {
    wcut_registration place;
    wcut_box box = no_box;
    hold_points(&box, count, point);
    const int code = find_place(app_text(call, "place"), block, box, &place);
    if (code != APP_DONE) return code;
    const wcut_status status = wcut_registration_move(&place, count, point, NULL);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, "--place", NULL);
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
    options.unit = (wcut_length_unit)app_choice(call, "unit");
    wcut_status status = wcut_cloud_read(path, &options, &cloud, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);

    /* placed, then taken */
    int code = place_points(call, block, cloud->count, cloud->point);
    if (code == APP_DONE) {
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
    options.unit = (wcut_length_unit)app_choice(call, "unit");
    wcut_status status = wcut_mesh_read(path, &options, &mesh, NULL, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);

    /* placed, then taken */
    int code = place_points(call, block, mesh->vertex_count, mesh->vertex);
    if (code == APP_DONE) {
        status = wcut_design_target_from_mesh(mesh, block, target, &error);
        if (status != WCUT_OK) code = app_fail_status(status, path, &error);
    }
    wcut_mesh_destroy(mesh);
    return code;
}

/* ---- faces of a CAD file ---- */

/* the box of some faces: of their borders, or of all of a surface without any */
static wcut_status find_faces_box(int faces, wcut_trimmed *const *face, wcut_box *box) {
    *box = no_box;
    for (int f = 0; f < faces; f++) {
        wcut_box whole;
        if (face[f]->loops > 0) {
            hold_points(box, face[f]->first[face[f]->loops], face[f]->point);
            continue;
        }
        const wcut_status status = wcut_surface_bounds(face[f]->surface, BOX_MM, &whole);
        if (status != WCUT_OK) return status;
        hold_points(box, 1, &whole.low);
        hold_points(box, 1, &whole.high);
    }
    return WCUT_OK;
}

/* a face where a motion sets it */
static wcut_status move_target_face(const wcut_registration *place, wcut_trimmed *face) {
    const double *m = place->matrix;
    const wcut_affine map = {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[3], m[7], m[11]}};
    wcut_surface *moved = NULL;
    wcut_status status = wcut_surface_transform(face->surface, &map, &moved);
    if (status != WCUT_OK) return status;
    wcut_surface_destroy(face->surface);
    face->surface = moved;
    const int points = face->loops > 0 ? face->first[face->loops] : 0;
    return points > 0 ? wcut_registration_move(place, points, face->point, NULL) : WCUT_OK;
}

/* the face that --face names or numbers from 1; without it all of them */
static int choose_faces(const app_call *call, const char *path, const wcut_trimmed_set *set, int *first, int *faces) {
    *first = 0, *faces = set->count;
    if (!app_given(call, "face")) return APP_DONE;
    const char *choice = app_text(call, "face");
    const int at = wcut_trimmed_set_find(set, choice, strlen(choice));
    if (at < 0)
        return app_fail(APP_BAD_INPUT,
                        "%s: --face: found \"%.60s\", expected the name of one of its %d faces or its number", path,
                        choice, set->count);
    *first = at, *faces = 1;
    return APP_DONE;
}

static int load_target_faces(const app_call *call, const char *path, wcut_vec3 block, wcut_design_target **target) {
    wcut_error error = {0};
    wcut_trimmed_set *set = NULL;
    wcut_registration place;
    wcut_box box;
    int first, faces;
    if (app_choice(call, "unit") != 0)
        return app_fail(APP_USAGE, "--unit: %s states its unit; expected a mesh or a cloud with it", path);
    wcut_status status = wcut_trimmed_set_read(path, &set, &error);
    if (status != WCUT_OK) return app_fail_status(status, error.text[0] ? NULL : path, &error);
    if (set->left_out > 0) app_say("%s: warning: %d left out: %s", path, set->left_out, set->why);

    /* chosen, placed, taken */
    int code = choose_faces(call, path, set, &first, &faces);
    if (code == APP_DONE) {
        status = find_faces_box(faces, set->face + first, &box);
        if (status == WCUT_OK) code = find_place(app_text(call, "place"), block, box, &place);
        for (int f = first; code == APP_DONE && status == WCUT_OK && f < first + faces; f++)
            status = move_target_face(&place, set->face[f]);
        if (code == APP_DONE && status == WCUT_OK)
            status = wcut_design_target_from_faces(faces, (const wcut_trimmed *const *)set->face + first, block, target,
                                                   &error);
        if (status != WCUT_OK) code = app_fail_status(status, path, &error);
    }
    wcut_trimmed_set_destroy(set);
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
    static const char *const cad[] = {".step", ".stp", ".p21", ".iges", ".igs", NULL};
    if (is_named(path, cad)) return load_target_faces(call, path, block, target);
    if (app_given(call, "face"))
        return app_fail(APP_USAGE, "--face: %s has no named faces; expected a CAD file with it, .step or .iges", path);
    if (is_named(path, mesh) || (is_named(path, ply) && has_faces(path)))
        return load_target_mesh(call, path, block, target);
    return load_target_cloud(call, path, block, target);
}
