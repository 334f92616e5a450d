/* Bad jobs: each is refused with its place and expectation, and nothing is written; a step without a solution ends the
   run with the station before still in view. */
#include <limits.h>
#include <wirecut/summary.h>
#include "cut/cuts.h"

#include "test.h"

/* what is expected of a job that `spoil` has spoilt */
typedef struct bad {
    void (*spoil)(wcut_job *job);
    wcut_status status;
    const char *text[3]; /* parts of the message; NULL ends them */
} bad;

static void no_width(wcut_job *j) { j->block_size.x = 0; }
static void endless_block(wcut_job *j) { j->block_size.y = (double)INFINITY; }
static void no_height(wcut_job *j) { j->block_size.z = NAN; }
static void no_diameter(wcut_job *j) { j->wire_diameter = -0.1; }
static void no_heat(wcut_job *j) { j->heat = 0; }
static void no_tension(wcut_job *j) { j->tension = NAN; }
static void no_force(wcut_job *j) { j->force_law.a = 0; }
static void no_decay(wcut_job *j) { j->force_law.b = -1e-3; }
static void no_speed(wcut_job *j) { j->speed_max = 0; }
static void negative_speed(wcut_job *j) { j->speed_min = -1; }
static void crossed_limits(wcut_job *j) { j->speed_min = 100; }
static void two_nodes(wcut_job *j) { j->nodes = 2; }
static void one_station(wcut_job *j) { j->stations = 1; }
static void no_length(wcut_job *j) { j->wire_length = 0; }
static void nan_mount(wcut_job *j) { j->mount_b[7].z = NAN; }
static void no_mounts(wcut_job *j) { j->mount_a = (wcut_free(j->mount_a), NULL); }
static void short_wire(wcut_job *j) { j->mount_b[12].x = 580; }
static void mount_inside(wcut_job *j) { j->mount_b[5].x = 390; }
static void mounts_meet(wcut_job *j) { j->mount_b[3] = j->mount_a[3] = vec3(-60, 170, 150); }
static void standing_still(wcut_job *j) { j->mount_a[9] = j->mount_a[8], j->mount_b[9] = j->mount_b[8]; }
static void no_contact(wcut_job *j) {
    for (int k = 0; k < j->stations; k++) j->mount_a[k].z = j->mount_b[k].z = 600;
}

static const bad path_jobs[] = {
    {no_width, WCUT_BAD_ARGUMENT, {"block.size_mm[0]", "found 0", "greater than 0"}},
    {endless_block, WCUT_BAD_ARGUMENT, {"block.size_mm[1]", "inf"}},
    {no_height, WCUT_BAD_ARGUMENT, {"block.size_mm[2]", "nan"}},
    {no_diameter, WCUT_BAD_ARGUMENT, {"wire.diameter_mm", "-0.1"}},
    {no_heat, WCUT_BAD_ARGUMENT, {"process.heat_W_per_m"}},
    {no_tension, WCUT_BAD_ARGUMENT, {"process.tension_N"}},
    {no_force, WCUT_BAD_ARGUMENT, {"process.force_law.a_N_per_mm"}},
    {no_decay, WCUT_BAD_ARGUMENT, {"process.force_law.b_m2_per_J"}},
    {no_speed, WCUT_BAD_ARGUMENT, {"limits.speed_max_mm_s"}},
    {negative_speed, WCUT_BAD_ARGUMENT, {"limits.speed_min_mm_s"}},
    {crossed_limits, WCUT_BAD_ARGUMENT, {"limits.speed_min_mm_s", "found 100", "less than"}},
    {two_nodes, WCUT_BAD_ARGUMENT, {"wire.nodes", "found 2", "at least 3"}},
    {one_station, WCUT_BAD_ARGUMENT, {"stations", "found 1", "at least 2"}},
    {no_length, WCUT_BAD_ARGUMENT, {"wire.length_mm"}},
    {nan_mount, WCUT_BAD_ARGUMENT, {"path", "20 finite positions"}},
    {no_mounts, WCUT_BAD_ARGUMENT, {"path", "20 finite positions"}},
    {short_wire, WCUT_DEGENERATE, {"station 12", "620 mm", "20 mm"}},
    {mount_inside, WCUT_DEGENERATE, {"station 5", "mount B", "inside the block"}},
    {mounts_meet, WCUT_DEGENERATE, {"station 3", "one place"}},
    {standing_still, WCUT_DEGENERATE, {"station 9", "moved"}},
    {no_contact, WCUT_DEGENERATE, {"no contact", "z 4"}},
};

