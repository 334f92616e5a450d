/* The dictionary: empirical terms that the foam's force may follow, as a case is searched for them. */
#ifndef WCUT_EXPLAIN_DICTIONARY_H
#define WCUT_EXPLAIN_DICTIONARY_H

#include "explain/coordinate.h"
#include "explain/evidence.h"

/* An entry: a term of empirical_force at a shape; its coefficient is what is sought. */
typedef struct wcut_entry {
    wcut_effect effect; /* coefficient 1; of a wave's second entry the cosine 1 */
    bool carried;       /* time and way go on from cut to cut */
    bool pair;          /* the next entry is the cosine of this sine */
} wcut_entry;

enum { WCUT_ENTRIES_MAX = 600 };

/* What is tried in a case: shapes over the ranges of its blocks, speeds and heats. out: WCUT_ENTRIES_MAX. Gives how
   many. */
int wcut_dictionary_list(const wcut_evidence *evidence, wcut_entry *out);

/* Which node counts how much: all in the foam alike, those near mount A more, those near mount B more. */
typedef enum wcut_weight { WCUT_WEIGHT_EVEN, WCUT_WEIGHT_A, WCUT_WEIGHT_B, WCUT_WEIGHTS } wcut_weight;

/*
 * phi of an entry in the bins of a cut: the simulator's own formula at the nodes of a response along the exogenous
 * trajectory, mean over the wire in the foam. response: with positions; out: WCUT_WEIGHTS x bins.
 * WCUT_OK; WCUT_NO_MEMORY.
 */
wcut_status wcut_dictionary_eval(const wcut_evidence *evidence, int cut, const wcut_response *response,
                                 const wcut_entry *entry, double *out);

/* how many values of an empirical term are fitted, and the k-th */
int wcut_term_coordinates(const wcut_effect *effect);
wcut_coordinate wcut_term_coordinate(const wcut_effect *effect, int k);

#endif
