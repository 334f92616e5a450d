/* Curves of IGES files, one entity each: rational B-splines (126), lines (110), circular arcs (100), ellipses (104),
   strings of points (106), each moved by its transformation (124). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/cad/arc.h"
#include "io/cad/iges_curves.h"

enum { NESTED_MAX = 8 };
static const double TURN = 6.283185307179586;
static const double INCREDIBLE = 1e12; /* [mm] */

static wcut_curve *refuse_iges_curves_data(wcut_iges *f, const wcut_iges_entry *e) {
    wcut_curves_refuse(f->reader, "line %d: found too few values, or values of another kind, for this entity",
                       e->at + 1);
    return NULL;
}

static wcut_curve *leave_iges_curves_out(wcut_iges *f, const wcut_iges_entry *e) {
    char text[40];
    snprintf(text, sizeof text, "type %d form %d", e->type, e->form);
    wcut_curves_leave_out(f->reader, text);
    return NULL;
}

static void scale_points(const wcut_iges *f, wcut_vec3 *p, int count) {
    for (int k = 0; f->scale != 1 && k < count; k++)
        p[k] = (wcut_vec3){p[k].x * f->scale, p[k].y * f->scale, p[k].z * f->scale};
}

/* what the data could hold at two characters a value: more is refused before memory is asked for */
static int iges_curves_max_values(const wcut_iges_cursor *c) { return (c->end - c->line) * 32; }

/* ---- one kind each; NULL: refused or left out ---- */

/* NULL: refused */
static wcut_curve *cut_to_range(wcut_iges *f, const wcut_iges_entry *e, wcut_curve *curve, const double range[2]) {
    double first, last;
    wcut_curve_domain(curve, &first, &last);
    const double slack = 1e-9 * (last - first);
    if (range[0] < range[1] && range[0] >= first - slack && range[1] <= last + slack)
        return wcut_curves_cut(f->reader, curve, range[0], range[1]);
    wcut_curves_refuse(f->reader, "line %d: found a curve from %g to %g, expected a part of its knots' range %g to %g",
                       e->at + 1, range[0], range[1], first, last);
    wcut_curve_destroy(curve);
    return NULL;
}

static wcut_curve *read_spline(wcut_iges *f, const wcut_iges_entry *e, wcut_iges_cursor *c, const char *place) {
    /* counts and flags come before the numbers */
    int last = 0, degree = 0, flag[4];
    bool ok = wcut_iges_int(c, 1, iges_curves_max_values(c), &last) && wcut_iges_int(c, 1, 1000, &degree);
    for (int k = 0; ok && k < 4; k++) ok = wcut_iges_int(c, 0, 1, &flag[k]);
    if (!ok) return refuse_iges_curves_data(f, e);
    if (degree > WCUT_DEGREE_MAX) return wcut_curves_leave_out(f->reader, "a degree above 7"), NULL;

    /* knots, weights and control points lie one after the other */
    const int count = last + 1, knots = count + degree + 1;
    double *value = wcut_alloc((size_t)knots + 4 * (size_t)count, sizeof *value);
    if (!value) return wcut_curves_refuse_memory(f->reader), NULL;
    double *weight = value + knots;
    wcut_vec3 *control = (wcut_vec3 *)(weight + count);
    wcut_curve *curve = NULL;
    double range[2];

    /* equal weights make a polynomial curve */
    if (wcut_iges_reals(c, knots + 4 * count, value)) {
        bool same = true;
        for (int k = 1; k < count; k++) same = same && weight[k] == weight[0];
        scale_points(f, control, count);
        const bool is_rational = !(same && weight[0] > 0);
        curve = wcut_curves_make(f->reader, place, degree, count, value, control, is_rational ? weight : NULL);

        /* the part of the knots' range that the curve is; files without it mean all of it */
        if (curve && wcut_iges_reals(c, 2, range)) curve = cut_to_range(f, e, curve, range);
    } else {
        refuse_iges_curves_data(f, e);
    }

    free(value);
    return curve;
}

/* `count` points of three coordinates, or of two at one height */
static wcut_curve *read_iges_curves_points(wcut_iges *f, const wcut_iges_entry *e, wcut_iges_cursor *c,
                                           const char *place, int count, bool is_flat) {
    wcut_vec3 *point = wcut_alloc((size_t)count, sizeof *point);
    wcut_curve *curve = NULL;
    if (!point) return wcut_curves_refuse_memory(f->reader), NULL;

    /* flat strings have one height for all points */
    double height = 0;
    bool ok = !is_flat || wcut_iges_real(c, &height);
    for (int k = 0; ok && k < count; k++) {
        point[k].z = height;
        ok = wcut_iges_reals(c, is_flat ? 2 : 3, &point[k].x);
    }

    /* points in millimetres, joined by straight lines */
    if (ok) {
        scale_points(f, point, count);
        curve = wcut_curves_polyline(f->reader, place, count, point);
    } else {
        refuse_iges_curves_data(f, e);
    }

    free(point);
    return curve;
}

static wcut_curve *read_string(wcut_iges *f, const wcut_iges_entry *e, wcut_iges_cursor *c, const char *place) {
    int kind = 0, count = 0;
    if (!wcut_iges_int(c, 1, 3, &kind) || !wcut_iges_int(c, 2, iges_curves_max_values(c), &count))
        return refuse_iges_curves_data(f, e);
    return kind == 3 ? leave_iges_curves_out(f, e) : read_iges_curves_points(f, e, c, place, count, kind == 1);
}

