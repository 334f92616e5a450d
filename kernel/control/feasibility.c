/* Whether a cut can be made: every station's figures over their limits, the worst of them in one word and a sentence. */
#include <wirecut/feasibility.h>

#include <stdio.h>

#include "base/degrees.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "control/robot_limits.h"

#define NEAR_LIMIT 0.95 /* [1] from here on a figure is at its limit */
#define ANGLE_MAX 100.0 /* [deg] beyond it a wire points back past its mount, whatever the head can do */
#define TURN_MAX 90.0   /* [deg] */
#define LOOP_MIN 270.0  /* [deg] an edge that turns by more to one side comes back to itself, or winds up */
#define EDGE_STEPS 1000 /* over which the turning of an edge is summed */
#define DEGREE (180.0 / WCUT_PI)

const char *wcut_feasibility_name(wcut_feasibility_verdict verdict) {
    static const char *const name[] = {"feasible", "at the limit", "infeasible"};
    return (unsigned)verdict < sizeof name / sizeof *name ? name[verdict] : "unknown";
}

/* the motion of what is in the foam at station j, from station `from` to the next */
static wcut_vec3 motion_in_foam(const wcut_history *h, int j, int from) {
    const size_t n = (size_t)h->nodes;
    wcut_vec3 sum = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        if (!(h->force_line[(size_t)j * n + i] > 0)) continue;
        const wcut_vec3 *x = h->position + (size_t)from * n + i;
        sum = vec3_add(sum, vec3_sub(x[n], x[0]));
    }
    return sum;
}

/* by how much the wire in the foam turns at station j [deg]; mounts may go back while it goes on */
static double turn_at(const wcut_history *h, int j) {
    if (j < 1 || j > h->stations - 2) return 0;
    const wcut_vec3 before = motion_in_foam(h, j, j - 1), after = motion_in_foam(h, j, j);
    const double size = vec3_length(before) * vec3_length(after);
    return size > 0 ? acos(clamp(vec3_dot(before, after) / size, -1, 1)) * DEGREE : 0;
}

/* what a sentence says of a figure */
typedef struct figure {
    const char *name, *unit;
    double value, limit;
} figure;

/* the figures of station j in the order of the measures */
static void measure_station(const wcut_history *h, const wcut_robot_limits *l, double stress_per_tension,
                            double strength, int j, figure *f) {
    const wcut_history_row *r = &h->row[j];
    const double alpha = fmax(fabs(r->alpha_a), fabs(r->alpha_b)), beta = fmax(fabs(r->beta_a), fabs(r->beta_b));
    f[WCUT_FEASIBILITY_MEASURE_SPEED] = (figure){"speed of a mount", "mm/s", fmax(r->speed_a, r->speed_b), l->speed};
    f[WCUT_FEASIBILITY_MEASURE_ALPHA] =
        (figure){"alpha of the wire at a mount", "deg", alpha * DEGREE, typed_degrees(l->alpha)};
    f[WCUT_FEASIBILITY_MEASURE_BETA] =
        (figure){"beta of the wire at a mount", "deg", beta * DEGREE, typed_degrees(l->beta)};
    f[WCUT_FEASIBILITY_MEASURE_TURN] = (figure){"turn of the wire", "deg", turn_at(h, j), TURN_MAX};
    f[WCUT_FEASIBILITY_MEASURE_STRESS] =
        (figure){"stress of the wire", "MPa", fmax(r->tension_a, r->tension_b) * stress_per_tension, strength};
}

/* T / F of the largest force at station j [mm]; INFINITY without force */
static double radius_at(const wcut_history *h, int j) {
    double line = 0;
    for (int i = 0; i < h->nodes; i++) line = fmax(line, h->force_line[(size_t)j * (size_t)h->nodes + (size_t)i]);
    const double tension = fmin(h->row[j].tension_a, h->row[j].tension_b);
    return line > 0 && tension > 0 ? tension / line : INFINITY;
}

/* the verdict of the worst figure at its station */
static void judge_figure(const figure *worst, int station, wcut_feasibility *v) {
    const double share = worst->value / worst->limit;
    const bool over = share > 1 + 1e-9;
    v->verdict = over                  ? WCUT_FEASIBILITY_VERDICT_INFEASIBLE
                 : share >= NEAR_LIMIT ? WCUT_FEASIBILITY_VERDICT_AT_LIMIT
                                       : WCUT_FEASIBILITY_VERDICT_FEASIBLE;
    v->station = station;
    snprintf(v->reason, sizeof v->reason, "%s: %.4g %s at station %d, limit %.4g %s", worst->name, worst->value,
             worst->unit, station, worst->limit, worst->unit);
}

/* by how much a drawn edge turns to one side in the plane of its side of the block, y and z, at most [deg] */
static double edge_turning(const wcut_curve *edge) {
    double first, last, sum = 0, turning = 0;
    wcut_vec3 before = {0, 0, 0};
    wcut_curve_domain(edge, &first, &last);
    for (int k = 0; k <= EDGE_STEPS; k++) {
        wcut_vec3 ders[2];
        if (wcut_curve_eval(edge, first + (last - first) * k / EDGE_STEPS, 1, ders) != WCUT_OK) return 0;

        /* the angle from the direction before; a direction along x has none */
        const wcut_vec3 d = {0, ders[1].y, ders[1].z};
        sum += atan2(before.y * d.z - before.z * d.y, before.y * d.y + before.z * d.z);
        turning = fmax(turning, fabs(sum));
        if (vec3_length(d) > 0) before = d;
    }
    return turning * DEGREE;
}

