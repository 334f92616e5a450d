/* What holds a wire and how it is fed: poses, feeds, copies, other numbers of stations, and what a rig refuses. */
#include "cut/job_rig.h"
#include "cut/setup.h"
#include "cuts.h"

static wcut_job *job;
static wcut_error error;

static void forget(void) {
    wcut_job_destroy(job);
    job = NULL;
}
FIXTURE(NULL, forget);

/* three poses: along y, the last one turned by 90 deg about x */
static void given_a_tool(void) {
    static const wcut_pose pose[] = {{{0, 0, 100}, {1, 0, 0, 0}},
                                     {{0, 40, 100}, {-1, 0, 0, 0}},
                                     {{0, 80, 100}, {0.70710678118654757, 0.70710678118654757, 0, 0}}};
    static const double speed[] = {9, 10, 20};
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->stations = 3;
    job->tool = wcut_copy(pose, 3, sizeof *pose);
    job->mount_a_in_tool = vec3(-50, 0, 10);
    job->mount_b_in_tool = vec3(450, 0, 10);
    job->rig =
        (wcut_rig){.kind = WCUT_RIG_KIND_BOW, .pretension = 30, .stiffness = 8, .wire_stiffness = 0, .expansion = -1};
    job->feed = (wcut_feed){WCUT_FEED_KIND_STATIONS, 3, wcut_copy(speed, 3, sizeof *speed), NULL};
    ck_assert_msg(wcut_job_place_mounts(job, &error) == WCUT_OK, "%s", error.text);
}

TEST(a_pose_turns_a_point_as_its_quaternion_says) {
    const double h = sqrt(0.5);
    const wcut_pose about_z = {{1, 2, 3}, {h, 0, 0, h}}, doubled = {{1, 2, 3}, {2 * h, 0, 0, 2 * h}};
    const wcut_vec3 p = wcut_pose_point(&about_z, vec3(1, 0, 0)), q = wcut_pose_point(&doubled, vec3(0, 1, 5));
    ck_assert(vec3_distance(p, vec3(1, 3, 3)) < 1e-15);
    ck_assert(vec3_distance(q, vec3(0, 2, 8)) < 1e-15);
}

TEST(mounts_follow_from_the_poses_of_the_tool) {
    given_a_tool();
    ck_assert(job->tool[1].turn[0] == 1);
    ck_assert(vec3_distance(job->mount_a[1], vec3(-50, 40, 110)) < 1e-13);
    ck_assert(vec3_distance(job->mount_b[2], vec3(450, 70, 100)) < 1e-13);

    /* a quaternion that is no rotation leaves the job as it was */
    const wcut_vec3 *before = job->mount_a;
    job->tool[2].turn[0] = 1;
    ck_assert_int_eq(wcut_job_place_mounts(job, &error), WCUT_BAD_ARGUMENT);
    ck_assert_msg(strstr(error.text, "path.tool[2]: found the quaternion") != NULL, "%s", error.text);
    ck_assert_ptr_eq(job->mount_a, before);
    ck_assert_int_eq(wcut_job_place_mounts(NULL, NULL), WCUT_BAD_ARGUMENT);
}

TEST(another_number_of_stations_turns_the_tool_evenly_and_keeps_the_speeds) {
    given_a_tool();
    ck_assert_int_eq(wcut_job_resample(job, 9), WCUT_OK);
    for (int j = 0; j < 9; j++) {
        const wcut_vec3 a = wcut_pose_point(&job->tool[j], job->mount_a_in_tool);
        ck_assert(vec3_distance(a, job->mount_a[j]) < 1e-12);
        ck_assert_double_eq_tol(vec3_distance(job->mount_a[j], job->mount_b[j]), 500, 1e-11);
        if (j > 0) ck_assert(job->feed.speed[j] == 10 || job->feed.speed[j] == 20);
    }
    ck_assert(job->feed.count == 9 && job->feed.speed[1] == 10 && job->feed.speed[8] == 20);

    /* between two poses the turn is even: half way of 90 deg is 45 deg */
    const wcut_pose from = {{0, 0, 0}, {1, 0, 0, 0}}, to = {{2, 0, 0}, {-sqrt(0.5), -sqrt(0.5), 0, 0}};
    const wcut_pose half = wcut_pose_mix(&from, &to, 0.5);
    ck_assert_double_eq_tol(half.turn[0], cos(WCUT_PI / 8), 1e-15);
    ck_assert_double_eq_tol(half.turn[1], sin(WCUT_PI / 8), 1e-15);
}

TEST(a_copy_and_a_reversed_path_keep_tool_and_feed) {
    given_a_tool();
    wcut_job *copy = wcut_job_copy(job);
    ck_assert(copy && copy->tool != job->tool && copy->feed.speed != job->feed.speed);
    wcut_job_reverse(copy);
    ck_assert(vec3_distance(copy->tool[0].at, job->tool[2].at) == 0);
    ck_assert(copy->feed.speed[1] == job->feed.speed[2] && copy->feed.speed[2] == job->feed.speed[1]);
    wcut_job_destroy(copy);
}

