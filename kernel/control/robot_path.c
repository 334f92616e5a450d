/* A cut as targets that two robots reach together: thinning in space and time (Ramer 1972; Douglas, Peucker 1973). */
#include <wirecut/robot.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/job_rig.h"

#define BLEND 0.4 /* [1] of the shorter neighbouring move: two zones never meet */

typedef struct path { /* what is thinned */
    const wcut_history_row *row;
    const wcut_vec3 *a, *b;
    wcut_robot_options o;
    double chord_error, time_error; /* [mm] the largest of what was accepted */
    wcut_vec3 feed, onward;         /* [1] of the leads */
} path;

wcut_robot_options wcut_robot_options_default(void) {
    return (wcut_robot_options){.chord_tolerance = 0.1,
                                .time_tolerance = 1,
                                .angle_tolerance = 0.5 * WCUT_PI / 180,
                                .zone = 1,
                                .frame = WCUT_TOOL_FRAME_FIXED};
}

/* ---- thinning ---- */

/* how far a mount is off at station j, when it goes straight and evenly from i to k: across and along its way */
static void stray(const wcut_vec3 *x, int i, int j, int k, double share, double *across, double *along) {
    const wcut_vec3 way = vec3_sub(x[k], x[i]), off = vec3_sub(x[j], vec3_add_scaled(x[i], share, way));
    *along = vec3_dot(off, vec3_unit(way));
    *across = vec3_length(vec3_add_scaled(off, -*along, vec3_unit(way)));
    *along = fabs(*along);
}

static double turn_error(double from, double to, double share, double at) {
    return fabs(at - (from + share * (to - from)));
}

/* the station between i and k that strays most, as a share of its tolerance; gives that share */
static double find_worst(path *p, int i, int k, int *worst) {
    double max = 0, chord = 0, time = 0;
    *worst = i + 1;

    /* each station between, at the time when both robots would be there */
    for (int j = i + 1; j < k; j++) {
        const wcut_history_row *f = &p->row[i], *t = &p->row[k], *r = &p->row[j];
        const double share = (r->time - f->time) / (t->time - f->time);

        /* distance across and along the chord of both mounts */
        double across[2], along[2], angle = 0;
        stray(p->a, i, j, k, share, &across[0], &along[0]);
        stray(p->b, i, j, k, share, &across[1], &along[1]);

        /* the angles count where the tool follows the wire */
        if (p->o.frame == WCUT_TOOL_FRAME_FOLLOWING)
            angle = fmax(fmax(turn_error(f->alpha_a, t->alpha_a, share, r->alpha_a),
                              turn_error(f->beta_a, t->beta_a, share, r->beta_a)),
                         fmax(turn_error(f->alpha_b, t->alpha_b, share, r->alpha_b),
                              turn_error(f->beta_b, t->beta_b, share, r->beta_b)));

        /* in shares of their tolerances */
        const double c = fmax(across[0], across[1]), l = fmax(along[0], along[1]);
        const double size = fmax(fmax(c / p->o.chord_tolerance, l / p->o.time_tolerance), angle / p->o.angle_tolerance);
        chord = fmax(chord, c);
        time = fmax(time, l);
        if (size > max) {
            max = size;
            *worst = j;
        }
    }

    /* the chord is taken: its errors are those of the motion */
    if (max <= 1) {
        p->chord_error = fmax(p->chord_error, chord);
        p->time_error = fmax(p->time_error, time);
    }

    return max;
}

/* mark the stations to keep; `stack` has room for m */
static void thin(path *p, int m, int *stack, unsigned char *keep) {
    int depth = 0, from = 0;
    keep[0] = keep[m - 1] = 1;
    stack[depth++] = m - 1;
    while (depth > 0) { /* the stack holds ends, nearest on top; its span begins at `from` */
        const int to = stack[depth - 1];
        int worst;
        if (find_worst(p, from, to, &worst) > 1) {
            keep[worst] = 1;
            stack[depth++] = worst;
        } else {
            from = to;
            depth--;
        }
    }
}

