/* The steady state of the whole model against its closed form, a parabola and straight ends; orders of convergence in
   nodes and stations. labels: unit oracle */
#include "cut/cuts.h"
#include "test.h"

/* A straight feed, width w in the foam, wire length s, mounts `beside` mm beside the block on both sides. */
typedef struct steady {
    double c;     /* [1/mm] y = c x^2 / 2 over the foam */
    double slope; /* [1] at the faces, and of the straight ends */
    double sag;   /* [mm] of the middle behind the mounts */
    double speed; /* [mm/s] */
} steady;

static double length_of(double c, double width, double beside) {
    const double p = c * width / 2;
    return (p * hypot(1, p) + asinh(p)) / c + 2 * beside * hypot(1, p);
}

static steady steady_of(const wcut_job *job) {
    const double w = job->block_size.x, beside = -job->mount_a[0].x;
    double low = 1e-9, high = 1;
    for (int k = 0; k < 200; k++) {
        const double middle = (low + high) / 2;
        if (length_of(middle, w, beside) > job->wire_length)
            high = middle;
        else
            low = middle;
    }
    steady s = {.c = low, .slope = low * w / 2};
    s.sag = low * w * w / 8 + beside * s.slope;
    const double horizontal = job->tension / hypot(1, s.slope);
    s.speed = job->force_law.b * job->heat * 1000 / log(job->force_law.a / (s.c * horizontal));
    return s;
}

/* the example of the model: the whole chord of 400 mm in the foam, 450 mm of wire, 60 W/m */
static wcut_job *example_job(int nodes, int stations) {
    wcut_job *job = straight_job(400, 0, 450, nodes, stations, 150, 1190);
    job->heat = 60;
    job->force_law = (wcut_force_law){.a = 0.02, .b = 1.2e-3};
    return job;
}

typedef struct answer {
    double sag, speed, alpha;
} answer;

static answer last_of(const wcut_history *h) {
    const int j = h->stations - 1;
    const wcut_vec3 *x = nodes_at(h, j);
    return (answer){x[0].y - x[h->nodes / 2].y, h->row[j].speed_a, h->row[j].alpha_a};
}

static answer answer_of(wcut_job *job) {
    wcut_history *h = run_of(job);
    const answer a = last_of(h);
    ck_assert_int_eq(h->row[h->stations - 1].condition, WCUT_CONDITION_TENSION);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
    return a;
}

TEST(the_example_of_the_model_has_its_sag_and_speed_at_200_nodes) {
    wcut_job *job = example_job(201, 400);
    const steady s = steady_of(job);
    ck_assert_double_eq_tol(s.sag, 91.1828, 5e-5);
    ck_assert_double_eq_tol(s.speed, 66.1765, 5e-5);
    const answer a = answer_of(job);
    ck_assert_double_eq_tol(a.sag, s.sag, 1e-4 * s.sag);
    ck_assert_double_eq_tol(a.speed, s.speed, 1e-4 * s.speed);
    ck_assert_double_eq_tol(a.alpha, atan(s.slope), 1e-2); /* the first edge is half an edge from the mount */
}

TEST(sag_and_speed_tend_to_the_closed_form_with_order_two_in_the_nodes) {
    answer before = {0};
    for (int n = 21; n <= 161; n = 2 * n - 1) {
        wcut_job *job = example_job(n, 300);
        const steady s = steady_of(job);
        answer a = answer_of(job);
        a.sag = fabs(a.sag - s.sag), a.speed = fabs(a.speed - s.speed);
        if (before.sag > 0) {
            ck_assert_double_eq_tol(log2(before.sag / a.sag), 2, 0.15);
            ck_assert_double_eq_tol(log2(before.speed / a.speed), 2, 0.15);
        }
        before = a;
    }
}

TEST(beside_a_block_narrower_than_the_chord_the_wire_is_straight_along_the_end_tangents) {
    wcut_job *job = straight_job(400, 60, 620, 201, 300, 250, 1190);
    const steady s = steady_of(job);
    wcut_history *h = run_of(job);
    const int j = h->stations - 1;
    const wcut_vec3 *x = nodes_at(h, j);
    const double edge = job->wire_length / (h->nodes - 1);
    double straight = 0, parabola = 0;
    for (int i = 0; i < h->nodes; i++) {
        const double out = fmax(0, fmax(-x[i].x, x[i].x - 400)), across = clamp(x[i].x, 0, 400) - 200;
        const double expected = s.sag - s.c * across * across / 2 - s.slope * out;
        const double error = fabs(x[0].y - x[i].y - expected);
        if (out > edge) straight = fmax(straight, error);
        if (out == 0) parabola = fmax(parabola, error);
        if (out > 2 * edge && i > 0 && i < h->nodes - 1) { /* free of load: two edges are one line */
            const wcut_vec3 bend = vec3_add_scaled(vec3_add(x[i - 1], x[i + 1]), -2, x[i]);
            ck_assert_double_lt(vec3_length(bend), 1e-8);
        }
        ck_assert_double_eq_tol(x[i].z, 150, 1e-9);
    }
    ck_assert_double_lt(straight, 0.02);
    ck_assert_double_lt(parabola, 0.02);
    ck_assert_double_eq_tol(h->row[j].alpha_a, atan(s.slope), 1e-4);
    ck_assert_double_eq_tol(h->row[j].alpha_b, atan(s.slope), 1e-4);
    ck_assert_double_eq_tol(h->row[j].beta_a, 0, 1e-9);
    ck_assert_double_eq_tol(h->row[j].speed_a, s.speed, 1e-4 * s.speed);
    ck_assert_double_eq_tol(h->row[j].tension_a, 2, 1e-9);
    ck_assert_double_eq_tol(h->row[j].tension_b, 2, 1e-9);
    ck_assert_int_eq(h->row[j].phase, WCUT_PHASE_STEADY);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(where_nothing_is_steady_angle_and_time_converge_with_order_one_in_the_stations) {
    double alpha[6], beta[6], time[6];
    int k = 0;
    for (int m = 65; m <= 513; m = 2 * m - 1, k++) {
        wcut_job *job = swinging_job(31, m);
        wcut_history *h = run_of(job);
        alpha[k] = h->row[m - 1].alpha_a, beta[k] = h->row[m - 1].beta_b, time[k] = h->row[m - 1].time;
        wcut_history_destroy(h);
        wcut_job_destroy(job);
        if (k < 2) continue;
        const double *each[] = {alpha, beta, time};
        for (int c = 0; c < 3; c++) {
            const double order = log2(fabs((each[c][k - 1] - each[c][k - 2]) / (each[c][k] - each[c][k - 1])));
            ck_assert_double_eq_tol(order, 1, 0.1);
        }
    }
}
