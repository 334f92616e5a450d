/* The foam's force on a node against (3) by hand, and its derivatives against central differences. */

#include "base/numbers.h"
#include "base/random.h"
#include "foam/resistance.h"
#include "test.h"

enum { N = 5 };

static const wcut_foam foam = {.law = {0.1, 8.6e-4}, .block = {.size = {400, 600, 300}, .depth = 0.15}};
static const double heat = 65, edge = 5;

static wcut_vec3 x[N], was[N];

/* a bent wire about `centre` that moves about 4 mm, mostly along y */
static void given_a_moving_wire(wcut_random *random, wcut_vec3 centre) {
    for (int i = 0; i < N; i++) {
        x[i] = vec3_add(centre, vec3((i - 2) * 4.6 + wcut_random_uniform(random), 2 * wcut_random_uniform(random),
                                     2 * wcut_random_uniform(random)));
        was[i] = vec3_sub(x[i], vec3(wcut_random_uniform(random) - 0.5, 3 + 2 * wcut_random_uniform(random),
                                     wcut_random_uniform(random) - 0.5));
    }
}

static wcut_resistance eval(const wcut_foam *f, double rate, int i) {
    wcut_resistance r;
    wcut_resistance_eval(f, heat, edge, rate, N, x, was, i, true, &r);
    return r;
}

TEST(a_straight_wire_moving_across_itself_feels_the_law_times_its_length) {
    for (int i = 0; i < N; i++) x[i] = vec3(100 + 5 * i, 50, 150), was[i] = vec3(100 + 5 * i, 46, 150);
    const double law = wcut_force_law_eval(&foam.law, heat, 20); /* 4 mm, five times a second */
    for (int i = 0; i < N; i++) {
        const wcut_resistance r = eval(&foam, 5, i);
        const double length = i == 0 || i == N - 1 ? edge / 2 : edge; /* half an edge at the ends */
        ck_assert_double_eq(r.speed, 20);
        ck_assert_double_eq_tol(r.line, law, 1e-16);
        ck_assert_double_eq(r.engaged, 1);
        ck_assert_double_eq_tol(r.force.y, -law * length, 1e-15);
        ck_assert(r.force.x == 0 && r.force.z == 0);
    }
}

TEST(the_force_opposes_the_motion_and_only_the_part_across_the_wire_counts) {
    wcut_random random = wcut_random_seed(1);
    for (int k = 0; k < 200; k++) {
        given_a_moving_wire(&random, vec3(200, 300, 150));
        for (int i = 0; i < N; i++) {
            const wcut_resistance r = eval(&foam, 5, i);
            const wcut_vec3 move = vec3_sub(x[i], was[i]), d = vec3_unit(move);
            const wcut_vec3 t = vec3_unit(vec3_sub(x[i < N - 1 ? i + 1 : i], x[i > 0 ? i - 1 : i]));
            const double speed = 5 * vec3_length(move), sine = vec3_length(vec3_cross(t, d));
            const double size = wcut_force_law_eval(&foam.law, heat, speed) * sine;
            ck_assert_double_eq_tol(r.line, size, 1e-15);
            const wcut_vec3 expected = vec3_scale(-size * edge * (i > 0 && i < N - 1 ? 1 : 0.5), d);
            ck_assert_double_lt(vec3_distance(r.force, expected), 1e-15);
        }
    }
}

TEST(a_wire_drawn_along_itself_or_at_rest_or_out_of_the_foam_feels_nothing) {
    for (int i = 0; i < N; i++) x[i] = vec3(100 + 5 * i, 50, 150);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < N; i++) {
            if (k == 2) x[i].y = -20;
            was[i] = k == 0 ? vec3(x[i].x - 4, x[i].y, 150) : k == 1 ? x[i] : vec3(x[i].x, -24, 150);
        }
        for (int i = 0; i < N; i++) {
            const wcut_resistance r = eval(&foam, 5, i);
            ck_assert_double_eq(vec3_length(r.force), 0);
            ck_assert_double_eq(r.line, 0);
            ck_assert_double_eq(r.engaged, k < 2);
            ck_assert(vec3_is_finite(r.by_here.x) && vec3_is_finite(r.by_before.y) && vec3_is_finite(r.by_after.z));
        }
    }
}

