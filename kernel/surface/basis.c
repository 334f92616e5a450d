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

/* N_{.,q} from N_{.,q-1}: the functions of degree q over the span whose knots are t[0] <= u < t[1] */
static void raise_degree(int q, const double *t, double u, const double *lower, double *value) {
    double saved = 0;
    for (int r = 0; r < q; r++) {
        const double share = lower[r] / (t[r + 1] - t[r + 1 - q]);
        value[r] = saved + (t[r + 1] - u) * share;
        saved = (u - t[r + 1 - q]) * share;
    }
    value[q] = saved;
}

/* d/du: N'_{i,q} = q (N_{i,q-1} / (t_{i+q} - t_i) - N_{i+1,q-1} / (t_{i+q+1} - t_{i+1})), in place */
static void differentiate(int q, const double *t, double *value) {
    double saved = 0;
    for (int r = 0; r < q; r++) {
        const double share = q * value[r] / (t[r + 1] - t[r + 1 - q]);
        value[r] = saved - share;
        saved = share;
    }
    value[q] = saved;
}

void wcut_basis_eval(int degree, int count, const double *knots, double u, int order, wcut_basis *basis) {
    u = clamp(u, knots[degree], knots[count]);
    basis->span = wcut_basis_span(degree, count, knots, u);
    const double *t = knots + basis->span;
    double lower[2][WCUT_BASIS_SIZE] = {{1}};
    for (int q = 0;; q++) {
        const double *now = lower[q % 2];
        const int k = degree - q; /* N_{.,q} differentiated k times is the k-th derivative */
        if (k <= order) {
            for (int r = 0; r <= q; r++) basis->value[k][r] = now[r];
            for (int d = q + 1; d <= degree; d++) differentiate(d, t, basis->value[k]);
        }
        if (q == degree) break;
        raise_degree(q + 1, t, u, now, lower[(q + 1) % 2]);
    }
    for (int k = degree + 1; k <= order; k++)
        for (int r = 0; r <= degree; r++) basis->value[k][r] = 0;
}
