/* The one residual of the wire in the foam, with its banded Jacobian bordered by the rate. */
#include "cut/system.h"

#include "base/alloc.h"
#include "base/numbers.h"
#include "wire/chain.h"

enum { BAND = 6 };

bool wcut_system_create(int n, wcut_system *y) {
    const int size = 4 * n - 7;
    *y = (wcut_system){.n = n, .size = size};
    y->jacobian = (wcut_banded){.n = size, .kl = BAND, .ku = BAND, .width = 3 * BAND + 1};
    y->jacobian.entry = wcut_alloc(banded_size(size, BAND, BAND), sizeof(double));
    y->jacobian.pivot = wcut_alloc((size_t)size, sizeof(int));
    y->residual = wcut_alloc((size_t)size, sizeof(double));
    y->by_log_rate = wcut_alloc((size_t)size, sizeof(double));
    y->border = wcut_alloc((size_t)size, sizeof(double));
    y->node = wcut_alloc((size_t)n, sizeof *y->node);
    return y->jacobian.entry && y->jacobian.pivot && y->residual && y->by_log_rate && y->border && y->node;
}

void wcut_system_destroy(wcut_system *y) {
    wcut_free(y->jacobian.entry);
    wcut_free(y->jacobian.pivot);
    wcut_free(y->residual);
    wcut_free(y->by_log_rate);
    wcut_free(y->border);
    wcut_free(y->node);
}

/* where the unknowns stand */
static int tension_at(int e) { return 4 * e; }
static int node_at(int i) { return 4 * i - 3; }
static bool is_free(const wcut_system *y, int i) { return i > 0 && i < y->n - 1; }

static void put_vector(double *at, wcut_vec3 v) { at[0] = v.x, at[1] = v.y, at[2] = v.z; }

static void add_vector(double *at, wcut_vec3 v) { at[0] += v.x, at[1] += v.y, at[2] += v.z; }

static void add_block(wcut_banded *m, int row, int column, mat3 a) {
    add_vector(banded_at(m, row, column), a.x);
    add_vector(banded_at(m, row + 1, column), a.y);
    add_vector(banded_at(m, row + 2, column), a.z);
}

/* (|E|^2 - l^2) / 2 l, the stretch to first order but polynomial */
static void put_lengths(wcut_system *y, const wcut_step *step, const wcut_vec3 *x, const double *s, bool slopes) {
    for (int e = 0; e < y->n - 1; e++) {
        const double l = wcut_edge_length(step->compliance, step->edge, e, s[e]);
        const wcut_vec3 edge = vec3_sub(x[e + 1], x[e]);
        const int row = tension_at(e);
        y->residual[row] = (vec3_dot(edge, edge) - l * l) / (2 * l);
        if (!slopes) continue;
        const wcut_vec3 u = vec3_scale(1 / l, edge);
        if (is_free(y, e)) put_vector(banded_at(&y->jacobian, row, node_at(e)), vec3_scale(-1, u));
        if (is_free(y, e + 1)) put_vector(banded_at(&y->jacobian, row, node_at(e + 1)), u);
        if (step->compliance)
            *banded_at(&y->jacobian, row, row) = -(1 + y->residual[row] / l) * wcut_edge_softness(step->compliance, e);
    }
}

