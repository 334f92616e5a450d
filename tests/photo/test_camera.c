/* Cameras from points: closed forms, noise, and what is refused. */
#include <string.h>

#include "photo/views.h"

enum { WIDTH = 3000, HEIGHT = 2000, ALL = 12 };

static const wcut_vec3 corner[ALL] = {{0, 0, 0},     {400, 0, 0},     {400, 900, 0},   {0, 900, 0},
                                      {0, 0, 300},   {400, 0, 300},   {400, 900, 300}, {0, 900, 300},
                                      {200, 0, 150}, {200, 900, 100}, {0, 450, 150},   {400, 450, 75}};

static wcut_camera given(void) {
    return camera_at((wcut_vec3){300, -500, 1500}, (wcut_vec3){200, 450, 150}, 2400, WIDTH, HEIGHT, -0.08, 0.02);
}

static void see(const wcut_camera *c, int count, const wcut_vec3 *place, wcut_photo_point *point) {
    for (int k = 0; k < count; k++) point[k] = seen_by(c, place[k]);
}

static wcut_status fit(int count, const wcut_photo_point *point, wcut_camera *c, wcut_camera_report *r,
                       wcut_error *error) {
    return wcut_camera_fit(count, point, WIDTH, HEIGHT, NULL, c, r, NULL, NULL, error);
}

static double far_apart(wcut_vec3 a, wcut_vec3 b) {
    return sqrt(pow(a.x - b.x, 2) + pow(a.y - b.y, 2) + pow(a.z - b.z, 2));
}

