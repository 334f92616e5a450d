/* Effects in whole cuts against closed forms: steady states under a changed law, a lag that runs out, a longer wire, a
   mount that gives, drag along the wire; neutral they are the plain model, bit for bit. labels: unit oracle property */
#include "base/random.h"
#include "cut/cuts.h"
#include "cut/system.h"
#include "foam/empirical.h"
#include "test.h"

static void give(wcut_job *job, int count, const wcut_effect *effect) {
    wcut_free(job->effect);
    job->effect = wcut_copy(effect, (size_t)count, sizeof *effect);
    ck_assert_ptr_nonnull(job->effect);
    job->effect_count = count;
}

static wcut_effect sized(wcut_effect_kind kind, double size) {
    wcut_effect e = wcut_effect_default(kind);
    e.value[0] = size;
    return e;
}

static bool acts_in_step(int kind) { return wcut_effect_view((wcut_effect_kind)kind)->place == WCUT_EFFECT_PLACE_STEP; }

/* largest difference of two runs in nodes [mm], speeds [mm/s] and tensions [N] */
static double difference_of(const wcut_history *a, const wcut_history *b) {
    double worst = shape_difference(a->stations * a->nodes, a->position, b->position);
    for (int j = 0; j < a->stations; j++) {
        worst = fmax(worst, fabs(a->row[j].speed_a - b->row[j].speed_a));
        worst = fmax(worst, fabs(a->row[j].tension_a - b->row[j].tension_a));
        worst = fmax(worst, fabs(a->row[j].tension_b - b->row[j].tension_b));
    }
    return worst;
}

TEST(at_its_neutral_value_each_is_the_plain_model_bit_for_bit_and_near_it_near_the_plain_model) {
    wcut_job *job = swinging_job(41, 40);
    wcut_history *plain = run_of(job);
    for (int k = 0; k < WCUT_EFFECT_COUNT; k++) {
        const wcut_effect neutral = wcut_effect_default((wcut_effect_kind)k);
        ck_assert(wcut_effect_is_neutral(&neutral));
        give(job, 1, &neutral);
        wcut_history *h = run_of(job);
        ck_assert_int_eq(memcmp(h->position, plain->position, sizeof *h->position * (size_t)(h->stations * h->nodes)),
                         0);
        ck_assert_int_eq(memcmp(h->tension, plain->tension, sizeof(double) * (size_t)(h->stations * (h->nodes - 1))),
                         0);
        ck_assert_double_eq(difference_of(h, plain), 0);
        wcut_history_destroy(h);
        if (!acts_in_step(k)) continue;
        wcut_effect near = neutral;
        near.value[0] = k == WCUT_EFFECT_MOUNT_COMPLIANCE   ? 1e9
                        : k == WCUT_EFFECT_SLICE_SOFTENING  ? 1e4
                        : k == WCUT_EFFECT_WIRE_THERMAL_LAG ? 1e-9
                                                            : neutral.value[0] + 1e-9;
        give(job, 1, &near);
        h = run_of(job);
        const double difference = difference_of(h, plain);
        ck_assert_msg(difference > 0 && difference < 1e-5, "%s: %g", wcut_effect_view((wcut_effect_kind)k)->name,
                      difference);
        wcut_history_destroy(h);
    }
    wcut_history_destroy(plain);
    wcut_job_destroy(job);
}

TEST(instrument_effects_change_no_physics) {
    wcut_job *job = straight_job(400, 60, 620, 41, 10, 200, 260);
    wcut_history *plain = run_of(job);
    const wcut_effect e[] = {sized(WCUT_EFFECT_TENSION_GAIN, 0.1), sized(WCUT_EFFECT_SCAN_SCALE, 1.01),
                             sized(WCUT_EFFECT_KERF_GROWTH, 1e-4)};
    give(job, 3, e);
    wcut_history *h = run_of(job);
    ck_assert_double_eq(difference_of(h, plain), 0);
    wcut_history_destroy(h);
    wcut_history_destroy(plain);
    wcut_job_destroy(job);
}