static void put_equilibrium(wcut_system *y, const wcut_step *step, const wcut_vec3 *x, const double *s, double rate,
                            bool slopes) {
    const wcut_compliance *give = step->compliance;
    const double edge = step->edge, per_edge = 1 / edge;
    for (int i = 1; i < y->n - 1; i++) {
        /* unit vectors of both edges, by their present lengths where they stretch */
        const double l = give ? wcut_edge_length(give, edge, i - 1, s[i - 1]) : edge;
        const double m = give ? wcut_edge_length(give, edge, i, s[i]) : edge;
        const wcut_vec3 back = vec3_scale(give ? 1 / l : per_edge, vec3_sub(x[i], x[i - 1]));
        const wcut_vec3 front = vec3_scale(give ? 1 / m : per_edge, vec3_sub(x[i + 1], x[i]));

        /* residual: loads of foam and weight, and the pull of both edges */
        const wcut_resistance *f = &y->node[i];
        const int row = node_at(i);
        const wcut_vec3 dragged = vec3_scale(-step->drag * rate, vec3_sub(x[i], step->was[i]));
        const wcut_vec3 load = step->dead_load ? vec3_add(vec3_add(f->force, step->dead_load[i]), dragged) : f->force;
        put_vector(y->residual + row, vec3_add_scaled(vec3_add_scaled(load, s[i], front), -s[i - 1], back));

        if (!slopes) continue;

        /* slopes by the tensions; a soft edge gets longer, which turns less */
        const double less_back = give ? 1 - s[i - 1] * wcut_edge_softness(give, i - 1) / l : 1;
        const double less_front = give ? 1 - s[i] * wcut_edge_softness(give, i) / m : 1;
        for (int c = 0; c < 3; c++) {
            const double b[3] = {back.x, back.y, back.z}, a[3] = {front.x, front.y, front.z};
            *banded_at(&y->jacobian, row + c, tension_at(i - 1)) = -b[c] * less_back;
            *banded_at(&y->jacobian, row + c, tension_at(i)) = a[c] * less_front;
        }

        /* slopes by the positions: the foam's own, and S / l of the edges */
        const double both = give ? s[i] / m + s[i - 1] / l : (s[i] + s[i - 1]) / l;
        add_block(&y->jacobian, row, row, mat3_add_identity(f->by_here, -both - step->drag * rate));
        if (i > 1) add_block(&y->jacobian, row, node_at(i - 1), mat3_add_identity(f->by_before, s[i - 1] / l));
        if (i < y->n - 2) add_block(&y->jacobian, row, node_at(i + 1), mat3_add_identity(f->by_after, s[i] / m));

        /* slope by ln r */
        put_vector(y->by_log_rate + row, vec3_add(f->by_log_rate, dragged));
    }
}

typedef struct wire_end { /* see wcut_chain_outward */
    wcut_vec3 outward;
    double scale; /* [1/mm] */
} wire_end;

static wire_end end_of(wcut_vec3 end, wcut_vec3 next, wcut_vec3 second) {
    wire_end e;
    e.outward = wcut_chain_outward(end, next, second, &e.scale);
    return e;
}

/* d (direction . outward) by the position that enters the difference with `weight` */
static wcut_vec3 direction_change(const wire_end *e, double weight, wcut_vec3 direction) {
    return vec3_scale(weight * e->scale, vec3_add_scaled(direction, -vec3_dot(e->outward, direction), e->outward));
}

/* (4): |sum f| - k |t_0 + t_{n-1}| */
static void put_condition(wcut_system *y, const wcut_step *step, const wcut_vec3 *x, bool slopes) {
    const int n = y->n;
    wcut_vec3 sum = {0, 0, 0};

    /* sum of the foam's forces, and of their magnitudes */
    y->load = 0;
    for (int i = 0; i < n; i++) {
        sum = vec3_add(sum, y->node[i].force);
        y->load += vec3_length(y->node[i].force);
    }
    if (step->heavy)
        for (int i = 0; i < n; i++) sum = vec3_add(sum, step->dead_load[i]);

    /* end tangents, and the tension that the force asks for */
    const wire_end a = end_of(x[0], x[1], x[2]), b = end_of(x[n - 1], x[n - 2], x[n - 3]);
    const wcut_vec3 out = vec3_add(a.outward, b.outward);
    const double total = vec3_length(sum), opening = vec3_length(out);
    y->condition = total - step->tension * opening;
    y->pull = opening > 0 ? total / opening : 0;
    if (!slopes) return;

    /* the border: derivative of |sum f| by the free nodes and ln r */
    const wcut_vec3 u = vec3_unit(sum), w = vec3_unit(out);
    y->condition_by_log_rate = 0;
    for (int i = 0; i < n; i++) {
        const wcut_resistance *f = &y->node[i];
        y->condition_by_log_rate += vec3_dot(u, f->by_log_rate);
        if (is_free(y, i)) add_vector(y->border + node_at(i), mat3_row_product(u, f->by_here));
        if (is_free(y, i - 1)) add_vector(y->border + node_at(i - 1), mat3_row_product(u, f->by_before));
        if (is_free(y, i + 1)) add_vector(y->border + node_at(i + 1), mat3_row_product(u, f->by_after));
    }

    /* derivative of k |t_0 + t_{n-1}|, by the two nodes next to each end */
    const double k = step->tension;
    const int inner[4] = {1, 2, n - 2, n - 3}; /* the last two are ends of the other side where there are few nodes */
    for (int i = 0; i < 4; i++)
        if (is_free(y, inner[i]))
            add_vector(y->border + node_at(inner[i]),
                       vec3_scale(-k, direction_change(i < 2 ? &a : &b, i % 2 ? 1 : -4, w)));
}

/* ---- ends that give way with their mounts ---- */

