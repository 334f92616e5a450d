/* Adequacy: whether noise alone could leave what a model leaves, by recordings of noise drawn at random. */
#include "explain/adequacy.h"

#include <math.h>

#include "base/alloc.h"
#include "base/random.h"
#include "explain/search.h"

/* one null: the noise of every channel, in units as measured */
static void draw_noise(const wcut_evidence *e, wcut_random *random, double *out) {
    const double share = WCUT_SLOWEST_NOISE * wcut_random_uniform(random);
    const double keeps = exp(-WCUT_BIN_WIDTH / WCUT_NOISE_MEMORY), adds = sqrt(1 - keeps * keeps);
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int s = 0; s < WCUT_SIGNALS; s++) {
            double *row = out + c->row + (ptrdiff_t)s * c->bins, slow = wcut_random_normal(random);
            for (int i = 0; i < c->bins; i++) {
                row[i] = e->sigma[s] * (sqrt(share) * slow + wcut_random_normal(random));
                slow = keeps * slow + adds * wcut_random_normal(random);
            }
        }
    }
}

wcut_status wcut_adequacy_p_value(const wcut_evidence *e, double slow, int draws, unsigned long long seed, double *p) {
    double *measured = wcut_alloc((size_t)e->rows, sizeof *measured);
    double *noise = wcut_alloc((size_t)e->rows, sizeof *noise);
    const bool whole = measured && noise;
    if (whole) {
        /* sensors as the whitening of a good rig takes them, whatever slow noise this case was found to have */
        wcut_evidence usual = *e;
        for (int g = 0; g < WCUT_NOISE_GROUPS; g++) usual.noise.slow[g] = WCUT_SLOW_NOISE;
        wcut_random random = wcut_random_seed(seed);
        int as_much = 0;

        /* the residual is computed for its gaps only: rows without a reading stay without noise */
        wcut_evidence_residual(e, measured); /* for its gaps */

        /* each drawing: noise with a random slow share, whitened as usual, and counted if it leaves as much as the
           model */
        for (int d = 0; d < draws; d++) {
            draw_noise(e, &random, noise);
            wcut_evidence_whiten(&usual, measured, noise, noise);
            as_much += wcut_residual_stats_eval(e, noise).slow >= slow;
        }

        /* the estimate (k + 1) / (n + 1) is never zero (Davison, Hinkley 1997) */
        *p = (as_much + 1.0) / (draws + 1);
    }

    wcut_free(measured);
    wcut_free(noise);
    return whole ? WCUT_OK : WCUT_NO_MEMORY;
}
