/* How long a cut takes and what memory it needs: 121 nodes x 600 stations, cost against nodes, and 1,001 nodes x 5,000
   stations with the history streamed to disk. CPU seconds of one core.   bench_simulate [FOLDER for the stream] */
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>
#include <wirecut/wirecut.h>

enum { RUNS = 3 };

static double cpu_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double peak_megabytes(void) {
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (double)usage.ru_maxrss / 1024;
}

static void check(wcut_status status, const wcut_error *error) {
    if (status == WCUT_OK) return;
    fprintf(stderr, "bench_simulate: %s: %s\n", wcut_status_text(status), error->text);
    exit(EXIT_FAILURE);
}

static wcut_setup *sample_setup(int nodes, int stations) {
    wcut_error error = {0};
    wcut_job *job = NULL;
    wcut_setup *setup = NULL;
    check(wcut_job_read(WCUT_SOURCE_DIR "/samples/jobs/steady-400-60.json", &job, &error), &error);
    check(wcut_job_resample(job, stations), &error);
    job->nodes = nodes;
    check(wcut_setup_create(job, NULL, &setup, &error), &error);
    wcut_job_destroy(job);
    return setup;
}

typedef struct cost {
    double seconds, iterations; /* of a run, the fastest; Newton iterations a station */
} cost;

static cost time_cut(int nodes, int stations) {
    wcut_error error = {0};
    wcut_setup *setup = sample_setup(nodes, stations);
    cost min = {.seconds = 1e9};
    for (int run = 0; run < RUNS; run++) {
        wcut_cut *cut = NULL;
        long iterations = 0;
        const double start = cpu_now();
        check(wcut_cut_create(setup, &cut, &error), &error);
        for (int j = 1; j < stations; j++) {
            wcut_station s;
            check(wcut_cut_step(cut, &error), &error);
            wcut_cut_view(cut, &s);
            iterations += s.iterations;
        }
        wcut_cut_destroy(cut);
        const double seconds = cpu_now() - start;
        if (seconds < min.seconds) min.seconds = seconds;
        min.iterations = (double)iterations / stations;
    }
    wcut_setup_destroy(setup);
    return min;
}

static void stream_cut(const char *folder, int nodes, int stations) {
    char path[1000];
    snprintf(path, sizeof path, "%s/bench_simulate.vtp", folder);
    wcut_error error = {0};
    wcut_setup *setup = sample_setup(nodes, stations);
    wcut_cut *cut = NULL;
    wcut_vtp_stream *stream = NULL;
    const double start = cpu_now();
    check(wcut_cut_create(setup, &cut, &error), &error);
    check(wcut_vtp_stream_create(path, stations, nodes, &stream, &error), &error);
    for (int j = 0;; j++) {
        wcut_station s;
        wcut_cut_view(cut, &s);
        check(wcut_vtp_stream_append(stream, &s, &error), &error);
        if (j == stations - 1) break;
        check(wcut_cut_step(cut, &error), &error);
    }
    check(wcut_vtp_stream_commit(stream, &error), &error);
    FILE *f = fopen(path, "rb");
    if (!f || fseek(f, 0, SEEK_END) != 0) exit(EXIT_FAILURE);
    printf("%d nodes x %d stations, streamed: %.2f s, %.0f MB on disk, peak memory %.1f MB (target 100)\n", nodes,
           stations, cpu_now() - start, (double)ftell(f) / 1e6, peak_megabytes());
    fclose(f);
    unlink(path);
    wcut_vtp_stream_destroy(stream);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
}

int main(int argc, char **argv) {
    /* first, since the peak is that of the process */
    stream_cut(argc > 1 ? argv[1] : ".", 1001, 5000);
    const cost usual = time_cut(121, 600);
    printf(
        "121 nodes x 600 stations: %.3f s (target 0.5)\n\n nodes   us a station   iterations   us a node and "
        "iteration\n",
        usual.seconds);
    double few = 0;
    const int nodes[] = {61, 121, 301, 601, 1201};
    for (int k = 0; k < 5; k++) {
        const cost c = time_cut(nodes[k], 300);
        const double each = 1e6 * c.seconds / 300;
        if (nodes[k] == 121) few = each;
        printf("%6d %14.0f %12.2f %25.3f\n", nodes[k], each, c.iterations, each / nodes[k] / c.iterations);
        if (nodes[k] == 1201) printf("\n1,201 nodes take %.1f times what 121 take a station (target 12)\n", each / few);
    }
    return EXIT_SUCCESS;
}
