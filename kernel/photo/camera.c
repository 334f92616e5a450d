/* Perspective with radial distortion (Brown 1971). */
#include "photo/camera.h"

#include <stddef.h>

#include "base/numbers.h"

/* the image of the foot of a place in the plane */
static wcut_pixel plane_pixel(const wcut_camera *c, wcut_vec3 place) {
    const double *h = c->homography;
    const wcut_vec3 d = vec3_sub(place, c->plane);
    const double x = vec3_dot(d, c->plane_x), y = vec3_dot(d, c->plane_y);
    const double w = h[6] * x + h[7] * y + h[8];
    if (!(w > 0)) return (wcut_pixel){0, 0, 0};
    return (wcut_pixel){(h[0] * x + h[1] * y + h[2]) / w, (h[3] * x + h[4] * y + h[5]) / w, w};
}

wcut_pixel wcut_camera_pixel(const wcut_camera *c, wcut_vec3 place) {
    if (c->kind == WCUT_CAMERA_KIND_PLANE) return plane_pixel(c, place);

    /* into the camera's frame */
    const double *r = c->rotation;
    const wcut_vec3 d = vec3_sub(place, c->centre);
    const double x = r[0] * d.x + r[1] * d.y + r[2] * d.z, y = r[3] * d.x + r[4] * d.y + r[5] * d.z,
                 z = r[6] * d.x + r[7] * d.y + r[8] * d.z;
    if (!(z > 0)) return (wcut_pixel){0, 0, 0};

    /* beyond the largest r(1 + k1 r^2 + k2 r^4) a place would come back into the picture */
    const double m = x / z, n = y / z, r2 = m * m + n * n;
    const double slope = 1 + r2 * (3 * c->k1 + 5 * c->k2 * r2);
    if (!(slope > 0)) return (wcut_pixel){0, 0, 0};

    const double stretch = c->focal * (1 + r2 * (c->k1 + c->k2 * r2));
    return (wcut_pixel){(c->width - 1) / 2.0 + stretch * m, (c->height - 1) / 2.0 + stretch * n, z};
}

/* R from a rotation vector about the camera's axes (Rodrigues 1840), times the camera's own */
static void turn_rotation(const double w[3], const double from[9], double to[9]) {
    /* sin(a) / a and (1 - cos(a)) / a^2 near a = 0 are their series */
    const double a2 = w[0] * w[0] + w[1] * w[1] + w[2] * w[2], a = sqrt(a2);
    const double s = a > 1e-8 ? sin(a) / a : 1 - a2 / 6, c = a > 1e-4 ? (1 - cos(a)) / a2 : 0.5 - a2 / 24;
    const double k[9] = {0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0};
    double e[9];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) e[3 * i + j] = (i == j) * (1 - c * a2) + s * k[3 * i + j] + c * w[i] * w[j];

    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++)
            to[3 * i + j] = e[3 * i] * from[j] + e[3 * i + 1] * from[3 + j] + e[3 * i + 2] * from[6 + j];
}

/* R^T v */
static wcut_vec3 turned_back(const double r[9], const double v[3]) {
    return vec3(r[0] * v[0] + r[3] * v[1] + r[6] * v[2], r[1] * v[0] + r[4] * v[1] + r[7] * v[2],
                r[2] * v[0] + r[5] * v[1] + r[8] * v[2]);
}

wcut_camera wcut_camera_moved(const wcut_camera *c, const double step[WCUT_CAMERA_PARAMETERS]) {
    wcut_camera moved = *c;
    const double *r = c->rotation;
    const double t[3] = {-(r[0] * c->centre.x + r[1] * c->centre.y + r[2] * c->centre.z) + step[3],
                         -(r[3] * c->centre.x + r[4] * c->centre.y + r[5] * c->centre.z) + step[4],
                         -(r[6] * c->centre.x + r[7] * c->centre.y + r[8] * c->centre.z) + step[5]};
    const double back[3] = {-t[0], -t[1], -t[2]};

    turn_rotation(step, c->rotation, moved.rotation);
    moved.centre = turned_back(moved.rotation, back);
    moved.focal = c->focal * exp(step[6]);
    moved.k1 = c->k1 + step[7];
    moved.k2 = c->k2 + step[8];
    return moved;
}

static bool camera_is_sound(const wcut_camera *c) {
    if (c->kind < WCUT_CAMERA_KIND_PLANE || c->kind > WCUT_CAMERA_KIND_FULL || c->width < 2 || c->height < 2)
        return false;
    if (c->kind == WCUT_CAMERA_KIND_PLANE)
        return all_finite(9, c->homography) && vec3_is_finite(c->plane) && vec3_is_finite(c->plane_x) &&
               vec3_is_finite(c->plane_y);
    return all_finite(9, c->rotation) && vec3_is_finite(c->centre) && is_positive(c->focal) && isfinite(c->k1) &&
           isfinite(c->k2);
}

wcut_status wcut_camera_project(const wcut_camera *camera, int count, const wcut_vec3 *place, double *pixel,
                                double *depth) {
    if (!camera || count < 0 || !place || !pixel || !camera_is_sound(camera) || !vec3_all_finite(count, place))
        return WCUT_BAD_ARGUMENT;

    for (size_t i = 0; i < (size_t)count; i++) {
        const wcut_pixel p = wcut_camera_pixel(camera, place[i]);
        pixel[2 * i] = p.u;
        pixel[2 * i + 1] = p.v;
        if (depth) depth[i] = p.depth;
    }
    return WCUT_OK;
}
