/* How long it takes to write: STEP of a surface of 2000 x 200 poles, binary STL of 10 million triangles beside memcpy
   of the same bytes; and to read them back. CPU seconds, the median of five runs; files in the folder of argument 1. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>
#include <wirecut/wirecut.h>

enum { RUNS = 5, TRIANGLES = 10000000, PIECE = 1000 };

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

static void check(wcut_status status, const wcut_error *error) {
    if (status == WCUT_OK) return;
    fprintf(stderr, "bench_exchange: %s %s\n", wcut_status_text(status), error ? error->text : "");
    exit(EXIT_FAILURE);
}

static double memory_mb(void) {
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    return (double)used.ru_maxrss / 1024;
}

/* a wire's cut: stations x nodes */
static wcut_surface *make_surface(int stations, int nodes) {
    wcut_vec3 *x = malloc((size_t)stations * (size_t)nodes * sizeof *x);
    wcut_surface *s = NULL;
    if (!x) exit(EXIT_FAILURE);
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) {
            const double u = (double)i / (nodes - 1), t = (double)j / (stations - 1);
            x[j * nodes + i] =
                (wcut_vec3){400 * u, 900 * t - 240 * u * (1 - u), 150 + 60 * sin(6 * t + 1.5 * u) + 80 * t * (u - 0.5)};
        }
    check(wcut_surface_loft(stations, nodes, x, 1e-6, &s, NULL, NULL), NULL);
    free(x);
    return s;
}

static void bench_stl(void) {
    double seconds[RUNS];
    wcut_error error;
    wcut_vec3 corner[3 * PIECE];
    for (int k = 0; k < 3 * PIECE; k++) corner[k] = (wcut_vec3){0.01 * k, 0.02 * k, 1e-3 * (k * k % 97)};
    for (int run = 0; run < RUNS; run++) {
        wcut_stl_stream *stream = NULL;
        const double start = cpu_now();
        check(wcut_stl_stream_create("bench.stl", &stream, &error), &error);
        for (int t = 0; t < TRIANGLES; t += PIECE) {
            for (int k = 0; k < 3 * PIECE; k++) corner[k] = (wcut_vec3){0.01 * (t + k), 0.02 * k, 1e-3 * (k * k % 97)};
            check(wcut_stl_stream_append(stream, PIECE, corner, &error), &error);
        }
        check(wcut_stl_stream_commit(stream, &error), &error);
        wcut_stl_stream_destroy(stream);
        seconds[run] = cpu_now() - start;
    }
    printf("binary STL, 10 M triangles, 500 MB, streamed: %.3f s, memory %.0f MB\n", median(seconds), memory_mb());
    unlink("bench.stl");
}

static void bench_copy(void) {
    const size_t size = (size_t)50 * TRIANGLES;
    char *from = malloc(size), *to = malloc(size);
    double seconds[RUNS];
    if (!from || !to) exit(EXIT_FAILURE);
    memset(from, 1, size);
    memset(to, 2, size); /* the pages are there */
    for (int run = 0; run < RUNS; run++) {
        const double start = cpu_now();
        memcpy(to, from, size);
        seconds[run] = cpu_now() - start;
        from[run] = to[size - 1];
    }
    printf("memcpy of 500 MB: %.3f s\n", median(seconds));
    free(from);
    free(to);
}

static void bench_mesh(void) {
    wcut_surface *s = make_surface(400, 200);
    wcut_mesh *mesh = NULL, *again = NULL;
    double out[RUNS], in[RUNS];
    wcut_error error;
    check(wcut_surface_tessellate(s, 2e-4, &mesh, NULL), NULL);
    for (int run = 0; run < RUNS; run++) {
        double start = cpu_now();
        check(wcut_mesh_write_stl(mesh, "bench.stl", &error), &error);
        out[run] = cpu_now() - start;
        start = cpu_now();
        check(wcut_mesh_read("bench.stl", NULL, &again, NULL, &error), &error);
        in[run] = cpu_now() - start;
        wcut_mesh_destroy(again);
    }
    printf("a mesh of %d triangles: STL written in %.3f s, read and its vertices joined in %.3f s\n",
           mesh->triangle_count, median(out), median(in));
    unlink("bench.stl");
    wcut_mesh_destroy(mesh);
    wcut_surface_destroy(s);
}

static void bench_step(void) {
    wcut_surface *s = make_surface(2000, 200);
    const wcut_shape shape = {"cut", NULL, s, NULL};
    double step[RUNS], iges[RUNS];
    wcut_error error;
    for (int run = 0; run < RUNS; run++) {
        double start = cpu_now();
        check(wcut_step_write(1, &shape, WCUT_STEP_AP214, "bench.step", &error), &error);
        step[run] = cpu_now() - start;
        start = cpu_now();
        check(wcut_iges_write(1, &shape, "bench.igs", &error), &error);
        iges[run] = cpu_now() - start;
    }
    printf("a surface of 2000 x 200 poles: STEP %.3f s, IGES %.3f s (bench.step is left for the peers)\n", median(step),
           median(iges));
    unlink("bench.igs");
    wcut_surface_destroy(s);
}

int main(int argc, char **argv) {
    if (argc > 1 && chdir(argv[1]) != 0) return EXIT_FAILURE;
    bench_stl(); /* first: its memory is the program's so far */
    bench_copy();
    bench_mesh();
    bench_step();
    return 0;
}
