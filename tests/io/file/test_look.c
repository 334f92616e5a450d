/* A file given in the place of another one is called what it is, with the verb that takes it. */
#include <stdio.h>

#include "base/fail.h"
#include "io/file/json_read.h"
#include "io/file/look.h"
#include "test.h"

typedef struct seen {
    const char *label, *text, *kind, *use;
} seen;

static const seen kinds[] = {
    {"a.stl", "solid a\n facet normal 0 0 1\n", "a mesh (STL)", "mould as --stock"},
    {"a", "SOLID\nFACET\n", NULL, ""},
    {"a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nelement face 1\n", "a mesh (PLY)", "SCAN"},
    {"a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nend_header\n", "a cloud (PLY)", "SCAN"},
    {"a.obj", "# of a program\nv 0 0 0\nv 1 0 0\nf 1 2 3\n", "a mesh (OBJ)", "SCAN"},
    {"a.off", "COFF\n3 1 0\n", "a mesh (OFF)", "SCAN"},
    {"a.glb", "glTF\2", "a mesh (glTF)", "SCAN"},
    {"a.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"meshes\": []}", "a mesh (glTF)", "SCAN"},
    {"a.step", "ISO-10303-21;\nHEADER;", "a STEP file", "--edges"},
    {"a.e57", "ASTM-E57", "a cloud in E57, which would need the library libE57Format", "CloudCompare"},
    {"a.las", "LASF", "a cloud (LAS)", "SCAN"},
    {"a.laz", "LASF", "a cloud in LAZ, which would need the library LASzip", "laszip"},
    {"a.pcd", "# .PCD v.7", "a cloud (PCD)", "SCAN"},
    {"a.dxf", "  0\r\nSECTION\r\n  2\r\n", "a DXF drawing", "STEP or IGES"},
    {"a.3dm", "3D Geometry File Format        5", "a Rhino model", "STEP or IGES"},
    {"a.3mf", "PK\003\004", "a mesh (3MF)", "STL"},
    {"a.xlsx", "PK\003\004", "a spreadsheet", "CSV"},
    {"a.zip", "PK\003\004", "a ZIP archive", ""},
    {"a.pdf", "%PDF-1.4", "a PDF document", ""},
    {"a.csv", "\xff\xfet", "UTF-16 text", "UTF-8"},
    {"a.json", "{\"format\": \"wirecut-job/1\"}", "a job (JSON)", "simulate"},
    {"a.json", "\xef\xbb\xbf \n{\"format\": \"wirecut-case/1\"}", "a case (JSON)", "diagnose"},
    {"a.json", "{\"format\": \"wirecut-force-law/1\"}", "force laws (JSON)", "--force-law"},
    {"a.json", "{\"format\": \"wirecut-summary/1\"}", "a result of wirecut (JSON)", ""},
    {"a.json", "[1, 2]", "JSON", ""},
    {"a.csv", "time_s,station,speed_a_mm_s\n", "a recording (CSV)", "score"},
    {"a.csv", "heat_W_per_m,speed_mm_s,engaged_mm,tension_N\n", "test cuts (CSV)", "calibrate"},
    {"a.csv", "scan_x_mm,scan_y_mm,scan_z_mm,block_x_mm\n", "datums (CSV)", "--datum"},
    {"a.csv", "curve;X;Y;Z\n", "a table of points", "--edges"},
    {"a.txt", "hello\n", NULL, ""},
    {"a", "", NULL, ""},
};

TEST(a_kind_is_told_by_the_first_bytes_and_the_ending) {
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        const seen *s = &kinds[k];
        const wcut_look look = wcut_look_at(s->text, strlen(s->text), s->label);
        ck_assert_msg((look.kind == NULL) == (s->kind == NULL), "%s: found %s", s->text,
                      look.kind ? look.kind : "none");
        if (!s->kind) continue;
        ck_assert_msg(strncmp(look.kind, s->kind, strlen(s->kind)) == 0, "%s: found %s", s->text, look.kind);
        ck_assert_msg(strstr(look.use, s->use) != NULL, "%s: found %s", s->text, look.use);
        ck_assert(wcut_look_is_table(look.kind) == (strstr(s->label, ".csv") && look.kind[0] != 'U'));
    }
}

TEST(a_binary_stl_is_told_by_its_size_and_other_bytes_are_binary_data) {
    char bytes[84 + 50] = "made by a program";
    bytes[80] = 1;
    ck_assert_str_eq(wcut_look_at(bytes, sizeof bytes, "a").kind, "a mesh (STL)");
    ck_assert_str_eq(wcut_look_at(bytes, sizeof bytes - 1, "a").kind, "binary data of no known kind");
    ck_assert_str_eq(wcut_look_at(bytes, sizeof bytes - 1, "a.STL").kind, "a mesh (STL)");

    /* an IGES by its 73rd column, bytes at the limit of what is looked at */
    static char iges[5000];
    memset(iges, ' ', sizeof iges);
    memcpy(iges + 72, "S      1\n", 9);
    ck_assert_str_eq(wcut_look_at(iges, 81, "a").kind, "an IGES file");
    ck_assert_str_eq(wcut_look_at(iges, sizeof iges, "a").kind, "an IGES file");
    ck_assert_ptr_null(wcut_look_at(iges, 79, "a").kind);
}

TEST(a_refusal_names_the_file_the_kind_what_is_expected_and_the_verb) {
    wcut_error error = {WCUT_OK, ""};
    ck_assert_int_eq(wcut_look_refuse("hello", 5, "a.txt", "JSON", &error), WCUT_OK);
    ck_assert_int_eq(error.text[0], 0);
    ck_assert_int_eq(wcut_look_refuse("%PDF", 4, "a.txt", "JSON", &error), WCUT_BAD_FORMAT);
    ck_assert_str_eq(error.text, "a.txt: found a PDF document, expected JSON");
    ck_assert_int_eq(wcut_look_refuse("COFF\n", 5, "a.off", "JSON", NULL), WCUT_BAD_FORMAT);
    ck_assert_int_eq(wcut_look_refuse("COFF\n", 5, "a.off", "JSON", &error), WCUT_BAD_FORMAT);
    ck_assert_str_eq(error.text,
                     "a.off: found a mesh (OFF), expected JSON; compare takes it as SCAN or in the place of the job, "
                     "mould as --stock");

    /* a file of ours in the place of another one of ours */
    wcut_reader reader = {"a.json", &error, WCUT_OK};
    json_t *json = json_pack("{s:s}", "format", "wirecut-job/1");
    const wcut_place root = {NULL, NULL, 0, json}, format = wcut_place_member(&root, "format");
    ck_assert(wcut_read_format(&reader, &format, "wirecut-job/1"));
    ck_assert(!wcut_read_format(&reader, &format, "wirecut-case/1"));
    ck_assert_str_eq(error.text,
                     "a.json: $.format: found \"wirecut-job/1\", expected \"wirecut-case/1\"; simulate, path, "
                     "mould, control and compare take a job");
    json_decref(json);
}
