/* A run of a cut, station by station. */
#include <string.h>
#include <wirecut/cut.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "cut/blade.h"
#include "cut/contact.h"
#include "cut/run.h"
#include "wire/chain.h"

static bool create_wire(int n, wcut_wire *w) {
    const size_t count = (size_t)n;
    w->x = wcut_alloc(count, sizeof *w->x);
    w->s = wcut_alloc(count, sizeof *w->s);
    w->pattern = wcut_alloc(count, sizeof *w->pattern);
    w->force = wcut_alloc(count, sizeof *w->force);
    w->line = wcut_alloc(count, sizeof *w->line);
    w->speed = wcut_alloc(count, sizeof *w->speed);
    w->engaged = wcut_alloc(count, sizeof *w->engaged);
    w->accumulated = wcut_alloc(count, sizeof *w->accumulated);
    w->state = wcut_alloc(count, sizeof *w->state);
    return w->state && w->x && w->s && w->pattern && w->force && w->line && w->speed && w->engaged && w->accumulated;
}

static void destroy_wire(wcut_wire *w) {
    wcut_free(w->x);
    wcut_free(w->s);
    wcut_free(w->pattern);
    wcut_free(w->force);
    wcut_free(w->line);
    wcut_free(w->speed);
    wcut_free(w->engaged);
    wcut_free(w->accumulated);
    wcut_free(w->state);
}

/* what the next step starts from; the fields that every step writes anew are left */
static void copy_wire(int n, int effects, const wcut_wire *from, wcut_wire *to) {
    const size_t count = (size_t)n;

    /* shape, tensions, load pattern and forces */
    memcpy(to->x, from->x, sizeof *to->x * count);
    memcpy(to->s, from->s, sizeof *to->s * count);
    memcpy(to->pattern, from->pattern, sizeof *to->pattern * count);
    memcpy(to->force, from->force, sizeof *to->force * count);
    memcpy(to->accumulated, from->accumulated, sizeof *to->accumulated * count);

    /* scalars of the last station */
    to->length = from->length;
    to->front_speed = from->front_speed;
    to->loaded = from->loaded;
    to->required_tension = from->required_tension;
    to->condition = from->condition;
    to->step_duration = from->step_duration;
    to->end_a = from->end_a, to->end_b = from->end_b;

    /* states of the nodes and mounts exist only with effects */
    if (effects == 0) return;
    memcpy(to->state, from->state, sizeof *to->state * count);
    memcpy(to->engaged, from->engaged, sizeof *to->engaged * count);
    for (int m = 0; m < 2; m++) to->offset[m] = from->offset[m], to->pull[m] = from->pull[m];
    to->pulled = from->pulled;
    to->age = from->age;
    to->clock = from->clock;
}

void wcut_contact_rule_set(wcut_cut *cut, wcut_contact_rule rule) {
    cut->contact_rule = rule;
    cut->weighted = rule == WCUT_CONTACT_HEAVY && cut->setup->weight == 0; /* it has its own */
}

/* station 0: the wire hangs trailing, under an even load against the feed; one with a weight hangs down */
static bool begin_cut(wcut_cut *cut) {
    /* an even load against the feed with the sum k gives the first shape */
    const wcut_setup *setup = cut->setup;
    const int n = setup->job->nodes;
    wcut_wire *w = &cut->now;
    if (setup->job->rig.kind == WCUT_RIG_KIND_BLADE) return wcut_blade_begin(cut), true;
    for (int i = 0; i < n; i++) w->pattern[i] = vec3_scale(-setup->job->tension / n, setup->feed);
    if (setup->weight > 0) wcut_cut_weigh(cut, w->pattern);

    const wcut_target target = {
        .end_a = setup->end_a[0], .end_b = setup->end_b[0], .length = setup->length[0], .heat = setup->job->heat};
    w->end_a = target.end_a, w->end_b = target.end_b;

    /* hang the wire between the mounts, and start from that shape */
    if (!wcut_cut_hang(cut, &target, w->pattern)) return false;
    memcpy(w->x, cut->hanging_shape, sizeof *w->x * (size_t)n);
    for (int e = 0; e < n - 1 && (setup->weight > 0 || cut->taut > 0); e++) w->s[e] = cut->hanging_tension[e];
    w->length = setup->length[0];
    w->front_speed = setup->job->speed_max;
    w->loaded = wcut_cut_touches(cut, w->x);
    w->condition = WCUT_CONDITION_SPEED_MAX;

    /* what of each node is in the foam where it begins; in a plan all of it */
    wcut_vec3 unused[2];
    for (int i = 0; i < n; i++)
        w->engaged[i] =
            setup->foam.embedded ? 1 : wcut_block_engagement(&setup->foam.block, w->x[i], w->x[i], unused, unused + 1);
    cut->touched = w->loaded;

    return true;
}