static void no_edge(wcut_job *j) { j->edge_b = (wcut_curve_destroy(j->edge_b), NULL); }
static void no_extra(wcut_job *j) { j->extra_count = 0; }
static void falling_u(wcut_job *j) { j->extra_u[1] = 0; }
static void u_above_one(wcut_job *j) { j->extra_u[2] = 1.5; }
static void negative_extra(wcut_job *j) { j->extra_length[1] = -3; }
static void endless_extra(wcut_job *j) { j->extra_length[2] = (double)INFINITY; }
static void negative_clearance(wcut_job *j) { j->clearance = -80; }
static void edges_meet(wcut_job *j) {
    for (int k = 0; k < j->edge_b->control_count; k++) j->edge_b->control[k] = j->edge_a->control[k];
}

static const bad design_jobs[] = {
    {no_edge, WCUT_BAD_ARGUMENT, {"design", "two edge curves"}},
    {no_extra, WCUT_BAD_ARGUMENT, {"design", "extra length"}},
    {falling_u, WCUT_BAD_ARGUMENT, {"design.extra_length_mm[1][0]", "increasing"}},
    {u_above_one, WCUT_BAD_ARGUMENT, {"design.extra_length_mm[2][0]", "1.5"}},
    {negative_extra, WCUT_BAD_ARGUMENT, {"design.extra_length_mm[1][1]", "-3"}},
    {endless_extra, WCUT_BAD_ARGUMENT, {"design.extra_length_mm[2][1]", "inf"}},
    {negative_clearance, WCUT_BAD_ARGUMENT, {"design.clearance_mm", "-80"}},
    {edges_meet, WCUT_DEGENERATE, {"station 0", "one place"}},
};

static void expect_refusal(const bad *b, wcut_job *job) {
    static char somewhere;
    wcut_setup *setup = (void *)&somewhere;
    wcut_error error = {0};
    b->spoil(job);
    const wcut_status status = wcut_setup_create(job, NULL, &setup, &error);
    ck_assert_msg(status == b->status && error.status == status, "%s: %s, expected %s", b->text[0],
                  wcut_status_text(status), wcut_status_text(b->status));
    for (int k = 0; k < 3 && b->text[k]; k++)
        ck_assert_msg(strstr(error.text, b->text[k]) != NULL, "\"%s\", expected \"%s\" in it", error.text, b->text[k]);
    ck_assert(setup == (void *)&somewhere);
    ck_assert_int_eq(wcut_setup_create(job, NULL, &setup, NULL), b->status); /* error may be NULL */
    wcut_job_destroy(job);
}

TEST(a_bad_path_job_is_refused_with_place_and_expectation) {
    for (size_t k = 0; k < sizeof path_jobs / sizeof *path_jobs; k++)
        expect_refusal(&path_jobs[k], straight_job(400, 60, 620, 61, 20, 150, 400));
}

TEST(a_bad_design_is_refused_with_place_and_expectation) {
    for (size_t k = 0; k < sizeof design_jobs / sizeof *design_jobs; k++)
        expect_refusal(&design_jobs[k], sample_job("freeform-1.json"));
}

TEST(bad_options_are_refused) {
    wcut_job *job = straight_job(400, 60, 620, 61, 20, 150, 400);
    for (int k = 0; k < 6; k++) {
        wcut_cut_options o = wcut_cut_options_default();
        if (k == 0) o.integrator = (wcut_integrator)7;
        if (k == 1) o.tolerance = 0;
        if (k == 2) o.tolerance = NAN;
        if (k == 3) o.max_iterations = 0;
        if (k == 4) o.max_halvings = -1;
        if (k == 5) o.max_halvings = 31;
        wcut_setup *setup = NULL;
        wcut_error error = {0};
        ck_assert_int_eq(wcut_setup_create(job, &o, &setup, &error), WCUT_BAD_ARGUMENT);
        ck_assert(strstr(error.text, "options") && !setup);
    }
    wcut_job_destroy(job);
}

