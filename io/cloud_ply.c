/* PLY (Turk 1994) as a cloud: the vertices of any header, ascii or binary; other elements and properties are
   skipped. */
#include <stdlib.h>
#include <string.h>

#include "cloud_record.h"
#include "cloud_row.h"
#include "fail.h"

enum { ELEMENTS_MOST = 64, PROPERTIES_MOST = 256 };

typedef struct ply_property {
    wcut_scalar count; /* of a list; WCUT_NO_SCALAR: a scalar */
    wcut_scalar value;
    int field; /* x y z nx ny nz as 0 .. 5, or -1 */
} ply_property;

typedef struct ply_element {
    int64_t count;
    int first, properties; /* its ones in ply.property */
    bool is_vertex, has_list;
    size_t size; /* [byte] of a record, a list counting as its count alone: the least it can be */
} ply_element;

typedef struct ply {
    wcut_record record; /* the state begins with it: wcut_record_fill reads it */
    bool ascii;
    int vertex; /* the element that is the cloud, -1 before it is found */
    int elements, properties;
    ply_element element[ELEMENTS_MOST];
    ply_property property[PROPERTIES_MOST];
} ply;

/* ---- the header ---- */

static wcut_scalar find_scalar(const char *p) {
    static const char *const name[] = {"char", "int8",  "uchar", "uint8",  "short", "int16",   "ushort", "uint16",
                                       "int",  "int32", "uint",  "uint32", "float", "float32", "double", "float64"};
    static const wcut_scalar scalar[] = {WCUT_I8, WCUT_U8, WCUT_I16, WCUT_U16, WCUT_I32, WCUT_U32, WCUT_F32, WCUT_F64};
    for (int k = 0; k < 16; k++)
        if (wcut_row_has_word(p, name[k])) return scalar[k / 2];
    return WCUT_NO_SCALAR;
}

static const char *next_word(const char *p) {
    while (!wcut_is_blank(*p) && !wcut_is_line_end(p)) p++;
    return wcut_skip_blanks(p);
}

static bool read_format(wcut_cloud_source *s, const char *line, const char *p, ply *m, bool *seen) {
    const char *version = next_word(p);
    if (*seen) return wcut_cloud_refuse_text(s, line, line, "one format");
    *seen = true;
    m->ascii = wcut_row_has_word(p, "ascii");
    m->record.big_endian = wcut_row_has_word(p, "binary_big_endian");
    if (!m->ascii && !m->record.big_endian && !wcut_row_has_word(p, "binary_little_endian"))
        return wcut_cloud_refuse_text(s, line, p, "ascii, binary_little_endian or binary_big_endian");
    return wcut_row_has_word(version, "1.0") || wcut_cloud_refuse_text(s, line, version, "1.0");
}

static bool read_element(wcut_cloud_source *s, const char *line, const char *p, ply *m) {
    if (m->elements == ELEMENTS_MOST) return wcut_cloud_refuse_text(s, line, line, "at most 64 elements");
    ply_element *e = &m->element[m->elements];
    *e = (ply_element){.first = m->properties, .is_vertex = wcut_row_has_word(p, "vertex")};
    if (e->is_vertex && m->vertex >= 0) return wcut_cloud_refuse_text(s, line, p, "one element vertex");
    if (e->is_vertex) m->vertex = m->elements;
    p = next_word(p);
    const char *behind = wcut_row_count(p, &e->count);
    if (!behind || !wcut_is_line_end(wcut_skip_blanks(behind)))
        return wcut_cloud_refuse_text(s, line, p, "a count, an integer that is not negative");
    m->elements++;
    return true;
}

static int find_field(const char *name) {
    static const char *const known[] = {"x", "y", "z", "nx", "ny", "nz"};
    for (int k = 0; k < WCUT_FIELDS; k++)
        if (wcut_row_has_word(name, known[k])) return k;
    return -1;
}