/* ---- tension held: steady speed of a straight feed ---- */

static wcut_job *steady_job(void) { return straight_job(400, 0, 450, 41, 200, 150, 900); }

static double last_speed(wcut_job *job, int count, const wcut_effect *effect) {
    give(job, count, effect);
    wcut_history *h = run_of(job);
    const wcut_history_row *last = &h->row[h->stations - 1];
    ck_assert_int_eq(last->condition, WCUT_CONDITION_TENSION);
    const double speed = last->speed_a;
    wcut_history_destroy(h);
    return speed;
}

TEST(the_steady_force_is_the_plain_one_so_speed_answers_every_change_of_the_law) {
    wcut_job *job = steady_job();
    const double a = job->force_law.a, bq = job->force_law.b * job->heat * 1000, v = last_speed(job, 0, NULL);
    const double force = a * exp(-bq / v); /* what the parabola needs, whatever the law is */

    wcut_effect e = sized(WCUT_EFFECT_RATE_DEPENDENCE, 0.3);
    double now = last_speed(job, 1, &e);
    ck_assert_double_eq_tol(a * exp(-bq / now) * pow(now / 10, 0.3), force, 1e-8 * force);
    ck_assert_double_lt(now, v);

    e = sized(WCUT_EFFECT_WIRE_FOULING, 0.25);
    e.value[1] = 20; /* [mm]: run out long ago */
    now = last_speed(job, 1, &e);
    ck_assert_double_eq_tol(1.25 * a * exp(-bq / now), force, 1e-8 * force);
    e.choice = 1;
    now = last_speed(job, 1, &e);
    ck_assert_double_eq_tol(a * exp(-1.25 * bq / now), force, 1e-8 * force);

    e = sized(WCUT_EFFECT_END_COOLING, 0.2);
    e.value[1] = 1e6; /* [mm]: the same all along the wire, but for 450/1e6 of it */
    now = last_speed(job, 1, &e);
    ck_assert_double_eq_tol(now, 0.6 * v, 1e-3 * v);

    e = sized(WCUT_EFFECT_AIR_OVERHEATING, 1.8);
    e.value[1] = 0.5; /* [s]: run out */
    ck_assert_double_eq_tol(last_speed(job, 1, &e), v, 1e-6 * v);
    e = sized(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.4); /* nothing changes any more: no lag */
    ck_assert_double_eq_tol(last_speed(job, 1, &e), v, 1e-6 * v);
    wcut_job_destroy(job);
}

static wcut_effect term_of(wcut_term term, double c, double shape0, double shape1) {
    wcut_effect e = wcut_effect_choose(WCUT_EFFECT_EMPIRICAL_FORCE, term);
    e.value[0] = c, e.value[WCUT_EMPIRICAL_FORCE_SHAPE] = shape0;
    if (shape1 != 0) e.value[WCUT_EMPIRICAL_FORCE_SHAPE + 1] = shape1;
    return e;
}

TEST(under_empirical_terms_the_steady_speed_answers_their_sum) {
    wcut_job *job = steady_job();
    const double a = job->force_law.a, bq = job->force_law.b * job->heat * 1000, v = last_speed(job, 0, NULL);
    const double force = a * exp(-bq / v);
    wcut_effect e[3] = {term_of(WCUT_TERM_LOG_SPEED, 0.3, 10, 0), term_of(WCUT_TERM_ORDER, 0.02, 5, 0),
                        term_of(WCUT_TERM_HEAT_INVERSE, 0.1, 3000, 0)};
    const double now = last_speed(job, 3, e);
    const double factor = 1 + 0.3 * log(now / 10) + 0.1 + 0.1 * (3000 * now / (1000 * job->heat) - 1);
    ck_assert_double_eq_tol(a * exp(-bq / now) * factor, force, 1e-8 * force);

    /* all nodes move along y; what time and memory did has run out */
    e[0] = term_of(WCUT_TERM_DIRECTION_Y, -0.2, 2, 0), e[1] = term_of(WCUT_TERM_SPEED_MEMORY, 0.5, 0.2, 0);
    e[2] = term_of(WCUT_TERM_WINDOW, 0.4, 0.5, 1.5);
    const double less = last_speed(job, 3, e);
    ck_assert_double_eq_tol(0.8 * a * exp(-bq / less), force, 1e-6 * force);
    wcut_job_destroy(job);
}

