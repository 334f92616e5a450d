/* Faces from STEP files (ISO 10303-42): B-spline surfaces and planes with the edges that bound them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/edit.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/cad/face_set.h"
#include "io/cad/step_curves.h"
#include "io/cad/step_places.h"

/* ---- surfaces ---- */

/* where a surface's attributes stand, whether it is simple or complex */
typedef struct net {
    const char *degree_u, *degree_v, *rows, *times_u, *times_v, *knots_u, *knots_v, *weights;
} net;

static net find_net(const char *body) {
    const bool is_simple = body[0] != '(';
    const char *list = wcut_p21_record(body, "B_SPLINE_SURFACE_WITH_KNOTS");
    const char *base = is_simple ? list : wcut_p21_record(body, "B_SPLINE_SURFACE");
    const int at = is_simple ? 1 : 0, knots = is_simple ? 8 : 0;
    return (net){.degree_u = wcut_p21_item(base, at),
                 .degree_v = wcut_p21_item(base, at + 1),
                 .rows = wcut_p21_item(base, at + 2),
                 .times_u = wcut_p21_item(list, knots),
                 .times_v = wcut_p21_item(list, knots + 1),
                 .knots_u = wcut_p21_item(list, knots + 2),
                 .knots_v = wcut_p21_item(list, knots + 3),
                 .weights = is_simple ? NULL : wcut_p21_item(wcut_p21_record(body, "RATIONAL_B_SPLINE_SURFACE"), 0)};
}

/* the poles, u in the outer list of the file and in the inner one of ours; false: refused */
static bool read_poles(wcut_step_source *s, long id, const net *n, int count_u, int count_v, wcut_vec3 *control,
                       double *weight) {
    const char *row = wcut_p21_item(n->rows, 0), *weights = n->weights ? wcut_p21_item(n->weights, 0) : NULL;
    for (int i = 0; i < count_u; i++, row = row ? wcut_p21_next(row) : NULL) {
        const char *item = wcut_p21_item(row, 0), *w = weights ? wcut_p21_item(weights, 0) : NULL;
        if (wcut_p21_length(row) != count_v || (n->weights && wcut_p21_length(weights) != count_v))
            return wcut_step_refuse(s, id, "rows of unlike lengths");
        for (int j = 0; j < count_v; j++, item = wcut_p21_next(item), w = w ? wcut_p21_next(w) : NULL) {
            const size_t to = (size_t)j * (size_t)count_u + (size_t)i;
            long at = 0;
            if (!wcut_p21_read_reference(item, &at)) return wcut_step_refuse(s, id, "a net that is not of points");
            if (!wcut_step_point(s, at, &control[to])) return false;
            if (n->weights && !wcut_p21_read_real(w, &weight[to]))
                return wcut_step_refuse(s, id, "a weight that is none");
        }
        if (weights) weights = wcut_p21_next(weights);
    }
    return true;
}

