/* Hostile calls of curves and surfaces: kernel/surface. */
#include "hostile/hostile.h"
#include "surface/shapes.h"

static const wcut_box block = {{-30, -30, -30}, {30, 30, 30}};
static const wcut_box cube = {{100, 100, 100}, {130, 130, 130}};
static const double line_knots[6] = {0, 0, 0, 1, 1, 1}, weights[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
static const wcut_vec3 points[9] = {{0, 0, 0},   {10, 0, 2}, {20, 0, 0},  {0, 10, 0}, {10, 10, 3},
                                    {20, 10, 0}, {0, 20, 0}, {10, 20, 1}, {20, 20, 0}};
static const double thirds[3] = {0, 0.4, 1};
static const double quarter[2] = {0.25, 0.75};
static const wcut_affine turn = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}, {5, 5, 5}};

/* made once a process */
static wcut_surface *sheet(void) {
    static wcut_surface *s;
    if (!s) ck_assert_int_eq(wcut_surface_create(2, 2, 3, 3, line_knots, line_knots, points, weights, &s), WCUT_OK);
    return s;
}
static wcut_surface *next_sheet(void) {
    static wcut_surface *s;
    wcut_vec3 moved[9];
    for (int k = 0; k < 9; k++) moved[k] = (wcut_vec3){points[k].x, points[k].y + 20, points[k].z};
    for (int k = 0; k < 3; k++) moved[k] = points[6 + k];
    if (!s) ck_assert_int_eq(wcut_surface_create(2, 2, 3, 3, line_knots, line_knots, moved, weights, &s), WCUT_OK);
    return s;
}
static wcut_curve *curve(void) {
    static wcut_curve *c;
    if (!c) ck_assert_int_eq(wcut_curve_create(2, 3, line_knots, points, weights, &c), WCUT_OK);
    return c;
}
static wcut_curve *next_curve(void) {
    static wcut_curve *c;
    const wcut_vec3 p[3] = {points[2], {30, 0, -2}, {40, 0, 0}};
    if (!c) ck_assert_int_eq(wcut_curve_create(2, 3, line_knots, p, weights, &c), WCUT_OK);
    return c;
}
static wcut_mesh *mesh(void) {
    static wcut_mesh *m;
    if (!m) ck_assert_int_eq(wcut_surface_tessellate(sheet(), 0.1, &m, NULL), WCUT_OK);
    return m;
}
static wcut_projection *projection(void) {
    static wcut_projection *p;
    if (!p) ck_assert_int_eq(wcut_projection_create(sheet(), &p), WCUT_OK);
    return p;
}
static wcut_traces *traces(void) {
    static wcut_traces *t;
    const wcut_vec3 at = {0, 5, 0}, along = {0, 1, 0};
    if (!t) ck_assert_int_eq(wcut_surface_intersect_plane(sheet(), at, along, 0.1, &t), WCUT_OK);
    return t;
}

/* ---- curves ---- */

HOSTILE_MADE(wcut_curve_create, wcut_curve, wcut_curve_destroy, INT(2), COUNT(3), VALUES(line_knots, 6),
             VALUES(points, 3), OPT(weights), PTR(&made))
HOSTILE_MADE(wcut_curve_interpolate, wcut_curve, wcut_curve_destroy, COUNT(3), VALUES(points, 3), PTR(&made))
HOSTILE_MADE(wcut_curve_interpolate_at, wcut_curve, wcut_curve_destroy, COUNT(3), VALUES(points, 3),
             OPT_VALUES(thirds, 3), OPT(&points[4]), OPT(&points[5]), PTR(&made))