static bool read_property(wcut_cloud_source *s, const char *line, const char *p, ply *m) {
    if (m->elements == 0) return wcut_cloud_refuse_text(s, line, line, "an element before its properties");
    if (m->properties == PROPERTIES_MOST) return wcut_cloud_refuse_text(s, line, line, "at most 256 properties");
    ply_element *e = &m->element[m->elements - 1];
    ply_property *q = &m->property[m->properties];
    *q = (ply_property){.field = -1};
    if (wcut_row_has_word(p, "list")) {
        p = next_word(p);
        q->count = find_scalar(p);
        if (q->count == WCUT_NO_SCALAR || q->count == WCUT_F32 || q->count == WCUT_F64)
            return wcut_cloud_refuse_text(s, line, p, "an integer type for a list's count");
        p = next_word(p);
        e->has_list = true;
    }
    q->value = find_scalar(p);
    if (q->value == WCUT_NO_SCALAR) return wcut_cloud_refuse_text(s, line, p, "a type such as float, double or uchar");
    p = next_word(p);
    if (wcut_is_line_end(p)) return wcut_cloud_refuse_text(s, line, p, "the property's name");
    if (e->is_vertex) q->field = find_field(p);
    if (q->field >= 0 && q->count) return wcut_cloud_refuse_text(s, line, p, "a coordinate that is no list");
    for (int k = e->first; q->field >= 0 && k < m->properties; k++)
        if (m->property[k].field == q->field) return wcut_cloud_refuse_text(s, line, p, "each coordinate once");
    e->size += wcut_scalar_size(q->count ? q->count : q->value);
    e->properties++;
    m->properties++;
    return true;
}

/* every line up to end_header */
static bool read_header(wcut_cloud_source *s, ply *m) {
    bool seen = false;
    size_t length;
    for (const char *line; (line = wcut_row_peek(s, &length)) != NULL; wcut_row_done(s, length)) {
        const char *p = wcut_skip_blanks(line), *rest = next_word(p);
        bool read = true;
        if (wcut_row_has_word(p, "end_header")) {
            if (!seen) return wcut_cloud_refuse_text(s, line, p, "a format before it");
            wcut_row_done(s, length);
            return true;
        }
        if (wcut_row_has_word(p, "format"))
            read = read_format(s, line, rest, m, &seen);
        else if (wcut_row_has_word(p, "element"))
            read = read_element(s, line, rest, m);
        else if (wcut_row_has_word(p, "property"))
            read = read_property(s, line, rest, m);
        else if (!wcut_row_has_word(p, "comment") && !wcut_row_has_word(p, "obj_info") &&
                 !(s->line == 1 && wcut_row_has_word(p, "ply")))
            read = wcut_cloud_refuse_text(s, line, p, "a word of a PLY header");
        if (!read) return false;
    }
    return s->failure.status == WCUT_OK && wcut_cloud_refuse_end(s, "end_header");
}

/* ---- elements, skipped ---- */

/* a list's count and values, binary; false: refused */
static bool skip_list(wcut_cloud_source *s, const ply *m, const ply_property *q) {
    const size_t size = wcut_scalar_size(q->count);
    if (wcut_stream_fill(&s->stream, size) < size) return wcut_cloud_refuse_end(s, "a list's count");
    const double count = wcut_scalar_load(s->stream.data + s->stream.at, q->count, m->record.big_endian);
    if (count < 0) return wcut_cloud_refuse(s, "found a list of %.0f values, expected 0 or more", count);
    s->stream.at += size;
    return wcut_stream_skip(&s->stream, (uint64_t)count * wcut_scalar_size(q->value)) ||
           wcut_cloud_refuse_end(s, "a list's values");
}

/* one record, binary, into value where it is wanted */
static bool read_binary(wcut_cloud_source *s, const ply *m, const ply_element *e, double *value) {
    for (const ply_property *q = m->property + e->first; q < m->property + e->first + e->properties; q++) {
        if (q->count) {
            if (!skip_list(s, m, q)) return false;
            continue;
        }
        const size_t size = wcut_scalar_size(q->value);
        if (wcut_stream_fill(&s->stream, size) < size) return wcut_cloud_refuse_end(s, "the elements that are stated");
        if (q->field >= 0)
            value[q->field] = wcut_scalar_load(s->stream.data + s->stream.at, q->value, m->record.big_endian);
        s->stream.at += size;
    }
    return true;
}

