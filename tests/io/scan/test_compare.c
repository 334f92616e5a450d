/* A scan beside a face in one call: closed forms on a plane and a wave, each kind of reference, refusals, faults. */
#include <wirecut/compare.h>
#include <wirecut/edit.h>
#include <wirecut/exchange.h>
#include <wirecut/surface_fit.h>

#include "cut/trials.h"
#include "io/given.h"

enum { SIDE = 41, SCAN_SIDE = 60, SCAN = SCAN_SIDE * SCAN_SIDE };

static wcut_vec3 scan_point[SCAN];

/* 400 x 300 mm, z = height(x) */
static wcut_mesh *sheet(double (*height)(double)) {
    wcut_mesh *m;
    ck_assert_int_eq(wcut_mesh_create(SIDE * SIDE, 2 * (SIDE - 1) * (SIDE - 1), 0, &m), WCUT_OK);
    for (int k = 0; k < SIDE * SIDE; k++) {
        const double x = 400.0 * (k % SIDE) / (SIDE - 1);
        m->vertex[k] = (wcut_vec3){x, 300.0 * (k / SIDE) / (SIDE - 1), height(x)};
    }
    for (int i = 0, t = 0; i < SIDE - 1; i++)
        for (int j = 0; j < SIDE - 1; j++) {
            const int at = i * SIDE + j, corner[6] = {at, at + 1, at + SIDE, at + 1, at + SIDE + 1, at + SIDE};
            for (int c = 0; c < 6; c++) m->triangle[t++] = corner[c];
        }
    return m;
}

static double flat(double x) { return 0 * x; }
static double wave(double x) { return 20 * sin(x / 60); }

/* points at `offset` along the normal of z = height(x), whose slope is `slope` */
static wcut_compare_scan scan_of(double (*height)(double), double slope, double offset) {
    for (int k = 0; k < SCAN; k++) {
        const double x = 10 + 380.0 * (k % SCAN_SIDE) / (SCAN_SIDE - 1),
                     y = 10 + 280.0 * (k / SCAN_SIDE) / (SCAN_SIDE - 1);
        const double s = slope * cos(x / 60), length = sqrt(1 + s * s);
        scan_point[k] = (wcut_vec3){x - offset * s / length, y, height(x) + offset / length};
    }
    return (wcut_compare_scan){.count = SCAN, .point = scan_point};
}

