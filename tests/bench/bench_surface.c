/* How long the surface room takes: loft, evaluation, tessellation, projection. CPU seconds, the median of five runs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <wirecut/mesh.h>
#include <wirecut/projection.h>
#include <wirecut/surface.h>

#include "base/random.h"
#include "base/vec3.h"

enum { RUNS = 5 };

static double cpu_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *seconds) {
    qsort(seconds, RUNS, sizeof *seconds, ascending);
    return seconds[RUNS / 2];
}

/* a wire's cut: 400 x 900 mm, sagging backwards, twisted and waved */
static wcut_vec3 *cut_nodes(int stations, int nodes) {
    wcut_vec3 *x = malloc((size_t)stations * (size_t)nodes * sizeof *x);
    if (!x) exit(EXIT_FAILURE);
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) {
            const double s = (double)i / (nodes - 1), t = (double)j / (stations - 1);
            x[j * nodes + i] = (wcut_vec3){400 * s, 900 * t - 240 * s * (1 - s),
                                           150 + 60 * sin(6.0 * t + 1.5 * s) + 80 * t * (s - 0.5)};
        }
    return x;
}

static void check(wcut_status status) {
    if (status == WCUT_OK) return;
    fprintf(stderr, "bench_surface: %s\n", wcut_status_text(status));
    exit(EXIT_FAILURE);
}

static wcut_surface *bench_loft(int stations, int nodes) {
    wcut_vec3 *x = cut_nodes(stations, nodes);
    wcut_surface *s = NULL;
    double seconds[RUNS], worst = 0;
    double *v = malloc((size_t)stations * sizeof *v);
    if (!v) exit(EXIT_FAILURE);
    for (int run = 0; run < RUNS; run++) {
        wcut_surface_destroy(s);
        const double start = cpu_now();
        check(wcut_surface_loft(stations, nodes, x, 1e-6, &s, v, NULL));
        seconds[run] = cpu_now() - start;
    }
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) {
            wcut_vec3 p;
            check(wcut_surface_eval(s, (double)i / (nodes - 1), v[j], 0, &p));
            const wcut_vec3 q = x[j * nodes + i];
            worst =
                fmax(worst, sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z)));
        }
    printf("loft %4d x %3d                        %9.4f s   nodes back to %.1e mm\n", stations, nodes, median(seconds),
           worst);
    free(v);
    free(x);
    return s;
}

static void bench_eval(const wcut_surface *s) {
    enum { POINTS = 1000000, SIDE = 1000 };
    double *u = malloc(2 * POINTS * sizeof *u), seconds[RUNS], sum = 0;
    wcut_vec3 *p = malloc(POINTS * sizeof *p);
    if (!u || !p) exit(EXIT_FAILURE);
    wcut_random random = wcut_random_seed(1);
    for (int k = 0; k < 2 * POINTS; k++) u[k] = wcut_random_uniform(&random);
    for (int run = 0; run < RUNS; run++) {
        const double start = cpu_now();
        for (int k = 0; k < POINTS; k++) check(wcut_surface_eval(s, u[2 * k], u[2 * k + 1], 0, &p[k]));
        seconds[run] = cpu_now() - start;
        sum += p[run].x;
    }
    printf("  1e6 points, random                   %9.4f s\n", median(seconds));
    for (int k = 0; k < SIDE; k++) u[k] = u[SIDE + k] = (double)k / (SIDE - 1);
    for (int run = 0; run < RUNS; run++) {
        const double start = cpu_now();
        check(wcut_surface_eval_grid(s, SIDE, u, SIDE, u + SIDE, p));
        seconds[run] = cpu_now() - start;
        sum += p[run].y;
    }
    printf("  1e6 points, grid                     %9.4f s   (checksum %.6f)\n", median(seconds), sum);
    free(p);
    free(u);
}

/* 1e6 points planted up to 5 mm from the surface, in random order */
static void bench_projection(const wcut_surface *s) {
    enum { POINTS = 1000000 };
    wcut_random random = wcut_random_seed(2);
    wcut_vec3 *p = malloc(POINTS * sizeof *p);
    wcut_foot *foot = malloc(POINTS * sizeof *foot);
    double *height = malloc(POINTS * sizeof *height), worst = 0;
    if (!p || !foot || !height) exit(EXIT_FAILURE);
    for (int k = 0; k < POINTS; k++) {
        wcut_vec3 d[4];
        check(wcut_surface_eval(s, wcut_random_uniform(&random), wcut_random_uniform(&random), 1, d));
        height[k] = 10 * wcut_random_uniform(&random) - 5;
        p[k] = vec3_add_scaled(d[0], height[k], vec3_unit(vec3_cross(d[2], d[1])));
    }
    wcut_projection *projection;
    double start = cpu_now();
    check(wcut_projection_create(s, &projection));
    const double prepared = cpu_now() - start;
    start = cpu_now();
    check(wcut_projection_locate(projection, POINTS, p, 1, foot));
    const double located = cpu_now() - start;
    int proven = 0;
    for (int k = 0; k < POINTS; k++) {
        worst = fmax(worst, fabs(foot[k].height - height[k]));
        proven += foot[k].gap == 0;
    }
    printf("  1e6 closest points                   %9.4f s   prepared in %.4f s, worst %.1e mm, %d proven\n", located,
           prepared, worst, proven);
    wcut_projection_destroy(projection);
    free(height);
    free(foot);
    free(p);
}

static void bench_tessellate(const wcut_surface *s, double tolerance) {
    double seconds[RUNS];
    wcut_tessellation_report report = {.rows = 0};
    for (int run = 0; run < RUNS; run++) {
        wcut_mesh *mesh;
        const double start = cpu_now();
        check(wcut_surface_tessellate(s, tolerance, &mesh, &report));
        seconds[run] = cpu_now() - start;
        wcut_mesh_destroy(mesh);
    }
    printf("  tessellated at %-6g mm              %9.4f s   %d x %d, measured %.4f mm\n", tolerance, median(seconds),
           report.rows, report.columns, report.chord_error);
}

int main(void) {
    const int size[2][2] = {{500, 100}, {2000, 200}};
    for (int k = 0; k < 2; k++) {
        wcut_surface *s = bench_loft(size[k][0], size[k][1]);
        bench_eval(s);
        bench_tessellate(s, 0.1);
        bench_tessellate(s, 0.01);
        bench_projection(s);
        wcut_surface_destroy(s);
    }
    return EXIT_SUCCESS;
}
