/* Work in a process of its own, with limits, so that what it crashes on or loops over is its end alone. */
#ifndef WCUT_IO_FILE_CHILD_H
#define WCUT_IO_FILE_CHILD_H

#include <stdbool.h>
#include <stddef.h>

/* in the child: do it, write the result to fd, and return 0; other numbers are handed to the parent */
typedef int wcut_child_work(int fd, void *context);

typedef struct wcut_child_limits {
    int seconds;     /* of the clock and of the processor */
    size_t memory;   /* [byte] beside what the parent has */
    size_t response; /* [byte] the most it may write */
} wcut_child_limits;

/* how it ended */
typedef struct wcut_child_end {
    enum {
        WCUT_CHILD_DONE,        /* `code` is what the work returned */
        WCUT_CHILD_CRASHED,     /* by signal `code` */
        WCUT_CHILD_SLOW,        /* more than `seconds` */
        WCUT_CHILD_TALKATIVE,   /* more than `response` */
        WCUT_CHILD_NO_MEMORY,   /* the parent has none for the response */
        WCUT_CHILD_NOT_STARTED, /* `code` is an errno */
    } how;
    int code;
} wcut_child_end;

/* Fork, and collect what the child writes; data is the caller's to free() where the end is WCUT_CHILD_DONE, NULL
   otherwise. The child has no file open but its answer's pipe, can open none, write none and start no process. */
wcut_child_end wcut_child_run(wcut_child_work *work, void *context, const wcut_child_limits *limits, char **data,
                              size_t *length);

/* all of it; for the child. false: the parent is gone */
bool wcut_child_write(int fd, const void *data, size_t size);

#endif
