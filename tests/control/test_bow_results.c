/* What users of a bow ask of a cut: force on the tool, departure from the ruled surface, the feed chart.
   labels: unit oracle */
#include <wirecut/bow.h>

#include "cut/cuts.h"

static wcut_job *job;
static wcut_setup *setup;
static wcut_history *history;
static wcut_bow_results *results;

/* mounts 60 mm beside a block of 300 mm, a 0.4 mm NiCr wire of 40 N on a frame of 8 N/mm */
static void given_a_bow(int stations, double feed) {
    job = straight_job(300, 60, 0, 61, stations, -10, 500);
    job->wire_diameter = 0.4;
    job->wire_material = wcut_copy_text("NiCr 80/20");
    job->heat = 90;
    job->kerf_width = 0.5, job->kerf_per_q = 1e-4;
    job->rig =
        (wcut_rig){.kind = WCUT_RIG_KIND_BOW, .pretension = 40, .stiffness = 8, .wire_stiffness = 0, .expansion = -1};
    job->feed = (wcut_feed){WCUT_FEED_KIND_CONSTANT, 1, wcut_copy(&feed, 1, sizeof feed), NULL};
}

static void run_bow(void) {
    wcut_error error = {0};
    setup = setup_of(job, NULL);
    ck_assert_msg(wcut_setup_run(setup, NULL, NULL, &history, &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_bow_results_create(setup, history, NULL, &results, &error) == WCUT_OK, "%s", error.text);
}

static void forget_bow(void) {
    wcut_bow_results_destroy(results);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
    results = NULL, history = NULL, setup = NULL, job = NULL;
}
FIXTURE(NULL, forget_bow);

TEST(a_cut_at_a_feed_of_the_chart_bows_by_what_the_chart_says) {
    for (int b = 0; b < WCUT_FEED_CHART_BOWS; b++) {
        given_a_bow(120, 10);
        run_bow();
        const wcut_feed_chart_row row = results->chart[5];
        ck_assert_double_eq_tol(row.heat, 90, 1e-12);
        ck_assert_double_eq_tol(row.kerf[b], 0.5 + 1e-4 * 90e3 / row.feed[b], 1e-12);
        forget_bow();

        /* the run is of polygons and of loads by the turn of each edge: it agrees to a percent of the bow */
        given_a_bow(160, row.feed[b]);
        run_bow();
        const double bow = wcut_feed_chart_bows()[b];
        ck_assert_double_eq_tol(results->row[159].bow, bow, 0.01 * bow);
        ck_assert_double_eq_tol(results->row[159].tension, row.tension[b], 0.002 * row.tension[b]);
        forget_bow();
    }
}

TEST(limits_of_temperature_and_strength_take_feeds_out_of_the_chart) {
    given_a_bow(60, 10);
    run_bow();
    int hot = 0, weak = 0;
    for (int k = 0; k < WCUT_FEED_CHART_HEATS; k++) {
        const wcut_feed_chart_row *r = &results->chart[k];
        if (k > 0) ck_assert(r->feed[0] > r[-1].feed[0] && r->temperature > r[-1].temperature);
        for (int b = 0; b < WCUT_FEED_CHART_BOWS; b++) {
            ck_assert(b == 0 || r->feed[b] > r->feed[b - 1]);
            ck_assert_double_le(r->allowed[b], r->feed[b]);
            ck_assert(!(r->too_hot || r->tension[b] > r->strength) == (r->allowed[b] == r->feed[b]));
            weak += r->allowed[b] < r->feed[b];
        }
    }
    ck_assert_int_gt(weak, 0);
    wcut_bow_results_destroy(results);

    /* a lower limit of the temperature */
    wcut_robot_limits l = wcut_robot_limits_default(job);
    l.temperature = 500;
    ck_assert_int_eq(wcut_bow_results_create(setup, history, &l, &results, NULL), WCUT_OK);
    for (int k = 0; k < WCUT_FEED_CHART_HEATS; k++)
        hot += results->chart[k].too_hot && results->chart[k].allowed[2] == 0;
    ck_assert(hot > 0 && hot < WCUT_FEED_CHART_HEATS);
}

/* turned about the line y = 0, z = 100 + R at an even rate, the straight line sweeps a cylinder: the departure is the node's
   distance from its axis less R */
TEST(on_a_turning_tool_the_face_departs_from_the_cylinder_by_the_radius_of_its_nodes) {
    enum { M = 201 };
    const double radius = 60;
    given_a_bow(M, 24);
    wcut_free(job->mount_a);
    wcut_free(job->mount_b);
    job->mount_a = job->mount_b = NULL;
    job->tool = wcut_alloc(M, sizeof *job->tool);
    for (int j = 0; j < M; j++) {
        const double turn = 0.9 * WCUT_PI * j / (M - 1), half = (turn - WCUT_PI / 2) / 2;
        job->tool[j] = (wcut_pose){{150, 100, 160}, {cos(half), sin(half), 0, 0}};
    }
    job->mount_a_in_tool = vec3(-210, 0, -radius);
    job->mount_b_in_tool = vec3(210, 0, -radius);
    job->block_size.z = 300;
    ck_assert_int_eq(wcut_job_place_mounts(job, NULL), WCUT_OK);
    run_bow();

    /* every node in the foam once the bow is steady; strips between stations are chords of the circle */
    const double arrow = radius * (1 - cos(0.45 * WCUT_PI / (M - 1)));
    int compared = 0;
    for (int j = 60; j < M; j++)
        for (int i = 0; i < 61; i++) {
            const double d = results->departure[j * 61 + i];
            const wcut_vec3 x = history->position[j * 61 + i];
            if (isnan(d)) continue;
            ck_assert_double_eq_tol(fabs(d), fabs(hypot(x.y - 100, x.z - 160) - radius), 1.1 * arrow);
            compared++;
        }
    ck_assert_int_gt(compared, 1000);
    ck_assert_double_gt(fabs(results->departure_max.value), 10 * arrow);

    /* in the tool's frame the foam pulls back against the feed, +y of the tool being its way forward */
    ck_assert_double_gt(fabs(results->row[M - 1].force.y), 10 * fabs(results->row[M - 1].force.z));
    ck_assert_double_lt(fabs(results->row[M - 1].force.x), 1e-6);
}

TEST(the_force_on_the_tool_is_the_law_times_the_engaged_length_while_the_bow_is_flat) {
    given_a_bow(160, 8);
    run_bow();
    const double force = wcut_force_law_eval(&job->force_law, 90, 8) * 300;
    ck_assert_double_eq_tol(-results->row[159].force.y, force, 1e-3 * force);
    ck_assert_double_lt(fabs(results->row[159].moment.z), 1e-6);
    ck_assert_double_eq_tol(results->row[159].moment.x, 0, 1e-9);
    ck_assert_double_eq_tol(results->force_max, force, 0.1 * force);
    ck_assert(results->slack_share == 0 && results->tension_max < results->strength);
}

TEST(only_a_bow_has_results_of_a_bow) {
    wcut_error error = {0};
    job = straight_job(300, 60, 470, 21, 30, -10, 300);
    setup = setup_of(job, NULL);
    ck_assert_int_eq(wcut_setup_run(setup, NULL, NULL, &history, &error), WCUT_OK);
    ck_assert_int_eq(wcut_bow_results_create(setup, history, NULL, &results, &error), WCUT_BAD_ARGUMENT);
    ck_assert_msg(strstr(error.text, "found the rig two_arms, expected a bow") != NULL, "%s", error.text);
    ck_assert_ptr_null(results);
    ck_assert_int_eq(wcut_bow_results_create(NULL, history, NULL, &results, NULL), WCUT_BAD_ARGUMENT);
}
