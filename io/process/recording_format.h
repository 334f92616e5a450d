/* The keys "columns" and "period_s" of a case. */
#ifndef WCUT_IO_PROCESS_RECORDING_FORMAT_H
#define WCUT_IO_PROCESS_RECORDING_FORMAT_H

#include <wirecut/recording_file.h>

#include "io/file/json_read.h"

/* into a wcut_recording_format, its period (a double); what was read is the caller's to clear, whole or not */
bool wcut_read_columns(wcut_reader *reader, const wcut_place *at, void *format);
bool wcut_read_period(wcut_reader *reader, const wcut_place *at, void *period);

#endif
