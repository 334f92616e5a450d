/* How many threads a parallel loop asks for. */
#ifndef WCUT_BASE_THREADS_H
#define WCUT_BASE_THREADS_H

/* libgomp ends the process where it cannot start the threads asked for, and a caller may ask for INT_MAX. No result
   depends on the number. */
enum { WCUT_THREADS_MAX = 256 };

static inline int wcut_threads(int asked) { return asked < WCUT_THREADS_MAX ? asked : WCUT_THREADS_MAX; }

#endif
