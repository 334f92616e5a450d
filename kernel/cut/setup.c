/* Check a job and prepare what its runs share. */
#include "cut/setup.h"

#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "cut/job_rig.h"

/* [m/s2] standard gravity */
#define GRAVITY 9.80665
/* [kg/m3] no metal is denser */
#define DENSITY_MAX 23000.0

#define COUNT_MAX 10000000 /* nodes, stations, entries of a list: index arithmetic stays within int */
#define FEED_WAY 0.25      /* [1] wire lengths of way that tell the feed */

wcut_cut_options wcut_cut_options_default(void) {
    return (wcut_cut_options){
        .integrator = WCUT_INTEGRATOR_IMPLICIT, .tolerance = 1e-10, .max_iterations = 40, .max_halvings = 10};
}

static wcut_status expect_positive(wcut_error *error, const char *key, double value) {
    if (is_positive(value)) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found %g, expected a number greater than 0", key, value);
}

static wcut_status check_job_numbers(const wcut_job *job, wcut_error *error) {
    /* every number that must be positive, under its key in the job's file */
    const struct {
        const char *key;
        double value;
    } positive[] = {{"block.size_mm[0]", job->block_size.x},
                    {"block.size_mm[1]", job->block_size.y},
                    {"block.size_mm[2]", job->block_size.z},
                    {"wire.diameter_mm", job->wire_diameter},
                    {"process.force_law.a_N_per_mm", job->force_law.a},
                    {"process.force_law.b_m2_per_J", job->force_law.b},
                    {"limits.speed_max_mm_s", job->speed_max},
                    {"limits.speed_min_mm_s", job->speed_min}};
    for (size_t i = 0; i < sizeof positive / sizeof *positive; i++) {
        const wcut_status status = expect_positive(error, positive[i].key, positive[i].value);
        if (status != WCUT_OK) return status;
    }

    /* the cold law F = a is that of a blade; a tension is held by two arms */
    if (!(job->heat == 0 && job->rig.kind == WCUT_RIG_KIND_BLADE)) {
        const wcut_status status = expect_positive(error, "process.heat_W_per_m", job->heat);
        if (status != WCUT_OK) return status;
    }
    if (job->rig.kind == WCUT_RIG_KIND_TWO_ARMS) {
        const wcut_status status = expect_positive(error, "process.tension_N", job->tension);
        if (status != WCUT_OK) return status;
    }

    /* a weight, which may be none */
    if (!(job->wire_density >= 0 && job->wire_density <= DENSITY_MAX))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "wire.density_kg_per_m3: found %g, expected 0 to %g",
                         job->wire_density, DENSITY_MAX);

    /* limits and counts */
    if (job->speed_min >= job->speed_max)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "limits.speed_min_mm_s: found %g, expected less than speed_max_mm_s = %g", job->speed_min,
                         job->speed_max);
    if (job->nodes < 3 || job->nodes > COUNT_MAX)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "wire.nodes: found %d, expected at least 3 and at most %d",
                         job->nodes, COUNT_MAX);
    if (job->stations < 2 || job->stations > COUNT_MAX)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "stations: found %d, expected at least 2 and at most %d",
                         job->stations, COUNT_MAX);

    return WCUT_OK;
}

/* arrays that their counts speak of, and values of enumerations */
static wcut_status check_lists(const wcut_job *job, wcut_error *error) {
    if (job->mode != WCUT_MODE_PATH && job->mode != WCUT_MODE_DESIGN)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "mode: found %d, expected path or design", (int)job->mode);
    const struct {
        const char *key;
        int count;
        const void *array;
    } list[] = {{"effects", job->effect_count, job->effect},
                {"excitation.speed", job->dither_count, job->dither},
                {"excitation.heat", job->heat_step_count, job->heat_step},
                {"design.extra_length_mm", job->extra_count, job->extra_u},
                {"design.extra_length_mm", job->extra_count, job->extra_length}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        if (list[i].count < 0 || list[i].count > COUNT_MAX || (list[i].count > 0 && !list[i].array))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found %d entries%s, expected an array of 0 to %d",
                             list[i].key, list[i].count, list[i].array ? "" : " without an array", COUNT_MAX);
    return WCUT_OK;
}

