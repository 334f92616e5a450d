/* Lines of text and the numbers in them. */
#include "io/file/row.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <string.h>
#include <strings.h>

#include <wirecut/cloud_file.h>
#include "io/file/decimal.h"

/* Which line ends a file has, from its first one: a feed, with or without a return before it, or a return alone. 0: not
   to be told yet. */
static char find_ending(const wcut_stream *t) {
    const unsigned char *from = t->data + t->at, *end = t->data + t->end;
    for (const unsigned char *p = from; p < end; p++) {
        if (*p == '\n') return '\n';
        if (*p == '\r' && (p + 1 < end || t->ended)) return p + 1 < end && p[1] == '\n' ? '\n' : '\r';
    }
    return t->ended ? '\n' : 0;
}

const char *wcut_row_peek(wcut_source *s, size_t *length) {
    /* the window grows until it holds a whole line */
    wcut_stream *t = &s->stream;
    size_t known = 0;
    for (;;) {
        const size_t unread = t->end - t->at;
        const unsigned char *line = t->data + t->at;
        if (!s->ending) s->ending = find_ending(t);
        const unsigned char *feed = s->ending ? memchr(line + known, s->ending, unread - known) : NULL;

        /* a line, or the rest of the file without a line feed */
        if (feed || (t->ended && unread > 0)) {
            *length = feed ? (size_t)(feed - line) + 1 : unread;
            return (const char *)line;
        }

        /* the end of the file */
        if (t->ended) {
            if (t->code) wcut_source_refuse_end(s, "more");
            return NULL;
        }

        if (unread == t->capacity) {
            wcut_source_refuse(s, "found more than %zu bytes without a line feed, expected lines", t->capacity);
            return NULL;
        }
        known = s->ending ? unread : 0;
        wcut_stream_fill(t, unread + 1);
    }
}

void wcut_row_done(wcut_source *s, size_t length) {
    s->stream.at += length;
    s->line += s->line < LONG_MAX;
}

static bool is_word_end(const char *p, char separator) {
    return wcut_is_blank(*p) || wcut_is_line_end(p) || *p == separator;
}

/* What printf and scanners write where there is no number: "nan" with anything in brackets, "inf", and what Microsoft's
   libraries make of a format, "1.#IND00", "1.#QNAN0e+000", "1.#J". */
static const char *read_word(const char *at, char separator, double *value) {
    static const char *const words[] = {"infinity", "inf", "nan", "1.#"};
    const char *p = at + (*at == '-' || *at == '+');

    /* which word it is */
    size_t k = 0;
    while (k < 4 && strncasecmp(p, words[k], strlen(words[k])) != 0) k++;
    if (k == 4) return NULL;
    p += strlen(words[k]);

    /* behind 1.# a kind of nothing, shortened as the format was, and an exponent */
    if (k == 3)
        while (isalnum((unsigned char)*p) || *p == '+' || *p == '-') p++;

    /* nan may have a payload in brackets */
    if (k == 2 && *p == '(') {
        const char *bracket = p + 1;
        while (isalnum((unsigned char)*bracket) || *bracket == '_') bracket++;
        if (*bracket == ')') p = bracket + 1;
    }

    /* the word ends at a separator or the line's end */
    if (!is_word_end(p, separator)) return NULL;
    *value = NAN;

    return p;
}

/* "1,5" as 1.5 */
static const char *read_with_comma(const char *at, double *value) {
    char text[64];
    size_t n = 0;
    bool seen = false;
    while (n < sizeof text - 1 && !wcut_is_blank(at[n]) && at[n] != ';' && at[n] != '\n' && at[n] != '\r' && at[n]) {
        if (at[n] == '.' || (at[n] == ',' && (seen || at[n + 1] < '0' || at[n + 1] > '9'))) return NULL;
        text[n] = at[n];
        if (at[n] == ',') text[n] = '.', seen = true;
        n++;
    }
    text[n] = '\0';
    return wcut_decimal_read(text, value) == text + n && n > 0 ? at + n : NULL;
}

const char *wcut_row_number(const char *at, char separator, bool comma, double *value) {
    at = wcut_skip_blanks(at);
    const char *behind = wcut_decimal_read(at, value);
    if (behind == at || *behind == '#') {
        behind = read_word(at, separator, value);
        if (!behind) return NULL;
    } else {
        if (comma && *behind == ',') behind = read_with_comma(at, value);
        if (!behind || !isfinite(*value)) return NULL;
    }
    return wcut_is_blank(*behind) || *behind == separator || wcut_is_line_end(behind) ? behind : NULL;
}

bool wcut_row_has_word(const char *at, const char *word) {
    const size_t n = strlen(word);
    return strncasecmp(at, word, n) == 0 && (wcut_is_blank(at[n]) || wcut_is_line_end(at + n));
}

const char *wcut_row_count(const char *at, int64_t *count) {
    int64_t n = 0;
    at = wcut_skip_blanks(at);
    const char *first = at;
    for (; *at >= '0' && *at <= '9'; at++) {
        if (n > (INT64_MAX - 9) / 10) return NULL;
        n = 10 * n + (*at - '0');
    }
    if (at == first || !(wcut_is_blank(*at) || wcut_is_line_end(at))) return NULL;
    *count = n;
    return at;
}
