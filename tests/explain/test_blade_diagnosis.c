/* The diagnosis of a blade: sliding along the edge is found where the simulator has it, and nothing where it has not. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/cut.h>
#include <wirecut/diagnosis.h>
#include <wirecut/recording_file.h>

#include "base/alloc.h"
#include "base/random.h"
#include "base/vec3.h"
#include "foam/blade_edge.h"
#include "test.h"

enum { CUTS = 4, STATIONS = 121 };

static wcut_error error;

/* an upright knife through a block of 200 x 300 x 100 mm, lifted along its edge by `ratio` of its advance from y = 60 to 200 */
static wcut_job *blade_job(double ratio) {
    wcut_job *job = NULL;
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->block_size = vec3(200, 300, 100);
    job->wire_diameter = 0.5, job->nodes = 61;
    job->heat = 0, job->tension = 0;
    job->force_law = (wcut_force_law){0.1, 1e-4};
    job->rig.kind = WCUT_RIG_KIND_BLADE;
    job->feed = (wcut_feed){WCUT_FEED_KIND_STATIONS, STATIONS, malloc(STATIONS * sizeof(double)), NULL};
    job->mode = WCUT_MODE_PATH, job->stations = STATIONS;
    job->tool = calloc(STATIONS, sizeof *job->tool);
    double z = -200;
    for (int j = 0; j < STATIONS; j++) {
        const double y = -40 + 2.0 * j;
        const double lift = y > 60 && y < 200 ? ratio : 0;
        z += 2 * lift;
        job->feed.speed[j] = 12 * hypot(1, lift); /* 12 mm/s across the edge */
        job->tool[j] = (wcut_pose){{100, y, z}, {1, 0, 0, 0}};
    }
    job->mount_a_in_tool = vec3(0, 0, 600), job->mount_b_in_tool = vec3(0, 0, 0);
    ck_assert_msg(wcut_job_place_mounts(job, &error) == WCUT_OK, "%s", error.text);
    return job;
}

static wcut_column column(wcut_channel channel, const double *value) {
    return (wcut_column){.name = wcut_copy_text(wcut_channel_name(channel)),
                         .value = wcut_copy(value, STATIONS, sizeof *value)};
}

