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

static wcut_status brep_new(int keys, wcut_brep **brep) {
    wcut_brep *b = wcut_alloc(1, sizeof *b);
    if (!b) return WCUT_NO_MEMORY;
    b->vertex_count = BLOCK_VERTICES + KEY_VERTICES * keys;
    b->edge_count = BLOCK_EDGES + KEY_EDGES * keys;
    b->vertex = wcut_alloc((size_t)b->vertex_count, sizeof *b->vertex);
    b->edge = wcut_alloc((size_t)b->edge_count, sizeof *b->edge);
    b->coedge = wcut_alloc(BLOCK_COEDGES + KEY_COEDGES * (size_t)keys, sizeof *b->coedge);
    b->loop = wcut_alloc(BLOCK_FACES + KEY_LOOPS * (size_t)keys, sizeof *b->loop);
    b->face = wcut_alloc(BLOCK_FACES + KEY_FACES * (size_t)keys, sizeof *b->face);
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

/* corners of the patch, around; below or above them those of the face that is not cut */
static void add_block_vertices(wcut_brep *b, const wcut_surface *patch, double level) {
    const ptrdiff_t last_row = (ptrdiff_t)(patch->count_v - 1) * patch->count_u;
    const ptrdiff_t corner[CORNERS] = {0, patch->count_u - 1, last_row + patch->count_u - 1, last_row};
    for (int k = 0; k < CORNERS; k++) {
        b->vertex[k] = patch->control[corner[k]];
        b->vertex[CORNERS + k] = vec3(b->vertex[k].x, b->vertex[k].y, level);
    }
}

/* borders of the patch, then the uprights, then the edges of the face that is not cut, as the borders run */
static wcut_status add_block_edges(wcut_brep *b, const wcut_surface *patch) {
    const int end[CORNERS][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}};
    double first[2], last[2];
    wcut_surface_domain(patch, first, last);
    for (int k = 0; k < CORNERS; k++) {
        b->edge[k] = (wcut_brep_edge){.from = end[k][0], .to = end[k][1]};
        b->edge[CORNERS + k] = (wcut_brep_edge){.from = k, .to = CORNERS + k};
        b->edge[2 * CORNERS + k] = (wcut_brep_edge){.from = CORNERS + end[k][0], .to = CORNERS + end[k][1]};
        const wcut_direction along = k % 2 ? WCUT_DIRECTION_V : WCUT_DIRECTION_U;
        const double at = k == 0 ? first[1] : k == 1 ? last[0] : k == 2 ? last[1] : first[0];
        const wcut_status status = wcut_surface_iso_curve(patch, along, at, &b->edge[k].curve);
        if (status != WCUT_OK) return status;
    }
    return WCUT_OK;
}

static wcut_status copy_surface(const wcut_surface *s, wcut_surface **copy) {
    return wcut_surface_create(s->degree_u, s->degree_v, s->count_u, s->count_v, s->knots_u, s->knots_v, s->control,
                               s->weights, copy);
}

static wcut_status add_block_faces(wcut_brep *b, bool upper, const wcut_surface *patch) {
    static const int cut[4] = {1, 2, -3, -4}, opposite[4] = {12, 11, -10, -9};
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
    }
    add_brep_face(b, upper, WCUT_BREP_PART_OPPOSITE, NULL, b->vertex[CORNERS], vec3(0, 0, upper ? 1 : -1));
    add_loop(b, upper, 4, opposite);
    return WCUT_OK;
}

/* ---- keys ---- */

static void arc_control(const wcut_key *key, int half, double radius, double z, wcut_vec3 *control, double *weight) {
    for (int i = 0; i < ARC_CONTROL; i++) {
        control[i] = vec3(key->x + radius * arc_x[half][i], key->y + radius * arc_y[half][i], z);
        weight[i] = arc_weight[i];
    }
}

/* vertices, arcs and lines of the k-th key; its flank from angle 0 to pi is half 0 */
static wcut_status add_key_edges(wcut_brep *b, int k, const wcut_key *key, double level) {
    const int v = BLOCK_VERTICES + KEY_VERTICES * k, e = BLOCK_EDGES + KEY_EDGES * k;
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

static wcut_status add_keys(wcut_brep *b, bool upper, double level, int count, const wcut_key *key) {
    for (int k = 0; k < count; k++) { /* the holes belong to the face that was added last */
        const int e = BLOCK_EDGES + KEY_EDGES * k, hole[2] = {e + 1, e + 2};
        const wcut_status status = add_key_edges(b, k, &key[k], level);
        if (status != WCUT_OK) return status;
        add_loop(b, upper, 2, hole);
    }
    for (int k = 0; k < count; k++) {
        const int e = BLOCK_EDGES + KEY_EDGES * k, tip[2] = {-(e + 4), -(e + 3)};
        for (int half = 0; half < 2; half++) {
            const wcut_status status = add_key_flank(b, upper, half, e, &key[k], level);
            if (status != WCUT_OK) return status;
        }
        add_brep_face(b, upper, WCUT_BREP_PART_KEY_TIP, NULL, b->vertex[b->edge[e + 2].from],
                      vec3(0, 0, upper ? 1 : -1));
        add_loop(b, upper, 2, tip);
    }
    return WCUT_OK;
}

wcut_status wcut_brep_of_half(const wcut_surface *patch, int upper, double level, int key_count, const wcut_key *key,
                              wcut_brep **brep) {
    wcut_brep *b;
    wcut_status status = brep_new(key_count, &b);
    if (status != WCUT_OK) return status;
    add_block_vertices(b, patch, level);
    status = add_block_edges(b, patch);
    if (status == WCUT_OK) status = add_block_faces(b, upper, patch);
    if (status == WCUT_OK) status = add_keys(b, upper, level, key_count, key);
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
