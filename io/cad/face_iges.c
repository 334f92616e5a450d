/* Faces from IGES files: rational B-spline surfaces (128), alone or trimmed (144) by curves on them (142). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/edit.h>

#include "base/alloc.h"
#include "io/cad/face_set.h"
#include "io/cad/iges_curves.h"

static const double INCREDIBLE = 1e12; /* [mm] */

static bool refuse_face_data(wcut_iges *f, const wcut_iges_entry *e) {
    return wcut_curves_refuse(f->reader, "line %d: found too few values, or values of another kind, for this entity",
                              e->at + 1);
}

static int face_values_max(const wcut_iges_cursor *c) { return (c->end - c->line) * 32; }

/* move poles as curves are moved */
static bool move_poles(wcut_iges *f, const wcut_iges_entry *e, wcut_surface *surface) {
    wcut_curve poles = {.control_count = surface->count_u * surface->count_v, .control = surface->control};
    return wcut_iges_transform(f, e, &poles);
}

/* ---- 128 ---- */

/* the part of a direction's range that the entity states */
static wcut_surface *cut_range(wcut_iges *f, const wcut_iges_entry *e, wcut_surface *surface, wcut_direction direction,
                               const double range[2]) {
    for (int side = 0; side < 2 && surface; side++) {
        /* the range must lie in the domain, up to rounding */
        double begin[2], end[2];
        wcut_surface_domain(surface, begin, end);
        const int at = direction == WCUT_DIRECTION_U ? 0 : 1;
        const double first = begin[at], last = end[at], slack = 1e-9 * (last - first);
        if (!(range[0] < range[1]) || range[side] < first - slack || range[side] > last + slack) {
            wcut_surface_destroy(surface);
            return wcut_curves_refuse(f->reader,
                                      "line %d: found a surface from %.6g to %.6g, expected a part of %.6g to %.6g",
                                      e->at + 1, range[0], range[1], first, last),
                   NULL;
        }

        /* split at the end of the range, and keep the part inside */
        if (side == 0 ? range[0] <= first + slack : range[1] >= last - slack) continue;
        wcut_surface *low = NULL, *high = NULL;
        const wcut_status status = wcut_surface_split(surface, direction, range[side], &low, &high);
        wcut_surface_destroy(surface);
        surface = side == 0 ? high : low;
        wcut_surface_destroy(side == 0 ? low : high);
        if (status != WCUT_OK) return wcut_curves_refuse_memory(f->reader), NULL;
    }
    return surface;
}

