/* What the two halves of wirecut sweep share: running here, and handing over to Slurm. */
#ifndef APP_SWEEP_H
#define APP_SWEEP_H

#include <limits.h>
#include <wirecut/sweep.h>

#include "command.h"

/* the path of this program, for the processes of the cases; an exit code */
int app_sweep_program(char path[PATH_MAX]);

/* sweep_slurm.c: write the batch script into the folder of a planned sweep, and submit it unless --slurm-script */
int app_sweep_slurm(const app_call *call, const wcut_sweep *sweep);

/* options of Slurm */
#define APP_OPTIONS_SLURM                                                                                             \
    {.kind = APP_FLAG, .name = "slurm", .help = "write a batch script and submit it as an array job of Slurm"},       \
        {.kind = APP_FLAG, .name = "slurm-script", .help = "write the batch script, and do not submit it"},           \
        {.kind = APP_INT,                                                                                             \
         .name = "tasks",                                                                                             \
         .value = "N",                                                                                                \
         .low = 1,                                                                                                    \
         .high = 100000,                                                                                              \
         .standard = "16",                                                                                            \
         .help = "size of Slurm's array; each task takes its share of the cases"},                                    \
        {.kind = APP_TEXT, .name = "partition", .value = "NAME", .help = "Slurm's partition"},                        \
        {.kind = APP_TEXT, .name = "time", .value = "TIME", .help = "Slurm's time limit of a task, such as 1:00:00"}, \
        {.kind = APP_TEXT, .name = "memory", .value = "SIZE", .help = "Slurm's memory of a task, such as 2G"}, {      \
        .kind = APP_TEXT, .name = "modules", .value = "LIST",                                                         \
        .help = "environment modules that a task loads, with commas"                                                  \
    }

#endif
