/* wirecut/study.h - a study: one verb of the command, run for many variants of its input (libwirecut-io). */
#ifndef WCUT_STUDY_H
#define WCUT_STUDY_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { WCUT_STUDY_CASES_MAX = 1000000, WCUT_STUDY_HASH_SIZE = 65 };

/** A study file and what it refers to, read. */
typedef struct wcut_study wcut_study;

/** The contents of a study; the texts belong to the study. */
typedef struct wcut_study_info {
    const char *name;             /**< UTF-8 without control characters, as all texts here */
    const char *verb;             /**< "simulate" */
    int cases;                    /**< 1 .. WCUT_STUDY_CASES_MAX */
    int parameters;               /**< at least 1 */
    const char *const *parameter; /**< parameters: a JSON pointer into the input, or an option with its dashes */
    int figures;                  /**< at least 1 */
    const char *const *figure;    /**< figures: their names */
    const char *const *pointer;   /**< figures: JSON pointers into the verb's result */
    int best;                     /**< which figure the best cases are chosen by; -1: none */
    bool best_is_highest;         /**< else the lowest is the best */
} wcut_study_info;

/**
 * Read a study, "format": "wirecut-study/1", with the input that it varies. Names of files in it are relative to its
 * folder. Files that cases use as they are (other inputs, files that options name) are hashed.
 *
 * @param[in]  path  a JSON file
 * @param[out] study the caller's, to wcut_study_destroy
 * @param[out] error may be NULL; the place, what was found, what was expected; for a pointer without a value in the
 *                   input also the nearest pointer, for too many cases their number
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT, WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY:
 *         nothing was written.
 */
WCUT_API wcut_status wcut_study_read(const char *path, wcut_study **study, wcut_error *error);

/** Free a study; NULL is allowed. */
WCUT_API void wcut_study_destroy(wcut_study *study);

/**
 * The contents of a study.
 *
 * @return borrowed from the study; NULL: study is NULL.
 */
WCUT_API const wcut_study_info *wcut_study_view(const wcut_study *study);

/**
 * The value of a parameter in a case.
 *
 * @param[in]  study
 * @param[in]  k         0 .. cases - 1
 * @param[in]  parameter 0 .. parameters - 1
 * @param[out] text      JSON, for free()
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_study_value_print(const wcut_study *study, int k, int parameter, char **text);

/**
 * The input of a case: the study's with the case's values in their places, keys sorted, numbers the shortest that read
 * back the same.
 *
 * @param[in]  study
 * @param[in]  k     0 .. cases - 1
 * @param[out] text  JSON, for free(); "" where no parameter is a pointer: the input is used as it is
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_study_input_print(const wcut_study *study, int k, char **text);

/**
 * The hash of a case: the SHA-256 (FIPS 180-4) of its input, verb, options, the files it uses as they
 * are, and the version of the program. Cases of the same hash have the same results.
 *
 * @param[in]  study
 * @param[in]  k     0 .. cases - 1
 * @param[out] hash  WCUT_STUDY_HASH_SIZE bytes, 64 hexadecimal digits
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_study_hash_eval(const wcut_study *study, int k, char *hash);

/**
 * The words of the command that runs a case, one per line: verb, inputs, -o FOLDER, options. Names of files in them are
 * relative to the study's folder, except the input that is varied: FOLDER/input.json, or FOLDER/input/case.json where it is a
 * case of recordings.
 *
 * @param[in]  study
 * @param[in]  k      0 .. cases - 1
 * @param[in]  folder where the results go; no line feed in it
 * @param[out] text   for free()
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_study_call_print(const wcut_study *study, int k, const char *folder, char **text);

#ifdef __cplusplus
}
#endif

#endif
