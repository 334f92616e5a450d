/* A chain of nodes: its end tangents, the angles at its mounts. */
#include "wire/chain.h"

#include "base/vec3.h"

wcut_vec3 wcut_chain_outward(wcut_vec3 end, wcut_vec3 next, wcut_vec3 second, double *scale) {
    const wcut_vec3 difference = vec3_add_scaled(vec3_add_scaled(vec3_scale(3, end), -4, next), 1, second);
    *scale = 1 / vec3_length(difference);
    return vec3_scale(*scale, difference);
}

/* the wire leaves the mount along d; at rest along side * x */
static void angles_of(wcut_vec3 d, double side, double *alpha, double *beta) {
    const double u = side * d.x;
    *alpha = atan2(-d.y, u);
    *beta = atan2(d.z, hypot(u, d.y));
}

void wcut_chain_angles(int n, const wcut_vec3 *x, double *alpha_a, double *beta_a, double *alpha_b, double *beta_b) {
    angles_of(vec3_sub(x[1], x[0]), 1, alpha_a, beta_a);
    angles_of(vec3_sub(x[n - 2], x[n - 1]), -1, alpha_b, beta_b);
}
