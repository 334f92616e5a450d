/* What a file is that was given in the place of another one: by its first bytes, in words, with the verb that takes it. */
#ifndef WCUT_IO_FILE_LOOK_H
#define WCUT_IO_FILE_LOOK_H

#include <stdbool.h>
#include <stddef.h>
#include <wirecut/status.h>

typedef struct wcut_look {
    const char *kind; /* "a mesh (STL)"; NULL: not known */
    const char *use;  /* "compare takes it as SCAN"; "" for none */
} wcut_look;

/* what `length` first bytes of a file (any, no zero needed behind them) and the ending of its name say */
wcut_look wcut_look_at(const char *bytes, size_t length, const char *label);

/* whether a kind is text in columns: a recording, datums, points, ... */
bool wcut_look_is_table(const char *kind);

/* whether text begins as JSON does */
bool wcut_look_is_json(const char *bytes, size_t length);

/* which verb takes a file with this value of "format"; "" for none */
const char *wcut_look_format(const char *format);

/* Where the bytes are known to be another kind of file than `expected` ("JSON"): "LABEL: found KIND, expected EXPECTED; USE",
   WCUT_BAD_FORMAT. Where they are not: WCUT_OK, nothing is written. */
wcut_status wcut_look_refuse(const char *bytes, size_t length, const char *label, const char *expected,
                             wcut_error *error);

#endif
