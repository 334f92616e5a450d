/* Hostile calls of clouds, deviations, registration and reconstruction: kernel/scan. */
#include "hostile/sound.h"

static wcut_vec3 block_of(void) { return sound_job()->block_size; }

static wcut_foot *feet(void) {
    static wcut_foot foot[SCAN];
    if (foot[0].distance == 0)
        ck_assert_int_eq(wcut_projection_locate(sound_projection(), SCAN, sound_scan(), 1, foot), WCUT_OK);
    return foot;
}

static wcut_thinning *thinning(void) {
    static wcut_thinning *t;
    if (!t) ck_assert_int_eq(wcut_thinning_create(1, &t), WCUT_OK);
    return t;
}

static wcut_histogram *histogram(void) {
    static wcut_histogram *h;
    if (!h) ck_assert_int_eq(wcut_histogram_create(0, NULL, &h), WCUT_OK);
    return h;
}

static wcut_deviation_summary *summary(void) {
    static wcut_deviation_summary *s;
    wcut_deviation_summary_options o = wcut_deviation_summary_options_default();
    o.high = block_of(), o.patch = 100, o.cell = 20;
    if (!s) ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, &s), WCUT_OK);
    return s;
}

static wcut_face_map *map(void) {
    static wcut_face_map *m;
    if (!m) ck_assert_int_eq(wcut_face_map_create(sound_face(), &m), WCUT_OK);
    return m;
}

static wcut_deviation *on_mesh(void) {
    static wcut_deviation d[SCAN];
    ck_assert_int_eq(wcut_deviation_from_mesh(sound_tree(), SCAN, sound_scan(), NULL, 1, d), WCUT_OK);
    return d;
}

static double sum[100000], weight[100000];

/* ---- clouds ---- */

HOSTILE_VALUE(wcut_cloud_options_default, )
HOSTILE_VALUE(wcut_clean_options_default, )
HOSTILE_VALUE(wcut_normals_options_default, )
HOSTILE_OUT(wcut_cloud_unit_eval, wcut_cloud_unit, VEC(sound_scan()[0]), VEC(sound_scan()[SCAN - 1]), VEC(block_of()))
HOSTILE_OUT(wcut_cloud_span, int, COUNT(SCAN), VALUES(sound_scan(), SCAN))
HOSTILE_MADE(wcut_thinning_create, wcut_thinning, wcut_thinning_destroy, NUM(1), PTR(&made))
HOSTILE_ARRAY(wcut_thinning_add, unsigned char, SCAN, PTR(thinning()), COUNT(SCAN), VALUES(sound_scan(), SCAN))
HOSTILE_VALUE(wcut_thinning_destroy, NULL)
HOSTILE_ARRAY(wcut_cloud_locate, double, SCAN, COUNT(SCAN), VALUES(sound_scan(), SCAN), COUNT(SCAN),
              VALUES(sound_scan(), SCAN), THREADS(1))
HOSTILE_VALUE(wcut_cloud_destroy, NULL)
HOSTILE_VALUE(wcut_cloud_source_destroy, NULL)

HOSTILE(wcut_cloud_clean) {
    const wcut_clean_options options = wcut_clean_options_default();
    unsigned char removal[SCAN];
    wcut_clean_report report = {.scale = 999};
    hostile_fill(removal, sizeof removal);
    EACH_HOSTILE_ARGUMENT(wcut_cloud_clean,
                          wcut_cloud_clean(COUNT(SCAN), VALUES(sound_scan(), SCAN), RECORD(&options), THREADS(1),
                                           PTR(&removal[0]), OPT(&report)),
                          report.scale == 999 && hostile_is_filled(removal, sizeof removal),
                          (report.scale = 999, hostile_fill(removal, sizeof removal)));
}

HOSTILE(wcut_cloud_keep) {
    static wcut_vec3 row[SCAN];
    static unsigned char removal[SCAN];
    for (hostile_begin(); hostile_next();)
        ck_assert_int_le(wcut_cloud_keep(COUNT(SCAN), PTR(&removal[0]), PTR(&row[0])), SCAN);
    hostile_end("wcut_cloud_keep");
}

HOSTILE(wcut_cloud_normals) {
    const wcut_normals_options options = wcut_normals_options_default();
    static wcut_vec3 normal[SCAN];
    wcut_normals_report report = {.guessed = 999};
    hostile_fill(normal, sizeof normal);
    EACH_HOSTILE_ARGUMENT(wcut_cloud_normals,
                          wcut_cloud_normals(COUNT(SCAN), VALUES(sound_scan(), SCAN), RECORD(&options), THREADS(1),
                                             PTR(&normal[0]), OPT(&report)),
                          report.guessed == 999 && hostile_is_filled(normal, sizeof normal),
                          (report.guessed = 999, hostile_fill(normal, sizeof normal)));
}

