/* Hostile calls of what reads and writes files: io, in a folder of its own; and of moulds and robot programs, whose
   results are files. */
#include "hostile/sound.h"
#include "io/given.h"
#include "io/process/diagnosis_given.h"

#define ERR OPT(NULL)

/* every test has an empty folder, with the files that are read */
static void begin(void) {
    wcut_error error = {0};
    enter_folder();
    write_file("case.json",
               "{\"format\": \"wirecut-case/1\", \"name\": \"c\", \"cuts\": [{\"job\": \"job.json\", "
               "\"recording\": \"r.csv\", \"scan\": null}], \"calibration\": null}");
    write_file("d.json",
               "{\"format\": \"wirecut-diagnosis/1\", \"correction\": {\"a_N_per_mm\": 0.1, \"b_m2_per_J\": 8e-4, "
               "\"length_change_mm\": 0, \"kerf\": null}}");
    write_file("points.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0.5\n");
    write_file("table.csv", "x,y\n1,2\n3,4\n");
    write_file("sheet.off", "OFF\n3 1 0\n0 0 0\n10 0 0\n10 10 0\n3 0 1 2\n");
    write_file("datums.csv",
               "scan_x_mm,scan_y_mm,scan_z_mm,block_x_mm,block_y_mm,block_z_mm,sigma_mm\n1,2,3,4,5,6,0.5\n"
               "7,8,9,,0,,0.25\n");
    write_file("edges.csv", "x_mm,y_mm,z_mm\n0,0,100\n0,300,120\n0,600,90\n0,900,100\n");
    ck_assert_msg(wcut_job_write(sound_job(), "job.json", &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_recording_write(sound_recording(), NULL, "r.csv", &error) == WCUT_OK, "%s", error.text);
}
FIXTURE(begin, leave_folder);

static wcut_mesh *mesh(void) {
    static wcut_mesh *m;
    if (!m) ck_assert_int_eq(wcut_face_mesh(sound_face(), &m), WCUT_OK);
    return m;
}

/* a mesh with a value and without one at each vertex */
static double *value_of_mesh(void) { return calloc((size_t)mesh()->vertex_count, sizeof(double)); }

static wcut_shape *shape(void) {
    static wcut_shape s;
    s = (wcut_shape){.name = "face", .surface = sound_face()->surface};
    return &s;
}

/* ---- jobs, cases, recordings, tables ---- */

HOSTILE_MADE(wcut_job_read, wcut_job, wcut_job_destroy, PTR("job.json"), PTR(&made), ERR)
HOSTILE_FILE(wcut_job_write, PTR(sound_job()), PTR(OUT_FILE), ERR)
HOSTILE_MADE(wcut_case_read, wcut_case, wcut_case_destroy, PTR("case.json"), PTR(&made), ERR)
HOSTILE_VALUE(wcut_case_destroy, NULL)
HOSTILE(wcut_correction_read) {
    wcut_correction c = {.a = 999};
    EACH_HOSTILE_ARGUMENT(wcut_correction_read, wcut_correction_read(PTR("d.json"), PTR(&c), ERR), c.a == 999,
                          c.a = 999);
}

HOSTILE(wcut_rig_prior_read) {
    wcut_rig_prior prior = {.tension_delay = 999};
    EACH_HOSTILE_ARGUMENT(wcut_rig_prior_read,
                          wcut_rig_prior_read(PTR(WCUT_SOURCE_DIR "/samples/rig.json"), PTR(&prior), ERR),
                          prior.tension_delay == 999, prior.tension_delay = 999);
}
HOSTILE_MADE(wcut_recording_read, wcut_recording, wcut_recording_destroy, PTR("r.csv"),
             OPT(&(wcut_recording_format){0}), PTR(&made), ERR)
HOSTILE_VALUE(wcut_recording_format_clear, NULL)
HOSTILE(wcut_recording_format_parse) {
    wcut_recording_format format = {.period = 999};
    EACH_HOSTILE_ARGUMENT(wcut_recording_format_parse, wcut_recording_format_parse(PTR("time_s=t"), PTR(&format), ERR),
                          format.period == 999, (wcut_recording_format_clear(&format), format.period = 999));
}
HOSTILE_FILE(wcut_recording_write, PTR(sound_recording()), OPT("a note"), PTR(OUT_FILE), ERR)
HOSTILE_VALUE(wcut_channel_name, ANY_ENUM(WCUT_CHANNEL_TIME))
HOSTILE_VALUE(wcut_table_destroy, NULL)
HOSTILE_FILE(wcut_history_write_csv, PTR(sound_history()), PTR(sound_job()->mount_a), PTR(sound_job()->mount_b),
             PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_history_write_vtp, PTR(sound_history()), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_summary_write, PTR(sound_setup()), PTR(sound_history()), PTR(OUT_FILE), ERR)
HOSTILE_TEXT(wcut_summary_print, PTR(sound_setup()), PTR(sound_history()), PTR(&made))

HOSTILE(wcut_format_read) {
    char format[64] = "999";
    EACH_HOSTILE_ARGUMENT(wcut_format_read, wcut_format_read(PTR("job.json"), PTR(&format[0]), ERR),
                          strcmp(format, "999") == 0, strcpy(format, "999"));
}

HOSTILE(wcut_file_hash) {
    char text[65] = "999";
    EACH_HOSTILE_ARGUMENT(wcut_file_hash, wcut_file_hash(PTR("job.json"), PTR(&text[0]), ERR), strcmp(text, "999") == 0,
                          strcpy(text, "999"));
}

HOSTILE(wcut_source_hash) {
    char text[65] = "999";
    EACH_HOSTILE_ARGUMENT(wcut_source_hash, wcut_source_hash(OPT("job.json"), PTR(&text[0]), ERR),
                          strcmp(text, "999") == 0, strcpy(text, "999"));
}

/* ---- sets of results ---- */

static const char *const result_name[1] = {"a"};
static wcut_results *set;

/* a set with the file b written, c taken in */
static wcut_results *fresh_set(void) {
    wcut_results_destroy(set);
    set = NULL;
    ck_assert_int_eq(wcut_results_create("results", 1, result_name, &set, NULL), WCUT_OK);
    write_file(wcut_results_path(set, "b"), "1");
    write_file(wcut_results_path(set, "c"), "2");
    ck_assert_int_eq(wcut_results_add(set, "c", NULL), WCUT_OK);
    return set;
}

/* the folder of the tests holds files alone when it is left */
static void forget_set(void) {
    wcut_results_destroy(set);
    set = NULL;
    remove("results/v.json");
    remove("results/c");
    remove("results");
}

HOSTILE(wcut_results_create) {
    wcut_results *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_results_create,
                          wcut_results_create(PTR("results"), COUNT(1), PTR(&result_name[0]), PTR(&made), ERR),
                          made == MARK, (wcut_results_destroy(made), made = MARK));
    forget_set();
}