/* ---- targets ---- */

/* rotation with the x axis along d and the z axis as far up as that allows, as a quaternion */
static void frame_along(wcut_vec3 d, double q[4]) {
    const double across = hypot(d.x, d.y), yaw = across > 0 ? atan2(d.y, d.x) : 0, pitch = -atan2(d.z, across);
    const double cy = cos(yaw / 2), sy = sin(yaw / 2), cp = cos(pitch / 2), sp = sin(pitch / 2);
    const double w = cy * cp, sign = w < 0 ? -1 : 1;
    q[0] = sign * w;
    q[1] = sign * -sy * sp;
    q[2] = sign * cy * sp;
    q[3] = sign * sy * cp;
}

/* direction of the wire leaving a mount; u is +1 at A and -1 at B */
static wcut_vec3 direction(double u, double alpha, double beta) {
    return vec3(u * cos(beta) * cos(alpha), -cos(beta) * sin(alpha), sin(beta));
}

static wcut_robot_target at_station(const path *p, int j) {
    const wcut_history_row *r = &p->row[j];
    wcut_robot_target t = {.station = j, .time = r->time, .a = p->a[j], .b = p->b[j]};
    const bool follow = p->o.frame == WCUT_TOOL_FRAME_FOLLOWING;
    frame_along(follow ? direction(1, r->alpha_a, r->beta_a) : vec3(1, 0, 0), t.frame_a);
    frame_along(follow ? direction(-1, r->alpha_b, r->beta_b) : vec3(-1, 0, 0), t.frame_b);
    return t;
}

/* The direction in which both mounts together begin (step 1, from the first station) or end (step -1, from the last):
   of as much of the way as they need to go together, where they start against each other; false where they never do. */
static bool lead_direction(const path *p, int m, int step, wcut_vec3 *direction) {
    const int from = step > 0 ? 0 : m - 1;
    double way = 0;
    for (int j = from; j + step >= 0 && j + step < m; j += step) {
        way += vec3_distance(p->a[j], p->a[j + step]) + vec3_distance(p->b[j], p->b[j + step]);
        const wcut_vec3 move = vec3_add(vec3_sub(p->a[j + step], p->a[from]), vec3_sub(p->b[j + step], p->b[from]));
        if (!(way > 0) || vec3_length(move) < way / 4) continue;
        *direction = vec3_scale(step, vec3_unit(move));
        return true;
    }
    return false;
}

/* a lead: both mounts by the same vector along a direction, at the speed of the faster one */
static wcut_robot_target lead_target(const path *p, int from, wcut_vec3 direction, double way, double speed) {
    wcut_robot_target t = at_station(p, from);
    const wcut_vec3 step = vec3_scale(way, direction);
    t.station = way < 0 ? -1 : -2;
    t.a = vec3_add(t.a, step);
    t.b = vec3_add(t.b, step);
    t.time += way / speed;
    return t;
}

/* ---- the heater's programme ---- */

/* between two targets both robots go straight and evenly: a target on the way changes nothing */
static wcut_robot_target target_between(const wcut_robot_target *f, const wcut_robot_target *t, double time) {
    const double share = (time - f->time) / (t->time - f->time);
    wcut_robot_target m = {.station = -3, .time = time};
    m.a = vec3_mix(f->a, t->a, share);
    m.b = vec3_mix(f->b, t->b, share);
    double size_a = 0, size_b = 0;
    for (int k = 0; k < 4; k++) {
        m.frame_a[k] = f->frame_a[k] + share * (t->frame_a[k] - f->frame_a[k]);
        m.frame_b[k] = f->frame_b[k] + share * (t->frame_b[k] - f->frame_b[k]);
        size_a += m.frame_a[k] * m.frame_a[k], size_b += m.frame_b[k] * m.frame_b[k];
    }
    for (int k = 0; k < 4; k++) m.frame_a[k] /= sqrt(size_a), m.frame_b[k] /= sqrt(size_b);
    return m;
}

