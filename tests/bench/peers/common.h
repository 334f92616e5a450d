/* What the programs that compare surfaces with their peers have in common: the sheet, CPU time, one line per job. */
#ifndef WCUT_BENCH_PEERS_COMMON_H
#define WCUT_BENCH_PEERS_COMMON_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static inline double cpu_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* a wire's cut: 400 x 900 mm, sagging backwards, twisted and waved */
static inline void sheet_node(double s, double t, double *x, double *y, double *z) {
    *x = 400 * s;
    *y = 900 * t - 240 * s * (1 - s);
    *z = 150 + 60 * sin(6.0 * t + 1.5 * s) + 80 * t * (s - 0.5);
}

/* stations x nodes x 3 */
static inline double *sheet_nodes(int stations, int nodes) {
    double *x = (double *)malloc((size_t)stations * (size_t)nodes * 3 * sizeof(double));
    if (!x) exit(EXIT_FAILURE);
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) {
            double *p = x + 3 * ((size_t)j * (size_t)nodes + (size_t)i);
            sheet_node((double)i / (nodes - 1), (double)j / (stations - 1), p, p + 1, p + 2);
        }
    return x;
}

/* the same random numbers in every program (xorshift64*, Vigna 2014) */
static inline double random_share(uint64_t *state) {
    *state ^= *state >> 12, *state ^= *state << 25, *state ^= *state >> 27;
    return (double)((*state * UINT64_C(2685821657736338717)) >> 11) * 0x1p-53;
}

/* a point a few mm beside the sheet, as a scan has them */
static inline void query_point(uint64_t *state, double p[3]) {
    const double s = random_share(state), t = random_share(state);
    sheet_node(s, t, &p[0], &p[1], &p[2]);
    p[2] += 10 * random_share(state) - 5;
}

/* one result: JOB PEER SECONDS each, and what it reached */
static inline void say(const char *job, const char *peer, double seconds, const char *note) {
    printf("%s\t%s\t%.6g\t%s\n", job, peer, seconds, note);
    fflush(stdout);
}

/* the least of five runs: what else the machine does only ever adds */
#define TIMED(runs, seconds, work)                    \
    do {                                              \
        (seconds) = 1e300;                            \
        for (int run_ = 0; run_ < (runs); run_++) {   \
            const double start_ = cpu_now();          \
            work;                                     \
            const double took_ = cpu_now() - start_;  \
            if (took_ < (seconds)) (seconds) = took_; \
        }                                             \
    } while (0)

#endif
