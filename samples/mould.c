/* Two edge curves drawn on a block become the two halves of a mould, as exact solids in one STEP file, without a file
   in between:  mould JOBS-FOLDER OUT-FOLDER [EDGES]  (the folder of jobs is not read). EDGES is a STEP, IGES, JSON or CSV
   file whose first two curves are the edges at x = 0 and at x = 400 mm, each from y = 0 to y = 900. */
#include <math.h>
#include <stdio.h>
#include <sys/stat.h>
#include <wirecut/wirecut.h>

enum { POINTS = 13 };

/* the edges along which the wire's ends enter and leave: out of a CAD program's file, or through points */
static wcut_status draw_edges(wcut_job *job, const char *path, wcut_error *error) {
    wcut_curve_set *set = NULL;
    wcut_vec3 a[POINTS], b[POINTS];
    if (path) {
        const wcut_status status = wcut_curve_set_read(path, NULL, &set, error);
        if (status) return status;
        if (set->count >= 2) {
            job->edge_a = set->curve[0], set->curve[0] = NULL; /* the job's from here on */
            job->edge_b = set->curve[1], set->curve[1] = NULL;
        }
        wcut_curve_set_destroy(set);
        if (!job->edge_b) snprintf(error->text, sizeof error->text, "%s: expected two edges", path);
        return job->edge_b ? WCUT_OK : WCUT_BAD_FORMAT;
    }
    for (int k = 0; k < POINTS; k++) {
        const double t = k / (POINTS - 1.0);
        a[k] = (wcut_vec3){0, 900 * t, 150 + 50 * sin(6 * t)};
        b[k] = (wcut_vec3){400, 900 * t, 140 - 40 * cos(5 * t)};
    }
    const wcut_status status = wcut_curve_interpolate(POINTS, a, &job->edge_a);
    return status ? status : wcut_curve_interpolate(POINTS, b, &job->edge_b);
}

/* what is to be cut: the block, the wire and its edges */
static wcut_status describe(wcut_job *job, const char *edges, wcut_error *error) {
    static double extra_u[3] = {0, 0.5, 1}, extra_length[3] = {4, 28, 4}; /* [mm] the wire sags most in the middle */
    job->block_size = (wcut_vec3){400, 900, 300};
    job->wire_diameter = 0.15;
    job->nodes = 121;
    job->heat = 60;
    job->tension = 2;
    job->force_law = (wcut_force_law){.a = 0.012, .b = 4e-4};
    job->kerf_width = 0.8;
    job->mode = WCUT_MODE_DESIGN;
    job->stations = 241;
    job->clearance = 80;
    job->extra_count = 3;
    job->extra_u = extra_u;
    job->extra_length = extra_length;
    return draw_edges(job, edges, error);
}

int main(int argc, char **argv) {
    if (argc != 3 && argc != 4) return fprintf(stderr, "usage: mould JOBS-FOLDER OUT-FOLDER [EDGES]\n"), 2;
    char path[4096];
    snprintf(path, sizeof path, "%s/mould.step", argv[2]);
    mkdir(argv[2], 0777);

    wcut_job *job = NULL;
    wcut_setup *setup = NULL;
    wcut_history *history = NULL;
    wcut_surface *surface = NULL;
    wcut_mould *mould = NULL;
    wcut_error error = {0}; /* says place and expectation where a call fails */
    wcut_key key[WCUT_KEYS_AT_CORNERS];
    wcut_mould_options options = wcut_mould_default();
    wcut_status status = wcut_job_create(&job);
    if (!status) status = describe(job, argv[3], &error);
    if (!status) status = wcut_setup_create(job, NULL, &setup, &error);
    if (!status) status = wcut_setup_run(setup, NULL, NULL, &history, &error);
    if (!status)
        status = wcut_surface_loft(history->stations, history->nodes, history->position, 1e-3, &surface, NULL, NULL);
    if (!status) status = wcut_keys_at_corners(job->block_size, 15, -12, key); /* pockets, for pins on a base plate */
    if (!status) {
        options.prolong = 100; /* the last wire sags behind the far side: cut on, straight */
        options.kerf = job->kerf_width;
        options.key = key, options.key_count = WCUT_KEYS_AT_CORNERS;
        status = wcut_mould_create(surface, job->block_size, &options, &mould, &error);
    }
    if (!status) {
        const wcut_shape half[2] = {{.name = "lower half", .solid = mould->lower.brep},
                                    {.name = "upper half", .solid = mould->upper.brep}};
        status = wcut_step_write(2, half, WCUT_STEP_SCHEMA_AP214, path, &error);
    }

    /* a call without an error's text has its status to say */
    if (!status)
        printf("%s: %.0f and %.0f mm3, %.0f mm3 of kerf\n", path, mould->lower.report.volume,
               mould->upper.report.volume, mould->kerf_volume);
    else
        fprintf(stderr, "failed: %s\n", error.text[0] ? error.text : wcut_status_text(status));

    wcut_mould_destroy(mould);
    wcut_surface_destroy(surface);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    if (job) { /* these two were never the job's own */
        job->extra_u = NULL;
        job->extra_length = NULL;
    }
    wcut_job_destroy(job);
    return status ? 1 : 0;
}
