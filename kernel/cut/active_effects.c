/* The effects of a run: made ready for a sub-step, remembered after it. */
#include "cut/active_effects.h"

#include <stddef.h>

static const wcut_effect *find_setup_effect(const wcut_setup *setup, wcut_effect_kind kind) {
    for (int e = 0; e < setup->effect_count; e++)
        if (setup->effect[e].kind == kind) return &setup->effect[e];
    return NULL;
}

/* choices of mount_compliance: which mounts give way; the last, both along the feed (y) alone */
enum { WCUT_MOUNTS_BOTH, WCUT_MOUNTS_A, WCUT_MOUNTS_B, WCUT_MOUNTS_FEED };

/* wire_elongation: strain at 60 W/m in the foam without tension */
static double thermal_strain(const wcut_effect *e) {
    return e->value[WCUT_WIRE_ELONGATION_STRAIN] * e->value[WCUT_WIRE_ELONGATION_THERMAL_SHARE];
}

/* [1/N] 1/EA: what is not of heat is the stretch under 2 N */
static double softness(const wcut_effect *e) { return (e->value[WCUT_WIRE_ELONGATION_STRAIN] - thermal_strain(e)) / 2; }

/* Edges of a bow's wire, warm by the engagement they come with, and the tension that it has where it is straight; its
   ends where the frame has them then. */
static double fit_bow(wcut_cut *cut, const wcut_target *target, wcut_vec3 *end_a, wcut_vec3 *end_b) {
    const wcut_setup *setup = cut->setup;
    const wcut_bow *bow = &setup->bow;
    const wcut_wire *w = &cut->next;
    const int n = setup->job->nodes;

    /* strains in air and in foam at the speed of the feed */
    const double way = fmax(vec3_distance(target->end_a, w->end_a), vec3_distance(target->end_b, w->end_b));
    double air, foam, rest = 0;
    wcut_bow_warm(bow, setup->job, target->heat, target->duration > 0 ? way / target->duration : 0, &air, &foam);
    for (int e = 0; e < n - 1; e++) {
        const double share = (w->engaged[e] + w->engaged[e + 1]) / 2;
        cut->rest[e] = target->length / (n - 1) * (1 + share * foam + (1 - share) * air);
        rest += cut->rest[e];
    }

    /* straight under its own tension, or slack between the ends of a frame that nothing pulls */
    cut->frame = wcut_bow_frame_at(bow, target->end_a, target->end_b);
    cut->taut = wcut_bow_tension(bow, rest);
    const double closing = bow->give * (cut->taut - bow->pretension);
    *end_a = wcut_bow_frame_end(&cut->frame, closing, 0);
    *end_b = wcut_bow_frame_end(&cut->frame, closing, 1);
    for (int e = 0; e < n - 1; e++)
        cut->edge[e] = cut->rest[e] * (1 + bow->softness * (w->loaded ? w->s[e] : cut->taut));
    return rest * (1 + bow->softness * cut->taut);
}

double wcut_cut_fit(wcut_cut *cut, const wcut_target *target, wcut_vec3 *end_a, wcut_vec3 *end_b) {
    const wcut_wire *w = &cut->next;
    const int n = cut->setup->job->nodes;
    const double edge = target->length / (n - 1);

    if (cut->setup->bow.on) return fit_bow(cut, target, end_a, end_b);

    /* rest lengths and present lengths are equal without effects */
    for (int e = 0; e < n - 1; e++) cut->rest[e] = cut->edge[e] = edge;
    *end_a = target->end_a, *end_b = target->end_b;

    /* a mount that gives carries the end of the wire with it */
    if (w->loaded && find_setup_effect(cut->setup, WCUT_EFFECT_MOUNT_COMPLIANCE)) {
        *end_a = vec3_add(*end_a, w->offset[0]);
        *end_b = vec3_add(*end_b, w->offset[1]);
    }

    /* thermal strain at this heat, less where the wire is in air */
    const wcut_effect *longer = find_setup_effect(cut->setup, WCUT_EFFECT_WIRE_ELONGATION);
    if (!longer) return target->length;
    const double strain = thermal_strain(longer) * target->heat / 60,
                 air = longer->value[WCUT_WIRE_ELONGATION_AIR_FACTOR];
    double sum = 0;

    /* each edge: its rest length when hot, then longer by its tension */
    for (int e = 0; e < n - 1; e++) {
        const double share = (w->engaged[e] + w->engaged[e + 1]) / 2;
        cut->rest[e] *= 1 + strain * (share + (1 - share) * air);
        cut->edge[e] = cut->rest[e] * (1 + softness(longer) * w->s[e]);
        sum += cut->edge[e];
    }

    return sum;
}

