/* Every job of the shared cases as it stands, and the sample jobs at 1,500 stations: none fails, stalls or wobbles.
   labels: property slow */
#include <glob.h>

#include <wirecut/job_file.h>
#include "cut/cuts.h"
#include "cut/wobble.h"
#include "test.h"

typedef struct outcome {
    wcut_status status;
    wcut_error error;
    wobble wobble;
    double residual;
    int stations, iterations, max_iterations, substeps;
} outcome;

static outcome cut_job(const char *path, int stations) {
    outcome o = {0};
    wcut_job *job = NULL;
    wcut_setup *setup = NULL;
    wcut_history *h = NULL;
    o.status = wcut_job_read(path, &job, &o.error);
    if (o.status == WCUT_OK && stations > 0) o.status = wcut_job_resample(job, stations);
    if (o.status == WCUT_OK) o.status = wcut_setup_create(job, NULL, &setup, &o.error);
    if (o.status == WCUT_OK) o.status = wcut_setup_run(setup, NULL, NULL, &h, &o.error);
    if (h) {
        o.wobble = wobble_of(h, 10); /* while the first nodes meet the face, the load along the wire is not smooth */
        o.stations = h->stations;
        for (int j = 0; j < h->stations; j++) {
            o.residual = fmax(o.residual, h->row[j].residual);
            o.iterations += h->row[j].iterations;
            if (h->row[j].iterations > o.max_iterations) o.max_iterations = h->row[j].iterations;
            if (h->row[j].substeps > o.substeps) o.substeps = h->row[j].substeps;
        }
    }
    wcut_history_destroy(h);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
    return o;
}

/* false where there are no such jobs */
static bool cut_all(const char *pattern, int stations, int min) {
    glob_t found;
    if (glob(pattern, 0, NULL, &found) != 0) return false;
    const int count = (int)found.gl_pathc;
    outcome *all = calloc((size_t)count, sizeof *all);
    ck_assert(all != NULL);
#pragma omp parallel for schedule(dynamic)
    for (int k = 0; k < count; k++) all[k] = cut_job(found.gl_pathv[k], stations);
    outcome worst = {0};
    for (int k = 0; k < count; k++) {
        const outcome *o = &all[k];
        const char *path = found.gl_pathv[k];
        ck_assert_msg(o->status == WCUT_OK, "%s: %s", path, o->error.text);
        ck_assert_msg(o->residual <= 1e-9, "%s: residual %g", path, o->residual);
        ck_assert_msg(o->wobble.speed < 0.01 && o->wobble.angle < 3e-4 && o->wobble.force < 3e-3,
                      "%s: wobbles by %g of its speed, %g rad, %g of its force", path, o->wobble.speed, o->wobble.angle,
                      o->wobble.force);
        ck_assert_msg(o->iterations < 16 * o->stations, "%s: %d iterations", path, o->iterations);
        worst.stations += o->stations, worst.iterations += o->iterations;
        worst.residual = fmax(worst.residual, o->residual);
        worst.wobble.speed = fmax(worst.wobble.speed, o->wobble.speed);
        worst.wobble.angle = fmax(worst.wobble.angle, o->wobble.angle);
        worst.wobble.force = fmax(worst.wobble.force, o->wobble.force);
        if (o->max_iterations > worst.max_iterations) worst.max_iterations = o->max_iterations;
        if (o->substeps > worst.substeps) worst.substeps = o->substeps;
    }
    printf(
        "%d jobs, %d stations: iterations %.2f in the mean, %d at most; sub-steps %d at most; residual %.1e at most; "
        "wobble %.1e of the speed, %.1e rad, %.1e of the force\n",
        count, worst.stations, (double)worst.iterations / worst.stations, worst.max_iterations, worst.substeps,
        worst.residual, worst.wobble.speed, worst.wobble.angle, worst.wobble.force);
    ck_assert_int_ge(count, min);
    free(all);
    globfree(&found);
    return true;
}

TEST(every_job_of_the_shared_cases_is_cut_to_its_end_without_a_wobble) {
    if (!cut_all(WCUT_SOURCE_DIR "/../shared/cases/*/*/*/job.json", 0, 1)) SKIP("there are no jobs in ../shared/cases");
}

TEST(every_sample_job_is_cut_to_its_end_without_a_wobble_at_1500_stations) { cut_all(SAMPLE_JOBS "*.json", 1500, 16); }
