/* What a diagnosis is given: checked before anything looks into it. */
#ifndef WCUT_EXPLAIN_DIAGNOSIS_CHECK_H
#define WCUT_EXPLAIN_DIAGNOSIS_CHECK_H

#include <wirecut/diagnosis.h>

/* WCUT_OK; WCUT_BAD_ARGUMENT with the cut and what is expected */
wcut_status wcut_diagnosis_check(int cuts, const wcut_diagnosis_cut *cut, int test_cuts,
                                 const wcut_test_cut *calibration, const wcut_diagnosis_options *o,
                                 wcut_diagnosis **out, wcut_error *error);

/* whether a case is one of a blade: by its first job */
bool wcut_diagnosis_is_of_blade(int cuts, const wcut_diagnosis_cut *cut);

#endif
