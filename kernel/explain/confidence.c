/* How sure a verdict is: a logistic regression over labelled cases of two laboratories. */
#include "explain/confidence.h"

#include <math.h>

/*
 * ln odds that a verdict is right: first + second x, x what the search leaves (wcut_decision.confidence_by). Of `none` ln (1 +
 * gain of the whole library at once) / 5; of `unknown` what is left over its limit, 3 at most, since what is just beyond noise
 * may be an effect that was lost and what is far beyond it may be two; 1 where two effects are named, 0 for one. The rows are what
 *     python3 tests/bench/confidence.py DIR ANSWERS ..
 * prints of the three sets of labelled cases (134 cases; ridge of 1).
 */
typedef struct odds {
    double first, second;
} odds;

static const odds none = {1.21, 0.16}, unknown = {1.43, -0.50}, named = {2.83, -0.32};

/* an ambiguous verdict says that there are two */
#define AMBIGUOUS 0.5

static double probability(odds o, double x) { return 1 / (1 + exp(-o.first - o.second * x)); }

double wcut_confidence_eval(wcut_verdict_kind kind, double x) {
    if (kind == WCUT_VERDICT_AMBIGUOUS) return AMBIGUOUS;
    return probability(kind == WCUT_VERDICT_NONE ? none : kind == WCUT_VERDICT_UNKNOWN ? unknown : named, x);
}
