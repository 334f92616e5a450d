/* B-spline basis functions and their derivatives (de Boor 1972, Cox 1972). */
#include "surface/basis.h"

#include "base/numbers.h"

bool wcut_knots_are_valid(int degree, int count, const double *knots) {
    if (!all_finite(count + degree + 1, knots)) return false;
    for (int i = 0; i < count + degree; i++)
        if (knots[i] > knots[i + 1]) return false;
    for (int i = 1; i < count; i++)
        if (!(knots[i] < knots[i + degree])) return false;
    return knots[degree] < knots[count] && isfinite(knots[count] - knots[degree]);
}

int wcut_basis_span(int degree, int count, const double *knots, double u) {
    int low = degree, high = count;
    if (u >= knots[high]) { /* the domain is closed: the last span that is not empty */
        while (knots[high - 1] >= knots[count]) high--;
        return high - 1;
    }
    /* knots are mostly even: look where u would be */
    const double share = (u - knots[low]) / (knots[high] - knots[low]);
    int guess = low + (int)(share * (high - low));
    if (guess >= high) guess = high - 1;
    for (int tries = 0; tries < 3; tries++) {
        if (knots[guess] > u) {
            high = guess--;
        } else if (knots[guess + 1] <= u) {
            low = ++guess;
        } else {
            return guess;
        }
    }

    /* bisection, where the knots are uneven */
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (knots[middle] > u) {
            high = middle;
        } else {
            low = middle;
        }
    }

    return low;
}

/* what the recurrences need of the span whose knots are t[0] <= u < t[1]: 1 / (t[r + 1] - t[r + 1 - q]) */
typedef struct triangle {
    double value[WCUT_BASIS_SIZE][WCUT_BASIS_SIZE]; /* [q][r]: the functions of degree q */
    double inverse[WCUT_BASIS_SIZE][WCUT_BASIS_SIZE];
} triangle;

/* the functions of every degree up to `degree`, each from the one below */
static inline void raise_degrees(int degree, const double *t, double u, triangle *n) {
    n->value[0][0] = 1;
    for (int q = 1; q <= degree; q++) {
        double saved = 0;
        for (int r = 0; r < q; r++) {
            const double inverse = 1 / (t[r + 1] - t[r + 1 - q]), share = n->value[q - 1][r] * inverse;
            n->inverse[q][r] = inverse;
            n->value[q][r] = saved + (t[r + 1] - u) * share;
            saved = (u - t[r + 1 - q]) * share;
        }
        n->value[q][q] = saved;
    }
}

/* d/du: N'_{i,q} = q (N_{i,q-1} / (t_{i+q} - t_i) - N_{i+1,q-1} / (t_{i+q+1} - t_{i+1})), in place */
static inline void differentiate(int q, const double *inverse, double *value) {
    double saved = 0;
    for (int r = 0; r < q; r++) {
        const double share = q * value[r] * inverse[r];
        value[r] = saved - share;
        saved = share;
    }
    value[q] = saved;
}

/* with the degree known to the compiler the loops unroll */
static inline void fill_basis(int degree, const double *t, double u, int order, wcut_basis *basis) {
    triangle n;
    raise_degrees(degree, t, u, &n);
    for (int r = 0; r <= degree; r++) basis->value[0][r] = n.value[degree][r];
    for (int k = 1; k <= order; k++) { /* the functions of degree - k, differentiated k times */
        for (int r = 0; r <= degree; r++)
            basis->value[k][r] = k <= degree && r <= degree - k ? n.value[degree - k][r] : 0;
        for (int q = degree - k + 1; k <= degree && q <= degree; q++) differentiate(q, n.inverse[q], basis->value[k]);
    }
}

void wcut_basis_eval(int degree, int count, const double *knots, double u, int order, wcut_basis *basis) {
    u = clamp(u, knots[degree], knots[count]);
    basis->span = wcut_basis_span(degree, count, knots, u);
    const double *t = knots + basis->span;
    if (degree == 3) {
        fill_basis(3, t, u, order, basis);
    } else {
        fill_basis(degree, t, u, order, basis);
    }
}

int wcut_basis_cubic(int count, const double *knots, double u, double value[4]) {
    u = clamp(u, knots[3], knots[count]);
    const int span = wcut_basis_span(3, count, knots, u);
    const double *t = knots + span;
    const double low[3] = {u - t[0], u - t[-1], u - t[-2]}, high[3] = {t[1] - u, t[2] - u, t[3] - u};
    const double one = 1 / (t[1] - t[0]), a = high[0] * one, b = low[0] * one;
    const double a2 = a * (1 / (t[1] - t[-1])), b2 = b * (1 / (t[2] - t[0]));
    const double n0 = high[0] * a2, n1 = low[1] * a2 + high[1] * b2, n2 = low[0] * b2;
    const double m0 = n0 * (1 / (t[1] - t[-2])), m1 = n1 * (1 / (t[2] - t[-1])), m2 = n2 * (1 / (t[3] - t[0]));
    value[0] = high[0] * m0;
    value[1] = low[2] * m0 + high[1] * m1;
    value[2] = low[1] * m1 + high[2] * m2;
    value[3] = low[0] * m2;
    return span;
}
