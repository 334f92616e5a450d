/* Say where something failed, and get memory: io's own few lines, since it sees the public headers alone. */
#ifndef WCUT_IO_FAIL_H
#define WCUT_IO_FAIL_H

#include <stddef.h>
#include <wirecut/status.h>

/* fill error (may be NULL) with a status and a printf text, and give the status back */
wcut_status wcut_io_fail(wcut_error *error, wcut_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* the same with ": " and the text of an errno behind it */
wcut_status wcut_io_fail_errno(wcut_error *error, wcut_status status, int code, const char *path, const char *what);

#ifdef __clang_analyzer__ /* it sees one file at a time: the status that comes back is the one given */
#define wcut_io_fail(error, status, ...) (wcut_io_fail(error, status, __VA_ARGS__), (status))
#define wcut_io_fail_errno(error, status, ...) (wcut_io_fail_errno(error, status, __VA_ARGS__), (status))
#endif

/* count x size zeroed bytes for free(); NULL where there is no memory or the product overflows */
void *wcut_io_alloc(size_t count, size_t size);

/* make what wcut_io_alloc gave (or NULL) size bytes long; NULL leaves it as it was */
void *wcut_io_grow(void *memory, size_t size);

/* for tests: let the k-th allocation from now fail, k >= 1; 0 ends it. Counts in the calling thread only. */
void wcut_io_alloc_fail_at(long k);

/* most bytes of a file's name, of a found text in a message */
enum { WCUT_QUOTE_SIZE = 256, WCUT_LABEL_MOST = 150, WCUT_FOUND_MOST = 60 };

/* text as one printable line: control characters become \xNN; of a text longer than `most` bytes the tail or the
   head is kept and "..." says so. Gives `to` back. */
const char *wcut_quote(char to[WCUT_QUOTE_SIZE], const char *text, int most, int tail);

#endif
