/* Tails and quantiles of the normal, Student t, chi-square and F distributions. */
#ifndef WCUT_BASE_DISTRIBUTION_H
#define WCUT_BASE_DISTRIBUTION_H

/* All take finite arguments and positive degrees of freedom, probabilities in the open (0, 1): checked by assert, for
   the callers are ours. Relative error below 1e-11 for up to 1e6 degrees of freedom. */

/* P(Z > z) */
double wcut_gaussian_tail(double z);

/* z with P(Z <= z) = p */
double wcut_gaussian_quantile(double p);

/* P(T > t) */
double wcut_student_tail(double t, double dof);

/* t with P(T <= t) = p */
double wcut_student_quantile(double p, double dof);

/* P(X > x); 1 for x <= 0 */
double wcut_chi_square_tail(double x, double dof);

/* x with P(X <= x) = p */
double wcut_chi_square_quantile(double p, double dof);

/* P(X > x); 1 for x <= 0 */
double wcut_f_tail(double x, double dof1, double dof2);

/* x with P(X <= x) = p */
double wcut_f_quantile(double p, double dof1, double dof2);

#endif
