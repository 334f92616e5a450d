/* Curves from STEP files (ISO 10303-42): those of geometric sets, or the edges of faces where there are none. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/edit.h>
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/cad/arc.h"
#include "io/cad/step_curves.h"
#include "io/cad/step_places.h"

enum { DEPTH_MAX = 8 };
static const double TURN = 6.283185307179586;

/* where a piece of a basis curve begins and ends, in whichever way the file says it */
typedef struct piece {
    bool has_points, has_parameters;
    wcut_vec3 point[2];  /* [mm] */
    double parameter[2]; /* of the file */
    bool forwards;       /* along the basis curve */
    double slack;        /* [mm] within which points lie on the curve */
} piece;

static bool reference(wcut_step_source *s, long id, const char *item, long *to) {
    return wcut_p21_read_reference(item, to) || wcut_step_refuse(s, id, "no reference where one is expected");
}

static double point_distance(wcut_vec3 a, wcut_vec3 b) {
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return sqrt(x * x + y * y + z * z);
}

/* ---- lines and arcs ---- */

static wcut_curve *make_line(wcut_step_source *s, long id, const char *list, const piece *p) {
    char place[32];
    wcut_vec3 end[2] = {p->point[0], p->point[1]};
    snprintf(place, sizeof place, "#%ld", id);

    /* without end points: the line's origin, direction and magnitude at both parameters */
    if (!p->has_points) {
        long at = 0, vector = 0, along = 0;
        wcut_vec3 origin, d;
        double size = 0;
        if (!reference(s, id, wcut_p21_item(list, 1), &at) || !reference(s, id, wcut_p21_item(list, 2), &vector) ||
            !wcut_step_point(s, at, &origin))
            return NULL;

        /* the VECTOR: its direction is made a unit vector, its magnitude scales the parameter */
        const char *body = wcut_p21_find(&s->file, vector), *v = body ? wcut_p21_record(body, "VECTOR") : NULL;
        if (!reference(s, vector, wcut_p21_item(v, 1), &along) || !wcut_step_direction(s, along, &d)) return NULL;
        if (!wcut_p21_read_real(wcut_p21_item(v, 2), &size)) return wcut_step_refuse(s, vector, "no magnitude"), NULL;

        /* both ends lie on the line */
        for (int k = 0; k < 2; k++) {
            const double t = p->parameter[k] * size * s->length;
            end[k] = (wcut_vec3){origin.x + t * d.x, origin.y + t * d.y, origin.z + t * d.z};
        }
    }

    return wcut_curves_polyline(s->reader, place, 2, end);
}

/* the angle of a point of the ellipse center + cos(t) a x + sin(t) b y */
static double arc_angle(wcut_vec3 p, wcut_vec3 center, wcut_vec3 x, wcut_vec3 y, double a, double b) {
    const wcut_vec3 d = {p.x - center.x, p.y - center.y, p.z - center.z};
    return atan2((d.x * y.x + d.y * y.y + d.z * y.z) / b, (d.x * x.x + d.y * x.y + d.z * x.z) / a);
}

static wcut_curve *make_curve_step_arc(wcut_step_source *s, long id, const char *list, bool is_circle, const piece *p) {
    long at = 0;
    double a = 0, b = 0, t[2];
    wcut_vec3 center, x, y, pole[WCUT_ARC_POLES];

    /* the placement, then one radius or two */
    if (!reference(s, id, wcut_p21_item(list, 1), &at) || !wcut_step_placement(s, at, &center, &x, &y)) return NULL;
    bool ok = wcut_p21_read_real(wcut_p21_item(list, 2), &a);
    ok = ok && (is_circle || wcut_p21_read_real(wcut_p21_item(list, 3), &b));
    if (is_circle) b = a;
    if (!ok || !(a > 0 && b > 0 && a <= 1e12 && b <= 1e12)) return wcut_step_refuse(s, id, "no radius"), NULL;

    /* radii in millimetres */
    a *= s->length;
    b *= s->length;

    /* both ends as angles, from the points or from the parameters */
    for (int k = 0; k < 2; k++)
        t[k] = p->has_points ? arc_angle(p->point[k], center, x, y, a, b) : fmod(p->parameter[k] * s->angle, TURN);
    if (!isfinite(t[0]) || !isfinite(t[1])) return wcut_step_refuse(s, id, "no angle"), NULL;
    /* the same place twice is a whole turn */
    if (p->forwards && !(t[1] > t[0] + 1e-12)) t[1] += TURN;
    if (!p->forwards && !(t[1] < t[0] - 1e-12)) t[1] -= TURN;
    while (t[1] - t[0] > TURN * (1 + 1e-12)) t[1] -= TURN;
    while (t[0] - t[1] > TURN * (1 + 1e-12)) t[1] += TURN;

    /* the arc as a rational curve of degree 2 */
    char place[32];
    double weight[WCUT_ARC_POLES], knot[WCUT_ARC_POLES + 3];
    snprintf(place, sizeof place, "#%ld", id);
    const wcut_vec3 ax = {a * x.x, a * x.y, a * x.z}, by = {b * y.x, b * y.y, b * y.z};
    const int poles = wcut_arc(center, ax, by, t[0], t[1], pole, weight, knot);

    return wcut_curves_make(s->reader, place, 2, poles, knot, pole, weight);
}

