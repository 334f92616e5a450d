/* Units, points, placements and splines of a STEP file (ISO 10303-41, -42). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/cad/step_curves.h"

static const double INCREDIBLE = 1e12; /* [mm] */

bool wcut_step_refuse(wcut_step_source *s, long id, const char *found) {
    return wcut_curves_refuse(s->reader, "#%ld: found %s", id, found);
}

/* ---- units ---- */

/* the factor of an SI prefix; 0: unknown */
static double read_prefix(const char *item) {
    static const struct {
        const char *word;
        double factor;
    } known[] = {{"$", 1},        {".MICRO.", 1e-6}, {".MILLI.", 1e-3}, {".CENTI.", 1e-2},
                 {".DECI.", 0.1}, {".KILO.", 1e3},   {".NANO.", 1e-9}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (wcut_p21_is(item, known[k].word)) return known[k].factor;
    return 0;
}

/* a unit over the SI unit `word`, through units that convert into others; 0: it is none of these */
static double read_unit(const wcut_step_source *s, long id, const char *word, int depth) {
    const char *body = wcut_p21_find(&s->file, id);
    const char *si = body ? wcut_p21_record(body, "SI_UNIT") : NULL;
    const char *other = body ? wcut_p21_record(body, "CONVERSION_BASED_UNIT") : NULL;
    if (si && wcut_p21_is(wcut_p21_item(si, 1), word)) return read_prefix(wcut_p21_item(si, 0));
    long of = 0, unit = 0;
    if (!other || depth == 0 || !wcut_p21_read_reference(wcut_p21_item(other, 1), &of)) return 0;
    const char *measured = wcut_p21_find(&s->file, of);
    const char *list = measured ? strchr(measured, '(') : NULL;
    if (list && measured[0] == '(') list = wcut_p21_record(measured, "MEASURE_WITH_UNIT");
    const char *value = wcut_p21_item(list, 0), *inside = value ? strchr(value, '(') : NULL;
    double factor = 0;
    if (!inside || !wcut_p21_read_real(inside + 1, &factor) || !wcut_p21_read_reference(wcut_p21_item(list, 1), &unit))
        return 0;
    return factor * read_unit(s, unit, word, depth - 1);
}

/* the units of a context: its length [mm] and angle [rad], 0 where it has none, and its accuracy */
typedef struct units {
    double length, angle, accuracy;
} units;

static bool read_context(wcut_step_source *s, const wcut_p21_instance *at, const char *list, units *u) {
    /* metres and radians; lengths are converted to millimetres */
    double *const into[2] = {&u->length, &u->angle};
    static const char *const word[2] = {".METRE.", ".RADIAN."};
    static const double scale[2] = {1000, 1};
    *u = (units){0, 0, 0};

    /* units of the context */
    for (const char *item = wcut_p21_item(wcut_p21_item(list, 0), 0); item; item = wcut_p21_next(item)) {
        long id = 0;
        if (!wcut_p21_read_reference(item, &id)) return wcut_step_refuse(s, at->id, "no list of units");
        for (int k = 0; k < 2; k++) {
            const double unit = read_unit(s, id, word[k], 4) * scale[k];
            if (unit > 0) *into[k] = unit;
        }
    }

    /* a millimetre is 0.001 m, of which a thousand are not quite one: the unit that matters is exact */
    if (fabs(u->length - 1) < 1e-12) u->length = 1;

    /* the accuracy that the file states for its lengths */
    const char *sure = wcut_p21_record(at->body, "GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT");
    long measure = 0;
    if (wcut_p21_read_reference(wcut_p21_item(wcut_p21_item(sure, 0), 0), &measure)) {
        const char *body = wcut_p21_find(&s->file, measure);
        const char *value = wcut_p21_item(body ? wcut_p21_record(body, "UNCERTAINTY_MEASURE_WITH_UNIT") : NULL, 0);
        const char *inside = value ? strchr(value, '(') : NULL;
        double number = 0;
        if (inside && wcut_p21_read_real(inside + 1, &number) && number > 0) u->accuracy = number * u->length;
    }

    return true;
}

static void step_values_use(wcut_step_source *s, const units *u) {
    if (u->length > 0) s->length = u->length;
    s->angle = u->angle > 0 ? u->angle : s->angle > 0 ? s->angle : 1;
    if (u->accuracy > 0) wcut_curves_use_accuracy(s->reader, u->accuracy);
}

bool wcut_step_units_of(wcut_step_source *s, long context) {
    const char *body = wcut_p21_find(&s->file, context);
    const char *list = body ? wcut_p21_record(body, "GLOBAL_UNIT_ASSIGNED_CONTEXT") : NULL;
    const wcut_p21_instance at = {context, body};
    units u;
    if (!list) return true;
    if (!read_context(s, &at, list, &u)) return false;
    if (u.length > 0 && !(u.length < 1e9)) return wcut_step_refuse(s, context, "no unit of length");
    step_values_use(s, &u);
    return true;
}

bool wcut_step_units(wcut_step_source *s) {
    for (int k = 0; k < s->file.count; k++) {
        const wcut_p21_instance *at = &s->file.instance[k];
        const char *list = wcut_p21_record(at->body, "GLOBAL_UNIT_ASSIGNED_CONTEXT");
        units u;
        if (!list) continue;
        if (!read_context(s, at, list, &u)) return false;
        if (s->length > 0 && u.length > 0 && fabs(s->length / u.length - 1) > 1e-12) s->has_several = true;
        if (!(s->length > 0)) step_values_use(s, &u);
    }
    if (!(s->length > 0 && s->length < 1e9))
        return wcut_curves_refuse(s->reader, "found no unit of length, expected a GLOBAL_UNIT_ASSIGNED_CONTEXT");
    return true;
}

/* ---- points and placements ---- */

static bool read_triple(wcut_step_source *s, long id, const char *name, double scale, wcut_vec3 *v) {
    const char *body = wcut_p21_find(&s->file, id);
    const char *list = body ? wcut_p21_item(wcut_p21_record(body, name), 1) : NULL;
    double value[3];
    bool ok = wcut_p21_length(list) == 3;
    for (int k = 0; ok && k < 3; k++)
        ok = wcut_p21_read_real(wcut_p21_item(list, k), &value[k]) && fabs(value[k] * scale) <= INCREDIBLE;
    if (!ok) return wcut_curves_refuse(s->reader, "#%ld: expected a %s with three numbers up to 1e12 mm", id, name);
    *v = (wcut_vec3){value[0] * scale, value[1] * scale, value[2] * scale};
    return true;
}

bool wcut_step_point(wcut_step_source *s, long id, wcut_vec3 *point) {
    return read_triple(s, id, "CARTESIAN_POINT", s->length, point);
}

bool wcut_step_direction(wcut_step_source *s, long id, wcut_vec3 *d) {
    wcut_vec3 v;
    if (!read_triple(s, id, "DIRECTION", 1, &v)) return false;
    const double size = sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    if (!(size > 1e-100)) return wcut_step_refuse(s, id, "a direction of no length");
    *d = (wcut_vec3){v.x / size, v.y / size, v.z / size};
    return true;
}

static wcut_vec3 cross(wcut_vec3 a, wcut_vec3 b) {
    return (wcut_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

bool wcut_step_placement(wcut_step_source *s, long id, wcut_vec3 *origin, wcut_vec3 *x, wcut_vec3 *y) {
    const char *body = wcut_p21_find(&s->file, id);
    const char *list = body ? wcut_p21_record(body, "AXIS2_PLACEMENT_3D") : NULL;
    long at = 0, axis = 0, ref = 0;
    wcut_vec3 z = {0, 0, 1}, r = {1, 0, 0};

    /* origin and axis, which is z unless it is told */
    if (!wcut_p21_read_reference(wcut_p21_item(list, 1), &at))
        return wcut_step_refuse(s, id, "no placement, expected an AXIS2_PLACEMENT_3D");
    if (!wcut_step_point(s, at, origin)) return false;
    if (wcut_p21_read_reference(wcut_p21_item(list, 2), &axis) && !wcut_step_direction(s, axis, &z)) return false;

    /* the direction of reference, or any that is not the axis */
    if (wcut_p21_read_reference(wcut_p21_item(list, 3), &ref)) {
        if (!wcut_step_direction(s, ref, &r)) return false;
    } else if (fabs(z.x) > 0.9) {
        r = (wcut_vec3){0, 1, 0};
    }

    /* the axes at right angles */
    *y = cross(z, r);
    const double size = sqrt(y->x * y->x + y->y * y->y + y->z * y->z);
    if (!(size > 1e-9)) return wcut_step_refuse(s, id, "a placement whose axes are parallel");
    *y = (wcut_vec3){y->x / size, y->y / size, y->z / size};
    *x = cross(*y, z);

    return true;
}

/* ---- splines ---- */

/* the points of a list of references; NULL: refused. Not more than the list has characters, so no lie costs memory. */
static wcut_vec3 *read_step_values_points(wcut_step_source *s, long id, const char *list, int *count) {
    *count = wcut_p21_length(list);
    wcut_vec3 *point = wcut_alloc((size_t)*count, sizeof *point);
    if (!point) return wcut_curves_refuse_memory(s->reader), NULL;
    bool ok = *count >= 2 || wcut_step_refuse(s, id, "fewer than two points");
    const char *item = wcut_p21_item(list, 0);
    for (int k = 0; ok && k < *count; k++, item = wcut_p21_next(item)) {
        long at = 0;
        ok = wcut_p21_read_reference(item, &at) ? wcut_step_point(s, at, &point[k])
                                                : wcut_step_refuse(s, id, "a list that is not of points");
    }
    if (ok) return point;
    free(point);
    return NULL;
}

wcut_curve *wcut_step_read_polyline(wcut_step_source *s, long id, const char *body) {
    char place[32];
    int count = 0;
    wcut_vec3 *point = read_step_values_points(s, id, wcut_p21_item(wcut_p21_record(body, "POLYLINE"), 1), &count);
    snprintf(place, sizeof place, "#%ld", id);
    wcut_curve *curve = point ? wcut_curves_polyline(s->reader, place, count, point) : NULL;
    free(point);
    return curve;
}

bool wcut_step_knots(wcut_step_source *s, long id, const char *times, const char *values, int total, double *knot) {
    int used = 0;
    const char *time = wcut_p21_item(times, 0), *value = wcut_p21_item(values, 0);
    for (; time && value; time = wcut_p21_next(time), value = wcut_p21_next(value)) {
        int n = 0;
        double u = 0;
        if (!wcut_p21_read_integer(time, 1, total - used, &n) || !wcut_p21_read_real(value, &u)) break;
        while (n-- > 0) knot[used++] = u;
    }
    if (time || value || used != total)
        return wcut_step_refuse(s, id, "knots and multiplicities that do not add up to poles + degree + 1");
    return true;
}

static bool read_step_values_weights(wcut_step_source *s, long id, const char *list, int count, double *weight) {
    const char *item = wcut_p21_item(list, 0);
    for (int k = 0; k < count; k++, item = item ? wcut_p21_next(item) : NULL)
        if (!wcut_p21_read_real(item, &weight[k])) return wcut_step_refuse(s, id, "too few weights");
    return !item || wcut_step_refuse(s, id, "too many weights");
}

/* how a spline's knots are given: listed, or implied by its kind */
typedef enum knot_kind { KNOTS_LISTED, KNOTS_BEZIER, KNOTS_QUASI_UNIFORM, KNOTS_UNIFORM } knot_kind;

/* where a spline's attributes stand, whether it is simple or complex */
typedef struct spline {
    const char *degree, *points, *times, *knots, *weights;
    knot_kind kind;
} spline;

static spline find_attributes(const char *body) {
    static const char *const name[] = {"B_SPLINE_CURVE_WITH_KNOTS", "BEZIER_CURVE", "QUASI_UNIFORM_CURVE",
                                       "UNIFORM_CURVE"};
    spline found = {0};
    const char *list = NULL;
    for (int k = 0; k < 4 && !list; k++) list = wcut_p21_record(body, name[k]), found.kind = (knot_kind)k;
    const bool is_simple = body[0] != '(', is_listed = found.kind == KNOTS_LISTED;
    const char *base = is_simple ? list : wcut_p21_record(body, "B_SPLINE_CURVE");
    found.degree = wcut_p21_item(base, is_simple ? 1 : 0);
    found.points = wcut_p21_item(base, is_simple ? 2 : 1);
    found.times = is_listed ? wcut_p21_item(list, is_simple ? 6 : 0) : NULL;
    found.knots = is_listed ? wcut_p21_item(list, is_simple ? 7 : 1) : NULL;
    found.weights = is_simple ? NULL : wcut_p21_item(wcut_p21_record(body, "RATIONAL_B_SPLINE_CURVE"), 0);
    return found;
}

/* the knots that a kind implies (ISO 10303-42, b_spline_curve); false: refused */
static bool imply_knots(wcut_step_source *s, long id, knot_kind kind, int degree, int count, double *knot) {
    const int spans = kind == KNOTS_BEZIER ? (count - 1) / degree : count - degree,
              repeat = kind == KNOTS_BEZIER ? degree : 1;
    if (spans < 1 || (kind == KNOTS_BEZIER && (count - 1) % degree != 0))
        return wcut_step_refuse(s, id, "a number of poles that its degree does not allow");
    int used = 0;
    if (kind == KNOTS_UNIFORM) {
        for (; used < count + degree + 1; used++) knot[used] = used - degree;
        return true;
    }
    for (; used <= degree; used++) knot[used] = 0;
    for (int span = 1; span < spans; span++)
        for (int k = 0; k < repeat; k++) knot[used++] = span;
    while (used < count + degree + 1) knot[used++] = spans;
    return true;
}

bool wcut_step_is_spline(const char *body) {
    return wcut_p21_record(body, "B_SPLINE_CURVE_WITH_KNOTS") || wcut_p21_record(body, "BEZIER_CURVE") ||
           wcut_p21_record(body, "QUASI_UNIFORM_CURVE") || wcut_p21_record(body, "UNIFORM_CURVE");
}

wcut_curve *wcut_step_read_spline(wcut_step_source *s, long id, const char *body) {
    const spline at = find_attributes(body);
    int degree = 0, count = 0;
    char place[32];

    /* degree and control points */
    if (!wcut_p21_read_integer(at.degree, 1, 1000, &degree)) return wcut_step_refuse(s, id, "no degree"), NULL;

    /* a higher degree is valid STEP: the curve is left out and counted */
    if (degree > WCUT_DEGREE_MAX) return wcut_curves_leave_out(s->reader, "a degree above 7"), NULL;
    wcut_vec3 *control = read_step_values_points(s, id, at.points, &count);
    if (!control) return NULL;

    /* knots, listed or implied, and weights */
    const size_t total = (size_t)count + (size_t)degree + 1;
    double *knot = wcut_alloc(total + (size_t)count, sizeof *knot);
    wcut_curve *curve = NULL;
    snprintf(place, sizeof place, "#%ld", id);
    if (!knot)
        wcut_curves_refuse_memory(s->reader);
    else if ((at.kind == KNOTS_LISTED ? wcut_step_knots(s, id, at.times, at.knots, (int)total, knot)
                                      : imply_knots(s, id, at.kind, degree, count, knot)) &&
             (!at.weights || read_step_values_weights(s, id, at.weights, count, knot + total)))
        curve = wcut_curves_make(s->reader, place, degree, count, knot, control, at.weights ? knot + total : NULL);

    /* the curve has copies of its numbers */
    free(knot);
    free(control);
    return curve;
}
