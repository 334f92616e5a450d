/* From homogeneous coordinates back to space: the quotient rule for rational derivatives.

   S = A / w, so A^(k,l) = sum C(k,i) C(l,j) w^(i,j) S^(k-i,l-j) (Leibniz), solved for S^(k,l) in rising order. */
#include "surface/rational.h"

#include "base/vec3.h"

static const double binomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};

static wcut_vec3 space_part(const wcut_homogeneous *h) { return vec3(h->x, h->y, h->z); }

void wcut_rational_curve(int order, bool rational, const wcut_homogeneous *sum, wcut_vec3 *ders) {
    for (int k = 0; k <= order; k++) {
        wcut_vec3 a = space_part(&sum[k]);
        if (rational) {
            for (int i = 1; i <= k; i++) a = vec3_add_scaled(a, -binomial[k][i] * sum[i].w, ders[k - i]);
            a = vec3_scale(1 / sum[0].w, a);
        }
        ders[k] = a;
    }
}

void wcut_rational_surface(int order, bool rational, const wcut_homogeneous *sum, wcut_vec3 *ders) {
    const int n = order + 1;
    for (int k = 0; k < n; k++)
        for (int l = 0; l < n; l++) {
            wcut_vec3 a = space_part(&sum[k * n + l]);
            if (rational && k + l <= order) {
                for (int i = 0; i <= k; i++)
                    for (int j = i == 0; j <= l; j++)
                        a = vec3_add_scaled(a, -binomial[k][i] * binomial[l][j] * sum[i * n + j].w,
                                            ders[(k - i) * n + l - j]);
                a = vec3_scale(1 / sum[0].w, a);
            }
            ders[k * n + l] = k + l <= order ? a : vec3(0, 0, 0);
        }
}
