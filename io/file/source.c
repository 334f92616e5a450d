/* A file that is read byte by byte or line by line: opened, refused with its place, checked at its end. */
#include "io/file/source.h"

#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/locale.h"

/* the stream, opened, becomes the source's; it is closed on failure */
static wcut_status take_stream(wcut_stream stream, const char *label, wcut_source *source, wcut_error *error) {
    char *copy = wcut_copy(label, strlen(label) + 1, 1);
    if (!copy) {
        wcut_stream_close(&stream);
        return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    *source = (wcut_source){.stream = stream, .label = copy, .scale = 1};
    return WCUT_OK;
}

wcut_status wcut_source_open(const char *path, wcut_source *source, wcut_error *error) {
    wcut_stream stream;
    const wcut_status status = wcut_stream_open(path, &stream, error);
    if (status == WCUT_NO_MEMORY) return wcut_fail(error, status, "%s", wcut_status_text(status));
    return status == WCUT_OK ? take_stream(stream, path, source, error) : status;
}

wcut_status wcut_source_open_memory(const void *bytes, size_t size, size_t window, const char *label,
                                    wcut_source *source, wcut_error *error) {
    wcut_stream stream;
    const wcut_status status = wcut_stream_open_memory(bytes, size, window, &stream);
    return status == WCUT_OK ? take_stream(stream, label, source, error) : status;
}

void wcut_source_close(wcut_source *source) {
    wcut_stream_close(&source->stream);
    free(source->label);
    source->label = NULL;
}

/* ---- refusals ---- */

bool wcut_source_refuse(wcut_source *s, const char *format, ...) {
    char label[WCUT_QUOTE_SIZE], text[200];
    va_list arguments;
    va_start(arguments, format);
    locale_t before = wcut_locale_plain();
    vsnprintf(text, sizeof text, format, arguments);
    wcut_locale_restore(before);
    va_end(arguments);
    wcut_quote(label, s->label, WCUT_LABEL_MAX, 1);
    if (s->line > 0)
        wcut_fail(&s->failure, WCUT_BAD_FORMAT, "%s: line %ld: %s", label, s->line, text);
    else
        wcut_fail(&s->failure, WCUT_BAD_FORMAT, "%s: byte %llu: %s", label,
                  (unsigned long long)wcut_stream_offset(&s->stream), text);
    return false;
}

bool wcut_source_refuse_memory(wcut_source *s) {
    char label[WCUT_QUOTE_SIZE];
    wcut_fail(&s->failure, WCUT_NO_MEMORY, "%s: %s", wcut_quote(label, s->label, WCUT_LABEL_MAX, 1),
              wcut_status_text(WCUT_NO_MEMORY));
    return false;
}

/* a read that failed looks like an end, but the file is not to blame */
static bool refuse_read(wcut_source *s) {
    wcut_fail_errno(&s->failure, WCUT_NOT_FOUND, s->stream.code, s->label, "cannot be read");
    return false;
}

bool wcut_source_refuse_end(wcut_source *s, const char *expected) {
    if (s->stream.code) return refuse_read(s);
    s->stream.at = s->stream.end;
    return wcut_source_refuse(s, "found the end of the file, expected %s", expected);
}

bool wcut_source_refuse_truncated(wcut_source *s, int64_t left, const char *what) {
    if (s->stream.code) return refuse_read(s);
    s->stream.at = s->stream.end;
    return wcut_source_refuse(s, "found the end of the file, expected %lld %s more", (long long)left, what);
}

bool wcut_source_refuse_text(wcut_source *s, const char *line, const char *at, const char *expected) {
    char label[WCUT_QUOTE_SIZE], found[WCUT_FOUND_MAX + 4], shown[WCUT_QUOTE_SIZE];
    size_t n = 0;
    while (n < sizeof found - 1 && at[n] && at[n] != '\n' && at[n] != '\r') found[n] = at[n], n++;
    found[n] = '\0';
    const char *cause = n > 0           ? wcut_quote(shown, found, WCUT_FOUND_MAX, 0)
                        : at[0] == '\0' ? "a zero byte or the end of the file"
                                        : "the end of the line";
    wcut_fail(&s->failure, WCUT_BAD_FORMAT, "%s: line %ld, column %ld: found %s, expected %s",
              wcut_quote(label, s->label, WCUT_LABEL_MAX, 1), s->line, (long)(at - line) + 1, cause, expected);
    return false;
}

/* what programs leave behind the last element: line ends, pages filled with zeros, the end-of-file of DOS */
static bool is_padding(unsigned char c) {
    return c == 0 || c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == 0x1a;
}

bool wcut_source_check_end(wcut_source *s, size_t record) {
    /* less than a record is none that was lost */
    if (s->binary && record <= s->stream.capacity && wcut_stream_fill(&s->stream, record) < record)
        return s->stream.code ? refuse_read(s) : true;
    while (wcut_stream_fill(&s->stream, 1) > 0) {
        const unsigned char c = s->stream.data[s->stream.at];
        if (!is_padding(c))
            return wcut_source_refuse(
                s, "found more data after the last element that the header states, expected the end");
        s->stream.at++;
        s->line += c == '\n' && s->line > 0;
    }
    return s->stream.code ? refuse_read(s) : true;
}

bool wcut_source_check_count(wcut_source *s, int64_t count, uint64_t size, const char *what) {
    if (count < 0 || count > INT_MAX)
        return wcut_source_refuse(s, "found a count of %lld %s, expected 0 to %d", (long long)count, what, INT_MAX);
    const uint64_t left = wcut_stream_left(&s->stream);
    if (size > 0 && (uint64_t)count > left / size)
        return wcut_source_refuse(
            s, "found a count of %lld %s in the header and %llu bytes of data, expected at least %llu bytes each",
            (long long)count, what, (unsigned long long)left, (unsigned long long)size);
    return true;
}
