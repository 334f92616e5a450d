/* What a search has fitted. */
#include "explain/candidates.h"

const wcut_fitted *wcut_search_base(const wcut_search *s) {
    return s->delayed >= 0 ? &s->candidate[s->delayed].fit : &s->none;
}
