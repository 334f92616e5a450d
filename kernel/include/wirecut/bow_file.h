/* wirecut/bow_file.h - a bow's results to files (libwirecut-io). */
#ifndef WCUT_BOW_FILE_H
#define WCUT_BOW_FILE_H

#include <wirecut/bow.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The files of a bow (FORMATS.md, Bow). */
typedef enum wcut_bow_file {
    WCUT_BOW_FILE_FIGURES,  /**< bow.json, "format": "wirecut-bow/1": largest figures and the feed chart */
    WCUT_BOW_FILE_STATIONS, /**< bow.csv: a row a station */
    WCUT_BOW_FILE_MAP,      /**< bow_map.csv: a row a node in the foam, with its departure from the ruled surface */
    WCUT_BOW_FILE_CHART     /**< feed_chart.csv: a row a heat and bow */
} wcut_bow_file;

/** The name of a file of a bow; NULL outside the enum. */
WCUT_API const char *wcut_bow_file_name(wcut_bow_file file);

/**
 * Write a file of a bow's results.
 *
 * @param[in]  results of wcut_bow_results_create
 * @param[in]  history that they are of
 * @param[in]  file    which
 * @param[in]  path    the target, replaced whole or left as it was
 * @param[out] error   may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_bow_results_write(const wcut_bow_results *results, const wcut_history *history,
                                            wcut_bow_file file, const char *path, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
