/* Before a design: what it may be asked for, and the direction of feed. */
#ifndef WCUT_INVERSE_PREPARE_H
#define WCUT_INVERSE_PREPARE_H

#include "inverse/scan.h"

/* WCUT_OK; WCUT_BAD_ARGUMENT with the words; `out` is where the answer is to go */
wcut_status wcut_design_check(const wcut_design_target *target, const wcut_job *job, const wcut_design_options *options,
                              const void *out, wcut_error *error);

/* the feed of the lowest prediction, or the one that is asked for; rms by feed [mm], HUGE_VAL where it was not tried */
wcut_status wcut_design_choose_feed(const wcut_design_target *target, const wcut_design_options *options, double rms[5],
                                    wcut_design_feed *feed);

#endif