TEST(null_arguments_are_refused) {
    wcut_job *job = straight_job(400, 60, 620, 61, 20, 150, 400);
    wcut_setup *setup = NULL;
    wcut_cut *cut = NULL;
    wcut_history *history = NULL;
    ck_assert_int_eq(wcut_setup_create(NULL, NULL, &setup, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_setup_create(job, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cut_create(NULL, &cut, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cut_step(NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_setup_run(NULL, NULL, NULL, &history, NULL), WCUT_BAD_ARGUMENT);
    ck_assert(!setup && !cut && !history);
    setup = setup_of(job, NULL);
    ck_assert_int_eq(wcut_cut_create(setup, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_setup_run(setup, NULL, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    wcut_setup_destroy(setup);
    wcut_setup_destroy(NULL);
    wcut_cut_destroy(NULL);
    wcut_history_destroy(NULL);
    wcut_job_destroy(job);
}

TEST(the_setup_owns_a_copy_of_the_job) {
    wcut_job *job = sample_job("freeform-3.json");
    wcut_setup *setup = setup_of(job, NULL);
    const wcut_job *copy = wcut_setup_job(setup);
    ck_assert(copy != job && copy->edge_a != job->edge_a && copy->name != job->name);
    ck_assert_str_eq(copy->name, job->name);
    ck_assert_double_eq(copy->edge_a->control[3].z, job->edge_a->control[3].z);
    wcut_job_destroy(job);
    ck_assert_double_eq(wcut_setup_job(setup)->clearance, 80);
    wcut_setup_destroy(setup);
}

TEST(after_its_last_station_the_path_is_over) {
    wcut_job *job = straight_job(400, 60, 620, 61, 4, 150, 165);
    wcut_setup *setup = setup_of(job, NULL);
    wcut_cut *cut = NULL;
    ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
    for (int j = 1; j < 4; j++) ck_assert_int_eq(wcut_cut_step(cut, NULL), WCUT_OK);
    wcut_error error = {0};
    ck_assert_int_eq(wcut_cut_step(cut, &error), WCUT_NOT_FOUND);
    ck_assert(strstr(error.text, "station 4") && strstr(error.text, "station 3"));
    wcut_station s;
    wcut_cut_view(cut, &s);
    ck_assert_int_eq(s.index, 3);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

TEST(a_step_without_a_solution_ends_the_run_with_the_station_before_in_view) {
    wcut_job *job = swinging_job(61, 40);
    wcut_cut_options options = wcut_cut_options_default();
    options.max_iterations = 2; /* enough where little changes, too few at the beginning of a swing */
    options.max_halvings = 0;
    wcut_setup *setup = setup_of(job, &options);
    wcut_cut *cut = NULL;
    ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
    wcut_error error = {0};
    wcut_station s;
    wcut_vec3 before[61];
    wcut_status status = WCUT_OK;
    while (status == WCUT_OK) {
        wcut_cut_view(cut, &s);
        memcpy(before, s.position, sizeof before);
        status = wcut_cut_step(cut, &error);
    }
    ck_assert_int_eq(status, WCUT_NOT_CONVERGED);
    const int reached = s.index;
    char place[40];
    snprintf(place, sizeof place, "station %d:", reached + 1);
    ck_assert_msg(strstr(error.text, place) == error.text, "%s", error.text);
    wcut_cut_view(cut, &s);
    ck_assert_int_eq(s.index, reached);
    ck_assert_int_eq(memcmp(before, s.position, sizeof before), 0);
    ck_assert_int_eq(wcut_cut_step(cut, &error), WCUT_NOT_CONVERGED); /* over is over */
    wcut_cut_destroy(cut);

    wcut_history *h = NULL;
    ck_assert_int_eq(wcut_setup_run(setup, NULL, NULL, &h, &error), WCUT_NOT_CONVERGED);
    ck_assert(h->stations == reached + 1 && h->planned == 40);
    ck_assert_int_eq(memcmp(before, nodes_at(h, reached), sizeof before), 0);
    wcut_history_destroy(h);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

static int stop_at_five(int station, int stations, void *context) {
    ck_assert_int_eq(stations, 20);
    *(int *)context = station;
    return station == 5;
}

TEST(stopped_on_request_the_history_holds_every_station_reached) {
    wcut_job *job = straight_job(400, 60, 620, 61, 20, 150, 400);
    wcut_setup *setup = setup_of(job, NULL);
    wcut_history *h = NULL;
    wcut_error error = {0};
    int last = 999;
    ck_assert_int_eq(wcut_setup_run(setup, stop_at_five, &last, &h, &error), WCUT_INTERRUPTED);
    ck_assert(h->stations == 5 && h->planned == 20 && last == 5 && strstr(error.text, "20"));
    wcut_history_destroy(h);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

TEST(names_of_phases_and_conditions_are_those_of_the_files) {
    const char *const phase[] = {"approach", "entry", "steady", "exit", "left"};
    const char *const condition[] = {"tension", "speed_max", "speed_min", "time"};
    for (int k = 0; k < 5; k++) ck_assert_str_eq(wcut_phase_name((wcut_phase)k), phase[k]);
    for (int k = 0; k < 4; k++) ck_assert_str_eq(wcut_condition_name((wcut_condition)k), condition[k]);
    ck_assert_str_eq(wcut_phase_name((wcut_phase)17), "unknown");
    ck_assert_str_eq(wcut_condition_name((wcut_condition)17), "unknown");
}

/* what a program may hand over that no file can say */
TEST(a_job_with_counts_but_no_arrays_or_with_an_impossible_mode_is_refused) {
    for (int mode = 0; mode < 2; mode++)
        for (int k = 0; k < 12; k++) {
            wcut_job *job = mode ? sample_job("freeform-1.json") : straight_job(400, 60, 620, 61, 20, 150, 400);
            if (k == 0) job->mode = (wcut_mode)7;
            if (k == 1) job->mode = (wcut_mode)-1;
            if (k == 2) job->effect_count = 3;
            if (k == 3) job->effect_count = -1;
            if (k == 4) job->dither_count = 2;
            if (k == 5) job->dither_count = -2;
            if (k == 6) job->heat_step_count = 1;
            if (k == 7) job->heat_step_count = INT_MAX;
            if (k == 8) job->nodes = INT_MAX;
            if (k == 9) job->stations = INT_MAX;
            if (k == 10) job->stations = -5;
            double *extra = job->extra_u;
            if (k == 11) job->extra_count = 4, job->extra_u = NULL;
            wcut_setup *setup = NULL;
            wcut_error error = {0};
            ck_assert_int_eq(wcut_setup_create(job, NULL, &setup, &error), WCUT_BAD_ARGUMENT);
            ck_assert_msg(!setup && strstr(error.text, "expected"), "%d: %s", k, error.text);

            /* nor does anything else run over what is not there */
            ck_assert(isfinite(wcut_job_heat_eval(job, 1)));
            ck_assert(isfinite(wcut_job_pace_eval(job, 1)));
            if (k != 9) wcut_job_resample(job, 30); /* what a count promises must be there */
            job->effect_count = job->dither_count = job->heat_step_count = 0;
            job->extra_u = extra;
            wcut_job_destroy(job);
        }
}

TEST(functions_of_a_cut_refuse_null) {
    double length = 999;
    wcut_vec3 at = {0, 0, 0};
    wcut_job *job = NULL;
    wcut_summary summary;
    wcut_history empty = {.stations = 2, .nodes = 5};
    ck_assert_int_eq(wcut_setup_path_job(NULL, &job), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_job_create(NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_job_resample(NULL, 5), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cut_drive(NULL, at, at, 1, 60, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_path(NULL, &empty, &at, &at, &length, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_summary_eval(NULL, &summary), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_summary_eval(&empty, &summary), WCUT_BAD_ARGUMENT);
    wcut_job_destroy(NULL);
    wcut_cut_view(NULL, NULL);
    ck_assert_ptr_null(wcut_setup_job(NULL));
    ck_assert_ptr_null(wcut_setup_options(NULL));
    ck_assert_int_eq(wcut_setup_stations(NULL).stations, 0);
    ck_assert_str_eq(wcut_phase_name((wcut_phase)99), "unknown");
    ck_assert_str_eq(wcut_condition_name((wcut_condition)-1), "unknown");
}