/* [s] a change of power so near to a target is told there: a shorter move would be none */
#define SNAP 0.02

/* the power from a time on is told at a target there */
static void tell_heat(wcut_robot_motion *motion, double time, double heat) {
    wcut_robot_target *t = motion->target;
    int i = motion->first;
    if (time > t[motion->last].time) return;
    while (i < motion->last && t[i + 1].time <= time + SNAP) i++;
    if (i < motion->last && time > t[i].time + SNAP) {
        const wcut_robot_target between = target_between(&t[i], &t[i + 1], time);
        for (int k = motion->count; k > i + 1; k--) t[k] = t[k - 1];
        t[++i] = between;
        motion->count++, motion->last++;
    }
    t[i].heat = heat;
}

/* where a step begins, and where it ends unless the next begins there */
static void tell_steps(wcut_robot_motion *motion, const wcut_job *job) {
    for (int k = 0; k < job->heat_step_count; k++) {
        const wcut_heat_step *step = &job->heat_step[k];
        const bool goes_on = k + 1 < job->heat_step_count && job->heat_step[k + 1].from <= step->to;
        tell_heat(motion, step->from, job->heat * step->factor);
        if (!goes_on) tell_heat(motion, step->to, job->heat);
    }
}

/* how far along `d` a point goes until it has left the box for good; 0 where it never meets it */
static double way_out(wcut_vec3 p, wcut_vec3 d, wcut_vec3 low, wcut_vec3 high) {
    const double from[3] = {p.x, p.y, p.z}, by[3] = {d.x, d.y, d.z};
    const double least[3] = {low.x, low.y, low.z}, largest[3] = {high.x, high.y, high.z};
    double enter = 0, leave = INFINITY;
    for (int c = 0; c < 3; c++) {
        if (by[c] == 0) {
            if (from[c] < least[c] || from[c] > largest[c]) return 0;
            continue;
        }
        const double one = (least[c] - from[c]) / by[c], other = (largest[c] - from[c]) / by[c];
        enter = fmax(enter, fmin(one, other));
        leave = fmin(leave, fmax(one, other));
    }
    return leave > enter && isfinite(leave) ? leave : 0;
}

/* How far the wire of the last station has to be moved along to be clear of the block: its edges in pieces of a
   millimetre at most, the block with the clearance about it. In the foam the wire trails; coming out it goes straight,
   that is forwards: as it stands it is the last to leave. */
static double clear_way(const wcut_history *h, wcut_vec3 block, wcut_vec3 onward) {
    const double c = WCUT_LEAD_CLEARANCE;
    const wcut_vec3 *x = h->position + (size_t)(h->stations - 1) * (size_t)h->nodes;
    double way = 0;
    for (int i = 0; i + 1 < h->nodes; i++) {
        const int pieces = (int)fmin(1e4, ceil(vec3_distance(x[i], x[i + 1])) + 1);
        for (int k = 0; k <= pieces; k++) {
            const wcut_vec3 p = vec3_mix(x[i], x[i + 1], (double)k / pieces);
            way = fmax(way, way_out(p, onward, vec3(-c, -c, -c), vec3(block.x + c, block.y + c, block.z + c)));
        }
    }
    return way;
}

/* durations, speeds and zones from times and places */
static void finish_motion(wcut_robot_motion *motion, double zone) {
    const int n = motion->count;
    const double begin = motion->target[0].time;
    for (int i = 0; i < n; i++) motion->target[i].time -= begin;
    for (int i = 1; i < n; i++) {
        wcut_robot_target *t = &motion->target[i], *before = t - 1;
        t->duration = t->time - before->time;
        t->speed_a = vec3_distance(before->a, t->a) / t->duration;
        t->speed_b = vec3_distance(before->b, t->b) / t->duration;
    }
    for (int i = 1; i < n - 1; i++) {
        wcut_robot_target *t = &motion->target[i], *after = t + 1;
        t->zone_a = fmin(zone, BLEND * fmin(t->speed_a * t->duration, after->speed_a * after->duration));
        t->zone_b = fmin(zone, BLEND * fmin(t->speed_b * t->duration, after->speed_b * after->duration));
    }
    motion->duration = motion->target[n - 1].time;
}

