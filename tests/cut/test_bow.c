/* A taut wire between the ends of an elastic frame: parabola, path mode as its limit, energy, bad input.
   labels: unit property oracle */
#include "cuts.h"

/* a bow of D mm whose ends run along the block's sides, all of the wire in foam from `first` on; a 0.4 mm NiCr wire */
static wcut_job *bow_job(double distance, int nodes, int stations, double first, double last, double feed) {
    wcut_job *job = straight_job(distance, 0, 0, nodes, stations, first, last);
    job->wire_diameter = 0.4;
    job->wire_material = wcut_copy_text("NiCr 80/20");
    job->heat = 90;
    job->tension = 0;
    job->rig =
        (wcut_rig){.kind = WCUT_RIG_KIND_BOW, .pretension = 30, .stiffness = 8, .wire_stiffness = 0, .expansion = 0};
    job->feed = (wcut_feed){WCUT_FEED_KIND_CONSTANT, 1, wcut_copy(&feed, 1, sizeof feed), NULL};
    ck_assert(job->wire_material && job->feed.speed);
    return job;
}

static double stiffness_of_wire(const wcut_job *job) {
    return 220e3 * WCUT_PI / 4 * job->wire_diameter * job->wire_diameter;
}

/* the largest distance of a station's nodes from the straight line between its ends */
static double bow_of(const wcut_history *h, int j) {
    const wcut_vec3 *x = nodes_at(h, j), a = x[0], along = vec3_unit(vec3_sub(x[h->nodes - 1], a));
    double largest = 0;
    for (int i = 0; i < h->nodes; i++) largest = fmax(largest, vec3_length(vec3_cross(vec3_sub(x[i], a), along)));
    return largest;
}

/* ---- the closed form: y = F0 / H x^2 / 2 ---- */

typedef struct parabola {
    double pull, sag, tension, closing; /* H, at the middle, at the ends, u */
} parabola;

/* length of the cold wire without tension that hangs so: ds / (1 + S / EA), by Simpson's rule */
static double natural_length(double load, double pull, double chord, double stiffness) {
    enum { N = 2000 };
    double sum = 0;
    for (int k = 0; k <= N; k++) {
        const double x = chord * ((double)k / N - 0.5), slope = load / pull * x, ds = sqrt(1 + slope * slope);
        sum += (k == 0 || k == N ? 1 : k % 2 ? 4 : 2) * ds / (1 + pull * ds / stiffness);
    }
    return sum * chord / (3 * N);
}

/* the pull H at which the frame, closed by u = (H - P) / k_b, holds the natural length of the wire */
static parabola solve_parabola(const wcut_job *job, double load) {
    const double distance = vec3_distance(job->mount_a[0], job->mount_b[0]), stiffness = stiffness_of_wire(job);
    const double natural = distance / (1 + job->rig.pretension / stiffness);
    double low = 0.1, high = 1e4;
    for (int k = 0; k < 200; k++) {
        const double pull = (low + high) / 2, chord = distance - (pull - job->rig.pretension) / job->rig.stiffness;
        if (chord > 0 && natural_length(load, pull, chord, stiffness) > natural)
            low = pull;
        else
            high = pull;
    }
    const double chord = distance - (low - job->rig.pretension) / job->rig.stiffness, turn = load / low;
    return (parabola){low, turn * chord * chord / 8, low * hypot(1, turn * chord / 2),
                      (low - job->rig.pretension) / job->rig.stiffness};
}