/* ---- pieces of splines ---- */

static wcut_curve *reversed(wcut_step_source *s, wcut_curve *curve) {
    wcut_curve *back = NULL;
    if (curve && wcut_curve_reverse(curve, &back) != WCUT_OK) wcut_curves_refuse_memory(s->reader);
    wcut_curve_destroy(curve);
    return back;
}

/* where a point lies on a curve; false: further from it than the slack, or refused */
static bool find_parameter(wcut_step_source *s, const wcut_curve *curve, wcut_vec3 point, double slack, double *u) {
    wcut_curve_foot foot;
    const wcut_status status = wcut_curve_locate(curve, 1, &point, 1, &foot);
    if (status == WCUT_NO_MEMORY) return wcut_curves_refuse_memory(s->reader);
    if (status != WCUT_OK || foot.distance > slack) {
        wcut_curves_leave_out(s->reader, "a spline whose ends are not on it");
        return false;
    }
    *u = foot.u;
    return true;
}

/* A spline is whole, or cut at parameters, or at the points of it that are the piece's ends. */
static wcut_curve *cut_spline(wcut_step_source *s, wcut_curve *curve, const piece *p) {
    double u[2] = {p->parameter[0], p->parameter[1]};
    bool cuts = curve && p->has_parameters, ok = curve != NULL;

    /* without parameters the end points tell whether a piece is cut out, and where */
    if (ok && !cuts && p->has_points) {
        wcut_vec3 end[2];
        double first, last;
        wcut_curve_domain(curve, &first, &last);
        wcut_curve_eval(curve, first, 0, &end[0]);
        wcut_curve_eval(curve, last, 0, &end[1]);
        const int begins = p->forwards ? 0 : 1;
        cuts = point_distance(end[begins], p->point[0]) > p->slack ||
               point_distance(end[1 - begins], p->point[1]) > p->slack;
        for (int k = 0; cuts && ok && k < 2; k++) ok = find_parameter(s, curve, p->point[k], p->slack, &u[k]);

        /* a piece in the wrong direction would run over the seam */
        if (cuts && ok && (p->forwards ? u[0] >= u[1] : u[0] <= u[1])) {
            wcut_curves_leave_out(s->reader, "a piece over the seam of a closed spline");
            ok = false;
        }
    }

    /* cut at both parameters; the reader's refusals leave no curve behind */
    if (ok && cuts) {
        curve = wcut_curves_cut(s->reader, curve, fmin(u[0], u[1]), fmax(u[0], u[1]));
    }
    if (!ok) {
        wcut_curve_destroy(curve);
        return NULL;
    }

    return p->forwards ? curve : reversed(s, curve);
}

/* ---- any curve ---- */

/* the name of a simple instance, for people */
static void leave_curve_step_out(wcut_step_source *s, const char *body) {
    char kind[48];
    const size_t n = strcspn(body[0] == '(' ? body + 1 : body, "(");
    snprintf(kind, sizeof kind, "%.*s", (int)(n < 40 ? n : 40), body[0] == '(' ? body + 1 : body);
    wcut_curves_leave_out(s->reader, kind);
}