/* the tool's pose at a target: of its station, moved along a lead; between stations of the heater by the time */
static wcut_pose pose_at(const path *p, const wcut_robot_motion *motion, int i) {
    const wcut_robot_target *t = &motion->target[i];
    const wcut_job *job = p->o.tool;
    const int last = motion->stations - 1, j = t->station >= 0 ? t->station : t->station == -1 ? 0 : last;
    if (t->station != -3) {
        wcut_pose pose = wcut_job_pose(job, j);
        if (t->station < 0) pose.at = vec3_add(pose.at, vec3_sub(t->a, p->a[j]));
        return pose;
    }

    /* the station before the moment, and the share of the way to the next */
    const double time =
        t->time + p->row[motion->target[motion->first].station].time - motion->target[motion->first].time;
    int k = 0;
    while (k < last - 1 && p->row[k + 1].time <= time) k++;
    const double share = (time - p->row[k].time) / (p->row[k + 1].time - p->row[k].time);
    const wcut_pose from = wcut_job_pose(job, k), to = wcut_job_pose(job, k + 1);
    return wcut_pose_mix(&from, &to, fmin(fmax(share, 0), 1));
}

/* both mounts of a target give way to the tool that holds them */
static void lead_by_tool(const path *p, wcut_robot_motion *motion) {
    motion->single = true;
    for (int i = 0; i < motion->count; i++) {
        const wcut_pose pose = pose_at(p, motion, i);
        const double sign = pose.turn[0] < 0 ? -1 : 1;
        wcut_robot_target *t = &motion->target[i];
        for (int k = 0; k < 4; k++) t->frame_a[k] = t->frame_b[k] = sign * pose.turn[k];
        t->b = pose.at; /* a is still the mount's: pose_at looks at it */
    }

    /* places, speeds and zones of the tool */
    for (int i = 0; i < motion->count; i++) motion->target[i].a = motion->target[i].b;
    for (int i = 1; i < motion->count; i++) {
        wcut_robot_target *t = &motion->target[i];
        t->speed_a = t->speed_b = vec3_distance(t[-1].a, t->a) / t->duration;
    }
    for (int i = 1; i < motion->count - 1; i++) {
        wcut_robot_target *t = &motion->target[i];
        t->zone_a = t->zone_b = fmin(p->o.zone, BLEND * fmin(t->speed_a * t->duration, t[1].speed_a * t[1].duration));
    }
}

static wcut_status fill_motion(const wcut_history *h, path *p, const unsigned char *keep, wcut_robot_motion *motion) {
    /* count the stations that are kept, and two leads */
    const int m = h->stations;
    int count = 0;
    for (int j = 0; j < m; j++) count += keep[j];
    const int steps = p->o.heater ? p->o.heater->heat_step_count : 0;
    motion->target = wcut_alloc((size_t)count + 2 + 2 * (size_t)steps, sizeof *motion->target);
    if (!motion->target) return WCUT_NO_MEMORY;

    /* lead in, the stations, lead out */
    int n = 0;
    const double first = fmax(h->row[1].speed_a, h->row[1].speed_b);
    const double last = fmax(h->row[m - 1].speed_a, h->row[m - 1].speed_b);
    if (p->o.lead_in > 0) motion->target[n++] = lead_target(p, 0, p->feed, -p->o.lead_in, first);
    motion->first = n;
    for (int j = 0; j < m; j++)
        if (keep[j]) motion->target[n++] = at_station(p, j);
    motion->last = n - 1;
    if (p->o.lead_out > 0) motion->target[n++] = lead_target(p, m - 1, p->onward, p->o.lead_out, last);

    motion->lead_out = p->o.lead_out;
    motion->count = n;
    motion->stations = m;
    motion->chord_error = p->chord_error;
    motion->time_error = p->time_error;
    if (steps > 0) tell_steps(motion, p->o.heater);
    finish_motion(motion, p->o.zone);
    if (p->o.tool) lead_by_tool(p, motion);

    return WCUT_OK;
}

