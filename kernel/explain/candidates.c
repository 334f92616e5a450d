/* What a search has fitted. */
#include "explain/candidates.h"

#include <stddef.h>

#include "base/numbers.h"

/* bins of four seconds */
enum { BLOCK = 8 };

typedef struct block_sums {
    double sum, peak;
    int blocks;
} block_sums;

/* squares of block sums over their length */
static block_sums slow_part(int n, const double *z) {
    block_sums t = {0};
    for (int i = 0; i + BLOCK <= n; i += BLOCK) {
        double sum = 0;
        for (int k = 0; k < BLOCK; k++) sum += z[i + k];
        t.sum += sum * sum / BLOCK, t.peak = fmax(t.peak, sum * sum / BLOCK);
        t.blocks++;
    }
    return t;
}

wcut_residual_stats wcut_residual_stats_eval(const wcut_evidence *e, const double *residual) {
    wcut_residual_stats left = {0};
    block_sums slow = {0}, common = {0};
    double sum = 0, patches = 0;
    int rows = 0, patch_count = 0;

    /* sums over all cuts */
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        const double *z = residual + c->row;

        /* each channel: its slow part, and the worst of them */
        for (int s = 0; s < WCUT_SIGNALS; s++) {
            const block_sums t = slow_part(c->bins, z + (ptrdiff_t)s * c->bins);
            slow.sum += t.sum, slow.blocks += t.blocks;
            left.peak = fmax(left.peak, t.peak);
            if (t.blocks > 4) left.worst = fmax(left.worst, t.sum / t.blocks);
        }

        /* means over four seconds of what both tensions share */
        for (int i = 0; i + BLOCK <= c->bins; i += BLOCK) {
            double both = 0;
            for (int j = i; j < i + BLOCK; j++) both += z[j] + z[c->bins + j];
            common.sum += both * both / (2 * BLOCK), common.blocks++;
        }

        /* all rows, then the patches of the scan */
        for (int i = 0; i < WCUT_SIGNALS * c->bins; i++) sum += z[i] * z[i];
        rows += WCUT_SIGNALS * c->bins;
        const double *p = z + (ptrdiff_t)WCUT_SIGNALS * c->bins;
        for (int i = 0; i < c->patch.count; i++) patches += p[i] * p[i];
        patch_count += c->patch.count;
    }

    /* means; 0 where there is nothing */
    left.per_row = rows ? sum / rows : 0;
    left.slow = slow.blocks ? slow.sum / slow.blocks : 0;
    left.common = common.blocks ? common.sum / common.blocks : 0;
    left.patches = patch_count ? patches / patch_count : 0;

    return left;
}

const wcut_fitted *wcut_search_base(const wcut_search *s) {
    return s->delayed >= 0 ? &s->candidate[s->delayed].fit : &s->none;
}