static wcut_curve *make(wcut_step_source *s, long id, const piece *p, int depth);

/* end k of a trimmed curve: a parameter, a point, or both; what is missing at one end is of no use at the other */
static bool read_trim(wcut_step_source *s, long id, const char *list, int k, piece *p) {
    bool has_point = false, has_parameter = false;
    for (const char *item = wcut_p21_item(list, 0); item; item = wcut_p21_next(item)) {
        long at = 0;
        if (wcut_p21_is(item, "PARAMETER_VALUE")) {
            has_parameter = wcut_p21_read_real(strchr(item, '(') + 1, &p->parameter[k]);
            if (!has_parameter) return wcut_step_refuse(s, id, "no parameter");
        } else if (wcut_p21_read_reference(item, &at)) {
            has_point = wcut_step_point(s, at, &p->point[k]);
            if (!has_point) return false;
        }
    }
    p->has_points = p->has_points && has_point;
    p->has_parameters = p->has_parameters && has_parameter;
    return true;
}

static wcut_curve *make_trimmed(wcut_step_source *s, long id, const char *list, int depth) {
    piece p = {.has_points = true, .has_parameters = true, .slack = 1e-3};
    long basis = 0;
    if (!reference(s, id, wcut_p21_item(list, 1), &basis)) return NULL;
    for (int k = 0; k < 2; k++)
        if (!read_trim(s, id, wcut_p21_item(list, 2 + k), k, &p)) return NULL;
    p.forwards = !wcut_p21_is(wcut_p21_item(list, 4), ".F.");
    if (!p.has_points && !p.has_parameters) return wcut_step_refuse(s, id, "a trimmed curve without ends"), NULL;
    return make(s, basis, &p, depth - 1);
}

/* whole where p is NULL; NULL: refused or left out */
static wcut_curve *make(wcut_step_source *s, long id, const piece *p, int depth) {
    static const piece whole = {.has_parameters = false, .forwards = true};
    static const piece whole_turn = {.has_parameters = true, .forwards = true};

    /* the instance, and a limit to nesting */
    const char *body = wcut_p21_find(&s->file, id), *list;
    long inner = 0;
    if (!body) return wcut_step_refuse(s, id, "no such instance"), NULL;
    if (depth == 0) return wcut_step_refuse(s, id, "curves nested too deep"), NULL;

    /* splines and polylines may be cut */
    if (wcut_step_is_spline(body)) return cut_spline(s, wcut_step_read_spline(s, id, body), p ? p : &whole);
    if (wcut_p21_record(body, "POLYLINE")) return cut_spline(s, wcut_step_read_polyline(s, id, body), p ? p : &whole);

    /* conics; without ends a whole turn */
    if ((list = wcut_p21_record(body, "CIRCLE")) != NULL)
        return make_curve_step_arc(s, id, list, true, p ? p : &whole_turn);
    if ((list = wcut_p21_record(body, "ELLIPSE")) != NULL)
        return make_curve_step_arc(s, id, list, false, p ? p : &whole_turn);

    /* a line has no ends of its own */
    if (p && (list = wcut_p21_record(body, "LINE")) != NULL) return make_line(s, id, list, p);
    if ((list = wcut_p21_record(body, "TRIMMED_CURVE")) != NULL) {
        /* a piece of a piece: between points on it, or, with the basis curve's parameters, a piece of that */
        if (!p) return make_trimmed(s, id, list, depth);
        if (p->has_points) {
            piece on = *p;
            on.has_parameters = false;
            return cut_spline(s, make_trimmed(s, id, list, depth), &on);
        }
        piece of = *p;
        if (wcut_p21_is(wcut_p21_item(list, 4), ".F.")) of.forwards = !of.forwards;
        return reference(s, id, wcut_p21_item(list, 1), &inner) ? make(s, inner, &of, depth - 1) : NULL;
    }

    /* curves that carry another one: the one in space counts */
    static const char *const bearer[] = {"SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE"};
    for (int k = 0; k < 3; k++)
        if ((list = wcut_p21_record(body, bearer[k])) != NULL)
            return reference(s, id, wcut_p21_item(list, 1), &inner) ? make(s, inner, p, depth - 1) : NULL;

    /* everything else is left out, with its name */
    leave_curve_step_out(s, body);

    return NULL;
}

