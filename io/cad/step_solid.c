/* Solids and faces as STEP instances (ISO 10303-42): shared vertices and edges, loops, planes, border curves in the
   parameters of the spline faces that they bound. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/cad/step_shape.h"

/* the numbers that a solid's pieces were given */
typedef struct pieces {
    const wcut_brep *b;
    wcut_id plane_context;
    bool named;                       /* faces have the names of their parts */
    wcut_id *vertex, *edge, *surface; /* of each vertex, edge and face */
    int *face;                        /* two of each edge, -1 where there is none: the spline faces it bounds */
} pieces;

/* ---- planes and lines ---- */

static wcut_vec3 unit(wcut_vec3 v) {
    const double size = sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return (wcut_vec3){v.x / size, v.y / size, v.z / size};
}

/* a direction across n: that axis of the three which is most across it, straightened */
static wcut_vec3 across(wcut_vec3 n) {
    const double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    const wcut_vec3 a = x <= y && x <= z ? (wcut_vec3){1, 0, 0} : y <= z ? (wcut_vec3){0, 1, 0} : (wcut_vec3){0, 0, 1};
    const double d = a.x * n.x + a.y * n.y + a.z * n.z;
    return unit((wcut_vec3){a.x - d * n.x, a.y - d * n.y, a.z - d * n.z});
}

static wcut_id put_plane(wcut_part21 *p, wcut_vec3 origin, wcut_vec3 normal) {
    const wcut_id at = wcut_p21_point(p, origin), axis = wcut_p21_direction(p, normal);
    const wcut_id ref = wcut_p21_direction(p, across(normal));
    const wcut_id place = wcut_p21_put(p, "AXIS2_PLACEMENT_3D('',#%ld,#%ld,#%ld)", at, axis, ref);
    return wcut_p21_put(p, "PLANE('',#%ld)", place);
}

static wcut_id put_step_solid_line(wcut_part21 *p, wcut_vec3 from, wcut_vec3 to) {
    const wcut_id at = wcut_p21_point(p, from);
    const wcut_id along = wcut_p21_direction(p, unit((wcut_vec3){to.x - from.x, to.y - from.y, to.z - from.z}));
    const wcut_id vector = wcut_p21_put(p, "VECTOR('',#%ld,1.)", along);
    return wcut_p21_put(p, "LINE('',#%ld,#%ld)", at, vector);
}

/* ---- edges ---- */

/* Whether a curve is the surface's border `side` (0: v first, 1: u last, 2: v last, 3: u first), pole by pole and knot
   by knot: then its parameter is the surface's. */
static bool is_border(const wcut_curve *c, const wcut_surface *s, int side) {
    const bool along_u = side % 2 == 0;
    const int degree = along_u ? s->degree_u : s->degree_v, count = along_u ? s->count_u : s->count_v;
    const double *knots = along_u ? s->knots_u : s->knots_v;
    if (c->degree != degree || c->control_count != count || (c->weights != NULL) != (s->weights != NULL)) return false;
    if (memcmp(c->knots, knots, (size_t)(count + degree + 1) * sizeof *knots) != 0) return false;
    const size_t columns = (size_t)s->count_u, last_row = columns * (size_t)(s->count_v - 1);
    const size_t first = side == 1 ? columns - 1 : side == 2 ? last_row : 0, step = along_u ? 1 : columns;
    for (int k = 0; k < count; k++) {
        const size_t at = first + (size_t)k * step;
        const wcut_vec3 a = c->control[k], b = s->control[at];
        if (a.x != b.x || a.y != b.y || a.z != b.z || (c->weights && c->weights[k] != s->weights[at])) return false;
    }
    return true;
}

/* the straight line in the surface's parameters that a border is; 0 where the curve is none */
static wcut_id put_pcurve(wcut_part21 *p, const wcut_curve *c, const wcut_surface *s, wcut_id surface,
                          wcut_id context) {
    /* the side of the surface that the curve runs along, and its parameter there */
    int side = 0;
    while (side < 4 && !is_border(c, s, side)) side++;
    if (side == 4) return 0;
    const bool along_u = side % 2 == 0;
    const double at = side == 0   ? s->knots_v[s->degree_v]
                      : side == 1 ? s->knots_u[s->count_u]
                      : side == 2 ? s->knots_v[s->count_v]
                                  : s->knots_u[s->degree_u];

    /* a straight line in the plane of parameters */
    const double start[2] = {along_u ? 0 : at, along_u ? at : 0};
    const wcut_id point = wcut_p21_begin(p);
    wcut_text_print(p->text, "CARTESIAN_POINT('',");
    wcut_p21_reals(p, start, 2, 1);
    wcut_text_print(p->text, ");\n");

    /* the other parameter runs from 0 along the side */
    const wcut_id direction = wcut_p21_put(p, "DIRECTION('',%s)", along_u ? "(1.,0.)" : "(0.,1.)");
    const wcut_id vector = wcut_p21_put(p, "VECTOR('',#%ld,1.)", direction);
    const wcut_id line = wcut_p21_put(p, "LINE('',#%ld,#%ld)", point, vector);
    const wcut_id flat = wcut_p21_put(p, "DEFINITIONAL_REPRESENTATION('',(#%ld),#%ld)", line, context);

    return wcut_p21_put(p, "PCURVE('',#%ld,#%ld)", surface, flat);
}