HOSTILE_VALUE(wcut_curve_destroy, NULL)
HOSTILE_ARRAY(wcut_curve_eval, wcut_vec3, 3, PTR(curve()), NUM(0.5), INT(2))
HOSTILE_OUT(wcut_curve_frame, wcut_frame, PTR(curve()), NUM(0.5))
HOSTILE_OUT(wcut_curve_length, double, PTR(curve()), NUM(0), NUM(1))
HOSTILE_OUT(wcut_curve_locate_length, double, PTR(curve()), NUM(5))
HOSTILE_OUT(wcut_curve_bounds, wcut_box, PTR(curve()), NUM(0.1))
HOSTILE_OUT(wcut_path_clearance, wcut_path_near, COUNT(9), VALUES(points, 9), RECORD(&cube), NUM(0.1))
HOSTILE_ARRAY(wcut_curve_locate, wcut_curve_foot, 9, PTR(curve()), COUNT(9), VALUES(points, 9), THREADS(1))
HOSTILE_MADE(wcut_curve_insert_knot, wcut_curve, wcut_curve_destroy, PTR(curve()), NUM(0.5), INT(1), PTR(&made))
HOSTILE_MADE(wcut_curve_reverse, wcut_curve, wcut_curve_destroy, PTR(curve()), PTR(&made))
HOSTILE_MADE(wcut_curve_elevate, wcut_curve, wcut_curve_destroy, PTR(curve()), INT(1), PTR(&made))
HOSTILE_MADE(wcut_curve_transform, wcut_curve, wcut_curve_destroy, PTR(curve()), RECORD(&turn), PTR(&made))

HOSTILE(wcut_curve_domain) {
    double first = 999, last = 999;
    wcut_curve_domain(curve(), &first, &last);
    ck_assert(first == 0 && last == 1);
}

HOSTILE(wcut_curve_clearance) {
    double distance = 999, u = 999;
    EACH_HOSTILE_ARGUMENT(wcut_curve_clearance,
                          wcut_curve_clearance(PTR(curve()), RECORD(&cube), NUM(0.1), PTR(&distance), OPT(&u)),
                          distance == 999 && u == 999, distance = u = 999);
}

HOSTILE(wcut_curve_split) {
    wcut_curve *low = MARK, *high = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_curve_split, wcut_curve_split(PTR(curve()), NUM(0.5), PTR(&low), PTR(&high)),
                          low == MARK && high == MARK,
                          (wcut_curve_destroy(low), wcut_curve_destroy(high), low = high = MARK));
}

HOSTILE(wcut_curve_remove_knots) {
    wcut_curve *made = MARK;
    double error = 999;
    EACH_HOSTILE_ARGUMENT(wcut_curve_remove_knots,
                          wcut_curve_remove_knots(PTR(curve()), NUM(0.1), PTR(&made), OPT(&error)),
                          made == MARK && error == 999, (wcut_curve_destroy(made), made = MARK, error = 999));
}

HOSTILE(wcut_curve_join) {
    const wcut_curve *const pair[2] = {curve(), next_curve()}, *const broken[2] = {curve(), NULL};
    wcut_curve *made = MARK;
    double gap = 999;
    EACH_HOSTILE_ARGUMENT(wcut_curve_join, wcut_curve_join(COUNT(2), PTR(&pair[0]), NUM(0.1), PTR(&made), OPT(&gap)),
                          made == MARK && gap == 999, (wcut_curve_destroy(made), made = MARK, gap = 999));
    ck_assert_int_eq(wcut_curve_join(2, broken, 0.1, &made, &gap), WCUT_BAD_ARGUMENT);
    ck_assert(made == MARK && gap == 999);
}

/* ---- surfaces ---- */

HOSTILE_MADE(wcut_surface_create, wcut_surface, wcut_surface_destroy, INT(2), INT(2), COUNT(3), COUNT(3),
             VALUES(line_knots, 6), VALUES(line_knots, 6), VALUES(points, 9), OPT(weights), PTR(&made))
HOSTILE_VALUE(wcut_surface_destroy, NULL)
HOSTILE_ARRAY(wcut_surface_eval, wcut_vec3, 9, PTR(sheet()), NUM(0.5), NUM(0.5), INT(2))
HOSTILE_ARRAY(wcut_surface_eval_grid, wcut_vec3, 4, PTR(sheet()), COUNT(2), VALUES(quarter, 2), COUNT(2),
              VALUES(quarter, 2))
