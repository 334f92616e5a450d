/* PLY (Turk 1994): what a header says of the elements and properties to come. */
#include <string.h>

#include "io/file/row.h"
#include "io/mesh/ply.h"

static wcut_scalar find_ply_header_scalar(const char *p) {
    static const char *const name[] = {"char", "int8",  "uchar", "uint8",  "short", "int16",   "ushort", "uint16",
                                       "int",  "int32", "uint",  "uint32", "float", "float32", "double", "float64"};
    static const wcut_scalar scalar[] = {WCUT_SCALAR_I8,  WCUT_SCALAR_U8,  WCUT_SCALAR_I16, WCUT_SCALAR_U16,
                                         WCUT_SCALAR_I32, WCUT_SCALAR_U32, WCUT_SCALAR_F32, WCUT_SCALAR_F64};
    for (int k = 0; k < 16; k++)
        if (wcut_row_has_word(p, name[k])) return scalar[k / 2];
    return WCUT_SCALAR_NONE;
}

static const char *next_ply_word(const char *p) {
    while (!wcut_is_blank(*p) && !wcut_is_line_end(p)) p++;
    return wcut_skip_blanks(p);
}

static bool read_ply_header_format(wcut_source *s, const char *line, const char *p, wcut_ply *m, bool *seen) {
    const char *version = next_ply_word(p);
    if (*seen) return wcut_source_refuse_text(s, line, line, "one format");
    *seen = true;
    m->ascii = wcut_row_has_word(p, "ascii");
    m->record.big_endian = wcut_row_has_word(p, "binary_big_endian");
    if (!m->ascii && !m->record.big_endian && !wcut_row_has_word(p, "binary_little_endian"))
        return wcut_source_refuse_text(s, line, p, "ascii, binary_little_endian or binary_big_endian");
    return wcut_row_has_word(version, "1.0") || wcut_source_refuse_text(s, line, version, "1.0");
}

static bool read_element(wcut_source *s, const char *line, const char *p, wcut_ply *m) {
    if (m->elements == WCUT_PLY_ELEMENTS) return wcut_source_refuse_text(s, line, line, "at most 64 elements");
    wcut_ply_element *e = &m->element[m->elements];
    *e = (wcut_ply_element){
        .first = m->properties, .is_vertex = wcut_row_has_word(p, "vertex"), .is_face = wcut_row_has_word(p, "face")};
    if (e->is_vertex && m->vertex >= 0) return wcut_source_refuse_text(s, line, p, "one element vertex");
    if (e->is_face && m->face >= 0) return wcut_source_refuse_text(s, line, p, "one element face");
    if (e->is_vertex) m->vertex = m->elements;
    if (e->is_face) m->face = m->elements;
    p = next_ply_word(p);
    const char *behind = wcut_row_count(p, &e->count);
    if (!behind || !wcut_is_line_end(wcut_skip_blanks(behind)))
        return wcut_source_refuse_text(s, line, p, "a count, an integer that is not negative");
    m->elements++;
    return true;
}

static int find_field(const char *name) {
    static const char *const known[] = {"x", "y", "z", "nx", "ny", "nz"};
    for (int k = 0; k < WCUT_FIELDS; k++)
        if (wcut_row_has_word(name, known[k])) return k;
    return -1;
}

static bool read_property(wcut_source *s, const char *line, const char *p, wcut_ply *m) {
    /* a property belongs to the element before it */
    if (m->elements == 0) return wcut_source_refuse_text(s, line, line, "an element before its properties");
    if (m->properties == WCUT_PLY_PROPERTIES) return wcut_source_refuse_text(s, line, line, "at most 256 properties");
    wcut_ply_element *e = &m->element[m->elements - 1];
    wcut_ply_property *q = &m->property[m->properties];
    *q = (wcut_ply_property){.field = -1};

    /* a list: the type of its count */
    if (wcut_row_has_word(p, "list")) {
        p = next_ply_word(p);
        q->count = find_ply_header_scalar(p);
        if (q->count == WCUT_SCALAR_NONE || q->count == WCUT_SCALAR_F32 || q->count == WCUT_SCALAR_F64)
            return wcut_source_refuse_text(s, line, p, "an integer type for a list's count");
        p = next_ply_word(p);
        e->has_list = true;
    }

    /* the type of the value and the name */
    q->value = find_ply_header_scalar(p);
    if (q->value == WCUT_SCALAR_NONE)
        return wcut_source_refuse_text(s, line, p, "a type such as float, double or uchar");
    p = next_ply_word(p);
    if (wcut_is_line_end(p)) return wcut_source_refuse_text(s, line, p, "the property's name");

    /* which property gives a coordinate or the corners of a face */
    if (e->is_vertex) q->field = find_field(p);
    q->is_corners =
        e->is_face && q->count && (wcut_row_has_word(p, "vertex_indices") || wcut_row_has_word(p, "vertex_index"));
    if (q->field >= 0 && q->count) return wcut_source_refuse_text(s, line, p, "a coordinate that is no list");
    for (int k = e->first; q->field >= 0 && k < m->properties; k++)
        if (m->property[k].field == q->field) return wcut_source_refuse_text(s, line, p, "each coordinate once");

    /* the record's size, for binary files */
    e->size += wcut_scalar_size(q->count ? q->count : q->value);
    e->properties++;
    m->properties++;

    return true;
}

bool wcut_ply_header(wcut_source *s, wcut_ply *m) {
    bool seen = false;
    size_t length;

    /* no vertex or face element is known yet */
    m->vertex = m->face = -1;
    for (const char *line; (line = wcut_row_peek(s, &length)) != NULL; wcut_row_done(s, length)) {
        const char *p = wcut_skip_blanks(line), *rest = next_ply_word(p);
        bool read = true;

        /* the header ends once the format is known */
        if (wcut_row_has_word(p, "end_header")) {
            if (!seen) return wcut_source_refuse_text(s, line, p, "a format before it");
            wcut_row_done(s, length);
            return true;
        }

        /* a line by its first word */
        if (wcut_row_has_word(p, "format"))
            read = read_ply_header_format(s, line, rest, m, &seen);
        else if (wcut_row_has_word(p, "element"))
            read = read_element(s, line, rest, m);
        else if (wcut_row_has_word(p, "property"))
            read = read_property(s, line, rest, m);
        else if (!wcut_row_has_word(p, "comment") && !wcut_row_has_word(p, "obj_info") &&
                 !(s->line == 1 && wcut_row_has_word(p, "ply")))
            read = wcut_source_refuse_text(s, line, p, "a word of a PLY header");
        if (!read) return false;
    }

    return s->failure.status == WCUT_OK && wcut_source_refuse_end(s, "end_header");
}
