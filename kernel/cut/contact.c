/* The wire that the foam does not load, and how it comes to be loaded: hanging, leaning on a face, taut. */
#include "cut/contact.h"

#include <string.h>

#include "base/numbers.h"
#include "cut/active_effects.h"
#include "cut/sensitivity.h"
#include "wire/equilibrium.h"

void wcut_cut_weigh(const wcut_cut *cut, wcut_vec3 *load) {
    const wcut_setup *setup = cut->setup;
    const int n = setup->job->nodes;
    const double edge = setup->weight * setup->length[0] / (n - 1);
    for (int i = 0; i < n; i++) load[i] = vec3(0, 0, i == 0 || i == n - 1 ? -edge / 2 : -edge);
}

bool wcut_cut_hang(wcut_cut *cut, const wcut_target *target, const wcut_vec3 *load) {
    const int n = cut->setup->job->nodes;
    const wcut_equilibrium_options options = {.tolerance = 1e-9, .max_iterations = 100};
    wcut_vec3 a, b;
    const double length = wcut_cut_fit(cut, target, &a, &b), chord = vec3_distance(a, b);
    cut->hanging_shape[0] = a, cut->hanging_shape[n - 1] = b;
    if (cut->taut > 0 || length <= chord * (1 + 1e-12)) {
        for (int i = 1; i < n - 1; i++) cut->hanging_shape[i] = vec3_mix(a, b, (double)i / (n - 1));
        for (int e = 0; e < n - 1; e++) cut->hanging_tension[e] = cut->taut;
        return true;
    }
    if (wcut_equilibrium_shape(n, load, cut->edge, &options, cut->hanging_shape, cut->hanging_tension, NULL) != WCUT_OK)
        return false;
    for (int e = 0; e < n - 1; e++) cut->hanging_tension[e] *= cut->edge[e];
    return true;
}

bool wcut_cut_touches(const wcut_cut *cut, const wcut_vec3 *x) {
    const wcut_foam *foam = &cut->setup->foam;
    const int n = cut->setup->job->nodes;
    if (foam->embedded) return true;
    wcut_vec3 unused[2];
    for (int e = 0; e < n - 1; e++)
        if (wcut_block_engagement(&foam->block, x[e], x[e + 1], unused, unused + 1) > 0) return true;
    return false;
}

/* what the tensions of a wire that hangs or leans are over those of its pattern: its weight is the part of it that is
   known; 0 without a weight */
static double weight_scale(const wcut_cut *cut) {
    const int n = cut->setup->job->nodes;
    double down = 0;
    for (int i = 0; i < n; i++) down -= cut->next.pattern[i].z;
    return cut->setup->weight > 0 && down > 0 ? cut->setup->weight * cut->setup->length[0] / down : 0;
}

void wcut_cut_feed_free(wcut_cut *cut, const wcut_target *target, double reach, double *elapsed) {
    /* the time: given, or what the faster mount needs at the highest speed */
    const wcut_job *job = cut->setup->job;
    const int n = job->nodes;
    wcut_wire *w = &cut->next;
    if (cut->sensitivity) wcut_sensitivity_hang(cut, target, w->pattern);
    const double duration = target->duration > 0 ? target->duration : reach / job->speed_max;

    /* the wire hangs in its last pattern, without force and outside the foam */
    for (int i = 0; i < n; i++) {
        w->x[i] = cut->hanging_shape[i];
        w->force[i] = vec3(0, 0, 0);
        w->line[i] = w->engaged[i] = 0;
        w->speed[i] = vec3_distance(cut->hanging_shape[i], cut->was[i]) / duration;
    }

    /* no tension counts; the condition is the one that set the speed */
    const double scale = weight_scale(cut);
    for (int e = 0; e < n - 1; e++) w->s[e] = cut->taut > 0 ? cut->taut : scale * cut->hanging_tension[e];
    w->length = target->length;
    w->loaded = false;
    w->required_tension = 0;
    w->condition = target->duration > 0 ? WCUT_CONDITION_TIME : WCUT_CONDITION_SPEED_MAX;
    w->front_speed = reach / duration;

    /* states of the nodes follow the step, then the clock */
    wcut_cut_remember(cut, target, 1 / duration);
    *elapsed += duration;
}

/* the direction in which both ends together move to the target */
static wcut_vec3 heading(const wcut_cut *cut, const wcut_target *target) {
    const wcut_vec3 *from = cut->next.x;
    const int n = cut->setup->job->nodes;
    return vec3_unit(vec3_add(vec3_sub(target->end_a, from[0]), vec3_sub(target->end_b, from[n - 1])));
}