static wcut_end end_on_mount(const wcut_step *step, const wcut_vec3 *x, const double *s, double rate, int mount) {
    const int e = mount == 0 ? 0 : step->n - 2, next = mount == 0 ? 1 : step->n - 2;
    const double length = wcut_edge_length(step->compliance, step->edge, e, s[e]);
    return wcut_compliance_end(step->compliance, mount, x[next], s[e], length, wcut_edge_softness(step->compliance, e),
                               rate);
}

static bool mounts_give(const wcut_step *step) {
    if (!step->compliance) return false;
    const wcut_vec3 *give = step->compliance->give;
    return vec3_dot(give[0], give[0]) + vec3_dot(give[1], give[1]) > 0;
}

static wcut_vec3 by_coordinate(wcut_vec3 a, wcut_vec3 b) { return (wcut_vec3){a.x * b.x, a.y * b.y, a.z * b.z}; }

void wcut_system_place_ends(const wcut_step *step, const double *s, double log_rate, wcut_vec3 *x) {
    if (!mounts_give(step)) return;
    const double rate = exp(log_rate);
    x[0] = end_on_mount(step, x, s, rate, 0).at;
    x[step->n - 1] = end_on_mount(step, x, s, rate, 1).at;
}

/* what an equation has by the end, by what moves the end: the next node, its edge's tension, ln r */
static void pass_on(wcut_system *y, const wcut_end *end, int row, int e, int next, wcut_vec3 by_end) {
    add_vector(banded_at(&y->jacobian, row, node_at(next)), by_coordinate(end->by_next, by_end));
    *banded_at(&y->jacobian, row, tension_at(e)) += vec3_dot(by_end, end->by_tension);
    y->by_log_rate[row] += vec3_dot(by_end, end->by_log_rate);
}

/* The ends are no unknowns: their share in the equations goes to those that they follow. */
static void put_mounts(wcut_system *y, const wcut_step *step, const wcut_vec3 *x, const double *s, double rate) {
    const int n = y->n;

    /* directions of the whole force and of the whole opening */
    wcut_vec3 sum = {0, 0, 0};
    for (int i = 0; i < n; i++) sum = vec3_add(sum, y->node[i].force);
    if (step->heavy)
        for (int i = 0; i < n; i++) sum = vec3_add(sum, step->dead_load[i]);
    const wire_end side[2] = {end_of(x[0], x[1], x[2]), end_of(x[n - 1], x[n - 2], x[n - 3])};
    const wcut_vec3 u = vec3_unit(sum), w = vec3_unit(vec3_add(side[0].outward, side[1].outward));
    for (int m = 0; m < 2; m++) {
        /* each end follows its neighbour, the tension of its edge, and ln r */
        const int e = m == 0 ? 0 : n - 2, next = m == 0 ? 1 : n - 2, here = m == 0 ? 0 : n - 1;
        const wcut_end end = end_on_mount(step, x, s, rate, m);
        const double l = wcut_edge_length(step->compliance, step->edge, e, s[e]);
        const mat3 by_next = m == 0 ? y->node[next].by_before : y->node[next].by_after;
        const mat3 balance = mat3_add_identity(by_next, s[e] / l);

        /* its share in the equations of length and of equilibrium */
        pass_on(y, &end, tension_at(e), e, next, vec3_scale(1 / l, vec3_sub(x[here], x[next])));
        pass_on(y, &end, node_at(next), e, next, balance.x);
        pass_on(y, &end, node_at(next) + 1, e, next, balance.y);
        pass_on(y, &end, node_at(next) + 2, e, next, balance.z);

        /* its share in condition (4) */
        wcut_vec3 by_end = vec3_add(mat3_row_product(u, y->node[here].by_here), mat3_row_product(u, by_next));
        by_end = vec3_add_scaled(by_end, -step->tension, direction_change(&side[m], 3, w));
        add_vector(y->border + node_at(next), by_coordinate(end.by_next, by_end));
        y->border[tension_at(e)] += vec3_dot(by_end, end.by_tension);
        y->condition_by_log_rate += vec3_dot(by_end, end.by_log_rate);
    }
}

/* ---- ends on the frame of a bow ---- */

typedef struct pulled_end { /* an end edge of the wire, as the frame feels it */
    double length;          /* [mm] */
    double along;           /* [mm] of the edge, out of the end's side towards B */
    double less;            /* [1] an edge that gets longer by its tension turns less */
} pulled_end;

static pulled_end end_pull(const wcut_step *step, const wcut_vec3 *x, const double *s, int e) {
    const double l = wcut_edge_length(step->compliance, step->edge, e, s[e]);
    return (pulled_end){.length = l,
                        .along = vec3_dot(vec3_sub(x[e + 1], x[e]), step->frame->along),
                        .less = 1 - s[e] * wcut_edge_softness(step->compliance, e) / l};
}