/* ---- deviations ---- */

HOSTILE_VALUE(wcut_deviation_options_default, )
HOSTILE_VALUE(wcut_deviation_summary_options_default, )
HOSTILE_VALUE(wcut_place_name, ANY_ENUM(WCUT_PLACE_INSIDE))
HOSTILE_MADE(wcut_mesh_tree_create, wcut_mesh_tree, wcut_mesh_tree_destroy, PTR(sound_mesh()), PTR(&made))
HOSTILE_VALUE(wcut_mesh_tree_destroy, NULL)
HOSTILE_ARRAY(wcut_mesh_tree_locate, wcut_mesh_foot, SCAN, PTR(sound_tree()), COUNT(SCAN), VALUES(sound_scan(), SCAN),
              THREADS(1))
HOSTILE_VALUE(wcut_mesh_tree_view, sound_tree())
HOSTILE_MADE(wcut_histogram_create, wcut_histogram, wcut_histogram_destroy, INT(3),
             VALUES(((double[3]){0.1, 0.2, 1}), 3), PTR(&made))
HOSTILE_STATUS(wcut_histogram_add, PTR(histogram()), COUNT(SCAN), VALUES((double *)sound_scan(), SCAN))
HOSTILE_OUT(wcut_histogram_eval, wcut_statistics, PTR(histogram()))
HOSTILE_VALUE(wcut_histogram_destroy, NULL)
HOSTILE_STATUS(wcut_deviation_summary_add, PTR(summary()), COUNT(SCAN), PTR(sound_deviation()))
HOSTILE_OUT(wcut_deviation_summary_eval, const wcut_deviation_summary_result *, PTR(summary()))
HOSTILE_VALUE(wcut_deviation_summary_destroy, NULL)
HOSTILE_STATUS(wcut_deviation_onto_surface, PTR(sound_mesh()), COUNT(SCAN), PTR(on_mesh()))

HOSTILE(wcut_deviation_summary_create) {
    wcut_deviation_summary_options o = wcut_deviation_summary_options_default();
    o.high = block_of(), o.patch = 100, o.cell = 20;
    wcut_deviation_summary *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_deviation_summary_create,
                          wcut_deviation_summary_create(RECORD(&o), OPT(sound_face()), PTR(&made)), made == MARK,
                          (wcut_deviation_summary_destroy(made), made = MARK));
}

HOSTILE(wcut_deviation_from_surface) {
    const wcut_deviation_options o = wcut_deviation_options_default();
    static wcut_deviation deviation[SCAN];
    static wcut_foot foot[SCAN];
    hostile_fill(deviation, sizeof deviation), hostile_fill(foot, sizeof foot);
    EACH_HOSTILE_ARGUMENT(wcut_deviation_from_surface,
                          wcut_deviation_from_surface(PTR(sound_projection()), COUNT(SCAN), VALUES(sound_scan(), SCAN),
                                                      RECORD(&o), THREADS(1), PTR(&deviation[0]), OPT(&foot[0])),
                          hostile_is_filled(deviation, sizeof deviation) && hostile_is_filled(foot, sizeof foot),
                          (hostile_fill(deviation, sizeof deviation), hostile_fill(foot, sizeof foot)));
}

HOSTILE(wcut_deviation_from_mesh) {
    const wcut_deviation_options o = wcut_deviation_options_default();
    static wcut_deviation deviation[SCAN];
    hostile_fill(deviation, sizeof deviation);
    EACH_HOSTILE_ARGUMENT(wcut_deviation_from_mesh,
                          wcut_deviation_from_mesh(PTR(sound_tree()), COUNT(SCAN), VALUES(sound_scan(), SCAN),
                                                   RECORD(&o), THREADS(1), PTR(&deviation[0])),
                          hostile_is_filled(deviation, sizeof deviation), hostile_fill(deviation, sizeof deviation));
}

/* ---- faces and their maps ---- */

HOSTILE_MADE(wcut_face_create, wcut_face, wcut_face_destroy, PTR(sound_job()), PTR(sound_history()),
             OPT(sound_job()->mount_a), OPT(sound_job()->mount_b), NUM(1), PTR(&made))
HOSTILE_VALUE(wcut_face_destroy, NULL)
HOSTILE_MADE(wcut_face_mesh, wcut_mesh, wcut_mesh_destroy, PTR(sound_face()), PTR(&made))
HOSTILE_MADE(wcut_face_map_create, wcut_face_map, wcut_face_map_destroy, PTR(sound_face()), PTR(&made))
HOSTILE_VALUE(wcut_face_map_destroy, NULL)

