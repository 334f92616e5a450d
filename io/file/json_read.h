/* JSON in: walk a text by tables of its keys, and say by JSON path what was found and what was expected. */
#ifndef WCUT_IO_FILE_JSON_READ_H
#define WCUT_IO_FILE_JSON_READ_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <wirecut/status.h>

/* who reads: the name in front of every message, and where the first one goes */
typedef struct wcut_reader {
    const char *label;
    wcut_error *error;  /* may be NULL */
    wcut_status status; /* of the first refusal */
} wcut_reader;

/* a value and the way to it, a chain on the stack; value NULL: the key is missing */
typedef struct wcut_place {
    const struct wcut_place *above; /* NULL at the root */
    const char *key;                /* NULL: an array's item */
    size_t index;
    const json_t *value;
} wcut_place;

/* read the value at a place into what `into` points to; false: refused, the reader holds the status */
typedef bool wcut_read_value(wcut_reader *reader, const wcut_place *at, void *into);

/* a key of an object: how it is read, and how far behind `into` it goes */
typedef struct wcut_field {
    const char *key;
    bool required;
    wcut_read_value *read;
    size_t offset;
} wcut_field;

/* the root of a JSON text, for json_decref; NULL: refused. Duplicate keys, trailing text and numbers outside the
   range of a double are errors; the caller's locale does not matter. */
json_t *wcut_json_load(wcut_reader *reader, const char *text, size_t length);

/* refuse the value at a place: "LABEL: $.path: found X, expected FORMAT"; gives false */
bool wcut_refuse(wcut_reader *reader, const wcut_place *at, wcut_status status, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* refuse for want of memory; gives false */
bool wcut_refuse_memory(wcut_reader *reader);
#ifdef __clang_analyzer__ /* it sees one file at a time */
#define wcut_refuse_memory(reader) (wcut_refuse_memory(reader), false)
#endif

/* an object's known keys in the table's order; unknown ones are refused, those that begin with "x-" ignored */
bool wcut_read_object(wcut_reader *reader, const wcut_place *at, const wcut_field *field, int fields, void *into);

/* an array of least .. most items, each of `size` bytes read by `item` into new memory at *into: on failure too what
 *into points to is the caller's to free */
bool wcut_read_array(wcut_reader *reader, const wcut_place *at, int min, int max, const char *item_text,
                     wcut_read_value *item, size_t size, int *count, void **into);

/* doubles: `into` is a double */
bool wcut_read_finite(wcut_reader *reader, const wcut_place *at, void *into);
bool wcut_read_positive(wcut_reader *reader, const wcut_place *at, void *into);
bool wcut_read_not_negative(wcut_reader *reader, const wcut_place *at, void *into);

/* an integer in least .. most */
bool wcut_read_int(wcut_reader *reader, const wcut_place *at, int min, int max, int *into);

/* [x, y, z]: `into` is a wcut_vec3 */
bool wcut_read_point(wcut_reader *reader, const wcut_place *at, void *into);

/* whether the place holds the name of a format, "wirecut-job/1"; another one is refused with the verbs that take it */
bool wcut_read_format(wcut_reader *reader, const wcut_place *at, const char *format);

/* a string: `into` is a char *, the caller's to free; what it held is freed */
bool wcut_read_text(wcut_reader *reader, const wcut_place *at, void *into);

/* one of the words of a list that NULL ends: `into` is an int, its place; another word gets the nearest as advice */
bool wcut_read_word(wcut_reader *reader, const wcut_place *at, const char *const *word, int *into);

/* the member `key` of the object at a place; its value is NULL where there is none */
wcut_place wcut_place_member(const wcut_place *at, const char *key);

#endif