TEST(a_wave_in_the_block_stands_at_its_place_however_the_path_is_stepped) {
    /* crests of the force along the feed: the held tension turns them into troughs of the speed, one wavelength apart */
    const double wavelength = 80;
    double trough[2][2];
    for (int fine = 0; fine < 2; fine++) {
        wcut_job *job = straight_job(400, 0, 450, 41, fine ? 301 : 151, 150, 450);
        wcut_effect e = term_of(WCUT_TERM_WAVE_Y, 0.3, wavelength, 0);
        give(job, 1, &e);
        wcut_history *h = run_of(job);
        int found = 0;
        for (int j = h->stations / 4; j < h->stations - 1 && found < 2; j++)
            if (h->row[j].speed_a < h->row[j - 1].speed_a && h->row[j].speed_a < h->row[j + 1].speed_a)
                trough[fine][found++] = nodes_at(h, j)[0].y;
        ck_assert_int_eq(found, 2);
        ck_assert_double_eq_tol(trough[fine][1] - trough[fine][0], wavelength, fine ? 2 : 4);
        wcut_history_destroy(h);
        wcut_job_destroy(job);
    }
    ck_assert_double_eq_tol(trough[0][0], trough[1][0], 4);
}

TEST(a_gradient_is_a_linear_map_of_the_force_along_the_wire) {
    wcut_job *job = steady_job();
    const wcut_effect e = sized(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.3); /* along x */
    give(job, 1, &e);
    wcut_history *h = run_of(job);
    const int n = h->nodes, j = h->stations - 1;
    const wcut_vec3 *x = nodes_at(h, j), *was = nodes_at(h, j - 1);
    ck_assert_int_eq(h->row[j].substeps, 1);
    for (int i = 1; i < n - 1; i++) {
        const wcut_vec3 d = vec3_unit(vec3_sub(x[i], was[i])), t = vec3_unit(vec3_sub(x[i + 1], x[i - 1]));
        const double v = h->speed[(size_t)j * (size_t)n + (size_t)i],
                     line = h->force_line[(size_t)j * (size_t)n + (size_t)i];
        const double plain = wcut_force_law_eval(&job->force_law, job->heat, v) * vec3_length(vec3_cross(t, d));
        ck_assert_double_eq_tol(line / plain, 1 + 0.3 * (x[i].x / 400 - 0.5), 1e-9);
    }
    ck_assert_double_gt(h->row[j].alpha_b, h->row[j].alpha_a); /* denser at B: the wire trails more there */
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

/* ---- time-driven ---- */

static void drive(wcut_cut *cut, wcut_vec3 *a, wcut_vec3 *b, wcut_vec3 way, double duration, double heat,
                  wcut_station *s) {
    *a = vec3_add(*a, way), *b = vec3_add(*b, way);
    wcut_error error = {0};
    ck_assert_msg(wcut_cut_drive(cut, *a, *b, duration, heat, &error) == WCUT_OK, "%s", error.text);
    wcut_cut_view(cut, s);
}

TEST(after_a_heater_step_the_tension_follows_one_exponential_of_the_time_constant) {
    wcut_job *job = steady_job();
    const wcut_effect e = sized(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.6);
    give(job, 1, &e);
    wcut_setup *setup = setup_of(job, NULL);
    wcut_cut *cut;
    ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
    wcut_station s;
    wcut_vec3 a = job->mount_a[0], b = job->mount_b[0];
    const double v = 20, h = 0.05, h10 = e.value[2] + 10 * e.value[3], hv = e.value[2] + v * e.value[3];
    const double tau = 0.6 * h10 / hv;
    for (int k = 0; k < 700; k++) drive(cut, &a, &b, vec3(0, v * h, 0), h, 65, &s);
    const double steady = s.tension_a, beta = job->force_law.b * 1000 / v;
    for (int k = 1; k <= 40; k++) {
        drive(cut, &a, &b, vec3(0, v * h, 0), h, 58, &s);
        /* the set power is taken to change evenly over the first step */
        const double z = h / tau, q = 58 + 7 * expm1(z) / z * exp(-k * z);
        ck_assert_double_eq_tol(s.tension_a / steady, exp(-beta * (q - 65)), 2e-6);
    }
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

/* a nearly straight wire, drawn through the foam at an angle: steady tensions at both mounts, driven at 20 mm/s */
static void draw_aslant(const wcut_effect *effect, int count, double tension[2]) {
    wcut_job *job = straight_job(400, 10, hypot(420, 200) * 1.0005, 81, 2, 250, 260);
    for (int j = 0; j < 2; j++) job->mount_b[j].y += 200;
    give(job, count, effect);
    wcut_setup *setup = setup_of(job, NULL);
    wcut_cut *cut;
    ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
    wcut_station s;
    wcut_vec3 a = job->mount_a[0], b = job->mount_b[0];
    for (int k = 0; k < 80; k++) drive(cut, &a, &b, vec3(0, 2, 0), 0.1, 65, &s);
    tension[0] = s.tension_a, tension[1] = s.tension_b;
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

TEST(drag_adds_mu_times_what_presses_to_the_difference_of_the_tensions) {
    const double mu = 0.2, force = 0.1 * exp(-8.6e-4 * 65000 / 20), sine = 420 / hypot(420, 200);
    const wcut_effect e = sized(WCUT_EFFECT_TANGENTIAL_DRAG, mu);
    double plain[2], dragged[2];
    draw_aslant(NULL, 0, plain);
    draw_aslant(&e, 1, dragged);
    /* each mm of wire feels F sin(phi), of which sin(phi) presses, and mu times that along: over the foam F W sin mu */
    const double added = (dragged[1] - dragged[0]) - (plain[1] - plain[0]);
    const double expected = mu * force * 400 * sine;
    ck_assert_double_eq_tol(added, expected, 5e-3 * expected);
}

/* ---- wire and mounts that give ---- */

TEST(a_wire_that_heat_makes_longer_cuts_like_a_longer_wire) {
    wcut_job *job = steady_job();
    wcut_effect e = sized(WCUT_EFFECT_WIRE_ELONGATION, 0.004);
    e.value[1] = 1, e.value[2] = 1; /* all of it by heat, and alike in air */
    give(job, 1, &e);
    wcut_history *longer = run_of(job);
    give(job, 0, NULL);
    job->wire_length *= 1 + 0.004 * 65 / 60;
    wcut_history *plain = run_of(job);
    const int j = plain->stations - 1;
    ck_assert_double_lt(shape_difference(plain->nodes, nodes_at(plain, j), nodes_at(longer, j)), 1e-6);
    ck_assert_double_eq_tol(longer->row[j].speed_a, plain->row[j].speed_a, 1e-7);
    wcut_history_destroy(longer);
    wcut_history_destroy(plain);
    wcut_job_destroy(job);
}

TEST(a_wire_of_another_length_and_a_block_that_lies_elsewhere_are_a_job_that_says_so) {
    wcut_job *job = swinging_job(41, 40), *same = swinging_job(41, 40);
    wcut_effect e[2] = {sized(WCUT_EFFECT_WIRE_LENGTH, 1.5), sized(WCUT_EFFECT_BLOCK_SHIFT, 2)};
    e[1].value[1] = -3, e[1].value[2] = 0.5;
    give(job, 2, e);
    same->wire_length += 1.5;
    for (int j = 0; j < same->stations; j++) {
        same->mount_a[j] = vec3_sub(same->mount_a[j], vec3(2, -3, 0.5));
        same->mount_b[j] = vec3_sub(same->mount_b[j], vec3(2, -3, 0.5));
    }
    wcut_history *h = run_of(job), *expected = run_of(same);
    ck_assert_double_eq(difference_of(h, expected), 0);
    wcut_history_destroy(h);
    wcut_history_destroy(expected);

    // driven by the mounts' positions, too
    for (int k = 0; k < 2; k++) {
        wcut_setup *setup = NULL;
        wcut_cut *cut = NULL;
        wcut_station s[2];
        ck_assert_int_eq(wcut_setup_create(k ? same : job, NULL, &setup, NULL), WCUT_OK);
        ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
        const wcut_job *from = k ? same : job;
        ck_assert_int_eq(wcut_cut_drive(cut, from->mount_a[1], from->mount_b[1], 0.5, 60, NULL), WCUT_OK);
        wcut_cut_view(cut, &s[k]);
        const wcut_vec3 there = vec3_sub(job->mount_a[1], vec3(2, -3, 0.5));
        ck_assert_double_lt(vec3_distance(s[k].mount_a, there), 1e-12);
        wcut_cut_destroy(cut);
        wcut_setup_destroy(setup);
    }
    wcut_job_destroy(job);
    wcut_job_destroy(same);
}

TEST(every_edge_is_as_much_longer_as_its_tension_stretches_it) {
    wcut_job *job = steady_job();
    wcut_effect e = sized(WCUT_EFFECT_WIRE_ELONGATION, 0.002);
    e.value[1] = 0; /* all of it by tension: EA = 1000 N */
    give(job, 1, &e);
    wcut_history *h = run_of(job);
    const int n = h->nodes, j = h->stations - 1;
    for (int k = 0; k < n - 1; k++) {
        const double length = vec3_distance(nodes_at(h, j)[k], nodes_at(h, j)[k + 1]);
        ck_assert_double_eq_tol(length / (450.0 / (n - 1)), 1 + tensions_at(h, j)[k] / 1000, 1e-9);
    }
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(mounts_that_give_stand_where_their_springs_hold_the_wire) {
    wcut_job *job = straight_job(400, 40, 560, 41, 200, 150, 900);
    const wcut_effect e = sized(WCUT_EFFECT_MOUNT_COMPLIANCE, 0.8);
    give(job, 1, &e);
    wcut_history *giving = run_of(job);
    const int n = giving->nodes, j = giving->stations - 1;
    const wcut_vec3 *x = nodes_at(giving, j);
    const wcut_vec3 pull = vec3_scale(tensions_at(giving, j)[0], vec3_unit(vec3_sub(x[1], x[0])));
    const wcut_vec3 offset = vec3_sub(x[0], job->mount_a[j]);
    ck_assert_double_lt(vec3_distance(vec3_scale(0.8, offset), pull), 1e-6);

    /* what a robot is told, and what a recording says, are the mounts, not the ends of the wire */
    wcut_setup *setup = setup_of(job, NULL);
    wcut_vec3 a[200], b[200];
    double length = 999;
    ck_assert_int_eq(wcut_history_path(setup, giving, a, b, &length, NULL), WCUT_OK);
    ck_assert_int_eq(memcmp(a, job->mount_a, sizeof a), 0);
    ck_assert_int_eq(memcmp(b, job->mount_b, sizeof b), 0);
    ck_assert_double_eq(length, 560);
    giving->stations++; /* of another setup, it seems */
    ck_assert_int_eq(wcut_history_path(setup, giving, a, b, &length, NULL), WCUT_BAD_ARGUMENT);
    giving->stations--;
    wcut_cut *cut;
    ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
    for (int k = 0; k < 20; k++) ck_assert_int_eq(wcut_cut_step(cut, NULL), WCUT_OK);
    wcut_station s;
    wcut_cut_view(cut, &s);
    ck_assert_double_eq(vec3_distance(s.mount_a, job->mount_a[20]), 0);
    ck_assert_double_eq(vec3_distance(s.mount_b, job->mount_b[20]), 0);
    ck_assert_double_gt(vec3_distance(s.mount_b, s.position[s.nodes - 1]), 0.1);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);

    give(job, 0, NULL); /* the same as rigid mounts that are led there */
    for (int k = 0; k < job->stations; k++) job->mount_a[k].x += offset.x, job->mount_b[k].x -= offset.x;
    wcut_history *rigid = run_of(job);
    ck_assert_double_eq_tol(giving->row[j].alpha_a, rigid->row[j].alpha_a, 1e-7);
    ck_assert_double_eq_tol(giving->row[j].alpha_b, rigid->row[j].alpha_b, 1e-7);
    ck_assert_double_eq_tol(giving->row[j].speed_a, rigid->row[j].speed_a, 1e-5);
    ck_assert_int_eq(n, rigid->nodes);
    wcut_history_destroy(giving);
    wcut_history_destroy(rigid);
    wcut_job_destroy(job);
}

TEST(one_mount_gives_or_both_along_the_feed) {
    wcut_job *job = straight_job(400, 40, 560, 41, 200, 150, 900);
    wcut_effect e = sized(WCUT_EFFECT_MOUNT_COMPLIANCE, 0.8);
    for (e.choice = 1; e.choice < 4; e.choice++) {
        give(job, 1, &e);
        wcut_history *h = run_of(job);
        const int j = h->stations - 1, last = h->nodes - 1;
        const wcut_vec3 *x = nodes_at(h, j);
        const double *s = tensions_at(h, j);
        const wcut_vec3 offset[2] = {vec3_sub(x[0], job->mount_a[j]), vec3_sub(x[last], job->mount_b[j])};
        const wcut_vec3 pull[2] = {vec3_scale(s[0], vec3_unit(vec3_sub(x[1], x[0]))),
                                   vec3_scale(s[last - 1], vec3_unit(vec3_sub(x[last - 1], x[last])))};

        /* a spring holds what pulls at it, and nothing else moves */
        for (int m = 0; m < 2; m++) {
            wcut_vec3 held = e.choice == 3 ? vec3(0, pull[m].y, 0) : pull[m];
            if (e.choice != 3 && e.choice != m + 1) held = vec3(0, 0, 0);
            ck_assert_double_lt(vec3_distance(vec3_scale(0.8, offset[m]), held), 1e-6);
        }
        wcut_history_destroy(h);
    }
    wcut_job_destroy(job);
}

TEST(a_mount_settles_as_one_exponential_however_it_is_stepped) {
    /* a pull of 2 N along a wire so long that its direction stays */
    const double far = 1e9, k = 0.5, tau = 0.3;
    for (int steps = 1; steps <= 81; steps *= 9) {
        wcut_compliance y = {
            .give = {{1 / k, 1 / k, 1 / k}}, .settling = tau, .mount = {{.pull = {2, 0, 0}, .set = true}}};
        for (int i = 0; i < steps; i++)
            y.mount[0].offset = wcut_compliance_end(&y, 0, vec3(far, 0, 0), 2, far, 0, steps / 0.45).at;
        ck_assert_double_eq_tol(y.mount[0].offset.x, 2 / k * (1 - exp(-0.45 / tau)), 1e-7);
    }
}

/* ---- the solver ---- */

enum { N = 9, SIZE = 4 * N - 7 };

TEST(jacobian_and_borders_hold_where_wire_and_mounts_give) {
    wcut_random random = wcut_random_seed(5);
    const wcut_foam foam = {.law = {0.1, 8.6e-4}, .block = {.size = {40, 600, 300}, .depth = 2}};
    double rest[N - 1], worst = 0;
    static double given[SIZE][SIZE], border[SIZE], by_rate[SIZE], high[SIZE];
    for (int trial = 0; trial < 20; trial++) {
        wcut_system y;
        ck_assert(wcut_system_create(N, &y));
        wcut_vec3 x[N], was[N];
        double s[N - 1], log_rate = 1 + wcut_random_uniform(&random);
        for (int i = 0; i < N; i++) {
            x[i] = vec3(-8 + 7 * i, 2 - 0.2 * i * (N - 1 - i) + wcut_random_uniform(&random), 150 + i * 0.3);
            was[i] = vec3_sub(x[i], vec3(wcut_random_uniform(&random) - 0.5, 3, wcut_random_uniform(&random) - 0.5));
            if (i < N - 1) s[i] = 1.5 + wcut_random_uniform(&random), rest[i] = 7.2 * (1 + 0.01 * i);
        }
        const wcut_compliance give_way = {
            .rest = rest,
            .softness = 0.003,
            .give = {{0.7, 0.3, 0.5}, {0, 0.9, 0}},
            .settling = 0.3,
            .mount = {{x[0], {0.4, 0.1, 0.2}, {1, 0.5, 0}, true}, {x[N - 1], {-0.3, 0.1, 0}, {-1, 0.4, 0.1}, true}}};
        const wcut_step step = {
            .foam = &foam, .heat = 65, .tension = 2, .edge = 7.2, .n = N, .was = was, .compliance = &give_way};
        wcut_system_place_ends(&step, s, log_rate, x);
        wcut_system_eval(&y, &step, x, s, log_rate, true);
        for (int i = 0; i < SIZE; i++) {
            for (int j = 0; j < SIZE; j++) given[i][j] = abs(i - j) <= 6 ? *banded_at(&y.jacobian, i, j) : 0;
            border[i] = y.border[i], by_rate[i] = y.by_log_rate[i];
        }
        const double by_rate_condition = y.condition_by_log_rate, h = 1e-6;
        for (int j = 0; j <= SIZE; j++) {
            double *unknown = j == SIZE    ? &log_rate
                              : j % 4 == 0 ? &s[j / 4]
                                           : &x[j / 4 + 1].x + (j - 1) % 4,
                   at = *unknown;
            *unknown = at + h;
            wcut_system_place_ends(&step, s, log_rate, x);
            wcut_system_eval(&y, &step, x, s, log_rate, false);
            memcpy(high, y.residual, sizeof high);
            const double condition = y.condition;
            *unknown = at - h;
            wcut_system_place_ends(&step, s, log_rate, x);
            wcut_system_eval(&y, &step, x, s, log_rate, false);
            *unknown = at;
            for (int i = 0; i < SIZE; i++)
                worst = fmax(worst, fabs((high[i] - y.residual[i]) / (2 * h) - (j < SIZE ? given[i][j] : by_rate[i])));
            worst = fmax(worst, fabs((condition - y.condition) / (2 * h) - (j < SIZE ? border[j] : by_rate_condition)));
        }
        wcut_system_destroy(&y);
    }
    ck_assert_double_lt(worst, 5e-8);
}

TEST(all_of_them_together_converge_in_few_iterations) {
    wcut_job *job = swinging_job(61, 150);
    wcut_history *plain = run_of(job);
    wcut_effect e[WCUT_EFFECT_COUNT];
    int count = 0;
    for (int k = 0; k < WCUT_EFFECT_COUNT; k++) {
        if (!acts_in_step(k)) continue;
        const wcut_effect_parameter *p = wcut_effect_view((wcut_effect_kind)k)->parameter;
        e[count++] = sized((wcut_effect_kind)k, p->low > 0 ? 1.5 * p->low : p->high / 3);
    }
    give(job, count, e);
    wcut_history *h = run_of(job);
    int iterations[2] = {0, 0};
    for (int j = 1; j < h->stations; j++) {
        iterations[0] += plain->row[j].iterations, iterations[1] += h->row[j].iterations;
        ck_assert_double_lt(h->row[j].residual, 1e-10);
    }
    ck_assert_msg(iterations[1] <= 2 * iterations[0], "%d against %d", iterations[1], iterations[0]);
    wcut_history_destroy(plain);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(what_cannot_be_simulated_is_refused_with_its_place) {
    wcut_job *job = steady_job();
    wcut_effect e[2] = {sized(WCUT_EFFECT_RATE_DEPENDENCE, 0.1), sized(WCUT_EFFECT_RATE_DEPENDENCE, 0.2)};
    wcut_setup *setup = NULL;
    wcut_error error = {0};
    give(job, 2, e);
    ck_assert_int_eq(wcut_setup_create(job, NULL, &setup, &error), WCUT_BAD_ARGUMENT);
    ck_assert_str_eq(error.text, "effects[1]: found a second rate_dependence, expected one at most");
    give(job, 1, e);
    wcut_cut_options heun = wcut_cut_options_default();
    heun.integrator = WCUT_INTEGRATOR_HEUN;
    ck_assert_int_eq(wcut_setup_create(job, &heun, &setup, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "effects[0]: found rate_dependence with the integrator heun"));
    e[0] = sized(WCUT_EFFECT_TENSION_GAIN, 0.1); /* no physics: heun does not mind */
    give(job, 1, e);
    ck_assert_int_eq(wcut_setup_create(job, &heun, &setup, &error), WCUT_OK);
    wcut_setup_destroy(setup);
    e[0] = sized(WCUT_EFFECT_WIRE_THERMAL_LAG, NAN);
    give(job, 1, e);
    ck_assert_int_eq(wcut_setup_create(job, NULL, &setup, &error), WCUT_BAD_ARGUMENT);
    e[0] = (wcut_effect){.kind = WCUT_EFFECT_COUNT};
    give(job, 1, e);
    ck_assert_int_eq(wcut_setup_create(job, NULL, &setup, &error), WCUT_BAD_ARGUMENT);
    e[0] = sized(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.1);
    e[0].choice = 12;
    give(job, 1, e);
    ck_assert_int_eq(wcut_setup_create(job, NULL, &setup, &error), WCUT_BAD_ARGUMENT);
    wcut_job_destroy(job);

    job = sample_job("freeform-1.json"); /* a design */
    e[0] = sized(WCUT_EFFECT_MOUNT_COMPLIANCE, 1);
    give(job, 1, e);
    job->stations = 31;
    wcut_history *h = run_of(job); /* its path is cut between mounts as any other */
    e[0] = sized(WCUT_EFFECT_MOUNT_COMPLIANCE, 2);
    give(job, 1, e);
    wcut_history *g = run_of(job);
    ck_assert_double_gt(shape_difference(h->nodes, nodes_at(h, 20), nodes_at(g, 20)), 0.01);
    wcut_history_destroy(h);
    wcut_history_destroy(g);
    wcut_job_destroy(job);
}

TEST(names_are_found_and_unknown_ones_are_not) {
    wcut_effect_kind kind = WCUT_EFFECT_COUNT;
    for (int k = 0; k < WCUT_EFFECT_COUNT; k++) {
        const wcut_effect_info *info = wcut_effect_view((wcut_effect_kind)k);
        ck_assert_int_eq(wcut_effect_locate(info->name, &kind), WCUT_OK);
        ck_assert_int_eq(kind, k);
        for (int choice = 0; choice == 0 || (info->choice && info->choice[choice]); choice++) {
            const wcut_effect e = wcut_effect_choose((wcut_effect_kind)k, choice);
            int used = 0;
            for (const wcut_effect_parameter *p = wcut_effect_parameters(&e); p->key; p++) {
                ck_assert_int_ge(p->at, used);
                used = p->at + p->size;
                ck_assert(p->min <= p->low && p->low < p->high && p->high <= p->max);
                ck_assert(p->initial >= p->min && p->initial <= p->max);
                for (int c = 0; c < p->size; c++) ck_assert_double_eq(e.value[p->at + c], p->initial);
            }
            ck_assert_int_le(used, WCUT_EFFECT_VALUES);
        }
        const wcut_effect none = {.kind = (wcut_effect_kind)k, .choice = 99};
        ck_assert_ptr_null(wcut_effect_parameters(&none));
    }
    kind = WCUT_EFFECT_COUNT;
    ck_assert_int_eq(wcut_effect_locate("gravity", &kind), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_effect_locate(NULL, &kind), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(kind, WCUT_EFFECT_COUNT);
    ck_assert_ptr_null(wcut_effect_view(WCUT_EFFECT_COUNT));
}