TEST(in_design_mode_every_node_is_wholly_in_the_foam) {
    const wcut_foam embedded = {.law = foam.law, .block = foam.block, .embedded = true};
    for (int i = 0; i < N; i++) x[i] = vec3(-50 + 5 * i, -50, 150), was[i] = vec3(-50 + 5 * i, -54, 150);
    for (int i = 0; i < N; i++) ck_assert_double_eq(eval(&embedded, 5, i).engaged, 1);
}

static double matrix_error(mat3 given, const double difference[3][3]) {
    const wcut_vec3 row[3] = {given.x, given.y, given.z};
    double worst = 0;
    for (int i = 0; i < 3; i++)
        worst = fmax(worst, fmax(fabs(row[i].x - difference[i][0]),
                                 fmax(fabs(row[i].y - difference[i][1]), fabs(row[i].z - difference[i][2]))));
    return worst;
}

/* d force of node i / d position of node k, by central differences */
static void difference(const wcut_foam *f, double rate, int i, int k, double d[3][3]) {
    const double h = 1e-6;
    for (int c = 0; c < 3; c++) {
        double *component = &x[k].x + c;
        const double at = *component;
        *component = at + h;
        const wcut_vec3 high = eval(f, rate, i).force;
        *component = at - h;
        const wcut_vec3 low = eval(f, rate, i).force;
        *component = at;
        d[0][c] = (high.x - low.x) / (2 * h), d[1][c] = (high.y - low.y) / (2 * h),
        d[2][c] = (high.z - low.z) / (2 * h);
    }
}

TEST(derivatives_are_those_of_central_differences_inside_and_across_every_face) {
    const wcut_vec3 centre[] = {{200, 300, 150}, {0, 300, 150},   {400, 300, 150}, {200, 0, 150},
                                {200, 600, 150}, {200, 300, 300}, {0, 0, 150},     {400, 600, 0}};
    const wcut_foam soft = {.law = foam.law, .block = {.size = {400, 600, 300}, .depth = 6}};
    const wcut_foam embedded = {.law = foam.law, .block = foam.block, .embedded = true};
    const wcut_foam *const each[] = {&soft, &embedded};
    wcut_random random = wcut_random_seed(4);
    double largest = 0;
    for (int k = 0; k < 400; k++) {
        given_a_moving_wire(&random, centre[k % 8]);
        const wcut_foam *f = each[k / 8 % 2];
        for (int i = 0; i < N; i++) {
            const double rate = 2 + 8 * wcut_random_uniform(&random), h = 1e-6;
            const wcut_resistance r = eval(f, rate, i);
            double d[3][3];
            difference(f, rate, i, i, d);
            ck_assert_double_lt(matrix_error(r.by_here, d), 1e-7);
            largest = fmax(largest, fabs(d[1][1]));
            if (i > 0) {
                difference(f, rate, i, i - 1, d);
                ck_assert_double_lt(matrix_error(r.by_before, d), 1e-7);
            }
            if (i < N - 1) {
                difference(f, rate, i, i + 1, d);
                ck_assert_double_lt(matrix_error(r.by_after, d), 1e-7);
            }
            const wcut_vec3 high = eval(f, rate * exp(h), i).force, low = eval(f, rate * exp(-h), i).force;
            ck_assert_double_lt(vec3_distance(vec3_scale(1 / (2 * h), vec3_sub(high, low)), r.by_log_rate), 1e-8);
        }
    }
    ck_assert_double_gt(largest, 1e-2); /* [N/mm]: the errors above are small against the derivatives themselves */
}
