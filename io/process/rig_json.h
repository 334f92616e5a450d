/* A job's "rig", "feed" and the poses of its tool, in and out. */
#ifndef WCUT_IO_PROCESS_RIG_JSON_H
#define WCUT_IO_PROCESS_RIG_JSON_H

#include <wirecut/job.h>

#include "io/file/json_read.h"
#include "io/file/text.h"

/* the objects "rig" and "feed", the array "path.tool": into a wcut_job */
bool wcut_read_rig(wcut_reader *reader, const wcut_place *at, void *job);
bool wcut_read_feed(wcut_reader *reader, const wcut_place *at, void *job);
bool wcut_read_tool(wcut_reader *reader, const wcut_place *at, void *job);

/* both mounts' places by the poses that were read; `at` is the path */
bool wcut_read_mounts(wcut_reader *reader, const wcut_place *at, wcut_job *job);

/* whether what a rig needs is there and what it has no use for is not; `at` is the job */
bool wcut_read_rig_fits(wcut_reader *reader, const wcut_place *at, wcut_job *job);

/* the keys "rig" and "feed" where they are not the defaults, and a path of poses */
void wcut_put_rig(wcut_text *text, const wcut_job *job);
void wcut_put_tool(wcut_text *text, const wcut_job *job);

#endif
