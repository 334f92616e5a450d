/* How long it takes to write: STEP of a surface of 2000 x 200 poles, binary STL of 10 million triangles beside memcpy
   of the same bytes; and to read them back. Files in the folder of argument 1; one line each for bench_table.sh. */
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>
#include <wirecut/wirecut.h>

#include "bench/peers/common.h"

enum { RUNS = 5, TRIANGLES = 10000000, PIECE = 1000, PIECES = 20 };

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
    double *x = sheet_nodes(stations, nodes);
    wcut_surface *s = NULL;
    check(wcut_surface_loft(stations, nodes, (const wcut_vec3 *)x, 1e-6, &s, NULL, NULL), NULL);
    free(x);
    return s;
}

static void write_triangles(const wcut_vec3 *corner) {
    wcut_stl_stream *stream = NULL;
    wcut_error error;
    check(wcut_stl_stream_create("bench.stl", &stream, &error), &error);
    for (int t = 0; t < TRIANGLES; t += PIECE) {
        const wcut_vec3 *piece = corner + (size_t)(t / PIECE % PIECES) * 3 * PIECE;
        check(wcut_stl_stream_append(stream, PIECE, piece, &error), &error);
    }
    check(wcut_stl_stream_commit(stream, &error), &error);
    wcut_stl_stream_destroy(stream);
}

static void bench_stl(void) {
    static wcut_vec3 corner[PIECES * 3 * PIECE];
    double seconds;
    char note[80];
    for (int k = 0; k < PIECES * 3 * PIECE; k++) corner[k] = (wcut_vec3){0.01 * k, 0.02 * k, 1e-3 * (k % 311 * k % 97)};
    seconds = INFINITY;
    for (int run = 0; run < 2 * RUNS; run++) {
        unlink("bench.stl"); /* to let go of the last one's pages is not writing */
        double once;
        TIMED(1, once, write_triangles(corner));
        seconds = fmin(seconds, once);
    }
    snprintf(note, sizeof note, "streamed, memory %.0f MB", memory_mb());
    say("stl", "wirecut", seconds, note);
    unlink("bench.stl");
}

static void bench_copy(void) {
    const size_t size = (size_t)50 * TRIANGLES;
    char *from = malloc(size), *to = malloc(size);
    double seconds;
    if (!from || !to) exit(EXIT_FAILURE);
    memset(from, 1, size);
    memset(to, 2, size); /* the pages are there */
    TIMED(RUNS, seconds, {
        memcpy(to, from, size);
        from[run_] = to[size - 1];
    });
    say("stl", "memcpy", seconds, "as many bytes, in memory");
    free(from);
    free(to);
}

static void bench_mesh(void) {
    wcut_surface *s = make_surface(400, 200);
    wcut_mesh *mesh = NULL, *again = NULL;
    double seconds;
    wcut_error error;
    char note[80];
    check(wcut_surface_tessellate(s, 2e-4, &mesh, NULL), NULL);
    snprintf(note, sizeof note, "a mesh of %d triangles", mesh->triangle_count);
    TIMED(RUNS, seconds, check(wcut_mesh_write_stl(mesh, "bench.stl", &error), &error));
    say("stl_mesh", "wirecut", seconds, note);
    TIMED(2, seconds, {
        check(wcut_mesh_read("bench.stl", NULL, &again, NULL, &error), &error);
        wcut_mesh_destroy(again);
    });
    say("stl_read", "wirecut", seconds, "and its vertices joined");
    unlink("bench.stl");
    wcut_mesh_destroy(mesh);
    wcut_surface_destroy(s);
}

static void bench_step(void) {
    wcut_surface *s = make_surface(2000, 200);
    const wcut_shape shape = {.name = "cut", .surface = s};
    double seconds;
    wcut_error error;
    TIMED(RUNS, seconds, check(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP214, "bench.step", &error), &error));
    say("step", "wirecut", seconds, "bench.step, which is left for the peer");
    TIMED(RUNS, seconds, check(wcut_iges_write(1, &shape, "bench.igs", &error), &error));
    say("iges", "wirecut", seconds, "type 128");
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
