/* Memory: counted, zeroed, overflow-checked; a test build's allocator fails on purpose. */
#ifndef WCUT_BASE_ALLOC_H
#define WCUT_BASE_ALLOC_H

#include <stddef.h>

/* count x size zeroed bytes; NULL where there is no memory or the product overflows (count 0 gives one element) */
void *wcut_alloc(size_t count, size_t size);

/* make what wcut_alloc gave (or NULL) size bytes long; NULL leaves it as it was */
void *wcut_grow(void *memory, size_t size);

/* free what wcut_alloc gave; NULL is allowed */
void wcut_free(void *memory);

/* a copy of a string, or NULL where there is no memory */
char *wcut_copy_text(const char *text);

/* a copy of count x size bytes, or NULL where there is no memory */
void *wcut_copy(const void *from, size_t count, size_t size);

/* for tests: let the k-th allocation from now fail, k >= 1; 0 ends it. Counts in the calling thread only. */
void wcut_alloc_fail_at(long k);

#endif
