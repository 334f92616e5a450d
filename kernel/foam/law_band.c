/* What a fitted law is judged by: the confidence band of its curve, and its residuals beside normal ones. */
#include <stdlib.h>
#include <wirecut/calibration.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/numbers.h"
#include "foam/law_fit.h"

static bool is_law(const wcut_law_fit *law) {
    return isfinite(law->a) && isfinite(law->b) && isfinite(law->c) && all_finite(9, law->covariance) &&
           law->degrees >= 1;
}

wcut_status wcut_law_fit_eval(const wcut_law_fit *law, double confidence, int n, const double *q_eff, double *fitted,
                              double *low, double *high) {
    if (!law || n < 0 || (n > 0 && (!q_eff || !fitted)) || !is_law(law)) return WCUT_BAD_ARGUMENT;
    if (!(confidence > 0 && confidence < 1)) return WCUT_BAD_ARGUMENT;
    for (int i = 0; i < n; i++)
        if (!isfinite(q_eff[i]) || q_eff[i] < 0) return WCUT_BAD_ARGUMENT;
    const double t = wcut_student_quantile(0.5 + confidence / 2, law->degrees);
    for (int i = 0; i < n; i++) {
        const double value = law->a * exp(-law->b * q_eff[i]) + law->c, reach = t * wcut_law_fit_error(law, q_eff[i]);
        fitted[i] = value;
        if (low) low[i] = value - reach;
        if (high) high[i] = value + reach;
    }
    return WCUT_OK;
}

typedef struct ranked {
    double value;
    int index;
} ranked;

static int compare_ranks(const void *a, const void *b) {
    const ranked *x = a, *y = b;
    if (x->value != y->value) return x->value < y->value ? -1 : 1;
    return x->index - y->index;
}

wcut_status wcut_gaussian_scores(int n, const double *value, double *score) {
    if (n < 0 || (n > 0 && (!value || !score)) || !all_finite(n, value)) return WCUT_BAD_ARGUMENT;
    if (n == 0) return WCUT_OK;
    ranked *order = wcut_alloc((size_t)n, sizeof *order);
    if (!order) return WCUT_NO_MEMORY;
    for (int i = 0; i < n; i++) order[i] = (ranked){value[i], i};
    qsort(order, (size_t)n, sizeof *order, compare_ranks);
    for (int k = 0; k < n; k++) score[order[k].index] = wcut_gaussian_quantile((k + 1 - 0.375) / (n + 0.25));
    wcut_free(order);
    return WCUT_OK;
}
