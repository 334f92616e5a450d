/* STL as a cloud: the corners of its triangles, binary or ASCII; what is not in its one grammar is refused. */
#include <stdlib.h>
#include <string.h>

#include "io/scan/cloud_record.h"
#include "io/scan/cloud_row.h"

enum { HEADER = 84, FACET = 50, CORNER = 12, SNIFF = 512 };

/* ---- binary: 80 bytes, a count, 50 bytes a triangle ---- */

static bool is_binary(wcut_cloud_source *s) {
    const wcut_stream *t = &s->stream;
    const size_t n = wcut_stream_fill(&s->stream, SNIFF);
    const unsigned char *at = t->data + t->at;
    if (n >= HEADER && t->size >= 0 &&
        (uint64_t)t->size == HEADER + FACET * (uint64_t)wcut_load_32(at + HEADER - 4, false))
        return true;
    return n < 5 || memcmp(at, "solid", 5) != 0 || memchr(at, 0, n < SNIFF ? n : SNIFF) != NULL;
}

/* s->left counts corners: three a triangle */
static bool fill_binary(wcut_cloud_source *s, wcut_batch *b) {
    while (s->left > 0 && b->count < b->capacity) {
        const size_t corner = 2 - (size_t)((s->left - 1) % 3);
        if (corner == 0 && wcut_stream_fill(&s->stream, FACET) < FACET)
            return wcut_cloud_refuse_truncated(s, "corners");
        const unsigned char *at = s->stream.data + s->stream.at + CORNER * (1 + corner);
        double value[WCUT_FIELDS] = {0};
        for (size_t k = 0; k < 3; k++) value[k] = wcut_scalar_load(at + 4 * k, WCUT_SCALAR_F32, false);
        if (!wcut_cloud_take(s, b, value)) return false;
        s->left--;
        if (corner == 2) s->stream.at += FACET;
    }
    return s->left > 0 || wcut_cloud_check_end(s);
}

static bool begin_binary(wcut_cloud_source *s) {
    if (wcut_stream_fill(&s->stream, HEADER) < HEADER) return wcut_cloud_refuse_end(s, "the 84 bytes of an STL header");
    const int64_t facets = wcut_load_32(s->stream.data + s->stream.at + HEADER - 4, false);
    s->stream.at += HEADER;
    s->binary = true;
    s->fill = fill_binary;
    if (!wcut_cloud_state(s, facets, FACET, "triangles")) return false;
    return wcut_cloud_state(s, 3 * facets, 0, "corners");
}

/* ---- ASCII: seven lines a triangle ---- */

typedef enum stl_line { SOLID, FACET_OR_END, LOOP, FIRST, SECOND, THIRD, END_LOOP, END_FACET } stl_line;

/* the line a reader is at is s->left */
static const char *const words[][2] = {{"solid", ""},  {"facet", "normal"}, {"outer", "loop"}, {"vertex", ""},
                                       {"vertex", ""}, {"vertex", ""},      {"endloop", ""},   {"endfacet", ""}};

static const char *match(const char *p, const char *word) {
    p = wcut_skip_blanks(p);
    return wcut_row_has_word(p, word) ? wcut_skip_blanks(p + strlen(word)) : NULL;
}

/* the numbers of a line's rest; the line must end behind them */
static bool read_three(wcut_cloud_source *s, const char *line, const char *p, double value[3]) {
    for (int k = 0; k < 3; k++) {
        const char *behind = wcut_row_number(p, ' ', false, &value[k]);
        if (!behind) return wcut_cloud_refuse_text(s, line, wcut_skip_blanks(p), "a number");
        p = wcut_skip_blanks(behind);
    }
    return wcut_is_line_end(p) || wcut_cloud_refuse_text(s, line, p, "the end of the line");
}

static bool read_line(wcut_cloud_source *s, const char *line, wcut_batch *b) {
    const stl_line at = (stl_line)s->left;
    double value[WCUT_FIELDS] = {0};
    if (at == FACET_OR_END && match(line, "endsolid")) {
        s->left = SOLID;
        return true;
    }
    const char *p = match(line, words[at][0]);
    if (p && words[at][1][0]) p = match(p, words[at][1]);
    if (!p) {
        static const char *const expected[] = {
            "solid", "endsolid or facet normal", "outer loop", "vertex", "vertex", "vertex", "endloop", "endfacet"};
        return wcut_cloud_refuse_text(s, line, wcut_skip_blanks(line), expected[at]);
    }
    if (at == FACET_OR_END && !read_three(s, line, p, value)) return false;
    if (at >= FIRST && at <= THIRD && !(read_three(s, line, p, value) && wcut_cloud_take(s, b, value))) return false;
    s->left = at == END_FACET ? FACET_OR_END : (int64_t)at + 1;
    return true;
}

static bool fill_ascii(wcut_cloud_source *s, wcut_batch *b) {
    size_t length;
    while (b->count < b->capacity) {
        const char *line = wcut_row_peek(s, &length);
        if (!line) {
            if (s->failure.status != WCUT_OK) return false;
            return s->left == SOLID || wcut_cloud_refuse_end(s, "endsolid");
        }
        if (!wcut_is_line_end(wcut_skip_blanks(line)) && !read_line(s, line, b)) return false;
        wcut_row_done(s, length);
    }
    return true;
}

bool wcut_cloud_begin_stl(wcut_cloud_source *s) {
    if (is_binary(s)) return begin_binary(s);
    s->line = 1;
    s->left = SOLID;
    s->fill = fill_ascii;
    return true;
}