wcut_status wcut_cut_create(const wcut_setup *setup, wcut_cut **out, wcut_error *error) {
    if (!setup || !out) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a setup and a place for the cut are expected");
    const int n = setup->job->nodes;
    wcut_cut *cut = wcut_alloc(1, sizeof *cut);
    if (!cut) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a run");

    /* scratch of the solver's sub-steps, one value a node */
    cut->setup = setup;
    wcut_contact_rule_set(cut, setup->options.weighted ? WCUT_CONTACT_HEAVY : WCUT_CONTACT_BY_WEIGHT);
    cut->was = wcut_alloc((size_t)n, sizeof *cut->was);
    cut->hanging_shape = wcut_alloc((size_t)n, sizeof *cut->hanging_shape);
    cut->hanging_tension = wcut_alloc((size_t)n, sizeof *cut->hanging_tension);
    cut->kept = wcut_alloc((size_t)n, sizeof *cut->kept);
    cut->contact = wcut_alloc((size_t)n, sizeof *cut->contact);
    cut->dead_load = wcut_alloc((size_t)n, sizeof *cut->dead_load);
    cut->softer = wcut_alloc((size_t)n, sizeof *cut->softer);
    cut->softer_tension = wcut_alloc((size_t)n, sizeof *cut->softer_tension);
    cut->edge = wcut_alloc((size_t)n, sizeof *cut->edge);
    cut->rest = wcut_alloc((size_t)n, sizeof *cut->rest);

    /* the present wire, the next one and Newton's system */
    bool whole = create_wire(n, &cut->now);
    whole = create_wire(n, &cut->next) && whole;
    whole = wcut_solver_create(n, &cut->solver) && whole;
    wcut_status status = WCUT_OK;
    if (!whole || !cut->was || !cut->hanging_shape || !cut->hanging_tension || !cut->kept || !cut->contact ||
        !cut->dead_load || !cut->softer || !cut->softer_tension || !cut->edge || !cut->rest)
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a wire of %d nodes", n);
    else if (!begin_cut(cut))
        status = wcut_fail(error, WCUT_NOT_CONVERGED, "station 0: no equilibrium of the wire found under an even load");
    if (status == WCUT_OK)
        *out = cut;
    else
        wcut_cut_destroy(cut);

    return status;
}

void wcut_cut_destroy(wcut_cut *cut) {
    if (!cut) return;
    destroy_wire(&cut->now);
    destroy_wire(&cut->next);
    wcut_solver_destroy(&cut->solver);
    wcut_free(cut->was);
    wcut_free(cut->hanging_shape);
    wcut_free(cut->hanging_tension);
    wcut_free(cut->kept);
    wcut_free(cut->contact);
    wcut_free(cut->dead_load);
    wcut_free(cut->softer);
    wcut_free(cut->softer_tension);
    wcut_free(cut->edge);
    wcut_free(cut->rest);
    wcut_free(cut);
}

