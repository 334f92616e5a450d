/* A scan compared with the face that a job should leave, by the C API:  compare JOBS-FOLDER OUT-FOLDER */
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <wirecut/wirecut.h>

/* deviations of a whole cloud, and what they say */
static wcut_status summarise_cloud(const wcut_face *face, const wcut_cloud *cloud, wcut_deviation_summary **summary) {
    wcut_projection *projection = NULL;
    wcut_deviation *deviation = calloc((size_t)cloud->count, sizeof *deviation);
    wcut_deviation_options options = wcut_deviation_options_default();
    wcut_deviation_summary_options parts = wcut_deviation_summary_options_default();
    options.low = parts.low = face->low, options.high = parts.high = face->high;
    parts.bands = 1, parts.band[0] = 1;
    wcut_status status = deviation ? wcut_projection_create(face->surface, &projection) : WCUT_NO_MEMORY;
    if (!status)
        status = wcut_deviation_from_surface(projection, cloud->count, cloud->point, &options, 1, deviation, NULL);
    if (!status) status = wcut_deviation_summary_create(&parts, face, summary);
    if (!status) status = wcut_deviation_summary_add(*summary, cloud->count, deviation);
    wcut_projection_destroy(projection);
    free(deviation);
    return status;
}

int main(int argc, char **argv) {
    if (argc != 3) return fprintf(stderr, "usage: compare JOBS-FOLDER OUT-FOLDER\n"), 2;
    char path[3][4096];
    snprintf(path[0], sizeof path[0], "%s/steady-400-60.json", argv[1]);
    snprintf(path[1], sizeof path[1], "%s/../scans/steady-400-60.xyz", argv[1]);
    snprintf(path[2], sizeof path[2], "%s/zones.csv", argv[2]);
    mkdir(argv[2], 0777);

    wcut_job *job = NULL;
    wcut_setup *setup = NULL;
    wcut_history *history = NULL;
    wcut_face *face = NULL;
    wcut_cloud *cloud = NULL;
    wcut_deviation_summary *summary = NULL;
    const wcut_deviation_summary_result *result = NULL;
    wcut_error error = {0}; /* says place and expectation where a call fails */
    wcut_status status = wcut_job_read(path[0], &job, &error);
    if (!status) status = wcut_setup_create(job, NULL, &setup, &error);
    if (!status) status = wcut_setup_run(setup, NULL, NULL, &history, &error);
    if (!status) status = wcut_face_create(job, history, NULL, NULL, 1e-3, &face);
    if (!status) status = wcut_cloud_read(path[1], NULL, &cloud, &error);
    if (!status) status = summarise_cloud(face, cloud, &summary);
    if (!status) status = wcut_deviation_summary_eval(summary, &result);
    if (!status) status = wcut_zones_write(result, path[2], &error);

    /* a call without an error's text has its status to say */
    if (!status)
        printf("%d deviations, RMS %.3f mm: offset %.3f, form %.3f, noise %.3f mm\n", result->statistics.count,
               result->statistics.rms, result->split.offset, result->split.form_rms, result->split.noise_rms);
    else
        fprintf(stderr, "failed: %s\n", error.text[0] ? error.text : wcut_status_text(status));

    wcut_deviation_summary_destroy(summary);
    wcut_cloud_destroy(cloud);
    wcut_face_destroy(face);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
    return status ? 1 : 0;
}