HOSTILE_OUT(wcut_surface_bounds, wcut_box, PTR(sheet()), NUM(0.1))
HOSTILE_OUT(wcut_surface_normal, wcut_vec3, PTR(sheet()), NUM(0.5), NUM(0.5))
HOSTILE_OUT(wcut_surface_frame, wcut_tangent_frame, PTR(sheet()), NUM(0.5), NUM(0.5))
HOSTILE_OUT(wcut_surface_inspect, wcut_surface_report, PTR(sheet()), NUM(0.1))
HOSTILE_MADE(wcut_surface_insert_knot, wcut_surface, wcut_surface_destroy, PTR(sheet()), ENUM(WCUT_DIRECTION_V),
             NUM(0.5), INT(1), PTR(&made))
HOSTILE_MADE(wcut_surface_reverse, wcut_surface, wcut_surface_destroy, PTR(sheet()), ENUM(WCUT_DIRECTION_V), PTR(&made))
HOSTILE_MADE(wcut_surface_transpose, wcut_surface, wcut_surface_destroy, PTR(sheet()), PTR(&made))
HOSTILE_MADE(wcut_surface_iso_curve, wcut_curve, wcut_curve_destroy, PTR(sheet()), ENUM(WCUT_DIRECTION_V), NUM(0.5),
             PTR(&made))
HOSTILE_MADE(wcut_surface_elevate, wcut_surface, wcut_surface_destroy, PTR(sheet()), ENUM(WCUT_DIRECTION_V), INT(1),
             PTR(&made))
HOSTILE_MADE(wcut_surface_transform, wcut_surface, wcut_surface_destroy, PTR(sheet()), RECORD(&turn), PTR(&made))
HOSTILE_MADE(wcut_surface_intersect_plane, wcut_traces, wcut_traces_destroy, PTR(sheet()), VEC(points[1]),
             VEC(points[3]), NUM(0.1), PTR(&made))
HOSTILE_MADE(wcut_surface_intersect_box, wcut_traces, wcut_traces_destroy, PTR(sheet()), RECORD(&block), NUM(0.1),
             PTR(&made))
HOSTILE_MADE(wcut_traces_join, wcut_traces, wcut_traces_destroy, PTR(traces()), NUM(0.1), PTR(&made))
HOSTILE_VALUE(wcut_traces_destroy, NULL)
HOSTILE_MADE(wcut_projection_create, wcut_projection, wcut_projection_destroy, PTR(sheet()), PTR(&made))
HOSTILE_VALUE(wcut_projection_destroy, NULL)
HOSTILE_STATUS(wcut_projection_prepare_many, PTR(projection()))
HOSTILE_ARRAY(wcut_projection_locate, wcut_foot, 9, PTR(projection()), COUNT(9), VALUES(points, 9), THREADS(1))

HOSTILE(wcut_surface_domain) {
    double first[2] = {999, 999}, last[2] = {999, 999};
    wcut_surface_domain(sheet(), first, last);
    ck_assert(first[0] == 0 && last[1] == 1);
}

HOSTILE(wcut_surface_curvature) {
    double larger = 999, smaller = 999;
    EACH_HOSTILE_ARGUMENT(wcut_surface_curvature,
                          wcut_surface_curvature(PTR(sheet()), NUM(0.5), NUM(0.5), PTR(&larger), OPT(&smaller)),
                          larger == 999 && smaller == 999, larger = smaller = 999);
}

HOSTILE(wcut_surface_split) {
    wcut_surface *low = MARK, *high = MARK;
    EACH_HOSTILE_ARGUMENT(
        wcut_surface_split, wcut_surface_split(PTR(sheet()), ENUM(WCUT_DIRECTION_U), NUM(0.5), PTR(&low), PTR(&high)),
        low == MARK && high == MARK, (wcut_surface_destroy(low), wcut_surface_destroy(high), low = high = MARK));
}

