/* Topology of a half by index. Everything is laid out for the lower half; the upper one is the same, mirrored: every
   loop runs the other way. */
#include "solid/solid_brep.h"

#include <stdbool.h>
#include <stdlib.h>
#include <wirecut/edit.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "solid/keys.h"

enum {
    CORNERS = 4,
    BLOCK_VERTICES = 8,
    BLOCK_EDGES = 12,
    BLOCK_FACES = 6,
    BLOCK_COEDGES = 24,
    KEY_VERTICES = 4, /* on the face at angles 0 and pi, then on the tip */
    KEY_EDGES = 6,    /* two arcs on the face, two on the tip, two straight up the flank */
    KEY_FACES = 3,
    KEY_LOOPS = 4, /* the hole, two flanks, the tip */
    KEY_COEDGES = 12,
    LUG_VERTICES = 8, /* around the face with the key, then around the one opposite */
    LUG_EDGES = 12,   /* around the face with the key, across, around the one opposite */
    LUG_FACES = 5,
    LUG_LOOPS = 6, /* the hole in the block's side, five faces */
    LUG_COEDGES = 24,
    ARC_DEGREE = 3,
    ARC_CONTROL = 4
};

/* half a circle as one rational cubic */
static const double arc_knots[ARC_CONTROL + 4] = {0, 0, 0, 0, 1, 1, 1, 1};
static const double arc_x[2][ARC_CONTROL] = {{1, 1, -1, -1}, {-1, -1, 1, 1}};
static const double arc_y[2][ARC_CONTROL] = {{0, 2, 2, 0}, {0, -2, -2, 0}};
static const double arc_weight[ARC_CONTROL] = {1, 1.0 / 3, 1.0 / 3, 1};
static const double line_knots[4] = {0, 0, 1, 1};

void wcut_brep_destroy(wcut_brep *brep) {
    if (!brep) return;
    for (int k = 0; brep->edge && k < brep->edge_count; k++) wcut_curve_destroy(brep->edge[k].curve);
    for (int k = 0; brep->face && k < brep->face_count; k++) wcut_surface_destroy(brep->face[k].surface);
    wcut_free(brep->vertex);
    wcut_free(brep->edge);
    wcut_free(brep->coedge);
    wcut_free(brep->loop);
    wcut_free(brep->face);
    wcut_free(brep);
}

static wcut_status brep_new(int keys, int lugs, wcut_brep **brep) {
    wcut_brep *b = wcut_alloc(1, sizeof *b);
    if (!b) return WCUT_NO_MEMORY;
    const size_t all = (size_t)keys + (size_t)lugs, boxes = (size_t)lugs;
    b->vertex_count = BLOCK_VERTICES + KEY_VERTICES * (keys + lugs) + LUG_VERTICES * lugs;
    b->edge_count = BLOCK_EDGES + KEY_EDGES * (keys + lugs) + LUG_EDGES * lugs;
    b->vertex = wcut_alloc((size_t)b->vertex_count, sizeof *b->vertex);
    b->edge = wcut_alloc((size_t)b->edge_count, sizeof *b->edge);
    b->coedge = wcut_alloc(BLOCK_COEDGES + KEY_COEDGES * all + LUG_COEDGES * boxes, sizeof *b->coedge);
    b->loop = wcut_alloc(BLOCK_FACES + KEY_LOOPS * all + LUG_LOOPS * boxes, sizeof *b->loop);
    b->face = wcut_alloc(BLOCK_FACES + KEY_FACES * all + LUG_FACES * boxes, sizeof *b->face);
    if (b->vertex && b->edge && b->coedge && b->loop && b->face) {
        *brep = b;
        return WCUT_OK;
    }
    wcut_brep_destroy(b);
    return WCUT_NO_MEMORY;
}

/* ---- faces and loops, in the order in which they are added ---- */

static void add_brep_face(wcut_brep *b, bool upper, wcut_brep_part part, wcut_surface *surface, wcut_vec3 origin,
                          wcut_vec3 normal) {
    b->face[b->face_count++] = (wcut_brep_face){.part = part,
                                                .surface = surface,
                                                .same_sense = !surface || !upper,
                                                .origin = origin,
                                                .normal = normal,
                                                .first_loop = b->loop_count};
}

