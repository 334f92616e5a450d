/* JSON in: walk a text by tables of its keys, and say by JSON path what was found and what was expected. */
#include "io/file/json_read.h"

#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/vec3.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/locale.h"
#include "io/file/look.h"
#include "io/file/nearest.h"
#include "io/file/number.h"
#include "io/file/utf8.h"

/* ---- the text ---- */

json_t *wcut_json_load(wcut_reader *reader, const char *text, size_t length) {
    char label[WCUT_QUOTE_SIZE], cause[WCUT_QUOTE_SIZE];
    json_error_t where;
    if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        text += 3, length -= 3; /* a byte order mark may be there */
    /* integers as doubles, so that 20 digits are no overflow; jansson's strtod follows the locale, so it gets "C" */
    locale_t before = wcut_locale_plain();
    errno = 0;
    json_t *root = json_loadb(text, length, JSON_REJECT_DUPLICATES | JSON_DECODE_INT_AS_REAL, &where);
    const int code = errno;
    wcut_locale_restore(before);
    if (root) return root;

    /* another kind of file, by its first bytes */
    if (!wcut_look_is_json(text, length)) {
        reader->status = wcut_look_refuse(text, length, reader->label, "JSON", reader->error);
        if (reader->status != WCUT_OK) return NULL;
    }

    /* the cause, with its place in the file */
    wcut_quote(label, reader->label, WCUT_LABEL_MAX, 1);
    /* jansson has no cause for some of its failed allocations, and calls others an invalid token */
    if (code == ENOMEM || where.text[0] == '\0' || json_error_code(&where) == json_error_out_of_memory)
        return wcut_refuse_memory(reader), NULL;
    bool nul = json_error_code(&where) == json_error_null_character;
    reader->status =
        wcut_fail(reader->error, WCUT_BAD_FORMAT, "%s: line %d, column %d: %s, expected valid JSON", label, where.line,
                  where.column, nul ? "\\u0000 in a string" : wcut_quote(cause, where.text, 160, 0));

    return NULL;
}

/* ---- refusals ---- */

static void print_json_value(char *to, size_t size, const json_t *value) {
    char number[WCUT_NUMBER_SIZE], quote[WCUT_QUOTE_SIZE];

    /* containers by kind, scalars by their value */
    switch (value ? json_typeof(value) : JSON_NULL) {
        case JSON_OBJECT:
            snprintf(to, size, "an object");
            break;
        case JSON_ARRAY:
            snprintf(to, size, "an array of %zu", json_array_size(value));
            break;
        case JSON_STRING:
            snprintf(to, size, "\"%s\"", wcut_quote(quote, json_string_value(value), WCUT_FOUND_MAX, 0));
            break;
        case JSON_INTEGER:
        case JSON_REAL:
            /* numbers as they are written elsewhere */
            number[wcut_number_print(json_number_value(value), number)] = '\0';
            snprintf(to, size, "%s", number);
            break;
        case JSON_TRUE:
        case JSON_FALSE:
            snprintf(to, size, "%s", json_is_true(value) ? "true" : "false");
            break;
        case JSON_NULL:
            /* a key without a value differs from a missing one */
            snprintf(to, size, "%s", value ? "null" : "nothing");
            break;
    }
}

/* "$.path.mount_a_mm[3][1]"; keys on the way are known ones and need no quotes */
static size_t print_path(char *to, size_t size, const wcut_place *at) {
    if (!at->above) return (size_t)snprintf(to, size, "$");
    size_t used = print_path(to, size, at->above);
    if (used >= size) return used;
    int n = at->key ? snprintf(to + used, size - used, ".%s", at->key)
                    : snprintf(to + used, size - used, "[%zu]", at->index);
    return used + (size_t)n;
}

bool wcut_refuse(wcut_reader *reader, const wcut_place *at, wcut_status status, const char *format, ...) {
    char label[WCUT_QUOTE_SIZE], path[128], shown[WCUT_QUOTE_SIZE], found[100], expected[256];
    print_path(path, sizeof path, at);
    print_json_value(found, sizeof found, at->value);
    va_list arguments;
    va_start(arguments, format);
    locale_t before = wcut_locale_plain();
    vsnprintf(expected, sizeof expected, format, arguments);
    wcut_locale_restore(before);
    va_end(arguments);
    reader->status = wcut_fail(reader->error, status, "%s: %s: found %s, expected %s",
                               wcut_quote(label, reader->label, WCUT_LABEL_MAX, 1),
                               wcut_quote(shown, path, (int)sizeof path, 0), found, expected);
    return false;
}

