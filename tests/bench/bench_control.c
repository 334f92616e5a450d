/* What one step of the controller costs: as a distribution over 1e7 steps, and, free of what else the machine does, as the
   least of ten passes over the same steps.  bench_control [STEPS] */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <wirecut/control.h>

#include "base/random.h"

enum { STATIONS = 1000, BINS = 100000, BIN_NS = 10, INPUTS = 1 << 14, PASSES = 10, REPEATED = 1000000 };

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec; /* [ns] */
}

static wcut_control *make(void) {
    static wcut_history_row row[STATIONS];
    for (int j = 0; j < STATIONS; j++)
        row[j] = (wcut_history_row){.time = 0.2 * j,
                                    .duration = j ? 0.2 : 0,
                                    .speed_a = 20,
                                    .speed_b = 18,
                                    .tension_a = 2,
                                    .tension_b = 2,
                                    .phase = WCUT_PHASE_STEADY};
    const wcut_history plan = {.stations = STATIONS, .planned = STATIONS, .nodes = 3, .row = row};
    const wcut_job job = {.tension = 2, .heat = 60, .force_law = {0.1, 8.6e-4}, .speed_min = 0.1, .speed_max = 100};
    const wcut_control_settings settings = wcut_control_settings_default(&job);
    wcut_control *control = NULL;
    return wcut_control_create(&settings, &plan, &control, NULL) == WCUT_OK ? control : NULL;
}

static double at_share(const long *bin, long steps, double share) {
    long sum = 0;
    for (int i = 0; i < BINS; i++)
        if ((double)(sum += bin[i]) >= share * (double)steps) return (i + 1) * BIN_NS;
    return INFINITY;
}

/* one step of a cut of so many, timed [ns] */
static double time_step(wcut_control *control, const double *tension, long i, long steps, double *speed) {
    const double a = tension[i % INPUTS], b = tension[(i * 7 + 3) % INPUTS], begun = now();
    wcut_control_step(control, 0.001 * (double)i, (double)i * (STATIONS - 1.0) / (double)steps, a, b, speed);
    return now() - begun;
}

/* The same cut again and again: an interruption hits another step in every pass, the step's own cost does not. */
static bool repeat(const double *tension) {
    double *min = calloc(REPEATED, sizeof *min), longest = 0, speed;
    for (int pass = 0; min && pass < PASSES; pass++) {
        wcut_control *control = make();
        for (long i = 0; control && i < REPEATED; i++) {
            const double took = time_step(control, tension, i, REPEATED, &speed);
            min[i] = pass > 0 ? fmin(min[i], took) : took;
        }
        wcut_control_destroy(control);
    }
    for (long i = 0; min && i < REPEATED; i++) longest = fmax(longest, min[i]);
    printf("least of %d passes over the same %d steps: the dearest step takes %.0f ns\n", PASSES, REPEATED, longest);
    const bool done = min != NULL;
    free(min);
    return done;
}

int main(int argc, char **argv) {
    const long steps = argc > 1 ? atol(argv[1]) : 10000000;
    static long bin[BINS];
    static double tension[INPUTS];
    wcut_control *control = make();
    if (steps < 1 || !control) return 1;
    wcut_random random = wcut_random_seed(1);
    for (int i = 0; i < INPUTS; i++) tension[i] = 2 + 0.05 * wcut_random_normal(&random);
    double longest = 0, sum = 0, min = INFINITY, speed = 0;
    for (long i = 0; i < 1000000; i++) { /* what the clock itself costs */
        const double begun = now();
        min = fmin(min, now() - begun);
    }
    for (long i = 0; i < steps; i++) {
        const double took = time_step(control, tension, i, steps, &speed);
        bin[took < BINS * (double)BIN_NS ? (int)(took / BIN_NS) : BINS - 1]++;
        longest = fmax(longest, took);
        sum += took;
    }
    wcut_control_view view;
    wcut_control_look(control, &view);
    long over = 0;
    for (int i = 2000 / BIN_NS; i < BINS; i++) over += bin[i];
    printf(
        "%ld steps, clock included (%.0f ns): mean %.0f ns, median %.0f, 99 %% %.0f, 99.99 %% %.0f, longest %.0f ns; "
        "%ld beyond 2 us; ended in \"%s\" at %.2f mm/s\n",
        steps, min, sum / (double)steps, at_share(bin, steps, 0.5), at_share(bin, steps, 0.99),
        at_share(bin, steps, 0.9999), longest, over, wcut_control_state_name(view.state), speed);
    wcut_control_destroy(control);
    return repeat(tension) ? EXIT_SUCCESS : EXIT_FAILURE;
}