/* ---- which curves ---- */

/* the name of an instance that has one, in the file's writing */
static const char *find_name(const char *body, size_t *length) {
    const char *list = body[0] == '(' ? wcut_p21_record(body, "REPRESENTATION_ITEM") : strchr(body, '(');
    const char *item = wcut_p21_item(list, 0);
    *length = 0;
    if (!item || *item != '\'') return "";
    *length = strcspn(item + 1, "'");
    return item + 1;
}

/* a curve into the set; false: refused */
static bool add_step_piece(wcut_step_source *s, long id, const piece *p, const char *body) {
    size_t length;
    const char *name = find_name(body, &length);
    wcut_curve *curve = make(s, id, p, DEPTH_MAX);
    if (curve) return wcut_curves_add(s->reader, curve, name, length);
    return s->reader->failure.status == WCUT_OK;
}

/* curves in a row, which grows */
typedef struct row {
    int count;
    size_t room;
    wcut_curve **curve;
} row;

static bool push(wcut_step_source *s, row *to, wcut_curve *curve) {
    if ((size_t)to->count == to->room) {
        const size_t room = to->room ? 2 * to->room : 16;
        wcut_curve **grown = wcut_grow(to->curve, room * sizeof *grown);
        if (!grown) {
            wcut_curve_destroy(curve);
            return wcut_curves_refuse_memory(s->reader);
        }
        to->curve = grown;
        to->room = room;
    }
    to->curve[to->count++] = curve;
    return true;
}

static const char *find_composite(const char *body) {
    static const char *const name[] = {"COMPOSITE_CURVE", "COMPOSITE_CURVE_ON_SURFACE", "BOUNDARY_CURVE",
                                       "OUTER_BOUNDARY_CURVE"};
    const char *list = NULL;
    for (int k = 0; k < 4 && !list; k++) list = wcut_p21_record(body, name[k]);
    return list;
}

/* the curves of a row from the first-th on the other way round */
static bool turn_curve_step_back(wcut_step_source *s, row *of, int first) {
    for (int k = first; k < of->count; k++) {
        of->curve[k] = reversed(s, of->curve[k]);
        if (!of->curve[k]) return false;
    }
    for (int a = first, b = of->count - 1; a < b; a++, b--) {
        wcut_curve *swap = of->curve[a];
        of->curve[a] = of->curve[b], of->curve[b] = swap;
    }
    return true;
}

/* the segments of a composite curve, those of composite segments among them; false: one is refused or left out */
static bool collect_curve_step(wcut_step_source *s, long id, const char *list, int depth, row *to) {
    /* the list of segments */
    const char *segments = wcut_p21_item(list, 1);
    if (wcut_p21_length(segments) < 1) return wcut_step_refuse(s, id, "no segments");
    if (depth == 0) return wcut_step_refuse(s, id, "curves nested too deep");

    /* each segment, possibly of a composite curve itself */
    for (const char *item = wcut_p21_item(segments, 0); item; item = wcut_p21_next(item)) {
        long at = 0, parent = 0;
        const int first = to->count;
        if (!reference(s, id, item, &at)) return false;
        const char *body = wcut_p21_find(&s->file, at);
        const char *segment = body ? wcut_p21_record(body, "COMPOSITE_CURVE_SEGMENT") : NULL;
        if (body && !segment) segment = wcut_p21_record(body, "REPARAMETRISED_COMPOSITE_CURVE_SEGMENT");
        if (!reference(s, at, wcut_p21_item(segment, 2), &parent)) return false;

        /* a curve, or a row of them */
        const char *of = wcut_p21_find(&s->file, parent), *nested = of ? find_composite(of) : NULL;
        if (nested) {
            if (!collect_curve_step(s, parent, nested, depth - 1, to)) return false;
        } else {
            wcut_curve *curve = make(s, parent, NULL, DEPTH_MAX);
            if (!curve || !push(s, to, curve)) return false;
        }

        /* a segment that runs against the curve is turned */
        if (wcut_p21_is(wcut_p21_item(segment, 1), ".F.") && !turn_curve_step_back(s, to, first)) return false;
    }

    return true;
}

