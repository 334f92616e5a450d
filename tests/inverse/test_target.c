/* Targets of a design: heights through scattered points, what is refused, and how it is said. */
#include <string.h>

#include "base/random.h"
#include "inverse/given.h"
#include "inverse/heights.h"
#include "inverse/target.h"

enum { POINTS = 3000 };

/* points of a height with noise, and strays among them */
static void scatter(double (*height)(double, double), double noise, int stray_every, wcut_vec3 *point) {
    wcut_random random = wcut_random_seed(7);
    for (int k = 0; k < POINTS; k++) {
        const double x = 400 * wcut_random_uniform(&random), y = 600 * wcut_random_uniform(&random);
        point[k] = vec3(x, y, height(x, y) + noise * wcut_random_normal(&random));
        if (stray_every && k % stray_every == 0) point[k].z += 12;
    }
}

TEST(heights_through_points_of_a_saddle_have_its_slopes_and_curvatures) {
    static wcut_vec3 point[POINTS];
    wcut_heights h = {0};
    scatter(saddle, 0, 0, point);
    ck_assert_int_eq(wcut_heights_fit(POINTS, point, vec3(0, 0, 0), vec3(400, 600, 0), false, &h), WCUT_OK);
    for (double y = 50; y < 600; y += 100) {
        const wcut_height at = wcut_heights_eval(&h, 130, y);
        ck_assert_double_eq_tol(at.z, saddle(130, y), 0.02);
        ck_assert_double_eq_tol(at.x, 8e-4 * (130 - 200), 2e-3);
        ck_assert_double_eq_tol(at.y, -8e-4 * (y - 300), 2e-3);
        ck_assert_double_eq_tol(at.xx, 8e-4, 1e-4);
        ck_assert_double_eq_tol(at.yy, -8e-4, 1e-4);
    }
    wcut_heights_clear(&h);
}

TEST(heights_go_on_smoothly_beyond_their_rectangle) {
    static wcut_vec3 point[POINTS];
    wcut_heights h = {0};
    scatter(saddle, 0, 0, point);
    ck_assert_int_eq(wcut_heights_fit(POINTS, point, vec3(0, 0, 0), vec3(400, 600, 0), false, &h), WCUT_OK);

    /* slopes there are those of the heights, by central differences */
    const double place[3][2] = {{200, 640}, {-30, 300}, {430, 700}};
    for (int k = 0; k < 3; k++) {
        const double x = place[k][0], y = place[k][1], step = 1e-3;
        const wcut_height at = wcut_heights_eval(&h, x, y);
        const double dx = wcut_heights_eval(&h, x + step, y).z - wcut_heights_eval(&h, x - step, y).z;
        const double dy = wcut_heights_eval(&h, x, y + step).z - wcut_heights_eval(&h, x, y - step).z;
        ck_assert_double_eq_tol(at.x, dx / (2 * step), 1e-7);
        ck_assert_double_eq_tol(at.y, dy / (2 * step), 1e-7);
    }
    wcut_heights_clear(&h);
}

TEST(strays_do_not_move_robust_heights) {
    static wcut_vec3 point[POINTS];
    wcut_heights h = {0};
    scatter(saddle, 0.2, 100, point);
    ck_assert_int_eq(wcut_heights_fit(POINTS, point, vec3(0, 0, 0), vec3(400, 600, 0), true, &h), WCUT_OK);
    double sum = 0;
    for (int k = 0; k < 100; k++) {
        const double x = 40 + 35 * (k % 10), y = 40 + 55 * (k / 10);
        sum += pow(wcut_heights_eval(&h, x, y).z - saddle(x, y), 2);
    }
    ck_assert_double_lt(sqrt(sum / 100), 0.08);
    ck_assert_double_eq_tol(h.scatter, 0.2, 0.04);
    wcut_heights_clear(&h);
}

TEST(a_target_turned_four_ways_has_the_same_heights) {
    wcut_design_target *target = given_target(saddle);
    for (int f = WCUT_DESIGN_FEED_PLUS_Y; f <= WCUT_DESIGN_FEED_MINUS_X; f++) {
        wcut_design_target *turned = NULL;
        ck_assert_int_eq(wcut_design_target_turn(target, (wcut_design_feed)f, &turned), WCUT_OK);
        for (int k = 0; k < 9; k++) {
            const wcut_vec3 p = {40.0 * k, 70.0 * k, 0};
            const wcut_vec3 q = wcut_design_turn((wcut_design_feed)f, target->block, p);
            ck_assert_double_eq_tol(wcut_heights_eval(&turned->heights, q.x, q.y).z,
                                    wcut_heights_eval(&target->heights, p.x, p.y).z, 1e-9);
        }
        wcut_design_target_destroy(turned);
    }
    wcut_design_target_destroy(target);
}

/* ---- what is refused ---- */

static void refused(const wcut_mesh *mesh, const char *words) {
    wcut_design_target *target = (wcut_design_target *)mesh;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_design_target_from_mesh(mesh, given_block, &target, &error), WCUT_DEGENERATE);
    ck_assert_msg(strstr(error.text, words) != NULL, "%s: not in: %s", words, error.text);
    ck_assert_ptr_eq(target, mesh);
}

