/* A job as JSON text in memory: what the file reader, the file writer and the fuzzer share. */
#ifndef WCUT_IO_PROCESS_JOB_H
#define WCUT_IO_PROCESS_JOB_H

#include <stddef.h>
#include <wirecut/job.h>

#include "io/file/json_read.h"

/* limits of what a job may hold: beyond them it is a slip of the pen, not a cut */
enum { WCUT_JOB_STATIONS_MAX = 1000000, WCUT_JOB_NODES_MAX = 100000, WCUT_JOB_BYTES_MAX = 256 << 20 };

/* wcut_job_read of a text; label stands in front of every message */
wcut_status wcut_job_parse(const char *text, size_t length, const char *label, wcut_job **job, wcut_error *error);

/* the text of a job, checked by parsing it; the caller's to free */
wcut_status wcut_job_print(const wcut_job *job, const char *label, char **text, size_t *length, wcut_error *error);

/* the objects "force_law" and "tension_law": `into` is a wcut_force_law, a wcut_tension_law */
bool wcut_read_force_law(wcut_reader *reader, const wcut_place *at, void *law);
bool wcut_read_tension_law(wcut_reader *reader, const wcut_place *at, void *law);

#endif
