/* How sure a verdict is: a logistic regression over labelled cases of two laboratories. */
#include "explain/confidence.h"

#include <math.h>

/*
 * ln odds that a verdict is right: first + second x. x is ln (1 + score) / 5 where nothing is named, since what gains without
 * being named may be an effect that was lost; and 1 where two effects are named, 0 for one. The rows are what
 *     python3 tests/bench/confidence.py DIR ANSWERS ..
 * prints of the three sets of labelled cases (127 of 134 cases; ridge of 1).
 */
typedef struct odds {
    double first, second;
} odds;

static const odds none = {1.38, -0.16}, unknown = {0.79, -0.73}, named = {2.76, -0.29};

/* an ambiguous verdict says that there are two */
#define AMBIGUOUS 0.5

static double probability(odds o, double x) { return 1 / (1 + exp(-o.first - o.second * x)); }

double wcut_confidence_eval(wcut_verdict_kind kind, double score, int effects) {
    if (kind == WCUT_VERDICT_AMBIGUOUS) return AMBIGUOUS;
    if (kind == WCUT_VERDICT_NONE) return probability(none, log1p(score) / 5);
    if (kind == WCUT_VERDICT_UNKNOWN) return probability(unknown, log1p(score) / 5);
    return probability(named, effects > 1);
}
