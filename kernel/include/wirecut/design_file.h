/* wirecut/design_file.h - the map of a target and a design's figures to files. */
#ifndef WCUT_DESIGN_FILE_H
#define WCUT_DESIGN_FILE_H

#include <wirecut/design.h>
#include <wirecut/design_panels.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What is written of a design; everything is borrowed. */
typedef struct wcut_design_result {
    const char *target; /**< the file's name */
    double tolerance;   /**< [mm] that the rms is to hold */
    const wcut_design_map *map;
    const wcut_design *design;        /**< NULL: the map alone, or panels */
    const wcut_design_panels *panels; /**< two or more; NULL: one cut or none */
    double face_rms; /**< [mm] of the face that the robot's paths cut; not read without a design or panels */
    double face_max; /**< [mm] */
} wcut_design_result;

/**
 * The text of feasibility.json, "wirecut-feasibility/1" (FORMATS.md, Design).
 *
 * @param[in]  result every pointer as its field says
 * @param[out] text   the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_design_result_print(const wcut_design_result *result, char **text);

/**
 * The same text into a file.
 *
 * @param[in]  result every pointer as its field says
 * @param[in]  path   the target, replaced whole or left as it was
 * @param[out] error  may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_design_result_write(const wcut_design_result *result, const char *path, wcut_error *error);

/**
 * Write a map as a PNG picture from above, x to the right and y up: orange where a wire runs above the target, blue
 * where below, grey at 0; striped where the bow exceeds the tolerance and has a reason.
 *
 * @param[in]  map   of wcut_design_map_create
 * @param[in]  limit [mm] of the strongest colours, positive
 * @param[in]  path  the target, replaced whole or not at all
 * @param[out] error may be NULL
 * @return WCUT_OK: wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the target is as it was.
 */
WCUT_API wcut_status wcut_design_map_write_png(const wcut_design_map *map, double limit, const char *path,
                                               wcut_error *error);

/**
 * One sentence on a result: whether the tolerance is held, how near the cut comes and why not nearer.
 *
 * @param[in]  result every pointer as its field says
 * @param[in]  size   of the text with its final zero, 1 or more; longer sentences are cut
 * @param[out] text   size
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_design_result_say(const wcut_design_result *result, int size, char *text);

#ifdef __cplusplus
}
#endif

#endif
