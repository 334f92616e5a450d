/* The cut and its first derivatives, by the derivatives of the surface's normal where it lies beside it. */
#include "solid/sheet.h"

#include <stdbool.h>
#include <stddef.h>

#include "base/numbers.h"
#include "base/vec3.h"

wcut_sheet wcut_sheet_of(const wcut_surface *surface) {
    wcut_sheet sheet = {.surface = surface};
    wcut_surface_domain(surface, sheet.first, sheet.last);
    return sheet;
}

/* S, prolonged, and its derivatives up to the second */
typedef struct frame {
    wcut_vec3 at, u, v, uu, uv, vv;
} frame;

/* S(u, v) = S + b S_u + c S_v + b c S_uv beyond the domain, the derivatives there those of this expression */
static frame eval_frame(const wcut_sheet *sheet, double u, double v, bool second) {
    /* the nearest parameters inside the domain, and how far beyond it */
    const double at_u = clamp(u, sheet->first[0], sheet->last[0]), at_v = clamp(v, sheet->first[1], sheet->last[1]);
    const double b = u - at_u, c = v - at_v;
    const bool inside = b == 0 && c == 0;
    const int order = (inside ? 1 : 2) + second;

    /* derivatives there; one order more where the surface is continued */
    const ptrdiff_t n = order + 1;
    wcut_vec3 d[16];
    wcut_surface_eval(sheet->surface, at_u, at_v, order, d); /* finite parameters and an order in range: cannot fail */
    frame f = {.at = d[0], .u = d[n], .v = d[1]};

    /* beyond the domain it goes on straight, bilinear in b and c */
    if (!inside) {
        const wcut_vec3 twist = d[n + 1];
        f.at = vec3_add_scaled(vec3_add_scaled(vec3_add_scaled(d[0], b, d[n]), c, d[1]), b * c, twist);
        f.u = vec3_add_scaled(d[n], c, twist);
        f.v = vec3_add_scaled(d[1], b, twist);
    }

    /* second derivatives; along a direction of continuation they vanish */
    if (!second) return f;
    f.uv = d[n + 1];
    if (b == 0) f.uu = inside ? d[2 * n] : vec3_add_scaled(d[2 * n], c, d[2 * n + 1]);
    if (c == 0) f.vv = inside ? d[2] : vec3_add_scaled(d[2], b, d[n + 2]);

    return f;
}

/* derivative of a unit normal n = N / |N|, from that of N */
static wcut_vec3 sheet_turn_of(wcut_vec3 unit, double length, wcut_vec3 normal_rate) {
    return vec3_scale(1 / length, vec3_add_scaled(normal_rate, -vec3_dot(unit, normal_rate), unit));
}

/* the width and its derivatives, constant beyond the domain */
static void eval_width(const wcut_sheet *sheet, double u, double v, double *d, double *d_u, double *d_v) {
    wcut_vec3 w[4];
    wcut_surface_eval(sheet->width, clamp(u, sheet->first[0], sheet->last[0]),
                      clamp(v, sheet->first[1], sheet->last[1]), 1, w);
    *d = sheet->side * w[0].z;
    *d_v = v < sheet->first[1] || v > sheet->last[1] ? 0 : sheet->side * w[1].z;
    *d_u = u < sheet->first[0] || u > sheet->last[0] ? 0 : sheet->side * w[2].z;
}

wcut_sheet_point wcut_sheet_eval(const wcut_sheet *sheet, double u, double v) {
    const frame f = eval_frame(sheet, u, v, sheet->width != NULL);
    wcut_sheet_point p = {.at = f.at, .along_u = f.u, .along_v = f.v};
    const wcut_vec3 normal = vec3_cross(f.u, f.v);
    const double length = vec3_length(normal), sides = vec3_length(f.u) * vec3_length(f.v);
    if (!(length > 0) || !(sides > 0)) return p;
    p.facing = length / sides;
    if (!sheet->width) return p;
    const wcut_vec3 n = vec3_scale(1 / length, normal);
    const wcut_vec3 n_u = sheet_turn_of(n, length, vec3_add(vec3_cross(f.uu, f.v), vec3_cross(f.u, f.uv)));
    const wcut_vec3 n_v = sheet_turn_of(n, length, vec3_add(vec3_cross(f.uv, f.v), vec3_cross(f.u, f.vv)));
    double d, d_u, d_v;
    eval_width(sheet, u, v, &d, &d_u, &d_v);
    p.at = vec3_add_scaled(f.at, d, n);
    p.along_u = vec3_add_scaled(vec3_add_scaled(f.u, d, n_u), d_u, n);
    p.along_v = vec3_add_scaled(vec3_add_scaled(f.v, d, n_v), d_v, n);
    p.facing = vec3_dot(vec3_cross(p.along_u, p.along_v), n) / sides;
    return p;
}

void wcut_sheet_prolonged(const wcut_sheet *sheet, double u, double v, double *wire, double *feed) {
    wcut_vec3 d[4];
    const double at_u = clamp(u, sheet->first[0], sheet->last[0]), at_v = clamp(v, sheet->first[1], sheet->last[1]);
    wcut_surface_eval(sheet->surface, at_u, at_v, 1, d);
    *wire = fabs(u - at_u) * vec3_length(d[2]);
    *feed = fabs(v - at_v) * vec3_length(d[1]);
}