/* Errors of sag, end tension and pull of the frame at the last, steady station, relative to the closed form. */
static void errors_at(int nodes, double error[3]) {
    wcut_job *job = bow_job(400, nodes, 31, 300, 900, 28);
    wcut_history *h = run_of(job);
    const int j = h->stations - 1;
    const parabola p = solve_parabola(job, wcut_force_law_eval(&job->force_law, job->heat, 28));
    const wcut_vec3 *x = nodes_at(h, j);
    error[0] = fabs(bow_of(h, j) / p.sag - 1);
    error[1] = fabs(h->row[j].tension_a / p.tension - 1);
    error[2] = fabs(400 - vec3_distance(x[0], x[nodes - 1]) - p.closing) * job->rig.stiffness / p.pull;
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(under_an_even_load_the_wire_is_the_parabola_of_the_elastic_frame_to_second_order) {
    double coarse[3], fine[3], finest[3];
    errors_at(51, coarse);
    errors_at(101, fine);
    errors_at(201, finest);
    for (int k = 0; k < 3; k++) {
        ck_assert_msg(finest[k] < 1e-6, "figure %d: relative error %g", k, finest[k]);
        ck_assert_double_eq_tol((coarse[k] - fine[k]) / (fine[k] - finest[k]), 4, 0.1);
    }
}

TEST(a_rigid_bow_with_the_length_given_is_path_mode_with_the_same_feed) {
    for (int slack = 0; slack < 2; slack++) {
        wcut_job *job = straight_job(400, 60, slack ? 620 : 521, 61, 120, slack ? 200 : -30, slack ? 800 : 500);
        const double feed = 12;
        job->feed = (wcut_feed){WCUT_FEED_KIND_CONSTANT, 1, wcut_copy(&feed, 1, sizeof feed), NULL};
        wcut_history *path = run_of(job);
        job->rig = (wcut_rig){.kind = WCUT_RIG_KIND_BOW,
                              .pretension = 0,
                              .stiffness = INFINITY,
                              .wire_stiffness = INFINITY,
                              .expansion = 0};
        wcut_history *bow = run_of(job);
        for (int j = 0; j < path->stations; j++) {
            ck_assert_double_lt(shape_difference(61, nodes_at(path, j), nodes_at(bow, j)), 1e-9);
            ck_assert_double_eq_tol(bow->row[j].tension_a, path->row[j].tension_a, 1e-9 * job->tension);
            ck_assert_double_eq_tol(bow->row[j].time, path->row[j].time, 1e-9);
        }
        wcut_history_destroy(path);
        wcut_history_destroy(bow);
        wcut_job_destroy(job);
    }
}

TEST(before_the_foam_the_wire_is_straight_with_its_pretension_and_behind_it_again) {
    wcut_job *job = straight_job(300, 50, 0, 41, 160, -20, 60);
    const double feed = 40;
    job->block_size.y = 40;
    job->wire_diameter = 0.4;
    job->wire_material = wcut_copy_text("NiCr");
    job->rig =
        (wcut_rig){.kind = WCUT_RIG_KIND_BOW, .pretension = 30, .stiffness = 8, .wire_stiffness = 0, .expansion = 0};
    job->feed = (wcut_feed){WCUT_FEED_KIND_CONSTANT, 1, wcut_copy(&feed, 1, sizeof feed), NULL};
    wcut_history *h = run_of(job);
    const int last = h->stations - 1;
    ck_assert_double_eq_tol(h->row[0].tension_a, 30, 1e-9);
    ck_assert_double_eq_tol(h->row[last].tension_a, 30, 1e-9);
    ck_assert_double_lt(bow_of(h, 0), 1e-9);
    ck_assert_double_lt(bow_of(h, last), 1e-9);
    ck_assert_int_eq(h->row[last].phase, WCUT_PHASE_LEFT);

    /* in the foam it bows, and goes on from station to station when its chord has left the foam (station 120); the last
       100 mm of the bow spring out at once: F never exceeds a */
    double largest = 0;
    for (int j = 1; j <= last; j++) {
        largest = fmax(largest, bow_of(h, j));
        if (j < 140) ck_assert_double_lt(fabs(bow_of(h, j) - bow_of(h, j - 1)), 0.6);
    }
    ck_assert_double_gt(largest, 10);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(heat_makes_the_wire_longer_and_takes_tension_from_it) {
    wcut_job *job = bow_job(400, 41, 25, 300, 420, 40);
    wcut_history *cold = run_of(job);
    job->rig.expansion = 15e-6;
    wcut_history *warm = run_of(job);
    const int j = cold->stations - 1;
    ck_assert_double_lt(warm->row[j].tension_a, cold->row[j].tension_a);
    ck_assert_double_gt(bow_of(warm, j), bow_of(cold, j));
    wcut_history_destroy(cold);
    wcut_history_destroy(warm);
    wcut_job_destroy(job);
}

/* Over a step the work of the mounts is what the foam takes and what wire and frame store: as virtual work exactly, as
   energy to second order in the step. */
TEST(what_the_arm_does_goes_into_foam_wire_and_frame) {
    double gap[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        wcut_job *job = bow_job(400, 41, k ? 161 : 81, 290, 330, 40);
        wcut_history *h = run_of(job);
        const double stiffness = stiffness_of_wire(job), rest = 400 / (1 + 30 / stiffness) / 40;
        double arm = 0, foam = 0, stored[2] = {0, 0}, exact = 0;
        for (int j = 1; j < h->stations; j++) {
            /* the foam against the way of the nodes; the sum of all is the force on the arm, which moves along y */
            const wcut_vec3 *x = nodes_at(h, j), *was = nodes_at(h, j - 1), *f = h->force + (size_t)j * 41;
            const double *s = h->tension + (size_t)j * 40, *before = s - 40;
            double taken = 0, pulled = 0, strain = 0;
            for (int i = 0; i < 41; i++) {
                const bool end = i == 0 || i == 40; /* along the chord the frame feels the edges alone */
                taken -= vec3_dot(f[i], vec3_sub(x[i], was[i])) - (end ? f[i].x * (x[i].x - was[i].x) : 0);
                pulled -= f[i].y * (job->mount_a[j].y - job->mount_a[j - 1].y);
            }

            /* tensions over the change of the edges, and the frame's spring over its closing */
            for (int e = 0; e < 40; e++)
                strain += s[e] * vec3_dot(vec3_unit(vec3_sub(x[e + 1], x[e])),
                                          vec3_sub(vec3_sub(x[e + 1], x[e]), vec3_sub(was[e + 1], was[e])));
            const double u = 400 - vec3_distance(x[0], x[40]), u_before = 400 - vec3_distance(was[0], was[40]);
            strain += (30 + 8 * u) * (u - u_before);
            exact = fmax(exact, fabs(pulled - taken - strain));
            arm += pulled, foam += taken;

            /* energies at both ends of the run */
            for (int end = 0; end < 2; end++) {
                if (end == 0 ? j != 1 : j != h->stations - 1) continue;
                const double *t = end == 0 ? before : s, c = end == 0 ? u_before : u;
                for (int e = 0; e < 40; e++) stored[end] += t[e] * t[e] / (2 * stiffness) * rest;
                stored[end] += 30 * c + 4 * c * c;
            }
        }
        ck_assert_double_lt(exact, 1e-9 * arm);
        gap[k] = fabs(arm - foam - (stored[1] - stored[0])) / arm;
        wcut_history_destroy(h);
        wcut_job_destroy(job);
    }
    ck_assert_msg(gap[1] < 2e-3 && gap[1] < 0.6 * gap[0], "%g, %g", gap[0], gap[1]);
}

/* ---- bad input ---- */

static void refused(wcut_job *job, const char *line) {
    wcut_setup *setup = NULL;
    wcut_error error = {0};
    ck_assert_int_ne(wcut_setup_create(job, NULL, &setup, &error), WCUT_OK);
    ck_assert_ptr_null(setup);
    ck_assert_msg(strstr(error.text, line) != NULL, "%s\n  expected: %s", error.text, line);
    wcut_job_destroy(job);
}

TEST(what_no_bow_can_be_is_refused_with_the_number) {
    wcut_job *job = bow_job(400, 21, 5, -10, 30, 10);
    job->rig.stiffness = 0.07;
    refused(
        job,
        "rig.stiffness_N_per_mm: found 0.07, expected more than 0.075: a frame whose ends are 400 mm apart buckles");
    job = bow_job(400, 21, 5, -10, 30, 10);
    job->rig.pretension = 120;
    refused(job, "rig.pretension_N: found 120, expected at most 101.8 N");
    job = bow_job(400, 21, 5, -10, 30, 10);
    job->mount_b[3].x += 1;
    refused(job, "station 3: found the mounts 401 mm apart, expected 400 mm as at station 0");
    job = bow_job(400, 21, 5, -10, 30, 10);
    job->rig = (wcut_rig){
        .kind = WCUT_RIG_KIND_BOW, .pretension = 0, .stiffness = INFINITY, .wire_stiffness = INFINITY, .expansion = 0};
    job->wire_length = 399;
    refused(job, "wire.length_mm: found 399, expected at least 400: neither frame nor wire gives");
    job = bow_job(400, 21, 5, -10, 30, 10);
    job->wire_density = 8300;
    refused(job, "wire.density_kg_per_m3: found 8300 with the rig bow");
    job = bow_job(400, 21, 5, -10, 30, 10);
    job->effect = wcut_alloc(1, sizeof *job->effect), job->effect_count = 1;
    job->effect[0] = wcut_effect_default(WCUT_EFFECT_WIRE_ELONGATION);
    job->effect[0].value[WCUT_WIRE_ELONGATION_STRAIN] = 0.003;
    refused(job, "effects[0]: found wire_elongation with the rig bow");
    job = bow_job(400, 21, 5, -10, 30, 10);
    job->feed.speed[0] = 400;
    refused(job, "feed: speed 0: found 400 mm/s, expected the limits' 0.1 to 100 mm/s");
}