static wcut_status check_path(const wcut_job *job, wcut_error *error) {
    if (!job->mount_a || !job->mount_b || !vec3_all_finite(job->stations, job->mount_a) ||
        !vec3_all_finite(job->stations, job->mount_b))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "path: expected %d finite positions of each mount", job->stations);
    const bool answer =
        job->rig.kind == WCUT_RIG_KIND_BLADE || (job->rig.kind == WCUT_RIG_KIND_BOW && job->rig.pretension > 0);
    return answer ? WCUT_OK : expect_positive(error, "wire.length_mm", job->wire_length);
}

static wcut_status check_design(const wcut_job *job, wcut_error *error) {
    if (!job->edge_a || !job->edge_b || job->extra_count < 1 || !job->extra_u || !job->extra_length)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "design: expected two edge curves and an extra length");
    for (int i = 0; i < job->extra_count; i++) {
        const double u = job->extra_u[i], before = i > 0 ? job->extra_u[i - 1] : -1;
        if (!(u >= 0 && u <= 1 && u > before))
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "design.extra_length_mm[%d][0]: found %g, expected strictly increasing in 0 .. 1", i, u);
        if (!(job->extra_length[i] >= 0 && isfinite(job->extra_length[i])))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "design.extra_length_mm[%d][1]: found %g, expected 0 or more", i,
                             job->extra_length[i]);
    }
    if (!(job->overrun >= 0 && isfinite(job->overrun)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "design.overrun_mm: found %g, expected 0 or more", job->overrun);
    if (!(job->clearance >= 0 && isfinite(job->clearance)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "design.clearance_mm: found %g, expected 0 or more", job->clearance);
    return WCUT_OK;
}

static bool acts_in_step(const wcut_effect *effect) {
    return wcut_effect_view(effect->kind)->place == WCUT_EFFECT_PLACE_STEP && !wcut_effect_is_neutral(effect);
}

static wcut_status check_effects(const wcut_job *job, wcut_integrator integrator, wcut_error *error) {
    const wcut_status status = wcut_effects_check(job->effect_count, job->effect, error);
    for (int e = 0; status == WCUT_OK && e < job->effect_count; e++) {
        const wcut_effect_info *info = wcut_effect_view(job->effect[e].kind);
        if (!acts_in_step(&job->effect[e])) continue;
        if (job->rig.kind == WCUT_RIG_KIND_BOW &&
            (job->effect[e].kind == WCUT_EFFECT_WIRE_ELONGATION || job->effect[e].kind == WCUT_EFFECT_MOUNT_COMPLIANCE))
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "effects[%d]: found %s with the rig bow, expected none: frame and wire of a bow give by "
                             "rig.stiffness_N_per_mm, rig.wire_stiffness_N and rig.expansion_per_K",
                             e, info->name);
        if (integrator == WCUT_INTEGRATOR_HEUN)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "effects[%d]: found %s with the integrator heun, expected implicit: heun is the paper's "
                             "plain model",
                             e, info->name);
    }
    return status;
}

/* a wire of another length than the job states, a block that lies elsewhere */
static bool is_of_setup(wcut_effect_kind kind) {
    return kind == WCUT_EFFECT_WIRE_LENGTH || kind == WCUT_EFFECT_BLOCK_SHIFT;
}

/* the physics that the step has to compute, apart from all else that a job may name */
static bool pick_effects(wcut_setup *setup) {
    const wcut_job *job = setup->job;
    setup->effect = wcut_alloc((size_t)job->effect_count, sizeof *setup->effect);
    for (int e = 0; setup->effect && e < job->effect_count; e++)
        if (acts_in_step(&job->effect[e]) && !is_of_setup(job->effect[e].kind) &&
            !(setup->foam.embedded && wcut_effect_view(job->effect[e].kind)->needs_mounts))
            setup->effect[setup->effect_count++] = job->effect[e]; /* a plan has no mounts to give way */
    return setup->effect != NULL;
}

static bool strictly_inside(const wcut_block *block, wcut_vec3 p) {
    const double h = 1e-6 * block->size.x;
    return p.x > h && p.x < block->size.x - h && p.y > h && p.y < block->size.y - h && p.z > h &&
           p.z < block->size.z - h;
}