HOSTILE(wcut_results_path) {
    for (hostile_begin(); hostile_next();) wcut_results_path(PTR(fresh_set()), PTR("d"));
    hostile_end("wcut_results_path");
    forget_set();
}

HOSTILE(wcut_results_add) {
    EACH_HOSTILE_ARGUMENT(wcut_results_add, wcut_results_add(PTR(fresh_set()), PTR("b"), ERR), true, (void)0);
    forget_set();
}

HOSTILE(wcut_results_reword) {
    wcut_error error = {WCUT_OK, "text"};
    for (hostile_begin(); hostile_next();) wcut_results_reword(OPT(fresh_set()), OPT(&error));
    hostile_end("wcut_results_reword");
    forget_set();
}

HOSTILE(wcut_results_commit) {
    char *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_results_commit,
                          wcut_results_commit(PTR(fresh_set()), PTR("v.json"), PTR("{}"), OPT(&made), ERR),
                          made == MARK, (made != MARK ? free(made) : (void)0, made = MARK));
    forget_set();
}

HOSTILE_VALUE(wcut_results_destroy, NULL)

HOSTILE(wcut_results_verify) {
    wcut_verification *made = MARK;
    ck_assert_int_eq(wcut_results_commit(fresh_set(), "v.json", "{}", NULL, NULL), WCUT_OK);
    EACH_HOSTILE_ARGUMENT(wcut_results_verify, wcut_results_verify(PTR("results"), PTR(&made), ERR), made == MARK,
                          (wcut_verification_destroy(made), made = MARK));
    forget_set();
}

HOSTILE_VALUE(wcut_verification_destroy, NULL)

HOSTILE(wcut_job_read_force_law) {
    wcut_job *job = NULL;
    write_file(
        "law.json",
        "{\"format\": \"wirecut-force-law/1\", \"process\": {\"force_law\": {\"a_N_per_mm\": 0.1, \"b_m2_per_J\": "
        "8e-4}}}");
    ck_assert_int_eq(wcut_job_read("job.json", &job, NULL), WCUT_OK);
    for (hostile_begin(); hostile_next();) wcut_job_read_force_law(PTR(job), PTR("law.json"), ERR);
    hostile_end("wcut_job_read_force_law");
    wcut_job_destroy(job);
}

HOSTILE(wcut_job_read_edges) {
    wcut_job *job = NULL;
    write_file("design.json", given_design_job);
    ck_assert_int_eq(wcut_job_read("design.json", &job, NULL), WCUT_OK);
    for (hostile_begin(); hostile_next();) wcut_job_read_edges(PTR(job), PTR("table.csv"), ERR);
    hostile_end("wcut_job_read_edges");
    wcut_job_destroy(job);
}

HOSTILE(wcut_table_read) {
    const char *const numeric[2] = {"x", "y"};
    wcut_table *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_table_read,
                          wcut_table_read(PTR("table.csv"), COUNT(2), PTR(&numeric[0]), PTR(&made), ERR), made == MARK,
                          (wcut_table_destroy(made), made = MARK));
}

HOSTILE(wcut_table_locate) {
    wcut_table *table = NULL;
    const char *const numeric[1] = {"x"};
    ck_assert_int_eq(wcut_table_read("table.csv", 1, numeric, &table, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_table_locate(table, "y"), 1);
    ck_assert_int_eq(wcut_table_locate(table, ""), -1);
    wcut_table_destroy(table);
}

HOSTILE(wcut_vtp_stream_create) {
    wcut_vtp_stream *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_vtp_stream_create,
                          wcut_vtp_stream_create(PTR(OUT_FILE), COUNT(2), COUNT(25), PTR(&made), ERR), made == MARK,
                          (wcut_vtp_stream_destroy(made), made = MARK));
}

