/* The correction of jobs that a fit asks for. */
#ifndef WCUT_EXPLAIN_CORRECT_H
#define WCUT_EXPLAIN_CORRECT_H

#include <wirecut/correction.h>

#include "explain/model_fit.h"

/* Law, length, kerf and effects of a fit as wcut_correction_apply puts them into a job: the job then predicts what the
   fit's model does. A kerf that grows evenly with the heat goes into the job's kerf, where moulds see it too. */
wcut_correction wcut_fitted_correction(const wcut_fitted *fitted);

#endif