TEST(twelve_exact_points_give_back_camera_and_distortion) {
    const wcut_camera c = given();
    wcut_photo_point p[ALL];
    wcut_camera found;
    wcut_camera_report r;
    wcut_error error = {0};
    see(&c, ALL, corner, p);
    ck_assert_msg(fit(ALL, p, &found, &r, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(found.kind, WCUT_CAMERA_KIND_FULL);
    ck_assert_double_eq_tol(found.focal, c.focal, 1e-3);
    ck_assert_double_eq_tol(found.k1, c.k1, 1e-6);
    ck_assert_double_eq_tol(found.k2, c.k2, 1e-5);
    ck_assert_double_lt(far_apart(found.centre, c.centre), 1e-3);
    for (int k = 0; k < 9; k++) ck_assert_double_eq_tol(found.rotation[k], c.rotation[k], 1e-7);
    ck_assert_double_lt(r.rms, 1e-5);
    ck_assert_int_eq(r.suspect, -1);
    ck_assert(r.left_out);
}

TEST(six_points_give_a_camera_with_one_distortion) {
    wcut_camera c = given();
    c.k2 = 0;
    wcut_photo_point p[6];
    wcut_camera found;
    wcut_camera_report r;
    const wcut_vec3 six[6] = {corner[0], corner[2], corner[5], corner[7], corner[9], corner[10]};
    see(&c, 6, six, p);
    ck_assert_int_eq(fit(6, p, &found, &r, NULL), WCUT_OK);
    ck_assert_int_eq(r.parameters, 8);
    ck_assert_double_eq_tol(found.focal, c.focal, 1e-2);
    ck_assert_double_eq_tol(found.k1, c.k1, 1e-5);
}

TEST(four_corners_of_a_face_give_pose_and_focal_length) {
    wcut_camera c = given();
    c.k1 = c.k2 = 0;
    wcut_photo_point p[4];
    wcut_camera found;
    wcut_camera_report r;
    see(&c, 4, corner + 4, p);
    ck_assert_int_eq(fit(4, p, &found, &r, NULL), WCUT_OK);
    ck_assert_int_eq(found.kind, WCUT_CAMERA_KIND_PINHOLE);
    ck_assert_double_eq_tol(found.focal, c.focal, 1e-2);
    ck_assert_double_lt(far_apart(found.centre, c.centre), 1e-2);
    ck_assert(!r.left_out || r.parameters == 7);

    /* places off the plane too */
    double pixel[2], depth;
    const wcut_photo_point truth = seen_by(&c, (wcut_vec3){100, 200, 250});
    ck_assert_int_eq(wcut_camera_project(&found, 1, &truth.place, pixel, &depth), WCUT_OK);
    ck_assert_double_eq_tol(pixel[0], truth.u, 1e-2);
    ck_assert_double_eq_tol(pixel[1], truth.v, 1e-2);
    ck_assert_double_gt(depth, 0);
}

TEST(a_plane_seen_straight_on_is_a_homography) {
    const wcut_camera c = camera_at((wcut_vec3){200, 449, 1500}, (wcut_vec3){200, 450, 300}, 2000, WIDTH, HEIGHT, 0, 0);
    const wcut_vec3 five[5] = {corner[4], corner[5], corner[6], corner[7], {150, 300, 300}};
    wcut_photo_point p[5];
    wcut_camera found;
    wcut_camera_report r;
    see(&c, 5, five, p);
    for (int k = 0; k < 5; k++) p[k].u += k % 2 ? 0.2 : -0.2;
    ck_assert_int_eq(fit(5, p, &found, &r, NULL), WCUT_OK);
    ck_assert_int_eq(found.kind, WCUT_CAMERA_KIND_PLANE);
    ck_assert_int_eq(r.parameters, 8);

    /* in the plane it is right */
    double pixel[2];
    const wcut_photo_point truth = seen_by(&c, (wcut_vec3){100, 200, 300});
    ck_assert_int_eq(wcut_camera_project(&found, 1, &truth.place, pixel, NULL), WCUT_OK);
    ck_assert_double_eq_tol(pixel[0], truth.u, 0.5);
    ck_assert_double_eq_tol(pixel[1], truth.v, 0.5);
}

TEST(the_focal_length_is_within_its_interval_under_noise) {
    const wcut_camera c = given();
    int within = 0;
    unsigned seed = 7;
    for (int trial = 0; trial < 100; trial++) {
        wcut_photo_point p[ALL];
        wcut_camera found;
        wcut_camera_report r;
        see(&c, ALL, corner, p);

        /* sums of twelve uniform numbers are nearly normal, variance 1; 0.4 px */
        for (int k = 0; k < 2 * ALL; k++) {
            double sum = -6;
            for (int i = 0; i < 12; i++) {
                seed = seed * 1664525u + 1013904223u;
                sum += seed / 4294967296.0;
            }
            *(k % 2 ? &p[k / 2].v : &p[k / 2].u) += 0.4 * sum;
        }
        ck_assert_int_eq(fit(ALL, p, &found, &r, NULL), WCUT_OK);
        within += fabs(found.focal - c.focal) < 2.1 * r.focal_sigma;
    }
    ck_assert_int_ge(within, 88); /* 95 of 100; 15 degrees of freedom */
}

TEST(a_mistyped_point_is_named) {
    const wcut_camera c = given();
    wcut_photo_point p[ALL];
    wcut_camera found = {0};
    wcut_camera_report r;
    wcut_error error = {0};
    double left_out[ALL];
    see(&c, ALL, corner, p);
    p[4].u += 9; /* a slip that the limit lets through */
    ck_assert_int_eq(wcut_camera_fit(ALL, p, WIDTH, HEIGHT, NULL, &found, &r, NULL, left_out, NULL), WCUT_OK);
    ck_assert_int_eq(r.suspect, 4);
    ck_assert_double_gt(left_out[4], 8);

    /* one that it does not */
    p[4].u += 200;
    ck_assert_int_eq(fit(ALL, p, &found, &r, &error), WCUT_NOT_CONVERGED);
    ck_assert_ptr_nonnull(strstr(error.text, "point 5"));

    /* two rows interchanged */
    see(&c, ALL, corner, p);
    p[0].place = corner[6], p[6].place = corner[0];
    ck_assert_int_eq(fit(ALL, p, &found, &r, &error), WCUT_NOT_CONVERGED);
}

/* a refusal with a word in its text, outputs untouched */
static void refused(int count, const wcut_photo_point *p, wcut_status status, const char *word) {
    wcut_camera found = {.focal = 999};
    wcut_error error = {0};
    ck_assert_int_eq(fit(count, p, &found, NULL, &error), status);
    ck_assert_msg(strstr(error.text, word) != NULL, "\"%s\" without \"%s\"", error.text, word);
    ck_assert_double_eq(found.focal, 999);
}

TEST(degenerate_points_are_refused_by_name) {
    const wcut_camera c = given();
    wcut_photo_point p[ALL];

    /* on a line, in a plane, off it, two at one place */
    for (int k = 0; k < 8; k++) p[k] = seen_by(&c, (wcut_vec3){40.0 * k, 90.0 * k, 20.0 * k});
    refused(8, p, WCUT_DEGENERATE, "line");
    for (int k = 0; k < 8; k++) p[k] = seen_by(&c, (wcut_vec3){40.0 * k, 11.0 * k * k, 100});
    refused(8, p, WCUT_DEGENERATE, "plane");
    see(&c, 5, corner + 2, p);
    refused(5, p, WCUT_DEGENERATE, "off a plane");
    see(&c, ALL, corner, p);
    p[7] = p[3];
    refused(ALL, p, WCUT_DEGENERATE, "rows 4 and 8");

    /* a mirror image */
    see(&c, ALL, corner, p);
    for (int k = 0; k < ALL; k++) p[k].u = WIDTH - 1 - p[k].u;
    refused(ALL, p, WCUT_DEGENERATE, "mirror");

    /* outside the picture; too few */
    see(&c, ALL, corner, p);
    p[2].v = HEIGHT;
    refused(ALL, p, WCUT_BAD_ARGUMENT, "point 3");
    refused(3, p, WCUT_BAD_ARGUMENT, "4 to");
}

TEST(places_that_cannot_be_seen_have_no_depth) {
    wcut_camera c = given();
    const wcut_vec3 behind = {300, -900, 2800};
    double pixel[2] = {999, 999}, depth = 999;
    ck_assert_int_eq(wcut_camera_project(&c, 1, &behind, pixel, &depth), WCUT_OK);
    ck_assert_double_eq(depth, 0);

    /* far beside the picture a negative k1 would bring it back */
    c.k1 = -0.3, c.k2 = 0;
    const wcut_vec3 beside = {9000, 450, 150};
    ck_assert_int_eq(wcut_camera_project(&c, 1, &beside, pixel, &depth), WCUT_OK);
    ck_assert_double_eq(depth, 0);
}

TEST(a_failed_allocation_leaves_no_camera) {
    const wcut_camera c = given();
    wcut_photo_point p[ALL];
    wcut_camera found = {.focal = 999};
    see(&c, ALL, corner, p);
    EACH_FAILED_ALLOCATION(fit(ALL, p, &found, NULL, NULL), found.focal == 999);
    ck_assert_int_eq(fit(ALL, p, &found, NULL, NULL), WCUT_OK);
}
