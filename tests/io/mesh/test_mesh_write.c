/* Meshes out and back in by small readers of their own: STL, OBJ and PLY bit for bit, GLB by its structure. */
#include <jansson.h>
#include <locale.h>
#include <stdbool.h>
#include <stdint.h>
#include <wirecut/write.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/given.h"
#include "io/mesh/colour.h"
#include "test.h"

static wcut_mesh mesh;
static wcut_error error;

static void setup(int rows, int columns) {
    mesh = given_mesh(rows, columns);
    error = (wcut_error){WCUT_OK, ""};
    enter_folder();
}

static void teardown(void) {
    forget_mesh(&mesh);
    leave_folder();
}

static void written(wcut_status status) {
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(count_entries("."), 1);
}

/* ---- STL ---- */

TEST(stl_holds_every_triangle_with_its_normal_outwards) {
    setup(23, 31);
    written(wcut_mesh_write_stl(&mesh, "a.stl", &error));
    size_t length;
    char *bytes = read_back("a.stl", &length);
    uint32_t count;
    memcpy(&count, bytes + 80, sizeof count);
    ck_assert_uint_eq(count, (unsigned)mesh.triangle_count);
    ck_assert_uint_eq(length, 84 + 50 * (size_t)count);
    ck_assert(strstr(bytes, "units: mm") != NULL && strncmp(bytes, "solid", 5) != 0);
    for (size_t t = 0; t < count; t++) {
        float facet[12];
        memcpy(facet, bytes + 84 + 50 * t, sizeof facet);
        for (size_t k = 0; k < 3; k++) {
            wcut_vec3 p = mesh.vertex[mesh.triangle[3 * t + k]];
            ck_assert(facet[3 + 3 * k] == (float)p.x && facet[4 + 3 * k] == (float)p.y &&
                      facet[5 + 3 * k] == (float)p.z);
        }
        wcut_vec3 n = mesh.normal[mesh.triangle[3 * t]];
        double along = facet[0] * n.x + facet[1] * n.y + facet[2] * n.z;
        ck_assert_double_gt(along, 0.99);
        ck_assert_double_eq_tol(
            sqrt((double)facet[0] * facet[0] + (double)facet[1] * facet[1] + (double)facet[2] * facet[2]), 1, 1e-6);
        ck_assert(bytes[84 + 50 * t + 48] == 0 && bytes[84 + 50 * t + 49] == 0);
    }
    free(bytes);
    teardown();
}

TEST(a_triangle_without_area_has_the_normal_zero) {
    setup(2, 2);
    mesh.vertex[1] = mesh.vertex[0];
    written(wcut_mesh_write_stl(&mesh, "a.stl", &error));
    size_t length;
    float normal[3];
    char *bytes = read_back("a.stl", &length);
    memcpy(normal, bytes + 84, sizeof normal);
    ck_assert(normal[0] == 0 && normal[1] == 0 && normal[2] == 0);
    free(bytes);
    teardown();
}

/* A needle: corners 1e-4 mm apart, 300 mm from the origin, where single precision holds steps of 3e-5 mm. */
TEST(a_normal_is_that_of_the_rounded_corners) {
    setup(2, 2);
    mesh.vertex[mesh.triangle[0]] = (wcut_vec3){300.00001, 300.00002, 100.00001};
    mesh.vertex[mesh.triangle[1]] = (wcut_vec3){300.0001, 300.0003, 100.0001};
    mesh.vertex[mesh.triangle[2]] = (wcut_vec3){310.00003, 300.00007, 101.00004};
    written(wcut_mesh_write_stl(&mesh, "a.stl", &error));
    size_t length;
    float facet[12];
    char *bytes = read_back("a.stl", &length);
    memcpy(facet, bytes + 84, sizeof facet);

    /* the cross product of the corners as the file holds them */
    double u[3], v[3];
    for (int k = 0; k < 3; k++) u[k] = (double)facet[6 + k] - facet[3 + k], v[k] = (double)facet[9 + k] - facet[3 + k];
    const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double size = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; k++) ck_assert_double_eq_tol(facet[k], n[k] / size, 1e-6);
    free(bytes);
    teardown();
}

/* ---- OBJ ---- */

/* the next line's numbers after its word, 0 at the end */
static int next_line(char **at, char word[8], double value[9]) {
    int count = 0;
    if (**at == '\0') return 0;
    size_t n = strcspn(*at, " \n");
    snprintf(word, 8, "%.*s", (int)n, *at);
    *at += n;
    if (word[0] == '#' || word[0] == 'o') *at += strcspn(*at, "\n");
    while (**at != '\n') {
        char *end;
        value[count++] = strtod(*at, &end);
        ck_assert_ptr_ne(end, *at);
        *at = end + (*end == '/');
        if (**at == '/') (*at)++; /* a//c */
    }
    (*at)++;
    return 1;
}

