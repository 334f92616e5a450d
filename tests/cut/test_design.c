/* Design mode: the plan of wires from edge to edge, the path curves it gives, and the cut along them, which leaves the
   block on the edges. labels: unit property oracle */
#include "cut/cuts.h"
#include "cut/setup.h"
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

/* the run of a design's plan; *plan: NULL, or the caller's */
static wcut_history *plan_of(const wcut_job *job, wcut_setup **plan) {
    const wcut_cut_options options = wcut_cut_options_default();
    wcut_setup *made = NULL;
    wcut_history *h = NULL;
    wcut_error error = {0};
    ck_assert_msg(wcut_plan_create(job, &options, &made, &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_setup_run(made, NULL, NULL, &h, &error) == WCUT_OK, "%s", error.text);
    if (plan)
        *plan = made;
    else
        wcut_setup_destroy(made);
    return h;
}

TEST_EACH(every_wire_runs_from_edge_to_edge_on_equal_edges_of_its_own_length, 4) {
    wcut_job *job = sample_job(design_jobs[_i]);
    wcut_history *h = plan_of(job, NULL);
    const int n = job->nodes, m = job->stations;
    for (int j = 0; j < m; j++) {
        const double u = (double)j / (m - 1);
        const wcut_vec3 *x = nodes_at(h, j), a = point_on(job->edge_a, u), b = point_on(job->edge_b, u);
        ck_assert_double_lt(vec3_distance(x[0], a), 1e-9);
        ck_assert_double_lt(vec3_distance(x[n - 1], b), 1e-9);
        double length = 0, low = 0, high = 0; /* of the extra length between the job's points around u */
        for (int e = 0; e < n - 1; e++) length += vec3_distance(x[e], x[e + 1]);
        for (int e = 0; e < n - 1; e++) ck_assert_double_eq_tol(vec3_distance(x[e], x[e + 1]), length / (n - 1), 1e-7);
        int i = 0;
        while (i < job->extra_count - 2 && u > job->extra_u[i + 1]) i++;
        low = fmin(job->extra_length[i], job->extra_length[i + 1]);
        high = fmax(job->extra_length[i], job->extra_length[i + 1]);
        const double extra = length - vec3_distance(a, b);
        ck_assert_double_gt(extra, low - 1e-6); /* monotone: nothing beyond the points */
        ck_assert_double_lt(extra, high + 1e-6);
        if (u == job->extra_u[i]) ck_assert_double_eq_tol(extra, job->extra_length[i], 1e-6);
        if (j > 0) ck_assert_double_eq_tol(h->row[j].engaged_length, length, 1e-6); /* all of it in the foam */
    }
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST_EACH(the_tension_condition_holds_while_the_wires_length_changes, 4) {
    wcut_job *job = sample_job(design_jobs[_i]);
    wcut_history *h = plan_of(job, NULL);
    for (int j = 1; j < h->stations; j++) {
        ck_assert_int_eq(h->row[j].condition, WCUT_CONDITION_TENSION);
        if (h->row[j].substeps == 1) ck_assert_double_eq_tol(pull_at(h, j), 2, 2e-9);
    }
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST_EACH(path_curves_give_every_wire_one_length_along_its_end_tangents_clear_of_the_block, 4) {
    wcut_job *job = sample_job(design_jobs[_i]);
    wcut_setup *plan;
    wcut_history *h = plan_of(job, &plan);
    wcut_design_path path;
    ck_assert_int_eq(wcut_design_path_create(plan, h, &path, NULL), WCUT_OK);
    ck_assert_int_eq(path.part_last - path.part_first + 1, job->stations);
    const wcut_block block = {.size = job->block_size, .depth = job->wire_diameter};
    const int n = job->nodes;
    double closest = 1e9;
    for (int j = 0; j < h->stations; j++) {
        const int at = path.part_first + j;
        const wcut_vec3 *x = nodes_at(h, j), a = path.mount_a[at], b = path.mount_b[at];
        double length = vec3_distance(a, x[0]) + vec3_distance(b, x[n - 1]);
        for (int e = 0; e < n - 1; e++) length += vec3_distance(x[e], x[e + 1]);
        ck_assert_double_eq_tol(length, path.length, 1e-9 * length);
        closest = fmin(closest, fmin(wcut_block_distance(&block, a), wcut_block_distance(&block, b)));

        /* the mount lies where the wire's end points to: the angle at it is half an edge's turn at most */
        const wcut_vec3 out = vec3_unit(vec3_sub(a, x[0])), edge = vec3_unit(vec3_sub(x[0], x[1]));
        const wcut_vec3 inner = vec3_unit(vec3_sub(x[1], x[2]));
        ck_assert_double_lt(vec3_distance(out, edge), 0.6 * vec3_distance(edge, inner) + 1e-9);
    }
    ck_assert_double_eq_tol(closest, job->clearance, 1e-6); /* kept, and no more than kept */

    /* before and behind them the wire goes on as it is, until it is out of the block */
    const int last = path.stations - 1;
    ck_assert_double_lt(fmax(path.mount_a[0].y, path.mount_b[0].y), path.mount_a[path.part_first].y);
    ck_assert_double_gt(path.mount_a[last].y, path.mount_a[path.part_last].y);
    ck_assert_double_eq_tol(vec3_distance(path.mount_a[0], path.mount_b[0]),
                            vec3_distance(path.mount_a[path.part_first], path.mount_b[path.part_first]), 1e-9);
    wcut_design_path_destroy(&path);
    wcut_history_destroy(h);
    wcut_setup_destroy(plan);
    wcut_job_destroy(job);
}

/* where the wire passes a side of the block, counted from its end A or B; false where it does not */
static bool passes(int n, const wcut_vec3 *x, double side, bool from_b, wcut_vec3 *place) {
    for (int k = 0; k < n - 1; k++) {
        const int e = from_b ? n - 2 - k : k;
        const double p = x[e].x - side, q = x[e + 1].x - side;
        if (p * q > 0 || p == q) continue;
        *place = vec3_mix(x[e], x[e + 1], p / (p - q));
        return true;
    }
    return false;
}

static double distance_to_edge(const wcut_curve *edge, wcut_vec3 p) {
    double min = 1e9;
    wcut_vec3 from = point_on(edge, 0);
    for (int i = 1; i <= 500; i++) {
        const wcut_vec3 to = point_on(edge, i / 500.0), d = vec3_sub(to, from);
        const double t = clamp(vec3_dot(vec3_sub(p, from), d) / vec3_dot(d, d), 0, 1);
        min = fmin(min, vec3_distance(p, vec3_add_scaled(from, t, d)));
        from = to;
    }
    return min;
}

/* What is drawn is what is cut: the wire leaves the block on the edges from the first millimetre on. At the very entry it
   lies on the block's edge until the foam loads it. */
TEST_EACH(the_cut_leaves_the_block_on_the_edges_from_the_first_millimetre, 4) {
    wcut_job *job = sample_job(design_jobs[_i]);
    if (_i == 2) job->stations = 121; /* a tilted wire comes loose: many parts of steps */
    wcut_history *h = run_of(job);
    double early = 0, late = 0;
    for (int j = 0; j < h->stations; j++)
        for (int side = 0; side < 2; side++) {
            wcut_vec3 p;
            if (!(h->row[j].engaged_length > 0) ||
                !passes(h->nodes, nodes_at(h, j), side ? job->block_size.x : 0, side == 1, &p) || p.y < 0.5 ||
                p.y > job->block_size.y - 0.5)
                continue;
            const double off = distance_to_edge(side ? job->edge_b : job->edge_a, p);
            if (p.y < 100)
                early = fmax(early, off);
            else
                late = fmax(late, off);
        }
    printf("%s: off its edges by %.2f mm at most in the first 100 mm, then by %.3f mm\n", design_jobs[_i], early, late);
    ck_assert_double_lt(early, 2);
    ck_assert_double_lt(late, 0.25);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST_EACH(a_design_and_its_own_path_job_are_one_cut_to_the_last_digit, 4) {
    wcut_job *job = sample_job(design_jobs[_i]), *path = NULL;
    job->stations = 121, job->nodes = 61;
    wcut_setup *setup = setup_of(job, NULL);
    ck_assert_int_eq(wcut_setup_path_job(setup, &path), WCUT_OK);
    ck_assert_int_eq(path->mode, WCUT_MODE_PATH);
    wcut_history *h = run_of(job), *g = run_of(path);
    ck_assert_int_eq(h->stations, g->stations);
    const size_t count = (size_t)h->stations * (size_t)h->nodes;
    ck_assert(memcmp(h->position, g->position, count * sizeof *h->position) == 0);
    ck_assert(memcmp(h->force, g->force, count * sizeof *h->force) == 0);
    ck_assert_double_eq(h->row[h->stations - 1].time, g->row[g->stations - 1].time);
    wcut_history_destroy(h);
    wcut_history_destroy(g);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
    wcut_job_destroy(path);
}

TEST_EACH(a_design_begins_and_ends_out_of_the_block_and_passes_its_phases_in_order, 4) {
    wcut_job *job = sample_job(design_jobs[_i]);
    job->stations = 121, job->nodes = 61;
    wcut_history *h = run_of(job);
    ck_assert_int_eq(h->row[0].phase, WCUT_PHASE_APPROACH);
    ck_assert_int_eq(h->row[h->stations - 1].phase, WCUT_PHASE_LEFT);
    bool met[5] = {false};
    for (int j = 0; j < h->stations; j++) met[h->row[j].phase] = true;
    for (int p = 0; p < 5; p++) ck_assert(met[p]);
    for (int j = 1; j < h->stations; j++) ck_assert_int_ge(h->row[j].phase, h->row[j - 1].phase);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST_EACH(speeds_of_the_mounts_are_their_way_over_the_time_at_every_station, 4) {
    wcut_job *job = sample_job(design_jobs[_i]);
    job->stations = 121, job->nodes = 61;
    wcut_setup *setup = setup_of(job, NULL);
    wcut_history *h = run_of(job);
    const size_t m = (size_t)h->stations;
    wcut_vec3 *a = wcut_alloc(m, sizeof *a), *b = wcut_alloc(m, sizeof *b);
    double length, fastest = 0;
    ck_assert_int_eq(wcut_history_path(setup, h, a, b, &length, NULL), WCUT_OK);
    for (size_t j = 1; j < m; j++) {
        const wcut_history_row *r = &h->row[j];
        ck_assert_double_eq_tol(r->time - r[-1].time, r->duration, 1e-9);
        ck_assert_double_eq_tol(r->speed_a, vec3_distance(a[j], a[j - 1]) / r->duration, 1e-9 * r->speed_a);
        ck_assert_double_eq_tol(r->speed_b, vec3_distance(b[j], b[j - 1]) / r->duration, 1e-9 * r->speed_b);
        fastest = fmax(fastest, fmax(r->speed_a, r->speed_b));
    }
    ck_assert_double_lt(fastest, job->speed_max * (1 + 1e-9)); /* the limits are the mounts' */
    wcut_free(a);
    wcut_free(b);
    wcut_setup_destroy(setup);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(what_is_outside_the_block_carries_no_force) {
    wcut_job *job = sample_job("freeform-4.json");
    wcut_history *h = run_of(job);
    const double d = 6; /* [mm] beyond a node's own length */
    int outside = 0;
    for (int j = 0; j < h->stations; j++)
        for (int i = 0; i < h->nodes; i++) {
            const wcut_vec3 x = nodes_at(h, j)[i], size = job->block_size;
            const bool out =
                x.x < -d || x.x > size.x + d || x.y < -d || x.y > size.y + d || x.z < -d || x.z > size.z + d;
            if (!out) continue;
            outside++;
            ck_assert_double_eq(vec3_length(forces_at(h, j)[i]), 0);
        }
    ck_assert_int_gt(outside, 5000);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

/* move an edge's control points */
static void shift_edge(wcut_curve *edge, wcut_vec3 by, double scale) {
    for (int i = 0; i < edge->control_count; i++) edge->control[i] = vec3_add(vec3_scale(scale, edge->control[i]), by);
}

TEST(edges_off_the_block_are_refused_with_curve_station_and_by_how_much) {
    const struct {
        wcut_vec3 block, shift;
        double scale;
        const char *words[3];
    } bad[] = {{{0.4, 0.9, 0.3}, {0, 0, 0}, 1, {"design.edge_", "outside the block", "they differ by 1000"}},
               {{400, 900, 100}, {0, 0, 0}, 1, {"design.edge_a", "station", "outside the block"}},
               {{400, 500, 300}, {0, 0, 0}, 1, {"station 240", "400 mm outside", "within 0.1 mm"}},
               {{40, 90, 30}, {0, 0, 0}, 1, {"design.edge_", "outside the block", "they differ by 10"}},
               {{400 / 25.4, 900 / 25.4, 300 / 25.4}, {0, 0, 0}, 1, {"design.edge_", "outside", "they differ by 25.4"}},
               {{400, 900, 300}, {0, 0, 0}, 1e-3, {"edges span", "design.extra_length_mm", "they differ by 1000"}},
               {{400, 900, 300}, {-50, 0, 0}, 1, {"design.edge_a", "50 mm outside", "expected edges on the block"}},
               {{400, 900, 300}, {60, 0, 0}, 1, {"design.edge_b", "60 mm outside", "expected edges on the block"}},
               {{400, 900, 300}, {0, -0.2, 0}, 1, {"station 0", "0.2 mm outside", "expected edges on the block"}},
               {{520, 900, 300}, {60, 0, 0}, 1, {"station 0", "end A", "expected a wire that leaves the block there"}}};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        wcut_job *job = sample_job("freeform-4.json");
        job->block_size = bad[k].block;
        shift_edge(job->edge_a, bad[k].shift, bad[k].scale);
        shift_edge(job->edge_b, bad[k].shift, bad[k].scale);
        wcut_setup *setup = NULL;
        wcut_error error = {0};
        ck_assert_int_eq(wcut_setup_create(job, NULL, &setup, &error), WCUT_DEGENERATE);
        ck_assert(!setup);
        for (int w = 0; w < 3; w++)
            ck_assert_msg(strstr(error.text, bad[k].words[w]) != NULL, "%zu: \"%s\" is not in: %s", k, bad[k].words[w],
                          error.text);
        wcut_job_destroy(job);
    }
}

TEST(edges_within_the_tolerance_and_a_little_inside_are_cut) {
    for (int k = 0; k < 2; k++) {
        wcut_job *job = sample_job("freeform-1.json");
        job->stations = 61;
        const double by = k == 0 ? -0.05 : 5; /* beside the block, and in it */
        shift_edge(job->edge_a, vec3(by, 0, 0), 1);
        shift_edge(job->edge_b, vec3(-by, 0, 0), 1);
        wcut_history *h = run_of(job);
        ck_assert_int_eq(h->row[h->stations - 1].phase, WCUT_PHASE_LEFT);
        wcut_history_destroy(h);
        wcut_job_destroy(job);
    }
}

TEST(edges_that_the_job_lets_run_over_are_cut) {
    /* 50 mm before the entry: refused, but where the job says so */
    for (int allowed = 0; allowed < 2; allowed++) {
        wcut_job *job = sample_job("freeform-4.json");
        job->stations = 61;
        job->overrun = allowed ? 60 : 49;
        shift_edge(job->edge_a, vec3(0, -50, 0), 1);
        shift_edge(job->edge_b, vec3(0, -50, 0), 1);
        wcut_setup *setup = NULL;
        wcut_error error = {0};
        const wcut_status status = wcut_setup_create(job, NULL, &setup, &error);
        ck_assert_msg(status == (allowed ? WCUT_OK : WCUT_DEGENERATE), "%s", error.text);
        if (!allowed) ck_assert_ptr_nonnull(strstr(error.text, "50 mm outside"));
        wcut_setup_destroy(setup);
        wcut_job_destroy(job);
    }
}

TEST(a_plan_that_ends_early_is_cut_up_to_there_and_says_why) {
    wcut_job *job = sample_job("freeform-1.json");
    job->extra_count = 2;
    job->extra_u[0] = 0, job->extra_length[0] = 5, job->extra_u[1] = 0.5, job->extra_length[1] = 0;
    wcut_setup *setup = setup_of(job, NULL);
    wcut_history *h = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_setup_run(setup, NULL, NULL, &h, &error), WCUT_NOT_CONVERGED);
    ck_assert(h && h->stations > job->stations / 4 && h->stations < h->planned);
    ck_assert_msg(strstr(error.text, "extra_length_mm") && strcmp(error.text, h->ended.text) == 0, "%s", error.text);
    wcut_history_destroy(h);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
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
