/* A cut that was run, and the files that hold it: what `simulate` writes, for every verb that ends with a cut. */
#ifndef APP_SIMULATION_H
#define APP_SIMULATION_H

#include <wirecut/wirecut.h>

#include "command.h"
#include "results.h"

/* Sections nearer than a job's own rounding of its coordinates are one section. */
#define APP_MERGE_MM 1e-3
#define APP_SIMULATION_FORMATS "vtp,stl,obj,ply,glb,csv,step"

/* What the files of a cut are called, in the order written. */
#define APP_SIMULATION_FILES                                                                               \
    "history.vtp", "surface.stl", "surface.obj", "surface.ply", "surface.glb", "path.csv", "surface.step", \
        "job-path.json", "bow.json", "bow.csv", "bow_map.csv", "feed_chart.csv"

typedef struct app_simulation {
    const app_call *call; /* with the options formats and chord-tolerance */
    const char *path;     /* of the job, for messages */
    wcut_job *job;
    wcut_setup *setup;
    wcut_history *history;
    wcut_surface *surface; /* through the stations */
    wcut_status ended;     /* how the run ended */
    wcut_bow_results *bow; /* of a bow */
    app_results results;
} app_simulation;

/* Run s->setup to its end, or as far as it goes: then the history holds what there is. Gives an exit code, after a line
   that says why. */
int app_simulation_run(app_simulation *s);

/* Write the history, the surface and the paths into s->results. Gives an exit code. */
int app_simulation_write(app_simulation *s);

/* What to know of the cut: its length and speed, what it does not show, whether it can be made. */
int app_simulation_say(const app_simulation *s);

void app_simulation_clear(app_simulation *s);

#endif
