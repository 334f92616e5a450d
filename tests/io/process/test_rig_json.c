/* Rigs in job files: bow and blade, feeds and poses of one tool, in and out, and every way to contradict them. */
#include <math.h>
#include <wirecut/job.h>
#include <wirecut/job_file.h>

#include "base/fail.h"
#include "io/given.h"
#include "io/process/job.h"
#include "test.h"

#define JOB(wire, process, rig, feed, path)                                                                   \
    "{\"format\": \"wirecut-job/1\", \"name\": \"r\", \"block\": {\"size_mm\": [400, 300, 200]}, \"wire\": {" \
    "\"diameter_mm\": 0.4, \"nodes\": 21" wire "}, \"process\": {" process                                    \
    ", \"force_law\": {\"a_N_per_mm\": 0.1, \"b_m2_per_J\": 8.6e-4}}, \"rig\": {" rig "}, \"feed\": {" feed   \
    "}, \"path\": {" path "}}"
#define NICR ", \"material\": \"NiCr 80/20\""
#define HOT "\"heat_W_per_m\": 90"
#define BOW "\"kind\": \"bow\", \"pretension_N\": 30, \"stiffness_N_per_mm\": 8"
#define FEED "\"speed_mm_s\": 10"
#define TOOL                                                                                                     \
    "\"tool\": [[0, 0, 100, 1, 0, 0, 0], [0, 50, 100, 1, 0, 0, 0], [0, 90, 100, 0.70710678, 0, 0.70710678, 0]]," \
    "\"mount_a_in_tool_mm\": [-50, 0, 0], \"mount_b_in_tool_mm\": [450, 0, 0]"
#define LISTS "\"mount_a_mm\": [[-50, 0, 90], [-50, 9, 90]], \"mount_b_mm\": [[450, 0, 90], [450, 9, 90]]"

static wcut_job *job;
static wcut_error error;

static wcut_status parse(const char *text) {
    wcut_job_destroy(job);
    job = NULL;
    error = (wcut_error){WCUT_OK, ""};
    return wcut_job_parse(text, strlen(text), "j", &job, &error);
}

static void accepted(const char *text) { ck_assert_msg(parse(text) == WCUT_OK, "%s", error.text); }

static void refused(const char *text, const char *line) {
    ck_assert_int_ne(parse(text), WCUT_OK);
    ck_assert_ptr_null(job);
    ck_assert_msg(strstr(error.text, line) != NULL, "%s\n  expected: %s", error.text, line);
}

static void forget(void) {
    wcut_job_destroy(job);
    job = NULL;
}

TEST(a_job_without_a_rig_is_of_two_arms_that_no_feed_drives) {
    accepted(given_path_job);
    ck_assert(job->rig.kind == WCUT_RIG_KIND_TWO_ARMS && job->feed.kind == WCUT_FEED_KIND_NONE && !job->tool);
    ck_assert(isinf(job->rig.stiffness) && job->rig.expansion == -1 && job->rig.wire_stiffness == 0);
    forget();
}

TEST(every_key_of_a_bow_and_its_tool_reaches_its_member) {
    accepted(JOB(NICR, HOT, BOW ", \"wire_stiffness_N\": 27000, \"expansion_per_K\": 1.5e-5", FEED, TOOL));
    ck_assert(job->rig.kind == WCUT_RIG_KIND_BOW && job->rig.pretension == 30 && job->rig.stiffness == 8);
    ck_assert(job->rig.wire_stiffness == 27000 && job->rig.expansion == 1.5e-5 && job->wire_length == 0);
    ck_assert(job->feed.kind == WCUT_FEED_KIND_CONSTANT && job->feed.count == 1 && job->feed.speed[0] == 10);
    ck_assert(job->stations == 3 && job->tool[1].at.y == 50 && job->mount_b_in_tool.x == 450);

    /* mounts follow from the poses; the last one looks down: x of the tool is -z of the block */
    ck_assert(job->mount_a[1].x == -50 && job->mount_a[1].y == 50 && job->mount_b[1].x == 450);
    ck_assert_double_eq_tol(job->mount_a[2].z, 150, 1e-12);
    ck_assert_double_eq_tol(job->mount_b[2].z, -350, 1e-12);
    ck_assert_double_eq_tol(job->mount_b[2].x, 0, 1e-12);
    forget();
}

TEST(a_feed_is_a_number_or_one_a_station_or_a_profile_of_time) {
    accepted(JOB(NICR, HOT, BOW, "\"speed_mm_s\": [1, 2.5, 3]", TOOL));
    ck_assert(job->feed.kind == WCUT_FEED_KIND_STATIONS && job->feed.count == 3 && job->feed.speed[1] == 2.5);
    accepted(JOB(NICR, HOT, BOW, "\"profile\": [[0, 5], [2, 9]]", TOOL));
    ck_assert(job->feed.kind == WCUT_FEED_KIND_TIME && job->feed.time[1] == 2 && job->feed.speed[1] == 9);
    refused(JOB(NICR, HOT, BOW, "\"speed_mm_s\": [1, 2]", TOOL),
            "$.feed.speed_mm_s: found an array of 2, expected a number, or 3 of them");
    refused(JOB(NICR, HOT, BOW, "\"speed_mm_s\": 1, \"profile\": [[0, 5], [2, 9]]", TOOL), "either \"speed_mm_s\" or");
    refused(JOB(NICR, HOT, BOW, "\"profile\": [[0, 5], [0, 9]]", TOOL), "times to increase");
    refused(JOB(NICR, HOT, BOW, "\"profile\": [[0, 5], [1]]", TOOL), "a pair [time in s, speed in mm/s]");
    refused(JOB(NICR, HOT, BOW, "\"profile\": [[0, 5]]", TOOL), "an array of 2 to");
    forget();
}

