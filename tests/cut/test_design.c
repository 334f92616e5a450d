/* Design mode: the wire between two edge curves, the path curves it gives, and the way back: the path curves cut in
   path mode leave the designed surface in the block. labels: unit property oracle plain */
#include "cut/cuts.h"
#include "foam/block.h"
#include "test.h"

static const char *const design_jobs[] = {"freeform-1.json", "freeform-2.json", "freeform-3.json", "freeform-4.json"};

static wcut_vec3 point_on(const wcut_curve *edge, double share) {
    double first, last;
    wcut_vec3 point;
    wcut_curve_domain(edge, &first, &last);
    ck_assert_int_eq(wcut_curve_eval(edge, first + share * (last - first), 0, &point), WCUT_OK);
    return point;
}

/* the job that cuts along the path curves of a design */
static wcut_job *path_of(const wcut_job *design, const wcut_history *h) {
    wcut_job *path = job_without_path(design->block_size.x, 0, design->nodes, h->stations);
    path->block_size = design->block_size;
    path->heat = design->heat;
    path->force_law = design->force_law;
    wcut_setup *setup = setup_of(design, NULL);
    ck_assert_int_eq(wcut_history_path(setup, h, path->mount_a, path->mount_b, &path->wire_length, NULL), WCUT_OK);
    wcut_setup_destroy(setup);
    return path;
}

TEST(every_wire_runs_from_edge_to_edge_on_equal_edges_of_its_own_length) {
    for (int k = 0; k < 4; k++) {
        wcut_job *job = sample_job(design_jobs[k]);
        wcut_history *h = run_of(job);
        const int n = job->nodes, m = job->stations;
        for (int j = 0; j < m; j++) {
            const double u = (double)j / (m - 1);
            const wcut_vec3 *x = nodes_at(h, j), a = point_on(job->edge_a, u), b = point_on(job->edge_b, u);
            ck_assert_double_lt(vec3_distance(x[0], a), 1e-9);
            ck_assert_double_lt(vec3_distance(x[n - 1], b), 1e-9);
            double length = 0, least = 0, most = 0; /* of the extra length between the job's points around u */
            for (int e = 0; e < n - 1; e++) length += vec3_distance(x[e], x[e + 1]);
            for (int e = 0; e < n - 1; e++)
                ck_assert_double_eq_tol(vec3_distance(x[e], x[e + 1]), length / (n - 1), 1e-7);
            int i = 0;
            while (i < job->extra_count - 2 && u > job->extra_u[i + 1]) i++;
            least = fmin(job->extra_length[i], job->extra_length[i + 1]);
            most = fmax(job->extra_length[i], job->extra_length[i + 1]);
            const double extra = length - vec3_distance(a, b);
            ck_assert_double_gt(extra, least - 1e-6); /* monotone: nothing beyond the points */
            ck_assert_double_lt(extra, most + 1e-6);
            if (u == job->extra_u[i]) ck_assert_double_eq_tol(extra, job->extra_length[i], 1e-6);
            if (j > 0) ck_assert_double_eq_tol(h->row[j].engaged_length, length, 1e-6); /* all of it in the foam */
        }
        wcut_history_destroy(h);
        wcut_job_destroy(job);
    }
}

TEST(the_tension_condition_holds_while_the_wires_length_changes) {
    for (int k = 0; k < 4; k++) {
        wcut_job *job = sample_job(design_jobs[k]);
        wcut_history *h = run_of(job);
        for (int j = 1; j < h->stations; j++) {
            ck_assert_int_eq(h->row[j].condition, WCUT_CONDITION_TENSION);
            if (h->row[j].substeps == 1) ck_assert_double_eq_tol(pull_at(h, j), 2, 2e-9);
        }
        wcut_history_destroy(h);
        wcut_job_destroy(job);
    }
}

TEST(path_curves_give_every_wire_one_length_along_its_end_tangents_clear_of_the_block) {
    for (int k = 0; k < 4; k++) {
        wcut_job *job = sample_job(design_jobs[k]);
        wcut_history *h = run_of(job);
        wcut_job *path = path_of(job, h);
        const wcut_block block = {.size = job->block_size, .depth = job->wire_diameter};
        const int n = job->nodes;
        double closest = 1e9;
        for (int j = 0; j < h->stations; j++) {
            const wcut_vec3 *x = nodes_at(h, j), a = path->mount_a[j], b = path->mount_b[j];
            double length = vec3_distance(a, x[0]) + vec3_distance(b, x[n - 1]);
            for (int e = 0; e < n - 1; e++) length += vec3_distance(x[e], x[e + 1]);
            ck_assert_double_eq_tol(length, path->wire_length, 1e-9 * length);
            closest = fmin(closest, fmin(wcut_block_distance(&block, a), wcut_block_distance(&block, b)));
            /* the mount lies where the wire's end points to: the angle at it is half an edge's turn at most */
            const wcut_vec3 out = vec3_unit(vec3_sub(a, x[0])), edge = vec3_unit(vec3_sub(x[0], x[1]));
            const wcut_vec3 inner = vec3_unit(vec3_sub(x[1], x[2]));
            ck_assert_double_lt(vec3_distance(out, edge), 0.6 * vec3_distance(edge, inner) + 1e-9);
        }
        ck_assert_double_eq_tol(closest, job->clearance, 1e-6); /* kept, and no more than kept */
        wcut_history_destroy(h);
        wcut_job_destroy(job);
        wcut_job_destroy(path);
    }
}

