/* A job cut in simulation by the C API, its surface as STL and its path curves as CSV:  simulate JOBS-FOLDER OUT */
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <wirecut/wirecut.h>

/* every call gives a status; the ones with a place fill an error too */
static void expect(wcut_status status, const wcut_error *error) {
    if (status == WCUT_OK) return;
    fprintf(stderr, "%s\n", error->text[0] ? error->text : wcut_status_text(status));
    exit(EXIT_FAILURE);
}

static const char *in_folder(const char *folder, const char *name) {
    static char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

int main(int argc, char **argv) {
    if (argc != 3) return fprintf(stderr, "usage: simulate JOBS-FOLDER OUT\n"), 2;
    wcut_error error = {0};
    wcut_job *job;
    wcut_setup *setup;
    wcut_history *history;
    wcut_surface *surface;
    wcut_mesh *mesh;

    expect(wcut_job_read(in_folder(argv[1], "steady-400-60.json"), &job, &error), &error);
    expect(wcut_setup_create(job, NULL, &setup, &error), &error);
    expect(wcut_setup_run(setup, NULL, NULL, &history, &error), &error);

    /* sections nearer than 1 um are one; triangles within 0.1 mm of the surface */
    expect(wcut_surface_loft(history->stations, history->nodes, history->position, 1e-3, &surface, NULL, NULL), &error);
    expect(wcut_surface_tessellate(surface, 0.1, &mesh, NULL), &error);
    mkdir(argv[2], 0777);
    expect(wcut_mesh_write_stl(mesh, in_folder(argv[2], "surface.stl"), &error), &error);
    expect(wcut_history_write_csv(history, job->mount_a, job->mount_b, in_folder(argv[2], "path.csv"), &error), &error);

    const wcut_history_row *last = &history->row[history->stations - 1];
    printf("%s: %d stations in %.1f s, %d triangles\n", job->name, history->stations, last->time, mesh->triangle_count);

    wcut_mesh_destroy(mesh);
    wcut_surface_destroy(surface);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
    return EXIT_SUCCESS;
}
