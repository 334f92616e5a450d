/* A chain of nodes: tangents, lengths, the angles at its mounts. */
#include "wire/chain.h"

#include "base/vec3.h"

wcut_vec3 wcut_chain_tangent(int n, const wcut_vec3 *x, int i) {
    const int before = i > 0 ? i - 1 : 0, after = i < n - 1 ? i + 1 : n - 1;
    return vec3_unit(vec3_sub(x[after], x[before]));
}

double wcut_chain_length(int n, const wcut_vec3 *x) {
    double length = 0;
    for (int e = 0; e < n - 1; e++) length += vec3_distance(x[e], x[e + 1]);
    return length;
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
