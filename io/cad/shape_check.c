/* Shapes as writers of exact geometry ask for them: finite, of a valid degree, with knots that make a domain, closed. */
#include "io/cad/shape_check.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>

#include "base/fail.h"

static bool is_shape_sound(double x) { return fabs(x) <= 1e12; /* false for nan, too */ }

static bool are_points(const wcut_vec3 *p, size_t count) {
    for (size_t k = 0; k < count; k++)
        if (!is_shape_sound(p[k].x) || !is_shape_sound(p[k].y) || !is_shape_sound(p[k].z)) return false;
    return true;
}

static bool are_weights(const double *w, size_t count) {
    for (size_t k = 0; w && k < count; k++)
        if (!(w[k] > 0) || !is_shape_sound(w[k])) return false;
    return true;
}

static bool are_knots(int degree, int count, const double *knot) {
    if (degree < 1 || degree > WCUT_DEGREE_MAX || count <= degree || !knot) return false;
    for (int k = 0; k <= count + degree; k++)
        if (!is_shape_sound(knot[k]) || (k > 0 && knot[k] < knot[k - 1])) return false;
    return knot[degree] < knot[count];
}

static const char *judge_curve(const wcut_curve *c) {
    if (!are_knots(c->degree, c->control_count, c->knots)) return "a degree or knots that make no curve";
    if (!c->control || !are_points(c->control, (size_t)c->control_count)) return "a control point that is not finite";
    return are_weights(c->weights, (size_t)c->control_count) ? NULL : "a weight that is not positive";
}

static const char *judge_surface(const wcut_surface *s) {
    if (!are_knots(s->degree_u, s->count_u, s->knots_u) || !are_knots(s->degree_v, s->count_v, s->knots_v) ||
        s->count_u > INT_MAX / s->count_v)
        return "a degree or knots that make no surface";
    const size_t count = (size_t)s->count_u * (size_t)s->count_v;
    if (!s->control || !are_points(s->control, count)) return "a control point that is not finite";
    return are_weights(s->weights, count) ? NULL : "a weight that is not positive";
}

/* ---- solids ---- */

static const char *judge_edges(const wcut_brep *b) {
    for (int k = 0; k < b->edge_count; k++) {
        const wcut_brep_edge *e = &b->edge[k];
        if (e->from < 0 || e->from >= b->vertex_count || e->to < 0 || e->to >= b->vertex_count || e->from == e->to)
            return "an edge without two vertices";
        const char *cause = e->curve ? judge_curve(e->curve) : NULL;
        if (cause) return cause;
    }
    return NULL;
}

/* each coedge begins where the one before it ends */
static bool is_shape_closed(const wcut_brep *b, const wcut_brep_loop *loop) {
    for (int k = 0; k < loop->coedge_count; k++) {
        const wcut_brep_coedge *at = &b->coedge[loop->first_coedge + k];
        const wcut_brep_coedge *next = &b->coedge[loop->first_coedge + (k + 1) % loop->coedge_count];
        const int end = at->reversed ? b->edge[at->edge].from : b->edge[at->edge].to;
        if (end != (next->reversed ? b->edge[next->edge].to : b->edge[next->edge].from)) return false;
    }
    return true;
}

static const char *judge_loops(const wcut_brep *b) {
    for (int k = 0; k < b->coedge_count; k++)
        if (b->coedge[k].edge < 0 || b->coedge[k].edge >= b->edge_count) return "a loop of edges that are not there";
    for (int k = 0; k < b->loop_count; k++) {
        const wcut_brep_loop *l = &b->loop[k];
        if (l->first_coedge < 0 || l->coedge_count < 1 || l->coedge_count > b->coedge_count - l->first_coedge)
            return "a loop without edges";
        if (!is_shape_closed(b, l)) return "a loop that is open";
    }
    return NULL;
}

static const char *judge_faces(const wcut_brep *b) {
    for (int k = 0; k < b->face_count; k++) {
        const wcut_brep_face *f = &b->face[k];
        if (f->first_loop < 0 || f->loop_count < 1 || f->loop_count > b->loop_count - f->first_loop)
            return "a face without a loop";
        const char *cause = f->surface ? judge_surface(f->surface) : NULL;
        if (cause) return cause;
        const double size = sqrt(f->normal.x * f->normal.x + f->normal.y * f->normal.y + f->normal.z * f->normal.z);
        if (!f->surface && (!are_points(&f->origin, 1) || !(fabs(size - 1) < 1e-9)))
            return "a plane without a point or a normal of length 1";
    }
    return NULL;
}

static const char *judge_solid(const wcut_brep *b) {
    if (b->vertex_count < 1 || b->edge_count < 1 || b->coedge_count < 1 || b->loop_count < 1 || b->face_count < 1 ||
        !b->vertex || !b->edge || !b->coedge || !b->loop || !b->face)
        return "a solid without faces";
    if (!are_points(b->vertex, (size_t)b->vertex_count)) return "a vertex that is not finite";
    const char *cause = judge_edges(b);
    if (!cause) cause = judge_loops(b);
    return cause ? cause : judge_faces(b);
}

/* ---- any ---- */

static const char *judge_shape(const wcut_shape *p) {
    if (!p->name) return "no name";
    if ((p->solid != NULL) + (p->surface != NULL) + (p->curve != NULL) != 1)
        return "not exactly one of solid, surface and curve";
    return p->solid ? judge_solid(p->solid) : p->surface ? judge_surface(p->surface) : judge_curve(p->curve);
}

wcut_status wcut_shapes_check(int count, const wcut_shape *shape, const char *path, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    if (!path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "the path of an output is NULL");
    wcut_quote(name, path, WCUT_LABEL_MAX, 1);
    if (count < 1 || !shape) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found no shape to write", name);
    for (int k = 0; k < count; k++) {
        const char *cause = judge_shape(&shape[k]);
        if (cause) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: shape %d: found %s", name, k, cause);
    }
    return WCUT_OK;
}