static wcut_status check_robot_path(const wcut_history *h, const wcut_vec3 *a, const wcut_vec3 *b,
                                    const wcut_robot_options *o, wcut_error *error) {
    if (!is_positive(o->chord_tolerance) || !is_positive(o->time_tolerance) || !is_positive(o->angle_tolerance) ||
        !(o->lead_in >= 0 && isfinite(o->lead_in)) || !(o->lead_out >= 0 && isfinite(o->lead_out)) ||
        !(o->zone >= 0 && isfinite(o->zone)) ||
        (o->frame != WCUT_TOOL_FRAME_FIXED && o->frame != WCUT_TOOL_FRAME_FOLLOWING))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "positive tolerances, leads and a zone of 0 or more and a known tool frame are expected");
    if (!h->row || h->stations < 2 || (o->clear && !h->position) || !vec3_all_finite(h->stations, a) ||
        !vec3_all_finite(h->stations, b))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a history of at least two stations and finite paths are expected");
    if (o->tool && (o->tool->stations < h->stations || (!o->tool->tool && (!o->tool->mount_a || !o->tool->mount_b))))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "tool: expected a job whose tool or mounts led the history");
    for (int j = 1; j < h->stations; j++) {
        const wcut_history_row *r = &h->row[j];
        if (!(r->time > r[-1].time) || !is_positive(fmax(r->speed_a, r->speed_b)))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "station %d: expected a later time and a positive speed", j);
    }
    return WCUT_OK;
}

wcut_status wcut_robot_motion_create(const wcut_history *history, const wcut_vec3 *mount_a, const wcut_vec3 *mount_b,
                                     const wcut_robot_options *options, wcut_robot_motion **out, wcut_error *error) {
    if (!history || !mount_a || !mount_b || !out)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a history, its path curves and a place for the motion are expected");
    path p = {.row = history->row, .a = mount_a, .b = mount_b, .o = options ? *options : wcut_robot_options_default()};

    /* check the history and the options */
    wcut_status status = check_robot_path(history, mount_a, mount_b, &p.o, error);
    if (status != WCUT_OK) return status;

    /* leads go in the common direction of both mounts */
    if ((p.o.lead_in > 0 && !lead_direction(&p, history->stations, 1, &p.feed)) ||
        ((p.o.lead_out > 0 || p.o.clear) && !lead_direction(&p, history->stations, -1, &p.onward)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a lead: the mounts move against each other all along, expected a common direction");
    if (p.o.clear) p.o.lead_out = fmax(p.o.lead_out, clear_way(history, p.o.clear->block_size, p.onward));
    const size_t m = (size_t)history->stations;

    /* room, then thin the stations and fill in the targets */
    wcut_robot_motion *motion = wcut_alloc(1, sizeof *motion);
    int *stack = wcut_alloc(m, sizeof *stack);
    unsigned char *keep = wcut_alloc(m, 1);
    status = WCUT_NO_MEMORY;
    if (motion && stack && keep) {
        thin(&p, history->stations, stack, keep);
        status = fill_motion(history, &p, keep, motion);
    }

    wcut_free(stack);
    wcut_free(keep);
    if (status == WCUT_OK) {
        *out = motion;
        return WCUT_OK;
    }

    wcut_robot_motion_destroy(motion);
    return wcut_fail(error, status, "no memory for the targets of %d stations", history->stations);
}

void wcut_robot_motion_destroy(wcut_robot_motion *motion) {
    if (!motion) return;
    wcut_free(motion->target);
    wcut_free(motion);
}
