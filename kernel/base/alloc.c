/* Memory: counted, zeroed, overflow-checked; a test build's allocator fails on purpose. */
#include "base/alloc.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static _Thread_local long fail_countdown = 0;

void wcut_alloc_fail_at(long k) { fail_countdown = k; }

void *wcut_alloc(size_t count, size_t size) {
    if (fail_countdown > 0 && --fail_countdown == 0) return NULL;
    if (size != 0 && count > PTRDIFF_MAX / size) return NULL;
    return calloc(count ? count : 1, size ? size : 1);
}

void *wcut_grow(void *memory, size_t size) {
    if (fail_countdown > 0 && --fail_countdown == 0) return NULL;
    return size <= PTRDIFF_MAX ? realloc(memory, size) : NULL;
}

void wcut_free(void *memory) { free(memory); }

void *wcut_copy(const void *from, size_t count, size_t size) {
    void *to = wcut_alloc(count, size);
    if (to && count) memcpy(to, from, count * size);
    return to;
}

char *wcut_copy_text(const char *text) { return wcut_copy(text, strlen(text) + 1, 1); }
