/* The surface at a distance from another along its normal, and where it folds (Farouki 1986). */
#include <wirecut/edit.h>
#include <wirecut/offset.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/approximate.h"
#include "surface/crossings.h"
#include "surface/curvature.h"
#include "surface/grid.h"

/* Normals on either side of a knot differ by a crease where their angle is above this [rad]; nearer is rounding. */
static const double CREASE = 1e-5;

/* of the domain: how far beside a parameter or a pole to look */
static const double BESIDE = 1e-7;

typedef struct task {
    const wcut_surface *surface;
    double distance;
} task;

/* at a pole the normal of a point a little inwards */
static bool normal_near(const wcut_surface *s, double u, double v, wcut_vec3 *normal) {
    double first[2], last[2];
    wcut_surface_domain(s, first, last);
    const double middle_u = (first[0] + last[0]) / 2, middle_v = (first[1] + last[1]) / 2;
    for (double share = BESIDE; share < 0.01; share *= 10) {
        /* straight inwards from the nearer edges: along a pole's edge the direction is the parameter's own */
        const double at_u = u <= first[0] || u >= last[0] ? u + share * (middle_u - u) : u;
        const double at_v = v <= first[1] || v >= last[1] ? v + share * (middle_v - v) : v;
        if (wcut_surface_normal(s, at_u, at_v, normal) == WCUT_OK) return true;
    }
    return false;
}

/* wcut_grid_map: S + distance n */
static wcut_status offset_grid(const void *data, int count_u, const double *u, int count_v, const double *v,
                               wcut_vec3 *point) {
    const task *t = data;

    /* basis functions along both directions, with first derivatives */
    const wcut_surface *s = t->surface;
    wcut_axis along = {.count = 0}, across = {.count = 0};
    wcut_status status = wcut_axis_fill(s->degree_u, s->count_u, s->knots_u, count_u, u, 1, &along);
    if (status == WCUT_OK) status = wcut_axis_fill(s->degree_v, s->count_v, s->knots_v, count_v, v, 1, &across);
    wcut_homogeneous *fold = wcut_alloc((size_t)s->count_u, 2 * sizeof *fold);
    if (!fold) status = WCUT_NO_MEMORY;

    /* row by row: fold along v, then the normal at each u */
    for (int j = 0; status == WCUT_OK && j < count_v; j++) {
        wcut_grid_fold(s, &across, j, 0, fold);
        wcut_grid_fold(s, &across, j, 1, fold + s->count_u);
        for (int i = 0; status == WCUT_OK && i < count_u; i++) {
            wcut_homogeneous sum[4] = {wcut_grid_along(&along, i, 0, fold),
                                       wcut_grid_along(&along, i, 0, fold + s->count_u),
                                       wcut_grid_along(&along, i, 1, fold)};

            /* at a pole the normal of its neighbourhood */
            wcut_vec3 d[4], n;
            wcut_rational_surface(1, s->weights != NULL, sum, d);
            if (!wcut_unit_normal(d[2], d[1], &n) && !normal_near(s, u[i], v[j], &n)) status = WCUT_DEGENERATE;
            if (status == WCUT_OK) point[(ptrdiff_t)j * count_u + i] = vec3_add_scaled(d[0], t->distance, n);
        }
    }

    wcut_free(fold);
    wcut_axis_clear(&across);
    wcut_axis_clear(&along);

    return status;
}

/* does the normal turn at once across a knot of full multiplicity? */
static bool is_crease(const wcut_surface *s, wcut_direction direction, double at) {
    double first[2], last[2];
    wcut_surface_domain(s, first, last);
    const int d = direction == WCUT_DIRECTION_U ? 0 : 1;
    const double step = BESIDE * (last[d] - first[d]);
    const double *knots = d == 0 ? s->knots_v : s->knots_u;
    const int from = d == 0 ? s->degree_v : s->degree_u, to = d == 0 ? s->count_v : s->count_u;
    for (int k = from; k < to; k++) {
        const double across = (knots[k] + knots[k + 1]) / 2;
        wcut_vec3 low, high, here;
        if (wcut_surface_normal(s, d == 0 ? at - step : across, d == 0 ? across : at - step, &low) != WCUT_OK ||
            wcut_surface_normal(s, d == 0 ? at : across, d == 0 ? across : at, &here) != WCUT_OK ||
            wcut_surface_normal(s, d == 0 ? at + step : across, d == 0 ? across : at + step, &high) != WCUT_OK)
            continue;
        /* what the normal turns by on one side it does not turn by on the other */
        if (vec3_distance(low, here) > CREASE + 2 * vec3_distance(here, high)) return true;
    }
    return false;
}

