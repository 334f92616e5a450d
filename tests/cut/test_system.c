/* The solver's residual: its Jacobian and borders against central differences, and what it says of a known solution. */
#include "base/random.h"
#include "cut/cuts.h"
#include "cut/system.h"
#include "test.h"

enum { N = 9, SIZE = 4 * N - 7 };

static wcut_foam foam = {.law = {0.1, 8.6e-4}, .block = {.size = {40, 600, 300}, .depth = 2}};
static wcut_vec3 x[N], was[N];
static double s[N - 1], log_rate;

/* a bent wire across the side, the front and the top of a block, each node moving its own way */
static wcut_step given_a_step(wcut_random *random, wcut_system *y) {
    ck_assert(wcut_system_create(N, y));
    for (int i = 0; i < N; i++) {
        x[i] = vec3(-8 + 7 * i, 2 - 0.2 * i * (N - 1 - i) + wcut_random_uniform(random),
                    298 + i * 0.3 + wcut_random_uniform(random));
        was[i] = vec3_sub(x[i], vec3(wcut_random_uniform(random) - 0.5, 3 + 2 * wcut_random_uniform(random),
                                     wcut_random_uniform(random) - 0.5));
        if (i < N - 1) s[i] = 1.5 + wcut_random_uniform(random);
    }
    log_rate = 1 + wcut_random_uniform(random);
    return (wcut_step){.foam = &foam, .heat = 65, .tension = 2, .edge = 7.2, .n = N, .was = was};
}

/* unknown k, where the system says it stands */
static double *unknown_at(int k) { return k % 4 == 0 ? &s[k / 4] : &x[k / 4 + 1].x + (k - 1) % 4; }

TEST(jacobian_and_borders_are_those_of_central_differences) {
    wcut_random random = wcut_random_seed(6);
    for (int trial = 0; trial < 40; trial++) {
        wcut_system y;
        const wcut_step step = given_a_step(&random, &y);
        static double given[SIZE][SIZE], border[SIZE], by_rate[SIZE], high[SIZE];
        wcut_system_eval(&y, &step, x, s, log_rate, true);
        for (int i = 0; i < SIZE; i++) {
            for (int j = 0; j < SIZE; j++) given[i][j] = abs(i - j) <= 6 ? *banded_at(&y.jacobian, i, j) : 0;
            border[i] = y.border[i], by_rate[i] = y.by_log_rate[i];
        }
        const double by_rate_condition = y.condition_by_log_rate, h = 1e-6;
        double worst = 0;
        for (int j = 0; j <= SIZE; j++) { /* the last is ln r */
            double *unknown = j < SIZE ? unknown_at(j) : &log_rate, at = *unknown;
            *unknown = at + h;
            wcut_system_eval(&y, &step, x, s, log_rate, false);
            memcpy(high, y.residual, sizeof high);
            const double condition = y.condition;
            *unknown = at - h;
            wcut_system_eval(&y, &step, x, s, log_rate, false);
            *unknown = at;
            for (int i = 0; i < SIZE; i++)
                worst = fmax(worst, fabs((high[i] - y.residual[i]) / (2 * h) - (j < SIZE ? given[i][j] : by_rate[i])));
            worst = fmax(worst, fabs((condition - y.condition) / (2 * h) - (j < SIZE ? border[j] : by_rate_condition)));
        }
        ck_assert_double_lt(worst, 5e-8);
        wcut_system_destroy(&y);
    }
}

TEST(the_band_holds_every_derivative) {
    wcut_random random = wcut_random_seed(8);
    wcut_system y;
    const wcut_step step = given_a_step(&random, &y);
    static double high[SIZE];
    for (int j = 0; j < SIZE; j++) {
        double *unknown = unknown_at(j), at = *unknown;
        wcut_system_eval(&y, &step, x, s, log_rate, false);
        memcpy(high, y.residual, sizeof high);
        *unknown = at + 1e-3;
        wcut_system_eval(&y, &step, x, s, log_rate, false);
        *unknown = at;
        for (int i = 0; i < SIZE; i++)
            if (abs(i - j) > 6) ck_assert_double_eq(y.residual[i], high[i]);
    }
    wcut_system_destroy(&y);
}

TEST(few_nodes_share_their_end_tangents_and_the_borders_still_hold) {
    for (int n = 3; n <= 5; n++) {
        wcut_system y;
        ck_assert(wcut_system_create(n, &y));
        wcut_vec3 at[5], from[5];
        double pull[4] = {2, 2.1, 1.9, 2.2};
        for (int i = 0; i < n; i++) at[i] = vec3(9 * i, 20 - 2 * i * (n - 1 - i), 150), from[i] = vec3(9 * i, 15, 149);
        const wcut_step step = {.foam = &foam, .heat = 65, .tension = 2, .edge = 9.5, .n = n, .was = from};
        wcut_system_eval(&y, &step, at, pull, 1, true);
        for (int i = 1; i < n - 1; i++)
            for (int c = 0; c < 3; c++) {
                const double h = 1e-6, given = y.border[4 * i - 3 + c];
                double *component = &at[i].x + c, was_at = *component;
                *component = was_at + h;
                wcut_system_eval(&y, &step, at, pull, 1, false);
                const double high = y.condition;
                *component = was_at - h;
                wcut_system_eval(&y, &step, at, pull, 1, false);
                *component = was_at;
                ck_assert_double_eq_tol((high - y.condition) / (2 * h), given, 1e-7);
            }
        wcut_system_destroy(&y);
    }
}
