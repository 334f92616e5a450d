/* wirecut/results.h - a run's files, put into their folder together or not at all, under a voucher. */
#ifndef WCUT_RESULTS_H
#define WCUT_RESULTS_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The most files in a set, and the longest name of one with its zero byte. */
enum { WCUT_RESULTS_MAX = 256, WCUT_RESULTS_NAME_SIZE = 200 };

/** A set of files that is being written. The folder keeps its files until wcut_results_commit. */
typedef struct wcut_results wcut_results;

/**
 * Begin a set: make the folder, with those above it, and in it a hidden folder for the new files.
 *
 * What a dead process left in the folder is put right first: a set that was being moved out is finished, one that was
 * in the making is removed.
 *
 * @param[in]  folder  where the set goes
 * @param[in]  count   0 .. WCUT_RESULTS_MAX
 * @param[in]  name    count names that the set may have, others too; each must be free or an ordinary file that may be
 *                     replaced, so that a long run does not fail at its end. A file of such a name that is not in
 *                     the set is removed with the earlier set. May be NULL where count is 0.
 * @param[out] results for wcut_results_destroy
 * @param[out] error   may be NULL; names the folder or the file in it
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN (no folder, or one that may not be written to; another process
 *         moves a set there for more than 30 s), WCUT_NO_MEMORY: no file of the folder was changed.
 */
WCUT_API wcut_status wcut_results_create(const char *folder, int count, const char *const *name, wcut_results **results,
                                         wcut_error *error);

/**
 * Where a file of the set is to be written: a path in the hidden folder.
 *
 * @param[in] results
 * @param[in] name UTF-8 without control characters and '/', no '.' in front
 * @return the path, valid until the next call; NULL: the name is not valid, or no memory.
 */
WCUT_API const char *wcut_results_path(wcut_results *results, const char *name);

/**
 * Take a written file into the set. Those that are not taken are dropped at the end.
 *
 * @param[in]  results
 * @param[in]  name as in wcut_results_path
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (no such name, in the set already, too many), WCUT_NOT_FOUND (nothing was written
 *         there): the set is as it was.
 */
WCUT_API wcut_status wcut_results_add(wcut_results *results, const char *name, wcut_error *error);

/**
 * Replace the hidden folder in an error's text by the folder of the set.
 *
 * @param[in]     results may be NULL
 * @param[in,out] error   may be NULL
 */
WCUT_API void wcut_results_reword(const wcut_results *results, wcut_error *error);

/**
 * Put the set into its folder, under a voucher: a JSON object to which "files", the names, and "sha256", the SHA-256 of
 * each file (FIPS 180-4) by name, are added.
 *
 * Every file is on disk before; then the earlier voucher is removed, the files are renamed, and the voucher comes last.
 * Another process that commits to the same folder is waited for. A process that is killed in between leaves a journal:
 * the next wcut_results_create or wcut_results_verify in that folder finishes the set.
 *
 * @param[in]  results its set is empty afterwards, whatever the outcome
 * @param[in]  voucher name of the voucher, *.json
 * @param[in]  text    an object that ends with a brace
 * @param[out] whole   the text of the voucher, for free(); may be NULL
 * @param[out] error   may be NULL
 * @return WCUT_OK: wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the folder has its earlier
 *         files. Where restoring them failed too, the text says so, and the journal stays.
 */
WCUT_API wcut_status wcut_results_commit(wcut_results *results, const char *voucher, const char *text, char **whole,
                                         wcut_error *error);

/**
 * Free a set; what was not committed is removed.
 *
 * @param[in] results may be NULL
 */
WCUT_API void wcut_results_destroy(wcut_results *results);

/** State of a file against its voucher. */
typedef enum wcut_result_state {
    WCUT_RESULT_STATE_WHOLE,   /**< as it was written */
    WCUT_RESULT_STATE_CHANGED, /**< other bytes than those written, or no ordinary file */
    WCUT_RESULT_STATE_MISSING, /**< not there */
} wcut_result_state;

/** A file that a voucher lists. */
typedef struct wcut_verified_file {
    char *voucher, *name;
    wcut_result_state state;
} wcut_verified_file;

/** A folder's files against its vouchers. */
typedef struct wcut_verification {
    int vouchers, count; /**< vouchers found, files that they list */
    int broken;          /**< files that are changed or missing */
    wcut_verified_file *file;
} wcut_verification;

/**
 * Check the files of a folder against the vouchers in it: the JSON files with "files" and "sha256".
 *
 * A set that a killed process left half moved is finished first. A voucher's own figures have no hash.
 *
 * @param[in]  folder
 * @param[out] verification for wcut_verification_destroy
 * @param[out] error        may be NULL
 * @return WCUT_OK, also where files are broken; WCUT_BAD_ARGUMENT, WCUT_NOT_FOUND (no such folder, no voucher in it, a
 *         file that cannot be read), WCUT_NOT_WRITTEN (a set cannot be finished), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_results_verify(const char *folder, wcut_verification **verification, wcut_error *error);

/**
 * Free a verification.
 *
 * @param[in] verification may be NULL
 */
WCUT_API void wcut_verification_destroy(wcut_verification *verification);

#ifdef __cplusplus
}
#endif

#endif
