/* The effects of a run: made ready for a sub-step, remembered after it. */
#include "cut/effects.h"

#include <stddef.h>

static const wcut_effect *find(const wcut_setup *setup, wcut_effect_kind kind) {
    for (int e = 0; e < setup->effect_count; e++)
        if (setup->effect[e].kind == kind) return &setup->effect[e];
    return NULL;
}

/* wire_elongation: strain at 60 W/m in the foam without tension */
static double thermal_strain(const wcut_effect *e) { return e->value[0] * e->value[1]; }

double wcut_cut_rest(wcut_cut *cut, const wcut_target *target) {
    const int n = cut->setup->job->nodes;
    const wcut_effect *longer = find(cut->setup, WCUT_WIRE_ELONGATION);
    const double edge = target->length / (n - 1), *inside = cut->next.engaged;
    for (int e = 0; e < n - 1; e++) cut->edge[e] = edge;
    if (!longer) return target->length;
    const double strain = thermal_strain(longer) * target->heat / 60, air = longer->value[2];
    double sum = 0;
    for (int e = 0; e < n - 1; e++) {
        const double share = (inside[e] + inside[e + 1]) / 2;
        cut->edge[e] *= 1 + strain * (share + (1 - share) * air);
        sum += cut->edge[e];
    }
    return sum;
}

/* mean way of both ends to the target [mm] */
static double way_to(const wcut_wire *w, const wcut_target *target) {
    return (vec3_distance(target->end_a, w->end_a) + vec3_distance(target->end_b, w->end_b)) / 2;
}

static wcut_locality locality_of(const wcut_cut *cut, const wcut_target *target, double cut_length) {
    return (wcut_locality){.count = cut->setup->effect_count,
                           .effect = cut->setup->effect,
                           .state = cut->next.state,
                           .edge = target->length / (cut->setup->job->nodes - 1),
                           .cut_length = cut_length};
}

void wcut_extension_apply(wcut_cut *cut, const wcut_target *target, wcut_extension *out, wcut_foam *foam,
                          wcut_step *step) {
    const wcut_setup *setup = cut->setup;
    const wcut_wire *w = &cut->next;
    if (setup->effect_count == 0) return;
    out->local = locality_of(cut, target, w->cut_length + way_to(w, target));
    foam->local = &out->local;
    const wcut_effect *longer = find(setup, WCUT_WIRE_ELONGATION), *mounts = find(setup, WCUT_MOUNT_COMPLIANCE);
    if (!longer && !mounts) return;
    out->yielding = (wcut_yielding){.mount = {{target->end_a, w->offset[0], w->pull[0], w->pulled},
                                              {target->end_b, w->offset[1], w->pull[1], w->pulled}}};
    if (longer) {
        double sum = 0;
        for (int e = 0; e < step->n - 1; e++) sum += cut->edge[e];
        step->edge = sum / (step->n - 1); /* what the foam acts on, per length, has got longer */
        out->yielding.rest = cut->edge;
        out->yielding.softness =
            (longer->value[0] - thermal_strain(longer)) / 2; /* the rest of the strain is 2 N / EA */
    }
    if (mounts) out->yielding.compliance = 1 / mounts->value[0], out->yielding.settling = mounts->value[1];
    step->yielding = &out->yielding;
}

static void remember_mounts(wcut_wire *w, int n, const wcut_target *target) {
    w->offset[0] = vec3_sub(w->x[0], target->end_a);
    w->offset[1] = vec3_sub(w->x[n - 1], target->end_b);
    w->pull[0] = vec3_scale(w->s[0], vec3_unit(vec3_sub(w->x[1], w->x[0])));
    w->pull[1] = vec3_scale(w->s[n - 2], vec3_unit(vec3_sub(w->x[n - 2], w->x[n - 1])));
    w->pulled = true;
}

void wcut_cut_remember(wcut_cut *cut, const wcut_target *target, double rate) {
    const wcut_setup *setup = cut->setup;
    wcut_wire *w = &cut->next;
    const int n = setup->job->nodes;
    if (setup->effect_count > 0) {
        const wcut_locality local = locality_of(cut, target, 0);
        wcut_vec3 unused;
        for (int i = 0; i < n; i++) {
            const double inside = wcut_foam_inside(&setup->foam, cut->was[i], w->x[i], &unused);
            w->state[i] = wcut_node_state_after(&local, target->heat, rate, w->speed[i], inside, n, i);
        }
        if (w->loaded) w->cut_length += way_to(w, target);
        remember_mounts(w, n, target);
    }
    w->end_a = target->end_a, w->end_b = target->end_b;
}
