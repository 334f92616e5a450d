/* labels: oracle property
   Derivatives of rational surfaces of every degree against the complex step (Squire, Trapp 1998) in extended precision,
   on a second evaluation that has nothing in common with the library's. */
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

typedef long double complex number;

/* N_{i,p}(t) by its definition, the span that of the real part */
static number basis(const double *knots, int i, int p, int span, number t) {
    if (p == 0) return i == span ? 1 : 0;
    number sum = 0;
    if (knots[i + p] > knots[i])
        sum += (t - knots[i]) / ((long double)knots[i + p] - knots[i]) * basis(knots, i, p - 1, span, t);
    if (knots[i + p + 1] > knots[i + 1])
        sum += (knots[i + p + 1] - t) / ((long double)knots[i + p + 1] - knots[i + 1]) *
               basis(knots, i + 1, p - 1, span, t);
    return sum;
}

static int span_of(const double *knots, int degree, int count, double t) {
    int span = degree;
    while (span + 1 < count && knots[span + 1] <= t) span++;
    return span;
}

/* a coordinate of the surface at complex parameters near (u, v) */
static number evaluate(const wcut_surface *s, double u, double v, number at_u, number at_v, int axis) {
    const int p = s->degree_u, q = s->degree_v, su = span_of(s->knots_u, p, s->count_u, u),
              sv = span_of(s->knots_v, q, s->count_v, v);
    number top = 0, bottom = 0;
    for (int j = sv - q; j <= sv; j++)
        for (int i = su - p; i <= su; i++) {
            const int k = j * s->count_u + i;
            const number n = basis(s->knots_u, i, p, su, at_u) * basis(s->knots_v, j, q, sv, at_v) *
                             (s->weights ? (long double)s->weights[k] : 1);
            top += n * (&s->control[k].x)[axis];
            bottom += n;
        }
    return top / bottom;
}

static wcut_surface *random_surface(wcut_random *random, int p, int q, bool rational) {
    enum { MAX = 12 };
    double ku[MAX + 8] = {0}, kv[MAX + 8] = {0}, w[MAX * MAX];
    wcut_vec3 c[MAX * MAX];
    const int m = p + 1 + wcut_random_below(random, MAX - p), n = q + 1 + wcut_random_below(random, MAX - q);
    for (int k = 0; k < m + p + 1; k++)
        ku[k] = k <= p ? 0 : k >= m ? 1 : (k - p + 0.6 * wcut_random_uniform(random)) / (m - p);
    for (int k = 0; k < n + q + 1; k++)
        kv[k] = k <= q ? 0 : k >= n ? 1 : (k - q + 0.6 * wcut_random_uniform(random)) / (n - q);
    for (int k = 0; k < m * n; k++) {
        c[k] = vec3(wcut_random_normal(random), wcut_random_normal(random), wcut_random_normal(random));
        w[k] = 0.5 + wcut_random_uniform(random);
    }
    for (int k = p + 1; k < m; k++) ku[k] = fmin(fmax(ku[k], ku[k - 1]), 1);
    for (int k = q + 1; k < n; k++) kv[k] = fmin(fmax(kv[k], kv[k - 1]), 1);
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_create(p, q, m, n, ku, kv, c, rational ? w : NULL, &s), WCUT_OK);
    return s;
}

TEST(every_derivative_to_third_order_is_that_of_the_complex_step) {
    const long double h = 1e-4L, tiny = 1e-30L;
    wcut_random random = wcut_random_seed(81);
    for (int p = 1; p <= WCUT_DEGREE_MAX; p++)
        for (int q = 1; q <= WCUT_DEGREE_MAX; q += 2)
            for (int rational = 0; rational < 2; rational++) {
                wcut_surface *s = random_surface(&random, p, q, rational);
                const double u = 0.01 + 0.98 * wcut_random_uniform(&random),
                             v = 0.01 + 0.98 * wcut_random_uniform(&random);
                wcut_vec3 d[16];
                ck_assert_int_eq(wcut_surface_eval(s, u, v, 3, d), WCUT_OK);
                for (int axis = 0; axis < 3; axis++) {
                    double got[16];
                    for (int k = 0; k < 16; k++) got[k] = (&d[k].x)[axis];
                    const long double f = creall(evaluate(s, u, v, u, v, axis));
                    ck_assert_double_le(fabs(got[0] - (double)f), 1e-13);
                    for (int turned = 0; turned < 2; turned++) { /* d[4 k + l]: k along u, l along v */
                        const int one = turned ? 1 : 4, other = turned ? 4 : 1;
                        const number step = (turned ? v : u) + I * tiny, far = (turned ? v : u) + I * h;
                        const number near_f =
                            turned ? evaluate(s, u, v, u, step, axis) : evaluate(s, u, v, step, v, axis);
                        const number far_f = turned ? evaluate(s, u, v, u, far, axis) : evaluate(s, u, v, far, v, axis);
                        const long double first = cimagl(near_f) / tiny, second = 2 * (f - creall(far_f)) / (h * h);
                        const long double third = 6 * (first - cimagl(far_f) / h) / (h * h);
                        const double size = 1 + fabs(got[one]) + fabs(got[2 * one]) + fabs(got[3 * one]);
                        ck_assert_double_le(fabs(got[one] - (double)first), 1e-12 * size);
                        ck_assert_double_le(fabs(got[2 * one] - (double)second), 1e-4 * size);
                        ck_assert_double_le(fabs(got[3 * one] - (double)third), 1e-2 * size);
                        /* mixed: the same, at both sides across */
                        const long double k = 1e-6L;
                        number low, high;
                        if (turned) {
                            low = evaluate(s, u, v, u - k, step, axis), high = evaluate(s, u, v, u + k, step, axis);
                        } else {
                            low = evaluate(s, u, v, step, v - k, axis), high = evaluate(s, u, v, step, v + k, axis);
                        }
                        const long double mixed = (cimagl(high) - cimagl(low)) / (2 * k * tiny);
                        const long double mixed2 = (cimagl(high) - 2 * cimagl(near_f) + cimagl(low)) / (k * k * tiny);
                        const double wide = size + fabs(got[5]) + fabs(got[6]) + fabs(got[9]) + fabs(got[other]);
                        ck_assert_double_le(fabs(got[5] - (double)mixed), 1e-7 * wide);
                        ck_assert_double_le(fabs(got[one + 2 * other] - (double)mixed2), 1e-4 * wide);
                    }
                }
                wcut_surface_destroy(s);
            }
}