/* whether the straight way from p to q runs through the block (Liang, Barsky 1984) */
static bool passes_inside(const wcut_block *block, wcut_vec3 p, wcut_vec3 q) {
    const double h = 1e-6 * block->size.x;
    const double from[3] = {p.x, p.y, p.z}, to[3] = {q.x, q.y, q.z};
    const double size[3] = {block->size.x, block->size.y, block->size.z};
    double enter = 0, leave = 1;
    for (int k = 0; k < 3; k++) {
        const double way = to[k] - from[k];
        if (way == 0 && !(from[k] > h && from[k] < size[k] - h)) return false;
        if (way == 0) continue;
        const double low = (h - from[k]) / way, high = (size[k] - h - from[k]) / way;
        enter = fmax(enter, fmin(low, high));
        leave = fmin(leave, fmax(low, high));
    }
    return enter < leave;
}

/* path mode: mounts in the foam, or that come through it from the station before */
static wcut_status check_mounts(const wcut_setup *setup, int j, wcut_error *error) {
    const wcut_block *block = &setup->foam.block;
    const wcut_vec3 a = setup->end_a[j], b = setup->end_b[j];
    if (strictly_inside(block, a) || strictly_inside(block, b))
        return wcut_fail(error, WCUT_DEGENERATE, "station %d: mount %c is inside the block, expected a path around it",
                         j, strictly_inside(block, a) ? 'A' : 'B');
    if (j == 0) return WCUT_OK;
    const bool by_a = passes_inside(block, setup->end_a[j - 1], a);
    if (!by_a && !passes_inside(block, setup->end_b[j - 1], b)) return WCUT_OK;
    return wcut_fail(error, WCUT_DEGENERATE,
                     "station %d: mount %c comes through the block from station %d, expected a path around it", j,
                     by_a ? 'A' : 'B', j - 1);
}

/* stations that the wire cannot reach, mounts in the foam, mounts that stand still */
static wcut_status check_stations(const wcut_setup *setup, wcut_error *error) {
    for (int j = 0; j < setup->stations; j++) {
        const wcut_vec3 a = setup->end_a[j], b = setup->end_b[j];
        const double chord = vec3_distance(a, b), length = setup->length[j];

        /* only where it begins may the wire be straight: under load a straight wire would need endless tension */
        if (length < chord * (1 - 1e-9) && !setup->bow.on)
            return wcut_fail(
                error, WCUT_DEGENERATE,
                "station %d: the wire (%.6g mm) is shorter than the distance of its ends (%.6g mm) by %.3g mm%s", j,
                length, chord, chord - length, wcut_unit_hint(length, chord));
        if (!(chord > 1e-6 * length))
            return wcut_fail(error, WCUT_DEGENERATE, "station %d: both ends of the wire are in one place", j);

        const bool free = setup->foam.embedded || setup->job->rig.kind == WCUT_RIG_KIND_BLADE; /* a tip may be inside */
        const wcut_status status = free ? WCUT_OK : check_mounts(setup, j, error);
        if (status != WCUT_OK) return status;

        /* a station at which nothing moves has no direction and no time */
        if (j > 0 &&
            !(fmax(vec3_distance(a, setup->end_a[j - 1]), vec3_distance(b, setup->end_b[j - 1])) > 1e-9 * length))
            return wcut_fail(error, WCUT_DEGENERATE, "station %d: neither mount has moved since station %d", j, j - 1);
    }

    return WCUT_OK;
}

/* whether anything of the region that the wire sweeps can lie in the block: the hull of the ends, trailing by
   the slack */