#undef wcut_refuse_memory
bool wcut_refuse_memory(wcut_reader *reader) {
    char label[WCUT_QUOTE_SIZE];
    reader->status = wcut_fail(reader->error, WCUT_NO_MEMORY, "%s: %s",
                               wcut_quote(label, reader->label, WCUT_LABEL_MAX, 1), wcut_status_text(WCUT_NO_MEMORY));
    return false;
}

/* ---- objects ---- */

static bool refuse_key(wcut_reader *reader, const wcut_place *at, const char *key, const wcut_field *field,
                       int fields) {
    char label[WCUT_QUOTE_SIZE], quote[WCUT_QUOTE_SIZE], path[128], expected[200];

    /* the nearest known key by edit distance, and a list of all */
    int nearest = -1, min = (int)strlen(key) / 3 + 1;
    size_t used = 0;
    expected[0] = '\0';
    for (int f = 0; f < fields; f++) {
        const int distance = wcut_edit_distance(key, field[f].key);
        if (distance <= min && (nearest < 0 || distance < min)) nearest = f, min = distance;
        if (used < sizeof expected)
            used +=
                (size_t)snprintf(expected + used, sizeof expected - used, "%s%s", f ? ", " : "one of ", field[f].key);
    }

    /* name the nearest where it is near enough */
    if (nearest >= 0) snprintf(expected, sizeof expected, "\"%s\"", field[nearest].key);

    /* where it is: the path of keys down to this one */
    print_path(path, sizeof path, at);
    reader->status = wcut_fail(reader->error, WCUT_BAD_FORMAT, "%s: %s: found the unknown key \"%s\", expected %s",
                               wcut_quote(label, reader->label, WCUT_LABEL_MAX, 1), path,
                               wcut_quote(quote, key, WCUT_FOUND_MAX, 0), expected);

    return false;
}

static bool is_json_known(const char *key, const wcut_field *field, int fields) {
    for (int f = 0; f < fields; f++)
        if (strcmp(key, field[f].key) == 0) return true;
    return strncmp(key, "x-", 2) == 0;
}

wcut_place wcut_place_member(const wcut_place *at, const char *key) {
    return (wcut_place){at, key, 0, json_object_get(at->value, key)};
}

