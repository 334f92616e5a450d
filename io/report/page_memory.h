/* Memory that lives as long as a page is being written: taken in pieces, given back at once. */
#ifndef WCUT_IO_REPORT_PAGE_MEMORY_H
#define WCUT_IO_REPORT_PAGE_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

typedef struct wcut_page_memory {
    struct wcut_page_piece *piece; /* the last one taken */
    bool failed;                   /* memory ran out */
} wcut_page_memory;

/* count x size zeroed bytes; NULL, and failed, where there is no memory */
void *wcut_page_take(wcut_page_memory *memory, size_t count, size_t size);

/* a text of printf's kind */
const char *wcut_page_text(wcut_page_memory *memory, const char *format, ...) __attribute__((format(printf, 2, 3)));

void wcut_page_free(wcut_page_memory *memory);

#endif
