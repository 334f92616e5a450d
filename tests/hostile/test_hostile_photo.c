/* Hostile calls of cameras, photographs and overlays: kernel/photo and io/photo, in a folder of its own. */
#include "hostile/sound.h"
#include "io/given.h"
#include "photo/views.h"

#define ERR OPT(NULL)

enum { POINTS = 7 };

static const char points[] = "u_px,v_px,x_mm,y_mm,z_mm\n1,2,3,4,5\n6,7,8,9,10\n11,12,13,14,15\n16,17.5,18,19,20\n";

static void begin(void) {
    enter_folder();
    write_file("points.csv", points);
}
FIXTURE(begin, leave_folder);

/* ---- sound arguments, made once a test ---- */

static wcut_camera *camera(void) {
    static wcut_camera c;
    c = camera_at((wcut_vec3){120, -60, 420}, (wcut_vec3){100, 80, 40}, 400, 320, 240, -0.05, 0);
    return &c;
}

static wcut_history *history(void) {
    static wcut_history *h;
    if (!h) h = flat_history();
    return h;
}

static wcut_picture *photo(void) {
    static wcut_picture *p;
    if (!p) p = flat_photo(camera(), FLAT_BOW, 12);
    return p;
}

static wcut_overlay *overlay(void) {
    static wcut_overlay *o;
    if (!o)
        ck_assert_int_eq(
            wcut_overlay_create(FLAT_BLOCK, history(), camera(), NULL, photo(), NULL, NULL, NULL, &o, NULL), WCUT_OK);
    return o;
}

static wcut_picture *drawn(void) {
    static wcut_picture *p;
    if (!p) ck_assert_int_eq(wcut_overlay_draw(overlay(), FLAT_BLOCK, history(), NULL, &p), WCUT_OK);
    return p;
}

/* POINTS points at two heights: u, v, x, y, z */
static wcut_photo_point *seen(void) {
    static const wcut_vec3 place[POINTS] = {{0, 0, 0},   {200, 0, 0},   {200, 160, 0}, {0, 160, 40},
                                            {0, 0, 100}, {200, 20, 60}, {90, 70, 30}};
    static wcut_photo_point p[POINTS];
    const wcut_camera c = camera_at((wcut_vec3){120, -160, 620}, (wcut_vec3){100, 80, 40}, 400, 320, 240, -0.05, 0);
    for (int k = 0; k < POINTS; k++) p[k] = seen_by(&c, place[k]);
    return p;
}

static wcut_camera_report *report(void) {
    static wcut_camera_report r = {.suspect = -1};
    return &r;
}

static wcut_overlaid *overlaid(void) {
    static wcut_picture_source source = {.orientation = 1, .depth = 8};
    static double residual[2 * POINTS], left[POINTS];
    static wcut_overlaid o;
    o = (wcut_overlaid){.job = "j",
                        .photo = "p",
                        .block = FLAT_BLOCK,
                        .source = &source,
                        .camera = camera(),
                        .report = report(),
                        .points = POINTS,
                        .point = seen(),
                        .residual = residual,
                        .leave_one_out = left,
                        .history = history(),
                        .overlay = overlay()};
    return &o;
}

/* ---- cameras ---- */

HOSTILE_VALUE(wcut_camera_options_default, )
HOSTILE(wcut_camera_fit) {
    const wcut_camera_options options = wcut_camera_options_default();
    wcut_camera c;
    wcut_camera_report r = {.iterations = 999};
    double residual[2 * POINTS], left[POINTS];
    hostile_fill(&c, sizeof c), hostile_fill(residual, sizeof residual);
    EACH_HOSTILE_ARGUMENT(
        wcut_camera_fit,
        wcut_camera_fit(COUNT(POINTS), VALUES(seen(), POINTS), INT(320), INT(240), RECORD(&options), PTR(&c), OPT(&r),
                        OPT(&residual[0]), OPT(&left[0]), ERR),
        hostile_is_filled(&c, sizeof c) && r.iterations == 999 && hostile_is_filled(residual, sizeof residual),
        (hostile_fill(&c, sizeof c), r.iterations = 999, hostile_fill(residual, sizeof residual)));
}
HOSTILE(wcut_camera_project) {
    double pixel[2 * POINTS], depth[POINTS];
    wcut_vec3 place[POINTS];
    for (int k = 0; k < POINTS; k++) place[k] = seen()[k].place;
    hostile_fill(pixel, sizeof pixel);
    EACH_HOSTILE_ARGUMENT(
        wcut_camera_project,
        wcut_camera_project(RECORD(camera()), COUNT(POINTS), VALUES(place, POINTS), PTR(&pixel[0]), OPT(&depth[0])),
        hostile_is_filled(pixel, sizeof pixel), hostile_fill(pixel, sizeof pixel));
}

