/* wirecut/sweep.h - the cases of a study, run by a pool of processes into a folder (libwirecut-io). */
#ifndef WCUT_SWEEP_H
#define WCUT_SWEEP_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/status.h>
#include <wirecut/study.h>

#ifdef __cplusplus
extern "C" {
#endif

/** State of a case: X(enumerator, word in files, whether it is final: a sweep does not run it again). */
#define WCUT_SWEEP_STATE_LIST(X)                                                                      \
    X(WCUT_SWEEP_STATE_MISSING, "missing", false)            /**< not run, or not to its end */       \
    X(WCUT_SWEEP_STATE_DONE, "done", true)                   /**< with its results */                 \
    X(WCUT_SWEEP_STATE_OUTSIDE, "outside", true)             /**< with results outside a tolerance */ \
    X(WCUT_SWEEP_STATE_NOT_CONVERGED, "not_converged", true) /**< with what was computed */           \
    X(WCUT_SWEEP_STATE_REFUSED, "refused", true)             /**< its input is wrong */               \
    X(WCUT_SWEEP_STATE_FAILED, "failed", false)              /**< memory or disk was short */         \
    X(WCUT_SWEEP_STATE_CRASHED, "crashed", false)            /**< ended by a signal */

#define WCUT_SWEEP_STATE_ENTRY(name, word, final) name,
typedef enum wcut_sweep_state { WCUT_SWEEP_STATE_LIST(WCUT_SWEEP_STATE_ENTRY) WCUT_SWEEP_STATE_COUNT } wcut_sweep_state;
#undef WCUT_SWEEP_STATE_ENTRY

enum { WCUT_SWEEP_JOBS_MAX = 256 };

/** A folder with the cases of a study. */
typedef struct wcut_sweep wcut_sweep;

/** How cases are run. */
typedef struct wcut_sweep_options {
    const char *program; /**< the command, "wirecut"; a path or a name on the search path */
    const char *word;    /**< a further word for every call, such as --threads=1; NULL: none. Not a part of the hash */
    int jobs;            /**< 1 .. WCUT_SWEEP_JOBS_MAX processes at a time; default 1 */
    int share, shares;   /**< run cases k with k mod shares = share; default 0 of 1: all */
    int limit;           /**< run no more than so many; default 0: no limit */
    wcut_progress progress; /**< called with cases looked at and their number; may be NULL; not 0 ends the run */
    void *context;          /**< for progress */
} wcut_sweep_options;

/** Counts of the cases of a run or of a sweep. */
typedef struct wcut_sweep_counts {
    int cases;                         /**< of the share */
    int state[WCUT_SWEEP_STATE_COUNT]; /**< number of cases in each */
    int ran;                           /**< run now, in whatever state they ended; the others were whole before */
    double seconds;                    /**< [s] sum of the times of those that were run now */
} wcut_sweep_counts;

/** The word of a state in files; NULL outside the enum. */
WCUT_API const char *wcut_sweep_state_name(wcut_sweep_state state);

/** One process at a time, all cases; program is NULL and has to be set. */
WCUT_API wcut_sweep_options wcut_sweep_options_default(void);

/**
 * Plan a sweep: read a study, make the folder and put study.json, input.json and manifest.csv there, under the voucher
 * plan.json. Cases that are in the folder from an earlier run stay. The folder is locked until wcut_sweep_destroy.
 *
 * @param[in]  path   a study
 * @param[in]  folder no line feed in its path
 * @param[out] sweep  the caller's, to wcut_sweep_destroy
 * @param[out] error  may be NULL
 * @return WCUT_OK; the statuses of wcut_study_read and wcut_results_commit; WCUT_NOT_WRITTEN (another sweep runs in the
 *         folder: the text names its process): no file of the folder was changed.
 */
WCUT_API wcut_status wcut_sweep_create(const char *path, const char *folder, wcut_sweep **sweep, wcut_error *error);

/**
 * Open a sweep that was planned, from any machine that sees the folder.
 *
 * @param[in]  folder
 * @param[out] sweep  the caller's, to wcut_sweep_destroy
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_NOT_FOUND (no plan.json), WCUT_BAD_FORMAT (changed since, or of another version),
 *         WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_sweep_read(const char *folder, wcut_sweep **sweep, wcut_error *error);

/** Free a sweep and unlock its folder; NULL is allowed. */
WCUT_API void wcut_sweep_destroy(wcut_sweep *sweep);

/** The study of a sweep, borrowed from it; NULL: sweep is NULL. */
WCUT_API const wcut_study *wcut_sweep_view(const wcut_sweep *sweep);

/**
 * Run the cases that are not whole, each in a process and a folder of its own: cases/HH/HASH, HH the first digits of
 * the hash. A case is whole where case.json says so and its files are as their voucher lists them. A case that fails
 * or crashes is recorded with the end of its output and does not stop the others. Processes that still run when the
 * caller's process ends are ended with it.
 *
 * @param[in]  sweep
 * @param[in]  options
 * @param[out] counts may be NULL; also filled where the run was interrupted
 * @param[out] error  may be NULL
 * @return WCUT_OK, whatever the states of the cases; WCUT_INTERRUPTED (the processes were asked to end and have ended),
 *         WCUT_NOT_WRITTEN (the folder; another sweep runs in it), WCUT_NOT_FOUND (the program cannot be started),
 *         WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: cases that are whole stay.
 */
WCUT_API wcut_status wcut_sweep_run(wcut_sweep *sweep, const wcut_sweep_options *options, wcut_sweep_counts *counts,
                                    wcut_error *error);

/**
 * Count the states of all cases, as their case.json has them.
 *
 * @param[in]  sweep
 * @param[out] counts ran is 0, seconds those of all that were run
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_sweep_query(const wcut_sweep *sweep, wcut_sweep_counts *counts, wcut_error *error);

/**
 * Estimate time and disk of a sweep from its first case, which is run.
 *
 * @param[in]  sweep
 * @param[in]  options jobs: for how many processes; share and shares are ignored
 * @param[out] seconds [s] of the first case alone
 * @param[out] total   [s] of all cases with that many processes
 * @param[out] bytes   [byte] on disk of all cases
 * @param[out] error   may be NULL
 * @return WCUT_OK, the statuses of wcut_sweep_run; WCUT_DEGENERATE (the first case has no result; the error has the
 *         end of its output): nothing was written.
 */
WCUT_API wcut_status wcut_sweep_measure(wcut_sweep *sweep, const wcut_sweep_options *options, double *seconds,
                                        double *total, double *bytes, wcut_error *error);

/**
 * Check that the first result has every figure of the study: a misspelt pointer is found while the sweep runs.
 *
 * @param[in]  sweep
 * @param[out] error may be NULL; the missing figure, and the nearest pointer
 * @return WCUT_OK, also where there is no result yet; WCUT_NOT_FOUND, WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY.
 */
WCUT_API wcut_status wcut_sweep_figures_query(const wcut_sweep *sweep, wcut_error *error);

/**
 * Write the table of a sweep: one row per case with its parameters, figures and state, in the order of the cases. The
 * same bytes whatever the order, the number of processes and the machine.
 *
 * @param[in]  sweep
 * @param[in]  path  the target, replaced whole or not at all
 * @param[out] error may be NULL; for a figure that no result has also the nearest pointer
 * @return WCUT_OK; WCUT_NOT_FOUND (a figure that no result has), WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN, WCUT_NO_MEMORY:
 *         the target is as it was.
 */
WCUT_API wcut_status wcut_sweep_write_csv(const wcut_sweep *sweep, const char *path, wcut_error *error);

/**
 * The summary of a sweep: states, the range of every figure, the best cases.
 *
 * @param[in]  sweep
 * @param[out] text  JSON "wirecut-sweep/1", for free()
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_sweep_print(const wcut_sweep *sweep, char **text, wcut_error *error);

/** An array job of Slurm that runs a planned sweep: task i takes the i-th share of the cases. */
typedef struct wcut_slurm {
    const char *program;   /**< the command, a path that is valid on every node */
    int tasks;             /**< 1 .. 100000 */
    int cpus;              /**< of a task, processes at a time; at least 1 */
    const char *partition; /**< NULL: the default one; letters, digits and ._-, as time and memory */
    const char *time;      /**< NULL: the default; "1:00:00" */
    const char *memory;    /**< of a task; NULL: the default; "2G" */
    const char *modules;   /**< names for `module load`, with commas; NULL: none */
} wcut_slurm;

/**
 * Write the batch script for sbatch.
 *
 * @param[in]  sweep
 * @param[in]  slurm
 * @param[in]  path  the target, replaced whole or not at all
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a character that such a word cannot have), WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the
 *         target is as it was.
 */
WCUT_API wcut_status wcut_slurm_write(const wcut_sweep *sweep, const wcut_slurm *slurm, const char *path,
                                      wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
