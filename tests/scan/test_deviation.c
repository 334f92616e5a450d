/* Deviations from faces that are known: both sides, borders and windows; the face of a job and its grid; holes. */
#include <stdio.h>
#include <wirecut/deviation_summary.h>
#include <wirecut/face.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "scan/sheets.h"
#include "test.h"

enum { ROWS = 81, COLUMNS = 41, POINTS = 20000 };

/* ---- a surface in closed form: waves over 400 x 1200 mm, bent at most with a radius of 118 mm ---- */

static wcut_surface *surface;
static wcut_projection *projection;
static wcut_vec3 point[POINTS], node[ROWS * COLUMNS];
static wcut_deviation deviation[POINTS];
static double made[POINTS];

static double height(double x, double y) { return 150 + 30 * sin(x / 80) + 20 * cos(y / 130); }

static wcut_vec3 normal(double x, double y) {
    return vec3_unit(vec3(-30.0 / 80 * cos(x / 80), 20.0 / 130 * sin(y / 130), 1));
}

static wcut_vec3 lifted(double x, double y, double by) {
    return vec3_add_scaled(vec3(x, y, height(x, y)), by, normal(x, y));
}

static void given_surface(void) {
    for (int k = 0; k < ROWS * COLUMNS; k++) {
        const double x = 400.0 * (k % COLUMNS) / (COLUMNS - 1), y = 1200.0 * (k / COLUMNS) / (ROWS - 1);
        node[k] = vec3(x, y, height(x, y));
    }
    ck_assert_int_eq(wcut_surface_loft(ROWS, COLUMNS, node, 0, &surface, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_projection_create(surface, &projection), WCUT_OK);
}

static void forget_surface(void) {
    wcut_projection_destroy(projection);
    wcut_surface_destroy(surface);
}

/* the offset field of the tests; size 1 */
static double field(double x, double y) { return sin(x / 30) * cos(y / 50); }

/* points over the face, `margin` from its border, off it by `size` times the field and noise */
static void given_points(int count, double margin, double size, double noise, uint64_t seed) {
    wcut_random r = wcut_random_seed(seed);
    for (int k = 0; k < count; k++) {
        const double x = margin + (400 - 2 * margin) * wcut_random_uniform(&r);
        const double y = margin + (1200 - 2 * margin) * wcut_random_uniform(&r);
        made[k] = size * field(x, y) + (noise > 0 ? noise * wcut_random_normal(&r) : 0);
        point[k] = lifted(x, y, made[k]);
    }
}

TEST(an_offset_is_recovered_with_its_sign_on_both_sides) {
    given_surface();
    for (int t = 0; t < 4; t++) {
        const double size = pow(10, t - 2); /* 0.01 to 10 mm, well below the radius of 118 mm */
        given_points(POINTS, 5, size, 0, (uint64_t)t + 1);
        ck_assert_int_eq(wcut_deviation_from_surface(projection, POINTS, point, NULL, 2, deviation, NULL), WCUT_OK);
        for (int k = 0; k < POINTS; k++) {
            /* the loft itself is 1e-3 mm off the waves */
            ck_assert_double_eq_tol(deviation[k].distance, made[k], 2e-3);
            ck_assert(fabs(made[k]) < 2e-3 || (deviation[k].distance > 0) == (made[k] > 0));
            ck_assert(deviation[k].place == WCUT_PLACE_INSIDE && deviation[k].triangle == -1);
        }
    }
    forget_surface();
}

TEST(a_mesh_of_the_surface_says_the_same) {
    wcut_mesh *mesh = NULL;
    wcut_mesh_tree *tree = NULL;
    static wcut_deviation other[POINTS];
    given_surface();
    ck_assert_int_eq(wcut_surface_tessellate(surface, 0.002, &mesh, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_mesh_tree_create(mesh, &tree), WCUT_OK);
    given_points(POINTS, 5, 1, 0.1, 7);
    ck_assert_int_eq(wcut_deviation_from_surface(projection, POINTS, point, NULL, 2, deviation, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_from_mesh(tree, POINTS, point, NULL, 2, other), WCUT_OK);
    for (int k = 0; k < POINTS; k++) {
        ck_assert_double_eq_tol(other[k].distance, deviation[k].distance, 0.0021);
        ck_assert_int_eq(other[k].place, WCUT_PLACE_INSIDE);
        ck_assert_int_ge(other[k].triangle, 0);
    }
    ck_assert_int_eq(wcut_deviation_onto_surface(mesh, POINTS, other), WCUT_OK);
    for (int k = 0; k < POINTS; k++) {
        wcut_vec3 at;
        ck_assert_int_eq(wcut_surface_eval(surface, other[k].u, other[k].v, 0, &at), WCUT_OK);
        ck_assert_double_le(vec3_distance(at, other[k].foot), 0.05);
        ck_assert_int_eq(other[k].triangle, -1);
    }
    ck_assert_int_eq(wcut_deviation_onto_surface(mesh, 1, other), WCUT_BAD_ARGUMENT); /* they are already */
    ck_assert_int_eq(wcut_deviation_onto_surface(NULL, 0, other), WCUT_BAD_ARGUMENT);
    wcut_mesh_tree_destroy(tree);
    wcut_mesh_destroy(mesh);
    forget_surface();
}

TEST(points_outside_are_counted_and_are_no_deviations) {
    given_surface();
    int beyond = 0;
    wcut_random r = wcut_random_seed(5);
    for (int k = 0; k < POINTS; k++) { /* a frame of 20 mm about the face */
        const double x = -20 + 440 * wcut_random_uniform(&r), y = -20 + 1240 * wcut_random_uniform(&r);
        point[k] = vec3(x, y, height(clamp(x, 0, 400), clamp(y, 0, 1200)));
        made[k] = x < 0 || x > 400 || y < 0 || y > 1200;
        beyond += made[k] != 0;
    }
    ck_assert_int_eq(wcut_deviation_from_surface(projection, POINTS, point, NULL, 1, deviation, NULL), WCUT_OK);
    int found = 0;
    for (int k = 0; k < POINTS; k++) {
        found += deviation[k].place == WCUT_PLACE_BEYOND;
        if (deviation[k].place > WCUT_PLACE_BORDER) continue;
        ck_assert_double_lt(fabs(deviation[k].distance), 2.1e-3 + 20 * made[k]);
    }
    /* near the border the tilt of the face decides on which side of it a point within 1e-3 mm is */
    ck_assert_int_le(abs(found - beyond), 3);
    ck_assert_int_gt(beyond, 500);
    forget_surface();
}

TEST(window_border_reach_and_flip_decide_what_counts) {
    wcut_deviation_options o = wcut_deviation_options_default();
    given_surface();
    o.low = vec3(100, 200, 0), o.high = vec3(300, 1000, 300);
    o.border = 5;
    const struct {
        double x, y, by;
        wcut_place place;
    } given[] = {
        {200, 600, 1, WCUT_PLACE_INSIDE},  {103, 600, 1, WCUT_PLACE_BORDER}, {99, 600, 1, WCUT_PLACE_BEYOND},
        {298, 600, 1, WCUT_PLACE_BORDER},  {301, 600, 1, WCUT_PLACE_BEYOND}, {200, 199, -1, WCUT_PLACE_BEYOND},
        {200, 998, -1, WCUT_PLACE_BORDER}, {200, 600, 9, WCUT_PLACE_INSIDE}, {200, 600, -11, WCUT_PLACE_BEYOND}};
    o.reach = 10;
    for (int flip = 0; flip < 2; flip++)
        for (size_t k = 0; k < sizeof given / sizeof *given; k++) {
            o.flip = flip;
            point[0] = lifted(given[k].x, given[k].y, given[k].by);
            ck_assert_int_eq(wcut_deviation_from_surface(projection, 1, point, &o, 1, deviation, NULL), WCUT_OK);
            ck_assert_msg(deviation->place == given[k].place, "point %zu: %s", k, wcut_place_name(deviation->place));
            ck_assert_double_eq_tol(deviation->distance, flip ? -given[k].by : given[k].by, 2e-3);
        }
    forget_surface();
}

TEST(a_point_at_a_centre_of_curvature_has_no_side_to_be_sure_of) {
    wcut_vec3 arc[2 * 41];
    for (int k = 0; k < 82; k++) { /* half a cylinder of radius 50 about the line y, z = 0; it opens upwards */
        const double angle = acos(-1) * (k % 41) / 40;
        arc[k] = vec3(-50 * cos(angle), 100 * (k / 41), -50 * sin(angle));
    }
    ck_assert_int_eq(wcut_surface_loft(2, 41, arc, 0, &surface, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_projection_create(surface, &projection), WCUT_OK);
    point[0] = vec3(0, 50, -45), point[1] = vec3(0, 50, -55), point[2] = vec3(3, 50, -20);
    ck_assert_int_eq(wcut_deviation_from_surface(projection, 3, point, NULL, 1, deviation, NULL), WCUT_OK);
    ck_assert_double_eq_tol(deviation[0].distance, 5, 1e-3);
    ck_assert_double_eq_tol(deviation[1].distance, -5, 1e-3);
    ck_assert_double_eq_tol(deviation[2].distance, 50 - hypot(3, 20), 1e-3);
    forget_surface();
}

TEST(bad_arguments_are_refused) {
    wcut_deviation_options o = wcut_deviation_options_default();
    given_surface();
    given_points(3, 5, 1, 0, 1);
    deviation[0].distance = 999;
    ck_assert_int_eq(wcut_deviation_from_surface(NULL, 1, point, NULL, 1, deviation, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_from_surface(projection, -1, point, NULL, 1, deviation, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_from_surface(projection, 1, point, NULL, 0, deviation, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_from_surface(projection, 1, NULL, NULL, 1, deviation, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_from_mesh(NULL, 1, point, NULL, 1, deviation), WCUT_BAD_ARGUMENT);
    for (int k = 0; k < 4; k++) {
        o = wcut_deviation_options_default();
        if (k == 0) o.border = -1;
        if (k == 1) o.reach = NAN;
        if (k == 2) o.low.x = 5, o.high.x = 4;
        if (k == 3) o.low.z = NAN;
        ck_assert_int_eq(wcut_deviation_from_surface(projection, 1, point, &o, 1, deviation, NULL), WCUT_BAD_ARGUMENT);
    }
    point[1].z = NAN;
    ck_assert_int_eq(wcut_deviation_from_surface(projection, 3, point, NULL, 1, deviation, NULL), WCUT_BAD_ARGUMENT);
    point[1].z = 2e12;
    ck_assert_int_eq(wcut_deviation_from_surface(projection, 3, point, NULL, 1, deviation, NULL), WCUT_BAD_ARGUMENT);
    FIRST_FAILED_ALLOCATIONS(2, wcut_deviation_from_surface(projection, 1, point, NULL, 1, deviation, NULL),
                             deviation[0].distance == 999);
    ck_assert(deviation[0].distance == 999);
    ck_assert_ptr_null(wcut_place_name(WCUT_PLACE_COUNT));
    ck_assert_str_eq(wcut_place_name(WCUT_PLACE_BEYOND), "beyond");
    forget_surface();
}

/* ---- the way back ---- */

TEST(the_way_back_is_that_of_a_full_search) {
    static double distance[300];
    given_points(2000, 0, 1, 0.1, 2);
    wcut_vec3 query[300];
    wcut_random r = wcut_random_seed(3);
    for (int k = 0; k < 300; k++)
        query[k] = vec3(500 * wcut_random_uniform(&r) - 50, 1300 * wcut_random_uniform(&r) - 50,
                        300 * wcut_random_uniform(&r));
    ck_assert_int_eq(wcut_cloud_locate(2000, point, 300, query, 2, distance), WCUT_OK);
    for (int k = 0; k < 300; k++) {
        double min = INFINITY;
        for (int i = 0; i < 2000; i++) min = fmin(min, vec3_distance(query[k], point[i]));
        ck_assert_double_eq_tol(distance[k], min, 1e-12);
    }
    distance[0] = 999;
    ck_assert_int_eq(wcut_cloud_locate(0, point, 1, query, 1, distance), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_locate(1, point, 1, NULL, 1, distance), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_locate(1, NULL, 1, query, 1, distance), WCUT_BAD_ARGUMENT);
    query[0].x = INFINITY;
    ck_assert_int_eq(wcut_cloud_locate(1, point, 1, query, 1, distance), WCUT_BAD_ARGUMENT);
    wcut_alloc_fail_at(1);
    ck_assert_int_eq(wcut_cloud_locate(1, point, 0, query, 1, distance), WCUT_NO_MEMORY);
    wcut_alloc_fail_at(0);
    ck_assert(distance[0] == 999);
}

/* ---- the face of a job ---- */

static wcut_job job;
static wcut_history history;
static wcut_history_row row[ROWS];
static double force[ROWS * COLUMNS], speed[ROWS * COLUMNS];
static wcut_vec3 mount_a[ROWS], mount_b[ROWS];

/* a wire from x = -100 to 500 that sweeps the waves from y = -60 to 1260, bowed back by 40 mm in its middle */
static void given_history(void) {
    static const wcut_history_row none = {0};
    job = (wcut_job){.block_size = {400, 1200, 300}, .heat = 60, .speed_min = 0.1, .kerf_width = 1};
    for (int s = 0; s < ROWS; s++) {
        const double y0 = -60 + 1360.0 * s / (ROWS - 1);
        row[s] = none;
        row[s].time = 2.0 * s;
        row[s].phase = s < 5    ? WCUT_PHASE_APPROACH
                       : s < 20 ? WCUT_PHASE_ENTRY
                       : s < 60 ? WCUT_PHASE_STEADY
                       : s < 76 ? WCUT_PHASE_EXIT
                                : WCUT_PHASE_LEFT;
        for (int n = 0; n < COLUMNS; n++) {
            const double t = 2.0 * n / (COLUMNS - 1) - 1, x = 200 + 300 * t, y = y0 - 40 * (1 - t * t);
            node[s * COLUMNS + n] = vec3(x, y, height(x, y));
            force[s * COLUMNS + n] = 0.01;
            speed[s * COLUMNS + n] = s ? 12 + t : 0;
        }
        mount_a[s] = node[(size_t)s * COLUMNS], mount_b[s] = node[(size_t)s * COLUMNS + COLUMNS - 1];
    }
    history = (wcut_history){.stations = ROWS,
                             .planned = ROWS,
                             .nodes = COLUMNS,
                             .row = row,
                             .position = node,
                             .force_line = force,
                             .speed = speed};
}

TEST(the_face_lies_half_a_kerf_below_the_wires_surface) {
    wcut_face *face = NULL;
    given_history();
    job.kerf_per_q = 1e-4;
    ck_assert_int_eq(wcut_face_create(&job, &history, mount_a, mount_b, 1e-3, &face), WCUT_OK);
    for (int s = 0; s < ROWS; s++)
        for (int n = 0; n < COLUMNS; n++) {
            const wcut_vec3 p = face->point[s * COLUMNS + n];
            const double t = (p.x - 200) / 300, kerf = 1 + 1e-4 * 60e3 / (12 + t);
            ck_assert_double_eq_tol(2 * face->half_kerf[s * COLUMNS + n], kerf, 2e-3);
            /* the waves lowered along their normal: project back onto them */
            wcut_vec3 q = p;
            for (int k = 0; k < 30; k++) {
                const wcut_vec3 up = lifted(q.x, q.y, -kerf / 2);
                q.x += p.x - up.x, q.y += p.y - up.y;
            }
            ck_assert_double_eq_tol(lifted(q.x, q.y, -kerf / 2).z, p.z, 0.01);
        }
    ck_assert_double_eq_tol(wcut_face_kerf(face), 1 + 6 / 12.0, 0.005);
    wcut_face_destroy(face);
}

TEST(its_grid_ends_where_the_block_does) {
    wcut_face *face = NULL;
    wcut_mesh *mesh = NULL;
    given_history();
    ck_assert_int_eq(wcut_face_create(&job, &history, NULL, NULL, 1e-3, &face), WCUT_OK);
    int inside = 0;
    for (int k = 0; k < ROWS * COLUMNS; k++) {
        const wcut_vec3 p = face->point[k];
        ck_assert(p.x > -1e-4 && p.x < 400 + 1e-4 && p.y > -1e-6 && p.y < 1200 + 1e-6);
        if (k % COLUMNS == 0) ck_assert_double_eq_tol(p.x, 0, 1e-4);
        if (k % COLUMNS == COLUMNS - 1) ck_assert_double_eq_tol(p.x, 400, 1e-4);
        if (k / COLUMNS == 0) ck_assert_double_eq_tol(p.y, 0, 1e-6);
        if (k / COLUMNS == ROWS - 1) ck_assert_double_eq_tol(p.y, 1200, 1e-6);
        inside += face->inside[k];
    }
    ck_assert(inside > ROWS * COLUMNS * 8 / 10 && inside < ROWS * COLUMNS);
    ck_assert(face->time[5] == 0 && face->time[15] == 20 && face->phase[30] == WCUT_PHASE_STEADY);
    /* the mesh covers the block seen from above, without gap or overlap */
    ck_assert_int_eq(wcut_face_mesh(face, &mesh), WCUT_OK);
    double area = 0;
    for (int t = 0; t < mesh->triangle_count; t++) {
        const wcut_vec3 a = mesh->vertex[mesh->triangle[3 * (size_t)t]], b = mesh->vertex[mesh->triangle[3 * t + 1]],
                        c = mesh->vertex[mesh->triangle[3 * t + 2]];
        const double twice = vec3_cross(vec3_sub(b, a), vec3_sub(c, a)).z;
        ck_assert_double_gt(twice, 0);
        area += twice / 2;
    }
    ck_assert_double_eq_tol(area, 400 * 1200, 0.1); /* seen from above its edges are straight */
    wcut_mesh_destroy(mesh);
    wcut_face_destroy(face);
}

/* points of the face itself, off it by the field; `hole` leaves out a square about (200, 600) */
static int given_scan(const wcut_face *face, double hole) {
    wcut_vec3 d[4];
    int count = 0;
    wcut_random r = wcut_random_seed(21);
    while (count < POINTS) {
        const double u = wcut_random_uniform(&r), v = wcut_random_uniform(&r);
        ck_assert_int_eq(wcut_surface_eval(face->surface, u, v, 1, d), WCUT_OK);
        if (d[0].x < 1 || d[0].x > 399 || d[0].y < 1 || d[0].y > 1199) continue;
        if (fabs(d[0].x - 200) < hole && fabs(d[0].y - 600) < hole) continue;
        made[count] = 0.5 * sin(d[0].x / 60);
        point[count] = vec3_add_scaled(d[0], made[count], vec3_unit(vec3_cross(d[2], d[1])));
        count++;
    }
    return count;
}

TEST(a_map_shows_what_was_scanned_and_leaves_holes) {
    static double value[ROWS * COLUMNS];
    static unsigned char present[ROWS * COLUMNS];
    const double hole = 60;
    wcut_face *face = NULL;
    wcut_face_map *map = NULL;
    double missing = 999;
    given_history();
    ck_assert_int_eq(wcut_face_create(&job, &history, mount_a, mount_b, 1e-3, &face), WCUT_OK);
    ck_assert_int_eq(wcut_projection_create(face->surface, &projection), WCUT_OK);
    const int count = given_scan(face, hole);
    ck_assert_int_eq(wcut_deviation_from_surface(projection, count, point, NULL, 2, deviation, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_face_map_create(face, &map), WCUT_OK);
    wcut_face_map_add(map, face, count, deviation);
    ck_assert_int_eq(wcut_face_map_eval(map, face, 12, value, present, &missing), WCUT_OK);
    for (int k = 0; k < ROWS * COLUMNS; k++) {
        const wcut_vec3 p = face->point[k];
        const double away = fmax(fabs(p.x - 200), fabs(p.y - 600));
        if (!face->inside[k]) continue;
        if (away < hole - 30) ck_assert_int_eq(present[k], 0);
        if (away < hole + 5) continue;
        ck_assert_int_eq(present[k], 1);
        if (p.x > 25 && p.x < 375) ck_assert_double_eq_tol(value[k], 0.5 * sin(p.x / 60), 0.06);
    }
    /* the hole, less what its rim speaks for */
    ck_assert(missing < 4 * hole * hole && missing > 4 * (hole - 18) * (hole - 18));
    ck_assert_int_eq(wcut_face_map_eval(map, face, -1, value, present, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_face_map_eval(NULL, face, 1, value, present, NULL), WCUT_BAD_ARGUMENT);
    wcut_alloc_fail_at(1);
    ck_assert_int_eq(wcut_face_map_eval(map, face, 1, value, present, NULL), WCUT_NO_MEMORY);
    wcut_alloc_fail_at(0);
    wcut_face_map_destroy(map);
    wcut_projection_destroy(projection);
    wcut_face_destroy(face);
}

TEST(parts_of_the_cut_and_what_goes_with_the_deviation_are_found) {
    wcut_face *face = NULL;
    wcut_deviation_summary *summary = NULL;
    const wcut_deviation_summary_result *r = NULL;
    wcut_deviation_summary_options o = wcut_deviation_summary_options_default();
    o.high = vec3(400, 1200, 300);
    given_history();
    ck_assert_int_eq(wcut_face_create(&job, &history, mount_a, mount_b, 1e-3, &face), WCUT_OK);
    ck_assert_int_eq(wcut_projection_create(face->surface, &projection), WCUT_OK);
    const int count = given_scan(face, 0);
    ck_assert_int_eq(wcut_deviation_from_surface(projection, count, point, NULL, 2, deviation, NULL), WCUT_OK);
    for (int k = 0; k < count; k++) { /* grows with time: 0 at entry, -1 mm at the end */
        double station, column;
        wcut_face_locate(face, deviation[k].u, deviation[k].v, &station, &column);
        deviation[k].distance = -station / (ROWS - 1);
    }
    ck_assert_int_eq(wcut_deviation_summary_create(&o, face, &summary), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_summary_add(summary, count, deviation), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_summary_eval(summary, &r), WCUT_OK);
    ck_assert(r->related && r->time.of_deviation < -0.9999 && r->time.of_size > 0.9999);
    ck_assert(fabs(r->path.of_deviation) <= 1 && fabs(r->bend.of_size) <= 1);
    const char *const name[] = {"entry", "steady", "exit"};
    const double low[] = {0, 19, 59}, high[] = {20, 60, 80};
    int sum = 0;
    for (int k = 0; k < 3; k++) {
        const wcut_zone *z = &r->zone[k];
        ck_assert_str_eq(z->name, name[k]);
        ck_assert(!z->is_patch && z->count > 1000 && z->max <= -low[k] / (ROWS - 1) && z->min >= -high[k] / (ROWS - 1));
        sum += z->count;
    }
    ck_assert_int_eq(sum, r->statistics.count);
    wcut_deviation_summary_destroy(summary);
    wcut_projection_destroy(projection);
    wcut_face_destroy(face);
}

TEST(path_curvature_is_that_of_the_mounts) {
    wcut_face *face = NULL;
    given_history();
    for (int s = 0; s < ROWS; s++) { /* arcs of radius 900 and 1800 mm */
        const double angle = 1.2 * s / ROWS;
        mount_a[s] = vec3(-100, 900 * sin(angle), 900 * cos(angle));
        mount_b[s] = vec3(500, 1800 * sin(angle), 1800 * cos(angle));
    }
    ck_assert_int_eq(wcut_face_create(&job, &history, mount_a, mount_b, 1e-3, &face), WCUT_OK);
    for (int s = 2; s < ROWS - 2; s++) ck_assert_double_eq_tol(face->path_bend[s], (1 / 900.0 + 1 / 1800.0) / 2, 1e-9);
    wcut_face_destroy(face);
}

TEST(bad_faces_are_refused) {
    wcut_face *face = (wcut_face *)999;
    given_history();
    ck_assert_int_eq(wcut_face_create(NULL, &history, NULL, NULL, 0, &face), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_face_create(&job, NULL, NULL, NULL, 0, &face), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_face_create(&job, &history, mount_a, NULL, 0, &face), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_face_create(&job, &history, NULL, NULL, NAN, &face), WCUT_BAD_ARGUMENT);
    history.stations = 1;
    ck_assert_int_eq(wcut_face_create(&job, &history, NULL, NULL, 0, &face), WCUT_BAD_ARGUMENT);
    given_history();
    for (int k = 0; k < ROWS * COLUMNS; k++) node[k].y -= 1e4; /* beside the block */
    ck_assert_int_eq(wcut_face_create(&job, &history, NULL, NULL, 0, &face), WCUT_DEGENERATE);
    for (int k = 0; k < ROWS * COLUMNS; k++) node[k] = node[k % COLUMNS]; /* it does not move */
    ck_assert_int_eq(wcut_face_create(&job, &history, NULL, NULL, 1e-3, &face), WCUT_DEGENERATE);
    ck_assert_ptr_eq(face, (wcut_face *)999);
    given_history();
    EACH_FAILED_ALLOCATION_BY(3, wcut_face_create(&job, &history, mount_a, mount_b, 0, &face),
                              face == (wcut_face *)999);
    wcut_face_destroy(face);
    wcut_face_destroy(NULL);
    wcut_face_map_destroy(NULL);
}
