/* The force of the foam on one node of a moving wire, and how it changes (Rust et al. 2016, 3). */
#include "foam/resistance.h"

#include "foam/force_law.h"

typedef struct engagement { /* of a node's length, which reaches half an edge to either side */
    double length;          /* [mm] engaged */
    wcut_vec3 by_before, by_here, by_after;
} engagement;

static void add_half_edge(const wcut_block *block, double half, wcut_vec3 x, wcut_vec3 neighbour, engagement *e,
                          wcut_vec3 *by_neighbour) {
    wcut_vec3 by_x, by_middle;
    e->length += half * wcut_block_engagement(block, x, vec3_mix(x, neighbour, 0.5), &by_x, &by_middle);
    e->by_here = vec3_add_scaled(e->by_here, half, vec3_add_scaled(by_x, 0.5, by_middle));
    *by_neighbour = vec3_scale(half / 2, by_middle);
}

static engagement engage(const wcut_foam *foam, double edge, int n, const wcut_vec3 *x, int i) {
    const double half = edge / 2;
    engagement e = {0};
    if (foam->embedded) {
        e.length = half * ((i > 0) + (i < n - 1));
        return e;
    }
    if (i > 0) add_half_edge(&foam->block, half, x[i], x[i - 1], &e, &e.by_before);
    if (i < n - 1) add_half_edge(&foam->block, half, x[i], x[i + 1], &e, &e.by_after);
    return e;
}

void wcut_resistance_eval(const wcut_foam *foam, double heat, double edge, double rate, int n, const wcut_vec3 *x,
                          const wcut_vec3 *was, int i, bool slopes, wcut_resistance *out) {
    const engagement e = engage(foam, edge, n, x, i);
    const wcut_vec3 move = vec3_sub(x[i], was[i]);
    const double distance = vec3_length(move), speed = rate * distance;
    double slope;
    const double law = force_law_slope(&foam->law, heat, speed, &slope);

    const wcut_vec3 zero = {0, 0, 0};
    *out = (wcut_resistance){.speed = speed, .engaged = e.length / (edge / 2 * ((i > 0) + (i < n - 1)))};
    if (!(law > 0) || !(e.length > 0)) return; /* a melted or untouched node has neither force nor slope */

    const int before = i > 0 ? i - 1 : i, after = i < n - 1 ? i + 1 : i;
    const wcut_vec3 span = vec3_sub(x[after], x[before]);
    const double span_length = vec3_length(span);
    const wcut_vec3 t = vec3_scale(1 / span_length, span);
    const double along = vec3_dot(t, move);
    const wcut_vec3 normal = vec3_add_scaled(move, -along, t); /* |normal| = |t x move| */
    const double across = vec3_length(normal);

    /* f = -w across move, w = F L / distance^2 */
    const double square = distance * distance, w = law * e.length / square;
    out->line = law * across / distance;
    out->force = vec3_scale(-w * across, move);
    out->by_log_rate = vec3_scale(-slope * speed * e.length / square * across, move);
    if (!slopes) return;

    const wcut_vec3 p = across > 0 ? vec3_scale(1 / across, normal) : zero;
    const double w_by_distance = e.length * (slope * rate - 2 * law / distance) / square;
    const wcut_vec3 by_move = vec3_add_scaled(vec3_scale(w_by_distance * across / distance, move), w, p);
    const double per_length = law * across / square;

    mat3 here = mat3_add_identity((mat3){zero, zero, zero}, -w * across);
    here = mat3_add_outer(here, vec3_scale(-1, move), vec3_add_scaled(by_move, per_length, e.by_here));
    const wcut_vec3 turning =
        vec3_scale(w * along / span_length, p); /* the tangent turns: -(t.move)/|span| p by x[after] */
    out->by_before =
        mat3_add_outer((mat3){zero, zero, zero}, vec3_scale(-1, move), vec3_scale(per_length, e.by_before));
    out->by_after = mat3_add_outer((mat3){zero, zero, zero}, vec3_scale(-1, move), vec3_scale(per_length, e.by_after));
    mat3 *front = i < n - 1 ? &out->by_after : &here, *back = i > 0 ? &out->by_before : &here;
    *front = mat3_add_outer(*front, move, turning);
    *back = mat3_add_outer(*back, move, vec3_scale(-1, turning));
    out->by_here = here;
}