/* joints where second derivatives may jump, and knots and their middles to look at; *crease: the normal is torn */
static wcut_status make_axis(const wcut_surface *s, wcut_direction direction, wcut_map_axis *axis, double **room,
                             bool *crease) {
    const bool u = direction == WCUT_DIRECTION_U;
    const int degree = u ? s->degree_u : s->degree_v, count = u ? s->count_u : s->count_v;
    const double *knots = u ? s->knots_u : s->knots_v;
    double *place = wcut_alloc((size_t)count + 1, 3 * sizeof *place);
    if (!place) return WCUT_NO_MEMORY;
    double *joint = place, *watch = place + count + 1;
    int joints = 0, watched = 0;

    /* joints: the ends, and knots whose multiplicity makes second derivatives jump */
    joint[joints++] = knots[degree];
    for (int k = degree; k < count; k++) {
        if (!(knots[k] < knots[k + 1])) continue;

        /* a knot between two spans: its multiplicity decides how smooth the surface is there */
        if (knots[k] > knots[degree]) {
            int times = 1;
            while (knots[k - times] == knots[k]) times++;
            watch[watched++] = knots[k];
            if (times > degree - 2) joint[joints++] = knots[k];
            if (times >= degree && is_crease(s, direction, knots[k])) *crease = true;
        }

        /* middles of the spans are watched too */
        watch[watched++] = (knots[k] + knots[k + 1]) / 2;
    }

    joint[joints++] = knots[count];
    *axis = (wcut_map_axis){.joints = joints, .joint = joint, .watched = watched, .watch = watch};
    *room = place;

    return WCUT_OK;
}

/* how strongly the surface bends towards the offset, in the middles and at the ends of its spans */
static void find_tightest(const wcut_surface *s, double distance, const wcut_map_axis *u, const wcut_map_axis *v,
                          wcut_offset_report *report) {
    const double side = distance < 0 ? -1 : 1;
    for (int j = 0; j < v->watched + v->joints; j++)
        for (int i = 0; i < u->watched + u->joints; i++) {
            const double at_u = i < u->watched ? u->watch[i] : u->joint[i - u->watched];
            const double at_v = j < v->watched ? v->watch[j] : v->joint[j - v->watched];
            wcut_tangent_frame frame;
            if (wcut_surface_frame(s, at_u, at_v, &frame) != WCUT_OK) continue;
            const double bend = fmax(side * frame.larger, side * frame.smaller);
            report->folds += bend * fabs(distance) >= 1;
            if (bend <= report->curvature) continue;
            report->curvature = bend;
            report->tight_u = at_u, report->tight_v = at_v;
        }
}

wcut_status wcut_surface_offset(const wcut_surface *surface, double distance, double tolerance, wcut_surface **offset,
                                wcut_offset_report *report) {
    if (!surface || !offset || !isfinite(distance) || !is_positive(tolerance)) return WCUT_BAD_ARGUMENT;
    wcut_map_axis u, v;
    double *room_u = NULL, *room_v = NULL;
    bool crease = false;
    wcut_surface *s = NULL;
    wcut_offset_report r = {.error = 0};

    const task t = {.surface = surface, .distance = distance};

    /* a surface with a crease has no offset */
    wcut_status status = make_axis(surface, WCUT_DIRECTION_U, &u, &room_u, &crease);
    if (status == WCUT_OK) status = make_axis(surface, WCUT_DIRECTION_V, &v, &room_v, &crease);
    if (status == WCUT_OK && crease) status = WCUT_DEGENERATE;
    if (status == WCUT_OK) status = wcut_approximate(offset_grid, &t, &u, &v, tolerance, &s, &r.error);
    if (status == WCUT_OK && report) {
        /* where the offset folds or crosses itself */
        find_tightest(surface, distance, &u, &v, &r);
        status =
            wcut_surface_crossings(s, fmax(tolerance, fabs(distance) / 50), &r.crossings, r.crossing_u, r.crossing_v);
    }
    if (status == WCUT_OK) {
        *offset = s;
        if (report) *report = r;
        s = NULL;
    }

    wcut_surface_destroy(s);
    wcut_free(room_v);
    wcut_free(room_u);
    return status;
}
