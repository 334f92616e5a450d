/* Correction text in memory: what the file reader and the fuzzer share. */
#ifndef WCUT_IO_PROCESS_CORRECTION_H
#define WCUT_IO_PROCESS_CORRECTION_H

#include <stddef.h>
#include <wirecut/correction.h>

/* limit beyond which it is no diagnosis */
enum { WCUT_DIAGNOSIS_BYTES_MAX = 64 << 20 };

/* wcut_correction_read of `length` bytes; path stands in front of every message */
wcut_status wcut_correction_parse(const char *text, size_t length, const char *path, wcut_correction *correction,
                                  wcut_error *error);

#endif
