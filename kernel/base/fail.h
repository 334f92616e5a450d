/* Say where something failed. */
#ifndef WCUT_BASE_FAIL_H
#define WCUT_BASE_FAIL_H

#include <wirecut/status.h>

/* fill error (may be NULL) with a status and a printf text, and give the status back: return wcut_fail(...) */
wcut_status wcut_fail(wcut_error *error, wcut_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#ifdef __clang_analyzer__ /* it sees one file at a time: the status that comes back is the one given */
#define wcut_fail(error, status, ...) (wcut_fail(error, status, __VA_ARGS__), (status))
#endif

#endif
