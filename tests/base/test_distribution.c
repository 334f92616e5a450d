/* Tails and quantiles against scipy's and mpmath's, and against each other. labels: unit oracle */
#include <math.h>

#include "base/distribution.h"
#include "base/distribution_table.h"
#include "test.h"

#define COUNT(table) ((int)(sizeof(table) / sizeof(table)[0]))

/* relative, so that small tails count as much as large ones */
static void expect(double found, double wanted, double tolerance, double x, double dof) {
    double off = wanted == 0 ? fabs(found) : fabs(found / wanted - 1);
    ck_assert_msg(off <= tolerance, "at %.17g (%g): %.17g, expected %.17g, off by %.1e", x, dof, found, wanted, off);
}

TEST(the_normal_distribution_agrees_with_scipy) {
    for (int i = 0; i < COUNT(normal_tail); i++)
        expect(wcut_gaussian_tail(normal_tail[i][0]), normal_tail[i][1], 1e-12, normal_tail[i][0], 0);
    for (int i = 0; i < COUNT(normal_quantile); i++)
        expect(wcut_gaussian_quantile(normal_quantile[i][0]), normal_quantile[i][1], 1e-12, normal_quantile[i][0], 0);
}

TEST(student_t_agrees_with_scipy) {
    for (int i = 0; i < COUNT(student_tail); i++) {
        const double *row = student_tail[i];
        expect(wcut_student_tail(row[0], row[1]), row[2], 1e-11, row[0], row[1]);
    }
    for (int i = 0; i < COUNT(student_quantile); i++) {
        const double *row = student_quantile[i];
        expect(wcut_student_quantile(row[0], row[1]), row[2], 1e-11, row[0], row[1]);
    }
}

TEST(chi_square_agrees_with_scipy) {
    for (int i = 0; i < COUNT(chi_square_tail); i++) {
        const double *row = chi_square_tail[i];
        expect(wcut_chi_square_tail(row[0], row[1]), row[2], 1e-11, row[0], row[1]);
    }
    for (int i = 0; i < COUNT(chi_square_quantile); i++) {
        const double *row = chi_square_quantile[i];
        expect(wcut_chi_square_quantile(row[0], row[1]), row[2], 1e-11, row[0], row[1]);
    }
}

TEST(f_agrees_with_scipy) {
    for (int i = 0; i < COUNT(f_tail); i++) {
        const double *row = f_tail[i];
        expect(wcut_f_tail(row[0], row[1], row[2]), row[3], 1e-11, row[0], row[1]);
    }
    for (int i = 0; i < COUNT(f_quantile); i++) {
        const double *row = f_quantile[i];
        expect(wcut_f_quantile(row[0], row[1], row[2]), row[3], 1e-11, row[0], row[1]);
    }
}

TEST(t_squared_is_f_with_one_degree) {
    for (double t = 0.1; t < 30; t *= 1.7)
        ck_assert_double_eq_tol(2 * wcut_student_tail(t, 9) / wcut_f_tail(t * t, 1, 9), 1, 1e-13);
}

TEST(one_degree_of_freedom_has_its_closed_form) {
    for (double p = 1e-14; p < 0.9; p *= 7) {
        double root = tan(acos(-1) * p / 2), t = -1 / tan(acos(-1) * p);
        ck_assert_double_eq_tol(wcut_student_quantile(p, 1), t, 1e-12 * (1 + fabs(t)));
        ck_assert_double_eq_tol(wcut_f_quantile(p, 1, 1) / (root * root), 1, 1e-12);
    }
}

TEST(a_quantile_undoes_its_tail) {
    for (double p = 0.001; p < 1; p += 0.0833) {
        ck_assert_double_eq_tol(wcut_student_tail(wcut_student_quantile(p, 4), 4), 1 - p, 1e-13);
        ck_assert_double_eq_tol(wcut_chi_square_tail(wcut_chi_square_quantile(p, 4), 4), 1 - p, 1e-13);
        ck_assert_double_eq_tol(wcut_f_tail(wcut_f_quantile(p, 4, 6), 4, 6), 1 - p, 1e-13);
        ck_assert_double_eq_tol(wcut_gaussian_tail(wcut_gaussian_quantile(p)), 1 - p, 1e-14);
    }
}

TEST(nothing_positive_lies_below_zero) {
    ck_assert(wcut_chi_square_tail(-1, 3) == 1 && wcut_chi_square_tail(0, 3) == 1);
    ck_assert(wcut_f_tail(-1, 3, 4) == 1 && wcut_f_tail(0, 3, 4) == 1);
}
