/* A wire of one cut that is far from the length its job states. */
#ifndef WCUT_EXPLAIN_CUT_LENGTH_H
#define WCUT_EXPLAIN_CUT_LENGTH_H

#include <wirecut/diagnosis.h>

/* Add wire_length to a verdict for every cut whose wire stands out of what wires are cut to by hand, and a sentence before the
   verdict's own. The table of the rig must be there. A verdict that is open stays as it is. */
void wcut_cut_length_report(wcut_diagnosis *diagnosis);

#endif