/* a B-spline surface; NULL: refused, or left out for its degree */
static wcut_surface *read_spline_surface(wcut_step_source *s, long id, const char *body) {
    const net n = find_net(body);

    /* degrees and the size of the net */
    int degree[2] = {0, 0};
    const int count_u = wcut_p21_length(n.rows), count_v = wcut_p21_length(wcut_p21_item(n.rows, 0));
    if (!wcut_p21_read_integer(n.degree_u, 1, 1000, &degree[0]) ||
        !wcut_p21_read_integer(n.degree_v, 1, 1000, &degree[1]))
        return wcut_step_refuse(s, id, "no degree"), NULL;
    if (degree[0] > WCUT_DEGREE_MAX || degree[1] > WCUT_DEGREE_MAX)
        return wcut_curves_leave_out(s->reader, "a degree above 7"), NULL;
    if (count_u < 2 || count_v < 2 || count_u > 100000 || count_v > 100000000 / count_u)
        return wcut_step_refuse(s, id, "no net of poles"), NULL;

    /* poles, weights, knots; not more than the lists have characters, so no lie costs memory */
    const size_t poles = (size_t)count_u * (size_t)count_v;
    const int total[2] = {count_u + degree[0] + 1, count_v + degree[1] + 1};
    wcut_vec3 *control = wcut_alloc(poles, sizeof *control);
    double *weight = wcut_alloc(n.weights ? poles : 1, sizeof *weight);
    double *knot = wcut_alloc((size_t)total[0] + (size_t)total[1], sizeof *knot);
    wcut_surface *surface = NULL;

    /* an unreadable list has been refused by its reader */
    if (!control || !weight || !knot) {
        wcut_curves_refuse_memory(s->reader);
    } else if (read_poles(s, id, &n, count_u, count_v, control, weight) &&
               wcut_step_knots(s, id, n.times_u, n.knots_u, total[0], knot) &&
               wcut_step_knots(s, id, n.times_v, n.knots_v, total[1], knot + total[0])) {
        const wcut_status status = wcut_surface_create(degree[0], degree[1], count_u, count_v, knot, knot + total[0],
                                                       control, n.weights ? weight : NULL, &surface);
        if (status == WCUT_NO_MEMORY) wcut_curves_refuse_memory(s->reader);
        if (status == WCUT_BAD_ARGUMENT) wcut_step_refuse(s, id, "knots or weights that make no surface");
    }
    wcut_free(knot);
    wcut_free(weight);
    wcut_free(control);
    return surface;
}

/* a plane as a patch that is larger than the loops on it by a tenth; NULL: refused */
static wcut_surface *make_plane_patch(wcut_step_source *s, long id, const char *list, const wcut_face_loops *l) {
    /* origin and axes of the plane */
    long at = 0;
    wcut_vec3 o, x, y;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    if (!wcut_p21_read_reference(wcut_p21_item(list, 1), &at)) return wcut_step_refuse(s, id, "no placement"), NULL;
    if (!wcut_step_placement(s, at, &o, &x, &y)) return NULL;

    /* the box of the curves' hulls in the plane */
    for (int c = 0; c < l->curves; c++)
        for (int k = 0; k < l->curve[c]->control_count; k++) {
            const wcut_vec3 p = l->curve[c]->control[k], d = {p.x - o.x, p.y - o.y, p.z - o.z};
            const double t[2] = {d.x * x.x + d.y * x.y + d.z * x.z, d.x * y.x + d.y * y.y + d.z * y.z};
            for (int a = 0; a < 2; a++) low[a] = fmin(low[a], t[a]), high[a] = fmax(high[a], t[a]);
        }
    if (!(high[0] > low[0] && high[1] > low[1]))
        return wcut_curves_leave_out(s->reader, "a plane without an extent"), NULL;

    /* a margin of a tenth, so that no boundary touches the border of the patch */
    for (int a = 0; a < 2; a++) {
        const double more = 0.1 * (high[a] - low[a]);
        low[a] -= more, high[a] += more;
    }

    /* four corners */
    static const double knot[4] = {0, 0, 1, 1};
    wcut_vec3 corner[4];
    for (int k = 0; k < 4; k++) {
        const double u = k % 2 ? high[0] : low[0], v = k / 2 ? high[1] : low[1];
        corner[k] = (wcut_vec3){o.x + u * x.x + v * y.x, o.y + u * x.y + v * y.y, o.z + u * x.z + v * y.z};
    }
    wcut_surface *surface = NULL;
    if (wcut_surface_create(1, 1, 2, 2, knot, knot, corner, NULL, &surface) != WCUT_OK)
        wcut_curves_refuse_memory(s->reader);
    return surface;
}

/* ---- loops ---- */

/* one edge at the end of a loop, in the direction in which the loop passes it */
static bool add_oriented(wcut_face_reader *r, wcut_step_source *s, long id, wcut_face_loops *l) {
    long edge = 0;
    const char *body = wcut_p21_find(&s->file, id), *list = body ? wcut_p21_record(body, "ORIENTED_EDGE") : NULL;
    if (!wcut_p21_read_reference(wcut_p21_item(list, 3), &edge)) return wcut_step_refuse(s, id, "no ORIENTED_EDGE");
    wcut_curve *curve = wcut_step_edge(s, edge);
    if (!curve) return false;
    if (wcut_p21_is(wcut_p21_item(list, 4), ".F.")) {
        wcut_curve *back = NULL;
        const wcut_status status = wcut_curve_reverse(curve, &back);
        wcut_curve_destroy(curve);
        if (status != WCUT_OK) return wcut_curves_refuse_memory(s->reader);
        curve = back;
    }
    return wcut_face_loops_add(r, l, curve);
}