/* a spline edge: its curve, with those pcurves that it has */
static wcut_id put_spline(wcut_part21 *p, const pieces *n, int edge) {
    const wcut_curve *c = n->b->edge[edge].curve;
    const wcut_id curve = wcut_step_curve(p, "", c);
    wcut_id on[2];
    int count = 0;
    for (int k = 0; k < 2; k++) {
        const int face = n->face[2 * edge + k];
        if (face < 0) continue;
        on[count] = put_pcurve(p, c, n->b->face[face].surface, n->surface[face], n->plane_context);
        count += on[count] != 0;
    }
    if (count == 0) return curve;
    if (count == 1) return wcut_p21_put(p, "SURFACE_CURVE('',#%ld,(#%ld),.CURVE_3D.)", curve, on[0]);
    return wcut_p21_put(p, "SURFACE_CURVE('',#%ld,(#%ld,#%ld),.CURVE_3D.)", curve, on[0], on[1]);
}

static void put_edges(wcut_part21 *p, pieces *n) {
    const wcut_brep *b = n->b;
    for (int k = 0; k < b->edge_count; k++) {
        const wcut_brep_edge *e = &b->edge[k];
        const wcut_id curve =
            e->curve ? put_spline(p, n, k) : put_step_solid_line(p, b->vertex[e->from], b->vertex[e->to]);
        n->edge[k] = wcut_p21_put(p, "EDGE_CURVE('',#%ld,#%ld,#%ld,.T.)", n->vertex[e->from], n->vertex[e->to], curve);
    }
}

/* ---- faces ---- */

static void note_faces(pieces *n) {
    const wcut_brep *b = n->b;
    for (int k = 0; k < 2 * b->edge_count; k++) n->face[k] = -1;
    for (int f = 0; f < b->face_count; f++) {
        const wcut_brep_loop *l = b->loop + b->face[f].first_loop;
        for (int k = 0; b->face[f].surface && k < l->coedge_count; k++) {
            int *face = n->face + 2 * (size_t)b->coedge[l->first_coedge + k].edge;
            face[face[0] >= 0] = f;
        }
    }
}

static wcut_id put_loop(wcut_part21 *p, const pieces *n, const wcut_brep_loop *l) {
    const wcut_id first = p->last + 1;
    for (int k = 0; k < l->coedge_count; k++) {
        const wcut_brep_coedge *c = &n->b->coedge[l->first_coedge + k];
        wcut_p21_put(p, "ORIENTED_EDGE('',*,*,#%ld,%s)", n->edge[c->edge], c->reversed ? ".F." : ".T.");
    }
    const wcut_id loop = wcut_p21_begin(p);
    wcut_text_print(p->text, "EDGE_LOOP('',");
    wcut_p21_references(p, first, l->coedge_count, 1);
    wcut_text_print(p->text, ");\n");
    return loop;
}

/* what a face is, for who looks at it in a CAD program */
static const char *part_word(wcut_brep_part part) {
    static const char *const word[] = {"cut face",   "side x = 0", "side x = W", "side y = 0", "side y = L",
                                       "outer face", "key flank",  "key end",    "lug",        "frame"};
    return (unsigned)part < sizeof word / sizeof *word ? word[part] : "";
}

static wcut_id put_step_solid_face(wcut_part21 *p, const pieces *n, int face) {
    const wcut_brep_face *f = &n->b->face[face];
    const wcut_brep_loop *loop = n->b->loop + f->first_loop;
    for (int k = 0; k < f->loop_count; k++) put_loop(p, n, loop + k);
    /* the bounds together, so that their numbers follow each other: the holes, the last of them first, then the outer
       one; before each loop stand its edges */
    wcut_id at = p->last;
    const wcut_id first = p->last + 1;
    for (int k = f->loop_count - 1; k >= 0; k--) {
        wcut_p21_put(p, k == 0 ? "FACE_OUTER_BOUND('',#%ld,.T.)" : "FACE_BOUND('',#%ld,.T.)", at);
        at -= loop[k].coedge_count + 1;
    }
    const wcut_id id = wcut_p21_begin(p);
    wcut_text_print(p->text, "ADVANCED_FACE('%s',", n->named ? part_word(f->part) : "");
    wcut_p21_references(p, first, f->loop_count, 1);
    wcut_text_print(p->text, ",#%ld,%s);\n", n->surface[face], !f->surface || f->same_sense ? ".T." : ".F.");
    return id;
}