HOSTILE(wcut_vtp_stream_append) {
    wcut_vtp_stream *stream = NULL;
    wcut_cut *cut = NULL;
    wcut_station station;
    ck_assert_int_eq(wcut_cut_create(sound_setup(), &cut, NULL), WCUT_OK);
    wcut_cut_view(cut, &station);
    ck_assert_int_eq(wcut_vtp_stream_create(OUT_FILE, 81, 25, &stream, NULL), WCUT_OK);
    EACH_HOSTILE_ARGUMENT(wcut_vtp_stream_append, wcut_vtp_stream_append(PTR(stream), PTR(&station), ERR), true,
                          (void)0);
    wcut_vtp_stream_destroy(stream);
    wcut_cut_destroy(cut);
    ck_assert_int_ne(access(OUT_FILE, F_OK), 0);
}

HOSTILE(wcut_vtp_stream_commit) { ck_assert_int_eq(wcut_vtp_stream_commit(NULL, NULL), WCUT_BAD_ARGUMENT); }
HOSTILE_VALUE(wcut_vtp_stream_destroy, NULL)

/* ---- calibration, scores, diagnosis ---- */

static const char table_text[] =
    "heat_W_per_m,speed_mm_s,engaged_mm,tension_a_N,tension_b_N,alpha_a_deg,alpha_b_deg\n"
    "50,5,400,8,8,30,30\n50,8,400,12,12,30,30\n60,5,400,7,7,30,30\n60,9,400,11,11,30,30\n70,7,400,8,8,30,30\n"
    "70,11,400,13,13,30,30\n";
static const wcut_test_cut *law_cuts(int *n) {
    static wcut_test_cut cut[8];
    for (int k = 0; k < 8; k++) {
        const double q = 4000 + 700 * k, line = 0.1 * exp(-8.6e-4 * q / 3) * (1 + 0.01 * (k % 3));
        cut[k] = (wcut_test_cut){.heat = 60,
                                 .speed = 60e3 / q,
                                 .engaged = 400,
                                 .tension_a = 200 * line / sin(0.5),
                                 .tension_b = 200 * line / sin(0.5),
                                 .alpha_a = 0.5,
                                 .alpha_b = 0.5,
                                 .weight = 1};
    }
    *n = 8;
    return cut;
}
static const wcut_calibration_point *law_points(wcut_calibration *c) {
    static wcut_calibration_point point[8];
    int n = 0;
    const wcut_test_cut *cut = law_cuts(&n);
    ck_assert_int_eq(wcut_calibration_fit(n, cut, NULL, c, point, NULL), WCUT_OK);
    return point;
}

HOSTILE(wcut_calibration_table_read) {
    write_file("calibration.csv", table_text);
    wcut_test_cut *made = MARK;
    int n = 999;
    EACH_HOSTILE_ARGUMENT(wcut_calibration_table_read,
                          wcut_calibration_table_read(PTR(WCUT_SOURCE_DIR "/samples/calibration/table.csv"), OPT(NULL),
                                                      PTR(&n), PTR(&made), ERR),
                          made == MARK && n == 999, (wcut_test_cut_destroy(made), made = MARK, n = 999));
}

HOSTILE(wcut_force_law_write) {
    int n;
    wcut_calibration c;
    const wcut_test_cut *cut = law_cuts(&n);
    const wcut_calibration_point *point = law_points(&c);
    const wcut_calibration_options o = wcut_calibration_options_default();
    EACH_HOSTILE_ARGUMENT(wcut_force_law_write,
                          wcut_force_law_write(COUNT(n), PTR(cut), OPT(&o), PTR(&c), PTR(point), PTR(OUT_FILE), ERR),
                          access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
}

HOSTILE(wcut_force_law_print) {
    int n;
    wcut_calibration c;
    const wcut_test_cut *cut = law_cuts(&n);
    const wcut_calibration_point *point = law_points(&c);
    char *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_force_law_print,
                          wcut_force_law_print(COUNT(n), PTR(cut), NULL, PTR(&c), PTR(point), PTR(&made)), made == MARK,
                          (free(made), made = MARK));
}

static const wcut_scored_cut *scored(void) {
    static wcut_scored_cut cut;
    static wcut_comparison *c;
    wcut_comparison_options o = wcut_comparison_options_default();
    o.settle = o.leave = 0;
    if (!c) ck_assert_int_eq(wcut_comparison_create(sound_job(), long_recording(), &o, &c, NULL), WCUT_OK);
    cut = (wcut_scored_cut){"one", "cut", "job.json", "r.csv", long_recording(), c, NULL};
    return &cut;
}

HOSTILE_TEXT(wcut_score_print, COUNT(1), PTR(scored()), OPT(NULL), PTR(&made))
HOSTILE_FILE(wcut_score_write, COUNT(1), PTR(scored()), OPT(NULL), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_residuals_write, COUNT(1), PTR(scored()), PTR(OUT_FILE), ERR)

