/* Case text in memory: what the file reader and the fuzzer share. */
#ifndef WCUT_IO_PROCESS_CASE_H
#define WCUT_IO_PROCESS_CASE_H

#include <stddef.h>
#include <wirecut/case.h>

/* limits beyond which it is a slip of the pen */
enum { WCUT_CASE_BYTES_MAX = 16 << 20, WCUT_CASE_CUTS_MAX = 10000 };

/* wcut_case_read of `length` bytes; path stands in front of every message and, up to its last slash, of every name */
wcut_status wcut_case_parse(const char *text, size_t length, const char *path, wcut_case **found, wcut_error *error);

/* the i-th file that a case names, in the order of its cuts; NULL: there are fewer */
const char *wcut_case_file(const wcut_case *found, int i);

/* wcut_format_read of `length` bytes */
wcut_status wcut_format_parse(const char *text, size_t length, const char *path, char *format, wcut_error *error);

#endif
