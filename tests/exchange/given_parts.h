/* Parts to exchange whose figures are known in closed form. */
#ifndef WCUT_TESTS_EXCHANGE_GIVEN_PARTS_H
#define WCUT_TESTS_EXCHANGE_GIVEN_PARTS_H

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/exchange.h>
#include <wirecut/wirecut.h>

/* ---- a block under (or above) a bicubic patch, [0, 40] x [0, 60] ----

   x and y of the patch are those of an even net, so its volume over z = 0 is the mean of the poles' heights times the
   base: the Bernstein polynomials all have the same integral. */

enum { GIVEN_W = 40, GIVEN_L = 60, GIVEN_H = 30 };
static const double given_height[4][4] = {{10, 12.125, 9, 11}, {12, 19, 7, 10.3}, {9, 8, 16, 12}, {11, 10, 13.7, 10}};

typedef struct given_solid {
    wcut_brep brep;
    wcut_vec3 vertex[8];
    wcut_brep_edge edge[12];
    wcut_brep_coedge coedge[24];
    wcut_brep_loop loop[6];
    wcut_brep_face face[6];
    wcut_surface *patch;
    double volume;
} given_solid;

static inline wcut_surface *given_patch(void) {
    static const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    wcut_vec3 control[16];
    wcut_surface *patch = NULL;
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++)
            control[4 * j + i] = (wcut_vec3){GIVEN_W * i / 3.0, GIVEN_L * j / 3.0, given_height[j][i]};
    for (int j = 0; j < 4; j++) control[4 * j + 3].x = GIVEN_W;
    for (int i = 0; i < 4; i++) control[12 + i].y = GIVEN_L;
    if (wcut_surface_create(3, 3, 4, 4, knots, knots, control, NULL, &patch) != WCUT_OK) abort();
    return patch;
}

static inline void given_set_face(given_solid *s, int k, wcut_brep_part part, wcut_surface *surface, int same_sense,
                                  wcut_vec3 normal, int from, const int *coedge) {
    for (int i = 0; i < 4; i++) s->coedge[4 * k + i] = (wcut_brep_coedge){abs(coedge[i]) - 1, coedge[i] < 0};
    s->loop[k] = (wcut_brep_loop){4 * k, 4};
    s->face[k] = (wcut_brep_face){part, surface, same_sense, s->vertex[from], normal, k, 1};
}

/* Vertices 0..3 are the patch's corners (u v = 00 10 11 01), 4..7 those of the flat face below or above them. Edges
   0..3 are the patch's border, 4..7 upright, 8..11 flat. A coedge k > 0 is edge k - 1, k < 0 that edge reversed. */
static inline void given_solid_create(given_solid *s, int upper) {
    const double flat = upper ? GIVEN_H : 0;
    double mean = 0;
    memset(s, 0, sizeof *s);
    s->patch = given_patch();
    for (int k = 0; k < 16; k++) mean += given_height[k / 4][k % 4] / 16;
    s->volume = (upper ? GIVEN_H - mean : mean) * GIVEN_W * GIVEN_L;
    static const int corner[4] = {0, 3, 15, 12};
    for (int k = 0; k < 4; k++) {
        s->vertex[k] = s->patch->control[corner[k]];
        s->vertex[4 + k] = (wcut_vec3){s->vertex[k].x, s->vertex[k].y, flat};
    }
    static const int end[12][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {0, 4}, {1, 5},
                                   {2, 6}, {3, 7}, {4, 5}, {5, 6}, {7, 6}, {4, 7}};
    for (int k = 0; k < 12; k++) s->edge[k] = (wcut_brep_edge){end[k][0], end[k][1], NULL};
    for (int k = 0; k < 4; k++)
        if (wcut_surface_iso_curve(s->patch, k % 2 ? WCUT_DIRECTION_V : WCUT_DIRECTION_U, k == 1 || k == 2 ? 1 : 0,
                                   &s->edge[k].curve) != WCUT_OK)
            abort();
    /* seen from outside a solid that lies below the patch; above it all is mirrored, so every loop runs backwards */
    static const int below[6][4] = {{1, 2, -3, -4},  {-1, 5, 9, -6},  {-2, 6, 10, -7},
                                    {3, 7, -11, -8}, {4, 8, -12, -5}, {12, 11, -10, -9}};
    static const wcut_vec3 out[6] = {{0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}};
    static const wcut_brep_part part[6] = {WCUT_BREP_PART_CUT,     WCUT_BREP_PART_SIDE_Y0, WCUT_BREP_PART_SIDE_XW,
                                           WCUT_BREP_PART_SIDE_YL, WCUT_BREP_PART_SIDE_X0, WCUT_BREP_PART_OPPOSITE};
    static const int at[6] = {0, 0, 1, 3, 0, 4};
    for (int k = 0; k < 6; k++) {
        int loop[4];
        for (int i = 0; i < 4; i++) loop[i] = upper ? -below[k][3 - i] : below[k][i];
        const double turn = upper && k == 5 ? -1 : 1;
        given_set_face(s, k, part[k], k == 0 ? s->patch : NULL, !upper || k > 0,
                       (wcut_vec3){out[k].x, out[k].y, turn * out[k].z}, at[k], loop);
    }
    s->brep = (wcut_brep){8, 12, 24, 6, 6, s->vertex, s->edge, s->coedge, s->loop, s->face};
}

