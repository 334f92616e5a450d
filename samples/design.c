/* A target surface to the cut that comes nearest to it, by the C API:  design JOBS-FOLDER OUT-FOLDER
   The wire, the heat and the foam are those of a job; the target is a saddle over a block of 400 x 600 x 300 mm. */
#include <stdio.h>
#include <sys/stat.h>
#include <wirecut/wirecut.h>

enum { COLUMNS = 25, ROWS = 37 };

/* the target as a surface through a grid of heights, 40 mm beyond the block's sides */
static wcut_status make_target(wcut_vec3 block, wcut_design_target **target, wcut_error *error) {
    static wcut_vec3 grid[ROWS * COLUMNS];
    for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i++) {
            const double x = -40 + (block.x + 80) * i / (COLUMNS - 1), y = -40 + (block.y + 80) * j / (ROWS - 1);
            const double u = x - block.x / 2, v = y - block.y / 2;
            grid[j * COLUMNS + i] = (wcut_vec3){x, y, block.z / 2 + 4e-4 * (u * u - v * v)};
        }
    wcut_surface *surface = NULL;
    wcut_status status = wcut_surface_loft(ROWS, COLUMNS, grid, 1e-3, &surface, NULL, NULL);
    if (!status) status = wcut_design_target_from_surface(surface, block, target, error);
    wcut_surface_destroy(surface);
    return status;
}

int main(int argc, char **argv) {
    if (argc != 3) return fprintf(stderr, "usage: design JOBS-FOLDER OUT-FOLDER\n"), 2;
    char from[4096], to[4096];
    snprintf(from, sizeof from, "%s/steady-400-60.json", argv[1]);
    snprintf(to, sizeof to, "%s/job-path.json", argv[2]);
    mkdir(argv[2], 0777);

    wcut_job *process = NULL;
    wcut_design_target *target = NULL;
    wcut_design *design = NULL;
    wcut_error error = {0}; /* says place and expectation where a call fails */
    wcut_status status = wcut_job_read(from, &process, &error);
    if (!status) {
        process->block_size = (wcut_vec3){400, 600, 300};
        process->stations = 61, process->nodes = 31; /* coarse: seconds, not minutes */
        process->clearance = 80;
        status = make_target(process->block_size, &target, &error);
    }

    /* a tolerance ends the search; the feed is known to be good along +y */
    wcut_design_options options = wcut_design_options_default();
    options.feed = WCUT_DESIGN_FEED_PLUS_Y;
    options.tolerance = 0.2;
    if (!status) status = wcut_design_fit(target, process, &options, NULL, NULL, &design, &error);
    if (!status) status = wcut_job_write(design->path, to, &error);

    /* a call without an error's text has its status to say */
    if (!status)
        printf("%.3f mm rms from the target as designed, %.3f mm rms as the paths cut, %d simulations\n", design->rms,
               design->path_rms, design->runs);
    else
        fprintf(stderr, "failed: %s\n", error.text[0] ? error.text : wcut_status_text(status));

    wcut_design_destroy(design);
    wcut_design_target_destroy(target);
    wcut_job_destroy(process);
    return status ? 1 : 0;
}
