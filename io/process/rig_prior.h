/* What a cell knows of its own rig, out of a text. */
#ifndef WCUT_IO_PROCESS_RIG_PRIOR_H
#define WCUT_IO_PROCESS_RIG_PRIOR_H

#include <stddef.h>
#include <wirecut/diagnosis.h>

/* of `length` bytes of JSON; path: the name in messages. As wcut_rig_prior_read. */
wcut_status wcut_rig_prior_parse(const char *text, size_t length, const char *path, wcut_rig_prior *prior,
                                 wcut_error *error);

#endif
