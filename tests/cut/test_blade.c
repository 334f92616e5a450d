/* A blade in the simulator: its force is law times engaged length, and what sliding along the edge makes of it. */
#include <string.h>
#include <wirecut/cut.h>
#include <wirecut/history.h>
#include <wirecut/job.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "test.h"

#define A 0.05 /* [N/mm] */

static wcut_error error;

/* a blade of 300 mm upright in a block 100 mm high, led along y at 8 mm/s, tilted in the plane of feed and height */
static wcut_job *given_blade(double tilt, wcut_vec3 feed, int stations) {
    wcut_job *job = NULL;
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->block_size = vec3(200, 300, 100);
    job->wire_diameter = 0.5, job->nodes = 301;
    job->heat = 0, job->tension = 0;
    job->force_law = (wcut_force_law){A, 1e-4};
    job->rig.kind = WCUT_RIG_KIND_BLADE;
    job->feed = (wcut_feed){WCUT_FEED_KIND_CONSTANT, 1, malloc(sizeof(double)), NULL};
    job->feed.speed[0] = 8;
    job->mode = WCUT_MODE_PATH, job->stations = stations;
    job->tool = calloc((size_t)stations, sizeof *job->tool);
    for (int j = 0; j < stations; j++) {
        job->tool[j].at = vec3_add_scaled(vec3(100, -80, 50), 8.0 * j, feed);
        job->tool[j].turn[0] = cos(tilt / 2), job->tool[j].turn[1] = sin(tilt / 2);
    }
    job->mount_a_in_tool = vec3(0, 0, 150), job->mount_b_in_tool = vec3(0, 0, -150);
    ck_assert_msg(wcut_job_place_mounts(job, &error) == WCUT_OK, "%s", error.text);
    return job;
}

static wcut_history *run(wcut_job *job, wcut_vec3 *force_sum, int station) {
    wcut_setup *setup = NULL;
    wcut_history *h = NULL;
    ck_assert_msg(wcut_setup_create(job, NULL, &setup, &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_setup_run(setup, NULL, NULL, &h, &error) == WCUT_OK, "%s", error.text);
    *force_sum = vec3(0, 0, 0);
    wcut_cut *cut = NULL;
    ck_assert_int_eq(wcut_cut_create(setup, &cut, &error), WCUT_OK);
    for (int j = 0; j < station; j++) ck_assert_int_eq(wcut_cut_step(cut, &error), WCUT_OK);
    wcut_station s;
    wcut_cut_view(cut, &s);
    for (int i = 0; i < s.nodes; i++) *force_sum = vec3_add(*force_sum, s.force[i]);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    return h;
}

TEST(the_flange_force_is_the_law_times_the_engaged_length) {
    for (int k = 0; k < 3; k++) {
        const double tilt = k * 0.3;
        wcut_job *job = given_blade(tilt, vec3(0, 1, 0), 31);
        wcut_vec3 sum;
        wcut_history *h = run(job, &sum, 25);
        const wcut_history_row *row = &h->row[25];

        /* the block is 100 mm high: tilted by t the edge has 100 / cos t of it */
        const double length = 100 / cos(tilt);
        ck_assert_double_eq_tol(row->engaged_length, length, 0.6); /* faces are soft over the blade's thickness */
        const wcut_vec3 normal = vec3(0, cos(tilt), sin(tilt));
        ck_assert_double_eq_tol(vec3_dot(sum, normal), -A * row->engaged_length, 1e-12);
        ck_assert_double_eq_tol(vec3_length(sum), A * row->engaged_length, 1e-12);

        /* both mounts carry it, each by its lever */
        ck_assert_double_eq_tol(row->tension_a + row->tension_b, A * row->engaged_length, 1e-9);
        ck_assert_double_eq_tol(row->duration, 1, 1e-12); /* 8 mm at 8 mm/s */
        wcut_history_destroy(h);
        wcut_job_destroy(job);
    }
}

TEST(nodes_lie_on_the_line_between_the_mounts) {
    wcut_job *job = given_blade(0.4, vec3(0, 0.8, 0.6), 21);
    wcut_vec3 sum;
    wcut_history *h = run(job, &sum, 3);
    for (int j = 0; j < h->stations; j++)
        for (int i = 0; i < h->nodes; i++) {
            const wcut_vec3 line = vec3_mix(job->mount_a[j], job->mount_b[j], (double)i / (h->nodes - 1));
            ck_assert_double_lt(vec3_distance(h->position[j * h->nodes + i], line), 1e-12);
        }
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(sliding_along_the_edge_changes_the_force_by_its_ratio_alone) {
    /* upright, led up by 0.75 of its advance */
    const wcut_vec3 feed = vec3(0, 0.8, 0.6);
    wcut_vec3 plain, soft;
    wcut_job *job = given_blade(0, feed, 16);
    wcut_history *h = run(job, &plain, 15);
    ck_assert_double_eq_tol(plain.y, -A * h->row[15].engaged_length,
                            1e-12); /* the whole law, against the advance alone */
    ck_assert_double_eq_tol(plain.z, 0, 1e-12);
    wcut_history_destroy(h);

    /* F / (1 + (xi / xi_0)^2)^m with xi = 0.75 */
    job->effect = malloc(sizeof *job->effect);
    job->effect_count = 1;
    job->effect[0] = wcut_effect_default(WCUT_EFFECT_SLICE_SOFTENING);
    job->effect[0].value[WCUT_SLICE_SOFTENING_RATIO] = 0.5;
    job->effect[0].value[WCUT_SLICE_SOFTENING_EXPONENT] = 1.3;
    h = run(job, &soft, 15);
    ck_assert_double_eq_tol(soft.y / plain.y, pow(1 + 2.25, -1.3), 1e-12);
    wcut_history_destroy(h);

    /* at its neutral value, bit for bit the plain force */
    job->effect[0] = wcut_effect_default(WCUT_EFFECT_SLICE_SOFTENING);
    ck_assert(wcut_effect_is_neutral(&job->effect[0]));
    h = run(job, &soft, 15);
    ck_assert(soft.x == plain.x && soft.y == plain.y && soft.z == plain.z);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(work_of_the_mounts_is_that_of_the_foam) {
    wcut_job *job = given_blade(0.2, vec3(0, 1, 0), 31);
    wcut_vec3 sum;
    wcut_history *h = run(job, &sum, 20);
    const double way = 8, work = -vec3_dot(sum, vec3(0, way, 0));
    const double length = h->row[20].engaged_length;
    ck_assert_double_eq_tol(work, A * length * way * cos(0.2), 1e-9); /* advance across the edge */
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}
