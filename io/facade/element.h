/* An element as JSON text in memory: what the reader, the plan of a facade and the fuzzer share. */
#ifndef WCUT_IO_FACADE_ELEMENT_H
#define WCUT_IO_FACADE_ELEMENT_H

#include <jansson.h>
#include <stddef.h>
#include <wirecut/facade_file.h>

#include "io/file/text.h"

enum { WCUT_ELEMENT_BYTES_MAX = 64 << 20 };

/* the keys of "border_mm", in the order of the borders */
extern const char *const wcut_border_key[4];

/* wcut_element_read of a text; label stands in front of every message */
wcut_status wcut_element_parse(const char *text, size_t length, const char *label, wcut_element **element,
                               wcut_error *error);

/* the text of an element of a facade, for free() */
wcut_status wcut_element_print(const wcut_facade_element *element, const wcut_element_options *options, char **text,
                               wcut_error *error);

/* a list of numbers behind words */
void wcut_text_put_list(wcut_text *text, const char *before, int count, const double *value);

/* the distinct elements of a facade: text of each (count, for free()), and which of them an element is (elements).
   WCUT_NO_MEMORY and what wcut_element_print says: nothing was written. */
typedef struct wcut_distinct {
    int count;
    char **text;
    int *of;
} wcut_distinct;
wcut_status wcut_distinct_create(const wcut_facade *facade, const wcut_element_options *options,
                                 wcut_distinct *distinct, wcut_error *error);
void wcut_distinct_clear(wcut_distinct *distinct);

#endif
