/* Lines of an OBJ file (Wavefront): what changes no triangle is passed over, free-form geometry refused. */
#include "io/mesh/obj.h"

#include <stdint.h>
#include <string.h>
#include <wirecut/cloud_file.h>

/* where a backslash says that the line goes on behind its end; NULL: it does not */
static char *find_continuation(const char *line, size_t length) {
    size_t n = length;
    while (n > 0 && (line[n - 1] == '\n' || line[n - 1] == '\r')) n--;
    /* NOLINTNEXTLINE(performance-no-int-to-ptr): the line is in the source's own window, which is writable */
    return n < length && n > 0 && line[n - 1] == '\\' ? (char *)(uintptr_t)line + n - 1 : NULL;
}

const char *wcut_obj_line(wcut_source *s, size_t *length) {
    const char *line = wcut_row_peek(s, length);

    /* lines that go on become one: blanks in the window, in the place of the backslash and the line's end */
    for (char *p; line && (p = find_continuation(line, *length)) != NULL; line = wcut_row_peek(s, length)) {
        memset(p, ' ', (size_t)(line + *length - p));
        s->line++;
    }
    const char *zero = line ? memchr(line, 0, *length) : NULL;
    if (zero) wcut_source_refuse_text(s, line, zero, "text");
    return zero ? NULL : line;
}

const char *wcut_obj_match(const char *p, const char *keyword) {
    const char *w = keyword;
    while (*w && *p == *w) p++, w++;
    return *w == '\0' && (wcut_is_blank(*p) || wcut_is_line_end(p)) ? wcut_skip_blanks(p) : NULL;
}

bool wcut_obj_vertex(wcut_source *s, const char *line, const char *p, double value[WCUT_FIELDS]) {
    int count = 0;
    for (; !wcut_is_line_end(p) && count < WCUT_FIELDS; count++) {
        const char *behind = wcut_row_number(p, ' ', false, &value[count]);
        if (!behind) return wcut_source_refuse_text(s, line, p, "a number");
        p = wcut_skip_blanks(behind);
    }
    if (!wcut_is_line_end(p) || count < 3 || count == 5)
        return wcut_source_refuse_text(s, line, p, "3 coordinates, with a weight or a colour at most");
    return count != 4 || value[3] == 1 || wcut_source_refuse_text(s, line, line, "a vertex of weight 1");
}

bool wcut_obj_is_passed_over(const char *p) {
    static const char *const word[] = {"vt", "vn", "o", "g", "s", "usemtl", "mtllib", "l", "p", "lod", "mg"};
    if (*p == '#' || wcut_is_line_end(p)) return true;
    for (size_t k = 0; k < sizeof word / sizeof *word; k++)
        if (wcut_obj_match(p, word[k])) return true;
    return false;
}

bool wcut_obj_refuse(wcut_source *s, const char *line, const char *p) {
    return wcut_source_refuse_text(s, line, p, "a polygon mesh: v, vt, vn, f, o, g, s, usemtl");
}
