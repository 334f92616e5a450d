/* How a verb reads recordings of other programs: one place for all verbs. */
#ifndef APP_RECORDING_H
#define APP_RECORDING_H

#include <wirecut/recording_file.h>

#include "command.h"

#define APP_OPTIONS_RECORDING                                                                                      \
    {.kind = APP_TEXT,                                                                                             \
     .name = "columns",                                                                                            \
     .value = "LIST",                                                                                              \
     .help =                                                                                                       \
         "columns of the recordings, CHANNEL=COLUMN with *FACTOR and +OFFSET behind where the unit is another, "   \
         "separated by commas: time_s=timestamp,force_x_N=Fx*0.001; in place of the case's columns"},              \
    {                                                                                                              \
        .kind = APP_REAL, .name = "period", .value = "S", .low = 1e-9, .high = 1e6,                                \
        .help = "constant time between the rows of recordings without a clock, s; in place of the case's period_s" \
    }

/* Put what the call gives in the place of what the format holds; says what is wrong and gives an exit code. */
int app_recording_format(const app_call *call, wcut_recording_format *format);

#endif