/* vertices, surfaces, edges, then the faces: their numbers go into face */
static void put_pieces(wcut_part21 *p, pieces *n, wcut_id *face) {
    const wcut_brep *b = n->b;
    for (int k = 0; k < b->vertex_count; k++)
        n->vertex[k] = wcut_p21_put(p, "VERTEX_POINT('',#%ld)", wcut_p21_point(p, b->vertex[k]));
    for (int k = 0; k < b->face_count; k++) {
        const wcut_brep_face *f = &b->face[k];
        n->surface[k] = f->surface ? wcut_step_surface(p, "", f->surface) : put_plane(p, f->origin, f->normal);
    }
    note_faces(n);
    put_edges(p, n);
    for (int k = 0; k < b->face_count; k++) face[k] = put_step_solid_face(p, n, k);
}

/* A shell of all faces; 0: no memory. face: room for the faces' numbers, with names of their parts; NULL: neither. */
static wcut_id put_shell(wcut_part21 *p, const wcut_brep *b, const char *kind, wcut_id plane_context, wcut_id *face) {
    const size_t vertices = (size_t)b->vertex_count, edges = (size_t)b->edge_count, faces = (size_t)b->face_count;
    wcut_id *id = wcut_alloc(vertices + edges + 2 * faces, sizeof *id);
    int *beside = wcut_alloc(2 * edges, sizeof *beside);
    wcut_id shell = 0;
    if (id && beside) {
        pieces n = {b, plane_context, face != NULL, id, id + vertices, id + vertices + edges, beside};
        wcut_id *written = id + vertices + edges + faces;
        put_pieces(p, &n, written);
        shell = wcut_p21_begin(p);
        wcut_text_print(p->text, "%s('',", kind);
        for (size_t k = 0; k < faces; k++)
            wcut_text_print(p->text, "%s#%ld", k == 0 ? "(" : k % 8 ? "," : ",\n", written[k]);
        wcut_text_print(p->text, "));\n");
        if (face) memcpy(face, written, faces * sizeof *face);
    }
    free(beside);
    free(id);
    return shell;
}

/* KIND('name',#shell) or KIND('name',(#shell)) */
static wcut_id put_named(wcut_part21 *p, const char *kind, const char *name, bool is_list, wcut_id shell) {
    const wcut_id id = wcut_p21_begin(p);
    wcut_text_print(p->text, "%s(", kind);
    wcut_p21_string(p, name);
    wcut_text_print(p->text, is_list ? ",(#%ld));\n" : ",#%ld);\n", shell);
    return id;
}

/* ---- colours ---- */

/* a style of presentation: both sides filled with a colour */
static wcut_id put_step_colour(wcut_part21 *p, unsigned rgb) {
    const wcut_id colour = wcut_p21_begin(p);
    wcut_text_print(p->text, "COLOUR_RGB('',");
    for (int k = 16; k >= 0; k -= 8) {
        wcut_p21_real(p, (rgb >> k & 0xff) / 255.0);
        wcut_text_print(p->text, k ? "," : ");\n");
    }
    const wcut_id fill = wcut_p21_put(p, "FILL_AREA_STYLE_COLOUR('',#%ld)", colour);
    const wcut_id area = wcut_p21_put(p, "FILL_AREA_STYLE('',(#%ld))", fill);
    const wcut_id surface = wcut_p21_put(p, "SURFACE_STYLE_FILL_AREA(#%ld)", area);
    const wcut_id side = wcut_p21_put(p, "SURFACE_SIDE_STYLE('',(#%ld))", surface);
    const wcut_id usage = wcut_p21_put(p, "SURFACE_STYLE_USAGE(.BOTH.,#%ld)", side);
    return wcut_p21_put(p, "PRESENTATION_STYLE_ASSIGNMENT((#%ld))", usage);
}

static bool is_key(wcut_brep_part part) {
    return part == WCUT_BREP_PART_KEY_FLANK || part == WCUT_BREP_PART_KEY_TIP || part == WCUT_BREP_PART_LUG;
}

