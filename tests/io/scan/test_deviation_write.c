/* deviation.json, zones.csv, coloured points and meshes, datums: read back, and refused whole. */
#include <jansson.h>
#include <wirecut/cloud_file.h>
#include <wirecut/deviation_file.h>
#include <wirecut/table.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/given.h"
#include "test.h"

enum { POINTS = 3000 };

static wcut_deviation deviation[POINTS];
static wcut_vec3 point[POINTS];
static wcut_deviation_summary *summary;
static const wcut_deviation_summary_result *result;
static wcut_registration registration;
static wcut_statistics back;
static const wcut_compared_scan scan[] = {{"a \"scan\"</script>.ply", "ab12", 2900, 3, 0}, {"b.xyz", "", 120, 0, 1}};

static wcut_compared given_comparison(void) {
    const double band[] = {0.25, 1};
    wcut_deviation_summary_options o = wcut_deviation_summary_options_default();
    o.high = (wcut_vec3){400, 1200, 300};
    o.bands = 2, o.band[0] = band[0], o.band[1] = band[1];
    ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, &summary), WCUT_OK);
    for (int k = 0; k < POINTS; k++) {
        const double x = 400.0 * (k % 50) / 49, y = 1200.0 * (k / 50) / 59;
        point[k] = (wcut_vec3){x, y, 150 + 0.1 * x};
        deviation[k] = (wcut_deviation){.distance = sin(x / 50) * cos(y / 90), .foot = point[k], .triangle = -1};
        deviation[k].place = k % 100 ? WCUT_PLACE_INSIDE : k % 200 ? WCUT_PLACE_BEYOND : WCUT_PLACE_AMBIGUOUS;
    }
    ck_assert_int_eq(wcut_deviation_summary_add(summary, POINTS, deviation), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_summary_eval(summary, &result), WCUT_OK);
    registration = wcut_registration_none();
    registration.method = WCUT_REGISTRATION_METHOD_FIT;
    registration.parameter[WCUT_DOF_RZ] = acos(-1) / 2;
    registration.covariance[WCUT_DOF_TX * 6 + WCUT_DOF_TX] = 4;
    back = (wcut_statistics){.count = 5, .max = 3.25, .mean = 1.5};
    return (wcut_compared){.reference = "job.json",
                           .distance = "surface",
                           .scans = 2,
                           .scan = scan,
                           .removed = {[WCUT_REMOVAL_KEPT] = POINTS, [WCUT_REMOVAL_OUTLIER] = 20},
                           .registration = &registration,
                           .found = result,
                           .unmoved = result,
                           .face_to_scan = &back,
                           .kerf = 1,
                           .has_kerf = 1,
                           .unmeasured = 12.5,
                           .support = 1.5,
                           .tolerance = 0.25,
                           .share = 0.95,
                           .within = 0};
}

static void forget(void) { wcut_deviation_summary_destroy(summary); }

static const json_t *at(const json_t *root, const char *path) {
    char copy[200], *rest = copy;
    snprintf(copy, sizeof copy, "%s", path);
    for (char *key; (key = strtok_r(rest, ".", &rest));) root = json_object_get(root, key);
    ck_assert_msg(root != NULL, "no %s", path);
    return root;
}

static double number(const json_t *root, const char *path) { return json_number_value(at(root, path)); }

TEST(a_comparison_says_what_the_format_asks_for) {
    char *text = NULL;
    const wcut_compared c = given_comparison();
    ck_assert_int_eq(wcut_deviation_print(&c, &text), WCUT_OK);
    json_t *root = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    ck_assert_ptr_nonnull(root);
    ck_assert_str_eq(json_string_value(at(root, "format")), "wirecut-deviation/1");
    ck_assert_str_eq(json_string_value(at(root, "scan")), scan[0].name);
    ck_assert(number(root, "points.read") == 3020 && number(root, "points.removed") == 20);
    ck_assert(number(root, "points.outside") == 15 && number(root, "points.ambiguous") == 15);
    ck_assert_double_eq(number(root, "points.used"), result->statistics.count);
    ck_assert_str_eq(json_string_value(at(root, "registration.method")), "fit");
    ck_assert_uint_eq(json_array_size(at(root, "registration.matrix")), 4);
    ck_assert_double_eq_tol(number(root, "registration.parameters.rz_deg.value"), 90, 1e-9);
    ck_assert_double_eq(number(root, "registration.parameters.tx_mm.sigma"), 2);
    const char *const figure[] = {"mean", "median", "std", "rms", "mae", "p01", "p05", "p95", "p99", "min", "max"};
    for (int k = 0; k < 11; k++) ck_assert(json_is_number(json_object_get(at(root, "distance_mm"), figure[k])));
    ck_assert_double_eq(number(root, "distance_mm.rms"), result->statistics.rms);
    ck_assert_double_eq(number(root, "kerf_offset_mm"), result->split.offset);
    ck_assert_double_eq(number(root, "form_rms_mm"), result->split.form_rms);
    ck_assert_double_eq(number(root, "kerf_mm.by_scan"), 1 - 2 * result->split.offset);
    ck_assert_double_eq(number(root, "hausdorff_face_to_scan_mm"), 3.25);
    ck_assert(json_is_false(at(root, "gate.within")));
    const json_t *band = json_array_get(at(root, "bands"), 1);
    ck_assert(number(band, "tolerance_mm") == 1 && number(band, "share") == 1);
    ck_assert_uint_eq(json_array_size(at(root, "zones")), 4 * 12);
    ck_assert_uint_eq(json_array_size(at(root, "worst")), (size_t)result->worsts);
    ck_assert_double_eq(number(json_array_get(at(root, "worst"), 0), "peak_mm"), result->worst[0].peak);
    ck_assert_double_eq(number(root, "as_scanned.distance_mm.rms"), result->statistics.rms);
    json_decref(root);
    free(text);
    forget();
}