/* a design whose edge runs in a loop: the wire would have to go through its own cut */
static bool judge_edge_loops(const wcut_job *job, wcut_feasibility *v) {
    if (job->mode != WCUT_MODE_DESIGN || !job->edge_a || !job->edge_b) return false;
    const double a = edge_turning(job->edge_a), b = edge_turning(job->edge_b);
    if (!(fmax(a, b) > LOOP_MIN)) return false;
    v->verdict = WCUT_FEASIBILITY_VERDICT_INFEASIBLE;
    v->station = -1;
    snprintf(
        v->reason, sizeof v->reason,
        "edge %c runs in a loop: it turns by %.4g deg to one side, more than %g; the wire would run through its own "
        "cut, which is not modelled",
        a >= b ? 'A' : 'B', fmax(a, b), LOOP_MIN);
    return true;
}

/* what makes a cut infeasible whatever its limits; false where nothing does */
static bool judge_course(const wcut_history *h, wcut_feasibility *v) {
    /* the largest angle of the wire to its rest direction */
    const wcut_history_row *last = &h->row[h->stations - 1];
    int steep = -1;
    double angle = ANGLE_MAX / DEGREE;
    for (int j = 0; j < h->stations; j++) {
        const double larger = fmax(fabs(h->row[j].alpha_a), fabs(h->row[j].alpha_b));
        if (larger > angle) angle = larger, steep = j;
    }

    /* in the order in which a reader has to mend them */
    v->verdict = WCUT_FEASIBILITY_VERDICT_INFEASIBLE;
    v->station = h->stations - 1;
    if (h->stations < h->planned) {
        snprintf(v->reason, sizeof v->reason, "it ends after station %d of 0 to %d: %.180s", h->stations - 1,
                 h->planned - 1, h->ended.text);
    } else if (steep >= 0) {
        v->station = steep;
        snprintf(v->reason, sizeof v->reason,
                 "the wire stands at %.4g deg to its rest direction at station %d, more than %g: edges exchanged, or a "
                 "mount that overtakes its wire",
                 angle * DEGREE, steep, ANGLE_MAX);
    } else if (last->engaged_length > 0) {
        snprintf(v->reason, sizeof v->reason, "the path ends at station %d with %.4g mm of wire in the foam",
                 h->stations - 1, last->engaged_length);
    } else {
        return false;
    }

    return true;
}

wcut_status wcut_feasibility_eval(const wcut_job *job, const wcut_history *h, const wcut_vec3 *mount_a,
                                  const wcut_vec3 *mount_b, const wcut_robot_limits *limits, wcut_feasibility *verdict,
                                  double *share) {
    /* check everything before the first station */
    if (!job || !h || !h->row || !h->force_line || !h->position || h->stations < 1 || h->nodes < 1 || !mount_a ||
        !mount_b || !verdict || !vec3_all_finite(h->stations, mount_a) || !vec3_all_finite(h->stations, mount_b))
        return WCUT_BAD_ARGUMENT;

    /* stress by tension: 1 / area of the wire's section */
    const wcut_robot_limits l = limits ? *limits : wcut_robot_limits_default(job);
    double temperature, strength;
    if (!is_positive(job->wire_diameter) || !wcut_limits_wire(job, &l, &temperature, &strength))
        return WCUT_BAD_ARGUMENT;
    const double per_tension = 1 / (WCUT_PI / 4 * job->wire_diameter * job->wire_diameter);

    /* every figure of every station over its limit, and the worst of them */
    wcut_feasibility v = {.station = -1, .radius_min = INFINITY};
    figure worst = {"", "", 0, 1};
    int at = 0;
    for (int j = 0; j < h->stations; j++) {
        figure f[WCUT_FEASIBILITY_MEASURE_COUNT];
        measure_station(h, &l, per_tension, strength, j, f);
        v.radius_min = fmin(v.radius_min, radius_at(h, j));
        for (int k = 0; k < WCUT_FEASIBILITY_MEASURE_COUNT; k++) {
            if (share) share[(size_t)k * (size_t)h->stations + (size_t)j] = f[k].value / f[k].limit;

            /* out of the foam every wire is fed at the largest speed: at that limit is no news, beyond it is */
            const bool fed = k == WCUT_FEASIBILITY_MEASURE_SPEED && f[k].value <= f[k].limit * (1 + 1e-9);
            if (!fed && f[k].value / f[k].limit > worst.value / worst.limit) worst = f[k], at = j;
        }
    }

    /* a course that cannot be run comes before any figure */
    if (!judge_edge_loops(job, &v) && !judge_course(h, &v)) judge_figure(&worst, at, &v);
    *verdict = v;

    return WCUT_OK;
}
