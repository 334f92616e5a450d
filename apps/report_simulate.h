/* The page of a simulated cut. */
#ifndef APP_REPORT_SIMULATE_H
#define APP_REPORT_SIMULATE_H

#include <wirecut/wirecut.h>

/* what there is to say of a run beside its setup and history */
typedef struct app_simulated {
    const char *job_path;
    const char *integrator; /* as the user calls it */
    double chord_tolerance; /* [mm] of the files beside the page */
    double merge;           /* [mm] sections nearer than this were one in the surface */
    wcut_status ended;      /* how the run ended */
} app_simulated;

/* Write report.html to path. WCUT_OK; as wcut_report_write, wcut_file_hash, wcut_history_path and wcut_surface_loft:
   nothing was written. */
wcut_status app_report_simulate(const app_simulated *run, const wcut_setup *setup, const wcut_history *history,
                                const char *path, wcut_error *error);

#endif
