/* The next experiment: of the cuts that could be made, the one in which two explanations differ most. */
#ifndef WCUT_EXPLAIN_EXPERIMENT_H
#define WCUT_EXPLAIN_EXPERIMENT_H

#include <wirecut/diagnosis.h>

#include "explain/stop.h"

/*
 * Every candidate is predicted with the effects a, with the effects b, and with a, b and the wire's length of the plain
 * model changed, all along one planned motion. What a refit of these three, of a constant kerf and of the strength of
 * one explanation (within 30 %) could explain is taken out of the difference; what is left, in units of the sensors'
 * noise and the less of both ways round, is the candidate's separation. Candidates: the cut as it is, a dithered speed,
 * heater steps, both, the path backwards, three quarters of the width, a fifth less and a quarter more heat, a quarter
 * more tension, a cold entry. Scans count where an explanation moves the face or the scan.
 *
 * job: path mode, with what is known of a, b; its own excitation is not used. count_a, a; count_b, b: each explanation,
 * 0 for the plain model. best: the candidate's job, named, without effects beyond those of job, the caller's.
 * separation: [1] its distance in standard deviations. reason: for an operator, also where nothing tells them apart
 * (separation below 3).
 * WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (job cannot be simulated, nor any candidate), WCUT_NO_MEMORY: nothing was
 * written. Candidates that cannot be run are passed over.
 */
wcut_status wcut_experiment_choose(const wcut_job *job, int count_a, const wcut_effect *a, int count_b,
                                   const wcut_effect *b, wcut_stop *stop, wcut_job **best, double *separation,
                                   char reason[WCUT_DIAGNOSIS_TEXT], wcut_error *error);

#endif