static wcut_status check_contact(const wcut_setup *setup, wcut_error *error) {
    /* the box of the ends, and the largest sag over all stations */
    wcut_vec3 low = setup->end_a[0], high = low;
    double slack = 0;
    for (int j = 0; j < setup->stations; j++) {
        const wcut_vec3 end[2] = {setup->end_a[j], setup->end_b[j]};
        for (int k = 0; k < 2; k++) {
            low = vec3(fmin(low.x, end[k].x), fmin(low.y, end[k].y), fmin(low.z, end[k].z));
            high = vec3(fmax(high.x, end[k].x), fmax(high.y, end[k].y), fmax(high.z, end[k].z));
        }

        /* largest distance of the wire from its chord: half the root of L^2 - c^2 */
        const double chord = vec3_distance(end[0], end[1]), length = setup->length[j];
        slack = fmax(slack, sqrt(fmax(length * length - chord * chord, 0)) / 2);
    }

    /* the box with the sag all around against the block */
    const wcut_vec3 size = setup->foam.block.size;
    const bool meets = low.x - slack < size.x && high.x + slack > 0 && low.y - slack < size.y && high.y + slack > 0 &&
                       low.z - slack < size.z && high.z + slack > 0;
    if (meets) return WCUT_OK;
    return wcut_fail(
        error, WCUT_DEGENERATE,
        "path: no contact with the block: the wire stays within x %.6g .. %.6g, y %.6g .. %.6g, z %.6g .. %.6g "
        "mm, the block fills 0 .. %.6g, 0 .. %.6g, 0 .. %.6g mm%s",
        low.x - slack, high.x + slack, low.y - slack, high.y + slack, low.z - slack, high.z + slack, size.x, size.y,
        size.z, wcut_unit_hint(vec3_distance(low, high), vec3_length(size)));
}

static double slack_of(const wcut_setup *setup, int j) {
    return setup->length[j] / vec3_distance(setup->end_a[j], setup->end_b[j]);
}

/* Entry: the wire gains slack from the beginning on, after whatever even approach. Exit: it loses slack until the end.
   Rates below a fiftieth of the largest count as even. */
static void find_phases(wcut_setup *setup) {
    const int m = setup->stations;
    double fastest = 0;
    for (int j = 1; j < m && !setup->bow.on; j++)
        fastest = fmax(fastest, fabs(slack_of(setup, j) - slack_of(setup, j - 1)));
    const double even = setup->bow.on ? 1 : fastest / 50; /* the ends of a bow stay where they are to each other */
    int j = 1;
    while (j < m && fabs(slack_of(setup, j) - slack_of(setup, j - 1)) <= even) j++;
    while (j < m && slack_of(setup, j) - slack_of(setup, j - 1) > even) j++;
    setup->entry_end = j - 1;
    j = m - 1;
    while (j > 0 && fabs(slack_of(setup, j) - slack_of(setup, j - 1)) <= even) j--;
    while (j > 0 && slack_of(setup, j) - slack_of(setup, j - 1) < -even) j--;
    setup->exit_begin = j > 0 ? j : m;
    if (setup->exit_begin - setup->entry_end >= m / 5) return;
    setup->entry_end = 0; /* a wire whose slack changes all along has no such phases; contact alone tells */
    setup->exit_begin = m;
}

/* The direction in which the cut begins, across the first chord: the mean motion of both mounts over the first part of
   the way, FEED_WAY wire lengths, the beginning counting most (weights falling evenly to 0). The first step alone would
   be a matter of how finely the path is sampled. */
wcut_vec3 wcut_setup_feed(const wcut_setup *setup) {
    /* a chord of the first station, and the way over which is averaged */
    const wcut_vec3 across = vec3_unit(vec3_sub(setup->end_b[0], setup->end_a[0]));
    const double reach = FEED_WAY * setup->length[0];
    wcut_vec3 motion = {0, 0, 0};
    double way = 0;

    for (int j = 1; j < setup->stations && way < reach; j++) {
        const wcut_vec3 move_a = vec3_sub(setup->end_a[j], setup->end_a[j - 1]);
        const wcut_vec3 move_b = vec3_sub(setup->end_b[j], setup->end_b[j - 1]);

        /* the integral of the weight 1 - way / reach over the step, which may end beyond `reach` */
        const double step = (vec3_length(move_a) + vec3_length(move_b)) / 2;
        const double share = fmin(1, (reach - way) / step);
        const double weight = share * (1 - (way + share * step / 2) / reach);
        motion = vec3_add_scaled(motion, weight, vec3_add(move_a, move_b));
        way += step;
    }

    /* what is along the chord does not feed */
    const wcut_vec3 feed = vec3_add_scaled(motion, -vec3_dot(motion, across), across);

    return vec3_length(feed) > 1e-9 * setup->length[0] ? vec3_unit(feed) : vec3(0, 1, 0);
}

