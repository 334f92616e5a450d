/* A rigid motion in six numbers: a shift and a rotation vector about a pivot (Rodrigues 1840). */
#include "scan/register_motion.h"

#include "base/numbers.h"

/* below this angle [rad] the series is exact to rounding */
static const double SMALL = 1e-4;

/* I + a [w]x + b [w]x^2 */
static mat3 register_motion_combine(wcut_vec3 w, double a, double b) {
    const mat3 cross = {{0, -a * w.z, a * w.y}, {a * w.z, 0, -a * w.x}, {-a * w.y, a * w.x, 0}};
    /* [w]x^2 = w w^T - |w|^2 I */
    return mat3_add_identity(mat3_add_outer(cross, vec3_scale(b, w), w), 1 - b * vec3_dot(w, w));
}

wcut_motion wcut_motion_of(wcut_vec3 pivot, const double *x) {
    wcut_motion m = {.pivot = pivot};
    for (int k = 0; k < WCUT_DOF_COUNT; k++) m.x[k] = x[k];
    const wcut_vec3 w = vec3(x[WCUT_DOF_RX], x[WCUT_DOF_RY], x[WCUT_DOF_RZ]);
    const double angle = vec3_length(w);
    if (angle < SMALL) {
        m.rotation = register_motion_combine(w, 1 - angle * angle / 6, 0.5 - angle * angle / 24);
    } else {
        const double half = sin(angle / 2) / angle;
        m.rotation = register_motion_combine(w, sin(angle) / angle, 2 * half * half);
    }
    return m;
}

mat3 wcut_motion_jacobian(const double *w) {
    const wcut_vec3 v = vec3(w[0], w[1], w[2]);
    const double angle = vec3_length(v);
    if (angle < SMALL) return register_motion_combine(v, 0.5 - angle * angle / 24, 1.0 / 6 - angle * angle / 120);
    return register_motion_combine(v, (1 - cos(angle)) / (angle * angle),
                                   (angle - sin(angle)) / (angle * angle * angle));
}

/* the quaternion (w; v) of a rotation, from its largest component (Shepperd 1978); turned so that w >= 0 */
static void to_quaternion(mat3 r, double q[4]) {
    const double square[4] = {1 + r.x.x + r.y.y + r.z.z, 1 + r.x.x - r.y.y - r.z.z, 1 - r.x.x + r.y.y - r.z.z,
                              1 - r.x.x - r.y.y + r.z.z};
    const double row[4][4] = {{square[0], r.z.y - r.y.z, r.x.z - r.z.x, r.y.x - r.x.y},
                              {r.z.y - r.y.z, square[1], r.y.x + r.x.y, r.x.z + r.z.x},
                              {r.x.z - r.z.x, r.y.x + r.x.y, square[2], r.z.y + r.y.z},
                              {r.y.x - r.x.y, r.x.z + r.z.x, r.z.y + r.y.z, square[3]}};
    int max = 0;
    for (int k = 1; k < 4; k++)
        if (square[k] > square[max]) max = k;
    const double scale = (row[max][0] < 0 ? -0.5 : 0.5) / sqrt(square[max]);
    for (int k = 0; k < 4; k++) q[k] = scale * row[max][k];
}

wcut_motion wcut_motion_between(wcut_vec3 pivot, mat3 rotation, wcut_vec3 from, wcut_vec3 to) {
    double q[4];
    to_quaternion(rotation, q);
    const wcut_vec3 v = vec3(q[1], q[2], q[3]);
    const double sine = vec3_length(v), angle = 2 * atan2(sine, q[0]);
    const wcut_vec3 w = vec3_scale(sine > 1e-12 ? angle / sine : 2, v);
    /* R (p - from) + to = R (p - pivot) + pivot + t */
    const wcut_vec3 t = vec3_sub(vec3_add(mat3_times(rotation, vec3_sub(pivot, from)), to), pivot);
    return wcut_motion_of(pivot, (double[]){t.x, t.y, t.z, w.x, w.y, w.z});
}
