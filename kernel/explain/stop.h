/* A request to stop, heard within every drive of a wire: asked for in the caller's thread, seen in all. */
#ifndef WCUT_EXPLAIN_STOP_H
#define WCUT_EXPLAIN_STOP_H

#include <pthread.h>
#include <stdatomic.h>
#include <wirecut/history.h>

typedef struct wcut_stop {
    wcut_progress progress; /* NULL: nobody asks */
    void *context;
    pthread_t owner;   /* the thread that progress is called in, and no other */
    const char *stage; /* what is being done, a constant text: "pairs of effects were fitted" */
    int done, steps;   /* written by the owner alone */
    atomic_bool asked; /* stays true */
} wcut_stop;

/* nothing done of so many steps; the caller's thread owns it */
void wcut_stop_begin(wcut_stop *stop, wcut_progress progress, void *context, int steps);

/* What is begun now, after so many steps, which never go back; gives whether it shall not be. stop: may be NULL. */
bool wcut_stop_step(wcut_stop *stop, const char *stage, int done);

/* Whether a stop was asked for; asks, where it is the owner who calls. stop: may be NULL. */
bool wcut_stop_asked(wcut_stop *stop);

/* the same as a wcut_progress; context: a wcut_stop or NULL */
int wcut_stop_progress(int done, int total, void *context);

#endif
