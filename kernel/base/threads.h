/* How many threads a parallel loop asks for. */
#ifndef WCUT_BASE_THREADS_H
#define WCUT_BASE_THREADS_H

enum { WCUT_THREADS_MAX = 256 };

/* How many of the threads asked for there can be now, from 1 to WCUT_THREADS_MAX; no result depends on the number. libgomp
   ends the process where it cannot start a thread, so those that the calling thread's team does not have yet are started
   here first, and ended. To be called in num_threads(..) of a parallel loop alone. */
int wcut_threads(int asked);

#endif
