/* Quantities along the exogenous trajectory that the foam's force might follow. */
#ifndef WCUT_EXPLAIN_FEATURES_H
#define WCUT_EXPLAIN_FEATURES_H

#include "explain/evidence.h"

enum { WCUT_WAVES = 90, WCUT_LATENCIES = 2, WCUT_FEATURES_MOST = 40 + 2 * WCUT_WAVES };

/* A quantity; a sine and a cosine of one wavelength follow each other and make one quantity. */
typedef struct wcut_feature {
    char name[40]; /* of a sine with %s where its phase goes */
    int what;      /* which, and below its constant: exponent, [s] or [mm] */
    double constant;
    bool wave;    /* first of a pair */
    bool latency; /* a memory so short that it is a latency of instruments; WCUT_LATENCIES of them */
} wcut_feature;

/* Which node counts how much: all in the foam alike, those near mount A more, those near mount B more. */
typedef enum wcut_weight { WCUT_WEIGHT_EVEN, WCUT_WEIGHT_A, WCUT_WEIGHT_B, WCUT_WEIGHTS } wcut_weight;

/* out: WCUT_FEATURES_MOST; gives how many. several: more than one cut. */
int wcut_features_list(bool several, wcut_feature *out);

/* A feature in the bins of a cut, mean over the wire in the foam; driven: along the exogenous trajectory with positions;
   out: WCUT_WEIGHTS x bins. */
void wcut_feature_eval(const wcut_evidence_cut *cut, const wcut_response *driven, const wcut_feature *feature,
                       double *out);

#endif
