/* A request to stop: the caller's progress is asked in his own thread alone, whichever threads drive wires. */
#include "explain/stop.h"

void wcut_stop_begin(wcut_stop *stop, wcut_progress progress, void *context, int steps) {
    *stop = (wcut_stop){.progress = progress, .context = context, .owner = pthread_self(), .stage = "", .steps = steps};
    atomic_init(&stop->asked, false);
}

bool wcut_stop_asked(wcut_stop *stop) {
    if (!stop || !stop->progress) return false;
    if (atomic_load_explicit(&stop->asked, memory_order_relaxed)) return true;
    if (!pthread_equal(pthread_self(), stop->owner)) return false;
    const bool asked = stop->progress(stop->done, stop->steps, stop->context) != 0;
    if (asked) atomic_store_explicit(&stop->asked, true, memory_order_relaxed);
    return asked;
}

bool wcut_stop_step(wcut_stop *stop, const char *stage, int done) {
    if (!stop) return false;
    if (done >= stop->steps) done = stop->steps - 1;
    if (done > stop->done) stop->done = done;
    stop->stage = stage;
    return wcut_stop_asked(stop);
}

int wcut_stop_progress(int done, int total, void *context) {
    (void)done, (void)total;
    return wcut_stop_asked(context);
}