/* the surface of an entry; NULL: refused or left out */
static wcut_surface *read_surface(wcut_iges *f, const wcut_iges_entry *e) {
    /* counts and flags come before the numbers */
    wcut_iges_cursor c;
    int last[2] = {0, 0}, degree[2] = {0, 0}, flag;
    if (!wcut_iges_open(f, e, &c)) return NULL;
    const int max = face_values_max(&c);
    bool ok = true;
    for (int k = 0; ok && k < 2; k++) ok = wcut_iges_int(&c, 1, max, &last[k]);
    for (int k = 0; ok && k < 2; k++) ok = wcut_iges_int(&c, 1, 1000, &degree[k]);
    for (int k = 0; ok && k < 5; k++) ok = wcut_iges_int(&c, 0, 1, &flag);
    if (!ok || (last[0] + 1) > max / (last[1] + 1)) return refuse_face_data(f, e), NULL;
    if (degree[0] > WCUT_DEGREE_MAX || degree[1] > WCUT_DEGREE_MAX)
        return wcut_curves_leave_out(f->reader, "a degree above 7"), NULL;

    /* knots of both directions, weights and control points, u fastest, then the range */
    const int count[2] = {last[0] + 1, last[1] + 1}, poles = count[0] * count[1];
    const int knots[2] = {count[0] + degree[0] + 1, count[1] + degree[1] + 1}, all = knots[0] + knots[1] + 4 * poles;
    double *value = wcut_alloc((size_t)all, sizeof *value), range[4] = {0};
    wcut_surface *surface = NULL;
    if (!value) return wcut_curves_refuse_memory(f->reader), NULL;
    if (!wcut_iges_reals(&c, all, value)) {
        refuse_face_data(f, e);
    } else {
        /* in mm; equal positive weights make a polynomial surface */
        double *weight = value + knots[0] + knots[1];
        wcut_vec3 *control = (wcut_vec3 *)(weight + poles);
        bool same = true;
        for (int k = 0; k < poles; k++) {
            same = same && weight[k] == weight[0];
            control[k] = (wcut_vec3){f->scale * control[k].x, f->scale * control[k].y, f->scale * control[k].z};
            if (!(fabs(control[k].x) <= INCREDIBLE && fabs(control[k].y) <= INCREDIBLE &&
                  fabs(control[k].z) <= INCREDIBLE))
                wcut_curves_refuse(f->reader, "line %d: found a coordinate beyond 1e12 mm", e->at + 1);
        }
        const bool is_rational = !(same && weight[0] > 0);
        const wcut_status status =
            wcut_surface_create(degree[0], degree[1], count[0], count[1], value, value + knots[0], control,
                                is_rational ? weight : NULL, &surface);
        if (status == WCUT_NO_MEMORY) wcut_curves_refuse_memory(f->reader);
        if (status == WCUT_BAD_ARGUMENT)
            wcut_curves_refuse(f->reader, "line %d: found knots or weights that make no surface", e->at + 1);
    }
    free(value);

    /* the part that the range states; files without it mean all of it */
    const bool has_range = surface && wcut_iges_reals(&c, 4, range);
    if (has_range) surface = cut_range(f, e, surface, WCUT_DIRECTION_U, range);
    if (has_range && surface) surface = cut_range(f, e, surface, WCUT_DIRECTION_V, range + 2);
    if (surface && (f->reader->failure.status != WCUT_OK || !move_poles(f, e, surface))) {
        wcut_surface_destroy(surface);
        surface = NULL;
    }
    return surface;
}

/* ---- 144, 142 ---- */

/* the curves of a boundary in space, a composite one by its pieces; false: refused or left out */
static bool add_boundary(wcut_face_reader *r, wcut_iges *f, const wcut_iges_entry *of, int number, wcut_face_loops *l) {
    /* 142, a curve on a surface: its curve in space is used, that in parameters is passed over */
    wcut_iges_entry e = {0}, on = {0}, piece = {0};
    wcut_iges_cursor c;
    int curve = 0, count = 0, flag;
    if (!wcut_iges_find_named(f, of, number, &e) || !wcut_iges_open(f, &e, &c)) return false;
    if (e.type != 142) return wcut_curves_leave_out(f->reader, "a boundary that is no curve on a surface"), false;
    if (!wcut_iges_int(&c, 0, 3, &flag)) return refuse_face_data(f, &e);
    wcut_iges_pass(&c); /* the surface */
    wcut_iges_pass(&c); /* the curve in its parameters */
    if (!wcut_iges_int(&c, 1, 9999999, &curve))
        return wcut_curves_leave_out(f->reader, "a boundary in parameters alone"), false;
    if (!wcut_iges_find_named(f, &e, curve, &on) || !wcut_face_loops_begin(r, l)) return false;

    /* one curve, or the pieces of a composite one */
    if (on.type != 102) {
        wcut_curve *made = wcut_iges_curve(f, &on);
        return made && wcut_face_loops_add(r, l, made);
    }
    if (!wcut_iges_open(f, &on, &c)) return false;
    if (!wcut_iges_int(&c, 1, face_values_max(&c), &count)) return refuse_face_data(f, &on);

    /* each piece is moved as the composite curve is */
    for (int k = 0; k < count; k++) {
        if (!wcut_iges_int(&c, 1, 9999999, &curve)) return refuse_face_data(f, &on);
        if (!wcut_iges_find_named(f, &on, curve, &piece)) return false;
        if (piece.type == 102) return wcut_curves_leave_out(f->reader, "a composite curve in a composite curve"), false;
        wcut_curve *made = wcut_iges_curve(f, &piece);
        if (!made) return false;
        if (!wcut_iges_transform(f, &on, made)) return wcut_curve_destroy(made), false;
        if (!wcut_face_loops_add(r, l, made)) return false;
    }
    return true;
}

