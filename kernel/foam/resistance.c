/* The force of the foam on one node of a moving wire, and how it changes (Rust et al. 2016, 3). */
#include "foam/resistance.h"

#include <stddef.h>

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

double wcut_foam_inside(const wcut_foam *foam, wcut_vec3 was, wcut_vec3 x) {
    wcut_vec3 unused[2];
    return foam->embedded ? 1 : wcut_block_engagement(&foam->block, was, x, unused, unused + 1);
}

typedef struct motion {           /* of a node with force, and how long a piece of it is engaged */
    wcut_vec3 move, normal, t, p; /* normal: move across t; p: its direction */
    double distance, along, across, span, speed, rate;
    const engagement *e;
    const wcut_local_law *law;
} motion;

/* - mu |f_n| tanh(v_t / v_smooth) t, v_t the speed along the wire; |f_n| = F L |t x d|^2 presses, what the foam's force
   has across the wire (Coulomb); or - mu |f_n| v_t / v_r t, growing with the speed as a film of melt does */
static void add_drag(const motion *m, const wcut_drag *drag, bool slopes, mat3 *before, mat3 *here, mat3 *after,
                     wcut_resistance *out) {
    /* friction along the wire: Coulomb's, smoothed by tanh at rest, or of a film */
    const bool film = drag->law == WCUT_DRAG_LAW_SPEED;
    const double mu = drag->mu, sliding = m->rate * m->along, ratio = sliding / drag->speed;
    const double turn = film ? ratio : tanh(ratio), turn_by = (film ? 1 : 1 - turn * turn) / drag->speed;
    const double sine = m->across / m->distance, share = sine * sine, per_length = m->law->force * share;
    const double pressing = per_length * m->e->length;
    out->force = vec3_add_scaled(out->force, -mu * pressing * turn, m->t);

    /* derivative by ln r */
    const double by_log_rate = (m->law->by_speed * m->speed + m->law->by_log_rate) * m->e->length * share;
    out->by_log_rate =
        vec3_add_scaled(out->by_log_rate, -mu * (turn * by_log_rate + pressing * turn_by * sliding), m->t);
    if (!slopes) return;

    /* derivatives by this node's own place, and by its neighbours through the engaged length */
    const double length = m->e->length, force = m->law->force, d = m->distance;
    wcut_vec3 by_here = vec3_scale(length * (m->law->by_speed * m->rate - 2 * force / d) * share / d, m->move);
    by_here = vec3_add_scaled(by_here, 2 * sine * length * force / d, m->p);
    const wcut_vec3 by_move = vec3_add_scaled(vec3_scale(turn, by_here), pressing * turn_by * m->rate, m->t);
    out->by_was = mat3_add_outer(out->by_was, vec3_scale(mu, m->t), by_move);
    by_here = vec3_add_scaled(by_here, length * share, m->law->by_position);
    by_here = vec3_add_scaled(vec3_scale(turn, by_here), pressing * turn_by * m->rate, m->t);
    *here = mat3_add_outer(*here, vec3_scale(-mu, m->t), vec3_add_scaled(by_here, turn * per_length, m->e->by_here));
    const wcut_vec3 push = vec3_scale(-mu * turn * per_length, m->t);
    *before = mat3_add_outer(*before, push, m->e->by_before);
    *after = mat3_add_outer(*after, push, m->e->by_after);

    /* the tangent turns: t, |t x d| and v_t by x[after], the opposite by x[before] */
    wcut_vec3 by_turn = vec3_scale(-2 * sine * turn * length * force / d * m->along / m->span, m->p);
    by_turn = vec3_add_scaled(by_turn, pressing * turn_by * m->rate / m->span, m->normal);
    const double c = -mu * pressing * turn / m->span;
    mat3 turning = mat3_add_outer((mat3){{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, vec3_scale(-mu, m->t), by_turn);
    turning = mat3_add_identity(mat3_add_outer(turning, vec3_scale(-c, m->t), m->t), c);
    *after = mat3_add(*after, turning);
    *before = (mat3){vec3_sub(before->x, turning.x), vec3_sub(before->y, turning.y), vec3_sub(before->z, turning.z)};
}

static mat3 mat3_scaled(double s, mat3 a) { return (mat3){vec3_scale(s, a.x), vec3_scale(s, a.y), vec3_scale(s, a.z)}; }

/* The force times g = (1 + u / xi_0^2)^-m with u = (along / across)^2, the ratio of sliding along the edge to advance
   across it (slice-push cutting; Atkins, Xu, Jeronimidis 2004). */
static void soften(const motion *m, double ratio, double exponent, bool slopes, mat3 *before, mat3 *here, mat3 *after,
                   wcut_resistance *out) {
    if (!(m->across > 0)) return; /* there is no force */

    /* the factor and how it changes with u */
    const double a = m->along, c = m->across, base = 1 + a * a / (c * c) / (ratio * ratio);
    const double g = pow(base, -exponent), by_u = -exponent * g / base / (ratio * ratio);
    const wcut_vec3 force = out->force;
    out->force = vec3_scale(g, force);
    out->line *= g;
    out->by_log_rate = vec3_scale(g, out->by_log_rate);
    if (!slopes) return;

    /* the plain slopes, then g's own: by the motion, and by the tangent that the neighbours turn */
    *here = mat3_scaled(g, *here);
    if (before != here) *before = mat3_scaled(g, *before);
    if (after != here && after != before) *after = mat3_scaled(g, *after);
    out->by_was = mat3_scaled(g, out->by_was);
    const wcut_vec3 by_move =
        vec3_add_scaled(vec3_scale(2 * a / (c * c) * by_u, m->t), -2 * a * a / (c * c * c) * by_u, m->p);
    const wcut_vec3 by_turn = vec3_scale((2 * a / c + 2 * a * a * a / (c * c * c)) * by_u / m->span, m->p);
    *here = mat3_add_outer(*here, force, by_move);
    out->by_was = mat3_add_outer(out->by_was, force, vec3_scale(-1, by_move));
    *after = mat3_add_outer(*after, force, by_turn);
    *before = mat3_add_outer(*before, force, vec3_scale(-1, by_turn));
}

/* what effects add to the plain force and its slopes */
static void add_effect_forces(const wcut_locality *local, const motion *m, bool slopes, bool first, bool last,
                              wcut_resistance *out) {
    const double per_law = m->e->length * m->across / (m->distance * m->distance);
    out->by_log_rate = vec3_add_scaled(out->by_log_rate, -m->law->by_log_rate * per_law, m->move);
    if (slopes) out->by_here = mat3_add_outer(out->by_here, vec3_scale(-per_law, m->move), m->law->by_position);
    wcut_drag drag;
    double ratio, exponent;
    mat3 *before = first ? &out->by_here : &out->by_before, *after = last ? &out->by_here : &out->by_after;
    if (wcut_locality_slice(local, &ratio, &exponent))
        soften(m, ratio, exponent, slopes, before, &out->by_here, after, out);
    if (!wcut_locality_drag(local, &drag)) return;
    add_drag(m, &drag, slopes, before, &out->by_here, after, out);
}

void wcut_resistance_eval(const wcut_foam *foam, double heat, double edge, double rate, int n, const wcut_vec3 *x,
                          const wcut_vec3 *was, int i, bool slopes, wcut_resistance *out) {
    /* engaged length, motion, and the law at this speed */
    const engagement e = engage(foam, edge, n, x, i);
    const wcut_vec3 move = vec3_sub(x[i], was[i]);
    const double distance = vec3_length(move), speed = rate * distance;
    wcut_local_law at = {0};
    if (foam->local)
        at = wcut_local_law_eval(foam->local, &foam->block, &foam->law, heat, rate, speed, n, x[i], i);
    else
        at.force = force_law_slope(&foam->law, heat, speed, &at.by_speed);
    const double law = at.force, slope = at.by_speed;

    const wcut_vec3 zero = {0, 0, 0};
    *out = (wcut_resistance){.speed = speed, .engaged = e.length / (edge / 2 * ((i > 0) + (i < n - 1)))};
    if (!(law > 0) || !(e.length > 0)) return; /* a melted or untouched node has neither force nor slope */

    /* tangent by central difference, one-sided at the ends */
    const int before = i > 0 ? i - 1 : i, after = i < n - 1 ? i + 1 : i;
    const wcut_vec3 span = vec3_sub(x[after], x[before]);
    const double span_length = vec3_length(span);
    const wcut_vec3 t = vec3_scale(1 / span_length, span);

    /* parts of the motion along and across the wire */
    const double along = vec3_dot(t, move);
    const wcut_vec3 normal = vec3_add_scaled(move, -along, t); /* |normal| = |t x move| */
    const double across = vec3_length(normal);

    /* f = -w across move, w = F L / distance^2 */
    const double square = distance * distance, w = law * e.length / square;
    out->line = law * across / distance;
    out->force = vec3_scale(-w * across, move);
    out->by_log_rate = vec3_scale(-slope * speed * e.length / square * across, move);
    const wcut_vec3 p = across > 0 ? vec3_scale(1 / across, normal) : zero;

    if (slopes) {
        /* derivative by the node's own place: the length of the motion, its direction, the engaged length */
        const double w_by_distance = e.length * (slope * rate - 2 * law / distance) / square;
        const wcut_vec3 by_move = vec3_add_scaled(vec3_scale(w_by_distance * across / distance, move), w, p);
        const double per_length = law * across / square;
        mat3 here = mat3_add_identity((mat3){zero, zero, zero}, -w * across);
        out->by_was = mat3_add_outer(mat3_add_identity((mat3){zero, zero, zero}, w * across), move, by_move);
        here = mat3_add_outer(here, vec3_scale(-1, move), vec3_add_scaled(by_move, per_length, e.by_here));
        const wcut_vec3 turning =
            vec3_scale(w * along / span_length, p); /* the tangent turns: -(t.move)/|span| p by x[after] */

        /* by the neighbours, through the engaged length and the tangent */
        out->by_before =
            mat3_add_outer((mat3){zero, zero, zero}, vec3_scale(-1, move), vec3_scale(per_length, e.by_before));
        out->by_after =
            mat3_add_outer((mat3){zero, zero, zero}, vec3_scale(-1, move), vec3_scale(per_length, e.by_after));

        /* at an end of the wire the node itself is one of the two that span the tangent */
        mat3 *front = i < n - 1 ? &out->by_after : &here, *back = i > 0 ? &out->by_before : &here;
        *front = mat3_add_outer(*front, move, turning);
        *back = mat3_add_outer(*back, move, vec3_scale(-1, turning));
        out->by_here = here;
    }
    if (!foam->local) return;

    /* effects add forces along the wire and at the ends */
    const motion m = {move, normal, t, p, distance, along, across, span_length, speed, rate, &e, &at};
    add_effect_forces(foam->local, &m, slopes, i == 0, i == n - 1, out);
}
