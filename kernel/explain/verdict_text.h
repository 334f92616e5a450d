/* What a diagnosis says in words: the verdict for an operator, and what could not be told. */
#ifndef WCUT_EXPLAIN_VERDICT_TEXT_H
#define WCUT_EXPLAIN_VERDICT_TEXT_H

#include <stdbool.h>
#include <wirecut/diagnosis.h>

/* fill diagnosis->sentence */
void wcut_diagnosis_sentence(wcut_diagnosis *diagnosis);

/* fill diagnosis->limit; false: no memory */
bool wcut_diagnosis_limits(wcut_diagnosis *diagnosis, int cuts, const wcut_diagnosis_cut *cut, int test_cuts,
                           const wcut_test_cut *calibration);

#endif