static bool add_trimmed(wcut_face_reader *r, wcut_iges *f, const wcut_iges_entry *e) {
    wcut_iges_entry base = {0};
    wcut_iges_cursor c;
    wcut_face_loops l = {0};
    int surface_at = 0, has_outer = 0, inner = 0, outer = 0;

    /* the surface, whether it has an outer boundary of its own, the inner ones */
    if (!wcut_iges_open(f, e, &c)) return false;
    if (!wcut_iges_int(&c, 1, 9999999, &surface_at) || !wcut_iges_int(&c, 0, 1, &has_outer) ||
        !wcut_iges_int(&c, 0, face_values_max(&c), &inner))
        return refuse_face_data(f, e);
    if (!wcut_iges_find_named(f, e, surface_at, &base)) return false;
    if (base.type != 128) return wcut_curves_leave_out(f->reader, "a trimmed surface that is no B-spline"), true;

    /* without an outer boundary the borders of the surface bound the face */
    if (!wcut_iges_int(&c, 0, 9999999, &outer)) outer = 0;
    if (has_outer != (outer > 0)) return refuse_face_data(f, e);
    if (inner > 0 && !has_outer)
        return wcut_curves_leave_out(f->reader, "a surface with holes and no outer boundary"), true;

    /* the loops, the outer one first */
    bool done = !has_outer || add_boundary(r, f, e, outer, &l);
    for (int k = 0; k < inner && done; k++) {
        int number = 0;
        done = wcut_iges_int(&c, 1, 9999999, &number) ? add_boundary(r, f, e, number, &l) : refuse_face_data(f, e);
    }

    /* both moved as the whole is */
    wcut_surface *surface = done ? read_surface(f, &base) : NULL;
    if (surface) done = move_poles(f, e, surface);
    for (int k = 0; k < l.curves && surface && done; k++) done = wcut_iges_transform(f, e, l.curve[k]);
    if (surface && done)
        wcut_faces_add(r, surface, &l, "", 0);
    else
        wcut_surface_destroy(surface);
    wcut_face_loops_clear(&l);
    return f->reader->failure.status == WCUT_OK;
}

/* ---- which ---- */

/* kinds of surfaces that are not read, by their numbers */
static bool leave_kind_out(wcut_iges *f, const wcut_iges_entry *e) {
    static const int kind[] = {108, 114, 118, 120, 122, 140, 143, 190, 192, 194, 196, 198};
    char text[40];
    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++)
        if (e->type == kind[k] && e->status[3] == '0') {
            snprintf(text, sizeof text, "an entity of type %d", e->type);
            wcut_curves_leave_out(f->reader, text);
        }
    return true;
}

static bool add_iges_face(wcut_face_reader *r, wcut_iges *f, const wcut_iges_entry *e) {
    static const wcut_face_loops none = {0};
    if (e->status[1] == '1') return true; /* hidden */
    if (e->type == 144) return add_trimmed(r, f, e);

    /* a surface that another entity uses is read with that */
    if (e->type != 128) return leave_kind_out(f, e);
    if (e->status[3] != '0') return true;
    wcut_surface *surface = read_surface(f, e);
    return surface ? wcut_faces_add(r, surface, &none, "", 0) : f->reader->failure.status == WCUT_OK;
}

bool wcut_faces_fill_iges(wcut_face_reader *r, char *text, size_t length) {
    wcut_iges f;
    bool done = wcut_iges_begin(r->curves, text, length, &f);
    for (int at = f.directory; done && at < f.data; at += 2) {
        wcut_iges_entry entry;
        done = wcut_iges_find(&f, at, &entry) && add_iges_face(r, &f, &entry);
    }
    wcut_iges_end(&f);
    return done;
}
