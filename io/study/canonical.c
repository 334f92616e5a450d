/* JSON as one text for one value: sorted keys, no blanks, shortest numbers (after RFC 8785). */
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "io/study/study.h"

static int by_key(const void *a, const void *b) { return strcmp(*(const char *const *)a, *(const char *const *)b); }

static void print_object(wcut_text *text, const json_t *value, wcut_hole *hole, void *context) {
    const size_t n = json_object_size(value);

    /* members in the order of their keys */
    const char **key = wcut_alloc(n, sizeof *key);
    if (!key) {
        text->failed = true;
        return;
    }
    size_t count = 0;
    for (void *at = json_object_iter((json_t *)value); at; at = json_object_iter_next((json_t *)value, at))
        key[count++] = json_object_iter_key(at);
    qsort(key, count, sizeof *key, by_key);

    /* {"key":value,...}, values by recursion */
    wcut_text_put(text, "{", 1);
    for (size_t i = 0; i < count; i++) {
        if (i) wcut_text_put(text, ",", 1);
        wcut_text_string(text, key[i]);
        wcut_text_put(text, ":", 1);
        wcut_canonical_print(text, json_object_get(value, key[i]), hole, context);
    }
    wcut_text_put(text, "}", 1);
    wcut_free(key);
}

void wcut_canonical_print(wcut_text *text, const json_t *value, wcut_hole *hole, void *context) {
    /* a hole prints a parameter's value in place of the input's */
    if (hole && hole(context, value, text)) return;
    switch (json_typeof(value)) {
        case JSON_OBJECT:
            print_object(text, value, hole, context);
            break;

        /* elements keep their order */
        case JSON_ARRAY:
            wcut_text_put(text, "[", 1);
            for (size_t i = 0; i < json_array_size(value); i++) {
                if (i) wcut_text_put(text, ",", 1);
                wcut_canonical_print(text, json_array_get(value, i), hole, context);
            }
            wcut_text_put(text, "]", 1);
            break;
        case JSON_STRING:
            wcut_text_string(text, json_string_value(value));
            break;

        /* numbers in their shortest form: 1.0 and 1 are one value */
        case JSON_INTEGER:
        case JSON_REAL:
            wcut_text_number(text, json_number_value(value));
            break;
        default:
            wcut_text_put_word(text, json_is_null(value) ? "null" : json_is_true(value) ? "true" : "false");
    }
}
