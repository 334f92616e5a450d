/* Output, buffered: into memory that grows, or into a file as the buffer fills. */
#ifndef WCUT_IO_FILE_TEXT_H
#define WCUT_IO_FILE_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#include "io/file/atomic.h"

/* an error sticks: in memory `failed`, in a file the file's own */
typedef struct wcut_text {
    char *data;
    size_t count, capacity;
    wcut_file *file; /* NULL: memory */
    bool failed;     /* memory ran out: data holds nothing of use */
} wcut_text;

enum { WCUT_TEXT_ROOM = 4096 }; /* the most that wcut_text_room gives */

/* begin; false: no memory */
bool wcut_text_create(wcut_text *text, wcut_file *file);

/* free the buffer */
void wcut_text_destroy(wcut_text *text);

/* room for up to WCUT_TEXT_ROOM bytes at data + count, to be filled and counted by the caller */
char *wcut_text_room(wcut_text *text);

void wcut_text_put(wcut_text *text, const void *data, size_t size);
void wcut_text_print(wcut_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* the shortest digits that read back the same */
void wcut_text_number(wcut_text *text, double value);

/* a JSON string with its quotes */
void wcut_text_string(wcut_text *text, const char *string);

/* words as they are */
void wcut_text_put_word(wcut_text *text, const char *word);

/* words, then a value of JSON: `, "key": `, 1.5. A number that is not finite is null; a point is closed by its bracket,
   which the words open. */
void wcut_text_put_number(wcut_text *text, const char *before, double value);
void wcut_text_put_string(wcut_text *text, const char *before, const char *string);
void wcut_text_put_point(wcut_text *text, const char *before, wcut_vec3 point);

/* end a text in memory and hand it out, the caller's to free(); length may be NULL. WCUT_NO_MEMORY: it is gone. */
wcut_status wcut_text_finish(wcut_text *text, char **data, size_t *length);

/* hand the buffer to the file */
void wcut_text_flush(wcut_text *text);

/* fills a text; false: memory ran out */
typedef bool wcut_text_writer(wcut_text *text, const void *context);

/* A whole file by one function. WCUT_OK: wholly on disk; WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the target is as it was. */
wcut_status wcut_text_write_file(const char *path, wcut_text_writer *write, const void *context, wcut_error *error);

#endif
