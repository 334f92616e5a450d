/* Loops over many alike items, compiled for wider vectors, too; the processor at hand decides which is run. Every lane
   does what a scalar would, no multiplication is fused with an addition: the same bytes on every processor. */
#ifndef WCUT_BASE_WIDE_H
#define WCUT_BASE_WIDE_H

#include <limits.h>

/* before a function; what that calls must be inlined */
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WCUT_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WCUT_WIDE
#endif

/* compilers take items side by side only where nothing in the loop is a call */
#if defined(__GNUC__)
#define WCUT_INLINE static inline __attribute__((always_inline))
#else
#define WCUT_INLINE static inline
#endif

#endif