/* the bounds of a face; false: refused, or a curve of them was left out */
static bool read_bounds(wcut_face_reader *r, wcut_step_source *s, long id, const char *bounds, wcut_face_loops *l) {
    /* each bound, outer or inner, has a loop */
    for (const char *item = wcut_p21_item(bounds, 0); item; item = wcut_p21_next(item)) {
        long bound = 0, loop = 0;
        if (!wcut_p21_read_reference(item, &bound)) return wcut_step_refuse(s, id, "a bound that is none");
        const char *body = wcut_p21_find(&s->file, bound);
        const char *list = body ? wcut_p21_record(body, "FACE_OUTER_BOUND") : NULL;
        if (body && !list) list = wcut_p21_record(body, "FACE_BOUND");
        if (!wcut_p21_read_reference(wcut_p21_item(list, 1), &loop)) return wcut_step_refuse(s, bound, "no loop");

        /* only loops of edges; the edges in the order of the loop */
        const char *of = wcut_p21_find(&s->file, loop), *edges = of ? wcut_p21_record(of, "EDGE_LOOP") : NULL;
        if (!edges) return wcut_curves_leave_out(s->reader, "a face bounded by other than edges"), false;
        if (wcut_p21_length(wcut_p21_item(edges, 1)) < 1) return wcut_step_refuse(s, loop, "no edges");
        if (!wcut_face_loops_begin(r, l)) return false;
        for (const char *edge = wcut_p21_item(wcut_p21_item(edges, 1), 0); edge; edge = wcut_p21_next(edge)) {
            long oriented = 0;
            if (!wcut_p21_read_reference(edge, &oriented))
                return wcut_step_refuse(s, loop, "a list that is not of edges");
            if (!add_oriented(r, s, oriented, l)) return false;
        }
    }
    return true;
}

/* ---- faces ---- */

static void leave_surface_out(wcut_step_source *s, const char *body) {
    char kind[48];
    const char *name = body[0] == '(' ? body + 1 : body;
    snprintf(kind, sizeof kind, "%.*s", (int)strcspn(name, "("), name);
    wcut_curves_leave_out(s->reader, kind);
}

/* move poles as curves are moved */
static bool place_poles(wcut_step_source *s, long id, const wcut_step_place *place, wcut_surface *surface) {
    wcut_curve poles = {.control_count = surface->count_u * surface->count_v, .control = surface->control};
    return wcut_step_set_in_place(s, id, place, &poles);
}

/* a surface with its loops in one place; what cannot be read of it leaves the face out. false: refused */
static bool add_face(wcut_face_reader *r, wcut_step_source *s, const wcut_p21_instance *at, const char *list,
                     const wcut_step_place *place) {
    /* the surface that the face lies on */
    long id = 0;
    wcut_face_loops l = {0};
    if (!wcut_p21_read_reference(wcut_p21_item(list, 2), &id))
        return wcut_step_refuse(s, at->id, "a face without a surface");
    const char *body = wcut_p21_find(&s->file, id);
    if (!body) return wcut_step_refuse(s, id, "no such instance");

    /* the loops, the surface, the side that counts */
    bool done = read_bounds(r, s, at->id, wcut_p21_item(list, 1), &l);
    wcut_surface *surface = NULL;
    const char *plane = wcut_p21_record(body, "PLANE");
    if (done && wcut_p21_record(body, "B_SPLINE_SURFACE_WITH_KNOTS"))
        surface = read_spline_surface(s, id, body);
    else if (done && plane)
        surface = make_plane_patch(s, id, plane, &l);
    else if (done)
        leave_surface_out(s, body);

    /* .F.: the normal of the face is opposite to that of the surface */
    if (surface && wcut_p21_is(wcut_p21_item(list, 3), ".F.")) {
        wcut_surface *back = NULL;
        if (wcut_surface_reverse(surface, WCUT_DIRECTION_U, &back) != WCUT_OK) wcut_curves_refuse_memory(s->reader);
        wcut_surface_destroy(surface);
        surface = back;
    }

    /* in its place, into the set */
    if (surface && place) {
        done = place_poles(s, at->id, place, surface);
        for (int k = 0; k < l.curves && done; k++) done = wcut_step_set_in_place(s, at->id, place, l.curve[k]);
    }

    /* the name between apostrophes, where there is one */
    const char *name = wcut_p21_item(list, 0);
    const bool named = name && *name == '\'';
    if (surface && done)
        wcut_faces_add(r, surface, &l, named ? name + 1 : "", named ? strcspn(name + 1, "'") : 0);
    else
        wcut_surface_destroy(surface);
    wcut_face_loops_clear(&l);
    return s->reader->failure.status == WCUT_OK;
}

