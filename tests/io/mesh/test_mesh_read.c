/* Meshes out and back in, every format; polygons; what is no mesh is refused with its own words. */
#include <limits.h>
#include <locale.h>
#include <wirecut/cloud_file.h>
#include <wirecut/read.h>
#include <wirecut/write.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/given.h"
#include "io/mesh/mesh_formats.h"
#include "test.h"

static wcut_mesh *mesh;
static wcut_mesh_read_info info;
static wcut_error error;

/* bytes through a small window, so that every refill is met */
static wcut_status read_bytes(const void *bytes, size_t size, const char *label) {
    const wcut_mesh_read_options o = wcut_mesh_read_options_default();
    wcut_mesh_destroy(mesh);
    mesh = NULL;
    memset(&info, 0x99, sizeof info);
    return wcut_mesh_read_memory(bytes, size, 1024, label, &o, &mesh, &info, &error);
}

static void reads(const char *label, const char *text, int vertices, int triangles) {
    ck_assert_msg(read_bytes(text, strlen(text), label) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(mesh->vertex_count, vertices);
    ck_assert_int_eq(mesh->triangle_count, triangles);
}

static void refuses_bytes(const char *label, const void *bytes, size_t size, const char *words) {
    ck_assert_int_eq(read_bytes(bytes, size, label), WCUT_BAD_FORMAT);
    ck_assert_ptr_null(mesh);
    ck_assert_int_eq(info.split, (int)0x99999999);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
    ck_assert_int_eq(error.status, WCUT_BAD_FORMAT);
}

static void refuses(const char *label, const char *text, const char *words) {
    refuses_bytes(label, text, strlen(text), words);
}

/* the divergence theorem */
static double volume(void) {
    double sum = 0;
    for (int t = 0; t < mesh->triangle_count; t++) {
        const int *v = mesh->triangle + 3 * (size_t)t;
        const wcut_vec3 a = mesh->vertex[v[0]], b = mesh->vertex[v[1]], c = mesh->vertex[v[2]];
        sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    }
    return sum / 6;
}

static double area(void) {
    double sum = 0;
    for (int t = 0; t < mesh->triangle_count; t++) {
        const int *v = mesh->triangle + 3 * (size_t)t;
        const wcut_vec3 a = mesh->vertex[v[0]], b = mesh->vertex[v[1]], c = mesh->vertex[v[2]];
        const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z}, w[3] = {c.x - a.x, c.y - a.y, c.z - a.z};
        sum += sqrt(pow(u[1] * w[2] - u[2] * w[1], 2) + pow(u[2] * w[0] - u[0] * w[2], 2) +
                    pow(u[0] * w[1] - u[1] * w[0], 2)) /
               2;
    }
    return sum;
}

/* a box of 2 x 3 x 4 with quadrangles, seen from outside counter-clockwise */
#define BOX_OBJ                                                                \
    "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\n" \
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"

/* ---- out and back in ---- */

static void is_given_back(const wcut_mesh *given, bool exact, double tolerance) {
    ck_assert_int_eq(mesh->vertex_count, given->vertex_count);
    ck_assert_int_eq(mesh->triangle_count, given->triangle_count);
    for (int k = 0; k < 3 * given->triangle_count; k++) {
        const wcut_vec3 a = given->vertex[given->triangle[k]], b = mesh->vertex[mesh->triangle[k]];
        if (exact)
            ck_assert(a.x == b.x && a.y == b.y && a.z == b.z);
        else
            ck_assert(fabs(a.x - b.x) + fabs(a.y - b.y) + fabs(a.z - b.z) <= tolerance);
    }
}