static void check_obj(bool with_uv, bool with_normal) {
    size_t length;
    char *text = read_back("a.obj", &length), *at = text, word[8] = "";
    double value[9] = {0};
    int v = 0, vt = 0, vn = 0;
    size_t f = 0;
    ck_assert_ptr_nonnull(strstr(text, "# units: mm"));
    while (next_line(&at, word, value)) {
        if (strcmp(word, "v") == 0) ck_assert(memcmp(value, &mesh.vertex[v++], sizeof(wcut_vec3)) == 0);
        if (strcmp(word, "vt") == 0) ck_assert(memcmp(value, &mesh.uv[2 * vt++], 2 * sizeof(double)) == 0);
        if (strcmp(word, "vn") == 0) ck_assert(memcmp(value, &mesh.normal[vn++], sizeof(wcut_vec3)) == 0);
        if (strcmp(word, "f") != 0) continue;
        int refs = 1 + with_uv + with_normal;
        for (int k = 0; k < 3 * refs; k++) ck_assert(value[k] == mesh.triangle[3 * f + (size_t)(k / refs)] + 1);
        f++;
    }
    ck_assert(v == mesh.vertex_count && f == (size_t)mesh.triangle_count);
    ck_assert(vt == (with_uv ? v : 0) && vn == (with_normal ? v : 0));
    free(text);
}

TEST(obj_comes_back_to_the_last_bit_with_and_without_normals) {
    setup(23, 31);
    double *uv = mesh.uv;
    wcut_vec3 *normal = mesh.normal;
    for (int k = 0; k < 4; k++) {
        mesh.uv = k & 1 ? uv : NULL;
        mesh.normal = k & 2 ? normal : NULL;
        written(wcut_mesh_write_obj(&mesh, "a.obj", &error));
        check_obj(k & 1, k & 2);
    }
    mesh.uv = uv;
    teardown();
}

TEST(obj_knows_no_locale) {
    setup(3, 3);
    ck_assert_msg(setlocale(LC_ALL, "de_DE.UTF-8") != NULL, "the tests' own locale is missing");
    written(wcut_mesh_write_obj(&mesh, "a.obj", &error));
    size_t length;
    char *text = read_back("a.obj", &length);
    ck_assert_ptr_null(strstr(text, "0,"));
    ck_assert_ptr_nonnull(strstr(text, "\nvt 0.5 0.5\n"));
    free(text);
    teardown();
}

/* ---- PLY ---- */

static size_t ply_vertex_size(void) {
    return sizeof(wcut_vec3) + (mesh.normal ? sizeof(wcut_vec3) : 0) + (mesh.scalar ? 3 + sizeof(double) : 0);
}

static void check_ply_vertex(const char *at, int i, double greatest) {
    ck_assert(memcmp(at, &mesh.vertex[i], sizeof(wcut_vec3)) == 0);
    at += sizeof(wcut_vec3);
    if (mesh.normal) {
        ck_assert(memcmp(at, &mesh.normal[i], sizeof(wcut_vec3)) == 0);
        at += sizeof(wcut_vec3);
    }
    if (!mesh.scalar) return;
    double rgb[3];
    wcut_colour(mesh.scalar[i] / greatest, rgb);
    for (int k = 0; k < 3; k++) ck_assert_int_eq((unsigned char)at[k], (int)(rgb[k] + 0.5));
    ck_assert(memcmp(at + 3, &mesh.scalar[i], sizeof(double)) == 0);
}

static void check_ply(void) {
    size_t length;
    char *text = read_back("a.ply", &length), line[64];
    snprintf(line, sizeof line, "element vertex %d\n", mesh.vertex_count);
    ck_assert(strncmp(text, "ply\nformat binary_little_endian 1.0\n", 36) == 0 && strstr(text, line));
    ck_assert(strstr(text, "comment units: mm"));
    ck_assert((strstr(text, "property double force_N_per_mm\n") != NULL) == (mesh.scalar != NULL));
    const char *at = strstr(text, "end_header\n") + 11;
    ck_assert_uint_eq(
        length, (size_t)(at - text) + ply_vertex_size() * (size_t)mesh.vertex_count + 13 * (size_t)mesh.triangle_count);
    for (int i = 0; i < mesh.vertex_count; i++, at += ply_vertex_size()) check_ply_vertex(at, i, 0.02);
    for (size_t t = 0; t < (size_t)mesh.triangle_count; t++, at += 13)
        ck_assert(at[0] == 3 && memcmp(at + 1, mesh.triangle + 3 * t, 12) == 0);
    free(text);
}