HOSTILE(wcut_face_kerf) { ck_assert(wcut_face_kerf(sound_face()) >= 0); }

HOSTILE(wcut_face_locate) {
    double row = 999, column = 999;
    for (hostile_begin(); hostile_next();) {
        wcut_face_locate(sound_face(), ANY_NUM(0.5), ANY_NUM(0.5), &row, &column);
        ck_assert(row >= 0 && row <= sound_face()->stations - 1 && column >= 0 && column <= sound_face()->nodes - 1);
    }
    hostile_end("wcut_face_locate");
}

HOSTILE(wcut_face_map_add) {
    static wcut_deviation d[SCAN];
    memcpy(d, sound_deviation(), sizeof d);
    d[0].place = WCUT_PLACE_COUNT, d[1].u = (double)NAN, d[2].v = (double)INFINITY, d[3].distance = (double)NAN;
    wcut_face_map_add(map(), sound_face(), -1, d);
    wcut_face_map_add(map(), sound_face(), SCAN, d);
    for (int k = 0; k < map()->rows * map()->columns; k++) ck_assert(isfinite(map()->sum[k]));
}

HOSTILE(wcut_face_map_eval) {
    const size_t n = (size_t)map()->rows * (size_t)map()->columns;
    double *value = calloc(n, sizeof *value), area = 999;
    unsigned char *present = calloc(n, 1);
    hostile_fill(value, n * sizeof *value), hostile_fill(present, n);
    wcut_face_map_add(map(), sound_face(), SCAN, sound_deviation());
    EACH_HOSTILE_ARGUMENT(
        wcut_face_map_eval,
        wcut_face_map_eval(PTR(map()), PTR(sound_face()), NUM(20), PTR(value), PTR(present), OPT(&area)),
        area == 999 && hostile_is_filled(value, n * sizeof *value) && hostile_is_filled(present, n),
        (area = 999, hostile_fill(value, n * sizeof *value), hostile_fill(present, n)));
    free(value);
    free(present);
}

HOSTILE(wcut_mesh_spread) {
    static wcut_deviation d[SCAN];
    ck_assert_int_eq(wcut_deviation_from_mesh(sound_tree(), SCAN, sound_scan(), NULL, 1, d), WCUT_OK);
    ck_assert_int_le(sound_mesh()->vertex_count, 100000);
    EACH_HOSTILE_ARGUMENT(wcut_mesh_spread,
                          wcut_mesh_spread(PTR(sound_mesh()), COUNT(SCAN), PTR(&d[0]), PTR(&sum[0]), PTR(&weight[0])),
                          sum[0] == 0, memset(sum, 0, sizeof sum));
    d[SCAN - 1].triangle = sound_mesh()->triangle_count;
    memset(sum, 0, sizeof sum), memset(weight, 0, sizeof weight);
    ck_assert_int_eq(wcut_mesh_spread(sound_mesh(), SCAN, d, sum, weight), WCUT_BAD_ARGUMENT);
    for (int k = 0; k < sound_mesh()->vertex_count; k++) ck_assert(sum[k] == 0 && weight[k] == 0);
}

HOSTILE(wcut_mesh_map_eval) {
    const size_t n = (size_t)sound_mesh()->vertex_count;
    double *value = calloc(n, sizeof *value), area = 999;
    unsigned char *present = calloc(n, 1);
    hostile_fill(value, n * sizeof *value), hostile_fill(present, n);
    EACH_HOSTILE_ARGUMENT(
        wcut_mesh_map_eval,
        wcut_mesh_map_eval(PTR(sound_mesh()), PTR(&sum[0]), PTR(&weight[0]), COUNT(SCAN), VALUES(sound_scan(), SCAN),
                           NUM(20), THREADS(1), PTR(value), PTR(present), OPT(&area)),
        area == 999 && hostile_is_filled(value, n * sizeof *value) && hostile_is_filled(present, n),
        (area = 999, hostile_fill(value, n * sizeof *value), hostile_fill(present, n)));
    free(value);
    free(present);
}

/* ---- registration, reconstruction ---- */

HOSTILE_VALUE(wcut_registration_options_default, )
HOSTILE_VALUE(wcut_registration_none, )
HOSTILE_VALUE(wcut_reconstruction_options_default, )
HOSTILE_VALUE(wcut_reconstruction_destroy, NULL)
HOSTILE_VALUE(wcut_datums_destroy, NULL)
HOSTILE_MADE(wcut_mesh_base, wcut_surface, wcut_surface_destroy, PTR(sound_mesh()), 0, PTR(&made))