/* advance to a target; on success `next` becomes `now` */
static wcut_status advance_wire(wcut_cut *cut, const wcut_target *target, wcut_integrator integrator,
                                wcut_error *error) {
    const int n = cut->setup->job->nodes;

    /* way of both mounts in this step */
    const double way_a = vec3_distance(target->end_a, cut->now.end_a);
    const double way_b = vec3_distance(target->end_b, cut->now.end_b);

    /* the next wire starts as the present one */
    double elapsed = 0;
    cut->iterations = cut->substeps = 0;
    cut->residual = 0;
    copy_wire(n, cut->setup->effect_count, &cut->now, &cut->next);

    /* solve the step by the chosen integrator */
    const bool blade = cut->setup->job->rig.kind == WCUT_RIG_KIND_BLADE;
    const wcut_status status = blade ? wcut_blade_advance(cut, target, &elapsed, error)
                               : integrator == WCUT_INTEGRATOR_HEUN
                                   ? wcut_heun_advance(cut, target, &elapsed, error)
                                   : wcut_implicit_advance(cut, target, &elapsed, error);
    if (status != WCUT_OK) return status;

    /* swap: the next wire becomes the present one */
    cut->next.end_a = target->end_a, cut->next.end_b = target->end_b;
    const wcut_wire spare = cut->now;
    cut->now = cut->next;
    cut->next = spare;

    /* index, time and the speeds of the mounts */
    cut->index++;
    cut->time += elapsed;
    cut->duration = elapsed;
    cut->speed_a = way_a / elapsed;
    cut->speed_b = way_b / elapsed;
    cut->touched = cut->touched || cut->now.loaded;

    return WCUT_OK;
}

/* with a commanded speed the step's duration is given, and the tension is the answer */
static wcut_status time_by_feed(const wcut_cut *cut, int j, wcut_target *target) {
    const wcut_feed *feed = &cut->setup->job->feed;
    if (feed->kind == WCUT_FEED_KIND_NONE || cut->setup->foam.embedded) return WCUT_OK;
    const double way = fmax(vec3_distance(target->end_a, cut->now.end_a), vec3_distance(target->end_b, cut->now.end_b));
    return wcut_feed_eval(feed, j, cut->time, way, &target->duration);
}

wcut_status wcut_cut_step(wcut_cut *cut, wcut_error *error) {
    if (!cut) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a run is expected");
    const wcut_setup *setup = cut->setup;
    const int j = cut->index + 1;
    if (j >= setup->stations)
        return wcut_fail(error, WCUT_NOT_FOUND, "station %d: the path ends with station %d", j, j - 1);
    if (cut->over) return wcut_fail(error, WCUT_NOT_CONVERGED, "station %d: the run has ended before", j);
    wcut_target target = {
        .end_a = setup->end_a[j], .end_b = setup->end_b[j], .length = setup->length[j], .heat = setup->job->heat};
    wcut_error cause = {0};
    wcut_status status = time_by_feed(cut, j, &target);
    if (status == WCUT_OK) status = advance_wire(cut, &target, setup->options.integrator, &cause);
    if (status == WCUT_OK) return WCUT_OK;
    cut->over = true;
    return wcut_fail(error, status, "station %d: %s", j, cause.text);
}

wcut_status wcut_cut_drive(wcut_cut *cut, wcut_vec3 mount_a, wcut_vec3 mount_b, double duration, double heat,
                           wcut_error *error) {
    if (!cut || !vec3_is_finite(mount_a) || !vec3_is_finite(mount_b) || !is_positive(duration) || !is_positive(heat))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a run, finite positions, a positive duration and heat are expected");
    const wcut_setup *setup = cut->setup;
    if (setup->foam.embedded || setup->options.integrator != WCUT_INTEGRATOR_IMPLICIT)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "time-driven steps are for mounts and the implicit integrator");
    const double wire = setup->length[0];
    const double chord = vec3_distance(mount_a, mount_b);
    if (chord > wire && !setup->bow.on)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "the mounts are %.6g mm apart, the wire is %.6g mm long", chord,
                         wire);
    const wcut_target target = {.end_a = vec3_sub(mount_a, setup->shift),
                                .end_b = vec3_sub(mount_b, setup->shift),
                                .length = wire,
                                .duration = duration,
                                .heat = heat};
    return advance_wire(cut, &target, WCUT_INTEGRATOR_IMPLICIT, error);
}