TEST(ply_comes_back_to_the_last_bit_with_scalar_and_colour) {
    setup(23, 31);
    written(wcut_mesh_write_ply(&mesh, "force_N_per_mm", "a.ply", &error));
    check_ply();
    free(mesh.scalar);
    mesh.scalar = NULL;
    written(wcut_mesh_write_ply(&mesh, NULL, "a.ply", &error)); /* no scalar, no name needed */
    check_ply();
    free(mesh.normal);
    mesh.normal = NULL;
    written(wcut_mesh_write_ply(&mesh, "", "a.ply", &error));
    check_ply();
    teardown();
}

TEST(a_name_that_is_no_ply_property_is_refused) {
    static const char *const name[] = {"", "two words", "a\nelement face 9", "x", "red", "nz", "\xc3\xa4", NULL};
    setup(2, 2);
    for (int k = 0; k < 8; k++) {
        ck_assert_int_eq(wcut_mesh_write_ply(&mesh, name[k], "a.ply", &error), WCUT_BAD_ARGUMENT);
        ck_assert_ptr_null(strchr(error.text, '\n'));
    }
    ck_assert_int_eq(count_entries("."), 0);
    teardown();
}

/* ---- colour ---- */

static double lightness(const double rgb[3]) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

TEST(colours_grow_lighter_with_the_value_and_stay_in_range) {
    double before = -1;
    for (int i = -10; i <= 1010; i++) {
        double rgb[3];
        wcut_colour(i / 1000.0, rgb);
        for (int k = 0; k < 3; k++) ck_assert(rgb[k] >= 0 && rgb[k] <= 255);
        ck_assert(i <= 0 || i > 1000 || lightness(rgb) > before);
        before = lightness(rgb);
    }
    ck_assert_double_eq(wcut_colour_parameter(3, 1, 5), 0.5);
    ck_assert_double_eq(wcut_colour_parameter(3, 3, 3), 0); /* one value everywhere */
    ck_assert_double_eq(wcut_colour_parameter(0, -1.7e308, 1.7e308), 0.5);
}

/* ---- GLB ---- */

static double number_at(const json_t *array, size_t i) { return json_number_value(json_array_get(array, i)); }

static const json_t *item(const json_t *root, const char *list, size_t i) {
    const json_t *found = json_array_get(json_object_get(root, list), i);
    ck_assert_msg(found != NULL, "no %s[%zu]", list, i);
    return found;
}

/* the chunks of a GLB: the JSON's root; *data and *bytes the binary one */
static json_t *open_glb(const char *glb, size_t length, const char **data, size_t *bytes) {
    uint32_t head[5], tail[2];
    memcpy(head, glb, sizeof head);
    ck_assert(memcmp(glb, "glTF", 4) == 0 && head[1] == 2 && head[2] == length && head[4] == 0x4e4f534a);
    memcpy(tail, glb + 20 + head[3], sizeof tail);
    ck_assert(tail[1] == 0x004e4942 && 28 + head[3] + tail[0] == length && head[3] % 4 == 0);
    *data = glb + 28 + head[3];
    *bytes = tail[0];
    json_t *root = json_loadb(glb + 20, head[3], JSON_REJECT_DUPLICATES, NULL);
    ck_assert_ptr_nonnull(root);
    return root;
}

/* where an accessor's values begin, which all lie within the binary chunk */
static const char *values_of(const json_t *root, size_t accessor, size_t size, size_t *count, const char *data,
                             size_t bytes) {
    const json_t *a = item(root, "accessors", accessor);
    const json_t *view = item(root, "bufferViews", (size_t)json_integer_value(json_object_get(a, "bufferView")));
    size_t at = (size_t)json_integer_value(json_object_get(view, "byteOffset")) +
                (size_t)json_integer_value(json_object_get(a, "byteOffset"));
    *count = (size_t)json_integer_value(json_object_get(a, "count"));
    ck_assert(at + *count * size <= bytes && at % 4 == 0);
    return data + at;
}