static double distance_to_wire(wcut_vec3 p, int n, const wcut_vec3 *x) {
    double least = 1e9;
    for (int e = 0; e < n - 1; e++) {
        const wcut_vec3 d = vec3_sub(x[e + 1], x[e]);
        const double t = clamp(vec3_dot(vec3_sub(p, x[e]), d) / vec3_dot(d, d), 0, 1);
        least = fmin(least, vec3_distance(p, vec3_add_scaled(x[e], t, d)));
    }
    return least;
}

/* The two begin differently: a design has foam about its first wire, which a path still has before it. What is left of
   that decays as the wire goes by about half the block's width; from there on the surfaces are one. */
TEST(the_path_curves_cut_in_path_mode_leave_the_designed_surface) {
    for (int k = 0; k < 4; k++) {
        wcut_job *job = sample_job(design_jobs[k]);
        wcut_history *h = run_of(job);
        wcut_job *path = path_of(job, h);
        wcut_history *g = run_of(path);
        const double width = job->block_size.x;
        double early = 0, late = 0, squares = 0;
        long count = 0;
        for (int j = 0; j < h->stations; j++)
            for (int i = 0; i < h->nodes; i++) {
                const double d = distance_to_wire(nodes_at(h, j)[i], g->nodes, nodes_at(g, j));
                early = fmax(early, d);
                if (j < h->stations / 3) continue;
                late = fmax(late, d), squares += d * d, count++;
            }
        printf("%s: apart by %.2f mm at most while it begins, then by %.3f mm, %.3f mm RMS\n", design_jobs[k], early,
               late, sqrt(squares / (double)count));
        ck_assert_double_lt(early, 0.08 * width);
        ck_assert_double_lt(late, 0.001 * width);
        ck_assert_double_lt(sqrt(squares / (double)count), 0.0004 * width);
        wcut_history_destroy(h);
        wcut_history_destroy(g);
        wcut_job_destroy(job);
        wcut_job_destroy(path);
    }
}

TEST(in_path_mode_the_path_curves_are_the_mounts) {
    wcut_job *job = swinging_job(31, 20);
    wcut_history *h = run_of(job);
    wcut_setup *setup = setup_of(job, NULL);
    wcut_vec3 a[20], b[20];
    double length = 999;
    ck_assert_int_eq(wcut_history_path(setup, h, a, b, &length, NULL), WCUT_OK);
    ck_assert_double_eq(length, 620);
    ck_assert(memcmp(a, job->mount_a, sizeof a) == 0 && memcmp(b, job->mount_b, sizeof b) == 0);
    ck_assert_int_eq(wcut_history_path(setup, h, NULL, b, &length, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_path(NULL, h, a, b, &length, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_path(setup, NULL, a, b, &length, NULL), WCUT_BAD_ARGUMENT);
    wcut_setup_destroy(setup);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(a_tangent_into_the_block_gives_no_path_and_nothing_is_written) {
    wcut_job *job = sample_job("freeform-1.json");
    job->stations = 10;
    wcut_setup *setup = setup_of(job, NULL);
    wcut_history *h = run_of(job);
    wcut_vec3 *x = h->position + 4 * h->nodes; /* station 4: as if the wire ran along the outside of the block */
    for (int i = 1; i < 5; i++) x[i] = vec3(-4.0 * i, x[0].y, x[0].z);
    wcut_vec3 a[10], b[10];
    double length = 999;
    wcut_error error = {0};
    a[0].x = b[9].z = 999;
    ck_assert_int_eq(wcut_history_path(setup, h, a, b, &length, &error), WCUT_DEGENERATE);
    ck_assert_msg(strstr(error.text, "station 4") && strstr(error.text, "end A"), "%s", error.text);
    ck_assert(a[0].x == 999 && b[9].z == 999 && length == 999);
    wcut_history_destroy(h);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}