static const char *find_step_face(const char *body) {
    const char *list = wcut_p21_record(body, "ADVANCED_FACE");
    return list ? list : wcut_p21_record(body, "FACE_SURFACE");
}

/* the faces that a representation's items lead to, wherever it stands */
static bool add_held(wcut_face_reader *r, wcut_step_source *s, const wcut_p21_instance *rep, unsigned char *reached) {
    wcut_step_place place[WCUT_STEP_PLACES_MAX];
    int places = 0, faces = 0;
    if (!wcut_step_reach(s, rep->body, reached)) return false;
    for (int k = 0; k < s->file.count; k++) faces += reached[k] && find_step_face(s->file.instance[k].body);
    if (faces == 0) return true;
    if (!wcut_step_use_units(s, rep->id) || !wcut_step_find_places(s, rep->id, place, &places)) return false;
    for (int p = 0; p < places; p++)
        for (int k = 0; k < s->file.count; k++) {
            const wcut_p21_instance *at = &s->file.instance[k];
            const char *list = reached[k] ? find_step_face(at->body) : NULL;
            if (list && !add_face(r, s, at, list, &place[p])) return false;
        }
    return true;
}

/* surfaces without faces count whole */
static bool add_loose(wcut_face_reader *r, wcut_step_source *s) {
    static const wcut_face_loops none = {0};
    for (int k = 0; k < s->file.count; k++) {
        const wcut_p21_instance *at = &s->file.instance[k];
        if (!wcut_p21_record(at->body, "B_SPLINE_SURFACE_WITH_KNOTS")) continue;
        wcut_surface *surface = read_spline_surface(s, at->id, at->body);
        if (surface && !wcut_faces_add(r, surface, &none, "", 0)) return false;
        if (s->reader->failure.status != WCUT_OK) return false;
    }
    return true;
}

static bool add_faces(wcut_face_reader *r, wcut_step_source *s) {
    unsigned char *reached = wcut_alloc((size_t)s->file.count + 1, 1);
    int faces = 0;
    bool done = reached || wcut_curves_refuse_memory(s->reader);
    for (int k = 0; done && reached && k < s->file.count; k++) {
        faces += find_step_face(s->file.instance[k].body) != NULL;
        if (wcut_step_items(s->file.instance[k].body)) done = add_held(r, s, &s->file.instance[k], reached);
    }
    wcut_free(reached);

    /* faces that no representation holds stand where they are */
    const bool none = r->set->count == 0 && s->reader->set->left_out == 0;
    for (int k = 0; done && none && faces > 0 && k < s->file.count; k++) {
        const char *list = find_step_face(s->file.instance[k].body);
        if (list) done = add_face(r, s, &s->file.instance[k], list, NULL);
    }
    return done && faces == 0 ? add_loose(r, s) : done;
}

bool wcut_faces_fill_step(wcut_face_reader *r, char *text, size_t length) {
    wcut_step_source s = {.reader = r->curves};
    const bool done = wcut_p21_open(r->curves, text, length, &s.file) && wcut_step_units(&s) && add_faces(r, &s);
    wcut_p21_close(&s.file);
    return done;
}
