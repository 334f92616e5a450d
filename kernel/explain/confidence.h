/* How sure a verdict is: how often verdicts like it were right on labelled cases. */
#ifndef WCUT_EXPLAIN_CONFIDENCE_H
#define WCUT_EXPLAIN_CONFIDENCE_H

#include <wirecut/diagnosis.h>

/* [1] kind of the verdict; x: as wcut_decision.confidence_by */
double wcut_confidence_eval(wcut_verdict_kind kind, double x);

#endif
