/* wcut_surface_curvature on surfaces whose curvature is known: plane, cylinder, sphere, saddle. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <wirecut/curvature.h>

#define R 37.0
static double bezier1[] = {0, 0, 1, 1}, bezier2[] = {0, 0, 0, 1, 1, 1};

START_TEST(a_quarter_cylinder_bends_by_one_over_its_radius) {
    /* rational quadratic arc along u, straight along v */
    const double c = sqrt(0.5);
    wcut_vec3 control[] = {{R, 0, 0}, {R, R, 0}, {0, R, 0}, {R, 0, 90}, {R, R, 90}, {0, R, 90}};
    double weights[] = {1, c, 1, 1, c, 1};
    const wcut_surface surface = {2, 1, 3, 2, bezier2, bezier1, control, weights};
    for (double u = 0; u <= 1; u += 0.1) {
        double larger = 999, smaller = 999;
        ck_assert_int_eq(wcut_surface_curvature(&surface, u, 0.3, &larger, &smaller), WCUT_OK);
        /* S_u x S_v points outward, away from the axis it bends towards */
        ck_assert_double_eq_tol(larger, -1 / R, 1e-14);
        ck_assert_double_eq_tol(smaller, 0, 1e-14);
    }
}
END_TEST

START_TEST(a_sphere_bends_alike_in_every_direction_and_has_no_curvature_formula_at_its_pole) {
    /* an octant: equator along u, meridians along v, pole at v = 1 */
    const double c = sqrt(0.5);
    wcut_vec3 control[] = {{R, 0, 0}, {R, R, 0}, {0, R, 0}, {R, 0, R}, {R, R, R},
                           {0, R, R}, {0, 0, R}, {0, 0, R}, {0, 0, R}};
    double weights[] = {1, c, 1, c, 0.5, c, 1, c, 1};
    const wcut_surface surface = {2, 2, 3, 3, bezier2, bezier2, control, weights};
    double larger = 999, smaller = 999;
    for (double v = 0; v < 0.95; v += 0.1) {
        ck_assert_int_eq(wcut_surface_curvature(&surface, 0.37, v, &larger, &smaller), WCUT_OK);
        ck_assert_double_eq_tol(larger, -1 / R, 1e-9);
        ck_assert_double_eq_tol(smaller, -1 / R, 1e-9);
    }
    larger = 999;
    ck_assert_int_eq(wcut_surface_curvature(&surface, 0.37, 1, &larger, NULL), WCUT_DEGENERATE);
    ck_assert_double_eq(larger, 999);
}
END_TEST

START_TEST(a_saddle_has_both_signs_and_the_larger_size_first) {
    /* z = (a x^2 - b y^2) / 2 over [-1, 1]^2 at its middle: curvatures a and -b */
    const double a = 0.02, b = 0.05;
    wcut_vec3 control[9];
    const double square[] = {1, -1, 1}, line[] = {-1, 0, 1};
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++)
            control[3 * j + i] = (wcut_vec3){line[i], line[j], (a * square[i] - b * square[j]) / 2};
    const wcut_surface surface = {2, 2, 3, 3, bezier2, bezier2, control, NULL};
    double larger = 999, smaller = 999;
    ck_assert_int_eq(wcut_surface_curvature(&surface, 0.5, 0.5, &larger, &smaller), WCUT_OK);
    ck_assert_double_eq_tol(larger, -b, 1e-15);
    ck_assert_double_eq_tol(smaller, a, 1e-15);
}
END_TEST

START_TEST(a_plane_is_flat_and_bad_arguments_are_refused) {
    wcut_vec3 control[] = {{0, 0, 0}, {5, 0, 1}, {0, 7, 0}, {5, 7, 1}};
    const wcut_surface surface = {1, 1, 2, 2, bezier1, bezier1, control, NULL};
    double larger = 999;
    ck_assert_int_eq(wcut_surface_curvature(&surface, 0.2, 0.8, &larger, NULL), WCUT_OK);
    ck_assert_double_eq(larger, 0);
    larger = 999;
    ck_assert_int_eq(wcut_surface_curvature(NULL, 0.2, 0.8, &larger, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_curvature(&surface, NAN, 0.8, &larger, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_curvature(&surface, 0.2, 0.8, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_double_eq(larger, 999);
}
END_TEST

int main(void) {
    Suite *suite = suite_create("curvature");
    TCase *tcase = tcase_create("known");
    tcase_add_test(tcase, a_quarter_cylinder_bends_by_one_over_its_radius);
    tcase_add_test(tcase, a_sphere_bends_alike_in_every_direction_and_has_no_curvature_formula_at_its_pole);
    tcase_add_test(tcase, a_saddle_has_both_signs_and_the_larger_size_first);
    tcase_add_test(tcase, a_plane_is_flat_and_bad_arguments_are_refused);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