static given_diagnosis diagnosed;
static wcut_diagnosis *diagnosis(void) {
    give_diagnosis(&diagnosed);
    return &diagnosed.d;
}

HOSTILE_TEXT(wcut_diagnosis_print, PTR(diagnosis()), PTR("c"), PTR(&made))
HOSTILE_FILE(wcut_diagnosis_write, PTR(diagnosis()), PTR("c"), PTR(OUT_FILE), ERR)

/* ---- clouds, meshes, curves ---- */

HOSTILE_MADE(wcut_cloud_read, wcut_cloud, wcut_cloud_destroy, PTR("points.xyz"), OPT(NULL), PTR(&made), ERR)
HOSTILE_MADE(wcut_cloud_source_create, wcut_cloud_source, wcut_cloud_source_destroy, PTR("points.xyz"), OPT(NULL),
             PTR(&made), ERR)

HOSTILE(wcut_cloud_source_next) {
    wcut_cloud_source *source = NULL;
    wcut_vec3 point[8];
    int count = 999;
    ck_assert_int_eq(wcut_cloud_source_create("points.xyz", NULL, &source, NULL), WCUT_OK);
    EACH_HOSTILE_ARGUMENT(wcut_cloud_source_next,
                          wcut_cloud_source_next(PTR(source), COUNT(8), PTR(&point[0]), OPT(NULL), PTR(&count), ERR),
                          count == 999, count = 999);
    wcut_cloud_source_destroy(source);
}

HOSTILE(wcut_cloud_source_info) {
    wcut_cloud_source *source = NULL;
    ck_assert_int_eq(wcut_cloud_source_create("points.xyz", NULL, &source, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_cloud_source_info(source)->not_finite, 0);
    wcut_cloud_source_destroy(source);
}

HOSTILE_MADE(wcut_datums_read, wcut_datums, wcut_datums_destroy, PTR("datums.csv"), PTR(&made), ERR)
HOSTILE_VALUE(wcut_mesh_read_options_default, )
HOSTILE_VALUE(wcut_curve_read_options_default, )
HOSTILE_VALUE(wcut_curve_set_destroy, NULL)
HOSTILE_FILE(wcut_mesh_write_stl, PTR(mesh()), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_mesh_write_obj, PTR(mesh()), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_mesh_write_ply, PTR(mesh()), OPT("force"), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_mesh_write_glb, PTR(mesh()), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_step_write, COUNT(1), PTR(shape()), ENUM(WCUT_STEP_SCHEMA_AP214), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_iges_write, COUNT(1), PTR(shape()), PTR(OUT_FILE), ERR)

HOSTILE(wcut_mesh_read) {
    const wcut_mesh_read_options o = wcut_mesh_read_options_default();
    wcut_mesh *made = MARK;
    wcut_mesh_read_info info = {.split = 999};
    EACH_HOSTILE_ARGUMENT(wcut_mesh_read, wcut_mesh_read(PTR("sheet.off"), RECORD(&o), PTR(&made), OPT(&info), ERR),
                          made == MARK && info.split == 999, (wcut_mesh_destroy(made), made = MARK, info.split = 999));
}

HOSTILE(wcut_curve_set_read) {
    wcut_curve *curve = NULL;
    const wcut_vec3 p[3] = {{0, 0, 0}, {10, 5, 0}, {20, 0, 0}};
    ck_assert_int_eq(wcut_curve_interpolate(3, p, &curve), WCUT_OK);
    const wcut_shape s = {.name = "c", .curve = curve};
    ck_assert_int_eq(wcut_iges_write(1, &s, "c.igs", NULL), WCUT_OK);
    wcut_curve_set *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_curve_set_read, wcut_curve_set_read(PTR("c.igs"), OPT(NULL), PTR(&made), ERR),
                          made == MARK, (wcut_curve_set_destroy(made), made = MARK));
    wcut_curve_destroy(curve);
}

/* a zone and a section over the first quadrant */
static const wcut_regions *sound_regions(void) {
    static double line[4] = {0, 0, 100, 0};
    static wcut_region zone = {.name = "z", .high = {100, 100, 100}, .tolerance = 1, .share = 0.5};
    static wcut_section section = {.name = "s", .points = 2, .point = line, .width = 1, .step = 10};
    static const wcut_regions regions = {1, &zone, 1, &section};
    return &regions;
}

static wcut_survey *sound_survey(void) {
    static wcut_survey *survey;
    if (!survey) ck_assert_int_eq(wcut_survey_create(sound_regions(), 0, NULL, &survey), WCUT_OK);
    return survey;
}

HOSTILE(wcut_regions_read) {
    FILE *file = fopen("zones.json", "w");
    ck_assert_ptr_nonnull(file);
    fputs("{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"a\", \"box_mm\": [[0,0,0],[1,1,1]]}]}", file);
    ck_assert_int_eq(fclose(file), 0);
    wcut_regions *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_regions_read, wcut_regions_read(PTR("zones.json"), PTR(&made), ERR), made == MARK,
                          (wcut_regions_destroy(made), made = MARK));
}
HOSTILE_VALUE(wcut_regions_destroy, NULL)
static const double survey_band[2] = {0.5, 1};
HOSTILE_MADE(wcut_survey_create, wcut_survey, wcut_survey_destroy, PTR(sound_regions()), COUNT(2),
             VALUES(survey_band, 2), PTR(&made))
