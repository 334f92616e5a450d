/* STEP and IGES out: every reference leads somewhere, every edge is used twice, lines are 80 columns; what is refused.
   That other programs read them, to the last bit, stands in tests/exchange. */
#include <locale.h>
#include <wirecut/exchange.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "exchange/given_parts.h"
#include "io/cad/part21_read.h"
#include "io/given.h"
#include "test.h"

static wcut_error error;

static wcut_shape surface_shape(const wcut_surface *s) { return (wcut_shape){.name = "s", .surface = s}; }

static wcut_shape curve_shape(const wcut_curve *c) { return (wcut_shape){.name = "c", .curve = c}; }

/* ---- STEP ---- */

static char *text;
static wcut_p21_file file;
static wcut_curve_reader reader;
static wcut_curve_set set;

static void open_step(const char *path) {
    size_t length = 0;
    text = read_back(path, &length);
    reader = (wcut_curve_reader){.label = path, .set = &set};
    ck_assert_msg(wcut_p21_open(&reader, text, length, &file), "%s", reader.failure.text);
}

static void close_step(void) {
    wcut_p21_close(&file);
    free(text);
}

static int count_records(const char *name) {
    int n = 0;
    for (int k = 0; k < file.count; k++) n += wcut_p21_record(file.instance[k].body, name) != NULL;
    return n;
}

static void every_reference_is_there(void) {
    for (int k = 0; k < file.count; k++)
        for (const char *p = file.instance[k].body; (p = strchr(p, '#')) != NULL; p++)
            ck_assert_ptr_nonnull(wcut_p21_find(&file, strtol(p + 1, NULL, 10)));
}

TEST(solids_share_their_edges_and_every_reference_leads_somewhere) {
    given_solid solid[2];
    wcut_shape shape[2];
    for (int k = 0; k < 2; k++) {
        given_solid_create(&solid[k], k);
        shape[k] = (wcut_shape){.name = k ? "upper" : "lower", .solid = &solid[k].brep};
    }
    enter_folder();
    ck_assert_int_eq(wcut_step_write(2, shape, WCUT_STEP_SCHEMA_AP214, "a.step", &error), WCUT_OK);
    open_step("a.step");
    every_reference_is_there();
    ck_assert_int_eq(count_records("MANIFOLD_SOLID_BREP"), 2);
    ck_assert_int_eq(count_records("CLOSED_SHELL"), 2);
    ck_assert_int_eq(count_records("ADVANCED_FACE"), 12);
    ck_assert_int_eq(count_records("EDGE_CURVE"), 24);
    ck_assert_int_eq(count_records("ORIENTED_EDGE"), 48);
    ck_assert_int_eq(count_records("VERTEX_POINT"), 16);
    ck_assert_int_eq(count_records("PCURVE"), 8);
    ck_assert_int_eq(count_records("PRODUCT"), 2);
    for (int k = 0; k < file.count; k++) { /* an edge is used once in either sense */
        if (!wcut_p21_record(file.instance[k].body, "EDGE_CURVE")) continue;
        int senses[2] = {0, 0};
        for (int j = 0; j < file.count; j++) {
            long edge = 0;
            const char *list = wcut_p21_record(file.instance[j].body, "ORIENTED_EDGE");
            if (!list || !wcut_p21_read_reference(wcut_p21_item(list, 3), &edge)) continue;
            if (edge == file.instance[k].id) senses[wcut_p21_is(wcut_p21_item(list, 4), ".T.")]++;
        }
        ck_assert(senses[0] == 1 && senses[1] == 1);
    }
    close_step();
    leave_folder();
    given_solid_destroy(&solid[0]);
    given_solid_destroy(&solid[1]);
}

