/* A correction in a job: law, wire, kerf and effects go in, what belongs to one cut goes out. labels: unit */
#include <wirecut/correction.h>

#include "cut/cuts.h"
#include "test.h"

static wcut_correction given(void) {
    wcut_correction c = {.a = 0.05, .b = 6e-4, .length_change = 1.5, .kerf = 0.9, .kerf_per_q = 1e-4, .effects = 2};
    c.effect[0] = wcut_effect_default(WCUT_EFFECT_WIRE_THERMAL_LAG), c.effect[0].value[0] = 0.4;
    c.effect[1] = wcut_effect_choose(WCUT_EFFECT_EMPIRICAL_FORCE, 4), c.effect[1].value[0] = 0.2;
    return c;
}

static wcut_job *excited_job(void) {
    wcut_job *job = straight_job(400, 60, 620, 41, 10, 200, 260);
    const wcut_effect own = wcut_effect_default(WCUT_EFFECT_RATE_DEPENDENCE);
    const wcut_dither dither = {0.05, 3, 0};
    const wcut_heat_step step = {3, 5, 0.9};
    job->effect = wcut_copy(&own, 1, sizeof own), job->effect_count = 1;
    job->dither = wcut_copy(&dither, 1, sizeof dither), job->dither_count = 1;
    job->heat_step = wcut_copy(&step, 1, sizeof step), job->heat_step_count = 1;
    ck_assert(job->effect && job->dither && job->heat_step);
    return job;
}

TEST(everything_goes_into_the_job_and_its_excitation_goes) {
    wcut_correction c = given();
    wcut_job *job = excited_job();
    ck_assert_int_eq(wcut_correction_apply(&c, job, NULL), WCUT_OK);
    ck_assert_double_eq(job->force_law.a, 0.05);
    ck_assert_double_eq(job->force_law.b, 6e-4);
    ck_assert_double_eq(job->wire_length, 621.5);
    ck_assert_double_eq(job->kerf_width, 0.9);
    ck_assert_double_eq(job->kerf_per_q, 1e-4);
    ck_assert_int_eq(job->effect_count, 2);
    ck_assert_int_eq(job->effect[1].choice, 4);
    ck_assert(job->dither_count == 0 && job->heat_step_count == 0 && !job->dither && !job->heat_step);
    wcut_history_destroy(run_of(job));

    /* without a scan the job keeps its kerf */
    c.kerf = (double)NAN;
    job->kerf_width = 1.1;
    ck_assert_int_eq(wcut_correction_apply(&c, job, NULL), WCUT_OK);
    ck_assert_double_eq(job->kerf_width, 1.1);
    wcut_job_destroy(job);
}

TEST(what_cannot_be_applied_leaves_the_job_as_it_was) {
    const wcut_correction whole = given();
    wcut_correction c[6] = {whole, whole, whole, whole, whole, whole};
    c[0].a = 0, c[1].b = (double)NAN, c[2].length_change = -700, c[3].effects = WCUT_CORRECTION_EFFECTS + 1;
    c[4].kerf = -1, c[5].effect[0].value[0] = -3;
    wcut_job *job = excited_job();
    for (int k = 0; k < 6; k++) {
        wcut_error error = {0};
        ck_assert_int_eq(wcut_correction_apply(&c[k], job, &error), WCUT_BAD_ARGUMENT);
        ck_assert_int_gt((int)strlen(error.text), 10);
        ck_assert_double_eq(job->wire_length, 620);
        ck_assert(job->effect_count == 1 && job->dither_count == 1);
    }
    ck_assert_int_eq(wcut_correction_apply(NULL, job, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_correction_apply(&whole, NULL, NULL), WCUT_BAD_ARGUMENT);

    /* a design has no mounts that an effect could need */
    wcut_error error = {0};
    wcut_correction mounts = whole;
    mounts.effect[0] = wcut_effect_default(WCUT_EFFECT_END_COOLING);
    job->mode = WCUT_MODE_DESIGN;
    ck_assert_int_eq(wcut_correction_apply(&mounts, job, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "end_cooling needs mounts"));
    FIRST_FAILED_ALLOCATIONS(1, wcut_correction_apply(&whole, job, &error), job->effect_count == 1);
    job->mode = WCUT_MODE_PATH;
    wcut_job_destroy(job);
}