/* the solid in its colour, each face in that of its part */
static void put_styles(wcut_part21 *p, const wcut_shape *shape, wcut_id solid, const wcut_id *face, wcut_id space) {
    const wcut_id body = put_step_colour(p, shape->colour), cut = put_step_colour(p, shape->cut_colour);
    const wcut_id key = put_step_colour(p, shape->key_colour);
    const wcut_id first = wcut_p21_put(p, "STYLED_ITEM('',(#%ld),#%ld)", body, solid);
    for (int k = 0; k < shape->solid->face_count; k++) {
        const wcut_brep_part part = shape->solid->face[k].part;
        wcut_p21_put(p, "STYLED_ITEM('',(#%ld),#%ld)",
                     part == WCUT_BREP_PART_CUT ? cut
                     : is_key(part)             ? key
                                                : body,
                     face[k]);
    }
    wcut_p21_begin(p);
    wcut_text_print(p->text, "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',");
    wcut_p21_references(p, first, shape->solid->face_count + 1, 1);
    wcut_text_print(p->text, ",#%ld);\n", space);
}

wcut_id wcut_step_solid(wcut_part21 *p, const wcut_shape *shape, wcut_id plane_context, wcut_id space_context) {
    wcut_id *face = NULL, solid = 0;
    if (shape->coloured) {
        face = wcut_alloc((size_t)shape->solid->face_count, sizeof *face);
        if (!face) return 0;
    }
    const wcut_id shell = put_shell(p, shape->solid, "CLOSED_SHELL", plane_context, face);
    if (shell) solid = put_named(p, "MANIFOLD_SOLID_BREP", shape->name, false, shell);
    if (solid && face) put_styles(p, shape, solid, face, space_context);
    free(face);
    return solid;
}

/* ---- a surface by itself: a face with its border ---- */

static bool is_clamped(int degree, int count, const double *knot) {
    return knot[0] == knot[degree] && knot[count] == knot[count + degree];
}

bool wcut_step_has_border(const wcut_surface *s) {
    const size_t row = (size_t)s->count_u, last = row * (size_t)(s->count_v - 1);
    const wcut_vec3 corner[4] = {s->control[0], s->control[row - 1], s->control[last], s->control[last + row - 1]};
    if (!is_clamped(s->degree_u, s->count_u, s->knots_u) || !is_clamped(s->degree_v, s->count_v, s->knots_v))
        return false;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < i; j++)
            if (corner[i].x == corner[j].x && corner[i].y == corner[j].y && corner[i].z == corner[j].z) return false;
    return true;
}

/* the border `side` as is_border counts them; the first and third are views, the others' columns go into room */
static wcut_curve border(const wcut_surface *s, int side, wcut_vec3 *room, double *weight_room) {
    const size_t columns = (size_t)s->count_u, rows = (size_t)s->count_v;
    const size_t first = side == 1 ? columns - 1 : side == 2 ? columns * (rows - 1) : 0;
    if (side % 2 == 0)
        return (wcut_curve){s->degree_u, s->count_u, s->knots_u, s->control + first,
                            s->weights ? s->weights + first : NULL};
    for (size_t j = 0; j < rows; j++) {
        room[j] = s->control[first + j * columns];
        if (s->weights) weight_room[j] = s->weights[first + j * columns];
    }
    return (wcut_curve){s->degree_v, s->count_v, s->knots_v, room, s->weights ? weight_room : NULL};
}

wcut_id wcut_step_shell(wcut_part21 *p, const char *name, const wcut_surface *s, wcut_id plane_context) {
    const size_t rows = (size_t)s->count_v, row = (size_t)s->count_u, last = row * (rows - 1);
    wcut_vec3 *room = wcut_alloc(2 * rows, sizeof *room);
    double *weight = wcut_alloc(2 * rows, sizeof *weight);
    wcut_id id = 0;

    /* the four borders as edges of one face */
    if (room && weight) {
        wcut_curve side[4];
        for (int k = 0; k < 4; k++) side[k] = border(s, k, room + (k == 3 ? rows : 0), weight + (k == 3 ? rows : 0));

        /* corners in the order of the loop; the last two edges are run against their direction */
        wcut_vec3 vertex[4] = {s->control[0], s->control[row - 1], s->control[last + row - 1], s->control[last]};
        wcut_brep_edge edge[4] = {{0, 1, &side[0]}, {1, 2, &side[1]}, {3, 2, &side[2]}, {0, 3, &side[3]}};
        wcut_brep_coedge coedge[4] = {{0, 0}, {1, 0}, {2, 1}, {3, 1}};
        wcut_brep_loop loop = {0, 4};
        wcut_brep_face face = {.surface = (wcut_surface *)s, .same_sense = 1, .loop_count = 1};

        /* four vertices, four edges, one loop, one face */
        const wcut_brep sheet = {4, 4, 4, 1, 1, vertex, edge, coedge, &loop, &face};
        const wcut_id shell = put_shell(p, &sheet, "OPEN_SHELL", plane_context, NULL);
        if (shell) id = put_named(p, "SHELL_BASED_SURFACE_MODEL", name, true, shell);
    }

    free(weight);
    free(room);
    return id;
}
