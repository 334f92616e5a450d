/* 3MF out: a ZIP archive that unpacks, and a model with exact numbers, names and types. */
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <wirecut/exchange.h>
#include <zlib.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/given.h"
#include "test.h"

static wcut_error error;

static unsigned number(const unsigned char *at, int bytes) {
    unsigned value = 0;
    while (bytes-- > 0) value = value << 8 | at[bytes];
    return value;
}

/* a member of the archive, unpacked, by the directory at its end; the caller's to free */
static char *unpack(const char *path, const char *name) {
    size_t length;
    unsigned char *zip = (unsigned char *)read_back(path, &length);
    const unsigned char *end = zip + length - 22, *entry = zip + number(end + 16, 4);
    ck_assert_uint_eq(number(end, 4), 0x06054b50);
    char *found = NULL;
    for (unsigned k = 0; k < number(end + 10, 2); k++) {
        const unsigned packed = number(entry + 20, 4), plain = number(entry + 24, 4), n = number(entry + 28, 2);
        const unsigned char *local = zip + number(entry + 42, 4);
        ck_assert_uint_eq(number(entry, 4), 0x02014b50);
        ck_assert_uint_eq(number(local, 4), 0x04034b50);
        ck_assert(memcmp(local + 14, entry + 16, 12) == 0); /* sizes and sum agree */
        if (strlen(name) == n && memcmp(entry + 46, name, n) == 0) {
            z_stream stream = {0};
            found = calloc(plain + 1, 1);
            stream.next_in = (unsigned char *)local + 30 + n;
            stream.avail_in = packed;
            stream.next_out = (unsigned char *)found;
            stream.avail_out = plain;
            ck_assert_int_eq(inflateInit2(&stream, -15), Z_OK);
            ck_assert_int_eq(inflate(&stream, Z_FINISH), Z_STREAM_END);
            ck_assert_uint_eq(stream.total_out, plain);
            inflateEnd(&stream);
            ck_assert_uint_eq(crc32(0, (unsigned char *)found, plain), number(entry + 16, 4));
        }
        entry += 46 + n;
    }
    free(zip);
    ck_assert_msg(found != NULL, "no %s", name);
    return found;
}