TEST(what_was_written_comes_back_exactly_or_to_single_precision) {
    wcut_mesh given = given_mesh(7, 5);
    enter_folder();
    ck_assert_int_eq(wcut_mesh_write_ply(&given, "force", "a.ply", NULL), WCUT_OK);
    ck_assert_int_eq(wcut_mesh_write_obj(&given, "a.obj", NULL), WCUT_OK);
    ck_assert_int_eq(wcut_mesh_write_stl(&given, "a.stl", NULL), WCUT_OK);
    ck_assert_int_eq(wcut_mesh_write_glb(&given, "a.glb", NULL), WCUT_OK);
    static const char *const name[] = {"a.ply", "a.obj", "a.stl", "a.glb"};
    static const wcut_mesh_format format[] = {WCUT_MESH_FORMAT_PLY, WCUT_MESH_FORMAT_OBJ, WCUT_MESH_FORMAT_STL,
                                              WCUT_MESH_FORMAT_GLTF};
    for (int k = 0; k < 4; k++) {
        ck_assert_msg(wcut_mesh_read(name[k], NULL, &mesh, &info, &error) == WCUT_OK, "%s", error.text);
        ck_assert_int_eq(info.format, format[k]);
        is_given_back(&given, k < 2, 3e-4);
        ck_assert_double_eq_tol(info.low.x, 0, 1e-3);
        ck_assert_double_eq_tol(info.high.y, 1200, 1e-3);
        ck_assert(info.split == 0 && info.collapsed == 0);
        wcut_mesh_destroy(mesh);
        mesh = NULL;
    }
    leave_folder();
    forget_mesh(&given);
}

TEST(a_decimal_comma_of_the_locale_changes_nothing) {
    ck_assert_ptr_nonnull(setlocale(LC_ALL, "de_DE.UTF-8"));
    reads("a.obj", "v 0.5 0 0\nv 1.5 0 0\nv 0 2.25 0\nf 1 2 3\n", 3, 1);
    ck_assert(mesh->vertex[0].x == 0.5 && mesh->vertex[2].y == 2.25);
    reads("a.off", "OFF\n3 1 0\n0.5 0 0\n1.5 0 0\n0 2.25 0\n3 0 1 2\n", 3, 1);
    ck_assert(mesh->vertex[0].x == 0.5 && mesh->vertex[2].y == 2.25);
    setlocale(LC_ALL, "C");
}

TEST(units_become_millimetres) {
    wcut_mesh_read_options o = wcut_mesh_read_options_default();
    const char *text = BOX_OBJ;
    static const double factor[] = {1, 10, 1000, 25.4};
    for (int unit = WCUT_LENGTH_UNIT_MM; unit <= WCUT_LENGTH_UNIT_INCH; unit++) {
        o.unit = (wcut_length_unit)unit;
        ck_assert_int_eq(wcut_mesh_read_memory(text, strlen(text), 1024, "a.obj", &o, &mesh, &info, NULL), WCUT_OK);
        ck_assert_double_eq_tol(volume(), 24 * pow(factor[unit], 3), 1e-9 * pow(factor[unit], 3));
        wcut_mesh_destroy(mesh);
        mesh = NULL;
    }
}

/* ---- topology ---- */

TEST(corners_in_one_place_are_one_vertex_and_collapsed_triangles_are_counted) {
    reads("a.stl",
          "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
          "facet normal 0 0 1\nouter loop\nvertex 1 0 -0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"
          "facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
          4, 2);
    ck_assert_int_eq(info.collapsed, 1);
    reads("a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nf 2 3 4\nf 5 6 4\n", 4, 2);
    ck_assert(info.high.x == 1); /* the first vertex is in no face */
}

