/* OFF as a cloud: its vertices, line by line in the memory of a window; the faces behind them are not looked at. */
#include <string.h>
#include <wirecut/cloud_file.h>

#include "io/file/row.h"
#include "io/scan/cloud_source.h"

/* the next line that says something, without its comment; NULL: the end, or refused */
static const char *next_line(wcut_cloud_source *s, size_t *length) {
    const char *line;
    while ((line = wcut_row_peek(&s->in, length)) != NULL) {
        const char *p = wcut_skip_blanks(line);
        if (*p != '#' && !wcut_is_line_end(p)) return line;
        wcut_row_done(&s->in, *length);
    }
    return NULL;
}

static const char *expect_line(wcut_cloud_source *s, size_t *length, const char *expected) {
    const char *line = next_line(s, length);
    if (!line && s->in.failure.status == WCUT_OK) wcut_source_refuse_end(&s->in, expected);
    return line;
}

static bool read_vertex(wcut_cloud_source *s, const char *line, wcut_batch *b) {
    double value[WCUT_FIELDS] = {0};
    const char *p = line;
    for (int k = 0; k < 3; k++) {
        const char *behind = wcut_row_number(p, ' ', false, &value[k]);
        if (!behind) return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(p), "a number");
        p = behind;
    }
    return wcut_cloud_take(s, b, value); /* a colour may follow */
}

static bool fill(wcut_cloud_source *s, wcut_batch *b) {
    size_t length;
    for (; s->left > 0 && b->count < b->capacity; s->left--) {
        const char *line = next_line(s, &length);
        if (!line)
            return s->in.failure.status == WCUT_OK ? wcut_source_refuse_truncated(&s->in, s->left, "vertices") : false;
        if (!read_vertex(s, line, b)) return false;
        wcut_row_done(&s->in, length);
    }
    return true;
}

/* "OFF" with the counts of vertices, faces and edges behind it or on the next line */
bool wcut_cloud_begin_off(wcut_cloud_source *s) {
    enum { SHORTEST = 6 }; /* bytes of a vertex: "0 0 0" and a line feed */
    static const char *const expected = "the counts of vertices, faces and edges";
    size_t length;
    int64_t vertices = 0, other = 0;
    s->in.line = 1;
    s->fill = fill;
    const char *line = expect_line(s, &length, "OFF"), *p = line ? wcut_skip_blanks(line) : NULL;
    if (!line) return false;
    if (!wcut_row_has_word(p, "off")) return wcut_source_refuse_text(&s->in, line, p, "OFF: with plain vertices");
    p = wcut_skip_blanks(p + 3);
    if (wcut_is_line_end(p) || *p == '#') {
        wcut_row_done(&s->in, length);
        p = line = expect_line(s, &length, expected);
        if (!line) return false;
    }
    const char *behind = wcut_row_count(p, &vertices);
    for (int k = 0; behind && k < 2; k++) behind = wcut_row_count(behind, &other);
    if (!behind) return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(p), expected);
    wcut_row_done(&s->in, length);
    return wcut_cloud_state(s, vertices, SHORTEST, "vertices");
}
