/* A job cut in simulation by the C API, its surface as STL and its path as CSV:  simulate JOBS-FOLDER OUT-FOLDER */
#include <stdio.h>
#include <sys/stat.h>
#include <wirecut/wirecut.h>

int main(int argc, char **argv) {
    if (argc != 3) return fprintf(stderr, "usage: simulate JOBS-FOLDER OUT-FOLDER\n"), 2;
    char path[3][4096];
    const char *const name[] = {"steady-400-60.json", "surface.stl", "path.csv"};
    for (int i = 0; i < 3; i++) snprintf(path[i], sizeof path[i], "%s/%s", argv[i ? 2 : 1], name[i]);
    mkdir(argv[2], 0777);

    wcut_job *job = NULL;
    wcut_setup *setup = NULL;
    wcut_history *history = NULL;
    wcut_surface *surface = NULL;
    wcut_mesh *mesh = NULL;
    wcut_error error = {0}; /* says place and expectation where a call fails */
    wcut_status status = wcut_job_read(path[0], &job, &error);
    if (!status) status = wcut_setup_create(job, NULL, &setup, &error);
    if (!status) status = wcut_setup_run(setup, NULL, NULL, &history, &error);

    /* sections nearer than 1 um are one; triangles within 0.1 mm of the surface */
    if (!status)
        status = wcut_surface_loft(history->stations, history->nodes, history->position, 1e-3, &surface, NULL, NULL);
    if (!status) status = wcut_surface_tessellate(surface, 0.1, &mesh, NULL);
    if (!status) status = wcut_mesh_write_stl(mesh, path[1], &error);
    if (!status) status = wcut_history_write_csv(history, job->mount_a, job->mount_b, path[2], &error);

    /* a call without an error's text has its status to say */
    if (!status)
        printf("%s: %d stations, %d triangles\n", job->name, history->stations, mesh->triangle_count);
    else
        fprintf(stderr, "failed: %s\n", error.text[0] ? error.text : wcut_status_text(status));

    wcut_mesh_destroy(mesh);
    wcut_surface_destroy(surface);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
    return status ? 1 : 0;
}
