/* What holds the wire of a job, how it is fed, and where a tool is that holds both ends. */
#ifndef WCUT_CUT_JOB_RIG_H
#define WCUT_CUT_JOB_RIG_H

#include <wirecut/job.h>

/* Between two poses: places evenly along the line, turns evenly the shorter way round (Shoemake 1985). */
wcut_pose wcut_pose_mix(const wcut_pose *a, const wcut_pose *b, double t);

/* The pose of a job's tool at station j; where it has mounts alone, that of a frame half way between them whose x axis runs
   from A to B, turned from the block's the shorter way. */
wcut_pose wcut_job_pose(const wcut_job *job, int j);

/* Rig, feed and tool of a job: WCUT_BAD_ARGUMENT with the key and what is expected. */
wcut_status wcut_rig_check(const wcut_job *job, wcut_error *error);

#endif