/* one record, a line of text */
static bool read_ascii(wcut_cloud_source *s, const ply *m, const ply_element *e, double *value) {
    size_t length;
    const char *line = wcut_row_peek(s, &length), *p = line;
    if (!line) return s->failure.status == WCUT_OK && wcut_cloud_refuse_end(s, "as many lines as elements are stated");
    for (const ply_property *q = m->property + e->first; q < m->property + e->first + e->properties; q++) {
        int64_t values = 1;
        if (q->count) {
            const char *behind = wcut_row_count(p, &values);
            if (!behind) return wcut_cloud_refuse_text(s, line, wcut_skip_blanks(p), "a list's count, 0 or more");
            p = behind;
        }
        for (double any; values > 0; values--) {
            const char *behind = wcut_row_number(p, ' ', false, q->field >= 0 ? &value[q->field] : &any);
            if (!behind) return wcut_cloud_refuse_text(s, line, wcut_skip_blanks(p), "a number");
            p = behind;
        }
    }
    p = wcut_skip_blanks(p);
    if (!wcut_is_line_end(p)) return wcut_cloud_refuse_text(s, line, p, "the end of the line");
    wcut_row_done(s, length);
    return true;
}

static bool skip_elements(wcut_cloud_source *s, const ply *m, int first, int end) {
    double none[WCUT_FIELDS];
    for (const ply_element *e = m->element + first; e < m->element + end; e++) {
        const uint64_t count = (uint64_t)e->count;
        if (!m->ascii && !e->has_list) {
            if (e->size > 0 && count > UINT64_MAX / e->size)
                return wcut_cloud_refuse_end(s, "the elements that are stated");
            if (!wcut_stream_skip(&s->stream, count * e->size))
                return wcut_cloud_refuse_end(s, "the elements that are stated");
            continue;
        }
        if (e->properties == 0) continue; /* nothing stands for them, however many */
        for (uint64_t k = 0; k < count; k++)
            if (!(m->ascii ? read_ascii(s, m, e, none) : read_binary(s, m, e, none))) return false;
    }
    return true;
}

/* ---- the vertices ---- */

static bool fill(wcut_cloud_source *s, wcut_batch *b) {
    const ply *m = s->state;
    const ply_element *e = &m->element[m->vertex];
    double value[WCUT_FIELDS] = {0};
    if (!m->ascii && !e->has_list) {
        if (!wcut_record_fill(s, b)) return false;
    } else {
        for (; s->left > 0 && b->count < b->capacity; s->left--) {
            if (!(m->ascii ? read_ascii(s, m, e, value) : read_binary(s, m, e, value))) return false;
            if (!wcut_cloud_take(s, b, value)) return false;
        }
    }
    if (s->left != 0) return true;
    s->left = -1; /* what follows is looked at once */
    return skip_elements(s, m, m->vertex + 1, m->elements) && wcut_cloud_check_end(s);
}

/* from the vertex's properties to its record */
static bool lay_out(wcut_cloud_source *s, ply *m) {
    if (m->vertex < 0) return wcut_cloud_refuse(s, "found no element vertex, expected one");
    const ply_element *e = &m->element[m->vertex];
    bool has[WCUT_FIELDS] = {false};
    size_t offset = 0;
    for (const ply_property *q = m->property + e->first; q < m->property + e->first + e->properties; q++) {
        if (q->field >= 0) {
            has[q->field] = true;
            m->record.field[q->field].scalar = q->value;
            m->record.field[q->field].offset = offset;
            m->record.field[q->field].factor = 1;
        }
        offset += wcut_scalar_size(q->count ? q->count : q->value);
    }
    for (int k = 0; k < 3; k++)
        if (!has[k]) return wcut_cloud_refuse(s, "found no property %c of the element vertex, expected one", "xyz"[k]);
    m->record.size = e->size;
    m->record.fields = has[3] && has[4] && has[5] ? 6 : 3;
    s->info.has_normals = m->record.fields == 6;
    return true;
}

bool wcut_cloud_begin_ply(wcut_cloud_source *s) {
    ply *m = wcut_io_alloc(1, sizeof *m);
    if (!m) return wcut_cloud_refuse_memory(s);
    s->state = m;
    s->line = 1;
    s->fill = fill;
    m->vertex = -1;
    if (!read_header(s, m) || !lay_out(s, m)) return false;
    s->binary = !m->ascii;
    if (!m->ascii) s->line = 0;
    const ply_element *e = &m->element[m->vertex];
    /* a value of text takes a digit and a blank or line feed, but the last one's */
    const uint64_t least = m->ascii ? 2 * (uint64_t)e->properties - 1 : e->size;
    return skip_elements(s, m, 0, m->vertex) && wcut_cloud_state(s, e->count, least, "vertices");
}