/* the time over a ramp against the integral: from 10 to 30 mm/s in 2 s the way is 40 mm; before and behind it is even */
TEST(the_time_of_a_way_is_that_of_the_profile) {
    double time[] = {1, 3}, speed[] = {10, 30}, t = 999;
    const wcut_feed f = {WCUT_FEED_KIND_TIME, 2, speed, time};
    ck_assert_int_eq(wcut_feed_eval(&f, 1, 0, 10 + 40 + 15, &t), WCUT_OK);
    ck_assert_double_eq_tol(t, 3.5, 1e-14);
    ck_assert_int_eq(wcut_feed_eval(&f, 1, 1, 40, &t), WCUT_OK);
    ck_assert_double_eq_tol(t, 2, 1e-14);
    ck_assert_int_eq(wcut_feed_eval(&f, 7, 2, 11.25, &t), WCUT_OK); /* 20 t + 5 t^2 at 0.5 s */
    ck_assert_double_eq_tol(t, 0.5, 1e-14);
    ck_assert_int_eq(wcut_feed_eval(&f, 1, 9, 30, &t), WCUT_OK);
    ck_assert_double_eq_tol(t, 1, 1e-14);

    /* parts of a way take as long as the whole */
    double first, second;
    ck_assert_int_eq(wcut_feed_eval(&f, 1, 0.5, 7, &first), WCUT_OK);
    ck_assert_int_eq(wcut_feed_eval(&f, 1, 0.5 + first, 30, &second), WCUT_OK);
    ck_assert_int_eq(wcut_feed_eval(&f, 1, 0.5, 37, &t), WCUT_OK);
    ck_assert_double_eq_tol(first + second, t, 1e-13);
}

TEST(a_feed_of_stations_is_that_of_the_step_that_leads_there) {
    double speed[] = {1, 5, 8}, t = 999;
    const wcut_feed f = {WCUT_FEED_KIND_STATIONS, 3, speed, NULL}, none = {0};
    ck_assert(wcut_feed_eval(&f, 2, 4, 16, &t) == WCUT_OK && t == 2);
    t = 999;
    ck_assert_int_eq(wcut_feed_eval(&f, 3, 0, 16, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_feed_eval(&f, 0, 0, 16, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_feed_eval(&none, 1, 0, 16, &t), WCUT_BAD_ARGUMENT);
    ck_assert(t == 999);
}

TEST(a_material_is_known_by_a_part_of_its_name) {
    ck_assert_ptr_eq(wcut_wire_material_view("Kanthal A-1"), wcut_wire_material_view("KANTHAL"));
    ck_assert(wcut_wire_material_view("NiCr 80/20")->hot_strength == 100);
    ck_assert(wcut_wire_material_view("resistance wire (nichrome)")->modulus == 220e3);
    ck_assert(!wcut_wire_material_view("string") && !wcut_wire_material_view(NULL) && !wcut_wire_material_view(""));
}

static void refused(const char *line) {
    ck_assert_int_eq(wcut_rig_check(job, &error), WCUT_BAD_ARGUMENT);
    ck_assert_msg(strstr(error.text, line) != NULL, "%s\n  expected: %s", error.text, line);
}

TEST(a_pretension_above_the_strength_of_the_wire_is_refused_with_the_number) {
    given_a_tool();
    job->wire_diameter = 0.15;
    job->wire_material = wcut_copy_text("Kanthal A");
    refused("rig.pretension_N: found 30, expected at most 12.81 N: the strength of kanthal, 725 MPa at 20 degC");
    job->rig.pretension = 12;
    ck_assert_int_eq(wcut_rig_check(job, &error), WCUT_OK);
}

TEST(a_bow_needs_a_feed_and_what_its_material_does_not_say) {
    given_a_tool();
    job->wire_diameter = 0.4;
    refused("rig.wire_stiffness_N: found none and a wire of no material");
    job->rig.wire_stiffness = 27000;
    refused("rig.expansion_per_K: found none");
    job->rig.expansion = 0;
    ck_assert_int_eq(wcut_rig_check(job, &error), WCUT_OK);
    job->feed.speed[2] = 101;
    refused("feed: speed 2: found 101 mm/s, expected the limits' 0.1 to 100 mm/s");
    job->feed.kind = WCUT_FEED_KIND_NONE;
    refused("feed: found none, expected a commanded speed: a bow has no other");
    job->rig.kind = WCUT_RIG_KIND_TWO_ARMS;
    refused("path.tool: found one tool with the rig two_arms");
    job->rig.kind = (wcut_rig_kind)7;
    refused("rig.kind: found 7");
}
