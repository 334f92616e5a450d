/* Entries in which the wire hangs by its weight: found by its directions, and left out. */
#ifndef WCUT_EXPLAIN_DROOP_H
#define WCUT_EXPLAIN_DROOP_H

#include "explain/evidence.h"

/*
 * Leave the first bins of every cut out in which both directions of the wire point down from where it is predicted, where
 * they do in all cuts. open: rows, measured less predicted. Gives the longest time left out [s], 0: none. After that the
 * evidence is to be predicted and its rows are to be made anew.
 */
double wcut_droop_leave_out(wcut_evidence *evidence, const double *open);

#endif
