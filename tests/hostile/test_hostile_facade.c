/* Hostile calls of facades: layout, faces, panels, descriptions and results. */
#include "facade/given.h"
#include "hostile/hostile.h"
#include "hostile/sound.h"
#include "io/given.h"

#define ERR OPT(NULL)
#define BLOCK ((wcut_vec3){300, 240, 160})

static wcut_facade_description *description;
static wcut_sweep *facade_sweep;

static double plane(double x, double y) { return 60 + 0.1 * x + 0.05 * y; }

static void begin_facade(void) {
    wcut_error error = {0};
    const wcut_element_options options = wcut_element_options_default();
    enter_folder();
    wcut_job *job = flat_job(300, 300, 160);
    wcut_free(job->name);
    job->name = wcut_copy_text("flat");
    job->wire_diameter = 0.2, job->heat = 60, job->tension = 2;
    job->force_law = (wcut_force_law){0.1, 8.6e-4};
    job->clearance = 40;
    ck_assert_msg(wcut_job_write(job, "job.json", &error) == WCUT_OK, "%s", error.text);
    wcut_job_destroy(job);
    write_file("facade.json",
               "{\"format\": \"wirecut-facade/1\", \"name\": \"f\", \"lattice\": {\"kind\": \"plane\", \"rows\": 1, "
               "\"columns\": 2}, \"job\": \"job.json\"}");
    ck_assert_msg(wcut_facade_read("facade.json", &description, &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_facade_sweep_create(description, &options, "out", &facade_sweep, &error) == WCUT_OK, "%s",
                  error.text);
}

static void end_facade(void) {
    wcut_sweep_destroy(facade_sweep);
    wcut_facade_description_destroy(description);
    leave_folder();
}
FIXTURE(begin_facade, end_facade);

static wcut_surface *wire(void) {
    static wcut_surface *surface;
    if (!surface) surface = graph(BLOCK, plane);
    return surface;
}

static wcut_element_face *element_face(void) {
    static wcut_element_face *face;
    static const double *const none[4];
    if (!face) ck_assert_int_eq(wcut_element_face_create(wire(), BLOCK, none, 0, 0, NULL, NULL, &face, NULL), WCUT_OK);
    return face;
}

/* results of a face that both elements have, as if it had been cut */
static wcut_facade_results *results(void) {
    static wcut_facade_results r;
    static wcut_facade_item item[2];
    static wcut_element_face *face[1];
    static wcut_joint_report joint[1];
    face[0] = element_face();
    item[0] = item[1] = (wcut_facade_item){.state = WCUT_SWEEP_STATE_DONE, .feasible = true, .face = element_face()};
    r = (wcut_facade_results){.description = description, .distinct = 1, .item = item, .face = face, .joint = joint};
    return &r;
}

static wcut_facade_plan *plan(void) {
    static given_plan g;
    static wcut_job *job;
    if (!job) job = flat_job(300, 300, 160);
    give_plan(&g, job, 1, 2);
    return &g.plan;
}

static const wcut_element *element(void) {
    static wcut_element e;
    e = (wcut_element){.job = sound_job(), .options = wcut_element_options_default()};
    return &e;
}

static const wcut_step_place *step_place(void) {
    static const wcut_step_place place = {"p", 0, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    return &place;
}

static const wcut_shape *step_shape(void) {
    static wcut_shape s;
    s = (wcut_shape){.name = "s", .surface = wire()};
    return &s;
}

/* ---- layout and faces ---- */

HOSTILE(wcut_facade_field_eval) {
    const wcut_facade_field field = {.value = 1};
    const double size[2] = {100, 100};
    double value = 999;
    EACH_HOSTILE_ARGUMENT(wcut_facade_field_eval,
                          wcut_facade_field_eval(COUNT(1), PTR(&field), VALUES(size, 2), NUM(1), NUM(2), PTR(&value)),
                          value == 999, value = 999);
}
HOSTILE_MADE(wcut_facade_create, wcut_facade, wcut_facade_destroy, PTR(plan()), PTR(&made), ERR)
HOSTILE_VALUE(wcut_facade_destroy, NULL)
HOSTILE(wcut_element_face_create) {
    static const double *const none[4];
    wcut_element_face *made = MARK;
    const wcut_vec3 place = {1, 1, 1};
    const double force = 1;
    EACH_HOSTILE_ARGUMENT(wcut_element_face_create,
                          wcut_element_face_create(PTR(wire()), VEC(BLOCK), PTR(none), COUNT(1), COUNT(1), PTR(&place),
                                                   PTR(&force), PTR(&made), ERR),
                          made == MARK, (wcut_element_face_destroy(made), made = MARK));
}
HOSTILE(wcut_element_face_interpolate) {
    static double height[POINTS];
    wcut_element_face *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_element_face_interpolate,
                          wcut_element_face_interpolate(VEC(BLOCK), VALUES(height, POINTS), PTR(&made)), made == MARK,
                          (wcut_element_face_destroy(made), made = MARK));
}
HOSTILE_VALUE(wcut_element_face_destroy, NULL)
HOSTILE_OUT(wcut_joint_eval, wcut_joint_report, PTR(description->facade), INT(0), PTR(element_face()),
            PTR(element_face()))
HOSTILE(wcut_facade_points) {
    static wcut_vec3 point[2 * POINTS];
    const wcut_element_face *const face[2] = {element_face(), NULL};
    hostile_fill(point, sizeof point);
    EACH_HOSTILE_ARGUMENT(wcut_facade_points, wcut_facade_points(PTR(description->facade), PTR(face), PTR(&point[0])),
                          hostile_is_filled(point, sizeof point), hostile_fill(point, sizeof point));
}
HOSTILE_MADE(wcut_panel_create, wcut_panel, wcut_panel_destroy, PTR(element_face()), NUM(12), NUM(1), PTR(&made), ERR)
HOSTILE_VALUE(wcut_panel_destroy, NULL)

/* ---- files ---- */

HOSTILE_MADE(wcut_facade_read, wcut_facade_description, wcut_facade_description_destroy, PTR("facade.json"), PTR(&made),
             ERR)
HOSTILE_VALUE(wcut_facade_description_destroy, NULL)
HOSTILE_VALUE(wcut_element_options_default)
HOSTILE(wcut_element_read) {
    wcut_element *made = MARK;
    ck_assert_int_eq(wcut_element_read(NULL, &made, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_element_read("facade.json", NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_element_read("facade.json", &made, NULL), WCUT_BAD_FORMAT);
    ck_assert_int_eq(wcut_element_read("none.json", &made, NULL), WCUT_NOT_FOUND);
    ck_assert(made == MARK);
}
HOSTILE_VALUE(wcut_element_destroy, NULL)
HOSTILE_TEXT(wcut_element_result_print, PTR(element()), PTR(sound_setup()), PTR(sound_history()), OPT(element_face()),
             OPT(NULL), OPT("why"), PTR(&made))
HOSTILE(wcut_facade_sweep_create) {
    const wcut_element_options options = wcut_element_options_default();
    wcut_sweep *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_facade_sweep_create,
                          wcut_facade_sweep_create(PTR(description), PTR(&options), PTR("other"), PTR(&made), ERR),
                          made == MARK, (wcut_sweep_destroy(made), made = MARK));
}
HOSTILE(wcut_facade_results_read) {
    const wcut_element_options options = wcut_element_options_default();
    wcut_facade_results *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_facade_results_read,
                          wcut_facade_results_read(PTR(description), PTR(&options), PTR(facade_sweep), PTR(&made), ERR),
                          made == MARK, (wcut_facade_results_destroy(made), made = MARK));
}
HOSTILE_VALUE(wcut_facade_results_destroy, NULL)
HOSTILE_FILE(wcut_facade_write_csv, PTR(results()), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_facade_write_glb, PTR(results()), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_facade_write_step, PTR(results()), PTR(OUT_FILE), ERR)
HOSTILE_TEXT(wcut_facade_print, PTR(results()), PTR(&made))
HOSTILE_FILE(wcut_report_facade_write, PTR(results()), OPT(NULL), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_step_write_assembly, PTR("a"), COUNT(1), PTR(step_shape()), COUNT(1), PTR(step_place()),
             PTR(OUT_FILE), ERR)
