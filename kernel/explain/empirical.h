/* Physics outside the library, modelled: empirical terms of the force chosen step by step, each confirmed on other cuts. */
#ifndef WCUT_EXPLAIN_EMPIRICAL_H
#define WCUT_EXPLAIN_EMPIRICAL_H

#include "explain/dictionary.h"
#include "explain/search.h"

enum { WCUT_EMPIRICAL_TERMS = 3, WCUT_EMPIRICAL_RIVALS = 4 };

/* a term that explains as much as one that was chosen */
typedef struct wcut_empirical_rival {
    wcut_effect effect;
    bool carried;
    int instead_of; /* the chosen term */
    double behind;  /* what it gains less, in units of noise */
} wcut_empirical_rival;

typedef struct wcut_empirical {
    wcut_fitted fit;                   /* the model with its terms; effects 0: nothing was confirmed */
    wcut_residual_stats left;          /* what it leaves */
    double gain, held_out;             /* fall of the misfit, fitted; on cuts that were not */
    double size[WCUT_EMPIRICAL_TERMS]; /* largest c phi of a bin, of each term */
    int rivals;
    wcut_empirical_rival rival[WCUT_EMPIRICAL_RIVALS];
} wcut_empirical;

/*
 * Search the dictionary about a recalibrated model. Every step screens all entries as columns along the exogenous
 * trajectory, with the instruments and nuisances of the fit beside them, fits the best in full by the simulator, and
 * takes the one that gains most if it gains on cuts that were not fitted. Two terms; a third where it halves what is
 * left.
 * WCUT_OK, with or without terms; WCUT_INTERRUPTED, WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_empirical_find(const wcut_evidence *evidence, const wcut_fitted *recalibrated, wcut_empirical *out,
                                wcut_error *error);
void wcut_empirical_destroy(wcut_empirical *empirical);

#endif
