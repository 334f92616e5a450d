/* What holds the wire of a job, how it is fed, and where a tool is that holds both ends. */
#include "cut/job_rig.h"

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* [1] how far a quaternion of a file may be off unit length: four digits are within it */
#define QUATERNION_OFF 1e-3

const char *wcut_rig_name(wcut_rig_kind kind) {
    static const char *const text[] = {"two_arms", "bow", "blade"};
    return (unsigned)kind < sizeof text / sizeof *text ? text[kind] : "unknown";
}

/* ---- the tool ---- */

wcut_vec3 wcut_pose_point(const wcut_pose *pose, wcut_vec3 p) {
    const double w = pose->turn[0], size = w * w + pose->turn[1] * pose->turn[1] + pose->turn[2] * pose->turn[2] +
                                           pose->turn[3] * pose->turn[3];
    const wcut_vec3 v = {pose->turn[1], pose->turn[2], pose->turn[3]};

    /* p + 2 v x (v x p + w p) over the square of the quaternion's length */
    const wcut_vec3 twist = vec3_cross(v, vec3_add_scaled(vec3_cross(v, p), w, p));
    return vec3_add(pose->at, vec3_add_scaled(p, 2 / size, twist));
}

/* a pose with a unit quaternion, w not negative; false: it is no rotation */
static bool normalise_pose(const wcut_pose *from, wcut_pose *to) {
    double size = 0;
    for (int k = 0; k < 4; k++) size += from->turn[k] * from->turn[k];
    size = sqrt(size);
    if (!vec3_is_finite(from->at) || !(fabs(size - 1) <= QUATERNION_OFF)) return false;

    /* what is of unit length already keeps every digit */
    const double scale = (from->turn[0] < 0 ? -1 : 1) / (fabs(size - 1) < 1e-15 ? 1 : size);
    to->at = from->at;
    for (int k = 0; k < 4; k++) to->turn[k] = scale * from->turn[k] + 0.0;
    return true;
}

wcut_pose wcut_pose_mix(const wcut_pose *a, const wcut_pose *b, double t) {
    wcut_pose p = {.at = vec3_mix(a->at, b->at, t)};
    double dot = 0;
    for (int k = 0; k < 4; k++) dot += a->turn[k] * b->turn[k];

    /* the shorter way round, at an even rate; nearly equal turns are mixed */
    const double sign = dot < 0 ? -1 : 1, angle = acos(fmin(fabs(dot), 1));
    const double from = angle > 1e-7 ? sin((1 - t) * angle) / sin(angle) : 1 - t;
    const double to = sign * (angle > 1e-7 ? sin(t * angle) / sin(angle) : t);
    double size = 0;
    for (int k = 0; k < 4; k++) {
        p.turn[k] = from * a->turn[k] + to * b->turn[k];
        size += p.turn[k] * p.turn[k];
    }
    for (int k = 0; k < 4; k++) p.turn[k] /= sqrt(size);
    return p;
}

wcut_pose wcut_job_pose(const wcut_job *job, int j) {
    if (job->tool) return job->tool[j];
    const wcut_vec3 d = vec3_unit(vec3_sub(job->mount_b[j], job->mount_a[j]));
    wcut_pose p = {.at = vec3_mix(job->mount_a[j], job->mount_b[j], 0.5), .turn = {1 + d.x, 0, -d.z, d.y}};

    /* from x to d: 1 + x . d and x cross d; against x half a turn about z */
    const double size = sqrt(p.turn[0] * p.turn[0] + d.z * d.z + d.y * d.y);
    if (!(size > 1e-9)) return (wcut_pose){.at = p.at, .turn = {0, 0, 0, 1}};
    for (int k = 0; k < 4; k++) p.turn[k] /= size;
    return p;
}

