/* Memory that lives as long as a page is being written: taken in pieces, given back at once. */
#ifndef APP_PAGE_MEMORY_H
#define APP_PAGE_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

typedef struct app_memory {
    struct app_piece *piece; /* the last one taken */
    bool failed;             /* memory ran out */
} app_memory;

/* count x size zeroed bytes; NULL, and failed, where there is no memory */
void *app_take(app_memory *memory, size_t count, size_t size);

/* a text of printf's kind */
const char *app_take_text(app_memory *memory, const char *format, ...) __attribute__((format(printf, 2, 3)));

void app_give_back(app_memory *memory);

#endif