TEST(polygons_become_triangles_that_fill_them) {
    reads("a.obj", BOX_OBJ, 8, 12);
    ck_assert_double_eq_tol(volume(), 24, 1e-12);
    ck_assert_int_eq(info.split, 6);
    /* a comb: a fan from its first corner would leave it */
    reads("comb.obj", "v 0 0 0\nv 5 0 0\nv 5 4 0\nv 4 1 0\nv 3 4 0\nv 2 1 0\nv 1 4 0\nv 0 4 0\nf 1 2 3 4 5 6 7 8\n", 8,
          6);
    ck_assert_double_eq_tol(area(), 14, 1e-12);
    /* the same, clockwise, in another plane */
    reads("comb.obj", "v 0 0 0\nv 0 5 0\nv 0 5 4\nv 0 4 1\nv 0 3 4\nv 0 2 1\nv 0 1 4\nv 0 0 4\nf 8 7 6 5 4 3 2 1\n", 8,
          6);
    ck_assert_double_eq_tol(area(), 14, 1e-12);
    /* a bow tie is what it is: as many triangles as corners less two */
    reads("tie.obj", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", 4, 2);
}

TEST(an_obj_counts_back_from_its_end_and_carries_what_is_not_needed) {
    reads("a.obj",
          "# a\nmtllib a.mtl\no b\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nvt 0 0\nvn 0 0 1\ns off\nusemtl x\r\n"
          "f -3/1/1 -2//-1 -1/1\r\nl 1 2\n",
          3, 1);
}

TEST(a_ply_of_either_kind_gives_its_faces) {
    reads(
        "a",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 2\nproperty uchar flag\nproperty list uchar uint vertex_index\nproperty list uchar float uv\n"
        "element edge 1\nproperty int a\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n7 3 0 1 2 2 0.5 0.5\n9 3 0 2 3 0\n5\n",
        4, 2);
    static const char big[] =
        "ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty short x\nproperty short y\nproperty short z\n"
        "element face 1\nproperty list uchar short vertex_indices\nend_header\n"
        "\0\0\0\0\0\0\0\1\0\0\0\0\0\1\0\1\0\0\0\0\0\1\0\0\4\0\0\0\1\0\2\0\3";
    ck_assert_msg(read_bytes(big, sizeof big - 1, "big") == WCUT_OK, "%s", error.text);
    ck_assert(mesh->triangle_count == 2 && mesh->vertex[2].x == 1 && mesh->vertex[2].y == 1);
    ck_assert_double_eq(area(), 1);
}

TEST(an_off_file_is_read_in_a_process_of_its_own) {
    reads("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0.125\n3 0 1 2\n3 0 2 3\n", 4, 2);
    ck_assert(mesh->vertex[3].z == 0.125 && info.format == WCUT_MESH_FORMAT_OFF);
}

TEST(a_gltf_is_in_metres_with_y_up_and_its_nodes_move_and_mirror_it) {
    /* one triangle, (0,0,0) (1,0,0) (0,1,0), as base64; the node doubles it, mirrors x and lifts it by 3 m */
    reads("a.gltf",
          "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
          "\"nodes\":[{\"mesh\":0,\"scale\":[-2,2,2],\"translation\":[0,3,0]}],"
          "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
          "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
          "\"min\":[0,0,0],\"max\":[1,1,0]}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
          "\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,"
          "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}",
          3, 1);
    ck_assert_double_eq_tol(info.low.x, -2000, 1e-9);
    ck_assert_double_eq_tol(info.low.z, 3000, 1e-9);
    ck_assert_double_eq_tol(info.high.z, 5000, 1e-9);
    /* its normal was glTF's +z, our -y; the mirror keeps it so */
    const int *v = mesh->triangle;
    const wcut_vec3 a = mesh->vertex[v[0]], b = mesh->vertex[v[1]], c = mesh->vertex[v[2]];
    ck_assert((b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z) < 0);
}

/* ---- refusals ---- */

TEST(faces_of_an_obj_may_leave_parts_out_and_lines_may_go_on) {
    static const char *const face[] = {"f 1// 2// 3//",    "f 1/1/ 2/1/ 3/1/", "f 1/ 2/ 3/",
                                       "f 1//1 2//1 3//1", "f 1 \\\n2 3",      "f 1 2 \\\r\n \\\r\n3"};
    char text[200];
    for (size_t k = 0; k < sizeof face / sizeof *face; k++) {
        snprintf(text, sizeof text, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n%s\n", face[k]);
        const wcut_mesh_read_options o = wcut_mesh_read_options_default();
        ck_assert_msg(wcut_mesh_read_memory(text, strlen(text), 1024, "a.obj", &o, &mesh, &info, &error) == WCUT_OK,
                      "%s", error.text);
        ck_assert_int_eq(mesh->triangle_count, 1);
        wcut_mesh_destroy(mesh);
        mesh = NULL;
    }
    refuses("a.obj", "v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n", "line 5, column 7: found x");
}

TEST(a_mesh_of_off_is_in_double_precision) {
    /* 4.5 km from the origin, a thousandth of a millimetre apart */
    static const char text[] =
        "OFF\n4 1 0\n4500000.001 0 0\n4500001.002 0 0 255 0 0\n4500001 1 0\n4500000 1 0.003\n"
        "4 0 1 2 3 1 0 0\n";
    const wcut_mesh_read_options o = wcut_mesh_read_options_default();
    ck_assert_msg(wcut_mesh_read_memory(text, strlen(text), 1024, "a.off", &o, &mesh, &info, &error) == WCUT_OK, "%s",
                  error.text);
    ck_assert(mesh->triangle_count == 2 && mesh->vertex_count == 4 && info.split == 1);
    ck_assert(mesh->vertex[0].x == 4500000.001 && mesh->vertex[1].x == 4500001.002 && mesh->vertex[3].z == 0.003);
    wcut_mesh_destroy(mesh);
    mesh = NULL;
}

TEST(what_is_no_mesh_is_refused_with_its_words) {
    refuses("a.obj", "", "byte 0: found the end of the file, expected a mesh");
    refuses("a.txt", "1 2 3\n", "found no mesh in a known format, expected STL, PLY, OBJ, OFF or glTF");
    refuses("a.obj", "v 0 0 0\n", "found no triangle (0 collapsed), expected at least one");
    refuses("a.obj", "v 0 0\n", "line 1, column 6: found the end of the line, expected 3 coordinates");
    refuses("a.obj", "v 0 0 0 0.5\n", "expected a vertex of weight 1");
    refuses("a.obj", "v 0 0 nan\n", "line 1: found a coordinate z that is not finite");
    refuses("a.obj", "v 0 1e13 0\n", "line 1: found y = 1e+13 mm, expected at most 1e12");
    refuses("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4, column 7: found 4, expected a corner");
    refuses("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "line 4, column 7: found 0, expected a corner");
    refuses("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", "line 4, column 3: found -4 1 2, expected a corner");
    refuses("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2/x 3\n", "expected a corner at one of the vertices");
    refuses("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "line 3: found a polygon of 2 corners, expected 3 to 1024");
    refuses("a.obj", "cstype bspline\n", "line 1, column 1: found cstype bspline, expected a polygon mesh");
    refuses_bytes("a.obj", "v 0 0 0\0\nv 1", 12, "line 1, column 8: found a zero byte");
    refuses("a.off", "OFF\n3 1 0\nxyz\n0 0 0\n0 0 0\n3 0 1 2\n", "line 3, column 1: found xyz, expected a number");
    refuses("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "line 6, column 6: found the end of the line");
    refuses("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n", "expected 1 faces more");
    refuses("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "found a corner at vertex 3, expected 0 to 2");
    refuses("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n", "line 7, column 1: found 3 0 2 1");
    refuses("a.glb", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "found neither glTF nor {");
    refuses("a.gltf", "{\"buffers\": [{\"byteLength\": 9, \"uri\": \"plane.bin\"}]}",
            "its data are in another file, \"plane.bin\"");
    refuses("a.gltf", "{", "assimp reads no mesh in it, expected a sound gltf file");
}

#define PLY_HEAD \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"

TEST(a_ply_that_lies_or_has_no_faces_is_refused) {
    refuses("a", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
            "found no element face with a list vertex_indices");
    refuses("a", PLY_HEAD "property list uchar float vertex_indices\nend_header\n",
            "found no element face with a list vertex_indices");
    refuses("a", PLY_HEAD "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
            "found a corner at vertex 3, expected 0 to 2");
    refuses("a", PLY_HEAD "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n",
            "found -1, expected the number of a vertex");
    refuses("a", PLY_HEAD "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n",
            "expected the number of a vertex");
    refuses("a", PLY_HEAD "property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n2000 0\n",
            "found a face of 2000 corners, expected at most 1024");
    refuses("a", PLY_HEAD "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n",
            "found a coordinate y that is not finite");
    refuses("a", PLY_HEAD "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n4\n",
            "found more data after the last element");
    refuses("a",
            "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0000",
            "a count of 2000000000 vertices in the header and 4 bytes of data");
}

TEST(an_stl_with_nan_or_cut_short_is_refused) {
    unsigned char stl[84 + 50] = {0};
    const float nan = NAN;
    stl[80] = 1;
    memcpy(stl + 84 + 12, &nan, 4);
    refuses_bytes("a.stl", stl, sizeof stl, "found a coordinate x that is not finite");
    memset(stl + 84 + 12, 0, 4);
    refuses_bytes("a.stl", stl, sizeof stl - 1, "a count of 1 triangles in the header and 49 bytes of data");
    refuses_bytes("a.stl", stl, sizeof stl, "found no triangle (1 collapsed)");
    refuses("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n",
            "line 6, column 1: found endloop, expected vertex");
}

TEST(more_triangles_than_asked_for_are_refused) {
    wcut_mesh_read_options o = wcut_mesh_read_options_default();
    o.max_triangles = 11;
    const char *text = BOX_OBJ, *off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
    ck_assert_int_eq(wcut_mesh_read_memory(text, strlen(text), 1024, "a.obj", &o, &mesh, &info, &error),
                     WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "found more than 11 triangles, expected at most that"));
    o.max_triangles = 1;
    ck_assert_int_eq(wcut_mesh_read_memory(off, strlen(off), 1024, "a.off", &o, &mesh, &info, &error), WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "found more than 1 triangles, expected at most that"));
    ck_assert_ptr_null(mesh);
}

TEST(arguments_outside_their_range_and_missing_files_are_refused) {
    wcut_mesh_read_options o = wcut_mesh_read_options_default();
    ck_assert_int_eq(wcut_mesh_read(NULL, NULL, &mesh, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_read("a.stl", NULL, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    o.max_triangles = 0;
    ck_assert_int_eq(wcut_mesh_read("a.stl", &o, &mesh, NULL, NULL), WCUT_BAD_ARGUMENT);
    o = wcut_mesh_read_options_default();
    o.seconds = 0;
    ck_assert_int_eq(wcut_mesh_read("a.stl", &o, &mesh, NULL, NULL), WCUT_BAD_ARGUMENT);
    o.seconds = 1;
    o.format = WCUT_MESH_FORMAT_COUNT;
    ck_assert_int_eq(wcut_mesh_read("a.stl", &o, &mesh, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_read("/nowhere/a.stl", NULL, &mesh, NULL, &error), WCUT_NOT_FOUND);
    ck_assert_ptr_nonnull(strstr(error.text, "/nowhere/a.stl: cannot be read"));
    ck_assert_int_eq(wcut_mesh_read("/", NULL, &mesh, NULL, &error), WCUT_NOT_FOUND);
    ck_assert_ptr_null(mesh);
}

TEST(without_memory_nothing_is_given_and_nothing_lost) {
    static const char ply[] =
        PLY_HEAD "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    static const char *const label[] = {"a.obj", "a.ply", "a.off"};
    static const char *const text[] = {BOX_OBJ, ply, "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n"};
    for (int f = 0; f < 3; f++) {
        EACH_FAILED_ALLOCATION(read_bytes(text[f], strlen(text[f]), label[f]), !mesh);
        ck_assert_ptr_nonnull(mesh);
    }
}