static wcut_locality locality_of(const wcut_cut *cut, const wcut_target *target) {
    return (wcut_locality){.count = cut->setup->effect_count,
                           .effect = cut->setup->effect,
                           .state = cut->next.state,
                           .age = cut->next.age,
                           .clock = cut->next.clock,
                           .was = cut->was,
                           .edge = target->length / (cut->setup->job->nodes - 1)};
}

/* a bow's wire stretches on a frame that gives; one that does neither has the lengths of a plain step */
static void apply_bow(const wcut_cut *cut, wcut_extension *out, wcut_step *step) {
    const wcut_bow *bow = &cut->setup->bow;
    step->frame = &cut->frame;
    if (bow->softness == 0 && bow->expansion == 0) return;
    double sum = 0;
    for (int e = 0; e < step->n - 1; e++) sum += cut->edge[e];
    step->edge = sum / (step->n - 1);
    step->lengths = cut->edge; /* the foam acts on the wire as long as it is where it comes from */
    out->compliance = (wcut_compliance){.rest = cut->rest, .softness = bow->softness};
    step->compliance = &out->compliance;
}

void wcut_extension_apply(wcut_cut *cut, const wcut_target *target, wcut_extension *out, wcut_foam *foam,
                          wcut_step *step) {
    const wcut_setup *setup = cut->setup;
    const wcut_wire *w = &cut->next;
    if (setup->bow.on) apply_bow(cut, out, step);
    if (setup->effect_count == 0) return;

    /* the law at a node sees the effects' states */
    out->local = locality_of(cut, target);
    foam->local = &out->local;
    const wcut_effect *longer = find_setup_effect(setup, WCUT_EFFECT_WIRE_ELONGATION),
                      *mounts = find_setup_effect(setup, WCUT_EFFECT_MOUNT_COMPLIANCE);

    /* without elongation and compliance the step stays as it is */
    if (!longer && !mounts) return;
    out->compliance = (wcut_compliance){.mount = {{target->end_a, w->offset[0], w->pull[0], w->pulled},
                                                  {target->end_b, w->offset[1], w->pull[1], w->pulled}}};

    /* the solver works with the mean rest length, and corrects each edge by its own */
    if (longer) {
        double sum = 0;
        for (int e = 0; e < step->n - 1; e++) sum += cut->rest[e];
        step->edge = sum / (step->n - 1); /* what the foam acts on, per length, has got longer */
        out->compliance.rest = cut->rest;
        out->compliance.softness = softness(longer);
    }

    /* compliance of the mounts, as displacement per tension, and their settling time */
    if (mounts) {
        const double give = 1 / mounts->value[WCUT_MOUNT_COMPLIANCE_STIFFNESS];
        const bool feed = mounts->choice == WCUT_MOUNTS_FEED;
        for (int m = 0; m < 2; m++)
            if (feed || mounts->choice == WCUT_MOUNTS_BOTH || mounts->choice == (m ? WCUT_MOUNTS_B : WCUT_MOUNTS_A))
                out->compliance.give[m] = feed ? (wcut_vec3){0, give, 0} : (wcut_vec3){give, give, give};
        out->compliance.settling = mounts->value[WCUT_MOUNT_COMPLIANCE_SETTLING];
    }
    step->compliance = &out->compliance;
}

static void remember_mounts(wcut_wire *w, int n, const wcut_target *target) {
    w->offset[0] = vec3_sub(w->x[0], target->end_a);
    w->offset[1] = vec3_sub(w->x[n - 1], target->end_b);
    w->pull[0] = vec3_scale(w->s[0], vec3_unit(vec3_sub(w->x[1], w->x[0])));
    w->pull[1] = vec3_scale(w->s[n - 2], vec3_unit(vec3_sub(w->x[n - 2], w->x[n - 1])));
    w->pulled = true;
}

void wcut_cut_set_clock(wcut_cut *cut, double time) { cut->now.clock = time; }

void wcut_cut_remember(wcut_cut *cut, const wcut_target *target, double rate) {
    const wcut_setup *setup = cut->setup;
    wcut_wire *w = &cut->next;
    const int n = setup->job->nodes;
    if (setup->effect_count > 0) {
        const wcut_locality local = locality_of(cut, target);
        for (int i = 0; i < n; i++) {
            const double inside = wcut_foam_inside(&setup->foam, cut->was[i], w->x[i]);
            w->state[i] = wcut_node_state_after(&local, target->heat, rate, w->speed[i], inside, n, i);
        }
        w->age = w->loaded ? w->age + 1 / rate : 0;
        w->clock += 1 / rate;
        remember_mounts(w, n, target);
    }
    w->end_a = target->end_a, w->end_b = target->end_b;
}
