/* The library of explanations: what of each effect is fitted, on which scale, and which variants are tried first. */
#ifndef WCUT_EXPLAIN_LIBRARY_H
#define WCUT_EXPLAIN_LIBRARY_H

#include "explain/coordinate.h"
#include "explain/evidence.h"

enum { WCUT_COORDINATES = 5, WCUT_VARIANTS = 80 };

/* where a screen takes the column of a variant: choice, values 0 and 1, and what it needs */
typedef struct wcut_start {
    int choice;
    double value[2];
    bool carried; /* along from cut to cut: more than one cut */
} wcut_start;

enum { WCUT_STARTS = 10 };

/* What there is to know of a kind of effect beside its physics: a row of explain/library.c. */
typedef struct wcut_explanation {
    wcut_effect_kind kind;
    bool instrument;
    bool searched;      /* by the screen; false: found another way, or not at all */
    bool delay;         /* of readings: beside it there is no nuisance of delays */
    double gate;        /* practical size, of the first coordinate from its neutral: less is of no consequence */
    const char *phrase; /* a sentence's subject */
    const char *number; /* a printf format of one double: its first value */
    double unit;        /* of the value as it is shown */
    int count;
    wcut_coordinate coordinate[WCUT_COORDINATES]; /* what is fitted; the strengths first */
    int starts;
    wcut_start start[WCUT_STARTS];
} wcut_explanation;

const wcut_explanation *wcut_explanation_view(wcut_effect_kind kind);

/* the k-th thing fitted of an effect: as its kind says, but that a kerf law of the other kind has its own coefficient */
wcut_coordinate wcut_effect_coordinate(const wcut_effect *effect, int k);

/* how many things of an effect are fitted; a step of density has a place beside its size */
int wcut_effect_coordinates(const wcut_effect *effect);

/* The nth form of an effect's family, at the same place, where its fit begins: the effect itself among them. False where
   there are no more. */
bool wcut_effect_form(const wcut_effect *effect, int nth, wcut_effect *form);

/* value on the fitted scale and back */
double wcut_scale_in(wcut_coordinate_scale scale, double value);
double wcut_scale_out(wcut_coordinate_scale scale, double x);

/* neutral value of a kind's first coordinate on the fitted scale */
double wcut_explanation_neutral(wcut_effect_kind kind);

/* size of an effect in units of its kind's gate, not negative */
double wcut_effect_size(const wcut_effect *effect);

/* One thing to try: an effect with its choice and shape parameters, at a strength at which its column is taken. */
typedef struct wcut_variant {
    wcut_effect effect;
    bool carried;
} wcut_variant;

/* The variants of all kinds that `without` leaves, but inclusions (they are searched by place); out: WCUT_VARIANTS.
   several: more than one cut; scans: any. Gives how many. */
int wcut_library_variants(const bool without[WCUT_EFFECT_COUNT], bool several, bool scans, wcut_variant *out);

#endif