/* room for so many stations */
static bool make_setup_room(wcut_setup *setup, int stations) {
    const size_t m = (size_t)stations;
    setup->stations = stations;
    setup->part_last = stations - 1;
    setup->end_a = wcut_alloc(m, sizeof *setup->end_a);
    setup->end_b = wcut_alloc(m, sizeof *setup->end_b);
    setup->length = wcut_alloc(m, sizeof *setup->length);
    return setup->end_a && setup->end_b && setup->length;
}

/* the mounts' way as given, with one length of wire; in the frame of the block as it lies */
static void take_mounts(wcut_setup *setup, const wcut_vec3 *a, const wcut_vec3 *b, double length) {
    const wcut_job *job = setup->job;
    for (int e = 0; e < job->effect_count; e++) {
        const double *d = job->effect[e].value;
        if (job->effect[e].kind == WCUT_EFFECT_WIRE_LENGTH) setup->longer = d[WCUT_WIRE_LENGTH_CHANGE];
        if (job->effect[e].kind == WCUT_EFFECT_BLOCK_SHIFT) setup->shift = vec3(d[0], d[1], d[2]);
    }

    /* stations of the run */
    for (int j = 0; j < setup->stations; j++) {
        setup->end_a[j] = vec3_sub(a[j], setup->shift);
        setup->end_b[j] = vec3_sub(b[j], setup->shift);
        setup->length[j] = job->rig.kind == WCUT_RIG_KIND_BLADE ? vec3_distance(a[j], b[j]) : length + setup->longer;
    }
}

/* a design: its plan is run, as far as it goes, and gives the mounts' way */
static wcut_status take_design(wcut_setup *setup, wcut_error *error) {
    wcut_setup *plan = NULL;
    wcut_history *history = NULL;
    wcut_design_path path = {0};

    /* run the plan: the wire inside the block, from edge to edge */
    wcut_status status = wcut_plan_create(setup->job, &setup->options, &plan, error);
    if (status == WCUT_OK) status = wcut_setup_run(plan, NULL, NULL, &history, error);

    /* a plan that ends early is cut up to there, and the run says why */
    if (status == WCUT_NOT_CONVERGED && history) {
        setup->plan_ended = history->ended;
        status = WCUT_OK;
    }

    /* the mounts' way that leads the wire along the plan */
    if (status == WCUT_OK) status = wcut_design_path_create(plan, history, &path, error);
    if (status == WCUT_OK) {
        if (make_setup_room(setup, path.stations)) {
            take_mounts(setup, path.mount_a, path.mount_b, path.length);
            setup->part_first = path.part_first, setup->part_last = path.part_last;
        } else {
            status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d stations", path.stations);
        }
    }

    wcut_design_path_destroy(&path);
    wcut_history_destroy(history);
    wcut_setup_destroy(plan);
    return status;
}

static wcut_status fill_setup(wcut_setup *setup, wcut_error *error) {
    const wcut_job *job = setup->job;
    wcut_status status = WCUT_OK;
    setup->foam.law = job->force_law;
    setup->foam.block = (wcut_block){.size = job->block_size, .depth = job->wire_diameter};
    if (job->rig.kind == WCUT_RIG_KIND_BOW) status = wcut_bow_create(job, &setup->bow, error);
    if (status != WCUT_OK) return status;

    /* where the wire's ends are at every station */
    if (job->mode == WCUT_MODE_DESIGN && !setup->foam.embedded)
        status = take_design(setup, error);
    else if (!make_setup_room(setup, job->stations))
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d stations", job->stations);
    else if (setup->foam.embedded)
        status = wcut_design_ends(job, setup->end_a, setup->end_b, setup->length, error);
    else
        take_mounts(setup, job->mount_a, job->mount_b, setup->bow.on ? setup->bow.natural : job->wire_length);

    /* whether a wire can go there, and meets the block */
    if (status == WCUT_OK && setup->foam.embedded)
        status = wcut_design_check_edges(job, setup->end_a, setup->end_b, error);
    if (status == WCUT_OK) status = check_stations(setup, error);
    if (status == WCUT_OK) status = check_contact(setup, error);
    if (status != WCUT_OK) return status;

    /* direction and phases follow from the stations */
    setup->feed = wcut_setup_feed(setup);
    find_phases(setup);

    return WCUT_OK;
}