/* (T - P) / k_b - u = 0 beside the equations of the wire, whose ends move by -+ u / 2 along the chord (cut/bow.h) */
static void put_frame(wcut_system *y, const wcut_step *step, const wcut_vec3 *x, const double *s, bool slopes) {
    const wcut_bow_frame *f = step->frame;
    const int n = y->n, last = n - 2;
    const pulled_end a = end_pull(step, x, s, 0), b = end_pull(step, x, s, last);
    const double tension = (s[0] * a.along / a.length + s[last] * b.along / b.length) / 2;
    y->chord_pull = tension;
    y->condition = f->give * (tension - f->pretension) - wcut_bow_frame_closing(f, x[0], x[n - 1]);
    if (!slopes) return;

    /* the row: by the tensions of both end edges and the nodes next to the ends, then by u itself */
    const double turn_a = s[0] / a.length, turn_b = s[last] / b.length;
    for (int k = 0; k < y->size; k++) y->by_log_rate[k] = y->border[k] = 0;
    y->border[tension_at(0)] += f->give / 2 * a.along / a.length * a.less;
    y->border[tension_at(last)] += f->give / 2 * b.along / b.length * b.less;
    add_vector(y->border + node_at(1), vec3_scale(f->give / 2 * turn_a, f->along));
    add_vector(y->border + node_at(n - 2), vec3_scale(-f->give / 2 * turn_b, f->along));
    y->condition_by_log_rate = -f->give / 4 * (turn_a + turn_b) - 1;

    /* the column: lengths of both end edges, equilibrium of the nodes next to the ends */
    const wcut_vec3 in = vec3_scale(0.5, f->along), out = vec3_scale(-0.5, f->along);
    y->by_log_rate[tension_at(0)] -= a.along / (2 * a.length);
    y->by_log_rate[tension_at(last)] -= b.along / (2 * b.length);
    add_vector(y->by_log_rate + node_at(1), mat3_times(mat3_add_identity(y->node[1].by_before, turn_a), in));
    add_vector(y->by_log_rate + node_at(n - 2), mat3_times(mat3_add_identity(y->node[n - 2].by_after, turn_b), out));
}

/* [mm] the length of wire that node i stands for, twice that at the ends */
static double length_at(const wcut_step *step, int i) {
    if (!step->lengths) return step->edge;
    const int before = i > 0 ? i - 1 : 0, behind = i < step->n - 1 ? i : step->n - 2;
    return (step->lengths[before] + step->lengths[behind]) / 2;
}

void wcut_system_eval(wcut_system *y, const wcut_step *step, const wcut_vec3 *x, const double *s, double log_rate,
                      bool slopes) {
    const double rate = exp(log_rate);
    for (int i = 0; i < y->n; i++)
        wcut_resistance_eval(step->foam, step->heat, length_at(step, i), rate, y->n, x, step->was, i, slopes,
                             &y->node[i]);
    if (slopes) {
        wcut_banded_clear(&y->jacobian);
        for (int k = 0; k < y->size; k++) y->by_log_rate[k] = y->border[k] = 0;
    }
    put_lengths(y, step, x, s, slopes);
    put_equilibrium(y, step, x, s, rate, slopes);
    put_condition(y, step, x, slopes && !step->frame);
    if (step->frame) put_frame(y, step, x, s, slopes);
    if (slopes && mounts_give(step)) put_mounts(y, step, x, s, rate);
}

wcut_misfit wcut_system_misfit(const wcut_system *y, const wcut_step *step) {
    /* a load far below the target tension is held to what rounding of the target allows; where a dead load shapes the
       wire, that is the measure, however much more the foam pulls already */
    double scale = fmax(y->load, 1e-6 * step->tension);
    if (step->frame) scale = fmax(scale, 1e-3 * y->chord_pull); /* a bow is taut without a load */
    if (step->dead_load) scale = fmin(scale, 1e-4 * step->tension);
    wcut_misfit m = {.condition = fabs(y->condition) / (step->frame ? step->edge : step->tension)};
    for (int e = 0; e < y->n - 1; e++) m.strain = fmax(m.strain, fabs(y->residual[tension_at(e)]) / step->edge);
    for (int i = 1; i < y->n - 1; i++)
        for (int c = 0; c < 3; c++) m.balance = fmax(m.balance, fabs(y->residual[node_at(i) + c]) / scale);
    return m;
}
