/* Entries in which the wire hangs by its weight. Without load a wire hangs down, not behind its mounts, and how far it has
   fallen when it touches depends on the air and on its bending; in the foam it is drawn into line within some 100 mm. */
#include "explain/droop.h"

#include <string.h>

#include "base/numbers.h"

/* bins whose mean is looked at: two seconds */
enum { BLOCK = 4 };
/* [rad] mean of either direction over the first of them, below which it points down: in every cut, and in the mean of all.
   A case of the second laboratory whose wires have a weight has 0.17 to 0.71 deg, 0.45 in the mean. */
#define DOWN (0.1 * WCUT_PI / 180)
#define DOWN_MEAN (0.2 * WCUT_PI / 180)
/* standard errors of such a mean, up to which the wire is in line again */
#define IN_LINE 2.0
/* [s] what is left out at most */
#define LONGEST 20.0

/* mean over a block of bins of what a beta is off; 0 where nothing is there */
static double mean_off(const wcut_evidence_cut *c, const double *open, int signal, int block) {
    double sum = 0;
    int count = 0;
    for (int i = block * BLOCK; i < (block + 1) * BLOCK && i < c->bins; i++) {
        const double off = open[c->row + signal * c->bins + i];
        if (isfinite(off) && isfinite(c->measured[signal][i])) sum += off, count++;
    }

    return count ? sum / count : 0;
}

/* blocks from the entry on in which the wire lies low; 0 where it does not begin so */
static int low_blocks(const wcut_evidence *e, const wcut_evidence_cut *c, const double *open) {
    if (mean_off(c, open, 3, 0) > -DOWN || mean_off(c, open, 5, 0) > -DOWN) return 0;
    const double error = (e->sigma[3] + e->sigma[5]) / 2 / sqrt(2.0 * BLOCK);
    int blocks = 1;
    while (blocks * BLOCK * WCUT_BIN_WIDTH < LONGEST && (blocks + 1) * BLOCK < c->bins / 2 &&
           (mean_off(c, open, 3, blocks) + mean_off(c, open, 5, blocks)) / 2 < -IN_LINE * error)
        blocks++;
    return blocks;
}

/* the first bins of a cut go */
static void drop_bins(wcut_evidence_cut *c, int count) {
    const size_t rest = (size_t)(c->bins - count) * sizeof(double);
    double *all[] = {c->middle, c->station, c->heat, c->pace, c->engaged};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) memmove(all[k], all[k] + count, rest);
    for (int s = 0; s < WCUT_SIGNALS; s++) {
        memmove(c->measured[s], c->measured[s] + count, rest);
        memmove(c->predicted[s], c->predicted[s] + count, rest);
    }
    c->bins -= count, c->from += count * WCUT_BIN_WIDTH;
}

double wcut_droop_leave_out(wcut_evidence *e, const double *open) {
    /* gravity pulls in every cut */
    double sum = 0;
    int cuts = 0;
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        if (c->bins == 0) continue;
        if (low_blocks(e, c, open) == 0) return 0;
        sum += (mean_off(c, open, 3, 0) + mean_off(c, open, 5, 0)) / 2, cuts++;
    }
    if (cuts == 0 || sum / cuts > -DOWN_MEAN) return 0;

    /* from the last cut on, whose rows lie behind those of the others */
    int most = 0;
    for (int k = e->cuts - 1; k >= 0; k--) {
        if (e->cut[k].bins == 0) continue;
        const int count = low_blocks(e, &e->cut[k], open) * BLOCK;
        drop_bins(&e->cut[k], count);
        most = count > most ? count : most;
    }

    /* rows of the cuts one after the other */
    e->rows = 0;
    for (int k = 0; k < e->cuts; k++) {
        e->cut[k].row = e->rows;
        e->rows += WCUT_SIGNALS * e->cut[k].bins + e->cut[k].patch.count;
    }

    return most * WCUT_BIN_WIDTH;
}