static wcut_status check_cut_options(const wcut_cut_options *o, wcut_error *error) {
    if ((o->integrator == WCUT_INTEGRATOR_IMPLICIT || o->integrator == WCUT_INTEGRATOR_HEUN) &&
        is_positive(o->tolerance) && o->max_iterations >= 1 && o->max_halvings >= 0 && o->max_halvings <= 30)
        return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT,
                     "options: a known integrator, a positive tolerance, at least 1 iteration and "
                     "0 to 30 halvings expected");
}

double wcut_wire_weight(const wcut_job *job) {
    const double section = WCUT_PI / 4 * job->wire_diameter * job->wire_diameter;
    return 1e-9 * job->wire_density * GRAVITY * section;
}

/* [N] what the forces of a bow are measured by: its pretension, or what the block's width of foam resists with at most */
static double bow_scale(const wcut_job *job) {
    if (job->rig.pretension > 0) return job->rig.pretension;
    return job->tension > 0 ? job->tension : job->force_law.a * job->block_size.x;
}

/* a setup of a job that is checked; embedded: of a design's plan */
static wcut_status create_setup(const wcut_job *job, const wcut_cut_options *options, bool embedded, wcut_setup **out,
                                wcut_error *error) {
    wcut_setup *setup = wcut_alloc(1, sizeof *setup);
    if (!setup) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a setup");
    wcut_status status;
    setup->options = *options;
    setup->foam.embedded = embedded;
    setup->weight = embedded ? 0 : wcut_wire_weight(job);
    setup->job = wcut_job_copy(job);
    if (setup->job && job->rig.kind == WCUT_RIG_KIND_BOW) setup->job->tension = bow_scale(job);
    if (setup->job && pick_effects(setup))
        status = fill_setup(setup, error);
    else
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a job of %d stations", job->stations);
    if (status == WCUT_OK)
        *out = setup;
    else
        wcut_setup_destroy(setup);
    return status;
}

wcut_status wcut_plan_create(const wcut_job *job, const wcut_cut_options *options, wcut_setup **plan,
                             wcut_error *error) {
    return create_setup(job, options, true, plan, error);
}

wcut_status wcut_plan_create_between(const wcut_job *job, const wcut_cut_options *options, int stations, int nodes,
                                     const wcut_vec3 *end_a, const wcut_vec3 *end_b, const double *length,
                                     wcut_setup **plan, wcut_error *error) {
    wcut_setup *setup = wcut_alloc(1, sizeof *setup);
    if (!setup) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a setup");
    setup->options = *options;
    setup->foam = (wcut_foam){
        .law = job->force_law, .block = {.size = job->block_size, .depth = job->wire_diameter}, .embedded = true};
    setup->job = wcut_job_copy(job);
    wcut_status status = WCUT_OK;
    if (!setup->job || !make_setup_room(setup, stations)) {
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d stations", stations);
    } else {
        setup->job->nodes = nodes;
        if (!pick_effects(setup)) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a setup");
    }

    /* the ends as given */
    if (status == WCUT_OK) {
        memcpy(setup->end_a, end_a, (size_t)stations * sizeof *end_a);
        memcpy(setup->end_b, end_b, (size_t)stations * sizeof *end_b);
        memcpy(setup->length, length, (size_t)stations * sizeof *length);
        status = check_stations(setup, error);
    }
    if (status == WCUT_OK) {
        setup->feed = wcut_setup_feed(setup);
        find_phases(setup);
        *plan = setup;
    } else {
        wcut_setup_destroy(setup);
    }
    return status;
}

