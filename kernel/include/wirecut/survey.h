/* wirecut/survey.h - deviations in zones, with a verdict each, and profiles along sections. */
#ifndef WCUT_SURVEY_H
#define WCUT_SURVEY_H

#include <wirecut/deviation.h>
#include <wirecut/export.h>
#include <wirecut/regions.h>
#include <wirecut/statistics.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What was measured in a zone. */
typedef struct wcut_region_result {
    int count;                          /**< deviations whose feet are in it; where it is 0 so is the rest */
    double mean, std, rms, mae;         /**< [mm] mae: mean |d| */
    double min, max;                    /**< [mm] */
    double within;                      /**< [1] share with |d| <= tolerance; 0 without one */
    double within_band[WCUT_BANDS_MAX]; /**< [1] share with |d| <= each band of the survey */
    int passed; /**< 1, or 0 where too few are within or none was measured; -1 without a tolerance */
} wcut_region_result;

/** A step of a section. */
typedef struct wcut_section_row {
    double along;             /**< [mm] of its middle from the line's beginning */
    double x, y;              /**< [mm] of its middle */
    int count;                /**< deviations; where it is 0 the rest is */
    double nominal, measured; /**< [mm] mean heights z of the feet and of the points */
    double deviation;         /**< [mm] mean */
} wcut_section_row;

typedef struct wcut_section_result {
    int rows;
    const wcut_section_row *row;
} wcut_section_result;

/** What was measured in all of them. */
typedef struct wcut_survey_result {
    const wcut_regions *of;             /**< that the survey was made for */
    int bands;                          /**< of each zone */
    const wcut_region_result *region;   /**< of->regions */
    const wcut_section_result *section; /**< of->sections */
    int passed;                         /**< 0 where a zone failed, else 1 */
} wcut_survey_result;

/** A survey in progress; its memory does not grow with the count of points. */
typedef struct wcut_survey wcut_survey;

/**
 * Begin a survey.
 *
 * @param[in]  regions borrowed for as long as the survey lives
 * @param[in]  bands   0 .. WCUT_BANDS_MAX
 * @param[in]  band    bands [mm] positive tolerances whose shares are counted in every zone
 * @param[out] survey  the caller's, to wcut_survey_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (also a section of more than 1,000,000 steps), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_survey_create(const wcut_regions *regions, int bands, const double *band,
                                        wcut_survey **survey);

/**
 * Add points and their deviations; those beyond or ambiguous are skipped.
 *
 * @param[in,out] survey    not in use by another thread
 * @param[in]     count     0 or more
 * @param[in]     point     count [mm]
 * @param[in]     deviation count
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was added.
 */
WCUT_API wcut_status wcut_survey_add(wcut_survey *survey, int count, const wcut_vec3 *point,
                                     const wcut_deviation *deviation);

/** What was found so far, borrowed until the next call with this survey; NULL gives NULL. */
WCUT_API const wcut_survey_result *wcut_survey_eval(wcut_survey *survey);

/** Free a survey; NULL is allowed. */
WCUT_API void wcut_survey_destroy(wcut_survey *survey);

/**
 * sections.csv: a row a step of a section; empty fields where nothing was measured.
 *
 * @param[in]  result of wcut_survey_eval
 * @param[in]  path   the target, replaced whole or left as it was
 * @param[out] error  may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_sections_write(const wcut_survey_result *result, const char *path, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
