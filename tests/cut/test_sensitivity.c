/* Derivatives of a run by what moves its ends, against differences of fourth order. */
#include "cut/cuts.h"
#include "cut/sensitivity.h"

enum { UNKNOWNS = 6, STATIONS = 41, NODES = 31 };

/* What each unknown does to the ends at t in 0 .. 1: a bump around a third of the cut, or all along. */
static void motion_at(int k, double t, wcut_vec3 *a, wcut_vec3 *b, double *length) {
    const double bump = exp(-pow((t - 0.4) / 0.15, 2));
    *a = *b = vec3(0, 0, 0), *length = 0;
    if (k == 0) a->z = bump;
    if (k == 1) b->z = t;
    if (k == 2) a->y = bump, b->y = -bump;
    if (k == 3) *length = bump;
    if (k == 4) *length = 1;
    if (k == 5) a->y = 1 - t, b->x = t;
}

typedef struct fixture {
    wcut_job *job;
    wcut_setup *setup;
    wcut_vec3 *by_a, *by_b;
    double *by_length;
    wcut_end_motion motion;
} fixture;

static fixture make(wcut_job *job, bool plan) {
    fixture f = {.job = job};
    wcut_error error = {0};
    const wcut_cut_options options = wcut_cut_options_default();
    if (plan)
        ck_assert_msg(wcut_plan_create(job, &options, &f.setup, &error) == WCUT_OK, "%s", error.text);
    else
        f.setup = setup_of(job, NULL);
    const int m = f.setup->stations;
    f.by_a = calloc((size_t)UNKNOWNS * (size_t)m, sizeof *f.by_a);
    f.by_b = calloc((size_t)UNKNOWNS * (size_t)m, sizeof *f.by_b);
    f.by_length = calloc((size_t)UNKNOWNS * (size_t)m, sizeof *f.by_length);
    for (int k = 0; k < UNKNOWNS; k++)
        for (int j = 0; j < m; j++) {
            const int at = k * m + j;
            motion_at(k, (double)j / (m - 1), &f.by_a[at], &f.by_b[at], &f.by_length[at]);
            if (!plan) f.by_length[at] = k == 3 || k == 4; /* one wire */
        }
    f.motion = (wcut_end_motion){UNKNOWNS, m, f.by_a, f.by_b, f.by_length, 2, 0};
    return f;
}

static void clear(fixture *f) {
    wcut_setup_destroy(f->setup);
    wcut_job_destroy(f->job);
    free(f->by_a);
    free(f->by_b);
    free(f->by_length);
}

/* the run with unknown k moved by h */
static wcut_history *moved(const fixture *f, int k, double h) {
    const int m = f->setup->stations;
    wcut_setup s = *f->setup;
    wcut_vec3 *a = calloc((size_t)m, sizeof *a), *b = calloc((size_t)m, sizeof *b);
    double *length = calloc((size_t)m, sizeof *length);
    for (int j = 0; j < m; j++) {
        a[j] = vec3_add_scaled(s.end_a[j], h, f->by_a[k * m + j]);
        b[j] = vec3_add_scaled(s.end_b[j], h, f->by_b[k * m + j]);
        length[j] = s.length[j] + h * f->by_length[k * m + j];
    }
    s.end_a = a, s.end_b = b, s.length = length;
    s.feed = wcut_setup_feed(&s);
    wcut_history *history = NULL;
    ck_assert_int_eq(wcut_setup_run(&s, NULL, NULL, &history, NULL), WCUT_OK);
    free(a);
    free(b);
    free(length);
    return history;
}

/* largest error of stations first .. last against fourth-order differences, over the largest derivative of the unknown */
static double worst_error(const fixture *f, double h, int first, int last) {
    const size_t m = (size_t)f->setup->stations, n = (size_t)f->job->nodes;
    wcut_vec3 *by = calloc(UNKNOWNS * m * n, sizeof *by);
    wcut_history *history = NULL;
    wcut_error error = {0};
    ck_assert_msg(wcut_setup_differentiate(f->setup, &f->motion, by, &history, &error) == WCUT_OK, "%s", error.text);
    double worst = 0;
    for (int k = 0; k < UNKNOWNS; k++) {
        wcut_history *at[4];
        const double step[4] = {-2, -1, 1, 2}, weight[4] = {1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12};
        for (int i = 0; i < 4; i++) at[i] = moved(f, k, step[i] * h);
        double off = 0, size = 0;
        for (size_t j = (size_t)first * n; j < (size_t)(last + 1) * n; j++) {
            wcut_vec3 d = {0, 0, 0};
            for (int i = 0; i < 4; i++) d = vec3_add_scaled(d, weight[i] / h, at[i]->position[j]);
            const double e = vec3_distance(d, by[(size_t)k * m * n + j]);
            if (getenv("SAY") && e > 1e-6 && (j % n == n / 2 || j % n == 1) && j < 40 * n)
                printf("  %d: station %d node %d %.2e\n", k, (int)(j / n), (int)(j % n), e);
            off = fmax(off, e);
            size = fmax(size, vec3_length(d));
        }
        if (getenv("SAY")) printf("unknown %d: %.2e of %.2e\n", k, off, size);
        worst = fmax(worst, off / size);
        for (int i = 0; i < 4; i++) wcut_history_destroy(at[i]);
    }
    wcut_history_destroy(history);
    free(by);
    return worst;
}

TEST(derivatives_of_a_plan_are_those_of_fourth_order_differences_to_1e_6) {
    wcut_job *job = sample_job("freeform-1.json");
    job->stations = STATIONS, job->nodes = NODES;
    fixture f = make(job, true);
    const double worst = worst_error(&f, 1e-2, 0, STATIONS - 1);
    ck_assert_msg(worst < 1e-6, "%g", worst);
    clear(&f);
}

TEST(derivatives_hold_in_path_mode_through_entry_steady_phase_and_exit) {
    wcut_job *job = straight_job(400, 100, 640, NODES, STATIONS, -60, 1350);
    for (int j = 0; j < STATIONS; j++) job->mount_a[j].z += 20 * sin(0.1 * j), job->mount_b[j].y += 0.5 * j;
    fixture f = make(job, false);
    const double worst = worst_error(&f, 1e-3, 0, STATIONS - 1);
    ck_assert_msg(worst < 1e-6, "%g", worst);
    clear(&f);
}
