/* How long it takes to score a case on one core: CPU seconds, the best of three.  bench_score CASE.json [NODES] */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <wirecut/wirecut.h>

static double cpu_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

typedef struct tally {
    int cuts, samples, failed, iterations;
    double tension, alpha; /* sums of the replays' RMSD [N, rad] */
    double read, compared; /* [s] */
} tally;

/* one cut from its files to its scores */
static int score_cut(const wcut_case_cut *cut, int nodes, tally *t) {
    wcut_job *job = NULL;
    wcut_recording *recording = NULL;
    wcut_comparison *c = NULL;
    wcut_error error = {WCUT_OK, ""};
    const double start = cpu_now();
    wcut_status status = wcut_job_read(cut->job, &job, &error);
    if (!status) status = wcut_recording_read(cut->recording, NULL, &recording, &error);
    const double between = cpu_now();
    if (!status && nodes > 0) job->nodes = nodes;
    if (!status) status = wcut_comparison_create(job, recording, NULL, &c, &error);
    if (status) {
        fprintf(stderr, "%s: %s\n", cut->recording, error.text);
    } else {
        t->cuts++;
        t->samples += c->samples;
        t->failed += c->replayed->failed;
        t->iterations += c->replayed->iterations;
        t->tension += c->replayed_score.of[WCUT_SCORED_TENSION][WCUT_PART_ALL].rmsd;
        t->alpha += c->replayed_score.of[WCUT_SCORED_ALPHA][WCUT_PART_ALL].rmsd;
        t->read += between - start;
        t->compared += cpu_now() - between;
    }
    wcut_comparison_destroy(c);
    wcut_recording_destroy(recording);
    wcut_job_destroy(job);
    return status == WCUT_OK;
}

int main(int argc, char **argv) {
    wcut_case *found = NULL;
    wcut_error error = {WCUT_OK, ""};
    if (argc < 2 || wcut_case_read(argv[1], &found, &error) != WCUT_OK) {
        fprintf(stderr, "%s\n", argc < 2 ? "usage: bench_score CASE.json [NODES]" : error.text);
        return 2;
    }
    tally best = {0};
    int whole = 1;
    for (int round = 0; round < 3 && whole; round++) {
        tally t = {0};
        for (int i = 0; i < found->cuts; i++)
            whole = score_cut(&found->cut[i], argc > 2 ? atoi(argv[2]) : 0, &t) && whole;
        if (round == 0 || t.read + t.compared < best.read + best.compared) best = t;
    }
    const double cuts = best.cuts > 0 ? best.cuts : 1, samples = best.samples > 0 ? best.samples : 1;
    printf(
        "%s: %d cuts, %d samples: %.2f s CPU (%.3f s reading), %.0f us and %.2f iterations a sample, %d not solved; "
        "replayed RMSD of tensions %.4f N, of alpha %.4f deg\n",
        found->name, best.cuts, best.samples, best.read + best.compared, best.read, 1e6 * best.compared / samples,
        best.iterations / samples, best.failed, best.tension / cuts, best.alpha / cuts * 57.295779513082321);
    wcut_case_destroy(found);
    return whole ? 0 : 1;
}