/* A loop of the last face: coded[k] is edge + 1, negative where it is run through backwards. */
static void add_loop(wcut_brep *b, bool upper, int count, const int *coded) {
    b->loop[b->loop_count++] = (wcut_brep_loop){b->coedge_count, count};
    b->face[b->face_count - 1].loop_count++;
    for (int k = 0; k < count; k++) {
        const int c = upper ? -coded[count - 1 - k] : coded[k];
        b->coedge[b->coedge_count++] = (wcut_brep_coedge){.edge = abs(c) - 1, .reversed = c < 0};
    }
}

/* ---- the block ---- */

/* the k-th corner of a patch, around */
static wcut_vec3 patch_corner(const wcut_surface *patch, int k) {
    const ptrdiff_t last_row = (ptrdiff_t)(patch->count_v - 1) * patch->count_u;
    const ptrdiff_t corner[CORNERS] = {0, patch->count_u - 1, last_row + patch->count_u - 1, last_row};
    return patch->control[corner[k]];
}

/* the k-th border of a patch, from corner to corner as edges of the block run */
static wcut_status patch_border(const wcut_surface *patch, int k, wcut_curve **curve) {
    double first[2], last[2];
    wcut_surface_domain(patch, first, last);
    const wcut_direction along = k % 2 ? WCUT_DIRECTION_V : WCUT_DIRECTION_U;
    const double at = k == 0 ? first[1] : k == 1 ? last[0] : k == 2 ? last[1] : first[0];
    return wcut_surface_iso_curve(patch, along, at, curve);
}

/* corners of the patch, around; below or above them those of the face that is not cut, or of the second patch */
static void add_block_vertices(wcut_brep *b, const wcut_surface *patch, const wcut_surface *second, double level) {
    for (int k = 0; k < CORNERS; k++) {
        b->vertex[k] = patch_corner(patch, k);
        b->vertex[CORNERS + k] = second ? patch_corner(second, k) : vec3(b->vertex[k].x, b->vertex[k].y, level);
    }
}

/* borders of the patch, then the uprights, then the edges opposite, as the borders run */
static wcut_status add_block_edges(wcut_brep *b, const wcut_surface *patch, const wcut_surface *second) {
    const int end[CORNERS][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}};
    wcut_status status = WCUT_OK;
    for (int k = 0; k < CORNERS && status == WCUT_OK; k++) {
        b->edge[k] = (wcut_brep_edge){.from = end[k][0], .to = end[k][1]};
        b->edge[CORNERS + k] = (wcut_brep_edge){.from = k, .to = CORNERS + k};
        b->edge[2 * CORNERS + k] = (wcut_brep_edge){.from = CORNERS + end[k][0], .to = CORNERS + end[k][1]};
        status = patch_border(patch, k, &b->edge[k].curve);
        if (status == WCUT_OK && second) status = patch_border(second, k, &b->edge[2 * CORNERS + k].curve);
    }
    return status;
}

static wcut_status copy_surface(const wcut_surface *s, wcut_surface **copy) {
    return wcut_surface_create(s->degree_u, s->degree_v, s->count_u, s->count_v, s->knots_u, s->knots_v, s->control,
                               s->weights, copy);
}

/* first edge of the k-th lug's box; its cone or pocket follows it */
static int lug_edge(int keys, int k) { return BLOCK_EDGES + KEY_EDGES * keys + (LUG_EDGES + KEY_EDGES) * k; }
static int lug_vertex(int keys, int k) {
    return BLOCK_VERTICES + KEY_VERTICES * keys + (LUG_VERTICES + KEY_VERTICES) * k;
}

/* the holes that lugs make in a side, which is the face added last */
static void add_lug_holes(wcut_brep *b, bool upper, int side, int keys, int lugs, const wcut_lug *lug) {
    for (int k = 0; k < lugs; k++) {
        const int e = lug_edge(keys, k) + 1, hole[4] = {-e, e + 4, e + 8, -(e + 5)};
        if (lug[k].side == side) add_loop(b, upper, 4, hole);
    }
}

