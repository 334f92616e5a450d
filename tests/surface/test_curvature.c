/* wcut_surface_curvature on surfaces whose curvature is known: plane, cylinder, sphere, saddle. */
#include <math.h>
#include <wirecut/curvature.h>

#include "surface/shapes.h"
#include "test.h"

#define R 37.0
static double bezier1[] = {0, 0, 1, 1}, bezier2[] = {0, 0, 0, 1, 1, 1};

TEST(a_quarter_cylinder_bends_by_one_over_its_radius) {
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

TEST(a_sphere_bends_alike_in_every_direction_and_has_no_curvature_formula_at_its_pole) {
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

TEST(a_saddle_has_both_signs_and_the_larger_size_first) {
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

TEST(a_plane_is_flat_and_bad_arguments_are_refused) {
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

TEST(a_torus_has_its_principal_directions_and_its_gaussian_and_mean_curvature) {
    const double a = 50, b = 20;
    wcut_surface *s = shape_torus(a, b);
    for (double u = 0.03; u < 1; u += 0.11)
        for (double v = 0.02; v < 1; v += 0.13) {
            wcut_tangent_frame f = {.gauss = 999};
            ck_assert_int_eq(wcut_surface_frame(s, u, v, &f), WCUT_OK);
            const double rho = hypot(f.point.x, f.point.y), c = (rho - a) / b; /* cos of the angle around the tube */
            const wcut_vec3 out = vec3(c * f.point.x / rho, c * f.point.y / rho, f.point.z / b);
            const double side = vec3_dot(out, f.normal);
            ck_assert_double_eq_tol(fabs(side), 1, 1e-12);
            ck_assert_double_eq_tol(f.gauss, c / (b * rho), 1e-12);
            ck_assert_double_eq_tol(f.mean, -side * (1 / b + c / rho) / 2, 1e-12);
            ck_assert_double_eq_tol(f.larger * f.smaller, f.gauss, 1e-14);
            ck_assert_double_eq_tol(f.larger + f.smaller, 2 * f.mean, 1e-14);
            ck_assert_double_eq_tol(fabs(f.larger), 1 / b, 1e-12); /* the tube bends more than the ring */
            const wcut_vec3 ring = vec3(-f.point.y / rho, f.point.x / rho, 0);
            ck_assert_double_le(fabs(vec3_dot(f.along, ring)), 1e-9);
            ck_assert_double_eq_tol(fabs(vec3_dot(f.across, ring)), 1, 1e-12);
            ck_assert_double_le(apart(vec3_cross(f.along, f.across), f.normal), 1e-12);
            wcut_vec3 n = {999, 0, 0};
            ck_assert_int_eq(wcut_surface_normal(s, u, v, &n), WCUT_OK);
            ck_assert_double_le(apart(n, f.normal), 0);
        }
    wcut_surface_destroy(s);
}

TEST(a_normal_where_there_is_none_is_refused) {
    wcut_surface *s = shape_octant();
    wcut_tangent_frame f = {.gauss = 999};
    wcut_vec3 n = {999, 0, 0};
    ck_assert_int_eq(wcut_surface_normal(s, 0.5, 1, &n), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_surface_frame(s, 0.5, 1, &f), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_surface_normal(NULL, 0.5, 0, &n), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_normal(s, 0.5, 0, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_frame(s, INFINITY, 0, &f), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_frame(s, 0, 0, NULL), WCUT_BAD_ARGUMENT);
    ck_assert(n.x == 999 && f.gauss == 999);
    ck_assert_int_eq(wcut_surface_frame(s, 0.3, 0.4, &f), WCUT_OK); /* umbilic everywhere: along S_u */
    wcut_vec3 d[4];
    ck_assert_int_eq(wcut_surface_eval(s, 0.3, 0.4, 1, d), WCUT_OK);
    ck_assert_double_eq_tol(fabs(f.larger), 1, 1e-7);
    ck_assert_double_eq_tol(vec3_length(f.along), 1, 1e-12);
    wcut_surface_destroy(s);
}