static inline void given_solid_destroy(given_solid *s) {
    for (int k = 0; k < 4; k++) wcut_curve_destroy(s->edge[k].curve);
    wcut_surface_destroy(s->patch);
}

/* ---- rational shapes ---- */

/* a whole cylinder of radius 7 about the axis x = 1, z = 2, along y over [0, 11]: closed in u */
static inline wcut_surface *given_cylinder(void) {
    static const double ku[12] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, kv[4] = {0, 0, 1, 1};
    static const double cx[9] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, cz[9] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    wcut_vec3 control[18];
    double weights[18];
    wcut_surface *s = NULL;
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 9; i++) {
            control[9 * j + i] = (wcut_vec3){1 + 7 * cx[i], 11 * j, 2 + 7 * cz[i]};
            weights[9 * j + i] = i % 2 ? sqrt(0.5) : 1;
        }
    if (wcut_surface_create(2, 1, 9, 2, ku, kv, control, weights, &s) != WCUT_OK) abort();
    return s;
}

/* a wire's stations across the block [0, 400] x [0, 600] x [0, 200] */
static inline wcut_surface *given_loft(int stations, int nodes) {
    wcut_vec3 *node = calloc((size_t)stations * (size_t)nodes, sizeof *node);
    wcut_surface *s = NULL;
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) {
            const double u = (double)i / (nodes - 1), v = (double)j / (stations - 1);
            node[(size_t)j * (size_t)nodes + (size_t)i] =
                (wcut_vec3){420 * u - 10, 660 * v - 10 - 30 * sin(3 * u), 100 + 30 * sin(4 * u + v) * cos(5 * v)};
        }
    if (wcut_surface_loft(stations, nodes, node, 1e-3, &s, NULL, NULL) != WCUT_OK) abort();
    free(node);
    return s;
}

static inline wcut_curve *given_curve(void) {
    wcut_vec3 p[25];
    wcut_curve *c = NULL;
    for (int k = 0; k < 25; k++) p[k] = (wcut_vec3){-110 + 3 * sin(k), 25.1 * k, 150 + 7 * cos(0.3 * k) / 3};
    if (wcut_curve_interpolate(25, p, &c) != WCUT_OK) abort();
    return c;
}

/* three quarters of a circle of radius 5 in the plane z = 1 */
static inline wcut_curve *given_arc(void) {
    static const double knots[10] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3};
    static const double x[7] = {1, 1, 0, -1, -1, -1, 0}, y[7] = {0, 1, 1, 1, 0, -1, -1};
    wcut_vec3 control[7];
    double weights[7];
    wcut_curve *c = NULL;
    for (int k = 0; k < 7; k++) {
        control[k] = (wcut_vec3){5 * x[k], 5 * y[k], 1};
        weights[k] = k % 2 ? sqrt(0.5) : 1;
    }
    if (wcut_curve_create(2, 7, knots, control, weights, &c) != WCUT_OK) abort();
    return c;
}

#endif
