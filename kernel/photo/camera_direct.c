/* Cameras by linear equations: the direct linear transformation (Abdel-Aziz, Karara 1971) and the homography of a plane,
   with coordinates about their means (Hartley 1997). Starts for the fit. */
#include "base/alloc.h"
#include "base/least_squares.h"
#include "base/numbers.h"
#include "base/symmetric.h"
#include "photo/camera.h"

/* ---- the extent of the places ---- */

void wcut_camera_points_measure(int count, const wcut_photo_point *point, int width, int height,
                                wcut_camera_points *points) {
    *points = (wcut_camera_points){.count = count, .point = point};
    points->middle[0] = (width - 1) / 2.0;
    points->middle[1] = (height - 1) / 2.0;
    points->scale_px = hypot(width, height) / 2;
    for (int i = 0; i < count; i++) points->mean = vec3_add_scaled(points->mean, 1.0 / count, point[i].place);

    /* scatter of the places about their mean, and its principal axes */
    double a[3][3] = {{0}}, v[3][3], spread[3];
    for (int i = 0; i < count; i++) {
        const wcut_vec3 d = vec3_sub(point[i].place, points->mean);
        const double x[3] = {d.x, d.y, d.z};
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++) a[j][k] += x[j] * x[k] / count;
    }

    /* descending; the third axis makes them right-handed */
    wcut_symmetric_eigen(3, &a[0][0], spread, &v[0][0]);
    for (int k = 0; k < 3; k++) {
        points->axis[k] = vec3(v[0][k], v[1][k], v[2][k]);
        points->spread[k] = sqrt(fmax(spread[k], 0));
    }
    points->axis[2] = vec3_cross(points->axis[0], points->axis[1]);
}

/* ---- six points and more ---- */

/* M of P = [M | p] to rotation, focal length and place; the rows of M are f r1 + c r3, f r2 + c r3, r3 up to a factor */
static bool camera_of_matrix(const wcut_camera_points *points, const double p[12], double scale, wcut_camera *camera,
                             bool *mirrored) {
    const wcut_vec3 m[3] = {vec3(p[0], p[1], p[2]), vec3(p[4], p[5], p[6]), vec3(p[8], p[9], p[10])};
    const double length = vec3_length(m[2]);
    if (!is_positive(length)) return false;

    /* the sign for which the mean of the places is in front: its depth is p[11] = 1 */
    const wcut_vec3 r3 = vec3_scale(1 / length, m[2]);
    const double c1 = vec3_dot(m[0], r3), c2 = vec3_dot(m[1], r3);
    const wcut_vec3 across = vec3_add_scaled(m[0], -c1, r3), down = vec3_add_scaled(m[1], -c2, r3);
    const double f1 = vec3_length(across) / length, f2 = vec3_length(down) / length;
    if (!is_positive(f1) || !is_positive(f2)) return false;
    const wcut_vec3 r1 = vec3_unit(across), r2 = vec3_cross(r3, r1);
    *mirrored = vec3_dot(r2, down) < 0;

    /* t from P's last column, in the units of the scaled places */
    const double f = sqrt(f1 * f2), t3 = 1 / length, t1 = (p[3] / length - c1 / length * t3) / f,
                 t2 = (p[7] / length - c2 / length * t3) / f;
    const double rotation[9] = {r1.x, r1.y, r1.z, r2.x, r2.y, r2.z, r3.x, r3.y, r3.z};
    for (int k = 0; k < 9; k++) camera->rotation[k] = rotation[k];
    camera->focal = f * points->scale_px;
    const wcut_vec3 back = vec3_add_scaled(vec3_add_scaled(vec3_scale(t1, r1), t2, r2), t3, r3);
    camera->centre = vec3_add_scaled(points->mean, -scale, back);
    return is_positive(camera->focal) && vec3_is_finite(camera->centre);
}

wcut_status wcut_camera_direct(const wcut_camera_points *points, wcut_camera *camera, bool *mirrored) {
    const int n = points->count;
    const double scale = points->spread[0];
    double *a = wcut_alloc((size_t)n * 22, sizeof *a), *b = wcut_alloc((size_t)n * 2, sizeof *b), x[12];
    wcut_status status = a && b ? WCUT_OK : WCUT_NO_MEMORY;

    /* u (m3 X + 1) = m1 X + p1 and v likewise: two rows a point, eleven unknowns */
    for (int i = 0; status == WCUT_OK && i < n; i++) {
        const wcut_vec3 d = vec3_scale(1 / scale, vec3_sub(points->point[i].place, points->mean));
        const double uv[2] = {(points->point[i].u - points->middle[0]) / points->scale_px,
                              (points->point[i].v - points->middle[1]) / points->scale_px};
        for (size_t k = 0; k < 2; k++) {
            double *row = a + ((size_t)2 * i + k) * 11, *own = row + 4 * k;
            own[0] = d.x, own[1] = d.y, own[2] = d.z, own[3] = 1;
            row[8] = -uv[k] * d.x, row[9] = -uv[k] * d.y, row[10] = -uv[k] * d.z;
            b[(size_t)2 * i + k] = uv[k];
        }
    }
    if (status == WCUT_OK) status = wcut_qr_solve(2 * n, 11, a, b, x, NULL);
    x[11] = 1;
    if (status == WCUT_OK && !camera_of_matrix(points, x, scale, camera, mirrored)) status = WCUT_SINGULAR;

    wcut_free(a);
    wcut_free(b);
    return status;
}

