/* What a diagnosis must not depend on: the order of the cuts, and which mount is called A. Two short cuts each.
   labels: unit plain */
#include "explain/machine.h"
#include "test.h"

static wcut_diagnosis *diagnose(const machine_case *m) {
    wcut_diagnosis *d = machine_diagnose(m, NULL);
    ck_assert_int_eq(d->effects, 1);
    return d;
}

/* a lag of 0.8 s, found in either order with the same numbers but for the order of sums */
TEST(shuffled_cuts_have_the_same_verdict) {
    const machine_secret secret = {
        .effects = 1, .effect = {machine_effect(WCUT_EFFECT_WIRE_THERMAL_LAG, 0, 0.8, 0)}, .seed = 5};
    machine_case m = machine_create(2, &secret);
    wcut_diagnosis *d = diagnose(&m);
    const wcut_diagnosis_cut first = m.cut[0];
    m.cut[0] = m.cut[1], m.cut[1] = first;
    wcut_diagnosis *shuffled = diagnose(&m);
    ck_assert_msg(machine_names(d, WCUT_EFFECT_WIRE_THERMAL_LAG, WCUT_EFFECT_WIRE_THERMAL_LAG), "%s",
                  machine_verdict(d));
    ck_assert_msg(machine_names(shuffled, WCUT_EFFECT_WIRE_THERMAL_LAG, WCUT_EFFECT_WIRE_THERMAL_LAG), "%s",
                  machine_verdict(shuffled));
    const double value = d->effect[0].effect.value[0], other = shuffled->effect[0].effect.value[0];
    ck_assert_msg(fabs(other / value - 1) < 0.02, "%g and %g", value, other);
    wcut_diagnosis_destroy(shuffled);
    wcut_diagnosis_destroy(d);
    machine_destroy(&m);
}

/* ---- the cell seen from behind: A is B, and x runs the other way ---- */

static void swap_columns(wcut_recording *r, wcut_channel a, wcut_channel b) {
    double *value = r->channel[a].value;
    r->channel[a].value = r->channel[b].value, r->channel[b].value = value;
}

static void swap_mounts(machine_case *m) {
    for (int k = 0; k < m->cuts; k++) {
        wcut_job *job = m->job[k];
        wcut_recording *r = &m->run[k]->recording;
        const double width = job->block_size.x;
        for (int j = 0; j < job->stations; j++) {
            const wcut_vec3 a = job->mount_a[j], b = job->mount_b[j];
            job->mount_a[j] = (wcut_vec3){width - b.x, b.y, b.z};
            job->mount_b[j] = (wcut_vec3){width - a.x, a.y, a.z};
        }
        swap_columns(r, WCUT_CHANNEL_SPEED_A, WCUT_CHANNEL_SPEED_B);
        swap_columns(r, WCUT_CHANNEL_TENSION_A, WCUT_CHANNEL_TENSION_B);
        swap_columns(r, WCUT_CHANNEL_ALPHA_A, WCUT_CHANNEL_ALPHA_B);
        swap_columns(r, WCUT_CHANNEL_BETA_A, WCUT_CHANNEL_BETA_B);
        for (int axis = 0; axis < 3; axis++)
            swap_columns(r, (wcut_channel)(WCUT_CHANNEL_A_X + axis), (wcut_channel)(WCUT_CHANNEL_B_X + axis));
        for (int i = 0; i < r->samples; i++) {
            r->channel[WCUT_CHANNEL_A_X].value[i] = width - r->channel[WCUT_CHANNEL_A_X].value[i];
            r->channel[WCUT_CHANNEL_B_X].value[i] = width - r->channel[WCUT_CHANNEL_B_X].value[i];
        }
    }
}

/* foam that gets denser from A to B gets softer from B to A, by as much */
TEST(swapped_mounts_turn_the_sign_of_a_gradient_across) {
    const machine_secret secret = {
        .effects = 1, .effect = {machine_effect(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0, 0.2, 0)}, .seed = 5};
    machine_case m = machine_create(2, &secret);
    wcut_diagnosis *d = diagnose(&m);
    swap_mounts(&m);
    wcut_diagnosis *swapped = diagnose(&m);
    ck_assert_msg(machine_names(d, WCUT_EFFECT_FOAM_DENSITY_GRADIENT, WCUT_EFFECT_FOAM_DENSITY_GRADIENT), "%s",
                  machine_verdict(d));
    ck_assert_msg(machine_names(swapped, WCUT_EFFECT_FOAM_DENSITY_GRADIENT, WCUT_EFFECT_FOAM_DENSITY_GRADIENT), "%s",
                  machine_verdict(swapped));
    ck_assert_int_eq(d->effect[0].effect.choice, 0);
    ck_assert_int_eq(swapped->effect[0].effect.choice, 0);
    const double change = d->effect[0].effect.value[0], turned = swapped->effect[0].effect.value[0];
    ck_assert_msg(change > 0.13 && fabs(change + turned) < 0.02, "%g and %g", change, turned);
    ck_assert_double_eq_tol(d->a.value, swapped->a.value, 0.01 * d->a.value);
    wcut_diagnosis_destroy(swapped);
    wcut_diagnosis_destroy(d);
    machine_destroy(&m);
}

/* a zero of sensor a becomes one of sensor b, with its sign */
TEST(swapped_mounts_move_a_zero_to_the_other_sensor) {
    const machine_secret secret = {
        .effects = 1, .effect = {machine_effect(WCUT_EFFECT_TENSION_ZERO, 0, 0.25, 0)}, .seed = 7};
    machine_case m = machine_create(2, &secret);
    wcut_diagnosis *d = diagnose(&m);
    swap_mounts(&m);
    wcut_diagnosis *swapped = diagnose(&m);
    ck_assert_msg(machine_names(d, WCUT_EFFECT_TENSION_ZERO, WCUT_EFFECT_TENSION_ZERO), "%s", machine_verdict(d));
    ck_assert_msg(machine_names(swapped, WCUT_EFFECT_TENSION_ZERO, WCUT_EFFECT_TENSION_ZERO), "%s",
                  machine_verdict(swapped));
    ck_assert_int_eq(d->effect[0].effect.choice, 0);
    ck_assert_int_eq(swapped->effect[0].effect.choice, 1);
    ck_assert_double_eq_tol(d->effect[0].effect.value[0], swapped->effect[0].effect.value[0], 1e-3);
    wcut_diagnosis_destroy(swapped);
    wcut_diagnosis_destroy(d);
    machine_destroy(&m);
}