TEST(a_surface_is_a_face_where_it_has_a_border_and_a_set_where_it_has_none) {
    wcut_surface *patch = given_patch(), *cylinder = given_cylinder();
    enter_folder();
    wcut_shape shape = surface_shape(patch);
    ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP242, "a.step", &error), WCUT_OK);
    open_step("a.step");
    every_reference_is_there();
    ck_assert(count_records("SHELL_BASED_SURFACE_MODEL") == 1 && count_records("PCURVE") == 4);
    ck_assert_int_eq(count_records("GEOMETRIC_SET"), 0);
    close_step();
    shape = surface_shape(cylinder);
    ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP242, "b.step", &error), WCUT_OK);
    open_step("b.step");
    every_reference_is_there();
    ck_assert(count_records("GEOMETRIC_SET") == 1 && count_records("RATIONAL_B_SPLINE_SURFACE") == 1);
    close_step();
    leave_folder();
    wcut_surface_destroy(cylinder);
    wcut_surface_destroy(patch);
}

TEST(names_are_written_as_step_writes_them) {
    wcut_curve *arc = given_arc();
    wcut_shape shape = curve_shape(arc);
    size_t length;
    shape.name = "it's \\ M\xc3\xbcller \xf0\x9f\x9c\x81 \xff\n";
    enter_folder();
    ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP214, "a.step", &error), WCUT_OK);
    char *bytes = read_back("a.step", &length);
    ck_assert_ptr_nonnull(strstr(bytes,
                                 "PRODUCT('it''s \\\\ M\\X2\\00FC\\X0\\ller \\X4\\0001F701\\X0\\ "
                                 "\\X2\\FFFD\\X0\\\\X2\\000A\\X0\\',"));
    free(bytes);
    leave_folder();
    wcut_curve_destroy(arc);
}

TEST(the_same_shapes_give_the_same_bytes_and_a_locale_changes_nothing) {
    wcut_surface *loft = given_loft(9, 8);
    const wcut_shape shape = surface_shape(loft);
    static const char *const name[] = {"a.step", "b.step", "a.igs", "b.igs"};
    size_t length[4];
    char *bytes[4];
    enter_folder();
    for (int k = 0; k < 4; k++) {
        ck_assert_ptr_nonnull(setlocale(LC_ALL, k % 2 ? "de_DE.UTF-8" : "C"));
        ck_assert_int_eq(k < 2 ? wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP214, name[k], &error)
                               : wcut_iges_write(1, &shape, name[k], &error),
                         WCUT_OK);
        bytes[k] = read_back(name[k], &length[k]);
    }
    setlocale(LC_ALL, "C");
    for (int k = 0; k < 4; k += 2) {
        ck_assert(length[k] == length[k + 1] && memcmp(bytes[k], bytes[k + 1], length[k]) == 0);
        free(bytes[k]);
        free(bytes[k + 1]);
    }
    leave_folder();
    wcut_surface_destroy(loft);
}

/* ---- IGES ---- */

TEST(iges_has_lines_of_80_columns_in_sections_that_count_them) {
    wcut_surface *loft = given_loft(9, 8);
    wcut_curve *arc = given_arc();
    const wcut_shape shape[] = {surface_shape(loft), curve_shape(arc)};
    size_t length;
    enter_folder();
    ck_assert_int_eq(wcut_iges_write(2, shape, "a.igs", &error), WCUT_OK);
    char *bytes = read_back("a.igs", &length);
    ck_assert_uint_eq(length % 81, 0);
    int count[5] = {0, 0, 0, 0, 0}, section = 0;
    for (size_t at = 0; at < length; at += 81) {
        while (section < 5 && bytes[at + 72] != "SGDPT"[section]) section++;
        ck_assert_int_lt(section, 5);
        ck_assert_int_eq(atoi(bytes + at + 73), ++count[section]);
        ck_assert_int_eq(bytes[at + 80], '\n');
    }
    ck_assert(count[2] == 8 && count[4] == 1); /* two shapes and their names, two lines each */
    const char *end = bytes + length - 81;
    ck_assert(atoi(end + 9) == count[1] && atoi(end + 17) == count[2] && atoi(end + 25) == count[3]);
    for (int k = 0; k < 4; k++) { /* each entry points to its data, which begin with its type */
        const char *entry = bytes + 81 * (size_t)(count[0] + count[1] + 2 * k);
        char type[9] = "", at[9] = "";
        memcpy(type, entry, 8);
        memcpy(at, entry + 8, 8);
        ck_assert_int_eq(atoi(bytes + 81 * (size_t)(count[0] + count[1] + count[2] + atoi(at) - 1)), atoi(type));
    }
    free(bytes);
    leave_folder();
    wcut_curve_destroy(arc);
    wcut_surface_destroy(loft);
}

