/* wirecut/correction.h - what a diagnosis changes in jobs, and how it is put into a job. */
#ifndef WCUT_CORRECTION_H
#define WCUT_CORRECTION_H

#include <wirecut/effects.h>
#include <wirecut/export.h>
#include <wirecut/job.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { WCUT_CORRECTION_EFFECTS = 8 };

/** The model that a diagnosis found: what its tables call "after". */
typedef struct wcut_correction {
    double a, b;          /**< [N/mm], [m^2/J] of the force law, positive */
    double length_change; /**< [mm] added to the wire's length */
    double kerf;          /**< [mm] constant kerf; NaN: no scan showed one, a job keeps its own */
    double kerf_per_q;    /**< [mm m^2/J] its growth with Q_eff */
    int effects;          /**< 0 .. WCUT_CORRECTION_EFFECTS */
    wcut_effect effect[WCUT_CORRECTION_EFFECTS]; /**< physics and instruments */
    int intervals; /**< effects, a growing kerf among them, whose size has a 95 % interval; not read by apply */
    double kerf_per_q_low, kerf_per_q_high; /**< [mm m^2/J] the ends of its interval; kerf_per_q where there is none */
    /** the effects with their sizes at the ends of their intervals, or as they are where there is none */
    wcut_effect low[WCUT_CORRECTION_EFFECTS], high[WCUT_CORRECTION_EFFECTS];
} wcut_correction;

/**
 * Read the correction of a diagnosis.json.
 *
 * @param[in]  path       "format": "wirecut-diagnosis/1"
 * @param[out] correction
 * @param[out] error      may be NULL; JSON path, found, expected; or why a diagnosis withholds its correction
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file), WCUT_BAD_FORMAT, WCUT_BAD_ARGUMENT (withheld: its verdict is unknown
 *         and nothing was modelled; a value out of range), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_correction_read(const char *path, wcut_correction *correction, wcut_error *error);

/**
 * Put a correction into a job: force law, wire length (path mode), kerf and effects; the job's own effects and its
 * excitation go.
 *
 * @param[in]     correction
 * @param[in,out] job        a filled job
 * @param[out]    error      may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (values out of range; a design, and an effect that needs mounts), WCUT_NO_MEMORY:
 *         the job is as it was.
 */
WCUT_API wcut_status wcut_correction_apply(const wcut_correction *correction, wcut_job *job, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