/* the root's matrix turns millimetres with z up into metres with y up, from a middle in whole millimetres on */
static wcut_vec3 check_root(const json_t *root) {
    const json_t *node = item(root, "nodes", (size_t)number_at(json_object_get(item(root, "scenes", 0), "nodes"), 0));
    const json_t *matrix = json_object_get(node, "matrix");
    static const double expected[16] = {0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1};
    for (size_t k = 0; k < 16; k++)
        if (k < 12 || k > 14) ck_assert_double_eq_tol(number_at(matrix, k), expected[k], 1e-9);
    const wcut_vec3 from = {1000 * number_at(matrix, 12), -1000 * number_at(matrix, 14), 1000 * number_at(matrix, 13)};
    ck_assert_double_le(fabs(from.x - round(from.x)) + fabs(from.y - round(from.y)) + fabs(from.z - round(from.z)),
                        1e-8);
    ck_assert_ptr_null(json_object_get(node, "mesh"));
    const json_t *child = item(root, "nodes", (size_t)number_at(json_object_get(node, "children"), 0));
    ck_assert(json_integer_value(json_object_get(child, "mesh")) == 0 && json_object_get(child, "mesh"));
    return from;
}

static size_t attribute(const json_t *primitive, const char *name) {
    const json_t *index = json_object_get(json_object_get(primitive, "attributes"), name);
    ck_assert_msg(json_is_integer(index), "no attribute %s", name);
    return (size_t)json_integer_value(index);
}

/* the power of two that is not less than what any coordinate is away from a place */
static double reach_of(wcut_vec3 from) {
    double reach = 0;
    for (int v = 0; v < mesh.vertex_count; v++) {
        const wcut_vec3 p = mesh.vertex[v];
        reach = fmax(reach, fmax(fabs(p.x - from.x), fmax(fabs(p.y - from.y), fabs(p.z - from.z))));
    }
    return exp2(ceil(log2(reach)));
}

/* every triangle's corners, colours and normals are those of the mesh, to half a unit of single precision of the half
   size, read back in double precision */
static void check_triangles(const json_t *root, wcut_vec3 from, const char *data, size_t bytes) {
    const double size = reach_of(from);
    const json_t *primitive = json_array_get(json_object_get(item(root, "meshes", 0), "primitives"), 0);
    size_t vertices, normals, colours, corners;
    const char *p = values_of(root, attribute(primitive, "POSITION"), 12, &vertices, data, bytes);
    const char *n = values_of(root, attribute(primitive, "NORMAL"), 12, &normals, data, bytes);
    const char *c = values_of(root, attribute(primitive, "COLOR_0"), 16, &colours, data, bytes);
    const char *f =
        values_of(root, (size_t)json_integer_value(json_object_get(primitive, "indices")), 4, &corners, data, bytes);
    ck_assert(corners == 3 * (size_t)mesh.triangle_count && normals == vertices && colours == vertices);
    for (size_t k = 0; k < corners; k++) {
        uint32_t index;
        float position[3], normal[3], colour[4];
        memcpy(&index, f + 4 * k, 4);
        ck_assert_uint_lt(index, vertices);
        memcpy(position, p + 12 * (size_t)index, sizeof position);
        memcpy(normal, n + 12 * (size_t)index, sizeof normal);
        memcpy(colour, c + 16 * (size_t)index, sizeof colour);
        int v = mesh.triangle[k];
        const wcut_vec3 x = mesh.vertex[v];
        const double off[3] = {from.x + (double)position[0] - x.x, from.y + (double)position[1] - x.y,
                               from.z + (double)position[2] - x.z};
        for (int i = 0; i < 3; i++) ck_assert_double_le(fabs(off[i]), ldexp(size, -25) + 2e-9);
        ck_assert_double_eq_tol(normal[2], mesh.normal[v].z, 1e-6);
        double rgb[3];
        wcut_colour(mesh.scalar[v] / 0.02, rgb);
        for (int i = 0; i < 3; i++) /* linear in the file */
            ck_assert_double_eq_tol(
                colour[i] <= 0.0031308 ? 12.92 * colour[i] : 1.055 * pow(colour[i], 1 / 2.4) - 0.055, rgb[i] / 255,
                1e-5);
        ck_assert(colour[3] == 1);
    }
}

TEST(glb_holds_the_triangles_colours_and_the_scale_to_metres) {
    setup(23, 31);
    written(wcut_mesh_write_glb(&mesh, "a.glb", &error));
    size_t length, bytes;
    const char *data;
    char *glb = read_back("a.glb", &length);
    json_t *root = open_glb(glb, length, &data, &bytes);
    check_triangles(root, check_root(root), data, bytes);
    const json_t *material = item(root, "materials", 0);
    ck_assert(json_is_true(json_object_get(material, "doubleSided")));
    ck_assert(json_number_value(json_object_get(json_object_get(material, "pbrMetallicRoughness"), "metallicFactor")) ==
              0);
    json_decref(root);
    free(glb);
    teardown();
}