wcut_status wcut_job_place_mounts(wcut_job *job, wcut_error *error) {
    if (!job || !job->tool || job->stations < 1 || !vec3_is_finite(job->mount_a_in_tool) ||
        !vec3_is_finite(job->mount_b_in_tool))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "path: expected poses of a tool and two points in it");
    const int m = job->stations;
    wcut_vec3 *a = wcut_alloc((size_t)m, sizeof *a), *b = wcut_alloc((size_t)m, sizeof *b);
    wcut_pose *tool = wcut_alloc((size_t)m, sizeof *tool);
    wcut_status status = a && b && tool ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d stations", m);

    /* both mounts of every station */
    for (int j = 0; status == WCUT_OK && j < m; j++) {
        const double *q = job->tool[j].turn;
        if (normalise_pose(&job->tool[j], &tool[j])) {
            a[j] = wcut_pose_point(&tool[j], job->mount_a_in_tool);
            b[j] = wcut_pose_point(&tool[j], job->mount_b_in_tool);
        } else {
            status =
                wcut_fail(error, WCUT_BAD_ARGUMENT,
                          "path.tool[%d]: found the quaternion (%.6g, %.6g, %.6g, %.6g) of length %.6g, expected a "
                          "rotation: w, x, y, z of length 1",
                          j, q[0], q[1], q[2], q[3], sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]));
        }
    }

    /* they take the place of what was there */
    if (status == WCUT_OK) {
        wcut_free(job->mount_a);
        wcut_free(job->mount_b);
        wcut_free(job->tool);
        job->mount_a = a, job->mount_b = b, job->tool = tool;
        return WCUT_OK;
    }
    wcut_free(a);
    wcut_free(b);
    wcut_free(tool);
    return status;
}

/* ---- the feed ---- */

/* [s] for a way from time t on, by a speed that is linear between the times */
static double time_of_way(const wcut_feed *feed, double from, double way) {
    double t = from;
    int k = 0;
    while (k < feed->count && feed->time[k] <= t) k++;
    for (;; k++) {
        /* the speed here, and how it changes to the next time */
        const int before = k > 0 ? k - 1 : 0;
        if (k == 0 || k == feed->count) {
            const double v = feed->speed[before], room = k == 0 ? (feed->time[0] - t) * v : INFINITY;
            if (way <= room) return t + way / v - from;
            way -= room;
            t = feed->time[0];
            continue;
        }
        const double slope = (feed->speed[k] - feed->speed[before]) / (feed->time[k] - feed->time[before]);
        const double v = feed->speed[before] + slope * (t - feed->time[before]), step = feed->time[k] - t;
        const double room = (v + slope * step / 2) * step;

        /* v t + slope t^2 / 2 = way, in the form that does not cancel */
        if (way <= room) return t + 2 * way / (v + sqrt(fmax(v * v + 2 * slope * way, 0))) - from;
        way -= room;
        t = feed->time[k];
    }
}

wcut_status wcut_feed_eval(const wcut_feed *feed, int station, double from, double way, double *duration) {
    if (!feed || !duration || !(from >= 0 && isfinite(from)) || !is_positive(way) || feed->count < 1 || !feed->speed ||
        station < 1)
        return WCUT_BAD_ARGUMENT;
    if (feed->kind == WCUT_FEED_KIND_CONSTANT)
        *duration = way / feed->speed[0];
    else if (feed->kind == WCUT_FEED_KIND_STATIONS && station < feed->count)
        *duration = way / feed->speed[station];
    else if (feed->kind == WCUT_FEED_KIND_TIME && feed->time)
        *duration = time_of_way(feed, from, way);
    else
        return WCUT_BAD_ARGUMENT;
    return WCUT_OK;
}

/* ---- checks ---- */