HOSTILE_VALUE(wcut_survey_eval, OPT(sound_survey()))
HOSTILE_VALUE(wcut_survey_destroy, NULL)

HOSTILE(wcut_survey_add) {
    static const wcut_vec3 point[2] = {{1, 1, 1}, {2, 2, 2}};
    static const wcut_deviation deviation[2] = {{.distance = 1}, {.distance = NAN}};
    EACH_HOSTILE_ARGUMENT(wcut_survey_add,
                          wcut_survey_add(PTR(sound_survey()), COUNT(2), PTR(&point[0]), PTR(&deviation[0])), true,
                          (void)0);
}
HOSTILE_FILE(wcut_sections_write, PTR(wcut_survey_eval(sound_survey())), PTR(OUT_FILE), ERR)

HOSTILE(wcut_trimmed_set_read) {
    static const double knot[4] = {0, 0, 1, 1};
    static const wcut_vec3 corner[4] = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {10, 10, 0}};
    wcut_surface *surface = NULL;
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, knot, knot, corner, NULL, &surface), WCUT_OK);
    const wcut_shape s = {.name = "s", .surface = surface};
    ck_assert_int_eq(wcut_iges_write(1, &s, "s.igs", NULL), WCUT_OK);
    wcut_trimmed_set *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_trimmed_set_read, wcut_trimmed_set_read(PTR("s.igs"), PTR(&made), ERR), made == MARK,
                          (wcut_trimmed_set_destroy(made), made = MARK));
    wcut_surface_destroy(surface);
}
HOSTILE_VALUE(wcut_trimmed_set_destroy, NULL)

static const wcut_trimmed_set *empty_set(void) {
    static const wcut_trimmed_set empty;
    return &empty;
}

HOSTILE_VALUE(wcut_trimmed_set_find, OPT(empty_set()), OPT("1"), 1)

HOSTILE(wcut_mesh_write_3mf) {
    const wcut_mesh_object all[1] = {{.mesh = mesh(), .name = "face"}};
    /* a sheet is no solid: what is refused anyway must be refused without harm */
    for (hostile_begin(); hostile_next();) wcut_mesh_write_3mf(COUNT(1), PTR(&all[0]), PTR(OUT_FILE), ERR);
    hostile_end("wcut_mesh_write_3mf");
}

HOSTILE_MADE(wcut_stl_stream_create, wcut_stl_stream, wcut_stl_stream_destroy, PTR(OUT_FILE), PTR(&made), ERR)
HOSTILE_VALUE(wcut_stl_stream_destroy, NULL)
HOSTILE(wcut_stl_stream_commit) { ck_assert_int_eq(wcut_stl_stream_commit(NULL, NULL), WCUT_BAD_ARGUMENT); }

HOSTILE(wcut_stl_stream_append) {
    wcut_stl_stream *stream = NULL;
    const wcut_vec3 corner[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    ck_assert_int_eq(wcut_stl_stream_create(OUT_FILE, &stream, NULL), WCUT_OK);
    EACH_HOSTILE_ARGUMENT(wcut_stl_stream_append, wcut_stl_stream_append(PTR(stream), COUNT(1), VALUES(corner, 3), ERR),
                          true, (void)0);
    wcut_stl_stream_destroy(stream);
}

/* ---- deviations ---- */

static wcut_compared *compared(void) {
    static wcut_deviation_summary *summary;
    static const wcut_deviation_summary_result *found;
    static wcut_registration registration;
    static wcut_statistics back = {.count = 5, .max = 3.25, .mean = 1.5};
    static const wcut_compared_scan scan = {"points.xyz", "", 600, 0, 0};
    static wcut_compared c;
    wcut_deviation_summary_options o = wcut_deviation_summary_options_default();
    o.high = sound_job()->block_size;
    if (!summary) {
        ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, &summary), WCUT_OK);
        ck_assert_int_eq(wcut_deviation_summary_add(summary, SCAN, sound_deviation()), WCUT_OK);
        ck_assert_int_eq(wcut_deviation_summary_eval(summary, &found), WCUT_OK);
    }
    registration = wcut_registration_none();
    c = (wcut_compared){.reference = "job.json",
                        .distance = "surface",
                        .scans = 1,
                        .scan = &scan,
                        .removed = {SCAN},
                        .registration = &registration,
                        .found = found,
                        .unmoved = found,
                        .face_to_scan = &back,
                        .kerf = 1,
                        .has_kerf = 1,
                        .unmeasured = 12.5,
                        .support = 1.5,
                        .tolerance = 0.25,
                        .share = 0.95};
    return &c;
}

HOSTILE_TEXT(wcut_deviation_print, PTR(compared()), PTR(&made))
HOSTILE_FILE(wcut_deviation_write, PTR(compared()), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_zones_write, PTR(compared()->found), OPT(NULL), PTR(OUT_FILE), ERR)

