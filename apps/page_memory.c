/* Memory that lives as long as a page is being written: a list of pieces. */
#include "page_memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct app_piece {
    struct app_piece *next;
} app_piece;

void *app_take(app_memory *memory, size_t count, size_t size) {
    app_piece *piece = calloc(1, sizeof *piece + (count ? count : 1) * size);
    if (!piece) {
        memory->failed = true;
        return NULL;
    }
    piece->next = memory->piece;
    memory->piece = piece;
    return piece + 1;
}

const char *app_take_text(app_memory *memory, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    char *text = app_take(memory, (size_t)length + 1, 1);
    if (!text) return "";
    va_start(arguments, format);
    vsnprintf(text, (size_t)length + 1, format, arguments);
    va_end(arguments);
    return text;
}

void app_give_back(app_memory *memory) {
    while (memory->piece) {
        app_piece *next = memory->piece->next;
        free(memory->piece);
        memory->piece = next;
    }
}
