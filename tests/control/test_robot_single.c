/* The motion of the one robot that holds a bow: its tool goes where the job's poses have it. labels: unit property */
#include <wirecut/robot.h>

#include "cut/cuts.h"
#include "cut/job_rig.h"

static wcut_job *job;
static wcut_history history;
static wcut_history_row row[41];
static wcut_robot_motion *motion;
static wcut_error error;

/* a tool that goes along y and turns about z, the mounts 260 mm beside its origin; a second a station */
static void given_a_tool(void) {
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->stations = 41;
    job->tool = wcut_alloc(41, sizeof *job->tool);
    for (int j = 0; j < 41; j++) {
        const double half = 0.15 * sin(0.1 * j);
        job->tool[j] = (wcut_pose){{200, 6.0 * j, 60 + 4 * sin(0.2 * j)}, {cos(half), 0, 0, sin(half)}};
    }
    job->mount_a_in_tool = vec3(-260, 0, 0);
    job->mount_b_in_tool = vec3(260, 0, 0);
    ck_assert_int_eq(wcut_job_place_mounts(job, &error), WCUT_OK);

    /* a history of its times and speeds alone */
    memset(row, 0, sizeof row);
    for (int j = 1; j < 41; j++) {
        row[j].time = j, row[j].duration = 1;
        row[j].speed_a = vec3_distance(job->mount_a[j - 1], job->mount_a[j]);
        row[j].speed_b = vec3_distance(job->mount_b[j - 1], job->mount_b[j]);
    }
    history = (wcut_history){.stations = 41, .planned = 41, .nodes = 3, .row = row};
}

static void make(double lead) {
    wcut_robot_options o = wcut_robot_options_default();
    o.tool = job;
    o.lead_in = o.lead_out = lead;
    ck_assert_msg(wcut_robot_motion_create(&history, job->mount_a, job->mount_b, &o, &motion, &error) == WCUT_OK, "%s",
                  error.text);
}

static void forget(void) {
    wcut_robot_motion_destroy(motion);
    wcut_job_destroy(job);
    motion = NULL, job = NULL;
}
FIXTURE(given_a_tool, forget);

TEST(every_target_is_the_pose_of_its_station) {
    make(0);
    ck_assert(motion->single && motion->count > 5 && motion->count <= 41);
    for (int i = 0; i < motion->count; i++) {
        const wcut_robot_target *t = &motion->target[i];
        const wcut_pose pose = {t->a, {t->frame_a[0], t->frame_a[1], t->frame_a[2], t->frame_a[3]}};
        const wcut_vec3 a = wcut_pose_point(&pose, job->mount_a_in_tool),
                        b = wcut_pose_point(&pose, job->mount_b_in_tool);
        ck_assert(vec3_distance(a, job->mount_a[t->station]) < 1e-10);
        ck_assert(vec3_distance(b, job->mount_b[t->station]) < 1e-10);
        ck_assert_double_eq_tol(t->time, t->station, 1e-12);
        ck_assert_double_ge(t->frame_a[0], 0);

        /* the speed is that of the tool's origin, which keeps the time of the move */
        if (i > 0) ck_assert_double_eq_tol(t->speed_a * t->duration, vec3_distance(t[-1].a, t->a), 1e-10);
    }
    ck_assert(motion->target[0].zone_a == 0 && motion->target[motion->count - 1].zone_a == 0);
}

TEST(a_lead_moves_the_tool_as_it_is) {
    make(15);
    const wcut_robot_target *in = &motion->target[0], *first = in + 1, *out = &motion->target[motion->count - 1];
    ck_assert(in->station == -1 && out->station == -2);
    ck_assert_double_eq_tol(vec3_distance(in->a, first->a), 15, 1e-9);
    ck_assert_double_eq_tol(vec3_distance(out->a, out[-1].a), 15, 1e-9);
    for (int k = 0; k < 4; k++) ck_assert(in->frame_a[k] == first->frame_a[k] && out->frame_a[k] == out[-1].frame_a[k]);
}

TEST(without_poses_the_tool_is_half_way_between_the_mounts_with_x_along_the_wire) {
    wcut_free(job->tool);
    job->tool = NULL;
    for (int j = 0; j < 41; j++) {
        const wcut_pose p = wcut_job_pose(job, j);
        ck_assert(vec3_distance(wcut_pose_point(&p, vec3(-260, 0, 0)), job->mount_a[j]) < 1e-10);
        ck_assert(vec3_distance(wcut_pose_point(&p, vec3(260, 0, 0)), job->mount_b[j]) < 1e-10);
    }
    make(0);
    ck_assert(motion->single && vec3_distance(motion->target[0].a, vec3(200, 0, 60)) < 1e-10);
}

TEST(between_stations_the_heater_s_target_has_the_tool_between_both_poses) {
    static wcut_heat_step step = {10.5, 12.25, 0.8};
    job->heat = 60;
    job->heat_step = wcut_copy(&step, 1, sizeof step);
    job->heat_step_count = 1;
    wcut_robot_options o = wcut_robot_options_default();
    o.tool = o.heater = job;
    ck_assert_int_eq(wcut_robot_motion_create(&history, job->mount_a, job->mount_b, &o, &motion, &error), WCUT_OK);
    int found = 0;
    for (int i = 0; i < motion->count; i++) {
        const wcut_robot_target *t = &motion->target[i];
        if (t->station != -3) continue;
        const int j = (int)t->time;
        const wcut_pose p = wcut_pose_mix(&job->tool[j], &job->tool[j + 1], t->time - j);
        ck_assert_double_lt(vec3_distance(t->a, p.at), 1e-9);
        for (int k = 0; k < 4; k++) ck_assert_double_eq_tol(t->frame_a[k], p.turn[k], 1e-12);
        found++;
    }
    ck_assert_int_eq(found, 2);
}
