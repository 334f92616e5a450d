/* Hostile calls of targets and designs. */
#include "hostile/sound.h"
#include "inverse/given.h"

static wcut_design_target *target_once(void) {
    static wcut_design_target *target;
    if (!target) target = given_target(saddle);
    return target;
}

static wcut_surface *surface_once(void) {
    static wcut_surface *surface;
    if (!surface) surface = given_surface(saddle);
    return surface;
}

static wcut_mesh *mesh_once(void) {
    static wcut_mesh *mesh;
    if (!mesh) ck_assert_int_eq(wcut_surface_tessellate(surface_once(), 2, &mesh, NULL), WCUT_OK);
    return mesh;
}

enum { CLOUD = 900 };

static wcut_vec3 *points_once(void) {
    static wcut_vec3 point[CLOUD];
    for (int k = 0; k < CLOUD; k++) {
        const double x = 6 + 13.0 * (k % 30), y = 10 + 20.0 * (k / 30);
        point[k] = vec3(x, y, saddle(x, y));
    }
    return point;
}

static wcut_job *process_once(void) {
    static wcut_job *job;
    if (!job) job = given_process(41, 21);
    return job;
}

static wcut_design_options *options_once(void) {
    static wcut_design_options o;
    if (o.threads == 0) o = wcut_design_options_default();
    o.feed = WCUT_DESIGN_FEED_PLUS_Y;
    return &o;
}

static wcut_design_result *result_once(void) {
    static wcut_design_map *map;
    static wcut_design_result result;
    if (!map) ck_assert_int_eq(wcut_design_map_create(target_once(), process_once(), NULL, &map, NULL), WCUT_OK);
    result = (wcut_design_result){.target = WCUT_SOURCE_DIR "/README.md", .tolerance = 0.1, .map = map};
    return &result;
}

static int stop(const wcut_design_round *round, void *context) {
    (void)round, (void)context;
    return 1;
}

HOSTILE_VALUE(wcut_design_options_default, )
HOSTILE_VALUE(wcut_design_feed_name, ANY_ENUM(WCUT_DESIGN_FEED_PLUS_Y))
HOSTILE_VALUE(wcut_design_reason_name, ANY_ENUM(WCUT_DESIGN_REASON_DOMED))
HOSTILE_VALUE(wcut_design_target_destroy, NULL)
HOSTILE_VALUE(wcut_design_map_destroy, NULL)
HOSTILE_VALUE(wcut_design_destroy, NULL)

HOSTILE_MADE(wcut_design_target_from_surface, wcut_design_target, wcut_design_target_destroy, PTR(surface_once()),
             VEC(given_block), PTR(&made), OPT((wcut_error *)NULL))

static const wcut_trimmed *const *faces_once(void) {
    static wcut_trimmed whole;
    static const wcut_trimmed *face[1] = {&whole};
    whole.surface = surface_once();
    return face;
}

HOSTILE_MADE(wcut_design_target_from_faces, wcut_design_target, wcut_design_target_destroy, COUNT(1), PTR(faces_once()),
             VEC(given_block), PTR(&made), OPT((wcut_error *)NULL))

HOSTILE_MADE(wcut_design_target_from_mesh, wcut_design_target, wcut_design_target_destroy, PTR(mesh_once()),
             VEC(given_block), PTR(&made), OPT((wcut_error *)NULL))

HOSTILE_MADE(wcut_design_target_from_points, wcut_design_target, wcut_design_target_destroy, COUNT(CLOUD),
             VALUES(points_once(), CLOUD), VEC(given_block), PTR(&made), OPT((wcut_error *)NULL))

HOSTILE_MADE(wcut_design_map_create, wcut_design_map, wcut_design_map_destroy, PTR(target_once()), PTR(process_once()),
             RECORD_WORDS(options_once(), 0, 4), PTR(&made), OPT((wcut_error *)NULL))

HOSTILE(wcut_design_fit) {
    wcut_design *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_design_fit,
                          wcut_design_fit(PTR(target_once()), PTR(process_once()), RECORD_WORDS(options_once(), 0, 4),
                                          stop, OPT((void *)NULL), PTR(&made), OPT((wcut_error *)NULL)),
                          made == MARK, (wcut_design_destroy(made), made = MARK));
}

/* ---- panels ---- */

HOSTILE_VALUE(wcut_design_panels_destroy, NULL)

