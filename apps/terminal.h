/* What reaches the user: lines on standard error, a progress bar on a terminal, exit codes, interruption. */
#ifndef APP_TERMINAL_H
#define APP_TERMINAL_H

#include <stdbool.h>
#include <wirecut/status.h>

/* One line on standard error. Whatever a file's or a job's name holds, no control character reaches the terminal. */
void app_say(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* "wirecut: ..." on standard error; gives the exit code back, so that `return app_fail(...)` reads well. */
int app_fail(int code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A library call's failure: "wirecut: PLACE: text", the exit code of its status. place may be NULL where the text
   begins with one. */
int app_fail_status(wcut_status status, const char *place, const wcut_error *error);

/* The exit code that a status stands for. */
int app_exit_code(wcut_status status);

/* Let SIGINT and SIGTERM set a flag, once: the second one ends the program as it would have. */
void app_catch_interrupts(void);
bool app_is_interrupted(void);

/* A bar of what is done, in how long; nothing where nobody sees it. */
typedef struct app_progress {
    bool visible;
    double begun, drawn; /* [s] */
    const char *unit;    /* what is counted: "stations" */
} app_progress;

app_progress app_progress_begin(bool quiet);

/* The columns of the terminal behind a descriptor, from 40; `without` where there is none. */
int app_terminal_width(int fd, int without);

/* A wcut_progress; context is an app_progress. Asks to stop once interrupted. */
int app_progress_step(int station, int stations, void *context);

/* Take the bar away. */
void app_progress_end(app_progress *progress);

#endif