/* 4.5 km from the origin single precision alone would be 0.25 mm off */
TEST(glb_far_from_the_origin_is_exact_relative_to_the_part) {
    setup(23, 31);
    for (int k = 0; k < 2; k++) {
        for (int v = 0; v < mesh.vertex_count; v++) { /* a part of 1.2 m, then one of 75 mm: 2e-6 mm */
            const double share = k ? 1.0 / 16 : 1;
            mesh.vertex[v].x = 4.5e6 + share * (mesh.vertex[v].x - (k ? 4.5e6 : 0));
            mesh.vertex[v].y = -4.5e6 + share * (mesh.vertex[v].y + (k ? 4.5e6 : 0));
            mesh.vertex[v].z *= share;
        }
        written(wcut_mesh_write_glb(&mesh, "a.glb", &error));
        size_t length, bytes;
        const char *data;
        char *glb = read_back("a.glb", &length);
        json_t *root = open_glb(glb, length, &data, &bytes);
        const wcut_vec3 from = check_root(root);
        ck_assert(fabs(from.x - 4.5e6) < 1000 && fabs(from.y + 4.5e6) < 1000);
        check_triangles(root, from, data, bytes);
        ck_assert(reach_of(from) == (k ? 64 : 1024));
        json_decref(root);
        free(glb);
    }
    teardown();
}

TEST(glb_without_normals_and_scalar_and_under_a_locale_is_valid_too) {
    setup(4, 5);
    free(mesh.normal);
    free(mesh.scalar);
    mesh.normal = NULL;
    mesh.scalar = NULL;
    ck_assert_msg(setlocale(LC_ALL, "de_DE.UTF-8") != NULL, "the tests' own locale is missing");
    written(wcut_mesh_write_glb(&mesh, "a.glb", &error));
    size_t length, bytes;
    const char *data;
    char *glb = read_back("a.glb", &length);
    json_t *root = open_glb(glb, length, &data, &bytes);
    check_root(root);
    const json_t *primitive = json_array_get(json_object_get(item(root, "meshes", 0), "primitives"), 0);
    ck_assert_ptr_null(json_object_get(json_object_get(primitive, "attributes"), "COLOR_0"));
    json_decref(root);
    free(glb);
    teardown();
}

/* ---- what is no mesh ---- */

static void refused_by_all(const char *words) {
    for (int k = 0; k < 4; k++) {
        wcut_status status = k == 0   ? wcut_mesh_write_stl(&mesh, "a", &error)
                             : k == 1 ? wcut_mesh_write_obj(&mesh, "a", &error)
                             : k == 2 ? wcut_mesh_write_ply(&mesh, "f", "a", &error)
                                      : wcut_mesh_write_glb(&mesh, "a", &error);
        ck_assert_int_eq(status, WCUT_BAD_ARGUMENT);
        ck_assert_msg(strstr(error.text, words) != NULL, "found: %s", error.text);
    }
    ck_assert_int_eq(count_entries("."), 0);
}

TEST(what_is_no_finite_mesh_is_refused_by_every_writer) {
    setup(3, 3);
    mesh.vertex[4].y = NAN;
    refused_by_all("a: vertex 4: found nan, inf or more than 1e30");
    mesh.vertex[4].y = 0;
    mesh.scalar[5] = INFINITY;
    refused_by_all("a: vertex 5: found nan, inf or more than 1e30");
    mesh.scalar[5] = 0;
    mesh.normal[6].x = NAN;
    refused_by_all("vertex 6");
    mesh.normal[6].x = 0;
    mesh.uv[3] = NAN;
    refused_by_all("vertex 1");
    mesh.uv[3] = 0;
    mesh.vertex[4].y = 1e39; /* finite, but in no float */
    refused_by_all("vertex 4");
    mesh.vertex[4].y = 0;
    mesh.triangle[7] = 9;
    refused_by_all("a: triangle 2: found a vertex outside 0 .. 8");
    mesh.triangle[7] = -1;
    refused_by_all("triangle 2");
    mesh.triangle[7] = 0;
    mesh.triangle_count = 0;
    refused_by_all("found no mesh");
    ck_assert_int_eq(wcut_mesh_write_stl(NULL, "a", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_write_stl(&mesh, NULL, NULL), WCUT_BAD_ARGUMENT);
    mesh.triangle_count = 8;
    teardown();
}

TEST(running_out_of_memory_anywhere_writes_nothing) {
    setup(3, 3);
    EACH_FAILED_ALLOCATION(wcut_mesh_write_stl(&mesh, "a", &error), count_entries(".") == 0);
    EACH_FAILED_ALLOCATION(wcut_mesh_write_glb(&mesh, "b", &error), count_entries(".") == 1);
    teardown();
}