/* the face opposite: flat, or the second patch, whose normal points into the solid */
static wcut_status add_opposite_face(wcut_brep *b, bool upper, const wcut_surface *second) {
    static const int opposite[4] = {12, 11, -10, -9};
    wcut_surface *copy = NULL;
    const wcut_status status = second ? copy_surface(second, &copy) : WCUT_OK;
    if (status != WCUT_OK) return status;
    add_brep_face(b, upper, WCUT_BREP_PART_OPPOSITE, copy, b->vertex[CORNERS], vec3(0, 0, upper ? 1 : -1));
    if (copy) b->face[b->face_count - 1].same_sense = upper;
    add_loop(b, upper, 4, opposite);
    return WCUT_OK;
}

static wcut_status add_block_faces(wcut_brep *b, bool upper, const wcut_surface *patch, const wcut_surface *second,
                                   int keys, int lugs, const wcut_lug *lug) {
    static const int cut[4] = {1, 2, -3, -4};
    static const int side[4][4] = {{-12, -5, 4, 8}, {10, -7, -2, 6}, {9, -6, -1, 5}, {-11, -8, 3, 7}};
    wcut_surface *copy;
    const wcut_status status = copy_surface(patch, &copy);
    if (status != WCUT_OK) return status;
    add_brep_face(b, upper, WCUT_BREP_PART_CUT, copy, vec3(0, 0, 0), vec3(0, 0, 0));
    add_loop(b, upper, 4, cut);
    const wcut_vec3 normal[4] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}};
    for (int k = 0; k < 4; k++) { /* x low, x high, y low, y high: their planes pass two opposite corners */
        add_brep_face(b, upper, WCUT_BREP_PART_SIDE_X0 + k, NULL, b->vertex[CORNERS + (k % 2 ? 2 : 0)], normal[k]);
        add_loop(b, upper, 4, side[k]);
        add_lug_holes(b, upper, k, keys, lugs, lug);
    }
    return add_opposite_face(b, upper, second);
}

/* ---- keys ---- */

static void arc_control(const wcut_key *key, int half, double radius, double z, wcut_vec3 *control, double *weight) {
    for (int i = 0; i < ARC_CONTROL; i++) {
        control[i] = vec3(key->x + radius * arc_x[half][i], key->y + radius * arc_y[half][i], z);
        weight[i] = arc_weight[i];
    }
}

/* vertices from v on, arcs and lines from e on; the flank from angle 0 to pi is half 0 */
static wcut_status add_key_edges(wcut_brep *b, int v, int e, const wcut_key *key, double level) {
    const double radius[2] = {key->radius, key->tip_radius}, z[2] = {level, level + wcut_key_rise(key)};
    for (int end = 0; end < 2; end++)
        for (int half = 0; half < 2; half++) {
            wcut_vec3 control[ARC_CONTROL];
            double weight[ARC_CONTROL];
            arc_control(key, half, radius[end], z[end], control, weight);
            b->vertex[v + 2 * end + half] = control[0];
            wcut_brep_edge *arc = &b->edge[e + 2 * end + half];
            *arc = (wcut_brep_edge){.from = v + 2 * end + half, .to = v + 2 * end + 1 - half};
            const wcut_status status =
                wcut_curve_create(ARC_DEGREE, ARC_CONTROL, arc_knots, control, weight, &arc->curve);
            if (status != WCUT_OK) return status;
        }
    for (int half = 0; half < 2; half++) b->edge[e + 4 + half] = (wcut_brep_edge){.from = v + half, .to = v + 2 + half};
    return WCUT_OK;
}

