/* Lines of text and the numbers in them. */
#ifndef WCUT_IO_SCAN_CLOUD_ROW_H
#define WCUT_IO_SCAN_CLOUD_ROW_H

#include "io/file/source.h"

/* the next line, unread still: it ends with a line feed, or with a zero byte at the end of the file. NULL: the end, or
   refused (then the failure says so): a line longer than the window */
const char *wcut_row_peek(wcut_source *source, size_t *length);

/* the line has been read */
void wcut_row_done(wcut_source *source, size_t length);

static inline bool wcut_is_blank(char c) { return c == ' ' || c == '\t'; }

/* a zero byte is an end only at the end of the file: `end` tells */
static inline bool wcut_is_line_end(const char *at) { return *at == '\n' || *at == '\0' || *at == '\r'; }

static inline const char *wcut_skip_blanks(const char *at) {
    while (wcut_is_blank(*at)) at++;
    return at;
}

/* Read a number at `at`, behind blanks; a blank, the line's end or `separator` (a blank for none) must follow. Where
   `comma` is true a decimal comma is one, too. "nan" and "inf" in their spellings are numbers. Gives what is behind it;
   NULL: something else stands there, or the number is beyond the range of a double. */
const char *wcut_row_number(const char *at, char separator, bool comma, double *value);

/* whether the word (of letters, lower case) stands at `at`, followed by a blank or the line's end */
bool wcut_row_has_word(const char *at, const char *word);

/* read a count, digits alone, not behind INT64_MAX; NULL: something else, a sign among that */
const char *wcut_row_count(const char *at, int64_t *count);

#endif