static wcut_status check_feed(const wcut_job *job, wcut_error *error) {
    const wcut_feed *f = &job->feed;
    if (f->kind == WCUT_FEED_KIND_NONE) {
        if (job->rig.kind == WCUT_RIG_KIND_TWO_ARMS) return WCUT_OK;
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "feed: found none, expected a commanded speed: a %s has no other",
                         wcut_rig_name(job->rig.kind));
    }

    /* as many speeds as the kind asks for */
    const int expected = f->kind == WCUT_FEED_KIND_CONSTANT   ? 1
                         : f->kind == WCUT_FEED_KIND_STATIONS ? job->stations
                                                              : 0;
    if ((unsigned)f->kind > WCUT_FEED_KIND_TIME || !f->speed || (expected > 0 ? f->count != expected : f->count < 2) ||
        (f->kind == WCUT_FEED_KIND_TIME && !f->time))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "feed: found %d speeds, expected %d", f->count,
                         expected > 0 ? expected : 2);

    /* each positive and within the limits; times in order */
    for (int k = 0; k < f->count; k++) {
        const double v = f->speed[k];
        if (!is_positive(v))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "feed: speed %d: found %g mm/s, expected a positive speed", k,
                             v);
        if (v > job->speed_max || v < job->speed_min)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "feed: speed %d: found %g mm/s, expected the limits' %g to %g mm/s", k, v, job->speed_min,
                             job->speed_max);
        if (f->kind == WCUT_FEED_KIND_TIME &&
            !(f->time[k] > (k > 0 ? f->time[k - 1] : -1e-300) && isfinite(f->time[k])))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "feed: time %d: found %g s, expected times that increase from 0",
                             k, f->time[k]);
    }
    return WCUT_OK;
}

static wcut_status check_bow(const wcut_job *job, wcut_error *error) {
    /* what holds whatever the material */
    const wcut_rig *r = &job->rig;
    const wcut_wire_material *material = wcut_wire_material_view(job->wire_material);
    if (!(r->pretension >= 0 && isfinite(r->pretension)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "rig.pretension_N: found %g, expected a number greater than 0",
                         r->pretension);
    if (!(r->stiffness > 0))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "rig.stiffness_N_per_mm: found %g, expected a number greater than 0",
                         r->stiffness);
    if (!(r->wire_stiffness >= 0))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "rig.wire_stiffness_N: found %g, expected a number greater than 0",
                         r->wire_stiffness);

    /* what the material gives where the job does not */
    if (!material && (r->wire_stiffness == 0 || !(r->expansion >= 0)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "rig.%s: found none and a wire of %s, expected it, or wire.material to name Kanthal, FeCrAl, "
                         "Nikrothal, Nichrome or NiCr",
                         r->wire_stiffness == 0 ? "wire_stiffness_N" : "expansion_per_K",
                         job->wire_material ? job->wire_material : "no material");
    if (r->expansion > 1e-3)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "rig.expansion_per_K: found %g, expected at most 1e-3",
                         r->expansion);

    /* a wire that breaks before it cuts */
    const double section = WCUT_PI / 4 * job->wire_diameter * job->wire_diameter;
    if (material && r->pretension > material->cold_strength * section)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "rig.pretension_N: found %g, expected at most %.4g N: the strength of %s, %g MPa at 20 degC, "
                         "times the wire's section of %.4g mm2",
                         r->pretension, material->cold_strength * section, material->name, material->cold_strength,
                         section);
    return WCUT_OK;
}

wcut_status wcut_rig_check(const wcut_job *job, wcut_error *error) {
    const wcut_rig_kind kind = job->rig.kind;
    if ((unsigned)kind > WCUT_RIG_KIND_BLADE)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "rig.kind: found %d, expected two arms, a bow or a blade",
                         (int)kind);
    if (job->tool && kind == WCUT_RIG_KIND_TWO_ARMS)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "path.tool: found one tool with the rig two_arms, expected a bow or a blade: two arms have "
                         "mounts of their own");
    if (kind != WCUT_RIG_KIND_TWO_ARMS && job->mode != WCUT_MODE_PATH)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "design: found one with the rig %s, expected a path: a design shapes a slack wire, a %s is "
                         "straight at rest",
                         wcut_rig_name(kind), wcut_rig_name(kind));
    const wcut_status status = kind == WCUT_RIG_KIND_BOW ? check_bow(job, error) : WCUT_OK;
    return status == WCUT_OK ? check_feed(job, error) : status;
}