static bool add_segments(wcut_step_source *s, long id, const char *list) {
    size_t length;
    const char *name = find_name(wcut_p21_find(&s->file, id), &length);
    row of = {0};
    if (collect_curve_step(s, id, list, DEPTH_MAX, &of))
        return wcut_curves_add_chain(s->reader, of.count, of.curve, name, length);
    for (int k = 0; k < of.count; k++) wcut_curve_destroy(of.curve[k]);
    wcut_free(of.curve);
    return s->reader->failure.status == WCUT_OK;
}

/* the curves among a geometric set's elements */
static bool add_set(wcut_step_source *s, long id, const char *list) {
    static const char *const no_curve[] = {"CARTESIAN_POINT",
                                           "AXIS2_PLACEMENT_3D",
                                           "B_SPLINE_SURFACE_WITH_KNOTS",
                                           "RECTANGULAR_TRIMMED_SURFACE",
                                           "CURVE_BOUNDED_SURFACE",
                                           "PLANE"};

    /* points, placements and surfaces of a set are no curves */
    for (const char *item = wcut_p21_item(wcut_p21_item(list, 1), 0); item; item = wcut_p21_next(item)) {
        long at = 0;
        bool is_curve = true;
        if (!reference(s, id, item, &at)) return false;
        const char *body = wcut_p21_find(&s->file, at);

        /* whatever it is, it must be there */
        if (!body) return wcut_step_refuse(s, at, "no such instance");
        for (size_t k = 0; k < sizeof no_curve / sizeof *no_curve; k++)
            is_curve = is_curve && !wcut_p21_record(body, no_curve[k]);

        /* composite curves by their segments, others whole */
        const char *composite = find_composite(body);
        if (composite ? !add_segments(s, at, composite) : is_curve && !add_step_piece(s, at, NULL, body)) return false;
    }

    return true;
}

static bool read_curve_step_vertex(wcut_step_source *s, long id, const char *item, wcut_vec3 *point) {
    long vertex = 0, at = 0;
    if (!reference(s, id, item, &vertex)) return false;
    const char *body = wcut_p21_find(&s->file, vertex);
    const char *list = body ? wcut_p21_record(body, "VERTEX_POINT") : NULL;
    return reference(s, vertex, wcut_p21_item(list, 1), &at) && wcut_step_point(s, at, point);
}

/* where an edge begins and ends on its curve, and the curve; false: refused */
static bool read_edge(wcut_step_source *s, long id, const char *list, piece *p, long *curve) {
    *p = (piece){.has_points = true, .slack = 1e-2};
    for (int k = 0; k < 2; k++)
        if (!read_curve_step_vertex(s, id, wcut_p21_item(list, 1 + k), &p->point[k])) return false;
    p->forwards = !wcut_p21_is(wcut_p21_item(list, 4), ".F.");
    return reference(s, id, wcut_p21_item(list, 3), curve);
}

static bool add_edge(wcut_step_source *s, const wcut_p21_instance *at, const char *list) {
    piece p;
    long curve = 0;
    return read_edge(s, at->id, list, &p, &curve) && add_step_piece(s, curve, &p, at->body);
}

wcut_curve *wcut_step_edge(wcut_step_source *s, long id) {
    const char *body = wcut_p21_find(&s->file, id), *list = body ? wcut_p21_record(body, "EDGE_CURVE") : NULL;
    piece p;
    long curve = 0;
    if (!list) return wcut_step_refuse(s, id, "no EDGE_CURVE"), NULL;
    return read_edge(s, id, list, &p, &curve) ? make(s, curve, &p, DEPTH_MAX) : NULL;
}

/* what is added in one place of a part: copies of it stand in the others */
static bool spread_curve_step(wcut_step_source *s, long id, int first, int places, const wcut_step_place *place) {
    /* what was added since `first` is the part */
    wcut_curve_set *set = s->reader->set;
    const int count = set->count - first;

    /* from the last place to the first, which takes the curves themselves */
    for (int p = places - 1; p >= 0; p--)
        for (int k = 0; k < count; k++) {
            wcut_curve *curve = set->curve[first + k];
            if (p > 0) {
                wcut_curve *copy = NULL;
                if (wcut_curve_create(curve->degree, curve->control_count, curve->knots, curve->control, curve->weights,
                                      &copy) != WCUT_OK)
                    return wcut_curves_refuse_memory(s->reader);
                const char *name = set->name[first + k];
                if (!wcut_step_set_in_place(s, id, &place[p], copy)) return wcut_curve_destroy(copy), false;
                if (!wcut_curves_add(s->reader, copy, name, strlen(name))) return false;
            } else if (!wcut_step_set_in_place(s, id, &place[0], curve)) {
                return false;
            }
        }

    return true;
}

