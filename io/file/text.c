/* Output, buffered: into memory that grows, or into a file as the buffer fills. */
#include "io/file/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/number.h"

enum { FILE_BUFFER = 1 << 20, MEMORY_BUFFER = 1 << 14 };

bool wcut_text_create(wcut_text *text, wcut_file *file) {
    size_t capacity = file ? FILE_BUFFER : MEMORY_BUFFER;
    *text = (wcut_text){wcut_alloc(capacity, 1), 0, capacity, file, false};
    return text->data != NULL;
}

void wcut_text_destroy(wcut_text *text) {
    free(text->data);
    *text = (wcut_text){0};
}

void wcut_text_flush(wcut_text *text) {
    wcut_file_write(text->file, text->data, text->count);
    text->count = 0;
}

char *wcut_text_room(wcut_text *text) {
    if (text->count + WCUT_TEXT_ROOM <= text->capacity) return text->data + text->count;
    if (text->file) {
        wcut_text_flush(text);
        return text->data;
    }
    char *grown = wcut_grow(text->data, 2 * text->capacity);
    if (grown) {
        text->data = grown;
        text->capacity *= 2;
    } else {
        text->failed = true; /* go on over what is lost already: the end reports it */
        text->count = 0;
    }
    return text->data + text->count;
}

void wcut_text_put(wcut_text *text, const void *data, size_t size) {
    const char *from = data;
    while (size > 0) {
        size_t n = size < WCUT_TEXT_ROOM ? size : WCUT_TEXT_ROOM;
        memcpy(wcut_text_room(text), from, n);
        text->count += n;
        from += n;
        size -= n;
    }
}

void wcut_text_print(wcut_text *text, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char *room = wcut_text_room(text);
    int n = vsnprintf(room, WCUT_TEXT_ROOM, format, arguments);
    va_end(arguments);
    text->count += n < WCUT_TEXT_ROOM ? (size_t)n : WCUT_TEXT_ROOM - 1;
}

void wcut_text_number(wcut_text *text, double value) {
    char *room = wcut_text_room(text);
    text->count += (size_t)wcut_number_print(value, room);
}

void wcut_text_string(wcut_text *text, const char *string) {
    wcut_text_put(text, "\"", 1);
    for (const char *p = string; *p; p++) {
        unsigned char c = (unsigned char)*p;
        if (c == '"' || c == '\\')
            wcut_text_print(text, "\\%c", c);
        else if (c < 0x20 || c == 0x7f)
            wcut_text_print(text, "\\u%04x", c);
        else
            wcut_text_put(text, p, 1);
    }
    wcut_text_put(text, "\"", 1);
}

wcut_status wcut_text_finish(wcut_text *text, char **data, size_t *length) {
    wcut_text_put(text, "", 1);
    if (text->failed) {
        wcut_text_destroy(text);
        return WCUT_NO_MEMORY;
    }
    *data = text->data;
    if (length) *length = text->count - 1;
    return WCUT_OK;
}

void wcut_text_put_word(wcut_text *text, const char *word) { wcut_text_put(text, word, strlen(word)); }

void wcut_text_put_number(wcut_text *text, const char *before, double value) {
    wcut_text_put_word(text, before);
    if (isfinite(value))
        wcut_text_number(text, value);
    else
        wcut_text_put_word(text, "null");
}

void wcut_text_put_string(wcut_text *text, const char *before, const char *string) {
    wcut_text_put_word(text, before);
    wcut_text_string(text, string);
}

void wcut_text_put_point(wcut_text *text, const char *before, wcut_vec3 point) {
    wcut_text_put_number(text, before, point.x);
    wcut_text_put_number(text, ", ", point.y);
    wcut_text_put_number(text, ", ", point.z);
    wcut_text_put_word(text, "]");
}

wcut_status wcut_text_write_file(const char *path, wcut_text_writer *write, const void *context, wcut_error *error) {
    wcut_file *file = NULL;
    wcut_text text = {0};
    wcut_status status = wcut_file_create(path, &file, error);
    if (status != WCUT_OK) return status;

    /* the target is replaced only by what was filled completely */
    if (wcut_text_create(&text, file) && write(&text, context)) {
        wcut_text_flush(&text);
        status = wcut_file_commit(file, error);
    } else {
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    wcut_text_destroy(&text);
    wcut_file_destroy(file);
    return status;
}
