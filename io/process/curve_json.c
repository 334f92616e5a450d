/* A CURVE in JSON: points to interpolate, or a spline by its degree, knots and control points. */
#include "io/process/curve_json.h"

#include <stdlib.h>
#include <wirecut/curve.h>

#include "io/process/job.h"

enum { POINTS_MAX = WCUT_JOB_STATIONS_MAX };

/* a CURVE as it stands in the file */
typedef struct curve_text {
    int points, degree, knots, controls, weights;
    wcut_vec3 *point, *control;
    double *knot, *weight;
} curve_text;

static bool read_curve_points(wcut_reader *reader, const wcut_place *at, void *into) {
    curve_text *c = into;
    return wcut_read_array(reader, at, 2, POINTS_MAX, "points", wcut_read_point, sizeof(wcut_vec3), &c->points,
                           (void **)&c->point);
}

static bool read_degree(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 1, WCUT_DEGREE_MAX, into);
}

static bool read_controls(wcut_reader *reader, const wcut_place *at, void *into) {
    curve_text *c = into;
    return wcut_read_array(reader, at, c->degree + 1, POINTS_MAX, "control points", wcut_read_point, sizeof(wcut_vec3),
                           &c->controls, (void **)&c->control);
}

static bool read_knots(wcut_reader *reader, const wcut_place *at, void *into) {
    curve_text *c = into;
    int count = c->controls + c->degree + 1;
    if (json_is_array(at->value) && json_array_size(at->value) != (size_t)count)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "%d knots: control points + degree + 1", count);
    return wcut_read_array(reader, at, count, count, "knots", wcut_read_finite, sizeof(double), &c->knots,
                           (void **)&c->knot);
}

static bool read_weights(wcut_reader *reader, const wcut_place *at, void *into) {
    curve_text *c = into;
    if (json_is_array(at->value) && json_array_size(at->value) != (size_t)c->controls)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "%d weights, one a control point", c->controls);
    return wcut_read_array(reader, at, c->controls, c->controls, "weights", wcut_read_positive, sizeof(double),
                           &c->weights, (void **)&c->weight);
}

static bool read_curve_text(wcut_reader *reader, const wcut_place *at, curve_text *c) {
    static const wcut_field interpolated[] = {{"points_mm", true, read_curve_points, 0}};
    static const wcut_field spline[] = {
        {"degree", true, read_degree, offsetof(curve_text, degree)},
        {"control_points_mm", true, read_controls, 0},
        {"knots", true, read_knots, 0},
        {"weights", false, read_weights, 0},
    };
    bool points = json_object_get(at->value, "points_mm"), degree = json_object_get(at->value, "degree");
    if (points && degree)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "either \"points_mm\" or \"degree\", not both");
    if (json_is_object(at->value) && !points && !degree && json_object_size(at->value) == 0)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT,
                           "a curve: \"points_mm\", or \"degree\", \"knots\" and \"control_points_mm\"");
    return degree || json_object_get(at->value, "knots") ? wcut_read_object(reader, at, spline, 4, c)
                                                         : wcut_read_object(reader, at, interpolated, 1, c);
}

bool wcut_read_curve(wcut_reader *reader, const wcut_place *at, void *into) {
    curve_text c = {0};
    wcut_curve *curve = NULL;
    bool ok = read_curve_text(reader, at, &c);

    /* a curve through points, or by its control points */
    if (ok) {
        wcut_status status = c.point ? wcut_curve_interpolate(c.points, c.point, &curve)
                                     : wcut_curve_create(c.degree, c.controls, c.knot, c.control, c.weight, &curve);

        /* the message says which of the two kinds was wrong */
        if (status == WCUT_NO_MEMORY) ok = wcut_refuse_memory(reader);
        if (status != WCUT_OK && status != WCUT_NO_MEMORY)
            ok = c.point ? wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "points of which no two neighbours coincide")
                         : wcut_refuse(reader, at, WCUT_BAD_ARGUMENT,
                                       "knots that do not decrease, span a domain, and repeat at most degree times "
                                       "inside it");
    }

    /* the texts were copied into the curve */
    free(c.point);
    free(c.control);
    free(c.knot);
    free(c.weight);
    if (ok) *(wcut_curve **)into = curve;

    return ok;
}
