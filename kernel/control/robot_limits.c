/* A cut against what cell and wire bear: speeds, accelerations, the head's angles, heat and stress of the wire. */
#include "control/robot_limits.h"

#include "base/degrees.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* what a job states of its wire, else that of its material */
static double stated_or(double stated, double otherwise) { return stated > 0 ? stated : otherwise; }

wcut_robot_limits wcut_robot_limits_default(const wcut_job *job) {
    const wcut_wire_material *named = wcut_wire_material_view(job->wire_material);
    const wcut_wire_material *of = named ? named : wcut_wire_material_view("Kanthal");
    return (wcut_robot_limits){.speed = job->speed_max,
                               .acceleration = 1000,
                               .alpha = 60 * WCUT_PI / 180,
                               .beta = 30 * WCUT_PI / 180,
                               .ambient = 20,
                               .emissivity = stated_or(job->wire_emissivity, of->emissivity),
                               .temperature = 900,
                               .cold_strength = stated_or(job->wire_cold_strength, of->cold_strength),
                               .hot_strength = stated_or(job->wire_hot_strength, of->hot_strength),
                               .hot_temperature = of->hot_temperature};
}

/* ---- the wire ---- */

/* [MPa] between its two known values, and on, exponentially */
static double strength_at(const wcut_robot_limits *l, double temperature) {
    const double share = (temperature - 20) / (l->hot_temperature - 20);
    return l->cold_strength * pow(l->hot_strength / l->cold_strength, share);
}

bool wcut_limits_wire(const wcut_job *job, const wcut_robot_limits *l, double *temperature, double *wire_strength) {
    const double positive[] = {l->speed,         l->acceleration, l->alpha,       l->beta,
                               l->cold_strength, l->hot_strength, l->temperature, l->hot_temperature};
    if (!all_positive(sizeof positive / sizeof *positive, positive) || !(l->hot_temperature > 20) ||
        wcut_wire_temperature(job->heat, job->wire_diameter, l->ambient, l->emissivity, temperature) != WCUT_OK)
        return false;
    *wire_strength = strength_at(l, *temperature);
    return true;
}

/* ---- the motion ---- */

static void raise(wcut_robot_check *check, double value, int station) {
    if (!(value > check->value) && check->station >= 0) return;
    check->value = value;
    check->station = station;
}

/* the change of a mount's velocity at station j over the mean of the moves before and behind it */
static double acceleration(const wcut_history_row *row, const wcut_vec3 *x, int j) {
    const wcut_vec3 before = vec3_scale(1 / row[j].duration, vec3_sub(x[j], x[j - 1]));
    const wcut_vec3 after = vec3_scale(1 / row[j + 1].duration, vec3_sub(x[j + 1], x[j]));
    return vec3_distance(before, after) / ((row[j].duration + row[j + 1].duration) / 2);
}

enum { SPEED, ACCELERATION = 2, ALPHA = 4, BETA = 6, TEMPERATURE = 8, STRESS };

static void check_motion(const wcut_history *h, const wcut_vec3 *const mount[2], wcut_robot_check *check) {
    for (int j = 0; j < h->stations; j++) {
        const wcut_history_row *r = &h->row[j];
        const double alpha[2] = {fabs(r->alpha_a), fabs(r->alpha_b)}, beta[2] = {fabs(r->beta_a), fabs(r->beta_b)};
        for (int k = 0; k < 2; k++) {
            if (j > 0) raise(&check[SPEED + k], vec3_distance(mount[k][j], mount[k][j - 1]) / r->duration, j);
            if (j > 0 && j < h->stations - 1) raise(&check[ACCELERATION + k], acceleration(h->row, mount[k], j), j);
            raise(&check[ALPHA + k], alpha[k] * 180 / WCUT_PI, j);
            raise(&check[BETA + k], beta[k] * 180 / WCUT_PI, j);
        }
        raise(&check[STRESS], fmax(r->tension_a, r->tension_b), j); /* [N] so far */
    }
}

wcut_status wcut_robot_limits_check(const wcut_job *job, const wcut_history *history, const wcut_vec3 *mount_a,
                                    const wcut_vec3 *mount_b, const wcut_robot_limits *limits, wcut_robot_check *out) {
    if (!job || !history || !history->row || history->stations < 2 || !mount_a || !mount_b || !out ||
        !vec3_all_finite(history->stations, mount_a) || !vec3_all_finite(history->stations, mount_b))
        return WCUT_BAD_ARGUMENT;

    /* limits of the cell, temperature and strength of the wire */
    const wcut_robot_limits l = limits ? *limits : wcut_robot_limits_default(job);
    double temperature, wire_strength;
    if (!wcut_limits_wire(job, &l, &temperature, &wire_strength)) return WCUT_BAD_ARGUMENT;

    /* the checks in the order of the report; values are filled in */
    wcut_robot_check check[WCUT_ROBOT_CHECKS] = {{"speed of mount A", "mm/s", 0, l.speed, -1, false},
                                                 {"speed of mount B", "mm/s", 0, l.speed, -1, false},
                                                 {"acceleration of mount A", "mm/s^2", 0, l.acceleration, -1, false},
                                                 {"acceleration of mount B", "mm/s^2", 0, l.acceleration, -1, false},
                                                 {"alpha at mount A", "deg", 0, typed_degrees(l.alpha), -1, false},
                                                 {"alpha at mount B", "deg", 0, typed_degrees(l.alpha), -1, false},
                                                 {"beta at mount A", "deg", 0, typed_degrees(l.beta), -1, false},
                                                 {"beta at mount B", "deg", 0, typed_degrees(l.beta), -1, false},
                                                 {"wire in still air", "degC", 0, l.temperature, -1, false},
                                                 {"stress of the wire in air", "MPa", 0, 0, -1, false}};

    /* mounts' motion and angles; temperature and stress come from the wire */
    const wcut_vec3 *const mount[2] = {mount_a, mount_b};
    check_motion(history, mount, check);
    check[TEMPERATURE].value = temperature;
    check[STRESS].value /= WCUT_PI / 4 * job->wire_diameter * job->wire_diameter;
    check[STRESS].limit = wire_strength;

    /* compare each with its limit */
    for (int i = 0; i < WCUT_ROBOT_CHECKS; i++) {
        check[i].over = check[i].value > check[i].limit * (1 + 1e-9); /* what is at its limit is within it */
        out[i] = check[i];
    }

    return WCUT_OK;
}
