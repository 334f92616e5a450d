/* OFF (Geomview): a line a vertex, a line a face; colours, normals and texture coordinates behind them. */
#include "io/mesh/off_read.h"

#include <limits.h>
#include <string.h>
#include <strings.h>

#include "io/file/row.h"

/* the next line that says something; NULL: the end, or refused */
static const char *next_line(wcut_source *s, size_t *length) {
    const char *line;
    while ((line = wcut_row_peek(s, length)) != NULL) {
        const char *p = wcut_skip_blanks(line);
        if (*p != '#' && !wcut_is_line_end(p)) return line;
        wcut_row_done(s, *length);
    }
    return NULL;
}

static const char *expect_off_line(wcut_source *s, size_t *length, const char *expected) {
    const char *line = next_line(s, length);
    if (!line && s->failure.status == WCUT_OK) wcut_source_refuse_end(s, expected);
    return line;
}

/* behind the keyword, which a file may leave out; NULL: one of a kind that is not read, refused */
static const char *read_keyword(wcut_source *s, const char *line, const char *p, wcut_off_reader *r) {
    static const char *const expected = "OFF, COFF, NOFF or CNOFF: with vertices in space, as text";
    if (*p >= '0' && *p <= '9') return p;
    const char *from = p;
    if (strncasecmp(p, "st", 2) == 0) p += 2;
    if (*p == 'C' || *p == 'c') p++;
    r->has_normals = *p == 'N';
    if (*p == 'N') p++;
    if (strncasecmp(p, "off", 3) != 0 || !(wcut_is_blank(p[3]) || wcut_is_line_end(p + 3) || p[3] == '#'))
        return wcut_source_refuse_text(s, line, from, expected), NULL;
    p = wcut_skip_blanks(p + 3);
    if (wcut_row_has_word(p, "binary")) return wcut_source_refuse_text(s, line, from, expected), NULL;
    return p;
}

bool wcut_off_begin(wcut_source *s, wcut_off_reader *r) {
    enum { SHORTEST = 6 }; /* bytes of a vertex: "0 0 0" and a line feed */
    static const char *const expected = "the counts of vertices, faces and edges";
    size_t length;
    int64_t edges = 0;

    /* a byte order mark is passed over */
    *r = (wcut_off_reader){.source = s};
    s->line = 1;
    if (s->stream.end - s->stream.at >= 3 && memcmp(s->stream.data + s->stream.at, "\xef\xbb\xbf", 3) == 0)
        s->stream.at += 3;

    /* the keyword, whose line may have the counts as well */
    const char *line = expect_off_line(s, &length, "OFF");
    const char *p = line ? read_keyword(s, line, wcut_skip_blanks(line), r) : NULL;
    if (!p) return false;
    if (wcut_is_line_end(p) || *p == '#') {
        wcut_row_done(s, length);
        p = line = expect_off_line(s, &length, expected);
        if (!line) return false;
    }

    /* some programs leave out the count of the edges */
    const char *behind = wcut_row_count(p, &r->vertices);
    if (behind) behind = wcut_row_count(behind, &r->faces);
    if (!behind) return wcut_source_refuse_text(s, line, wcut_skip_blanks(p), expected);
    p = wcut_skip_blanks(behind);
    if (!wcut_is_line_end(p) && *p != '#' && !wcut_row_count(p, &edges))
        return wcut_source_refuse_text(s, line, p, expected);

    /* counts are limited by what is left of the file */
    wcut_row_done(s, length);
    if (r->faces > INT_MAX) return wcut_source_check_count(s, r->faces, 0, "faces");

    return wcut_source_check_count(s, r->vertices, SHORTEST, "vertices");
}

bool wcut_off_vertex(wcut_off_reader *r, double value[WCUT_FIELDS]) {
    wcut_source *s = r->source;
    size_t length;
    const char *line = next_line(s, &length), *p = line;
    if (!line) return s->failure.status == WCUT_OK && wcut_source_refuse_truncated(s, r->vertices, "vertices");
    for (int k = 0; k < (r->has_normals ? 6 : 3); k++) {
        const char *behind = wcut_row_number(p, ' ', false, &value[k]);
        if (!behind) return wcut_source_refuse_text(s, line, wcut_skip_blanks(p), "a number");
        p = behind;
    }
    r->vertices--; /* a colour or texture coordinates may follow */
    wcut_row_done(s, length);
    return true;
}

bool wcut_off_face(wcut_off_reader *r, int max, int *corner, int *count) {
    wcut_source *s = r->source;

    /* a face is one line */
    size_t length;
    int64_t n = 0, index = 0;
    const char *line = next_line(s, &length);
    if (!line) return s->failure.status == WCUT_OK && wcut_source_refuse_truncated(s, r->faces, "faces");

    /* the number of corners, then the corners; colours behind them are passed over */
    const char *p = wcut_row_count(line, &n);
    if (!p || n > max)
        return wcut_source_refuse_text(s, line, wcut_skip_blanks(line), "a face: its number of corners, and these");
    for (int k = 0; k < (int)n; k++) {
        const char *behind = wcut_row_count(p, &index);
        if (!behind || index > INT_MAX)
            return wcut_source_refuse_text(s, line, wcut_skip_blanks(p), "the number of a vertex");
        corner[k] = (int)index;
        p = behind;
    }

    /* one face less */
    *count = (int)n;
    r->faces--;
    wcut_row_done(s, length);

    return true;
}

bool wcut_off_end(wcut_off_reader *r) {
    size_t length;
    const char *line = next_line(r->source, &length);
    if (!line) return r->source->failure.status == WCUT_OK;
    return wcut_source_refuse_text(r->source, line, wcut_skip_blanks(line), "the end: the header states no more faces");
}