TEST(a_title_block_and_the_cleaning_are_told) {
    wcut_compared c = given_comparison();
    wcut_clean_options cleaning = wcut_clean_options_default();
    char *text = NULL;
    cleaning.radius = 3, cleaning.neighbours = 0;
    c.part = "P \"7\"", c.date = "2026-11-30", c.datum_file = "d.csv", c.cleaning = &cleaning;
    ck_assert_int_eq(wcut_deviation_print(&c, &text), WCUT_OK);
    json_t *root = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    ck_assert_str_eq(json_string_value(at(root, "title.part")), "P \"7\"");
    ck_assert_str_eq(json_string_value(at(root, "title.date")), "2026-11-30");
    ck_assert(json_is_null(at(root, "title.inspector")) && json_is_null(at(root, "title.instrument")));
    ck_assert_str_eq(json_string_value(at(root, "datum_file")), "d.csv");
    ck_assert(json_is_true(at(root, "cleaning.duplicates")) && number(root, "cleaning.isolated_mm") == 3);
    ck_assert(json_is_null(at(root, "cleaning.outlier_deviations")) && json_is_null(at(root, "cleaning.thinned_mm")));
    json_decref(root);
    free(text);
}

TEST(bad_comparisons_are_refused) {
    char *text = (char *)999;
    const wcut_compared good = given_comparison();
    wcut_compared bad[5] = {good, good, good, good, good};
    bad[0].scans = 0, bad[1].reference = NULL, bad[2].found = NULL, bad[3].registration = NULL;
    bad[4].face_to_scan = NULL;
    for (int k = 0; k < 5; k++) ck_assert_int_eq(wcut_deviation_print(&bad[k], &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_print(NULL, &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_print(&good, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_write(&good, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_write(&good, "/nowhere/at/all.json", NULL), WCUT_NOT_WRITTEN);
    ck_assert_int_eq(wcut_zones_write(NULL, NULL, "zones.csv", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_zones_write(result, NULL, "/nowhere/zones.csv", NULL), WCUT_NOT_WRITTEN);
    FIRST_FAILED_ALLOCATIONS(1, wcut_deviation_print(&good, &text), true);
    ck_assert_ptr_eq(text, (char *)999);
    forget();
}

TEST(zones_are_a_table) {
    wcut_table *table = NULL;
    given_comparison();
    enter_folder();
    ck_assert_int_eq(wcut_zones_write(result, NULL, "zones.csv", NULL), WCUT_OK);
    const char *const numeric[] = {"count", "mean_mm", "rms_mm", "within_mm_0.25"};
    ck_assert_int_eq(wcut_table_read("zones.csv", 4, numeric, &table, NULL), WCUT_OK);
    ck_assert_int_eq(table->rows, 48);
    double count = 0;
    const wcut_column *of = &table->column[wcut_table_locate(table, "count")];
    for (int k = 0; k < table->rows; k++) count += of->value[k];
    ck_assert_double_eq(count, result->statistics.count);
    ck_assert_double_eq(table->column[wcut_table_locate(table, "mean_mm")].value[7], result->zone[7].mean);
    wcut_table_destroy(table);
    leave_folder();
    forget();
}

/* ---- points ---- */

TEST(points_are_written_as_they_come_and_read_back) {
    wcut_deviation_stream *stream = NULL;
    wcut_cloud *cloud = NULL;
    wcut_error error = {0};
    given_comparison();
    enter_folder();
    const char *path = "deviation.ply";
    ck_assert_int_eq(wcut_deviation_stream_create(path, 1, 0, &stream, &error), WCUT_OK);
    for (int k = 0; k < POINTS; k += 1000)
        ck_assert_int_eq(wcut_deviation_stream_append(stream, 1000, point + k, NULL, deviation + k, &error), WCUT_OK);
    ck_assert_int_ne(access(path, F_OK), 0); /* not before it is whole */
    ck_assert_int_eq(wcut_deviation_stream_commit(stream, &error), WCUT_OK);
    wcut_deviation_stream_destroy(stream);
    ck_assert_msg(wcut_cloud_read(path, NULL, &cloud, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(cloud->count, POINTS);
    for (int k = 0; k < POINTS; k++) ck_assert(memcmp(&cloud->point[k], &point[k], sizeof *point) == 0);
    wcut_cloud_destroy(cloud);
    char *bytes;
    size_t size;
    ck_assert_int_eq(wcut_file_read(path, 1 << 24, &bytes, &size, NULL), WCUT_OK);
    const size_t record = 3 * 8 + 8 + 3 + 1;
    const unsigned char *rows = (unsigned char *)bytes + size - POINTS * record;
    for (int k = 0; k < POINTS; k++) {
        double value;
        const unsigned char *rgb = rows + k * record + 32;
        memcpy(&value, rgb - 8, sizeof value);
        ck_assert_int_eq(rgb[3], deviation[k].place);
        if (deviation[k].place > WCUT_PLACE_BORDER)
            ck_assert(isnan(value) && rgb[0] == 158 && rgb[1] == 163 && rgb[2] == 168);
        else
            ck_assert(value == deviation[k].distance);
        if (value > 0.2) ck_assert_int_gt(rgb[0], rgb[2] + 20);  /* orange above */
        if (value < -0.2) ck_assert_int_gt(rgb[2], rgb[0] + 20); /* blue below */
    }
    free(bytes);
    leave_folder();
    forget();
}

TEST(normals_come_back_with_their_points) {
    wcut_deviation_stream *stream = NULL;
    wcut_cloud *cloud = NULL;
    static wcut_vec3 normal[POINTS];
    given_comparison();
    enter_folder();
    for (int k = 0; k < POINTS; k++) normal[k] = (wcut_vec3){k % 2 ? 0.6 : -0.6, 0, 0.8};
    ck_assert_int_eq(wcut_deviation_stream_create("n.ply", 1, 1, &stream, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_stream_append(stream, POINTS, point, NULL, deviation, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_stream_append(stream, POINTS, point, normal, deviation, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_stream_commit(stream, NULL), WCUT_OK);
    wcut_deviation_stream_destroy(stream);
    ck_assert_int_eq(wcut_cloud_read("n.ply", NULL, &cloud, NULL), WCUT_OK);
    ck_assert(cloud->count == POINTS && cloud->normal);
    for (int k = 0; k < POINTS; k++) {
        ck_assert(memcmp(&cloud->point[k], &point[k], sizeof *point) == 0);
        ck_assert(fabs(cloud->normal[k].x - normal[k].x) < 1e-15 && fabs(cloud->normal[k].z - 0.8) < 1e-15);
    }
    wcut_cloud_destroy(cloud);
    ck_assert_int_eq(wcut_deviation_stream_create("n.ply", 1, 0, &stream, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_stream_append(stream, POINTS, point, normal, deviation, NULL), WCUT_BAD_ARGUMENT);
    wcut_deviation_stream_destroy(stream);
    leave_folder();
    forget();
}

TEST(a_stream_that_is_not_committed_leaves_nothing) {
    wcut_deviation_stream *stream = NULL;
    given_comparison();
    enter_folder();
    ck_assert_int_eq(wcut_deviation_stream_create("d.ply", 1, 0, &stream, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_stream_append(stream, POINTS, point, NULL, deviation, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_stream_append(stream, -1, point, NULL, deviation, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_stream_append(stream, 1, NULL, NULL, deviation, NULL), WCUT_BAD_ARGUMENT);
    wcut_deviation_stream_destroy(stream);
    wcut_deviation_stream_destroy(NULL);
    ck_assert_int_eq(count_entries("."), 0);
    stream = (wcut_deviation_stream *)999;
    ck_assert_int_eq(wcut_deviation_stream_create(NULL, 1, 0, &stream, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_stream_create("d.ply", 0, 0, &stream, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_stream_create("/nowhere/d.ply", 1, 0, &stream, NULL), WCUT_NOT_WRITTEN);
    FIRST_FAILED_ALLOCATIONS(2, wcut_deviation_stream_create("d.ply", 1, 0, &stream, NULL), true);
    ck_assert_ptr_eq(stream, (wcut_deviation_stream *)999);
    ck_assert_int_eq(wcut_deviation_stream_commit(NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(count_entries("."), 0);
    leave_folder();
    forget();
}

/* ---- meshes ---- */

TEST(a_coloured_mesh_keeps_its_holes_grey) {
    wcut_mesh *mesh = NULL;
    const double value[] = {-2, 0, 2, 0.5};
    const unsigned char present[] = {1, 1, 1, 0};
    const int triangle[] = {0, 1, 2, 1, 3, 2};
    enter_folder();
    ck_assert_int_eq(wcut_mesh_create(4, 2, 0, &mesh), WCUT_OK);
    memcpy(mesh->triangle, triangle, sizeof triangle);
    for (int k = 0; k < 4; k++) mesh->vertex[k] = (wcut_vec3){k % 2, k / 2, 0.1 * k};
    ck_assert_int_eq(wcut_deviation_mesh_write_ply(mesh, value, present, 1, "m.ply", NULL), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_mesh_write_obj(mesh, value, present, 1, "m.obj", NULL), WCUT_OK);
    char *text;
    size_t size;
    ck_assert_int_eq(wcut_file_read("m.obj", 1 << 16, &text, &size, NULL), WCUT_OK);
    ck_assert_ptr_nonnull(strstr(text, "v 0 0 0 0.000 0.309 0.607\n"));
    ck_assert_ptr_nonnull(strstr(text, "v 1 1 0.30000000000000004 0.618 0.638 0.658\n"));
    ck_assert_ptr_nonnull(strstr(text, "f 2 4 3\n"));
    free(text);
    wcut_cloud *cloud = NULL;
    ck_assert_int_eq(wcut_cloud_read("m.ply", NULL, &cloud, NULL), WCUT_OK);
    ck_assert_int_eq(cloud->count, 4);
    wcut_cloud_destroy(cloud);
    const double odd[] = {0, NAN, 0, 0};
    ck_assert_int_eq(wcut_deviation_mesh_write_ply(mesh, odd, NULL, 1, "x.ply", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_mesh_write_obj(mesh, value, NULL, 0, "x.obj", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_mesh_write_ply(NULL, value, NULL, 1, "x.ply", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_mesh_write_ply(mesh, value, NULL, 1, "/nowhere/x.ply", NULL), WCUT_NOT_WRITTEN);
    ck_assert_int_eq(count_entries("."), 2);
    wcut_mesh_destroy(mesh);
    leave_folder();
}

/* ---- datums ---- */

TEST(datums_are_pairs_and_points_on_faces) {
    wcut_datums *datums = NULL;
    wcut_error error = {0};
    enter_folder();
    write_file("d.csv",
               "scan_x_mm,scan_y_mm,scan_z_mm,block_x_mm,block_y_mm,block_z_mm,sigma_mm\n"
               "1,2,3,4,5,6,0.5\n"
               "7,8,9,,0,,0.25\n"
               "7,8,9,400,,,0.25\n");
    ck_assert_msg(wcut_datums_read("d.csv", &datums, &error) == WCUT_OK, "%s", error.text);
    ck_assert(datums->pairs == 1 && datums->faces == 2);
    ck_assert(datums->pair[0].scan.z == 3 && datums->pair[0].block.x == 4 && datums->pair[0].sigma == 0.5);
    ck_assert(datums->face[0].normal.y == 1 && datums->face[0].normal.x == 0 && datums->face[0].count == 1);
    ck_assert(datums->face[1].normal.x == 1 && datums->face[1].point.x == 400 && datums->face[1].scan->y == 8);
    wcut_datums_destroy(datums);
    wcut_datums_destroy(NULL);
    const char *const head = "scan_x_mm,scan_y_mm,scan_z_mm,block_x_mm,block_y_mm,block_z_mm,sigma_mm\n";
    const char *const bad[] = {
        "", "1,2,3,4,5,,1\n", "1,2,,4,5,6,1\n", "1,2,3,,,,1\n", "1,2,3,4,5,6,-1\n", "1,2,3,1e13,,,1\n"};
    datums = (wcut_datums *)999;
    for (int k = 0; k < 6; k++) {
        char text[300];
        snprintf(text, sizeof text, "%s%s", head, bad[k]);
        write_file("bad.csv", text);
        ck_assert_int_eq(wcut_datums_read("bad.csv", &datums, &error), WCUT_BAD_FORMAT);
        ck_assert_ptr_nonnull(strstr(error.text, k ? "line 2" : "no datum"));
    }
    write_file("bad.csv", "x,y\n1,2\n");
    ck_assert_int_eq(wcut_datums_read("bad.csv", &datums, &error), WCUT_BAD_FORMAT);
    ck_assert_int_eq(wcut_datums_read("none.csv", &datums, &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_datums_read(NULL, &datums, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_eq(datums, (wcut_datums *)999);
    leave_folder();
}
