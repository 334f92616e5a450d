/* Memory that lives as long as a page is being written: a list of pieces. */
#include "io/report/page_memory.h"

#include <stdarg.h>
#include <stdio.h>

#include "base/alloc.h"

typedef struct wcut_page_piece {
    struct wcut_page_piece *next;
} wcut_page_piece;

void *wcut_page_take(wcut_page_memory *memory, size_t count, size_t size) {
    wcut_page_piece *piece = wcut_alloc(1, sizeof *piece + (count ? count : 1) * size);
    if (!piece) {
        memory->failed = true;
        return NULL;
    }
    piece->next = memory->piece;
    memory->piece = piece;
    return piece + 1;
}

const char *wcut_page_text(wcut_page_memory *memory, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    char *text = wcut_page_take(memory, (size_t)length + 1, 1);
    if (!text) return "";
    va_start(arguments, format);
    vsnprintf(text, (size_t)length + 1, format, arguments);
    va_end(arguments);
    return text;
}

void wcut_page_free(wcut_page_memory *memory) {
    while (memory->piece) {
        wcut_page_piece *next = memory->piece->next;
        wcut_free(memory->piece);
        memory->piece = next;
    }
}
