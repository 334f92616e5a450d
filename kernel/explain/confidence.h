/* How sure a verdict is: how often verdicts like it were right on labelled cases. */
#ifndef WCUT_EXPLAIN_CONFIDENCE_H
#define WCUT_EXPLAIN_CONFIDENCE_H

#include <wirecut/diagnosis.h>

/* [1] kind of the verdict; score: of the best candidate, not below 0; effects: how many are named */
double wcut_confidence_eval(wcut_verdict_kind kind, double score, int effects);

#endif
