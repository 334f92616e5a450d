/* A blade's stations: the limit of a wire that nothing bends (Rust et al. 2016, 3, with the whole law across the edge). */
#include "cut/blade.h"

#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/active_effects.h"

static void place_on_line(int n, wcut_vec3 a, wcut_vec3 b, wcut_vec3 *x) {
    for (int i = 0; i < n; i++) x[i] = vec3_mix(a, b, (double)i / (n - 1));
}

void wcut_blade_begin(wcut_cut *cut) {
    const wcut_setup *setup = cut->setup;
    wcut_wire *w = &cut->now;
    w->end_a = setup->end_a[0], w->end_b = setup->end_b[0];
    w->length = setup->length[0];
    w->condition = WCUT_CONDITION_TIME;
    place_on_line(setup->job->nodes, w->end_a, w->end_b, w->x);

    /* what of it is in the foam where it begins */
    wcut_vec3 unused[2];
    for (int i = 0; i < setup->job->nodes; i++)
        w->engaged[i] = wcut_block_engagement(&setup->foam.block, w->x[i], w->x[i], unused, unused + 1);
}

/* The force on a node of a blade from that on a wire's: (3) has the law's size times |t x d| against the motion, a blade the
   whole law against what of the motion is across the edge; drag along the edge is the same. */
static wcut_vec3 blade_force(wcut_vec3 force, wcut_vec3 t, wcut_vec3 move) {
    const double along = vec3_dot(t, move), square = vec3_dot(move, move);
    const wcut_vec3 across = vec3_add_scaled(move, -along, t), normal = vec3_unit(across);
    const double c = vec3_length(across);
    if (!(c > 0)) return vec3(0, 0, 0);
    const double size = -vec3_dot(force, normal) * square / (c * c);
    const double drag = vec3_dot(force, t) + size * c * along / square;
    return vec3_add_scaled(vec3_scale(-size, normal), drag, t);
}

static void load_nodes(wcut_cut *cut, const wcut_target *target, double rate) {
    const wcut_setup *setup = cut->setup;
    const int n = setup->job->nodes;
    wcut_wire *w = &cut->next;

    /* effects change the law */
    wcut_foam foam = setup->foam;
    wcut_step step = {.foam = &foam, .n = n};
    wcut_extension extension;
    wcut_extension_apply(cut, target, &extension, &foam, &step);

    /* node by node, all in the same direction of the edge */
    const wcut_vec3 t = vec3_unit(vec3_sub(target->end_b, target->end_a));
    w->loaded = false, w->front_speed = 0;
    for (int i = 0; i < n; i++) {
        wcut_resistance r;
        wcut_resistance_eval(&foam, target->heat, target->length / (n - 1), rate, n, w->x, cut->was, i, false, &r);
        const wcut_vec3 move = vec3_sub(w->x[i], cut->was[i]);
        const double across = vec3_length(vec3_cross(t, move)), distance = vec3_length(move);
        w->force[i] = blade_force(r.force, t, move);
        w->line[i] = across > 0 ? r.line * distance / across : 0;
        w->speed[i] = r.speed, w->engaged[i] = r.engaged;
        w->loaded = w->loaded || vec3_length(w->force[i]) > 0;
    }
    for (int e = 0; e < n - 1; e++) w->s[e] = 0;
}

wcut_status wcut_blade_advance(wcut_cut *cut, const wcut_target *target, double *elapsed, wcut_error *error) {
    const int n = cut->setup->job->nodes;
    wcut_wire *w = &cut->next;
    if (!is_positive(target->duration))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a blade has no tension that would set its speed: expected a feed");

    /* from line to line */
    for (int i = 0; i < n; i++) cut->was[i] = w->x[i];
    place_on_line(n, target->end_a, target->end_b, w->x);
    load_nodes(cut, target, 1 / target->duration);

    /* the step is taken as it is: there is nothing to solve */
    w->length = target->length;
    w->condition = WCUT_CONDITION_TIME;
    w->front_speed =
        fmax(vec3_distance(target->end_a, w->end_a), vec3_distance(target->end_b, w->end_b)) / target->duration;
    w->required_tension = 0;
    wcut_cut_remember(cut, target, 1 / target->duration);
    cut->substeps = 1;
    *elapsed += target->duration;

    return WCUT_OK;
}

double wcut_blade_reaction(int n, const wcut_vec3 *force, bool at_a) {
    wcut_vec3 sum = {0};
    for (int i = 0; i < n; i++) {
        const double share = (double)i / (n - 1);
        sum = vec3_add_scaled(sum, at_a ? 1 - share : share, force[i]);
    }
    return vec3_length(sum);
}