HOSTILE(wcut_registration_solve_datum) {
    const wcut_registration_options o = wcut_registration_options_default();
    const wcut_datum_pair pair[4] = {{{0, 0, 0}, {1, 0, 0}, 0},
                                     {{100, 0, 0}, {101, 0, 0}, 0},
                                     {{0, 100, 0}, {1, 100, 0}, 0},
                                     {{0, 0, 100}, {1, 0, 100}, 0}};
    wcut_registration r;
    hostile_fill(&r, sizeof r);
    EACH_HOSTILE_ARGUMENT(
        wcut_registration_solve_datum,
        wcut_registration_solve_datum(COUNT(4), VALUES(pair, 4), COUNT(0), OPT(NULL), RECORD(&o), PTR(&r), OPT(NULL)),
        hostile_is_filled(&r, sizeof r), hostile_fill(&r, sizeof r));
}

HOSTILE(wcut_datum_residual_eval) {
    const wcut_registration none = wcut_registration_none();
    const wcut_datum_pair pair[2] = {{{0, 0, 0}, {1, 0, 0}, 0}, {{100, 0, 0}, {101, 0, 0}, 0}};
    wcut_datum_residual r[2];
    hostile_fill(r, sizeof r);
    EACH_HOSTILE_ARGUMENT(wcut_datum_residual_eval,
                          wcut_datum_residual_eval(PTR(&none), COUNT(2), VALUES(pair, 2), COUNT(0),
                                                   OPT((wcut_datum_face *)NULL), PTR(&r[0])),
                          hostile_is_filled(r, sizeof r), hostile_fill(r, sizeof r));
}

HOSTILE(wcut_registration_fit) {
    wcut_registration_options o = wcut_registration_options_default();
    o.coarse = 0;
    wcut_registration r;
    hostile_fill(&r, sizeof r);
    EACH_HOSTILE_ARGUMENT(wcut_registration_fit,
                          wcut_registration_fit(PTR(sound_projection()), COUNT(SCAN), VALUES(sound_scan(), SCAN),
                                                RECORD(&o), THREADS(1), PTR(&r), OPT(NULL)),
                          hostile_is_filled(&r, sizeof r), hostile_fill(&r, sizeof r));
}

HOSTILE(wcut_registration_fit_mesh) {
    wcut_registration_options o = wcut_registration_options_default();
    o.coarse = 0;
    wcut_registration r;
    hostile_fill(&r, sizeof r);
    EACH_HOSTILE_ARGUMENT(
        wcut_registration_fit_mesh,
        wcut_registration_fit_mesh(PTR(sound_mesh()), PTR(sound_tree()), COUNT(SCAN), VALUES(sound_scan(), SCAN),
                                   RECORD(&o), THREADS(1), PTR(&r), OPT(NULL)),
        hostile_is_filled(&r, sizeof r), hostile_fill(&r, sizeof r));
}

HOSTILE(wcut_registration_move) {
    const wcut_registration none = wcut_registration_none();
    wcut_vec3 point[2] = {{1, 2, 3}, {4, 5, 6}};
    EACH_HOSTILE_ARGUMENT(wcut_registration_move,
                          wcut_registration_move(PTR(&none), COUNT(2), PTR(&point[0]), OPT(NULL)),
                          point[0].x == 1 && point[1].z == 6, (void)0);
}

HOSTILE(wcut_reconstruction_create) {
    wcut_reconstruction_options o = wcut_reconstruction_options_default();
    o.spacing = 20, o.support = 40;
    wcut_reconstruction *made = MARK;
    EACH_HOSTILE_ARGUMENT(
        wcut_reconstruction_create,
        wcut_reconstruction_create(PTR(sound_face()->surface), COUNT(SCAN), VALUES(sound_scan(), SCAN), PTR(feet()),
                                   OPT(&o), THREADS(1), PTR(&made), OPT(NULL)),
        made == MARK, (wcut_reconstruction_destroy(made), made = MARK));
}

TEST(without_memory_no_deviation_is_written) {
    static wcut_deviation deviation[SCAN];
    ck_assert(sound_deviation() && on_mesh());
    hostile_fill(deviation, sizeof deviation);
    EACH_FAILED_ALLOCATION(
        wcut_deviation_from_surface(sound_projection(), SCAN, sound_scan(), NULL, 1, deviation, NULL),
        hostile_is_filled(deviation, sizeof deviation));
    hostile_fill(deviation, sizeof deviation);
    EACH_FAILED_ALLOCATION(wcut_deviation_from_mesh(sound_tree(), SCAN, sound_scan(), NULL, 1, deviation),
                           hostile_is_filled(deviation, sizeof deviation));
}