/* ---- a plane ---- */

/* the pinhole whose image of the plane is h (rows of f r11 f r12 f t1 ...), in scaled coordinates (Zhang 2000, with the
   principal point known): h1 and h2 are images of orthogonal axes of one length */
static bool pinhole_of_plane(const wcut_camera_points *points, const double h[9], double scale, wcut_camera *camera) {
    /* (h11 h12 + h21 h22) w + h31 h32 = 0 and the difference of squares likewise, w = 1 / f^2 */
    const double a1 = h[0] * h[1] + h[3] * h[4], b1 = h[6] * h[7];
    const double a2 = h[0] * h[0] + h[3] * h[3] - h[1] * h[1] - h[4] * h[4], b2 = h[6] * h[6] - h[7] * h[7];
    const double w = -(a1 * b1 + a2 * b2) / (a1 * a1 + a2 * a2);
    if (!is_positive(w)) return false;
    const double f = 1 / sqrt(w);

    /* axes and place of the plane in the camera's frame; in front of it, since h[8] = 1 is a positive depth */
    const wcut_vec3 first = vec3(h[0] / f, h[3] / f, h[6]), second = vec3(h[1] / f, h[4] / f, h[7]),
                    third = vec3(h[2] / f, h[5] / f, h[8]);
    const double size = sqrt(vec3_length(first) * vec3_length(second));
    if (!is_positive(size)) return false;
    const wcut_vec3 x = vec3_unit(first), y = vec3_unit(vec3_add_scaled(second, -vec3_dot(second, x), x)),
                    z = vec3_cross(x, y), t = vec3_scale(scale / size, third);

    /* R = [x y z] [axes]^T */
    const wcut_vec3 *e = points->axis;
    const double in[9] = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
    for (size_t i = 0; i < 3; i++) {
        camera->rotation[3 * i] = in[3 * i] * e[0].x + in[3 * i + 1] * e[1].x + in[3 * i + 2] * e[2].x;
        camera->rotation[3 * i + 1] = in[3 * i] * e[0].y + in[3 * i + 1] * e[1].y + in[3 * i + 2] * e[2].y;
        camera->rotation[3 * i + 2] = in[3 * i] * e[0].z + in[3 * i + 1] * e[1].z + in[3 * i + 2] * e[2].z;
    }
    camera->focal = f * points->scale_px;
    const double *r = camera->rotation;
    camera->centre =
        vec3_sub(points->mean, vec3(r[0] * t.x + r[3] * t.y + r[6] * t.z, r[1] * t.x + r[4] * t.y + r[7] * t.z,
                                    r[2] * t.x + r[5] * t.y + r[8] * t.z));
    return is_positive(camera->focal) && vec3_is_finite(camera->centre);
}

/* h in scaled coordinates to pixels of plane coordinates in mm */
static void unscale_homography(const wcut_camera_points *points, const double h[9], double scale, double to[9]) {
    for (int k = 0; k < 3; k++) {
        const double s = k < 2 ? scale : 1; /* columns of x and y are per scaled mm */
        to[k] = (points->scale_px * h[k] + points->middle[0] * h[6 + k]) / s;
        to[3 + k] = (points->scale_px * h[3 + k] + points->middle[1] * h[6 + k]) / s;
        to[6 + k] = h[6 + k] / s;
    }
}

wcut_status wcut_camera_plane(const wcut_camera_points *points, wcut_camera *camera, bool *determined) {
    const int n = points->count;
    const double scale = points->spread[0];
    double *a = wcut_alloc((size_t)n * 16, sizeof *a), *b = wcut_alloc((size_t)n * 2, sizeof *b), h[9];
    wcut_status status = a && b ? WCUT_OK : WCUT_NO_MEMORY;

    /* u (h31 x + h32 y + 1) = h11 x + h12 y + h13 and v likewise */
    for (int i = 0; status == WCUT_OK && i < n; i++) {
        const wcut_vec3 d = vec3_scale(1 / scale, vec3_sub(points->point[i].place, points->mean));
        const double x = vec3_dot(d, points->axis[0]), y = vec3_dot(d, points->axis[1]);
        const double uv[2] = {(points->point[i].u - points->middle[0]) / points->scale_px,
                              (points->point[i].v - points->middle[1]) / points->scale_px};
        for (size_t k = 0; k < 2; k++) {
            double *row = a + ((size_t)2 * i + k) * 8, *own = row + 3 * k;
            own[0] = x, own[1] = y, own[2] = 1;
            row[6] = -uv[k] * x, row[7] = -uv[k] * y;
            b[(size_t)2 * i + k] = uv[k];
        }
    }
    if (status == WCUT_OK) status = wcut_qr_solve(2 * n, 8, a, b, h, NULL);
    h[8] = 1;
    wcut_free(a);
    wcut_free(b);
    if (status != WCUT_OK) return status;

    camera->plane = points->mean;
    camera->plane_x = points->axis[0];
    camera->plane_y = points->axis[1];
    unscale_homography(points, h, scale, camera->homography);
    *determined = pinhole_of_plane(points, h, scale, camera);
    return WCUT_OK;
}
