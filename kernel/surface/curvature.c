/* Normal and curvature from the two fundamental forms (do Carmo 1976, Differential Geometry of Curves and Surfaces). */
#include "surface/curvature.h"

#include "base/numbers.h"

/* area of S_u, S_v over |S_u|^2 + |S_v|^2 below which rounding has made them span a plane, or one of them be there */
static const double FLAT = 1e-10;

bool wcut_unit_normal(wcut_vec3 su, wcut_vec3 sv, wcut_vec3 *normal) {
    const wcut_vec3 across = vec3_cross(su, sv);
    const double area = vec3_length(across);
    if (!(area > FLAT * (vec3_dot(su, su) + vec3_dot(sv, sv))) || !isfinite(area)) return false;
    *normal = vec3_scale(1 / area, across);
    return true;
}

bool wcut_frame_of(const wcut_vec3 *d, wcut_tangent_frame *frame) {
    const wcut_vec3 su = d[3], sv = d[1];

    /* unit normal */
    wcut_tangent_frame t = {.point = d[0]};
    if (!wcut_unit_normal(su, sv, &t.normal)) return false;

    /* first and second fundamental forms: e, f, g and l, m, n */
    const double e = vec3_dot(su, su), f = vec3_dot(su, sv), g = vec3_dot(sv, sv), area2 = e * g - f * f;
    const double l = vec3_dot(d[6], t.normal), m = vec3_dot(d[4], t.normal), n = vec3_dot(d[2], t.normal);

    /* mean and Gaussian curvature, and the principal ones from both */
    t.mean = (e * n - 2 * f * m + g * l) / (2 * area2);
    t.gauss = (l * n - m * m) / area2;
    /* the root is real; where both curvatures are the same rounding may say otherwise */
    const double size = fabs(t.mean) + sqrt(fmax(t.mean * t.mean - t.gauss, 0)), k = t.mean < 0 ? -size : size;
    t.larger = k, t.smaller = 2 * t.mean - k;
    /* (II - k I) x = 0: across the longer row, measured in lengths */
    const double uu = l - k * e, uv = m - k * f, vv = n - k * g;
    const bool by_u = fabs(uu) * g + fabs(uv) * sqrt(e * g) >= fabs(vv) * e + fabs(uv) * sqrt(e * g);
    const wcut_vec3 x =
        by_u ? vec3_add_scaled(vec3_scale(-uv, su), uu, sv) : vec3_add_scaled(vec3_scale(vv, su), -uv, sv);
    const bool umbilic = t.larger - t.smaller == 0 || !(vec3_length(x) > 1e-12 * fabs(k) * e * sqrt(g));

    /* at an umbilic every direction is principal */
    t.along = vec3_unit(umbilic ? su : x);
    t.across = vec3_cross(t.normal, t.along);
    *frame = t;

    return true;
}

wcut_status wcut_surface_normal(const wcut_surface *surface, double u, double v, wcut_vec3 *normal) {
    if (!normal) return WCUT_BAD_ARGUMENT;
    wcut_vec3 d[4];
    const wcut_status status = wcut_surface_eval(surface, u, v, 1, d);
    if (status != WCUT_OK) return status;
    return wcut_unit_normal(d[2], d[1], normal) ? WCUT_OK : WCUT_DEGENERATE;
}

wcut_status wcut_surface_frame(const wcut_surface *surface, double u, double v, wcut_tangent_frame *frame) {
    if (!frame) return WCUT_BAD_ARGUMENT;
    wcut_vec3 d[9];
    const wcut_status status = wcut_surface_eval(surface, u, v, 2, d);
    if (status != WCUT_OK) return status;
    return wcut_frame_of(d, frame) ? WCUT_OK : WCUT_DEGENERATE;
}

wcut_status wcut_surface_curvature(const wcut_surface *surface, double u, double v, double *larger, double *smaller) {
    if (!larger) return WCUT_BAD_ARGUMENT;
    wcut_tangent_frame frame;
    const wcut_status status = wcut_surface_frame(surface, u, v, &frame);
    if (status != WCUT_OK) return status;
    *larger = frame.larger;
    if (smaller) *smaller = frame.smaller;
    return WCUT_OK;
}