HOSTILE(wcut_design_panels_fit) {
    wcut_design_panels *made = MARK;
    EACH_HOSTILE_ARGUMENT(
        wcut_design_panels_fit,
        wcut_design_panels_fit(PTR(target_once()), PTR(process_once()), RECORD_WORDS(options_once(), 0, 4), COUNT(1),
                               NUM(0.5), stop, OPT((void *)NULL), PTR(&made), OPT((wcut_error *)NULL)),
        made == MARK, (wcut_design_panels_destroy(made), made = MARK));
}

/* ---- compensation ---- */

/* a straight cut through the saddle's block: how far it is from the target does not matter */
static wcut_job *cut_once(void) {
    static wcut_job *job;
    if (job) return job;
    job = straight_job(400, 80, 620, 21, 31, -40, 760);
    job->block_size = given_block;
    return job;
}

HOSTILE_VALUE(wcut_compensation_destroy, NULL)

HOSTILE(wcut_compensation_fit) {
    wcut_compensation *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_compensation_fit,
                          wcut_compensation_fit(PTR(target_once()), PTR(cut_once()), RECORD_WORDS(options_once(), 1, 2),
                                                stop, OPT((void *)NULL), PTR(&made), OPT((wcut_error *)NULL)),
                          made == MARK, (wcut_compensation_destroy(made), made = MARK));
}

HOSTILE(wcut_compensation_measure) {
    double rms = 999, max = 999;
    EACH_HOSTILE_ARGUMENT(wcut_compensation_measure,
                          wcut_compensation_measure(PTR(target_once()), PTR(cut_once()), THREADS(1), PTR(&rms),
                                                    PTR(&max), OPT((wcut_error *)NULL)),
                          rms == 999 && max == 999, rms = max = 999);
}

static wcut_compensation_result *worth_once(void) {
    static wcut_compensation found = {.before_rms = 1, .after_rms = 0.1};
    static wcut_compensation_result result = {.job = "job.json", .with = "diagnosis.json", .compensation = &found};
    return &result;
}

/* with all that its page shows */
static wcut_compensation_result *page_once(void) {
    static double curve[2];
    static wcut_design_round round = {.stations = 2, .nodes = 5, .unknowns = 4, .runs = 1, .rms = 0.1};
    static wcut_compensation found = {.rounds = 1,
                                      .round = &round,
                                      .before_rms = 1,
                                      .after_rms = 0.1,
                                      .stations = 2,
                                      .nearer = curve,
                                      .lag = curve,
                                      .rise_a = curve,
                                      .rise_b = curve,
                                      .branch = -1};
    static wcut_compensation_result result = {
        .job = WCUT_SOURCE_DIR "/README.md", .with = "diagnosis.json", .compensation = &found};
    return &result;
}

HOSTILE(wcut_report_compensate_write) {
    EACH_HOSTILE_ARGUMENT(
        wcut_report_compensate_write,
        wcut_report_compensate_write(PTR("a page"), PTR(page_once()), PTR(OUT_FILE), OPT((wcut_error *)NULL)),
        access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
}

HOSTILE_TEXT(wcut_compensation_print, PTR(worth_once()), PTR(&made))

HOSTILE(wcut_compensation_say) {
    char text[300] = "";
    EACH_HOSTILE_ARGUMENT(wcut_compensation_say, wcut_compensation_say(PTR(worth_once()), COUNT(300), PTR(&text[0])),
                          text[0] == 0, text[0] = 0);
}

HOSTILE_TEXT(wcut_design_result_print, PTR(result_once()), PTR(&made))
HOSTILE_FILE(wcut_design_result_write, PTR(result_once()), PTR(OUT_FILE), OPT((wcut_error *)NULL))

HOSTILE_FILE(wcut_design_map_write_png, PTR(result_once()->map), NUM(1), PTR(OUT_FILE), OPT((wcut_error *)NULL))

HOSTILE(wcut_design_result_say) {
    char text[200] = "";
    EACH_HOSTILE_ARGUMENT(wcut_design_result_say, wcut_design_result_say(PTR(result_once()), COUNT(200), PTR(&text[0])),
                          text[0] == 0, text[0] = 0);
}

HOSTILE(wcut_report_design_write) {
    wcut_report_design page = {.title = "a page", .block = given_block, .result = result_once()};
    EACH_HOSTILE_ARGUMENT(wcut_report_design_write,
                          wcut_report_design_write(PTR(&page), PTR(OUT_FILE), OPT((wcut_error *)NULL)),
                          access(OUT_FILE, F_OK) != 0, remove(OUT_FILE));
}