/* half a cone: u around, v from the face to the tip; its border is a loop the other way round */
static wcut_status add_key_flank(wcut_brep *b, bool upper, int half, int e, const wcut_key *key, double level) {
    wcut_vec3 control[2 * ARC_CONTROL];
    double weight[2 * ARC_CONTROL];
    arc_control(key, half, key->radius, level, control, weight);
    arc_control(key, half, key->tip_radius, level + wcut_key_rise(key), control + ARC_CONTROL, weight + ARC_CONTROL);
    wcut_surface *flank;
    const wcut_status status =
        wcut_surface_create(ARC_DEGREE, 1, ARC_CONTROL, 2, arc_knots, line_knots, control, weight, &flank);
    if (status != WCUT_OK) return status;
    add_brep_face(b, !upper, WCUT_BREP_PART_KEY_FLANK, flank, vec3(0, 0, 0), vec3(0, 0, 0));
    const int around[4] = {e + 1 + half, e + 5 + 1 - half, -(e + 3 + half), -(e + 5 + half)};
    add_loop(b, !upper, 4, around);
    return WCUT_OK;
}

/* the edges of a key and its hole, which belongs to the face that was added last */
static wcut_status add_key_hole(wcut_brep *b, bool upper, int v, int e, const wcut_key *key, double level) {
    const int hole[2] = {e + 1, e + 2};
    const wcut_status status = add_key_edges(b, v, e, key, level);
    if (status == WCUT_OK) add_loop(b, upper, 2, hole);
    return status;
}

/* its flank and its end */
static wcut_status add_key_faces(wcut_brep *b, bool upper, int e, const wcut_key *key, double level) {
    const int tip[2] = {-(e + 4), -(e + 3)};
    for (int half = 0; half < 2; half++) {
        const wcut_status status = add_key_flank(b, upper, half, e, key, level);
        if (status != WCUT_OK) return status;
    }
    add_brep_face(b, upper, WCUT_BREP_PART_KEY_TIP, NULL, b->vertex[b->edge[e + 2].from], vec3(0, 0, upper ? 1 : -1));
    add_loop(b, upper, 2, tip);
    return WCUT_OK;
}

static wcut_status add_keys(wcut_brep *b, bool upper, double level, int count, const wcut_key *key) {
    for (int k = 0; k < count; k++) {
        const int v = BLOCK_VERTICES + KEY_VERTICES * k, e = BLOCK_EDGES + KEY_EDGES * k;
        const wcut_status status = add_key_hole(b, upper, v, e, &key[k], level);
        if (status != WCUT_OK) return status;
    }
    for (int k = 0; k < count; k++) {
        const wcut_status status = add_key_faces(b, upper, BLOCK_EDGES + KEY_EDGES * k, &key[k], level);
        if (status != WCUT_OK) return status;
    }
    return WCUT_OK;
}

/* ---- lugs ---- */

/* around the face with the key, counter-clockwise seen from above, from the block's side on; then opposite */
static void add_lug_edges(wcut_brep *b, int v, int e, const wcut_lug *lug) {
    for (int k = 0; k < CORNERS; k++) {
        const int next = (k + 1) % CORNERS;
        b->vertex[v + k] = vec3(lug->corner[k].x, lug->corner[k].y, lug->level);
        b->vertex[v + CORNERS + k] = vec3(lug->corner[k].x, lug->corner[k].y, lug->far);
        b->edge[e + k] = (wcut_brep_edge){.from = v + k, .to = v + next};
        b->edge[e + CORNERS + k] = (wcut_brep_edge){.from = v + k, .to = v + CORNERS + k};
        b->edge[e + 2 * CORNERS + k] = (wcut_brep_edge){.from = v + CORNERS + k, .to = v + CORNERS + next};
    }
}