static wcut_compare_result *compare(const wcut_compare_reference *r, const wcut_compare_scan *scan,
                                    const wcut_compare_options *o) {
    wcut_compare_result *result = NULL;
    wcut_error error = {0};
    const wcut_status status = wcut_compare_run(r, 1, scan, o, NULL, NULL, &result, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    return result;
}

TEST(an_even_offset_from_a_plane_is_told_as_it_is) {
    wcut_mesh *plane = sheet(flat);
    const wcut_compare_scan scan = scan_of(flat, 0, 0.125);
    const wcut_compare_reference r = {.mesh = plane, .name = "plane"};
    wcut_compare_options o = wcut_compare_options_default();
    o.tolerance = 0.1, o.feet = true, o.threads = 2;
    wcut_compare_result *c = compare(&r, &scan, &o);

    /* figures, gate, and every point's own */
    const wcut_statistics *s = &c->compared.found->statistics;
    ck_assert_int_eq(s->count, SCAN);
    ck_assert_double_eq_tol(s->mean, 0.125, 1e-15);
    ck_assert_double_eq_tol(s->rms, 0.125, 1e-15);
    ck_assert_int_eq(s->bands, 5);
    ck_assert_double_eq(s->band[0], 0.1);
    ck_assert(!c->compared.within);
    ck_assert_str_eq(c->compared.reference, "plane");
    ck_assert_str_eq(c->compared.scan[0].name, "scan");
    ck_assert_str_eq(c->compared.distance, "mesh");
    ck_assert_int_eq(c->page.points, SCAN);
    for (int k = 0; k < SCAN; k++) {
        ck_assert_double_eq_tol(c->page.deviation[k], 0.125, 1e-15);
        ck_assert_double_eq(c->row[k].distance, c->page.deviation[k]);
        ck_assert_double_eq_tol(c->row[k].foot.x, scan_point[k].x, 1e-12);
    }
    ck_assert(!c->compared.has_kerf && !c->compared.reconstruction && !c->normal && !c->streamed);
    wcut_compare_destroy(c);

    o.tolerance = 0.13, o.flip = true;
    c = compare(&r, &scan, &o);
    ck_assert_double_eq_tol(c->compared.found->statistics.mean, -0.125, 1e-15);
    ck_assert(c->compared.within);
    wcut_compare_destroy(c);
    wcut_mesh_destroy(plane);
}

TEST(a_given_surface_is_measured_exactly_and_its_triangles_within_their_chord) {
    wcut_mesh *m = sheet(wave);
    wcut_surface *surface = NULL;
    wcut_vec3 *row = wcut_alloc(SIDE * SIDE, sizeof *row);
    for (int k = 0; k < SIDE * SIDE; k++) row[k] = m->vertex[k];
    ck_assert_int_eq(wcut_surface_loft(SIDE, SIDE, row, 1e-6, &surface, NULL, NULL), WCUT_OK);
    const wcut_compare_scan scan = scan_of(wave, 20.0 / 60, 0.3);
    const wcut_compare_reference r = {.surface = surface};
    wcut_compare_options o = wcut_compare_options_default();
    o.reconstruct = true, o.feet = true;

    /* the loft interpolates the wave to 4e-6 mm between stations 10 mm apart; seen from below here: wound that way */
    wcut_compare_result *exact = compare(&r, &scan, &o);
    o.distance = WCUT_COMPARE_DISTANCE_MESH, o.chord_tolerance = 0.5;
    wcut_compare_result *chords = compare(&r, &scan, &o);
    const double sign = exact->compared.found->statistics.mean > 0 ? 1 : -1;
    double error = 0, coarse = 0;
    for (int k = 0; k < SCAN; k++) {
        error = fmax(error, fabs(sign * exact->row[k].distance - 0.3));
        coarse = fmax(coarse, fabs(sign * chords->row[k].distance - 0.3));
    }
    ck_assert_double_lt(error, 1e-3);
    ck_assert_double_gt(coarse, 10 * error);
    ck_assert_double_lt(coarse, 0.55);
    ck_assert_str_eq(exact->compared.distance, "surface");
    ck_assert_ptr_nonnull(exact->compared.reconstruction);
    ck_assert_double_eq_tol(sign * exact->compared.to_face->mean, 0.3, 2e-3);

    /* the map has the exact distance at every vertex that the scan covers */
    int covered = 0;
    for (int k = 0; k < exact->page.mesh->vertex_count; k++) {
        if (!exact->page.present[k]) continue;
        covered++;
        ck_assert_double_eq_tol(sign * exact->page.value[k], 0.3, 2e-3);
    }
    ck_assert_int_gt(covered, exact->page.mesh->vertex_count / 2);
    wcut_compare_destroy(chords);
    wcut_compare_destroy(exact);
    wcut_surface_destroy(surface);
    wcut_free(row);
    wcut_mesh_destroy(m);
}

/* ---- a job: as a file, and as a history ---- */

static wcut_job *job;
static wcut_setup *setup;
static wcut_history *history;

static void begin_job(void) {
    enter_folder();
    job = short_job();
    ck_assert_int_eq(wcut_job_write(job, "job.json", NULL), WCUT_OK);
    setup = setup_of(job, NULL);
    ck_assert_int_eq(wcut_setup_run(setup, NULL, NULL, &history, NULL), WCUT_OK);

    /* points over the swept surface, as a text and in memory */
    FILE *file = fopen("scan.xyz", "w");
    ck_assert_ptr_nonnull(file);
    for (int k = 0; k < SCAN; k++) {
        const int j = 1 + k % (history->stations - 2), i = 1 + (k / 7) % (history->nodes - 2);
        scan_point[k] = history->position[j * history->nodes + i];
        scan_point[k].z += 0.01 * (k % 9);
        fprintf(file, "%.17g %.17g %.17g\n", scan_point[k].x, scan_point[k].y, scan_point[k].z);
    }
    ck_assert_int_eq(fclose(file), 0);
}

static void end_job(void) {
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
    leave_folder();
}

TEST(several_faces_of_a_cad_file_are_one_reference_across_their_seams) {
    wcut_mesh *m = sheet(wave);
    wcut_surface *surface = NULL, *half[2];
    ck_assert_int_eq(wcut_surface_loft(SIDE, SIDE, m->vertex, 1e-6, &surface, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_surface_split(surface, WCUT_DIRECTION_U, 0.37, &half[0], &half[1]), WCUT_OK);
    const wcut_shape shape[] = {{.name = "left", .surface = half[0]}, {.name = "right", .surface = half[1]}};
    wcut_error error = {0};
    enter_folder();
    ck_assert_int_eq(wcut_step_write(2, shape, WCUT_STEP_SCHEMA_AP214, "two.step", &error), WCUT_OK);
    const wcut_compare_scan scan = scan_of(wave, 20.0 / 60, 0.3);
    wcut_compare_options o = wcut_compare_options_default();
    o.feet = true, o.threads = 2;
    const wcut_compare_reference whole = {.surface = surface}, all = {.path = "two.step", .face = "all"};
    wcut_compare_result *a = compare(&whole, &scan, &o), *b = compare(&all, &scan, &o);
    ck_assert_int_eq(b->compared.found->statistics.count, SCAN);
    for (int k = 0; k < SCAN; k++) ck_assert_double_le(fabs(a->row[k].distance - b->row[k].distance), 1e-6);
    ck_assert_double_gt(b->page.mesh->vertex[b->page.mesh->vertex_count - 1].x, 150); /* the map has both */
    wcut_compare_destroy(b);

    /* by their numbers the same; one alone leaves the points of the other beyond */
    const wcut_compare_reference listed = {.path = "two.step", .face = "2,1"}, one = {.path = "two.step", .face = "2"};
    b = compare(&listed, &scan, &o);
    for (int k = 0; k < SCAN; k++) ck_assert_double_le(fabs(a->row[k].distance - b->row[k].distance), 1e-6);
    wcut_compare_destroy(b);
    b = compare(&one, &scan, &o);
    ck_assert_int_lt(b->compared.found->statistics.count, SCAN - 100);
    wcut_compare_destroy(b);

    /* what is no choice, and what several faces do not have */
    static const char *const bad[] = {"3", "1,1", "1,", "none", ""};
    for (size_t k = 0; k <= sizeof bad / sizeof *bad; k++) {
        const bool none = k == sizeof bad / sizeof *bad;
        const wcut_compare_reference r = {.path = "two.step", .face = none ? NULL : bad[k]};
        wcut_compare_result *no = NULL;
        ck_assert_int_eq(wcut_compare_run(&r, 1, &scan, &o, NULL, NULL, &no, &error), WCUT_BAD_FORMAT);
        ck_assert_msg(strstr(error.text, "(1, 2)") != NULL, "%s", error.text);
        ck_assert_ptr_null(no);
    }
    o.reconstruct = true;
    wcut_compare_result *no = NULL;
    ck_assert_int_eq(wcut_compare_run(&all, 1, &scan, &o, NULL, NULL, &no, &error), WCUT_BAD_ARGUMENT);
    ck_assert_msg(strstr(error.text, "several faces") != NULL, "%s", error.text);
    leave_folder();
    wcut_compare_destroy(a);
    wcut_surface_destroy(half[0]);
    wcut_surface_destroy(half[1]);
    wcut_surface_destroy(surface);
    wcut_mesh_destroy(m);
}

TEST(a_file_and_what_is_in_memory_give_the_same_digits) {
    begin_job();
    const wcut_compare_reference file = {.path = "job.json"}, memory = {.setup = setup, .history = history};
    const wcut_compare_scan from_file = {.path = "scan.xyz"}, points = {.count = SCAN, .point = scan_point};
    wcut_compare_options o = wcut_compare_options_default();
    o.method = WCUT_REGISTRATION_METHOD_FIT;
    o.registration.coarse = 0, o.registration.max_points = 500, o.registration.max_iterations = 20;
    wcut_compare_result *a = compare(&file, &from_file, &o), *b = compare(&memory, &points, &o);
    ck_assert_int_eq(a->page.points, b->page.points);
    for (int k = 0; k < a->page.points; k++)
        ck_assert(memcmp(&a->page.deviation[k], &b->page.deviation[k], sizeof(double)) == 0);
    ck_assert_double_eq(a->compared.found->statistics.rms, b->compared.found->statistics.rms);
    ck_assert_double_eq(a->compared.unmoved->statistics.mean, b->compared.unmoved->statistics.mean);
    ck_assert(a->compared.has_kerf && b->compared.has_kerf);
    ck_assert_int_eq(a->compared.registration->method, WCUT_REGISTRATION_METHOD_FIT);
    ck_assert_ptr_nonnull(a->page.reference_sha256);
    ck_assert_ptr_null(b->page.reference_sha256);
    wcut_compare_destroy(b);
    wcut_compare_destroy(a);
    end_job();
}

TEST(a_scan_that_is_streamed_has_the_figures_of_one_that_is_held) {
    begin_job();
    const wcut_compare_reference memory = {.setup = setup, .history = history};
    const wcut_compare_scan parts[] = {{.path = "scan.xyz"}, {.count = SCAN, .point = scan_point, .name = "again"}};
    wcut_compare_options o = wcut_compare_options_default();
    wcut_compare_result *held = NULL, *streamed = NULL;
    ck_assert_int_eq(wcut_compare_run(&memory, 2, parts, &o, NULL, NULL, &held, NULL), WCUT_OK);
    o.hold = 1000;
    ck_assert_int_eq(wcut_compare_run(&memory, 2, parts, &o, NULL, NULL, &streamed, NULL), WCUT_OK);
    ck_assert_int_eq(held->page.points, 2 * SCAN);
    ck_assert_int_lt(streamed->page.points, 2 * SCAN);
    ck_assert_int_eq(streamed->compared.removed[WCUT_REMOVAL_KEPT], 2 * SCAN);
    ck_assert_double_gt(streamed->page.spacing, 0);
    ck_assert_double_eq_tol(held->compared.found->statistics.mean, streamed->compared.found->statistics.mean, 1e-12);
    ck_assert_double_eq(held->compared.found->statistics.p99, streamed->compared.found->statistics.p99);
    ck_assert_str_eq(streamed->compared.scan[1].name, "again");

    /* normals are of what is held */
    wcut_error error = {0};
    wcut_compare_result *none = NULL;
    o.normals = 8;
    ck_assert_int_eq(wcut_compare_run(&memory, 2, parts, &o, NULL, NULL, &none, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "normals: found 7200 points"));
    ck_assert_ptr_null(none);
    wcut_compare_destroy(streamed);
    wcut_compare_destroy(held);
    end_job();
}

/* ---- files ---- */

static wcut_results *begin_results(const char *folder) {
    const char *name[WCUT_COMPARE_FILES_MAX];
    wcut_results *results = NULL;
    const int count = wcut_compare_files(NULL, name);
    ck_assert_int_eq(count, WCUT_COMPARE_FILES_MAX);
    ck_assert_int_eq(wcut_results_create(folder, count, name, &results, NULL), WCUT_OK);
    return results;
}

TEST(a_comparison_leaves_its_files_and_no_other) {
    enter_folder();
    wcut_mesh *plane = sheet(flat);
    const wcut_compare_scan scan = scan_of(flat, 0, 0.125);
    const wcut_compare_reference r = {.mesh = plane};
    wcut_compare_options o = wcut_compare_options_default();
    for (int whole = 0; whole < 2; whole++) {
        o.reconstruct = whole;
        wcut_results *results = begin_results("out");
        wcut_compare_result *c = NULL;
        char *text = NULL;
        ck_assert_int_eq(wcut_compare_run(&r, 1, &scan, &o, results, NULL, &c, NULL), WCUT_OK);
        ck_assert(c->streamed);
        ck_assert_int_eq(wcut_compare_write(c, results, &text, NULL), WCUT_OK);
        const char *name[WCUT_COMPARE_FILES_MAX];
        const int files = wcut_compare_files(c, name);
        ck_assert_int_eq(files, whole ? 8 : 6);
        ck_assert_int_eq(count_entries("out"), files);
        for (int k = 0; k < files; k++) {
            char path[64];
            snprintf(path, sizeof path, "out/%s", name[k]);
            ck_assert_int_eq(access(path, R_OK), 0);
            if (k < files - 1) ck_assert_ptr_nonnull(strstr(text, name[k]));
        }
        file_holds("out/deviation.json", text);
        free(text);
        wcut_compare_destroy(c);
        wcut_results_destroy(results);
    }
    ck_assert_int_eq(system("rm -r out"), 0);

    /* without a set at its run it has no deviation.ply */
    wcut_compare_result *c = compare(&r, &scan, &o);
    wcut_results *results = begin_results("out");
    wcut_error error = {0};
    ck_assert_int_eq(wcut_compare_write(c, results, NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "deviation.ply"));
    wcut_results_destroy(results);
    ck_assert_int_eq(count_entries("out"), 0);
    wcut_compare_destroy(c);
    ck_assert_int_eq(rmdir("out"), 0);
    wcut_mesh_destroy(plane);
    leave_folder();
}

/* ---- who watches ---- */

typedef struct watched {
    int stop, seen[WCUT_COMPARE_STAGE_COUNT], warnings;
    char warning[512];
} watched;

static int watch_progress(wcut_compare_stage stage, int done, int total, void *context) {
    watched *w = context;
    w->seen[stage]++;
    ck_assert(stage == WCUT_COMPARE_STAGE_READ ? total == 0 && done > 0 : done <= total);
    return (int)stage == w->stop;
}

static void watch_warning(const char *text, void *context) {
    watched *w = context;
    w->warnings++;
    snprintf(w->warning, sizeof w->warning, "%s", text);
}

TEST(it_is_watched_and_stopped_in_every_stage) {
    begin_job();
    const wcut_compare_reference file = {.path = "job.json"};
    const wcut_compare_scan points = {.count = SCAN, .point = scan_point};
    for (int stop = -1; stop < WCUT_COMPARE_STAGE_COUNT; stop++) {
        watched w = {.stop = stop};
        const wcut_compare_watch watch = {watch_progress, watch_warning, &w};
        wcut_results *results = begin_results("out");
        wcut_compare_result *c = NULL;
        wcut_error error = {0};
        const wcut_status status = wcut_compare_run(&file, 1, &points, NULL, results, &watch, &c, &error);
        ck_assert_int_eq(status, stop < 0 ? WCUT_OK : WCUT_INTERRUPTED);
        ck_assert((c != NULL) == (stop < 0));
        ck_assert(stop < 0 || strlen(error.text) > 0);
        for (int k = 0; k < WCUT_COMPARE_STAGE_COUNT; k++) ck_assert((w.seen[k] > 0) == (stop < 0 || k <= stop));
        wcut_compare_destroy(c);
        wcut_results_destroy(results);
        ck_assert_int_eq(count_entries("out"), 0);
    }
    ck_assert_int_eq(rmdir("out"), 0);
    end_job();
}

TEST(doubts_are_told_before_the_answer) {
    wcut_mesh *plane = sheet(flat);
    wcut_compare_scan scan = scan_of(flat, 0, 0.125);
    const wcut_compare_reference r = {.mesh = plane, .name = "a\tmesh"};
    wcut_compare_options o = wcut_compare_options_default();
    watched w = {.stop = -1};
    const wcut_compare_watch watch = {watch_progress, watch_warning, &w};
    wcut_compare_result *c = NULL;
    wcut_error error = {0};

    /* a mesh that is turned the wrong way */
    o.flip = true;
    ck_assert_int_eq(wcut_compare_run(&r, 1, &scan, &o, NULL, &watch, &c, NULL), WCUT_OK);
    ck_assert_int_eq(w.warnings, 1);
    ck_assert_str_eq(w.warning,
                     "a\\x09mesh: warning: the triangles faced up; after the flip deviations are positive below them");
    wcut_compare_destroy(c);
    c = NULL;

    /* a scan in metres */
    for (int k = 0; k < SCAN; k++) scan_point[k].x *= 1e-3, scan_point[k].y *= 1e-3, scan_point[k].z = -100;
    o.flip = false, o.threads = 1;
    for (int k = 0; k < SCAN; k++) scan_point[k].x -= 10, scan_point[k].y -= 10;
    ck_assert_int_eq(wcut_compare_run(&r, 1, &scan, &o, NULL, &watch, &c, &error), WCUT_BAD_FORMAT);
    ck_assert_int_eq(w.warnings, 2);
    ck_assert_ptr_nonnull(strstr(w.warning, "multiplied by 1000 it would fit"));
    ck_assert_ptr_nonnull(strstr(error.text, "none of them over the face"));
    ck_assert_ptr_null(c);
    wcut_mesh_destroy(plane);
}

/* ---- refusals ---- */

static void refused(const wcut_compare_reference *r, int scans, const wcut_compare_scan *scan,
                    const wcut_compare_options *o, wcut_status expected, const char *text) {
    wcut_compare_result *c = (wcut_compare_result *)&scan_point;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_compare_run(r, scans, scan, o, NULL, NULL, &c, &error), expected);
    ck_assert_msg(strstr(error.text, text) != NULL, "%s: expected in it: %s", error.text, text);
    ck_assert_ptr_eq(c, (wcut_compare_result *)&scan_point);
    ck_assert_int_eq(wcut_compare_run(r, scans, scan, o, NULL, NULL, &c, NULL), expected);
}

TEST(what_cannot_be_compared_is_refused_with_its_place) {
    enter_folder();
    wcut_mesh *plane = sheet(flat);
    const wcut_compare_reference r = {.mesh = plane}, both = {.mesh = plane, .path = "x.json"}, none = {.mesh = NULL};
    const wcut_compare_reference changed = {.mesh = plane, .edges = "e.csv"}, cad = {.path = "a.STEP"};
    const wcut_compare_reference lost = {.path = "no.json"}, history_alone = {.history = (const wcut_history *)plane};
    wcut_compare_scan scan = scan_of(flat, 0, 0.125);
    const wcut_compare_scan empty = {.count = 0, .point = scan_point}, missing = {.path = "no.xyz"};

    /* references and scans */
    refused(NULL, 1, &scan, NULL, WCUT_BAD_ARGUMENT, "reference: expected one of");
    refused(&none, 1, &scan, NULL, WCUT_BAD_ARGUMENT, "reference: expected one of");
    refused(&both, 1, &scan, NULL, WCUT_BAD_ARGUMENT, "reference: expected one of");
    refused(&history_alone, 1, &scan, NULL, WCUT_BAD_ARGUMENT, "reference: expected one of");
    refused(&changed, 1, &scan, NULL, WCUT_BAD_ARGUMENT, "reference: edges: expected a job");
    refused(&cad, 1, &scan, NULL, WCUT_NOT_FOUND, "a.STEP: cannot be read");
    refused(&lost, 1, &scan, NULL, WCUT_NOT_FOUND, "no.json");
    refused(&r, 0, &scan, NULL, WCUT_BAD_ARGUMENT, "scans: found 0");
    refused(&r, 1, NULL, NULL, WCUT_BAD_ARGUMENT, "scans: found 1");
    refused(&r, 1, &empty, NULL, WCUT_BAD_ARGUMENT, "scan 1: found 0 points");
    refused(&r, 1, &missing, NULL, WCUT_NOT_FOUND, "no.xyz");
    scan_point[7].y = NAN;
    refused(&r, 1, &scan, NULL, WCUT_BAD_ARGUMENT, "scan 1: point 8: found (");
    for (int k = 0; k < SCAN; k++) scan_point[k] = (wcut_vec3){k, 2, 3};
    refused(&r, 1, &scan, NULL, WCUT_DEGENERATE, "scan: found 3600 points on one line");
    scan = scan_of(flat, 0, 0.125);

    /* options */
    const struct {
        double chord, share, tolerance, support;
        int normals, bands, hold, threads;
        const char *datums, *text;
    } wrong[] = {{0, .5, 0, 0, 0, 0, 0, 1, NULL, "chord_tolerance: found 0"},
                 {1, 1.5, 0, 0, 0, 0, 0, 1, NULL, "share: found 1.5"},
                 {1, NAN, 0, 0, 0, 0, 0, 1, NULL, "share: found nan"},
                 {1, .5, -1, 0, 0, 0, 0, 1, NULL, "tolerance: found -1"},
                 {1, .5, 0, INFINITY, 0, 0, 0, 1, NULL, "support: found inf"},
                 {1, .5, 0, 0, 1, 0, 0, 1, NULL, "normals: found 1"},
                 {1, .5, 0, 0, 0, WCUT_BANDS_MAX, 0, 1, NULL, "bands: found 8"},
                 {1, .5, 0, 0, 0, 1, 0, 1, NULL, "band: found 0"},
                 {1, .5, 0, 0, 0, 0, -1, 1, NULL, "hold: found -1"},
                 {1, .5, 0, 0, 0, 0, 0, 0, NULL, "threads: found 0"},
                 {1, .5, 0, 0, 0, 0, 0, 1, "d.csv", "datums: expected a file and the method datum together"}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        wcut_compare_options o = wcut_compare_options_default();
        o.chord_tolerance = wrong[k].chord, o.share = wrong[k].share, o.tolerance = wrong[k].tolerance;
        o.support = wrong[k].support, o.normals = wrong[k].normals, o.bands = wrong[k].bands, o.band[0] = 0;
        o.hold = wrong[k].hold, o.threads = wrong[k].threads, o.datums = wrong[k].datums;
        refused(&r, 1, &scan, &o, WCUT_BAD_ARGUMENT, wrong[k].text);
    }
    wcut_mesh_destroy(plane);
    leave_folder();
}

TEST(every_failed_allocation_is_told_and_leaves_nothing) {
    enter_folder();
    wcut_mesh *plane = sheet(flat);
    wcut_compare_scan scan = scan_of(flat, 0, 0.125);
    scan.count = 600;
    const wcut_compare_reference r = {.mesh = plane};
    wcut_compare_options o = wcut_compare_options_default();
    o.method = WCUT_REGISTRATION_METHOD_FIT, o.normals = 6, o.reconstruct = true, o.feet = true;
    o.clean.duplicate = 0;
    o.registration.coarse = 0;
    wcut_results *results = begin_results("out");
    wcut_compare_result *c = NULL;
    EACH_FAILED_ALLOCATION_BY(7, wcut_compare_run(&r, 1, &scan, &o, results, NULL, &c, NULL), c == NULL);
    ck_assert_ptr_nonnull(c->normal);
    wcut_compare_destroy(c);
    wcut_results_destroy(results);
    ck_assert_int_eq(count_entries("out"), 0);
    ck_assert_int_eq(rmdir("out"), 0);
    wcut_mesh_destroy(plane);
    leave_folder();
}
