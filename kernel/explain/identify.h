/* Identification cuts: a programme that tells lags, rates and heats apart, and the same path run backwards. */
#ifndef WCUT_EXPLAIN_IDENTIFY_H
#define WCUT_EXPLAIN_IDENTIFY_H

#include <wirecut/job.h>

#include "base/random.h"
#include "explain/predicted_cut.h"

/* what a programme holds, added up */
enum { WCUT_PROGRAMME_SPEED = 1, WCUT_PROGRAMME_HEAT = 2 };

/* Give a job an excitation in place of its own, within its limits: NOTATION.md, Identification cuts.
   schedule: of the job without excitation; parts: sum of WCUT_PROGRAMME_...; random: draws as many numbers for any
   parts as the duration asks for.
   WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE, WCUT_NOT_CONVERGED, WCUT_NO_MEMORY: as wcut_predicted_cut_run, the job's
   excitation is not to be used. */
wcut_status wcut_programme_create(wcut_job *job, const wcut_schedule *schedule, int parts, wcut_random *random,
                                  wcut_error *error);

#endif
