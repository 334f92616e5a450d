/* labels: unit property
   Boxes and clearances against closed forms and dense samples. */
#include <wirecut/bounds.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

static wcut_curve *random_curve(wcut_random *random, bool rational) {
    enum { COUNT = 14 };
    double knots[COUNT + 5], weight[COUNT];
    wcut_vec3 p[COUNT];
    for (int k = 0; k < COUNT + 5; k++) knots[k] = k < 5 ? 0 : k >= COUNT ? 1 : (k - 4.0) / (COUNT - 4);
    for (int k = 0; k < COUNT; k++) {
        p[k] = vec3(200 * wcut_random_uniform(random) - 100, 200 * wcut_random_uniform(random) - 100,
                    200 * wcut_random_uniform(random) - 100);
        weight[k] = 0.2 + wcut_random_uniform(random);
    }
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(4, COUNT, knots, p, rational ? weight : NULL, &c), WCUT_OK);
    return c;
}

TEST(the_box_of_sphere_and_torus_is_known) {
    wcut_surface *s = shape_sphere(37);
    wcut_box box = {{999, 999, 999}, {999, 999, 999}};
    for (double tolerance = 1; tolerance > 1e-9; tolerance /= 100) {
        ck_assert_int_eq(wcut_surface_bounds(s, tolerance, &box), WCUT_OK);
        const double side[6] = {-box.low.x, -box.low.y, -box.low.z, box.high.x, box.high.y, box.high.z};
        for (int k = 0; k < 6; k++) ck_assert(side[k] >= 37 - 1e-12 && side[k] <= 37 + tolerance + 1e-12);
    }
    wcut_surface_destroy(s);
    s = shape_torus(50, 20);
    ck_assert_int_eq(wcut_surface_bounds(s, 1e-300, &box), WCUT_OK);
    ck_assert_double_eq_tol(box.high.x, 70, 1e-9);
    ck_assert_double_eq_tol(box.low.z, -20, 1e-9);
    wcut_surface_destroy(s);
}

TEST(a_box_holds_its_curve_and_touches_it_on_every_side) {
    wcut_random random = wcut_random_seed(21);
    for (int trial = 0; trial < 50; trial++) {
        wcut_curve *c = random_curve(&random, trial % 2);
        wcut_box box;
        ck_assert_int_eq(wcut_curve_bounds(c, 1e-3, &box), WCUT_OK);
        wcut_vec3 low = {INFINITY, INFINITY, INFINITY}, high = {-INFINITY, -INFINITY, -INFINITY};
        for (int i = 0; i <= 20000; i++) {
            wcut_vec3 p;
            ck_assert_int_eq(wcut_curve_eval(c, i / 20000.0, 0, &p), WCUT_OK);
            low = vec3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
            high = vec3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
        }
        const double gap[6] = {low.x - box.low.x,   low.y - box.low.y,   low.z - box.low.z,
                               box.high.x - high.x, box.high.y - high.y, box.high.z - high.z};
        for (int k = 0; k < 6; k++) ck_assert(gap[k] >= -1e-12 && gap[k] <= 1.2e-3);
        wcut_curve_destroy(c);
    }
}

TEST(no_point_of_a_curve_is_nearer_to_a_block_than_its_clearance) {
    wcut_random random = wcut_random_seed(22);
    int clear = 0;
    for (int trial = 0; trial < 200; trial++) {
        wcut_curve *c = random_curve(&random, trial % 2);
        const wcut_vec3 at = {100 * wcut_random_uniform(&random) - 50, 100 * wcut_random_uniform(&random) - 50,
                              100 * wcut_random_uniform(&random) - 50};
        const wcut_box block = {at, {at.x + 5, at.y + 30, at.z + 10}};
        double distance = 999, u = 999, nearest = INFINITY, there = 0;
        ck_assert_int_eq(wcut_curve_clearance(c, &block, 1e-4, &distance, &u), WCUT_OK);
        for (int i = 0; i <= 5001; i++) {
            wcut_vec3 p;
            ck_assert_int_eq(wcut_curve_eval(c, i < 5001 ? i / 5000.0 : u, 0, &p), WCUT_OK);
            const double x = fmax(0, fmax(block.low.x - p.x, p.x - block.high.x)),
                         y = fmax(0, fmax(block.low.y - p.y, p.y - block.high.y)),
                         z = fmax(0, fmax(block.low.z - p.z, p.z - block.high.z));
            there = sqrt(x * x + y * y + z * z);
            nearest = fmin(nearest, there);
        }
        ck_assert(distance <= nearest && there <= distance + 1e-4 + 1e-12 && nearest - distance < 0.2);
        clear += distance > 0;
        wcut_curve_destroy(c);
    }
    ck_assert_int_gt(clear, 20);
}

