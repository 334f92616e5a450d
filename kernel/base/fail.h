/* Say where something failed, in one printable line. */
#ifndef WCUT_BASE_FAIL_H
#define WCUT_BASE_FAIL_H

#include <wirecut/status.h>

/* fill error (may be NULL) with a status and a printf text, and give the status back: return wcut_fail(...). Numbers
   have a decimal point in every locale. */
wcut_status wcut_fail(wcut_error *error, wcut_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* "PATH: WHAT: text of the errno `code`"; ENOMEM is WCUT_NO_MEMORY whatever the status is called */
wcut_status wcut_fail_errno(wcut_error *error, wcut_status status, int code, const char *path, const char *what);

#ifdef __clang_analyzer__ /* it sees one file at a time: the status that comes back is the one given */
#define wcut_fail(error, status, ...) (wcut_fail(error, status, __VA_ARGS__), (status))
#define wcut_fail_errno(error, status, ...) (wcut_fail_errno(error, status, __VA_ARGS__), (status))
#endif

/* [byte] of a quoted text, of a file's name in a message, of a found text in a message */
enum { WCUT_QUOTE_SIZE = 256, WCUT_LABEL_MAX = 150, WCUT_FOUND_MAX = 60 };

/* text as one printable line: control characters become \xNN; of a text longer than `max` bytes the tail or the head is
   kept and "..." says so. Gives `to` back. */
const char *wcut_quote(char to[WCUT_QUOTE_SIZE], const char *text, int max, int tail);

#endif