HOSTILE(wcut_deviation_mesh_write_ply) {
    double *value = value_of_mesh();
    EACH_HOSTILE_ARGUMENT(wcut_deviation_mesh_write_ply,
                          wcut_deviation_mesh_write_ply(PTR(mesh()), VALUES(value, mesh()->vertex_count), OPT(NULL),
                                                        NUM(1), PTR(OUT_FILE), ERR),
                          access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
    free(value);
}

HOSTILE(wcut_deviation_mesh_write_obj) {
    double *value = value_of_mesh();
    EACH_HOSTILE_ARGUMENT(wcut_deviation_mesh_write_obj,
                          wcut_deviation_mesh_write_obj(PTR(mesh()), VALUES(value, mesh()->vertex_count), OPT(NULL),
                                                        NUM(1), PTR(OUT_FILE), ERR),
                          access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
    free(value);
}

HOSTILE_MADE(wcut_deviation_stream_create, wcut_deviation_stream, wcut_deviation_stream_destroy, PTR(OUT_FILE), NUM(1),
             0, PTR(&made), ERR)
HOSTILE_VALUE(wcut_deviation_stream_destroy, NULL)
HOSTILE(wcut_deviation_stream_commit) { ck_assert_int_eq(wcut_deviation_stream_commit(NULL, NULL), WCUT_BAD_ARGUMENT); }

HOSTILE(wcut_deviation_stream_append) {
    wcut_deviation_stream *stream = NULL;
    ck_assert_int_eq(wcut_deviation_stream_create(OUT_FILE, 1, 0, &stream, NULL), WCUT_OK);
    EACH_HOSTILE_ARGUMENT(wcut_deviation_stream_append,
                          wcut_deviation_stream_append(PTR(stream), COUNT(SCAN), VALUES(sound_scan(), SCAN), OPT(NULL),
                                                       PTR(sound_deviation()), ERR),
                          true, (void)0);
    wcut_deviation_stream_destroy(stream);
}

/* ---- moulds ---- */

static wcut_mould *mould(void) {
    static wcut_mould *m;
    wcut_error error = {0};
    if (!m) {
        const wcut_status status = wcut_mould_create(sound_face()->surface, sound_job()->block_size, NULL, &m, &error);
        ck_assert_msg(status == WCUT_OK, "%s", error.text);
    }
    return m;
}

HOSTILE_VALUE(wcut_mould_default, )
HOSTILE_VALUE(wcut_mould_destroy, NULL)
HOSTILE_MADE(wcut_mould_create, wcut_mould, wcut_mould_destroy, PTR(sound_face()->surface),
             VEC(sound_job()->block_size), OPT(NULL), PTR(&made), ERR)
HOSTILE_ARRAY(wcut_keys_at_corners, wcut_key, WCUT_KEYS_AT_CORNERS, VEC(sound_job()->block_size), NUM(10), NUM(6))
HOSTILE_TEXT(wcut_mould_print, PTR(mould()), PTR("m"), PTR(&made))
HOSTILE_FILE(wcut_mould_write, PTR(mould()), PTR("m"), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_mould_write_3mf, PTR(mould()), PTR("m"), COUNT(3), ANY_INT(0), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_mould_write_step, PTR(mould()), PTR("m"), ANY_ENUM(WCUT_MOULD_PART_LOWER),
             ANY_ENUM(WCUT_STEP_SCHEMA_AP214), PTR(OUT_FILE), ERR)

/* ---- robots, the rig ---- */

static wcut_robot_motion *motion(void) {
    static wcut_robot_motion *m;
    const wcut_robot_options o = wcut_robot_options_default();
    if (!m)
        ck_assert_int_eq(
            wcut_robot_motion_create(sound_history(), sound_job()->mount_a, sound_job()->mount_b, &o, &m, NULL),
            WCUT_OK);
    return m;
}

HOSTILE_VALUE(wcut_robot_options_default, )
HOSTILE_VALUE(wcut_robot_names_default, )
HOSTILE_VALUE(wcut_robot_limits_default, sound_job())
HOSTILE_VALUE(wcut_robot_motion_destroy, NULL)
HOSTILE_VALUE(wcut_robot_file_name, ANY_ENUM(WCUT_ROBOT_FORMAT_KRL), ANY_INT(0))
HOSTILE_VALUE(wcut_robot_format_name, ANY_ENUM(WCUT_ROBOT_FORMAT_KRL))
HOSTILE_OUT(wcut_wire_temperature, double, NUM(60), NUM(0.15), NUM(20), NUM(0.7))
HOSTILE_FILE(wcut_robot_write, PTR(motion()), OPT(NULL), ENUM(WCUT_ROBOT_FORMAT_KRL), INT(0), PTR(OUT_FILE), ERR)

HOSTILE(wcut_robot_motion_create) {
    const wcut_robot_options o = wcut_robot_options_default();
    wcut_robot_motion *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_robot_motion_create,
                          wcut_robot_motion_create(PTR(sound_history()), PTR(sound_job()->mount_a),
                                                   PTR(sound_job()->mount_b), RECORD_WORDS(&o, 0, 6), PTR(&made), ERR),
                          made == MARK, (wcut_robot_motion_destroy(made), made = MARK));
}

HOSTILE(wcut_robot_limits_check) {
    const wcut_robot_limits limits = wcut_robot_limits_default(sound_job());
    wcut_robot_check check[WCUT_ROBOT_CHECKS];
    hostile_fill(check, sizeof check);
    EACH_HOSTILE_ARGUMENT(wcut_robot_limits_check,
                          wcut_robot_limits_check(PTR(sound_job()), PTR(sound_history()), PTR(sound_job()->mount_a),
                                                  PTR(sound_job()->mount_b), RECORD(&limits), PTR(&check[0])),
                          hostile_is_filled(check, sizeof check), hostile_fill(check, sizeof check));
}

HOSTILE(wcut_robot_summary_print) {
    const wcut_robot_limits limits = wcut_robot_limits_default(sound_job());
    wcut_robot_check check[WCUT_ROBOT_CHECKS];
    wcut_path_near near[2];
    memset(near, 0, sizeof near);
    ck_assert_int_eq(wcut_robot_limits_check(sound_job(), sound_history(), sound_job()->mount_a, sound_job()->mount_b,
                                             &limits, check),
                     WCUT_OK);
    const wcut_robot_summary s = {sound_job(), motion(), check, near, WCUT_ROBOT_FORMAT_KRL};
    char *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_robot_summary_print, wcut_robot_summary_print(PTR(&s), PTR(&made)), made == MARK,
                          (free(made), made = MARK));
}