wcut_status wcut_setup_create(const wcut_job *job, const wcut_cut_options *options, wcut_setup **out,
                              wcut_error *error) {
    const wcut_cut_options o = options ? *options : wcut_cut_options_default();
    if (!job || !out) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a job and a place for the setup are expected");

    /* each part of the job by itself */
    wcut_status status = check_cut_options(&o, error);
    if (status == WCUT_OK) status = check_job_numbers(job, error);
    if (status == WCUT_OK) status = check_lists(job, error);
    if (status == WCUT_OK) status = job->mode == WCUT_MODE_PATH ? check_path(job, error) : check_design(job, error);
    if (status == WCUT_OK) status = wcut_rig_check(job, error);
    if (status == WCUT_OK) status = check_effects(job, o.integrator, error);

    /* what does not go together */
    if (status == WCUT_OK && job->wire_density > 0 && o.integrator == WCUT_INTEGRATOR_HEUN)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT,
                           "wire.density_kg_per_m3: found %g with the integrator heun, expected implicit: heun is the "
                           "paper's scheme, without weight",
                           job->wire_density);
    if (status == WCUT_OK && job->feed.kind != WCUT_FEED_KIND_NONE && o.integrator == WCUT_INTEGRATOR_HEUN)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT,
                           "feed: found one with the integrator heun, expected implicit: heun solves for the speed");
    if (status == WCUT_OK && job->wire_density > 0 && job->rig.kind == WCUT_RIG_KIND_BOW)
        status =
            wcut_fail(error, WCUT_BAD_ARGUMENT,
                      "wire.density_kg_per_m3: found %g with the rig bow, expected none: a taut wire hangs by less "
                      "than 0.1 mm, its weight is left out",
                      job->wire_density);
    return status == WCUT_OK ? create_setup(job, &o, false, out, error) : status;
}

wcut_status wcut_setup_path_job(const wcut_setup *setup, wcut_job **job) {
    if (!setup || !job) return WCUT_BAD_ARGUMENT;
    if (setup->plan_ended.status != WCUT_OK) return setup->plan_ended.status;

    /* the copy is changed, the setup stays */
    wcut_job *path = wcut_job_copy(setup->job);
    if (!path) return WCUT_NO_MEMORY;

    /* what a design was drawn by gives way to the mounts' way that it became */
    const size_t m = (size_t)setup->stations;
    wcut_free(path->mount_a);
    wcut_free(path->mount_b);
    wcut_curve_destroy(path->edge_a);
    wcut_curve_destroy(path->edge_b);
    wcut_free(path->extra_u);
    wcut_free(path->extra_length);
    path->edge_a = path->edge_b = NULL;
    path->extra_u = path->extra_length = NULL;
    path->extra_count = 0;
    path->clearance = 0;

    /* a job in path mode, with the stations of the setup */
    path->mode = WCUT_MODE_PATH;
    path->stations = setup->stations;
    path->wire_length = setup->length[0] - setup->longer; /* the path keeps the effects that say so */
    path->mount_a = wcut_copy(setup->end_a, m, sizeof *path->mount_a);
    path->mount_b = wcut_copy(setup->end_b, m, sizeof *path->mount_b);
    if (!path->mount_a || !path->mount_b) {
        wcut_job_destroy(path);
        return WCUT_NO_MEMORY;
    }
    for (size_t j = 0; j < m; j++) {
        path->mount_a[j] = vec3_add(path->mount_a[j], setup->shift);
        path->mount_b[j] = vec3_add(path->mount_b[j], setup->shift);
    }
    *job = path;

    return WCUT_OK;
}

wcut_setup_span wcut_setup_stations(const wcut_setup *setup) {
    if (!setup) return (wcut_setup_span){0, 0, 0};
    return (wcut_setup_span){setup->stations, setup->part_first, setup->part_last};
}

void wcut_setup_destroy(wcut_setup *setup) {
    if (!setup) return;
    wcut_job_destroy(setup->job);
    wcut_free(setup->end_a);
    wcut_free(setup->end_b);
    wcut_free(setup->length);
    wcut_free(setup->effect);
    wcut_free(setup);
}

const wcut_job *wcut_setup_job(const wcut_setup *setup) { return setup ? setup->job : NULL; }

const wcut_cut_options *wcut_setup_options(const wcut_setup *setup) { return setup ? &setup->options : NULL; }
