/* The effects of a job as JSON: in by the table of their parameters, out the same way. */
#ifndef WCUT_IO_PROCESS_EFFECT_JSON_H
#define WCUT_IO_PROCESS_EFFECT_JSON_H

#include <wirecut/job.h>

#include "io/file/json_read.h"
#include "io/file/text.h"

/* "effects": [...] into a wcut_job's effect and effect_count: names, choices and ranges checked */
bool wcut_read_effects(wcut_reader *reader, const wcut_place *at, void *job);

/* `,\n  "effects": [..]`, or nothing where there are none; the effects are of known kinds and choices */
void wcut_put_effects(wcut_text *text, int count, const wcut_effect *effect);

#endif