/* ---- refusals ---- */

static void refuses(const wcut_shape *shape, const char *words) {
    for (int k = 0; k < 2; k++) {
        error.text[0] = '\0';
        const wcut_status status = k ? wcut_iges_write(1, shape, "refused", &error)
                                     : wcut_step_write(1, shape, WCUT_STEP_SCHEMA_AP214, "refused", &error);
        ck_assert_int_eq(status, WCUT_BAD_ARGUMENT);
        ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
        ck_assert_int_ne(access("refused", F_OK), 0);
    }
}

TEST(shapes_that_are_none_are_refused) {
    wcut_surface *patch = given_patch();
    wcut_curve *arc = given_arc();
    given_solid solid;
    given_solid_create(&solid, 0);
    enter_folder();
    wcut_shape shape = {.name = "a"};
    refuses(&shape, "shape 0: found not exactly one of solid, surface and curve");
    shape = (wcut_shape){.name = "a", .surface = patch, .curve = arc};
    refuses(&shape, "shape 0: found not exactly one of solid, surface and curve");
    shape = (wcut_shape){.surface = patch};
    refuses(&shape, "shape 0: found no name");
    shape = surface_shape(patch);
    patch->control[3].y = NAN;
    refuses(&shape, "shape 0: found a control point that is not finite");
    patch->control[3].y = 0;
    patch->knots_v[4] = -1;
    refuses(&shape, "shape 0: found a degree or knots that make no surface");
    shape = curve_shape(arc);
    arc->weights[2] = 0;
    refuses(&shape, "shape 0: found a weight that is not positive");
    shape = (wcut_shape){.name = "a", .solid = &solid.brep};
    solid.coedge[5].reversed ^= 1;
    refuses(&shape, "shape 0: found a loop that is open");
    solid.coedge[5].edge = 12;
    refuses(&shape, "shape 0: found a loop of edges that are not there");
    solid.edge[5].to = solid.edge[5].from;
    refuses(&shape, "shape 0: found an edge without two vertices");
    solid.vertex[1].x = INFINITY;
    refuses(&shape, "shape 0: found a vertex that is not finite");
    solid.brep.face_count = 0;
    refuses(&shape, "shape 0: found a solid without faces");
    leave_folder();
    given_solid_destroy(&solid);
    wcut_curve_destroy(arc);
    wcut_surface_destroy(patch);
}

TEST(misuse_and_closed_doors_are_told_apart) {
    wcut_curve *arc = given_arc();
    given_solid solid;
    given_solid_create(&solid, 0);
    const wcut_shape shape = curve_shape(arc), block = {.name = "b", .solid = &solid.brep};
    enter_folder();
    ck_assert_int_eq(wcut_step_write(0, &shape, WCUT_STEP_SCHEMA_AP214, "a", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_step_write(1, NULL, WCUT_STEP_SCHEMA_AP214, "a", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_COUNT, "a", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP214, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP214, "none/a", NULL), WCUT_NOT_WRITTEN);
    ck_assert_int_eq(wcut_iges_write(1, &shape, "none/a", NULL), WCUT_NOT_WRITTEN);
    ck_assert_int_eq(wcut_iges_write(1, &block, "a", &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "shape 0: found a solid, expected a surface or a curve"));
    ck_assert_int_eq(count_entries("."), 0);
    leave_folder();
    given_solid_destroy(&solid);
    wcut_curve_destroy(arc);
}

TEST(without_memory_the_target_is_as_it_was) {
    given_solid solid;
    given_solid_create(&solid, 0);
    const wcut_shape shape[] = {{.name = "b", .solid = &solid.brep}, surface_shape(solid.patch)};
    enter_folder();
    write_file("a.step", "before");
    EACH_FAILED_ALLOCATION(wcut_step_write(2, shape, WCUT_STEP_SCHEMA_AP214, "a.step", NULL),
                           (file_holds("a.step", "before"), true));
    leave_folder();
    given_solid_destroy(&solid);
}