bool wcut_read_object(wcut_reader *reader, const wcut_place *at, const wcut_field *field, int fields, void *into) {
    if (!json_is_object(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object");
    /* a misspelt key first: it is why another one is missing */
    void *at_key = json_object_iter((json_t *)at->value);
    for (; at_key; at_key = json_object_iter_next((json_t *)at->value, at_key)) {
        const char *key = json_object_iter_key(at_key);
        if (!is_json_known(key, field, fields)) return refuse_key(reader, at, key, field, fields);
    }
    for (int f = 0; f < fields; f++) {
        wcut_place member = wcut_place_member(at, field[f].key);
        if (!member.value && !field[f].required) continue;
        if (!field[f].read(reader, &member, (char *)into + field[f].offset)) return false;
    }
    return true;
}

/* ---- arrays and values ---- */

bool wcut_read_array(wcut_reader *reader, const wcut_place *at, int min, int max, const char *item_text,
                     wcut_read_value *item, size_t size, int *count, void **into) {
    if (!json_is_array(at->value))
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an array of at least %d %s", min, item_text);
    size_t n = json_array_size(at->value);
    if (n < (size_t)min || n > (size_t)max)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "%d to %d %s", min, max, item_text);
    char *items = wcut_alloc(n, size);
    if (!items) return wcut_refuse_memory(reader);
    *into = items;
    *count = (int)n;
    for (size_t i = 0; i < n; i++) {
        wcut_place place = {at, NULL, i, json_array_get(at->value, i)};
        if (!item(reader, &place, items + i * size)) return false;
    }
    return true;
}

bool wcut_read_word(wcut_reader *reader, const wcut_place *at, const char *const *word, int *into) {
    const char *found = json_string_value(at->value);

    /* the nearest known word, and a list of all */
    int nearest = -1, min = found ? (int)strlen(found) / 3 + 1 : 0;
    char list[200] = "";
    size_t used = 0;
    for (int k = 0; word[k]; k++) {
        if (found && strcmp(found, word[k]) == 0) {
            *into = k;
            return true;
        }
        const int distance = found ? wcut_edit_distance(found, word[k]) : WCUT_NEAREST_MAX;
        if (distance <= min && (nearest < 0 || distance < min)) nearest = k, min = distance;
        if (used + strlen(word[k]) + 8 < sizeof list)
            used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", k ? ", " : "", word[k]);
        else if (used + 5 < sizeof list)
            used += (size_t)snprintf(list + used, sizeof list - used, ", ..") + sizeof list;
    }

    /* a wrong word is a bad argument, a missing one a bad format */
    const wcut_status status = found ? WCUT_BAD_ARGUMENT : WCUT_BAD_FORMAT;
    if (nearest >= 0) return wcut_refuse(reader, at, status, "\"%s\"", word[nearest]);

    return wcut_refuse(reader, at, status, "one of %s", list);
}

/* a number for which low < value, or low <= value where that is allowed */
static bool read_json_number(wcut_reader *reader, const wcut_place *at, double low, bool open, const char *expected,
                             double *into) {
    if (!json_is_number(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "%s", expected);
    double value = json_number_value(at->value);
    if (!isfinite(value) || !(open ? value > low : value >= low))
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "%s", expected);
    *into = value;
    return true;
}

bool wcut_read_finite(wcut_reader *reader, const wcut_place *at, void *into) {
    return read_json_number(reader, at, -INFINITY, true, "a number", into);
}

bool wcut_read_positive(wcut_reader *reader, const wcut_place *at, void *into) {
    return read_json_number(reader, at, 0, true, "a number greater than 0", into);
}

bool wcut_read_not_negative(wcut_reader *reader, const wcut_place *at, void *into) {
    return read_json_number(reader, at, 0, false, "a number of at least 0", into);
}

bool wcut_read_int(wcut_reader *reader, const wcut_place *at, int min, int max, int *into) {
    double value = json_number_value(at->value); /* 0 where it is none */
    bool number = json_is_number(at->value);
    if (!number || value != floor(value) || value < min || value > max)
        return wcut_refuse(reader, at, number ? WCUT_BAD_ARGUMENT : WCUT_BAD_FORMAT, "an integer from %d to %d", min,
                           max);
    *into = (int)value;
    return true;
}

bool wcut_read_point(wcut_reader *reader, const wcut_place *at, void *into) {
    double coordinate[3];
    if (!json_is_array(at->value) || json_array_size(at->value) != 3)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a point [x, y, z]");
    for (size_t k = 0; k < 3; k++) {
        wcut_place place = {at, NULL, k, json_array_get(at->value, k)};
        if (!wcut_read_finite(reader, &place, &coordinate[k])) return false;
    }
    *(wcut_vec3 *)into = (wcut_vec3){coordinate[0], coordinate[1], coordinate[2]};
    return true;
}

bool wcut_read_format(wcut_reader *reader, const wcut_place *at, const char *format) {
    const char *found = json_string_value(at->value);
    if (found && strcmp(found, format) == 0) return true;
    const bool other = found && strncmp(found, format, strcspn(format, "/")) != 0; /* not another version of it */
    const char *use = other ? wcut_look_format(found) : "";
    return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "\"%s\"%s%s", format, *use ? "; " : "", use);
}

bool wcut_read_text(wcut_reader *reader, const wcut_place *at, void *into) {
    if (!json_is_string(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a string");

    /* it becomes part of files, of lines on a terminal and of names of solids: checked here, once */
    if (!wcut_utf8_is_plain(json_string_value(at->value)))
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a text without control characters");
    char *copy = wcut_alloc(json_string_length(at->value) + 1, 1);
    if (!copy) return wcut_refuse_memory(reader);
    memcpy(copy, json_string_value(at->value), json_string_length(at->value));
    free(*(char **)into);
    *(char **)into = copy;
    return true;
}