TEST(targets_in_metres_outside_the_block_and_folded_ones_are_refused_in_words) {
    wcut_surface *surface = given_surface(saddle);
    wcut_mesh *mesh = NULL;
    ck_assert_int_eq(wcut_surface_tessellate(surface, 1, &mesh, NULL), WCUT_OK);
    wcut_surface_destroy(surface);
    wcut_design_target *target = NULL;
    ck_assert_int_eq(wcut_design_target_from_mesh(mesh, given_block, &target, NULL), WCUT_OK);
    wcut_design_target_destroy(target);

    /* metres */
    for (int k = 0; k < mesh->vertex_count; k++) mesh->vertex[k] = vec3_scale(1e-3, mesh->vertex[k]);
    refused(mesh, "metres");

    /* above the block, and beside it */
    for (int k = 0; k < mesh->vertex_count; k++) mesh->vertex[k] = vec3_scale(1e3, mesh->vertex[k]);
    for (int k = 0; k < mesh->vertex_count; k++) mesh->vertex[k].z += 500;
    refused(mesh, "not inside the block's height");
    for (int k = 0; k < mesh->vertex_count; k++) mesh->vertex[k].z -= 500, mesh->vertex[k].x += 5000;
    refused(mesh, "not over the block");

    /* a triangle upside down */
    for (int k = 0; k < mesh->vertex_count; k++) mesh->vertex[k].x -= 5000;
    int *corner = mesh->triangle + 30;
    mesh->vertex[corner[0]].x += 200;
    refused(mesh, "folds over");
    wcut_mesh_destroy(mesh);
}

TEST(a_closed_target_is_refused) {
    wcut_mesh *mesh = NULL;
    ck_assert_int_eq(wcut_mesh_create(4, 4, 0, &mesh), WCUT_OK);
    const wcut_vec3 corner[4] = {{50, 50, 50}, {350, 50, 50}, {200, 500, 50}, {200, 200, 250}};
    const int triangle[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    memcpy(mesh->vertex, corner, sizeof corner);
    memcpy(mesh->triangle, triangle, sizeof triangle);
    refused(mesh, "closed");
    wcut_mesh_destroy(mesh);
}

TEST(a_target_without_memory_leaves_nothing) {
    static wcut_vec3 point[POINTS];
    scatter(saddle, 0.2, 100, point);
    wcut_design_target *target = NULL;
    EACH_FAILED_ALLOCATION(wcut_design_target_from_points(POINTS, point, given_block, &target, NULL), target == NULL);
    wcut_design_target_destroy(target);
    target = NULL;
    wcut_surface *surface = given_surface(saddle);
    EACH_FAILED_ALLOCATION_BY(7, wcut_design_target_from_surface(surface, given_block, &target, NULL), target == NULL);
    wcut_design_target_destroy(target);
    wcut_surface_destroy(surface);
}

/* ---- faces of CAD ---- */

/* a closed line as one curve of straight pieces, on the saddle */
static wcut_curve *square_on_saddle(double low_x, double low_y, double high_x, double high_y) {
    enum { SIDE = 40 };
    static wcut_vec3 point[4 * SIDE + 1];
    static double knot[4 * SIDE + 3];
    const double x[5] = {low_x, high_x, high_x, low_x, low_x}, y[5] = {low_y, low_y, high_y, high_y, low_y};
    for (int k = 0; k <= 4 * SIDE; k++) {
        const int side = k < 4 * SIDE ? k / SIDE : 3;
        const double t = k / (double)SIDE - side;
        const double px = x[side] + t * (x[side + 1] - x[side]), py = y[side] + t * (y[side + 1] - y[side]);
        point[k] = vec3(px, py, saddle(px, py));
        knot[k + 1] = k;
    }
    knot[0] = 0, knot[4 * SIDE + 2] = knot[4 * SIDE + 1];
    wcut_curve *curve = NULL;
    ck_assert_int_eq(wcut_curve_create(1, 4 * SIDE + 1, knot, point, NULL, &curve), WCUT_OK);
    return curve;
}

TEST(of_a_trimmed_face_what_is_inside_its_borders_is_the_target) {
    wcut_curve *outer = square_on_saddle(-10, -10, 410, 610), *hole = square_on_saddle(100, 200, 250, 400);
    const wcut_curve *const curve[2] = {outer, hole};
    const int curves[2] = {1, 1};
    wcut_trimmed *face = NULL;
    wcut_error error = {0};
    ck_assert_msg(wcut_trimmed_create(given_surface(saddle), 2, curves, curve, 0.5, &face, &error) == WCUT_OK, "%s",
                  error.text);
    const wcut_trimmed *const faces[2] = {face, face};
    wcut_design_target *target = NULL;
    ck_assert_msg(wcut_design_target_from_faces(1, faces, given_block, &target, &error) == WCUT_OK, "%s", error.text);

    /* the hole is an eighth of the block; the heights go on over it */
    ck_assert_double_eq_tol(target->covered, 1 - 150.0 * 200 / (400 * 600), 0.02);
    for (int k = 0; k < target->count; k++) {
        const wcut_vec3 p = target->point[k];
        ck_assert(!(p.x > 101 && p.x < 249 && p.y > 201 && p.y < 399));
    }
    ck_assert_double_eq_tol(wcut_heights_eval(&target->heights, 175, 300).z, saddle(175, 300), 0.1);
    wcut_design_target_destroy(target);

    /* the same face twice is one sheet; a second one above the first is none */
    ck_assert_int_eq(wcut_design_target_from_faces(2, faces, given_block, &target, NULL), WCUT_OK);
    wcut_design_target_destroy(target);
    const wcut_affine up = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 6}};
    wcut_trimmed above = {0};
    ck_assert_int_eq(wcut_surface_transform(face->surface, &up, &above.surface), WCUT_OK);
    const wcut_trimmed *const two[2] = {face, &above};
    ck_assert_int_eq(wcut_design_target_from_faces(2, two, given_block, &target, &error), WCUT_DEGENERATE);
    ck_assert_msg(strstr(error.text, "above each other") != NULL, "%s", error.text);
    wcut_surface_destroy(above.surface);
    wcut_trimmed_destroy(face);
    wcut_curve_destroy(outer);
    wcut_curve_destroy(hole);
}
