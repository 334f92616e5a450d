/* A job as the options of a verb change it: one place for all verbs. */
#ifndef APP_JOB_H
#define APP_JOB_H

#include <wirecut/job.h>

#include "command.h"

/* Options that change the job; a verb has those of them that it lists. */
#define APP_OPTION_STATIONS                                                           \
    {                                                                                 \
        .kind = APP_INT, .name = "stations", .value = "N", .low = 2, .high = 1000000, \
        .help = "number of stations along the path, in place of the job's",           \
    }
#define APP_OPTION_NODES                                                          \
    {                                                                             \
        .kind = APP_INT, .name = "nodes", .value = "N", .low = 3, .high = 100000, \
        .help = "number of nodes along the wire, in place of the job's",          \
    }
#define APP_OPTION_EDGES                                                                             \
    {                                                                                                \
        .kind = APP_FILE, .name = "edges", .value = "FILE",                                          \
        .help = "STEP, IGES, JSON or CSV file with two curves, which replace the edges of a design", \
    }

#define APP_OPTION_FORCE_LAW                                                            \
    {                                                                                   \
        .kind = APP_FILE, .name = "force-law", .value = "FILE",                         \
        .help = "the force and tension law of force_law.json, instead of the job's own" \
    }

#define APP_OPTIONS_STRENGTH                                                             \
    {                                                                                    \
        .kind = APP_REAL,                                                                \
        .name = "cold-strength",                                                         \
        .value = "MPA",                                                                  \
        .low = 1,                                                                        \
        .high = 1e4,                                                                     \
        .help = "tensile strength of the wire at 20 degC, MPa, in place of the job's",   \
    },                                                                                   \
    {                                                                                    \
        .kind = APP_REAL, .name = "hot-strength", .value = "MPA", .low = 1, .high = 1e4, \
        .help =                                                                          \
            "the same at 900 degC, in place of the job's; between both, and on, the "    \
            "strength is exponential in the temperature",                                \
    }

/* Reads a job and applies the options above that the verb has and the call gives. A NULL call gives none. On failure
   *job is NULL and the error's text names the file. */
wcut_status app_job_read(const app_call *call, const char *path, wcut_job **job, wcut_error *error);

/* The same; says what is wrong and gives an exit code. */
int app_job_load(const app_call *call, const char *path, wcut_job **job);

/* Refuses a job of a bow or a blade where a verb makes no sense for it, with the reason. Gives an exit code. */
int app_require_two_arms(const wcut_job *job, const char *path, const char *reason);

/* The same two for verbs that drive mounts: a design becomes the path job that it is cut by, job-path.json of wirecut
   simulate, planned with the options. */
wcut_status app_job_read_path(const app_call *call, const char *path, wcut_job **job, wcut_error *error);
int app_job_load_path(const app_call *call, const char *path, wcut_job **job);

/* For verbs that look at a recording: the path of a design is the one that was cut, planned by the job as it is, and the
   options change the job behind that. */
wcut_status app_job_read_cut(const app_call *call, const char *path, wcut_job **job, wcut_error *error);

#endif