static double engaged_length(int n, const wcut_wire *w) {
    double length = 0;
    for (int i = 0; i < n; i++) length += w->engaged[i] * w->length / (n - 1) * (i > 0 && i < n - 1 ? 1 : 0.5);
    return length;
}

/* whether no node of the span over the block, x = 0 .. W, is out of the foam */
static bool wire_is_whole(const wcut_setup *setup, const wcut_wire *w) {
    if (setup->foam.embedded) return true;
    for (int i = 0; i < setup->job->nodes; i++) {
        const double x = w->x[i].x, margin = w->length / (setup->job->nodes - 1);
        if (x > margin && x < setup->job->block_size.x - margin && w->engaged[i] < 1) return false;
    }
    return true;
}

static wcut_phase phase_of(const wcut_cut *cut) {
    const wcut_setup *setup = cut->setup;
    if (!cut->now.loaded) return cut->touched ? WCUT_PHASE_LEFT : WCUT_PHASE_APPROACH;
    if (cut->index < setup->entry_end) return WCUT_PHASE_ENTRY;
    if (cut->index > setup->exit_begin) return WCUT_PHASE_EXIT;
    if (wire_is_whole(setup, &cut->now)) return WCUT_PHASE_STEADY;
    const double middle = (cut->now.x[0].y + cut->now.x[setup->job->nodes - 1].y) / 2;
    return middle < setup->job->block_size.y / 2 ? WCUT_PHASE_ENTRY : WCUT_PHASE_EXIT;
}

/* what a mount holds: the pull of its edge, the foam on its own node, and that node's weight [N] */
static double mount_tension(wcut_vec3 mount, wcut_vec3 next, double s, wcut_vec3 force, double weight) {
    const wcut_vec3 load = vec3(force.x, force.y, force.z - weight);
    return vec3_length(vec3_add_scaled(load, s, vec3_unit(vec3_sub(next, mount))));
}

void wcut_cut_view(const wcut_cut *cut, wcut_station *station) {
    if (!cut || !station) return;

    /* everything of the present station, borrowed from the cut */
    const int n = cut->setup->job->nodes;
    const wcut_wire *w = &cut->now;
    const double weight = cut->setup->weight * w->length / (n - 1) / 2; /* of an end */
    *station =
        (wcut_station){.index = cut->index,
                       .time = cut->time,
                       .duration = cut->duration,
                       .nodes = n,
                       .position = w->x,
                       .force = w->force,
                       .force_line = w->line,
                       .speed = w->speed,
                       .tension = w->s,
                       .engaged = w->engaged,
                       .mount_a = w->end_a,
                       .mount_b = w->end_b,
                       .speed_a = cut->speed_a,
                       .speed_b = cut->speed_b,
                       .tension_a = mount_tension(w->x[0], w->x[1], w->s[0], w->force[0], weight),
                       .tension_b = mount_tension(w->x[n - 1], w->x[n - 2], w->s[n - 2], w->force[n - 1], weight),
                       .engaged_length = engaged_length(n, w),
                       .phase = phase_of(cut),
                       .condition = w->condition,
                       .iterations = cut->iterations,
                       .substeps = cut->substeps,
                       .residual = cut->residual};
    if (cut->setup->job->rig.kind == WCUT_RIG_KIND_BLADE) {
        station->tension_a = wcut_blade_reaction(n, w->force, true);
        station->tension_b = wcut_blade_reaction(n, w->force, false);
    }
    wcut_chain_angles(n, w->x, &station->alpha_a, &station->beta_a, &station->alpha_b, &station->beta_b);
}

const char *wcut_phase_name(wcut_phase phase) {
    static const char *const text[] = {"approach", "entry", "steady", "exit", "left"};
    return (unsigned)phase < sizeof text / sizeof *text ? text[phase] : "unknown";
}

const char *wcut_condition_name(wcut_condition condition) {
    static const char *const text[] = {"tension", "speed_max", "speed_min", "time"};
    return (unsigned)condition < sizeof text / sizeof *text ? text[condition] : "unknown";
}