/* a tetrahedron */
static wcut_vec3 corner[4] = {{0, 0, 0}, {0.1, 0, 0}, {0, 1e-7, 0}, {0, 0, -12345.678901234567}};
static int face[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
static wcut_mesh tetrahedron = {4, 4, corner, NULL, NULL, NULL, face};

TEST(both_halves_are_named_models_in_millimetres_with_exact_numbers) {
    const wcut_mesh_object object[] = {{.mesh = &tetrahedron, .name = "lower"},
                                       {.mesh = &tetrahedron, .name = "upper <\"&\xc3\xbc\">"}};
    enter_folder();
    ck_assert_ptr_nonnull(setlocale(LC_ALL, "de_DE.UTF-8"));
    ck_assert_int_eq(wcut_mesh_write_3mf(2, object, "a.3mf", &error), WCUT_OK);
    setlocale(LC_ALL, "C");
    char *model = unpack("a.3mf", "3D/3dmodel.model");
    ck_assert_ptr_nonnull(strstr(model, "<model unit=\"millimeter\""));
    ck_assert_ptr_nonnull(strstr(model, "<object id=\"1\" type=\"model\" name=\"lower\">"));
    ck_assert_ptr_nonnull(
        strstr(model, "<object id=\"2\" type=\"model\" name=\"upper &#60;&#34;&#38;\xc3\xbc&#34;&#62;\">"));
    ck_assert_ptr_nonnull(strstr(model, "<vertex x=\"0.1\" y=\"0\" z=\"0\"/>"));
    ck_assert_ptr_nonnull(strstr(model, "<vertex x=\"0\" y=\"1e-07\" z=\"0\"/>"));
    ck_assert_ptr_nonnull(strstr(model, "z=\"-12345.678901234567\"/>"));
    ck_assert_ptr_nonnull(strstr(model, "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/>"));
    ck_assert_ptr_nonnull(strstr(model, "<item objectid=\"2\"/>"));
    free(model);
    free(unpack("a.3mf", "[Content_Types].xml"));
    free(unpack("a.3mf", "_rels/.rels"));
    leave_folder();
}

TEST(an_open_mesh_is_a_surface_and_a_large_one_is_whole) {
    wcut_mesh sheet = given_mesh(90, 80);
    const wcut_mesh_object object = {.mesh = &sheet, .name = "sheet"};
    enter_folder();
    ck_assert_int_eq(wcut_mesh_write_3mf(1, &object, "a.3mf", &error), WCUT_OK);
    char *model = unpack("a.3mf", "3D/3dmodel.model");
    ck_assert_ptr_nonnull(strstr(model, "type=\"surface\""));
    int vertices = 0, triangles = 0;
    for (const char *p = model; (p = strstr(p, "<vertex ")) != NULL; p++) vertices++;
    for (const char *p = model; (p = strstr(p, "<triangle ")) != NULL; p++) triangles++;
    ck_assert(vertices == sheet.vertex_count && triangles == sheet.triangle_count);
    free(model);
    leave_folder();
    forget_mesh(&sheet);
}

TEST(colours_names_and_places_are_in_the_package) {
    static const unsigned char mark[4] = {0, 1, 0, 0};
    const wcut_mesh_object object[] = {{.mesh = &tetrahedron, .name = "plain"},
                                       {.mesh = &tetrahedron,
                                        .name = "upper half",
                                        .material = "foam",
                                        .marked_material = "cut & face",
                                        .mark = mark,
                                        .colour = 0x0a0b0c,
                                        .marked_colour = 0xff8000,
                                        .turned = 1,
                                        .move = {410, 0.5, 300}}};
    enter_folder();
    ck_assert_int_eq(wcut_mesh_write_3mf(2, object, "a.3mf", &error), WCUT_OK);
    char *model = unpack("a.3mf", "3D/3dmodel.model");
    static const char *const part[] = {
        "<basematerials id=\"4\">\n<base name=\"foam\" displaycolor=\"#0A0B0C\"/>\n<base name=",
        "<base name=\"cut &#38; face\" displaycolor=\"#FF8000\"/>\n</basematerials>",
        "<object id=\"1\" type=\"model\" name=\"plain\"><mesh>",
        "name=\"upper half\" pid=\"4\" pindex=\"0\"><mesh>",
        "<triangle v1=\"0\" v2=\"1\" v3=\"3\" pid=\"4\" p1=\"1\"/>",
        "<item objectid=\"1\"/>",
        "<item objectid=\"2\" transform=\"1 0 0 0 -1 0 0 0 -1 410 0.5 300\"/>"};
    for (size_t k = 0; k < sizeof part / sizeof *part; k++)
        ck_assert_msg(strstr(model, part[k]) != NULL, "no %s in %s", part[k], model);
    ck_assert_ptr_null(strstr(model, "<basematerials id=\"3\""));
    free(model);
    leave_folder();
}

TEST(what_is_no_mesh_and_no_name_is_refused) {
    const char *bad[] = {"\xff", "a\nb", "\xed\xa0\x80", NULL};
    static const unsigned char mark[4] = {0, 1, 0, 0};
    wcut_mesh_object object = {.mesh = &tetrahedron};
    enter_folder();
    for (int k = 0; k < 4; k++) {
        object.name = bad[k];
        ck_assert_int_eq(wcut_mesh_write_3mf(1, &object, "a.3mf", &error), WCUT_BAD_ARGUMENT);
    }
    object.name = "a", object.material = bad[0];
    ck_assert_int_eq(wcut_mesh_write_3mf(1, &object, "a.3mf", NULL), WCUT_BAD_ARGUMENT);
    object.material = "foam", object.mark = mark;
    ck_assert_int_eq(wcut_mesh_write_3mf(1, &object, "a.3mf", NULL), WCUT_BAD_ARGUMENT);
    object.mark = NULL, object.move.x = NAN;
    ck_assert_int_eq(wcut_mesh_write_3mf(1, &object, "a.3mf", NULL), WCUT_BAD_ARGUMENT);
    object.move.x = 0;
    const wcut_mesh_object none = {.name = "a"};
    ck_assert_int_eq(wcut_mesh_write_3mf(0, &object, "a.3mf", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_write_3mf(1, NULL, "a.3mf", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_write_3mf(1, &none, "a.3mf", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_write_3mf(1, &object, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_write_3mf(1, &object, "none/a.3mf", NULL), WCUT_NOT_WRITTEN);
    ck_assert_int_eq(count_entries("."), 0);
    EACH_FAILED_ALLOCATION(wcut_mesh_write_3mf(1, &object, "a.3mf", NULL), count_entries(".") == 0);
    leave_folder();
}
