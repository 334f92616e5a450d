/* Paths corrected for what the machine does: an effect that moves the face, and most of it taken back. */
#include <string.h>
#include <wirecut/compensation.h>

#include "cut/cuts.h"
#include "inverse/given.h"

/* a curved cut of the block of the given targets */
static wcut_job *curved_job(void) {
    wcut_job *job = straight_job(400, 80, 640, 31, 61, -120, 780);
    job->block_size = given_block;
    for (int j = 0; j < job->stations; j++) {
        job->mount_a[j].z += 25 * sin(0.08 * j);
        job->mount_b[j].z += 20 * sin(0.06 * j + 1);
    }
    return job;
}

/* the surface that a job's wire sweeps, as a target */
static wcut_design_target *planned_target(const wcut_job *job) {
    wcut_history *history = run_of(job);
    wcut_surface *surface = NULL;
    wcut_design_target *target = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(
        wcut_surface_loft(history->stations, history->nodes, history->position, 1e-3, &surface, NULL, NULL), WCUT_OK);
    const wcut_status status = wcut_design_target_from_surface(surface, given_block, &target, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    wcut_surface_destroy(surface);
    wcut_history_destroy(history);
    return target;
}

/* what is left of a deviation over what there was */
static double remaining(wcut_effect effect) {
    wcut_job *job = curved_job();
    wcut_design_target *target = planned_target(job);
    job->effect = wcut_alloc(1, sizeof *job->effect);
    job->effect[0] = effect;
    job->effect_count = 1;
    wcut_design_options o = wcut_design_options_default();
    o.unknowns_max = 12;
    wcut_compensation *c = NULL;
    wcut_error error = {0};
    ck_assert_msg(wcut_compensation_fit(target, job, &o, NULL, NULL, &c, &error) == WCUT_OK, "%s", error.text);
    double rms, max;
    ck_assert_int_eq(wcut_compensation_measure(target, c->job, 1, &rms, &max, &error), WCUT_OK);
    ck_assert_double_eq_tol(rms, c->after_rms, 1e-6 + 0.05 * rms);
    const double share = c->after_rms / c->before_rms;
    ck_assert_double_gt(c->before_rms, 0.05);
    wcut_compensation_destroy(c);
    wcut_design_target_destroy(target);
    wcut_job_destroy(job);
    return share;
}

TEST(elongation_of_the_wire_is_taken_back_by_nine_tenths) {
    wcut_effect e = wcut_effect_default(WCUT_EFFECT_WIRE_ELONGATION);
    e.value[0] = 4e-3;
    const double share = remaining(e);
    ck_assert_msg(share < 0.1, "%g of it is left", share);
}

TEST(a_compensation_without_memory_leaves_nothing) {
    wcut_job *job = curved_job();
    wcut_design_target *target = planned_target(job);
    wcut_compensation *c = NULL;
    FIRST_FAILED_ALLOCATIONS(40, wcut_compensation_fit(target, job, NULL, NULL, NULL, &c, NULL), c == NULL);
    wcut_design_target_destroy(target);
    wcut_job_destroy(job);
}
