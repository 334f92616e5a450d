/* Redundancy: what a recording holds twice, and what a job says that its recording shows. Compared before any physics. */
#ifndef WCUT_EXPLAIN_REDUNDANCY_H
#define WCUT_EXPLAIN_REDUNDANCY_H

#include <wirecut/diagnosis.h>

enum { WCUT_CONTRADICTIONS_MAX = 16 };

/* A case as it came in, but for the columns and programmes that a contradiction set right. */
typedef struct wcut_redundancy {
    int cuts;
    const wcut_diagnosis_cut *given; /* borrowed */
    const wcut_recording *still;     /* borrowed; NULL: none */
    wcut_diagnosis_cut *cut;         /* cuts */
    wcut_job *job;                   /* cuts: shallow, what they point to is the caller's */
    wcut_recording *recording;       /* cuts: shallow but for the columns below */
    int columns;                     /* that are owned */
    double **column;
    char *made; /* the name of a channel that a file had not */
    int count;
    wcut_contradiction *found; /* count of WCUT_CONTRADICTIONS_MAX */
} wcut_redundancy;

/*
 * Compare, in this order, and set right what can be: the programme of an excitation with the recorded speed and heat; the
 * heater's volts times amperes with its set power; stations with speeds and measured places; measured places with the path;
 * tensions in the air with zero, or those of a record at rest (still, may be NULL). given: cuts, borrowed. WCUT_OK; WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_redundancy_create(int cuts, const wcut_diagnosis_cut *given, const wcut_recording *still,
                                   wcut_redundancy *out, wcut_error *error);

/* WCUT_OK where a record at rest (may be NULL) has samples; else WCUT_BAD_ARGUMENT */
wcut_status wcut_redundancy_check(const wcut_recording *still, wcut_error *error);

void wcut_redundancy_destroy(wcut_redundancy *redundancy);

/* ---- what the checks share ---- */

/* a sample of a channel in its unit; false where it is missing or the file has no such column */
bool wcut_sample_at(const wcut_recording *recording, wcut_channel channel, int sample, double *value);

/* [W/m] heater_V times heater_A over the wire's length; false where one of them is missing */
bool wcut_heater_power(const wcut_job *job, const wcut_recording *recording, int sample, double *power);

/* whether a cut has a job with a path and a recording */
bool wcut_redundancy_has(const wcut_redundancy *redundancy, int cut);

/* A new contradiction about no cut yet; NULL where there are as many as can be. Its text is printed by the caller. */
wcut_contradiction *wcut_contradiction_add(wcut_redundancy *redundancy, wcut_contradiction_kind kind,
                                           const char *column);
void wcut_contradiction_add_cut(wcut_contradiction *contradiction, int cut);

/* "cut 3", "cuts 1, 2 and 5", "all cuts" */
enum { WCUT_CUT_LIST = 120 };
void wcut_cut_list(const wcut_redundancy *redundancy, const wcut_contradiction *contradiction,
                   char text[WCUT_CUT_LIST]);

/* An own copy of a channel of a cut's recording, to be written; created where the file has none. NULL: no memory. */
double *wcut_redundancy_column(wcut_redundancy *redundancy, int cut, wcut_channel channel);

/* the checks; WCUT_OK, WCUT_NO_MEMORY */
wcut_status wcut_excitation_compare(wcut_redundancy *all);
wcut_status wcut_heater_compare(wcut_redundancy *all);
wcut_status wcut_motion_compare(wcut_redundancy *all);
wcut_status wcut_zero_compare(wcut_redundancy *all);

/*
 * Hand the contradictions over: the list, a sentence for each before the diagnosis's own, and, where the search came to its
 * end (decided), what they make of the verdict: an instrument's fault, and a zero that is the same in all cuts as an
 * effect. false: no memory.
 */
bool wcut_contradictions_report(const wcut_redundancy *redundancy, bool decided, wcut_diagnosis *diagnosis);

#endif