/* ---- pictures ---- */

HOSTILE_MADE(wcut_picture_create, wcut_picture, wcut_picture_destroy, INT(20), INT(10), INT(3), PTR(&made))
HOSTILE_VALUE(wcut_picture_destroy, NULL)
HOSTILE_FILE(wcut_picture_write, PTR(drawn()), NUM(0.25), PTR(OUT_FILE), ERR)
HOSTILE(wcut_picture_read) {
    wcut_picture *made = MARK;
    ck_assert_int_eq(wcut_picture_write(photo(), 0, "p.png", NULL), WCUT_OK);
    EACH_HOSTILE_ARGUMENT(wcut_picture_read, wcut_picture_read(PTR("p.png"), PTR(&made), OPT(NULL), ERR), made == MARK,
                          (wcut_picture_destroy(made), made = MARK));
}
HOSTILE(wcut_photo_points_read) {
    wcut_photo_point *made = MARK;
    int count = 999;
    EACH_HOSTILE_ARGUMENT(wcut_photo_points_read,
                          wcut_photo_points_read(PTR("points.csv"), PTR(&count), PTR(&made), ERR),
                          made == MARK && count == 999, (free(made), made = MARK, count = 999));
}

/* ---- overlays ---- */

HOSTILE_VALUE(wcut_overlay_options_default, )
HOSTILE_VALUE(wcut_overlay_style_default, )
HOSTILE_VALUE(wcut_overlay_destroy, NULL)
HOSTILE(wcut_overlay_create) {
    wcut_overlay_options options = wcut_overlay_options_default();
    options.resolution = 1;
    wcut_overlay *made = MARK;

    /* the first word holds a bool */
    EACH_HOSTILE_ARGUMENT(
        wcut_overlay_create,
        wcut_overlay_create(VEC(FLAT_BLOCK), PTR(history()), RECORD(camera()), OPT(report()), PTR(photo()),
                            RECORD_WORDS(&options, 1, (int)(sizeof options / 8)), NULL, NULL, PTR(&made), ERR),
        made == MARK, (wcut_overlay_destroy(made), made = MARK));
}
HOSTILE_MADE(wcut_overlay_draw, wcut_picture, wcut_picture_destroy, PTR(overlay()), VEC(FLAT_BLOCK), PTR(history()),
             OPT(NULL), PTR(&made))
HOSTILE_MADE(wcut_overlay_draw_photo, wcut_picture, wcut_picture_destroy, PTR(overlay()), VEC(FLAT_BLOCK),
             PTR(history()), OPT(NULL), PTR(camera()), PTR(photo()), PTR(&made))
HOSTILE_MADE(wcut_overlay_details, wcut_picture, wcut_picture_destroy, PTR(overlay()), VEC(FLAT_BLOCK), PTR(history()),
             PTR(drawn()), NUM(40), PTR(&made))
HOSTILE_TEXT(wcut_overlay_print, PTR(overlaid()), PTR(&made))
HOSTILE_FILE(wcut_rills_write, PTR(overlay()), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_overlay_svg_write, PTR(overlaid()), PTR("rectified.png"), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_world_write, PTR(overlay()), VEC(FLAT_BLOCK), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_report_overlay_write, PTR(overlaid()), PTR(OUT_FILE), ERR)
