/* wirecut/status.h - how a call ended, and where it failed. */
#ifndef WCUT_STATUS_H
#define WCUT_STATUS_H

#include <wirecut/export.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One list makes the enum and its texts, so they cannot drift apart. */
#define WCUT_STATUS_LIST(X)                                             \
    X(WCUT_OK, "ok")                                                    \
    X(WCUT_BAD_ARGUMENT, "an argument is outside its stated range")     \
    X(WCUT_NO_MEMORY, "out of memory")                                  \
    X(WCUT_NOT_CONVERGED, "the iteration stopped before its tolerance") \
    X(WCUT_SINGULAR, "the linear system has no unique solution")        \
    X(WCUT_DEGENERATE, "the geometry is degenerate")                    \
    X(WCUT_NOT_FOUND, "no such file or item")                           \
    X(WCUT_BAD_FORMAT, "the file does not follow its format")           \
    X(WCUT_NOT_WRITTEN, "the output is not wholly on disk")             \
    X(WCUT_INTERRUPTED, "stopped on request")                           \
    X(WCUT_INTERNAL, "a defect in this library; please report it")

#define WCUT_STATUS_ENTRY(name, text) name,
typedef enum wcut_status { WCUT_STATUS_LIST(WCUT_STATUS_ENTRY) WCUT_STATUS_COUNT } wcut_status;
#undef WCUT_STATUS_ENTRY

/** What went wrong and where: one line, a place and an expectation. */
typedef struct wcut_error {
    wcut_status status; /**< WCUT_OK where nothing failed */
    char text[480];     /**< "job.json: wire.nodes: found 2, expected an integer of at least 3" */
} wcut_error;

/**
 * The text of a status.
 *
 * @param[in] status any value
 * @return a constant string, never NULL; "unknown status" outside the enum.
 */
WCUT_API const char *wcut_status_text(wcut_status status);

#ifdef __cplusplus
}
#endif

#endif
