/* Kinks across joints made smaller: heights of the lines moved by a balance of moves and second differences
   (Whittaker 1923). */
#include "base/alloc.h"
#include "base/banded.h"
#include "facade/layout.h"

wcut_status wcut_match_smooth(int count, double weight, double *height) {
    if (count < 3 || !(weight > 0)) return WCUT_OK;
    wcut_banded m = {.n = count, .kl = 2, .ku = 2, .width = 7};
    m.entry = wcut_alloc(banded_size(count, 2, 2), sizeof *m.entry);
    m.pivot = wcut_alloc((size_t)count, sizeof *m.pivot);
    if (!m.entry || !m.pivot) {
        wcut_free(m.entry);
        wcut_free(m.pivot);
        return WCUT_NO_MEMORY;
    }

    /* I + weight D'D, D the second differences: positive definite */
    static const double d[3] = {1, -2, 1};
    for (int i = 0; i < count; i++) *banded_at(&m, i, i) += 1;
    for (int k = 0; k + 2 < count; k++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) *banded_at(&m, k + i, k + j) += weight * d[i] * d[j];

    /* the moved heights in place */
    const bool solved = wcut_banded_factor(&m);
    if (solved) wcut_banded_solve(&m, height);
    wcut_free(m.entry);
    wcut_free(m.pivot);
    return solved ? WCUT_OK : WCUT_SINGULAR;
}