TEST(a_curve_along_a_face_of_the_block_keeps_its_distance) {
    const double knots[4] = {0, 0, 1, 1};
    const wcut_vec3 p[2] = {{-50, -3, 7}, {90, -3, 7}};
    const wcut_box block = {{0, 0, 0}, {40, 50, 60}};
    wcut_curve *c = NULL;
    double distance = 999;
    ck_assert_int_eq(wcut_curve_create(1, 2, knots, p, NULL, &c), WCUT_OK);
    ck_assert_int_eq(wcut_curve_clearance(c, &block, 1e-300, &distance, NULL), WCUT_OK);
    ck_assert_double_eq_tol(distance, 3, 1e-9);
    c->control[0].y = c->control[1].y = 20;
    ck_assert_int_eq(wcut_curve_clearance(c, &block, 1e-6, &distance, NULL), WCUT_OK);
    ck_assert(distance == 0);
    wcut_curve_destroy(c);
}

/* the mount turns around the block's edge at x = 0, y = 0: its stations stay 20 mm away, the curve between does not */
TEST(a_path_comes_nearer_between_its_stations_than_at_them) {
    const wcut_vec3 mount[6] = {{-20, 80, 5}, {-20, 40, 5}, {-20, 40, 5}, {-16, -12, 5}, {40, -20, 5}, {80, -20, 5}};
    const wcut_box block = {{0, 0, 0}, {100, 100, 10}};
    wcut_path_near near = {.distance = 999};
    wcut_vec3 apart[5] = {mount[0], mount[1], mount[3], mount[4], mount[5]};
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_path_clearance(6, mount, &block, 1e-6, &near), WCUT_OK);
    ck_assert_int_eq(wcut_curve_interpolate(5, apart, &c), WCUT_OK);
    double min = INFINITY;
    for (int k = 0; k <= 100000; k++) {
        wcut_vec3 p;
        ck_assert_int_eq(wcut_curve_eval(c, k / 1e5, 0, &p), WCUT_OK);
        min = fmin(min, hypot(fmax(0, -p.x), fmax(0, -p.y)));
    }
    ck_assert_double_le(fabs(near.distance - min), 1e-5);
    ck_assert_double_lt(near.distance, 19.5); /* 20 at every station */
    ck_assert_double_le(fabs(hypot(fmax(0, -near.place.x), fmax(0, -near.place.y)) - near.distance), 1e-5);
    ck_assert(near.station > 0 && near.station < 5 && fabs(near.station - floor(near.station + 0.5)) > 0.05);
    wcut_curve_destroy(c);
    /* one that stands still, for as many stations as there are */
    for (int k = 0; k < 6; k++) apart[k % 5] = vec3(-3, 50, 14);
    ck_assert_int_eq(wcut_path_clearance(5, apart, &block, 1e-6, &near), WCUT_OK);
    ck_assert(near.distance == 5 && near.station == 0 && near.place.x == -3);
    ck_assert_int_eq(wcut_path_clearance(0, mount, &block, 1, &near), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_path_clearance(6, NULL, &block, 1, &near), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_path_clearance(6, mount, NULL, 1, &near), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_path_clearance(6, mount, &block, 0, &near), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_path_clearance(6, mount, &block, 1, NULL), WCUT_BAD_ARGUMENT);
    apart[2].y = NAN;
    ck_assert_int_eq(wcut_path_clearance(5, apart, &block, 1, &near), WCUT_BAD_ARGUMENT);
    ck_assert(near.distance == 5);
    EACH_FAILED_ALLOCATION(wcut_path_clearance(6, mount, &block, 1e-3, &near), near.distance == 5);
}

TEST(bad_arguments_are_refused_and_nothing_is_written) {
    wcut_surface *s = shape_octant();
    wcut_random random = wcut_random_seed(23);
    wcut_curve *c = random_curve(&random, false);
    wcut_box box = {{999, 0, 0}, {0, 0, 0}};
    const wcut_box block = {{0, 0, 0}, {1, 1, 1}}, turned = {{1, 0, 0}, {0, 1, 1}},
                   open = {{0, 0, 0}, {INFINITY, 1, 1}};
    double distance = 999;
    ck_assert_int_eq(wcut_surface_bounds(NULL, 1, &box), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_bounds(s, 0, &box), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_bounds(s, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_bounds(NULL, 1, &box), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_bounds(c, NAN, &box), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_clearance(NULL, &block, 1, &distance, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_clearance(c, &turned, 1, &distance, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_clearance(c, &open, 1, &distance, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_clearance(c, &block, 0, &distance, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_clearance(c, &block, 1, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert(box.low.x == 999 && distance == 999);
    wcut_curve_destroy(c);
    wcut_surface_destroy(s);
}
