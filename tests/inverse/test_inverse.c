/* From a target to a cut: what comes back of a hidden design, what cannot be reached, and that nothing depends on threads.
   labels: unit plain */
#include <string.h>

#include "cut/setup.h"
#include "inverse/feet.h"
#include "inverse/given.h"
#include "inverse/scan.h"

static wcut_design *fit(const wcut_design_target *target, const wcut_design_options *o) {
    wcut_job *job = given_process(61, 31);
    wcut_design *design = NULL;
    wcut_error error = {0};
    const wcut_status status = wcut_design_fit(target, job, o, NULL, NULL, &design, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    wcut_job_destroy(job);
    return design;
}

TEST(a_point_over_a_cylinder_of_wires_has_its_foot_and_its_height) {
    enum { M = 21, N = 21 };
    static wcut_vec3 x[M * N];
    for (int j = 0; j < M; j++)
        for (int i = 0; i < N; i++) {
            const double angle = 0.05 * i - 0.5;
            x[j * N + i] = vec3(200 + 300 * sin(angle), 10.0 * j, 300 * cos(angle));
        }
    const wcut_wire_face face = {M, N, x};
    wcut_wire_foot foot;
    for (int k = 0; k < 5; k++) {
        const double angle = 0.17 * k - 0.4, over = 3.0 * k - 6;
        const wcut_vec3 p = {200 + (300 + over) * sin(angle), 33 + 20 * k, (300 + over) * cos(angle)};
        wcut_wire_feet(&face, 1, &p, false, 1, &foot);
        ck_assert_double_eq_tol(fabs(foot.height), fabs(over), 1e-4);
        ck_assert_double_eq_tol(foot.station, (33 + 20 * k) / 10.0, 1e-6);
        ck_assert_double_eq(foot.beside, 0);
    }

    /* beyond a border it says so */
    const wcut_vec3 off = {200, 230, 300};
    wcut_wire_feet(&face, 1, &off, false, 1, &foot);
    ck_assert_double_eq_tol(foot.beside, 30, 1e-6);
}

TEST(the_scan_finds_that_a_saddle_can_be_followed_and_a_dome_cannot) {
    wcut_design_target *target[2] = {given_target(saddle), given_target(dome)};
    wcut_scan scan[2] = {{0}, {0}};
    for (int k = 0; k < 2; k++) ck_assert_int_eq(wcut_scan_create(target[k], true, 1.05, &scan[k]), WCUT_OK);
    ck_assert_double_lt(scan[0].rms, 0.3);
    ck_assert_double_gt(scan[1].rms, 2);
    for (int k = 0; k < 2; k++) {
        wcut_scan_clear(&scan[k]);
        wcut_design_target_destroy(target[k]);
    }
}

TEST(the_map_of_a_dome_names_its_curvature) {
    wcut_design_target *target = given_target(dome);
    wcut_job *job = given_process(61, 31);
    wcut_design_map *map = NULL;
    ck_assert_int_eq(wcut_design_map_create(target, job, NULL, &map, NULL), WCUT_OK);
    ck_assert_double_gt(map->domed_share, 0.99);
    ck_assert_double_gt(map->share[WCUT_DESIGN_REASON_DOMED], 0.5);
    for (int k = 0; k < map->rows * map->columns; k++) ck_assert_double_eq_tol(map->gauss[k], 1.6e-7, 1e-7);
    wcut_design_map_destroy(map);

    /* and of a saddle has nothing to say but small bows */
    wcut_design_target *other = given_target(saddle);
    ck_assert_int_eq(wcut_design_map_create(other, job, NULL, &map, NULL), WCUT_OK);
    ck_assert_double_eq(map->domed_share, 0);
    ck_assert_double_lt(map->predicted_rms, 0.3);
    wcut_design_map_destroy(map);
    wcut_design_target_destroy(other);
    wcut_design_target_destroy(target);
    wcut_job_destroy(job);
}

TEST(a_saddle_is_cut_to_a_tenth_of_a_millimetre_whatever_the_threads) {
    wcut_design_target *target = given_target(saddle);
    wcut_design_options o = wcut_design_options_default();
    o.feed = WCUT_DESIGN_FEED_PLUS_Y;
    wcut_design *one = fit(target, &o);
    ck_assert_msg(one->rms < 0.1, "%g mm rms", one->rms);
    ck_assert_int_eq(one->uncovered, 0);
    ck_assert_int_gt(one->points, 1000);
    ck_assert_int_eq(one->job->mode, WCUT_MODE_DESIGN);

    /* three threads, the same numbers */
    o.threads = 3;
    wcut_design *three = fit(target, &o);
    ck_assert_double_eq(one->rms, three->rms);
    ck_assert_int_eq(memcmp(one->extra, three->extra, (size_t)one->stations * sizeof *one->extra), 0);

    /* the design's job runs, from edge to edge */
    wcut_setup *setup = NULL;
    wcut_history *history = NULL;
    wcut_error error = {0};
    ck_assert_msg(wcut_setup_create(one->job, NULL, &setup, &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_setup_run(setup, NULL, NULL, &history, &error) == WCUT_OK, "%s", error.text);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    wcut_design_destroy(one);
    wcut_design_destroy(three);
    wcut_design_target_destroy(target);
}

/* ---- a hidden design ---- */

/* a job of design mode with edges that rise and fall, an end that leads and a wire that gets longer and shorter */
static wcut_job *hidden_job(void) {
    enum { POINTS = 7 };
    wcut_job *job = given_process(61, 31);
    wcut_vec3 a[POINTS], b[POINTS];
    for (int k = 0; k < POINTS; k++) {
        const double t = (double)k / (POINTS - 1), y = -100 + 820 * t, lag = 30 * sin(2 * t);
        a[k] = vec3(0, y + lag, 150 + 20 * sin(4 * t));
        b[k] = vec3(400, y - lag, 140 + 25 * sin(3 * t + 1));
    }
    job->mode = WCUT_MODE_DESIGN;
    ck_assert_int_eq(wcut_curve_interpolate(POINTS, a, &job->edge_a), WCUT_OK);
    ck_assert_int_eq(wcut_curve_interpolate(POINTS, b, &job->edge_b), WCUT_OK);
    job->overrun = job->block_size.x; /* the edges go on behind the block */
    job->extra_count = 3;
    job->extra_u = wcut_alloc(3, sizeof(double)), job->extra_length = wcut_alloc(3, sizeof(double));
    const double u[3] = {0, 0.5, 1}, extra[3] = {15, 30, 18};
    memcpy(job->extra_u, u, sizeof u);
    memcpy(job->extra_length, extra, sizeof extra);
    return job;
}

TEST(a_hidden_design_comes_back_from_its_surface) {
    wcut_job *job = hidden_job();
    const wcut_cut_options cut = wcut_cut_options_default();
    wcut_setup *plan = NULL;
    wcut_history *history = NULL;
    wcut_error error = {0};
    ck_assert_msg(wcut_plan_create(job, &cut, &plan, &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_setup_run(plan, NULL, NULL, &history, &error) == WCUT_OK, "%s", error.text);
    wcut_surface *surface = NULL;
    ck_assert_int_eq(
        wcut_surface_loft(history->stations, history->nodes, history->position, 1e-3, &surface, NULL, NULL), WCUT_OK);
    wcut_design_target *target = NULL;
    ck_assert_msg(wcut_design_target_from_surface(surface, given_block, &target, &error) == WCUT_OK, "%s", error.text);
    wcut_design_options o = wcut_design_options_default();
    o.tolerance = 1e-3;
    o.feed = WCUT_DESIGN_FEED_PLUS_Y;
    wcut_design *found = fit(target, &o);
    ck_assert_msg(found->rms < 0.02, "%g mm rms", found->rms);
    wcut_design_destroy(found);
    wcut_design_target_destroy(target);
    wcut_surface_destroy(surface);
    wcut_history_destroy(history);
    wcut_setup_destroy(plan);
    wcut_job_destroy(job);
}

static int stop_at_once(const wcut_design_round *round, void *context) {
    (void)round, (void)context;
    return 1;
}

TEST(a_search_that_is_stopped_hands_out_what_it_has) {
    wcut_design_target *target = given_target(saddle);
    wcut_job *job = given_process(61, 31);
    wcut_design *design = NULL;
    ck_assert_int_eq(wcut_design_fit(target, job, NULL, stop_at_once, NULL, &design, NULL), WCUT_INTERRUPTED);
    ck_assert_ptr_nonnull(design);
    ck_assert_int_le(design->rounds, 2);
    ck_assert_ptr_nonnull(design->path);
    wcut_design_destroy(design);
    wcut_job_destroy(job);
    wcut_design_target_destroy(target);
}

TEST(a_map_and_the_first_steps_of_a_design_without_memory_leave_nothing) {
    wcut_design_target *target = given_target(saddle);
    wcut_job *job = given_process(61, 31);
    wcut_design_map *map = NULL;
    wcut_design_options o = wcut_design_options_default();
    o.feed = WCUT_DESIGN_FEED_PLUS_Y;
    EACH_FAILED_ALLOCATION(wcut_design_map_create(target, job, &o, &map, NULL), map == NULL);
    wcut_design_map_destroy(map);
    wcut_design *design = NULL;
    FIRST_FAILED_ALLOCATIONS(60, wcut_design_fit(target, job, &o, NULL, NULL, &design, NULL), design == NULL);
    wcut_job_destroy(job);
    wcut_design_target_destroy(target);
}

/* ---- panels ---- */

/* a dome that is cut by straight wires along y: less of it is left the narrower the panels are */
TEST(a_dome_in_four_panels_across_is_nearer_than_one_cut_and_its_joints_are_stated) {
    wcut_design_target *target = given_target(dome);
    wcut_job *job = given_process(41, 21);
    wcut_design_options o = wcut_design_options_default();
    wcut_design_panels *panels = NULL;
    wcut_error error = {0};
    o.feed = WCUT_DESIGN_FEED_PLUS_Y;
    o.unknowns_max = 8;
    ck_assert_msg(wcut_design_panels_fit(target, job, &o, 4, 0.01, NULL, NULL, &panels, &error) == WCUT_OK, "%s",
                  error.text);

    /* one cut of the dome leaves 5 mm: four hold no hundredth either, but come much nearer */
    ck_assert_int_eq(panels->count, 4);
    ck_assert_int_eq(panels->across * panels->along, 4);
    ck_assert_double_lt(panels->rms, 1);
    ck_assert_double_gt(panels->max, panels->rms);
    ck_assert_int_ge(panels->joints, 3);
    for (int k = 0; k < panels->joints; k++) {
        const wcut_design_joint *joint = &panels->joint[k];
        ck_assert_int_gt(joint->places, 20);
        ck_assert_double_le(joint->step_rms, joint->step_max);
        ck_assert_double_lt(joint->step_max, 5);
        ck_assert_double_lt(joint->angle_max, 0.3);
    }
    wcut_design_panels_destroy(panels);
    wcut_job_destroy(job);
    wcut_design_target_destroy(target);
}

TEST(a_target_that_one_cut_holds_is_one_panel) {
    wcut_design_target *target = given_target(saddle);
    wcut_job *job = given_process(41, 21);
    wcut_design_options o = wcut_design_options_default();
    wcut_design_panels *panels = NULL;
    o.feed = WCUT_DESIGN_FEED_PLUS_Y;
    o.unknowns_max = 8;
    ck_assert_int_eq(wcut_design_panels_fit(target, job, &o, 3, 2, NULL, NULL, &panels, NULL), WCUT_OK);
    ck_assert_int_eq(panels->count, 1);
    ck_assert_int_eq(panels->joints, 0);
    ck_assert_double_le(panels->rms, 2);
    wcut_design_panels_destroy(panels);
    panels = NULL;
    FIRST_FAILED_ALLOCATIONS(20, wcut_design_panels_fit(target, job, &o, 3, 2, NULL, NULL, &panels, NULL),
                             panels == NULL);
    wcut_job_destroy(job);
    wcut_design_target_destroy(target);
}