/* five faces of a box and its cone or pocket, which stands on the face that looks to the other half */
static wcut_status add_lug(wcut_brep *b, bool upper, int v, int first, const wcut_lug *lug) {
    const int e = first + 1, key_edge = first + LUG_EDGES;
    const int keyed[4] = {e, e + 1, e + 2, e + 3}, far[4] = {-(e + 11), -(e + 10), -(e + 9), -(e + 8)};

    /* the face with the key: seen from the half's opposite side it is turned, as are its key's faces */
    add_brep_face(b, upper, WCUT_BREP_PART_LUG, NULL, b->vertex[v], vec3(0, 0, upper ? -1 : 1));
    add_loop(b, upper, 4, keyed);
    const wcut_status status = add_key_hole(b, !upper, v + LUG_VERTICES, key_edge, &lug->key, lug->level);
    if (status != WCUT_OK) return status;

    /* the face opposite and the three sides that are not on the block */
    add_brep_face(b, upper, WCUT_BREP_PART_LUG, NULL, b->vertex[v + CORNERS], vec3(0, 0, upper ? 1 : -1));
    add_loop(b, upper, 4, far);
    for (int k = 1; k < CORNERS; k++) {
        const int next = (k + 1) % CORNERS, around[4] = {e + 8 + k, -(e + 4 + next), -(e + k), e + 4 + k};
        const wcut_vec3 along = vec3_unit(vec3_sub(b->vertex[v + next], b->vertex[v + k]));
        add_brep_face(b, upper, WCUT_BREP_PART_LUG, NULL, b->vertex[v + k], vec3(along.y, -along.x, 0));
        add_loop(b, upper, 4, around);
    }

    return add_key_faces(b, !upper, key_edge, &lug->key, lug->level);
}

static wcut_status add_lugs(wcut_brep *b, bool upper, int keys, int lugs, const wcut_lug *lug) {
    for (int k = 0; k < lugs; k++) {
        const wcut_status status = add_lug(b, upper, lug_vertex(keys, k), lug_edge(keys, k), &lug[k]);
        if (status != WCUT_OK) return status;
    }
    return WCUT_OK;
}

wcut_status wcut_brep_of_half(const wcut_surface *patch, int upper, double level, int key_count, const wcut_key *key,
                              int lugs, const wcut_lug *lug, wcut_brep **brep) {
    wcut_brep *b;
    wcut_status status = brep_new(key_count, lugs, &b);
    if (status != WCUT_OK) return status;
    add_block_vertices(b, patch, NULL, level);
    for (int k = 0; k < lugs; k++) add_lug_edges(b, lug_vertex(key_count, k), lug_edge(key_count, k), &lug[k]);
    status = add_block_edges(b, patch, NULL);
    if (status == WCUT_OK) status = add_block_faces(b, upper, patch, NULL, key_count, lugs, lug);
    if (status == WCUT_OK) status = add_keys(b, upper, level, key_count, key);
    if (status == WCUT_OK) status = add_lugs(b, upper, key_count, lugs, lug);
    if (status == WCUT_OK) {
        *brep = b;
    } else {
        wcut_brep_destroy(b);
    }
    return status;
}

wcut_status wcut_brep_between(const wcut_surface *floor, const wcut_surface *ceiling, wcut_brep **brep) {
    wcut_brep *b;
    wcut_status status = brep_new(0, 0, &b);
    if (status != WCUT_OK) return status;
    add_block_vertices(b, ceiling, floor, 0);
    status = add_block_edges(b, ceiling, floor);
    if (status == WCUT_OK) status = add_block_faces(b, false, ceiling, floor, 0, 0, NULL);
    if (status == WCUT_OK) {
        *brep = b;
    } else {
        wcut_brep_destroy(b);
    }
    return status;
}

static void solid_brep_scale_points(int count, double factor, wcut_vec3 *point) {
    for (int k = 0; k < count; k++) point[k] = vec3_scale(factor, point[k]);
}

void wcut_brep_scale(wcut_brep *brep, double factor) {
    solid_brep_scale_points(brep->vertex_count, factor, brep->vertex);
    for (int k = 0; k < brep->edge_count; k++) {
        const wcut_curve *c = brep->edge[k].curve;
        if (c) solid_brep_scale_points(c->control_count, factor, c->control);
    }
    for (int k = 0; k < brep->face_count; k++) {
        const wcut_surface *s = brep->face[k].surface;
        if (s) solid_brep_scale_points(s->count_u * s->count_v, factor, s->control);
        brep->face[k].origin = vec3_scale(factor, brep->face[k].origin);
    }
}
