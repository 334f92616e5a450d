/* The figures of a channel, for callers that have checked its values. */
#ifndef WCUT_CUT_SCORE_H
#define WCUT_CUT_SCORE_H

#include <wirecut/score.h>

/* wcut_score_eval of finite values: measured x, predicted y */
wcut_score wcut_score_of(int n, const double *x, const double *y, double range);

#endif