TEST(a_feed_beyond_the_limits_contradicts_them) {
    refused(JOB(NICR, HOT, BOW, "\"speed_mm_s\": 101", TOOL),
            "$.feed.speed_mm_s: found 101, expected a speed within the job's limits, 0.1 to 100 mm/s");
    refused(JOB(NICR, HOT, BOW, "\"speed_mm_s\": [1, 0.05, 1]", TOOL), "$.feed.speed_mm_s[1]");
    refused(JOB(NICR, HOT, BOW, "\"profile\": [[0, 5], [1, 200]]", TOOL), "$.feed.profile[1][1]");
}

TEST(a_pose_that_is_no_rotation_is_refused) {
    refused(JOB(NICR, HOT, BOW, FEED,
                "\"tool\": [[0,0,0, 1,0,0,0], [0,9,0, 1,1,0,0]], \"mount_a_in_tool_mm\": [0,0,0], "
                "\"mount_b_in_tool_mm\": [9,0,0]"),
            "$.path.tool[1]: found an array of 7, expected a rotation: a quaternion qw, qx, qy, qz of length 1, not "
            "1.41421");
    refused(JOB(NICR, HOT, BOW, FEED,
                "\"tool\": [[0,0,0, 0,0,0,0], [0,9,0, 1,0,0,0]], \"mount_a_in_tool_mm\": [0,0,0], "
                "\"mount_b_in_tool_mm\": [9,0,0]"),
            "of length 1, not 0");
    refused(JOB(NICR, HOT, BOW, FEED,
                "\"tool\": [[0,0,0,1], [0,9,0, 1,0,0,0]], \"mount_a_in_tool_mm\": [0,0,0], \"mount_b_in_tool_mm\": "
                "[9,0,0]"),
            "a pose [x, y, z in mm, qw, qx, qy, qz]");
    refused(JOB(NICR, HOT, BOW, FEED, "\"tool\": [[0,0,0, 1,0,0,0], [0,9,0, 1,0,0,0]]"), "mount_a_in_tool_mm");
}

TEST(a_rig_and_its_job_do_not_contradict_each_other) {
    refused(JOB(NICR, HOT ", \"tension_N\": 2", BOW, FEED, TOOL), "the tension of a bow is an answer");
    refused(JOB(NICR, "\"heat_W_per_m\": 0", BOW, FEED, TOOL),
            "$.process.heat_W_per_m: found 0, expected a number greater than 0");
    refused(JOB(NICR ", \"length_mm\": 510", HOT, BOW, FEED, TOOL), "none beside rig.pretension_N");
    refused(JOB(NICR, HOT, "\"kind\": \"bow\"", FEED, TOOL),
            "a number greater than 0, or a wire.length_mm in its place");
    refused(JOB(NICR ", \"length_mm\": 510", HOT ", \"tension_N\": 2", "\"kind\": \"two_arms\"", FEED, TOOL),
            "each of two arms has a mount of its own");
    refused(JOB(NICR ", \"length_mm\": 510", HOT, "\"kind\": \"two_arms\"", FEED, LISTS), "two arms hold it");
    refused(JOB("", HOT, "\"kind\": \"blade\", \"pretension_N\": 3", FEED, TOOL),
            "it is of a bow, this is a rig of kind blade");
    refused(JOB("", HOT, "\"kind\": \"sword\"", FEED, TOOL), "$.rig.kind");
    accepted(JOB("", "\"heat_W_per_m\": 0", "\"kind\": \"blade\"", FEED, LISTS));
    ck_assert(job->heat == 0 && job->rig.kind == WCUT_RIG_KIND_BLADE);
    accepted(JOB(", \"length_mm\": 510", HOT ", \"tension_N\": 2", "\"kind\": \"two_arms\"", FEED, LISTS));
    forget();
}

/* written and read once more: the same members, and the same bytes a third time */
static void comes_back(const char *text) {
    wcut_job *again = NULL;
    char *first = NULL, *second = NULL;
    size_t length = 0;
    accepted(text);
    ck_assert_msg(wcut_job_print(job, "out", &first, &length, &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_job_parse(first, length, "again", &again, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(wcut_job_print(again, "out", &second, &length, &error), WCUT_OK);
    ck_assert_str_eq(first, second);
    ck_assert(memcmp(&job->rig, &again->rig, sizeof job->rig) == 0 && job->feed.kind == again->feed.kind);
    ck_assert(memcmp(job->feed.speed, again->feed.speed, (size_t)job->feed.count * sizeof(double)) == 0);
    ck_assert(!job->tool == !again->tool && job->stations == again->stations);
    ck_assert(memcmp(job->mount_b, again->mount_b, (size_t)job->stations * sizeof(wcut_vec3)) == 0);
    free(first);
    free(second);
    wcut_job_destroy(again);
}

TEST(rigs_come_back_to_the_last_bit) {
    comes_back(JOB(NICR, HOT, BOW ", \"wire_stiffness_N\": 27000.125, \"expansion_per_K\": 0", FEED, TOOL));
    comes_back(JOB(NICR, HOT, BOW, "\"speed_mm_s\": [1, 2.5, 3]", TOOL));
    comes_back(JOB(NICR ", \"length_mm\": 510", HOT, "\"kind\": \"bow\"", "\"profile\": [[0, 5], [2, 9.1]]", LISTS));
    comes_back(JOB("", "\"heat_W_per_m\": 0", "\"kind\": \"blade\"", FEED, TOOL));
    forget();
}