/* what a force sensor at the handle would record of a simulated cut: noise of 0.02 N, a zero of 0.5 N along x and y */
static wcut_recording *record(const wcut_job *job, uint64_t seed) {
    static double row[7][STATIONS];
    wcut_setup *setup = NULL;
    wcut_cut *cut = NULL;
    wcut_random random = wcut_random_seed(seed);
    ck_assert_msg(wcut_setup_create(job, NULL, &setup, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(wcut_cut_create(setup, &cut, &error), WCUT_OK);
    for (int j = 0; j < STATIONS; j++) {
        if (j > 0) ck_assert_msg(wcut_cut_step(cut, &error) == WCUT_OK, "%s", error.text);
        wcut_station s;
        wcut_vec3 sum = vec3(0.5, 0.5, 0);
        wcut_cut_view(cut, &s);
        for (int i = 0; i < s.nodes; i++) sum = vec3_add(sum, s.force[i]);
        const double read[7] = {s.time, sum.x, sum.y, sum.z, job->tool[j].at.x, job->tool[j].at.y, job->tool[j].at.z};
        for (int k = 0; k < 7; k++) row[k][j] = read[k] + (k > 0 && k < 4 ? 0.02 * wcut_random_normal(&random) : 0);
    }
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);

    /* the channels of a tool */
    wcut_recording *r = wcut_alloc(1, sizeof *r);
    r->samples = STATIONS;
    r->further = wcut_alloc(1, sizeof *r->further);
    r->further->rows = STATIONS, r->further->line = wcut_alloc(STATIONS, sizeof(int));
    static const wcut_channel channel[7] = {WCUT_CHANNEL_TIME,    WCUT_CHANNEL_FORCE_X, WCUT_CHANNEL_FORCE_Y,
                                            WCUT_CHANNEL_FORCE_Z, WCUT_CHANNEL_TOOL_X,  WCUT_CHANNEL_TOOL_Y,
                                            WCUT_CHANNEL_TOOL_Z};
    for (int k = 0; k < 7; k++) r->channel[channel[k]] = column(channel[k], row[k]);
    return r;
}

/* cuts with these ratios, recorded with softening at sliding_ratio (infinite: none); the jobs do not know of it */
static wcut_diagnosis *diagnose(int cuts, const double *ratio, double sliding_ratio) {
    wcut_diagnosis_cut cut[CUTS] = {{0}};
    wcut_diagnosis *d = NULL;
    wcut_effect slice = wcut_effect_default(WCUT_EFFECT_SLICE_SOFTENING);
    slice.value[WCUT_SLICE_SOFTENING_RATIO] = sliding_ratio;
    for (int k = 0; k < cuts; k++) {
        wcut_job *job = blade_job(ratio[k]);
        job->effect = &slice, job->effect_count = 1;
        job->force_law.a = 0.14; /* the jobs have another coefficient */
        cut[k].recording = record(job, 7 + (uint64_t)k);
        job->effect = NULL, job->effect_count = 0;
        job->force_law.a = 0.1;
        cut[k].job = job;
    }
    ck_assert_msg(wcut_diagnosis_create(cuts, cut, 0, NULL, NULL, NULL, NULL, &d, &error) == WCUT_OK, "%s", error.text);
    for (int k = 0; k < cuts; k++) {
        wcut_job_destroy((wcut_job *)cut[k].job);
        wcut_recording_destroy((wcut_recording *)cut[k].recording);
    }
    return d;
}

TEST(sliding_is_named_with_its_ratio_and_cuts_left_out_are_predicted) {
    const double ratio[CUTS] = {0, 0.5, 1, 2};
    wcut_diagnosis *d = diagnose(CUTS, ratio, 0.8);
    ck_assert_msg(d->kind == WCUT_VERDICT_PHYSICS, "%s", d->sentence);
    ck_assert_int_eq(d->effects, 1);
    ck_assert_int_eq(d->effect[0].effect.kind, WCUT_EFFECT_SLICE_SOFTENING);
    const wcut_estimate *e = &d->effect[0].parameter[WCUT_SLICE_SOFTENING_RATIO];
    ck_assert_msg(e->low <= 0.8 && e->high >= 0.8 && fabs(e->value - 0.8) < 0.08, "%g [%g, %g]", e->value, e->low,
                  e->high);
    ck_assert_double_eq_tol(d->a.value, 0.14, 0.007);
    const int force = WCUT_EVIDENCE_CHANNEL_FORCE;
    const double before = d->held_out_score[WCUT_EVIDENCE_MODEL_RECALIBRATED][force].rmse;
    ck_assert_double_lt(d->held_out_score[WCUT_EVIDENCE_MODEL_AFTER][force].rmse, 0.2 * before);
    ck_assert_int_eq(d->held_out_score[WCUT_EVIDENCE_MODEL_BLACK_BOX][force].count,
                     d->held_out_score[WCUT_EVIDENCE_MODEL_AFTER][force].count);
    ck_assert_ptr_nonnull(d->improved);
    ck_assert_int_eq(d->improved->effect_count, 1);
    ck_assert(d->mismatches > 0 && d->traces == CUTS && d->rig_rows > 3);
    wcut_diagnosis_destroy(d);
}

TEST(without_softening_nothing_is_named) {
    const double ratio[CUTS] = {0, 0.5, 1, 2};
    wcut_diagnosis *d = diagnose(CUTS, ratio, INFINITY);
    ck_assert_msg(d->effects == 0, "%s", d->sentence);
    ck_assert_double_eq_tol(d->a.value, 0.14, 0.007);
    wcut_diagnosis_destroy(d);
}

TEST(cuts_that_slide_alike_or_are_two_name_nothing) {
    const double alike[CUTS] = {1, 1, 1, 1}, two[2] = {0, 2};
    wcut_diagnosis *d = diagnose(CUTS, alike, 0.8);
    ck_assert_msg(d->effects == 0, "%s", d->sentence);
    wcut_diagnosis_destroy(d);
    d = diagnose(2, two, 0.8);
    ck_assert_msg(d->effects == 0 && d->kind == WCUT_VERDICT_UNKNOWN, "%s", d->sentence);
    wcut_diagnosis_destroy(d);
}

TEST(rigs_that_differ_and_recordings_of_the_other_rig_are_refused) {
    wcut_job *blade = blade_job(0), *arms = blade_job(0);
    wcut_recording *r = record(blade, 1);
    wcut_diagnosis *d = (wcut_diagnosis *)&error;
    arms->rig.kind = WCUT_RIG_KIND_TWO_ARMS;
    const wcut_diagnosis_cut mixed[2] = {{blade, r, NULL}, {arms, r, NULL}}, other = {arms, r, NULL};
    ck_assert_int_eq(wcut_diagnosis_create(2, mixed, 0, NULL, NULL, NULL, NULL, &d, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_diagnosis_create(1, &other, 0, NULL, NULL, NULL, NULL, &d, &error), WCUT_BAD_ARGUMENT);
    ck_assert(d == (wcut_diagnosis *)&error);
    wcut_job_destroy(blade);
    wcut_job_destroy(arms);
    wcut_recording_destroy(r);
}

TEST(want_of_memory_leaves_no_diagnosis) {
    wcut_job *job[3];
    wcut_recording *recording[3];
    wcut_diagnosis_cut cut[3] = {{0}};
    wcut_diagnosis_options o = wcut_diagnosis_options_default();
    for (int k = WCUT_EFFECT_COUNT - 1; k >= 0; k--) o.without[k] = k != WCUT_EFFECT_SLICE_SOFTENING;
    for (int k = 0; k < 3; k++) {
        job[k] = blade_job(k);
        recording[k] = record(job[k], 3 + (uint64_t)k);
        cut[k] = (wcut_diagnosis_cut){job[k], recording[k], NULL};
    }

    /* each of the first allocations, then some of those of the fits, until one comes to its end */
    wcut_diagnosis *d = (wcut_diagnosis *)&error;
    int failed = 0;
    for (long k = 1;; k += k < 60 ? 1 : k / 2) {
        wcut_alloc_fail_at(k);
        const wcut_status status = wcut_diagnosis_create(3, cut, 0, NULL, &o, NULL, NULL, &d, &error);
        wcut_alloc_fail_at(0);
        if (status == WCUT_OK) break;
        ck_assert_msg(status == WCUT_NO_MEMORY, "allocation %ld: %s", k, error.text);
        ck_assert(d == (wcut_diagnosis *)&error);
        failed++;
    }
    ck_assert_int_gt(failed, 60);
    wcut_diagnosis_destroy(d);
    for (int k = 0; k < 3; k++) wcut_job_destroy(job[k]), wcut_recording_destroy(recording[k]);
}

TEST(an_edge_feels_what_earlier_passes_have_left) {
    /* upright edge, tip at z = 40 in the first pass and at 10 in the second; a block 100 mm high */
    enum { N = 60 };
    wcut_vec3 place[2 * N];
    int pass[2 * N];
    double engaged[2 * N];
    for (int i = 0; i < 2 * N; i++) place[i] = vec3(50, i % N, i < N ? 40 : 10), pass[i] = i >= N;
    const wcut_blade_way way = {2 * N, place, pass, vec3(0, 0, -1), vec3(0, 1, 0), -300, 0};
    ck_assert_int_eq(wcut_blade_engaged(&way, vec3(0, 10.25, 0), vec3(100, 200, 100), engaged), WCUT_OK);
    for (int i = 0; i < 2 * N; i++) {
        const double expected = i % N < 11 ? 0 : i < N ? 60 : 30;
        ck_assert_msg(fabs(engaged[i] - expected) < 1e-12, "%d: %g, expected %g", i, engaged[i], expected);
    }
}
