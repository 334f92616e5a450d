/* wirecut/compensation_file.h - what a compensation is worth, to a file and in a sentence. */
#ifndef WCUT_COMPENSATION_FILE_H
#define WCUT_COMPENSATION_FILE_H

#include <wirecut/compensation.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What is written of a compensation; everything is borrowed. */
typedef struct wcut_compensation_result {
    const char *job;    /**< the file's name */
    const char *with;   /**< of what the machine does */
    const char *target; /**< of the target; NULL: the job's own planned face */
    const wcut_compensation *compensation;
    int interval; /**< 1: the figures below are at the ends of the diagnosis' 95 % intervals; 0: changed by the spread */
    double spread;         /**< [1] by which the effects' sizes were changed for the figures below, without intervals */
    double smaller_rms;    /**< [mm] after, where the effects are smaller by the spread than assumed */
    double smaller_before; /**< [mm] before, where they are */
    double larger_rms;     /**< [mm] after, where they are larger by it */
    double larger_before;  /**< [mm] before, where they are */
    double worth;          /**< [mm] rms below which a correction is not worth it */
    int effects;           /**< of the machine, 0 or more */
    const wcut_effect *effect; /**< effects */
    const double *moved;       /**< effects [mm] rms by which each alone moves the face off its target */
} wcut_compensation_result;

/**
 * The text of compensation.json, "wirecut-compensation/1" (FORMATS.md, Compensation).
 *
 * @param[in]  result every pointer as its field says
 * @param[out] text   the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_compensation_print(const wcut_compensation_result *result, char **text);

/**
 * One sentence on a result: what is removed, what is left where the effects are off, whether it is worth it.
 *
 * @param[in]  result every pointer as its field says
 * @param[in]  size   of the text with its final zero, 1 or more; longer sentences are cut
 * @param[out] text   size
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_compensation_say(const wcut_compensation_result *result, int size, char *text);

#ifdef __cplusplus
}
#endif

#endif
