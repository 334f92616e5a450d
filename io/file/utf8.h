/* UTF-8, a character at a time. */
#ifndef WCUT_IO_FILE_UTF8_H
#define WCUT_IO_FILE_UTF8_H

#include <stdbool.h>
#include <stdint.h>

/* the character at text, which is not at its end; gives what is behind it. What is not UTF-8 is U+FFFD, a byte long. */
const char *wcut_utf8_next(const char *text, uint32_t *code);

/* whether a text is UTF-8 without control characters */
bool wcut_utf8_is_plain(const char *text);

#endif
