/* The feet of points on the face that a run's wires sweep: Lagrange's cubic through four nodes and four stations. */
#include "inverse/feet.h"

#include <stddef.h>

#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"

#define STEP_SMALL 1e-11 /* [1] of the nodes' number: Newton has arrived */

enum { ROUNDS = 30 };

/* the first of four neighbours of u among n, their weights and the weights of the slope */
static int cubic_weights(double u, int n, double w[4], double d[4]) {
    const int first = (int)clamp(floor(u) - 1, 0, n - 4);
    const double t = u - first, a = t, b = t - 1, c = t - 2, e = t - 3;
    w[0] = -b * c * e / 6, w[1] = a * c * e / 2, w[2] = -a * b * e / 2, w[3] = a * b * c / 6;
    d[0] = -(c * e + b * e + b * c) / 6, d[1] = (c * e + a * e + a * c) / 2;
    d[2] = -(b * e + a * e + a * b) / 2, d[3] = (b * c + a * c + a * b) / 6;
    return first;
}

wcut_stencil wcut_wire_stencil(const wcut_wire_face *face, double station, double node) {
    wcut_stencil s;
    double unused[4];
    s.station = cubic_weights(station, face->stations, s.along, unused);
    s.node = cubic_weights(node, face->nodes, s.across, unused);
    return s;
}

wcut_vec3 wcut_stencil_eval(const wcut_stencil *at, int nodes, const wcut_vec3 *field) {
    wcut_vec3 sum = {0, 0, 0};
    for (int j = 0; j < 4; j++) {
        const wcut_vec3 *row = field + (size_t)(at->station + j) * (size_t)nodes + at->node;
        wcut_vec3 here = vec3_scale(at->across[0], row[0]);
        for (int i = 1; i < 4; i++) here = vec3_add_scaled(here, at->across[i], row[i]);
        sum = vec3_add_scaled(sum, at->along[j], here);
    }
    return sum;
}

typedef struct place { /* of the face, with its tangents by node and by station */
    wcut_vec3 x, by_node, by_station;
} place;

static place eval_face(const wcut_wire_face *face, double station, double node) {
    double wj[4], dj[4], wi[4], di[4];
    const int j0 = cubic_weights(station, face->stations, wj, dj), i0 = cubic_weights(node, face->nodes, wi, di);
    place p = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    for (int j = 0; j < 4; j++) {
        const wcut_vec3 *row = face->x + (size_t)(j0 + j) * (size_t)face->nodes + i0;
        wcut_vec3 here = {0, 0, 0}, slope = {0, 0, 0};
        for (int i = 0; i < 4; i++) {
            here = vec3_add_scaled(here, wi[i], row[i]);
            slope = vec3_add_scaled(slope, di[i], row[i]);
        }
        p.x = vec3_add_scaled(p.x, wj[j], here);
        p.by_node = vec3_add_scaled(p.by_node, wj[j], slope);
        p.by_station = vec3_add_scaled(p.by_station, dj[j], here);
    }
    return p;
}

/* the nearest of the nodes */
static void nearest_node(const wcut_wire_face *face, wcut_vec3 q, wcut_wire_foot *foot) {
    double best = HUGE_VAL;
    for (int j = 0; j < face->stations; j++)
        for (int i = 0; i < face->nodes; i++) {
            const wcut_vec3 d = vec3_sub(q, face->x[(size_t)j * (size_t)face->nodes + (size_t)i]);
            const double square = vec3_dot(d, d);
            if (square < best) best = square, foot->station = j, foot->node = i;
        }
}

/* Gauss-Newton on the squared distance, held inside the face */
static void find_foot(const wcut_wire_face *face, wcut_vec3 q, wcut_wire_foot *foot) {
    const double last_j = face->stations - 1, last_i = face->nodes - 1;
    place p = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < ROUNDS; k++) {
        p = eval_face(face, foot->station, foot->node);
        const wcut_vec3 d = vec3_sub(q, p.x);
        const double a = vec3_dot(p.by_node, p.by_node), b = vec3_dot(p.by_node, p.by_station);
        const double c = vec3_dot(p.by_station, p.by_station), f = vec3_dot(d, p.by_node),
                     g = vec3_dot(d, p.by_station);
        const double det = a * c - b * b;
        if (!(det > 1e-12 * a * c)) break;
        double step_i = (c * f - b * g) / det, step_j = (a * g - b * f) / det;

        /* on a border the other parameter alone, where the step would leave */
        if ((foot->node <= 0 && step_i < 0) || (foot->node >= last_i && step_i > 0)) step_i = 0, step_j = g / c;
        if ((foot->station <= 0 && step_j < 0) || (foot->station >= last_j && step_j > 0)) {
            step_j = 0;
            step_i = f / a;
            if ((foot->node <= 0 && step_i < 0) || (foot->node >= last_i && step_i > 0)) step_i = 0;
        }
        const double node = clamp(foot->node + clamp(step_i, -4, 4), 0, last_i);
        const double station = clamp(foot->station + clamp(step_j, -4, 4), 0, last_j);
        const double moved = fabs(node - foot->node) + fabs(station - foot->station);
        foot->node = node, foot->station = station;
        if (moved < STEP_SMALL * (last_i + last_j)) break;
    }

    /* what is left: over the face, or beside it */
    p = eval_face(face, foot->station, foot->node);
    const wcut_vec3 d = vec3_sub(q, p.x);
    foot->normal = vec3_unit(vec3_cross(p.by_node, p.by_station));
    foot->height = vec3_dot(d, foot->normal);
    const wcut_vec3 off = vec3_add_scaled(d, -foot->height, foot->normal);
    const bool border = foot->node <= 0 || foot->node >= last_i || foot->station <= 0 || foot->station >= last_j;
    foot->beside = border ? vec3_length(off) : 0;
    foot->outward = vec3_unit(off);
    if (foot->beside < 1e-6 * vec3_length(vec3_add(p.by_node, p.by_station))) foot->beside = 0;
}

void wcut_wire_feet(const wcut_wire_face *face, int count, const wcut_vec3 *point, bool known, int threads,
                    wcut_wire_foot *foot) {
#pragma omp parallel for schedule(static) num_threads(wcut_threads(threads))
    for (int k = 0; k < count; k++) {
        if (!known) nearest_node(face, point[k], &foot[k]);
        find_foot(face, point[k], &foot[k]);
    }
}