HOSTILE(wcut_surface_remove_knots) {
    wcut_surface *made = MARK;
    double error = 999;
    EACH_HOSTILE_ARGUMENT(wcut_surface_remove_knots,
                          wcut_surface_remove_knots(PTR(sheet()), NUM(0.1), PTR(&made), OPT(&error)),
                          made == MARK && error == 999, (wcut_surface_destroy(made), made = MARK, error = 999));
}

HOSTILE(wcut_surface_join) {
    wcut_surface *made = MARK;
    double gap = 999;
    EACH_HOSTILE_ARGUMENT(
        wcut_surface_join,
        wcut_surface_join(PTR(sheet()), PTR(next_sheet()), ENUM(WCUT_DIRECTION_V), NUM(0.1), PTR(&made), OPT(&gap)),
        made == MARK && gap == 999, (wcut_surface_destroy(made), made = MARK, gap = 999));
}

HOSTILE(wcut_surface_offset) {
    wcut_surface *made = MARK;
    wcut_offset_report report = {.error = 999};
    EACH_HOSTILE_ARGUMENT(
        wcut_surface_offset, wcut_surface_offset(PTR(sheet()), NUM(1), NUM(0.1), PTR(&made), OPT(&report)),
        made == MARK && report.error == 999, (wcut_surface_destroy(made), made = MARK, report.error = 999));
}

HOSTILE(wcut_surface_loft) {
    wcut_surface *made = MARK;
    double parameter[3] = {999, 999, 999};
    wcut_loft_report report = {999, 999};
    EACH_HOSTILE_ARGUMENT(
        wcut_surface_loft,
        wcut_surface_loft(COUNT(3), COUNT(3), VALUES(points, 9), NUM(0), PTR(&made), OPT(&parameter[0]), OPT(&report)),
        made == MARK && parameter[0] == 999 && report.used == 999,
        (wcut_surface_destroy(made), made = MARK, parameter[0] = report.used = 999));
}

HOSTILE(wcut_surface_fit) {
    wcut_surface *made = MARK;
    double parameter[3] = {999, 999, 999};
    wcut_surface_fit_report report = {.node_error = 999};
    EACH_HOSTILE_ARGUMENT(wcut_surface_fit,
                          wcut_surface_fit(COUNT(3), COUNT(3), VALUES(points, 9), NUM(0), NUM(1), PTR(&made),
                                           OPT(&parameter[0]), OPT(&report)),
                          made == MARK && parameter[0] == 999 && report.node_error == 999,
                          (wcut_surface_destroy(made), made = MARK, parameter[0] = report.node_error = 999));
}

HOSTILE(wcut_surface_loft_curves) {
    const wcut_curve *const pair[2] = {curve(), next_curve()}, *const broken[2] = {curve(), NULL};
    wcut_surface *made = MARK;
    double parameter[2] = {999, 999};
    wcut_curve_loft_report report = {.used = 999};
    EACH_HOSTILE_ARGUMENT(
        wcut_surface_loft_curves,
        wcut_surface_loft_curves(COUNT(2), PTR(&pair[0]), NUM(0), NUM(1), PTR(&made), OPT(&parameter[0]), OPT(&report)),
        made == MARK && parameter[0] == 999 && report.used == 999,
        (wcut_surface_destroy(made), made = MARK, parameter[0] = report.used = 999));
    ck_assert_int_eq(wcut_surface_loft_curves(2, broken, 0, 1, &made, parameter, &report), WCUT_BAD_ARGUMENT);
    ck_assert(made == MARK && parameter[0] == 999);
}

/* ---- meshes ---- */

HOSTILE_MADE(wcut_mesh_create, wcut_mesh, wcut_mesh_destroy, COUNT(9), COUNT(8), WCUT_MESH_NORMAL, PTR(&made))
HOSTILE_VALUE(wcut_mesh_destroy, NULL)

/* the sheet with its border as a loop */
static wcut_trimmed *trimmed(void) {
    static wcut_trimmed *t;
    if (!t) {
        wcut_surface *copy = NULL;
        const wcut_surface *s = sheet();
        ck_assert_int_eq(wcut_surface_create(s->degree_u, s->degree_v, s->count_u, s->count_v, s->knots_u, s->knots_v,
                                             s->control, s->weights, &copy),
                         WCUT_OK);
        ck_assert_int_eq(wcut_trimmed_create(copy, 0, NULL, NULL, 1e-2, &t, NULL), WCUT_OK);
    }
    return t;
}