/* a run through the first third of the block */
static int stop_late(int station, int stations, void *context) {
    (void)context;
    return station > stations / 3;
}

static wcut_rig_summary *rig(void) {
    static wcut_rig_run *run;
    static wcut_control_settings settings;
    static wcut_rig_options options;
    static wcut_rig_summary s;
    settings = wcut_control_settings_default(sound_job()), options = wcut_rig_options_default(sound_job());
    if (!run)
        ck_assert_int_eq(
            wcut_rig_run_create(sound_job(), sound_history(), &settings, &options, stop_late, NULL, &run, NULL),
            WCUT_INTERRUPTED);
    s = (wcut_rig_summary){sound_job(), &settings, &options, run, run, false};
    return &s;
}

HOSTILE_TEXT(wcut_rig_summary_print, PTR(rig()), PTR(&made))
HOSTILE_FILE(wcut_rig_summary_write, PTR(rig()), PTR(OUT_FILE), ERR)

/* ---- report pages ---- */

HOSTILE_FILE(wcut_report_control_write, PTR(rig()), PTR("job.json"), PTR(OUT_FILE), ERR)

HOSTILE(wcut_report_simulate_write) {
    const wcut_report_simulate run = {"job.json", "implicit", 0.1, 1, WCUT_OK};
    EACH_HOSTILE_ARGUMENT(
        wcut_report_simulate_write,
        wcut_report_simulate_write(PTR(&run), PTR(sound_setup()), PTR(sound_history()), PTR(OUT_FILE), ERR),
        access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
}

static const wcut_report_calibrate *calibrated(void) {
    static wcut_calibration c;
    static wcut_calibration_options o;
    static wcut_report_calibrate page;
    int n = 0;
    const wcut_test_cut *cut = law_cuts(&n);
    o = wcut_calibration_options_default();
    page = (wcut_report_calibrate){
        WCUT_SOURCE_DIR "/samples/calibration/table.csv", "relative", n, cut, &o, &c, NULL, 0, NULL};
    page.point = law_points(&c);
    return &page;
}

HOSTILE_FILE(wcut_report_calibrate_write, PTR(calibrated()), PTR(OUT_FILE), ERR)

HOSTILE(wcut_report_calibrate_scatter) {
    char sentence[WCUT_REPORT_SENTENCE] = "";
    wcut_report_calibrate_scatter(calibrated(), &calibrated()->fit->force, sentence);
    ck_assert_uint_lt(strlen(sentence), WCUT_REPORT_SENTENCE);
}

HOSTILE(wcut_report_calibrate_lack) {
    char sentence[WCUT_REPORT_SENTENCE] = "";
    wcut_law_fit fit = calibrated()->fit->force;
    fit.lack = (wcut_lack_of_fit)99, fit.lack_p = (double)NAN, fit.lack_f = (double)INFINITY;
    wcut_report_calibrate_lack(&fit, sentence);
    ck_assert_uint_lt(strlen(sentence), WCUT_REPORT_SENTENCE);
}

HOSTILE(wcut_report_diagnose_write) {
    const char *const name[3] = {"one", "two", "three"};
    const wcut_report_diagnose page = {.title = "c", .diagnosis = diagnosis(), .cut_name = name};
    EACH_HOSTILE_ARGUMENT(wcut_report_diagnose_write, wcut_report_diagnose_write(PTR(&page), PTR(OUT_FILE), ERR),
                          access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
}

HOSTILE(wcut_report_mould_write) {
    const wcut_report_mould run = {"job.json", NULL, NULL, 0.1, 0.1, 0};
    EACH_HOSTILE_ARGUMENT(
        wcut_report_mould_write,
        wcut_report_mould_write(PTR(&run), PTR(sound_job()), OPT(sound_history()), PTR(mould()), PTR(OUT_FILE), ERR),
        access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
}

HOSTILE(wcut_report_compare_write) {
    static double size[SCAN];
    double *value = value_of_mesh();
    unsigned char *present = calloc((size_t)mesh()->vertex_count, 1);
    for (int k = 0; k < SCAN; k++) size[k] = sound_deviation()[k].distance;
    const wcut_report_compare page = {.compared = compared(),
                                      .face = sound_face(),
                                      .stations = 0,
                                      .mesh = mesh(),
                                      .value = value,
                                      .present = present,
                                      .points = SCAN,
                                      .point = sound_scan(),
                                      .deviation = size,
                                      .unit = "mm",
                                      .border = 1};
    EACH_HOSTILE_ARGUMENT(wcut_report_compare_write, wcut_report_compare_write(PTR(&page), PTR(OUT_FILE), ERR),
                          access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
    EACH_FAILED_ALLOCATION(wcut_report_compare_write(&page, OUT_FILE, NULL), access(OUT_FILE, F_OK) != 0);

    /* counts that the page has no room for, a face that is not the mesh's, arrays that are missing */
    wcut_error error;
    wcut_report_compare other = page;
    wcut_compared figures = *compared();
    wcut_deviation_summary_result crowded = *figures.found;
    crowded.worsts = WCUT_WORST_MAX + 1;
    figures.found = &crowded;
    other.compared = &figures;
    ck_assert_int_eq(wcut_report_compare_write(&other, OUT_FILE, &error), WCUT_BAD_ARGUMENT);
    other = page;
    other.stations = 2;
    ck_assert_int_eq(wcut_report_compare_write(&other, OUT_FILE, &error), WCUT_BAD_ARGUMENT);
    wcut_mesh small = *mesh();
    small.vertex_count--;
    other = page;
    other.mesh = &small;
    ck_assert_int_eq(wcut_report_compare_write(&other, OUT_FILE, &error), WCUT_BAD_ARGUMENT);
    free(present);
    free(value);
}

static const wcut_compare_reference *compared_mesh(void) {
    static wcut_compare_reference reference;
    reference.mesh = mesh();
    return &reference;
}

static const wcut_compare_scan *compared_scan(void) {
    static wcut_compare_scan scan = {.count = SCAN};
    scan.point = sound_scan();
    return &scan;
}

static wcut_compare_result *comparison_made(void) {
    static wcut_compare_result *result;
    if (!result)
        ck_assert_int_eq(wcut_compare_run(compared_mesh(), 1, compared_scan(), NULL, NULL, NULL, &result, NULL),
                         WCUT_OK);
    return result;
}

HOSTILE_VALUE(wcut_compare_options_default, )
HOSTILE_MADE(wcut_compare_run, wcut_compare_result, wcut_compare_destroy, PTR(compared_mesh()), COUNT(1),
             PTR(compared_scan()), OPT(NULL), OPT(NULL), OPT(NULL), PTR(&made), ERR)

HOSTILE_VALUE(wcut_compare_destroy, NULL)

HOSTILE(wcut_compare_files) {
    const char *name[WCUT_COMPARE_FILES_MAX];
    ck_assert_int_eq(wcut_compare_files(NULL, NULL), 0);
    ck_assert_int_eq(wcut_compare_files(comparison_made(), NULL), 0);
    ck_assert_int_eq(wcut_compare_files(comparison_made(), name), WCUT_COMPARE_FILES_MAX - 3);
}

/* one that was run without a set is refused, whatever else is broken */
HOSTILE(wcut_compare_write) {
    for (int broken = 0; broken < 3; broken++) {
        char *text = MARK;
        wcut_error error;
        ck_assert_int_eq(
            wcut_compare_write(broken == 0 ? NULL : comparison_made(), broken == 1 ? NULL : fresh_set(), &text, &error),
            WCUT_BAD_ARGUMENT);
        ck_assert_ptr_eq(text, MARK);
    }
    forget_set();
}

HOSTILE(wcut_report_score_write) {
    const char *const group[1] = {"one"};
    const wcut_comparison_options o = wcut_comparison_options_default();
    const wcut_scored_cut *cut = scored();
    static wcut_scores planned[2], replayed[2]; /* of the group and of all */
    planned[0] = planned[1] = cut->comparison->planned_score;
    replayed[0] = replayed[1] = cut->comparison->replayed_score;
    const wcut_report_score page = {.title = "c",
                                    .cuts = 1,
                                    .cut = cut,
                                    .groups = 1,
                                    .group_name = group,
                                    .planned = planned,
                                    .replayed = replayed,
                                    .group_label = "case",
                                    .options = &o,
                                    .nodes = 25};
    EACH_HOSTILE_ARGUMENT(wcut_report_score_write, wcut_report_score_write(PTR(&page), PTR(OUT_FILE), ERR),
                          access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
}

HOSTILE(wcut_report_write) {
    const wcut_report plain = {.verb = "v", .title = "t", .verdict = "w"};
    EACH_HOSTILE_ARGUMENT(wcut_report_write, wcut_report_write(PTR(&plain), PTR(OUT_FILE), ERR),
                          access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
}

/* ---- words ---- */

HOSTILE_VALUE(wcut_status_text, ANY_ENUM(WCUT_OK))
HOSTILE_VALUE(wcut_version_text, )