/* center + cos(t) a x + sin(t) b y at a height, counter-clockwise from start to end, a whole turn where they are one */
static wcut_curve *make_iges_curves_arc(wcut_iges *f, const char *place, wcut_vec3 center, double a, double b,
                                        const double start[2], const double end[2]) {
    wcut_vec3 pole[WCUT_ARC_POLES];
    double weight[WCUT_ARC_POLES], knot[WCUT_ARC_POLES + 3];
    const double from = atan2((start[1] - center.y) / b, (start[0] - center.x) / a);
    double to = atan2((end[1] - center.y) / b, (end[0] - center.x) / a);
    if (!(to > from + 1e-12)) to += TURN;
    const int poles = wcut_arc(center, (wcut_vec3){a, 0, 0}, (wcut_vec3){0, b, 0}, from, to, pole, weight, knot);
    scale_points(f, pole, poles);
    return wcut_curves_make(f->reader, place, 2, poles, knot, pole, weight);
}

static wcut_curve *read_circle(wcut_iges *f, const wcut_iges_entry *e, wcut_iges_cursor *c, const char *place) {
    double v[7]; /* height, center, start, end */
    if (!wcut_iges_reals(c, 7, v)) return refuse_iges_curves_data(f, e);
    const double radius = hypot(v[3] - v[1], v[4] - v[2]);
    if (!(radius > 0) || !isfinite(radius)) return refuse_iges_curves_data(f, e);
    return make_iges_curves_arc(f, place, (wcut_vec3){v[1], v[2], v[0]}, radius, radius, v + 3, v + 5);
}

/* a x^2 + b x y + c y^2 + d x + e y + f = 0 at a height, from start to end: an ellipse along the axes, as it must be */
static wcut_curve *read_conic(wcut_iges *f, const wcut_iges_entry *e, wcut_iges_cursor *c, const char *place) {
    double v[11];
    if (!wcut_iges_reals(c, 11, v)) return refuse_iges_curves_data(f, e);
    const bool is_ellipse = v[1] == 0 && v[3] == 0 && v[4] == 0 && v[0] * v[2] > 0 && v[0] * v[5] < 0;
    const double x = sqrt(-v[5] / v[0]), y = sqrt(-v[5] / v[2]);
    if (!is_ellipse || !(x > 0 && y > 0) || !isfinite(x) || !isfinite(y)) return leave_iges_curves_out(f, e);
    return make_iges_curves_arc(f, place, (wcut_vec3){0, 0, v[6]}, x, y, v + 7, v + 9);
}

/* ---- where it stands ---- */

bool wcut_iges_find_named(wcut_iges *f, const wcut_iges_entry *by, int number, wcut_iges_entry *entry) {
    if (number < 1 || number % 2 == 0 || number > f->data - f->directory)
        return wcut_curves_refuse(f->reader, "line %d: found no directory entry %d", by->at + 1, number);
    return wcut_iges_find(f, f->directory + number - 1, entry);
}

bool wcut_iges_transform(wcut_iges *f, const wcut_iges_entry *e, wcut_curve *curve) {
    /* a transformation may have one itself, up to a depth */
    wcut_iges_entry by = *e;
    for (int depth = 0; by.transformation != 0; depth++) {
        wcut_iges_entry to = {0};
        wcut_iges_cursor c;
        double m[3][4] = {{0}}; /* rows, and their shift */

        /* twelve numbers: three rows of a matrix, each with its shift */
        bool ok = wcut_iges_find_named(f, &by, by.transformation, &to) && wcut_iges_open(f, &to, &c);
        if (ok && (to.type != 124 || depth == NESTED_MAX || !wcut_iges_reals(&c, 12, m[0])))
            ok = wcut_curves_refuse(f->reader, "line %d: found no transformation, expected one of type 124", to.at + 1);

        /* move the control points; a curve beyond 1e12 mm is refused */
        for (int k = 0; ok && k < curve->control_count; k++) {
            const wcut_vec3 p = curve->control[k];
            double q[3];
            for (int r = 0; r < 3; r++) q[r] = m[r][0] * p.x + m[r][1] * p.y + m[r][2] * p.z + m[r][3] * f->scale;
            ok = fabs(q[0]) <= INCREDIBLE && fabs(q[1]) <= INCREDIBLE && fabs(q[2]) <= INCREDIBLE;
            if (!ok) wcut_curves_refuse(f->reader, "line %d: found a curve moved beyond 1e12 mm", e->at + 1);
            curve->control[k] = (wcut_vec3){q[0], q[1], q[2]};
        }
        if (!ok) return false;
        by = to;
    }

    return true;
}

wcut_curve *wcut_iges_curve(wcut_iges *f, const wcut_iges_entry *e) {
    wcut_iges_cursor c;
    char place[40];
    wcut_curve *curve = NULL;
    if (!wcut_iges_open(f, e, &c)) return NULL;

    /* messages name the line of the entry in the directory */
    snprintf(place, sizeof place, "line %d", e->at + 1);

    /* by the number of the type */
    if (e->type == 126)
        curve = read_spline(f, e, &c, place);
    else if (e->type == 110 && e->form == 0)
        curve = read_iges_curves_points(f, e, &c, place, 2, false);
    else if (e->type == 100)
        curve = read_circle(f, e, &c, place);
    else if (e->type == 104)
        curve = read_conic(f, e, &c, place);
    else if (e->type == 106)
        curve = read_string(f, e, &c, place);
    else
        leave_iges_curves_out(f, e);

    /* a curve that cannot be moved is given up */
    if (!curve || wcut_iges_transform(f, e, curve)) return curve;

    wcut_curve_destroy(curve);
    return NULL;
}