HOSTILE(wcut_trimmed_create) {
    wcut_trimmed *made = MARK;
    wcut_curve *ring = NULL;
    const wcut_surface *s = sheet();
    ck_assert_int_eq(wcut_surface_iso_curve(s, WCUT_DIRECTION_U, 0.5, &ring), WCUT_OK);
    static const int one[1] = {1};
    const wcut_curve *const all[1] = {ring};

    /* an open curve is no loop: what is refused anyway is refused without harm */
    for (hostile_begin(); hostile_next();) {
        wcut_surface *own = NULL;
        ck_assert_int_eq(wcut_surface_create(s->degree_u, s->degree_v, s->count_u, s->count_v, s->knots_u, s->knots_v,
                                             s->control, s->weights, &own),
                         WCUT_OK);
        ck_assert(wcut_trimmed_create(PTR(own), COUNT(1), PTR(&one[0]), PTR(&all[0]), NUM(1e-2), PTR(&made), NULL) !=
                  WCUT_OK);
        ck_assert_ptr_eq(made, MARK);
        wcut_surface_destroy(own);
    }
    hostile_end("wcut_trimmed_create");
    wcut_curve_destroy(ring);
}

HOSTILE_VALUE(wcut_trimmed_destroy, NULL)
HOSTILE_VALUE(wcut_trimmed_inside, OPT(trimmed()), ANY_NUM(0.5), ANY_NUM(0.5))
HOSTILE_VALUE(wcut_trimmed_border, OPT(trimmed()), (wcut_vec3){NAN, 0, 0})
HOSTILE_MADE(wcut_trimmed_mesh, wcut_mesh, wcut_mesh_destroy, PTR(trimmed()), NUM(0.1), PTR(&made))

HOSTILE(wcut_deviation_from_trimmed) {
    const wcut_deviation_options o = wcut_deviation_options_default();
    static const wcut_vec3 point[2] = {{1, 1, 1}, {2, 2, 2}};
    wcut_deviation d[2];
    hostile_fill(d, sizeof d);
    EACH_HOSTILE_ARGUMENT(wcut_deviation_from_trimmed,
                          wcut_deviation_from_trimmed(PTR(trimmed()), PTR(projection()), COUNT(2), VALUES(point, 2),
                                                      RECORD(&o), THREADS(1), PTR(&d[0]), OPT(NULL)),
                          hostile_is_filled(d, sizeof d), hostile_fill(d, sizeof d));
}

HOSTILE(wcut_surface_tessellate) {
    wcut_mesh *made = MARK;
    wcut_tessellation_report report = {.chord_error = 999};
    EACH_HOSTILE_ARGUMENT(
        wcut_surface_tessellate, wcut_surface_tessellate(PTR(sheet()), NUM(0.1), PTR(&made), OPT(&report)),
        made == MARK && report.chord_error == 999, (wcut_mesh_destroy(made), made = MARK, report.chord_error = 999));
}

HOSTILE(wcut_mesh_sample) {
    wcut_mesh *m = mesh();
    EACH_HOSTILE_ARGUMENT(wcut_mesh_sample,
                          wcut_mesh_sample(PTR(m), COUNT(2), COUNT(2), VALUES(line_knots + 2, 2), VALUES(weights, 4)),
                          !m->scalar, (wcut_free(m->scalar), m->scalar = NULL));
}

HOSTILE(wcut_mesh_crossings) {
    wcut_crossing crossing[4];
    int count = 999;
    hostile_fill(crossing, sizeof crossing);
    EACH_HOSTILE_ARGUMENT(wcut_mesh_crossings,
                          wcut_mesh_crossings(PTR(mesh()), COUNT(4), PTR(&crossing[0]), PTR(&count)),
                          count == 999 && hostile_is_filled(crossing, sizeof crossing), count = 999);
}
