/* STL read: the corners of its triangles. ASCII may have other lines before the first "solid", and any normals. */
#include "io/mesh/stl_read.h"

#include <string.h>

#include "io/file/record.h"
#include "io/file/row.h"

enum { HEADER = 84, FACET = 50, CORNER = 12, SNIFF = 512, LINES_BEFORE = 100 };

/* ---- binary: 80 bytes, a count, 50 bytes a triangle ---- */

/* a file of just the size that its count asks for, or one whose first bytes are no text: a count below 2^24 has a zero */
static bool is_binary(wcut_source *s) {
    const wcut_stream *t = &s->stream;
    const size_t n = wcut_stream_fill(&s->stream, SNIFF);
    const unsigned char *at = t->data + t->at;
    if (n >= HEADER && t->size >= 0 &&
        (uint64_t)t->size == HEADER + FACET * (uint64_t)wcut_load_32(at + HEADER - 4, false))
        return true;
    return memchr(at, 0, n < SNIFF ? n : SNIFF) != NULL;
}

/* how many triangles follow: programs that write as they go leave 0 or all ones in the place of the count */
static uint32_t count_facets(const wcut_source *s, uint32_t stated) {
    const uint64_t left = wcut_stream_left(&s->stream);
    const bool left_open = stated == 0 || stated == UINT32_MAX;
    if (!left_open || left == UINT64_MAX || left % FACET != 0 || left / FACET >= UINT32_MAX) return stated;
    return (uint32_t)(left / FACET);
}

static bool begin_binary(wcut_source *s, wcut_stl_reader *r) {
    if (wcut_stream_fill(&s->stream, HEADER) < HEADER)
        return wcut_source_refuse_end(s, "the 84 bytes of an STL header");
    const uint32_t stated = wcut_load_32(s->stream.data + s->stream.at + HEADER - 4, false);
    s->stream.at += HEADER;
    s->binary = true;
    r->stated = count_facets(s, stated);
    r->left = 3 * r->stated;
    return wcut_source_check_count(s, r->stated, FACET, "triangles") &&
           wcut_source_check_count(s, r->left, 0, "corners");
}

static bool next_binary(wcut_stl_reader *r, double corner[3]) {
    wcut_source *s = r->source;
    if (r->left == 0) {
        wcut_source_check_end(s, FACET);
        return false;
    }
    const size_t k = 2 - (size_t)((r->left - 1) % 3);
    if (k == 0 && wcut_stream_fill(&s->stream, FACET) < FACET)
        return wcut_source_refuse_truncated(s, r->left, "corners");
    const unsigned char *at = s->stream.data + s->stream.at + CORNER * (1 + k);
    for (size_t c = 0; c < 3; c++) corner[c] = wcut_scalar_load(at + 4 * c, WCUT_SCALAR_F32, false);
    r->left--;
    if (k == 2) s->stream.at += FACET;
    return true;
}

/* ---- ASCII: seven lines a triangle ---- */

typedef enum stl_line { SOLID, FACET_OR_END, LOOP, FIRST, SECOND, THIRD, END_LOOP, END_FACET } stl_line;

static const char *const words[][2] = {{"solid", ""},  {"facet", "normal"}, {"outer", "loop"}, {"vertex", ""},
                                       {"vertex", ""}, {"vertex", ""},      {"endloop", ""},   {"endfacet", ""}};

/* behind a word in either case; NULL: another one stands there */
static const char *match(const char *p, const char *word) {
    p = wcut_skip_blanks(p);
    return wcut_row_has_word(p, word) ? wcut_skip_blanks(p + strlen(word)) : NULL;
}

/* the numbers of a line's rest; the line must end behind them */
static bool read_three(wcut_source *s, const char *line, const char *p, double value[3]) {
    for (int k = 0; k < 3; k++) {
        const char *behind = wcut_row_number(p, ' ', false, &value[k]);
        if (!behind) return wcut_source_refuse_text(s, line, wcut_skip_blanks(p), "a number");
        p = wcut_skip_blanks(behind);
    }
    return wcut_is_line_end(p) || wcut_source_refuse_text(s, line, p, "the end of the line");
}

/* lines before the first "solid": a byte order mark, blanks, comments, whatever a program puts there */
static bool begin_ascii(wcut_source *s, wcut_stl_reader *r) {
    static const char mark[] = "\xef\xbb\xbf";
    wcut_stream *t = &s->stream;
    s->line = 1;
    r->state = SOLID;
    if (t->end - t->at >= 3 && memcmp(t->data + t->at, mark, 3) == 0) t->at += 3;
    size_t length;
    for (const char *line; (line = wcut_row_peek(s, &length)) != NULL; wcut_row_done(s, length)) {
        if (match(line, "solid")) return true;
        if (s->line == LINES_BEFORE)
            return wcut_source_refuse_text(s, line, wcut_skip_blanks(line), "solid in one of the first 100 lines");
    }
    return s->failure.status == WCUT_OK && wcut_source_refuse_end(s, "solid, or the 84 bytes of a binary STL header");
}

/* one line; has_corner: it was a vertex */
static bool read_stl_line(wcut_stl_reader *r, const char *line, double corner[3], bool *has_corner) {
    static const char *const expected[] = {
        "solid", "endsolid or facet normal", "outer loop", "vertex", "vertex", "vertex", "endloop", "endfacet"};
    const stl_line at = (stl_line)r->state;
    if (at == FACET_OR_END && match(line, "endsolid")) {
        r->state = SOLID;
        return true;
    }
    const char *p = match(line, words[at][0]);
    if (p && words[at][1][0]) p = match(p, words[at][1]);
    if (!p) return wcut_source_refuse_text(r->source, line, wcut_skip_blanks(line), expected[at]);
    *has_corner = at >= FIRST && at <= THIRD;
    if (*has_corner && !read_three(r->source, line, p, corner)) return false;
    r->state = at == END_FACET ? FACET_OR_END : (int)at + 1;
    return true;
}

static bool next_ascii(wcut_stl_reader *r, double corner[3]) {
    wcut_source *s = r->source;
    bool has_corner = false;
    while (!has_corner) {
        size_t length;
        const char *line = wcut_row_peek(s, &length);
        if (!line) {
            if (s->failure.status == WCUT_OK && r->state != SOLID) wcut_source_refuse_end(s, "endsolid");
            return false;
        }
        if (!wcut_is_line_end(wcut_skip_blanks(line)) && !read_stl_line(r, line, corner, &has_corner)) return false;
        wcut_row_done(s, length);
    }
    return true;
}

/* ---- either ---- */

bool wcut_stl_begin(wcut_source *s, wcut_stl_reader *r) {
    *r = (wcut_stl_reader){.source = s, .is_binary = is_binary(s), .stated = -1};
    return r->is_binary ? begin_binary(s, r) : begin_ascii(s, r);
}

bool wcut_stl_next(wcut_stl_reader *r, double corner[3]) {
    return r->is_binary ? next_binary(r, corner) : next_ascii(r, corner);
}