/* a set in its units, wherever its representation stands; loose pieces of it become whole curves */
static bool add_part(wcut_step_source *s, long id, const char *list) {
    wcut_step_place place[WCUT_STEP_PLACES_MAX];
    const int first = s->reader->set->count;
    const long holder = wcut_step_holder(s, id);
    int places = 0;
    if (holder && !wcut_step_use_units(s, holder)) return false;
    if (!add_set(s, id, list) || !wcut_curves_join_loose(s->reader, first)) return false;
    if (!holder || s->reader->set->count == first) return true;
    return wcut_step_find_places(s, holder, place, &places) && spread_curve_step(s, id, first, places, place);
}

static bool moves_parts(const wcut_step_source *s) {
    static const char *const moves[] = {"MAPPED_ITEM", "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION"};
    for (int k = 0; k < s->file.count; k++)
        for (int m = 0; m < 2; m++)
            if (wcut_p21_record(s->file.instance[k].body, moves[m])) return true;
    return false;
}

/* ---- edges of faces: those that a representation's items lead to ---- */

/* the edges of a representation's items, in its units, wherever it stands */
static bool add_representation(wcut_step_source *s, const wcut_p21_instance *rep, unsigned char *reached) {
    wcut_step_place place[WCUT_STEP_PLACES_MAX];
    const int first = s->reader->set->count;
    int places = 0;

    /* everything that its items refer to, in this representation's units */
    if (!wcut_step_reach(s, rep->body, reached)) return false;
    if (!wcut_step_use_units(s, rep->id)) return false;
    for (int k = 0; k < s->file.count; k++) {
        const char *list = reached[k] ? wcut_p21_record(s->file.instance[k].body, "EDGE_CURVE") : NULL;
        if (list && !add_edge(s, &s->file.instance[k], list)) return false;
    }

    /* nothing was added: no places are needed */
    if (s->reader->set->count == first) return true;

    return wcut_step_find_places(s, rep->id, place, &places) && spread_curve_step(s, rep->id, first, places, place);
}

static bool add_parts(wcut_step_source *s) {
    unsigned char *reached = wcut_alloc((size_t)s->file.count + 1, 1);
    bool done = reached || wcut_curves_refuse_memory(s->reader);
    for (int k = 0; done && reached && k < s->file.count; k++)
        if (wcut_step_items(s->file.instance[k].body)) done = add_representation(s, &s->file.instance[k], reached);
    wcut_free(reached);
    return done;
}

static bool add_all(wcut_step_source *s) {
    for (int k = 0; k < s->file.count; k++) {
        const wcut_p21_instance *at = &s->file.instance[k];
        const char *list = wcut_p21_record(at->body, "GEOMETRIC_CURVE_SET");
        if (!list) list = wcut_p21_record(at->body, "GEOMETRIC_SET");
        if (list && !add_part(s, at->id, list)) return false;
    }
    if (!wcut_curves_join_loose(s->reader, 0)) return false;
    const bool are_alone = s->reader->set->count > 0 || s->reader->set->left_out > 0;
    if (are_alone) return true;
    if (moves_parts(s) || s->has_several) return add_parts(s);
    for (int k = 0; k < s->file.count; k++) {
        const char *list = wcut_p21_record(s->file.instance[k].body, "EDGE_CURVE");
        if (list && !add_edge(s, &s->file.instance[k], list)) return false;
    }
    return true;
}

bool wcut_curves_fill_step(wcut_curve_reader *r, char *text, size_t length) {
    wcut_step_source s = {.reader = r};
    const bool done = wcut_p21_open(r, text, length, &s.file) && wcut_step_units(&s) && add_all(&s);
    wcut_p21_close(&s.file);
    return done;
}