/* the load of the foam on whatever touches, at v_max against the motion, into cut->contact; false where nothing does */
static bool find_contact(wcut_cut *cut, const wcut_target *target) {
    const wcut_setup *setup = cut->setup;
    const int n = setup->job->nodes;
    const double edge = target->length / (n - 1);
    const wcut_vec3 move = heading(cut, target);
    const double force = wcut_force_law_eval(&setup->foam.law, target->heat, setup->job->speed_max);
    double load = 0;
    for (int i = 0; i < n; i++) {
        wcut_resistance f;
        wcut_resistance_eval(&setup->foam, target->heat, edge, 1, n, cut->hanging_shape, cut->was, i, false, &f);
        cut->contact[i] = vec3_scale(-force * f.engaged * edge, move);
        if (i > 0 && i < n - 1) load += vec3_length(cut->contact[i]);
    }
    return load > 0;
}

double wcut_load_sum(int n, const wcut_vec3 *load) {
    double sum = 0;
    for (int i = 1; i < n - 1; i++) sum += vec3_length(load[i]);
    return sum;
}

/* hang the wire under a share of the contact and for the rest under its old pattern; whether it still touches */
static bool touches_leaning(wcut_cut *cut, const wcut_target *target, double share) {
    const int n = cut->setup->job->nodes;
    const double scale = (1 - share) * wcut_load_sum(n, cut->contact) / wcut_load_sum(n, cut->kept);
    for (int i = 0; i < n; i++)
        cut->next.pattern[i] = vec3_add_scaled(vec3_scale(share, cut->contact[i]), scale, cut->kept[i]);
    return wcut_cut_hang(cut, target, cut->next.pattern) && wcut_cut_touches(cut, cut->hanging_shape);
}

/* A wire that has lost its load in parts goes slack there and has no one shape under the rest; an even load of a
   hundredth of it, against the motion, gives it one. */
static bool hang_slack(wcut_cut *cut, const wcut_target *target) {
    const int n = cut->setup->job->nodes;
    wcut_wire *w = &cut->next;
    const wcut_vec3 move = heading(cut, target);
    double load = 0;
    for (int i = 0; i < n; i++) load += vec3_length(w->pattern[i]);
    for (int i = 0; i < n; i++) w->pattern[i] = vec3_add_scaled(w->pattern[i], -0.01 * load / n, move);
    return wcut_cut_hang(cut, target, w->pattern);
}

/* A hanging wire that comes to touch the foam has slack: what touches leans on the face, without force to speak of, and
   holds back until the rest has been pulled straight. Only a wire that touches even when it hangs on nothing but its
   contact is loaded by it (and that contact is the load to begin with); before, it leans just so far that it does not
   enter. */
static wcut_contact_state lean(wcut_cut *cut, const wcut_target *target) {
    const double max = 0.999; /* a wire on its contact alone may have parts without any load, hence without a shape */
    if (!find_contact(cut, target)) return WCUT_CONTACT_FREE;
    if (touches_leaning(cut, target, max)) return WCUT_CONTACT_SLACK;
    double low = 0, high = max;
    for (int i = 0; i < 20; i++) {
        const double middle = (low + high) / 2;
        if (touches_leaning(cut, target, middle))
            low = middle;
        else
            high = middle;
    }
    touches_leaning(cut, target, high);
    return WCUT_CONTACT_FREE;
}

wcut_contact_state wcut_contact_find(wcut_cut *cut, const wcut_target *target) {
    bool slack = !cut->next.loaded;
    if (!wcut_cut_hang(cut, target, cut->next.pattern)) {
        if (!hang_slack(cut, target)) return WCUT_CONTACT_NO_SHAPE;
        slack = true;
    }
    memcpy(cut->kept, cut->next.pattern, sizeof *cut->kept * (size_t)cut->setup->job->nodes);

    /* a bow's taut wire hangs on no pattern: it is loaded where it touches, straight or as it was */
    if (cut->taut > 0) {
        const bool touches =
            wcut_cut_touches(cut, cut->hanging_shape) || (cut->next.loaded && wcut_cut_touches(cut, cut->was));
        return touches ? WCUT_CONTACT_LOADED : WCUT_CONTACT_FREE;
    }

    /* a wire that the foam has let go hangs by its weight, where it has one */
    if (!wcut_cut_touches(cut, cut->hanging_shape)) {
        if (slack || cut->setup->weight == 0) return WCUT_CONTACT_FREE;
        wcut_cut_weigh(cut, cut->next.pattern);
        memcpy(cut->kept, cut->next.pattern, sizeof *cut->kept * (size_t)cut->setup->job->nodes);
        if (!wcut_cut_hang(cut, target, cut->next.pattern)) return WCUT_CONTACT_NO_SHAPE;
        if (!wcut_cut_touches(cut, cut->hanging_shape)) return WCUT_CONTACT_FREE;
        slack = true;
    }
    if (cut->weighted) return WCUT_CONTACT_LOADED;
    return slack && !cut->setup->foam.embedded ? lean(cut, target) : WCUT_CONTACT_LOADED;
}
