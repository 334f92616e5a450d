/* PLY (Turk 1994): records as the header lays them out, ascii or binary; what nobody asks for is skipped. */
#include "io/mesh/ply.h"

#include "io/file/row.h"

/* ---- binary ---- */

static bool refuse_corners(wcut_source *s, double count) {
    return wcut_source_refuse(s, "found a face of %.0f corners, expected at most %d", count, WCUT_POLYGON_MAX);
}

/* a list's count and values, kept where they are corners */
static bool read_list(wcut_source *s, const wcut_ply *m, const wcut_ply_property *q, wcut_ply_corners *corners) {
    const size_t size = wcut_scalar_size(q->count), step = wcut_scalar_size(q->value);
    if (wcut_stream_fill(&s->stream, size) < size) return wcut_source_refuse_end(s, "a list's count");
    const double count = wcut_scalar_load(s->stream.data + s->stream.at, q->count, m->record.big_endian);
    if (count < 0) return wcut_source_refuse(s, "found a list of %.0f values, expected 0 or more", count);
    s->stream.at += size;
    if (!corners || !q->is_corners)
        return wcut_stream_skip(&s->stream, (uint64_t)count * step) || wcut_source_refuse_end(s, "a list's values");
    if (count > WCUT_POLYGON_MAX) return refuse_corners(s, count);
    corners->count = (int)count;
    for (int k = 0; k < corners->count; k++) {
        if (wcut_stream_fill(&s->stream, step) < step) return wcut_source_refuse_end(s, "a list's values");
        const unsigned char *at = s->stream.data + s->stream.at;
        corners->vertex[k] = (int64_t)wcut_scalar_load(at, q->value, m->record.big_endian);
        s->stream.at += step;
    }
    return true;
}

static bool read_binary(wcut_source *s, const wcut_ply *m, const wcut_ply_element *e, double *value,
                        wcut_ply_corners *corners) {
    for (const wcut_ply_property *q = m->property + e->first; q < m->property + e->first + e->properties; q++) {
        if (q->count) {
            if (!read_list(s, m, q, corners)) return false;
            continue;
        }
        const size_t size = wcut_scalar_size(q->value);
        if (wcut_stream_fill(&s->stream, size) < size) return wcut_source_refuse_end(s, "the elements that are stated");
        if (q->field >= 0)
            value[q->field] = wcut_scalar_load(s->stream.data + s->stream.at, q->value, m->record.big_endian);
        s->stream.at += size;
    }
    return true;
}

/* ---- text ---- */

/* a list's count and values */
static const char *read_ply_words(wcut_source *s, const char *line, const char *p, const wcut_ply_property *q,
                                  wcut_ply_corners *corners) {
    int64_t values = 0;
    const char *behind = wcut_row_count(p, &values);
    if (!behind) return wcut_source_refuse_text(s, line, wcut_skip_blanks(p), "a list's count, 0 or more"), NULL;
    const bool kept = corners && q->is_corners;
    if (kept && values > WCUT_POLYGON_MAX) return refuse_corners(s, (double)values), NULL;
    if (kept) corners->count = (int)values;
    for (int64_t k = 0; k < values; k++) {
        double any;
        p = wcut_skip_blanks(behind);
        behind = kept ? wcut_row_count(p, &corners->vertex[k]) : wcut_row_number(p, ' ', false, &any);
        if (!behind) return wcut_source_refuse_text(s, line, p, kept ? "the number of a vertex" : "a number"), NULL;
    }
    return behind;
}

static bool read_ascii(wcut_source *s, const wcut_ply *m, const wcut_ply_element *e, double *value,
                       wcut_ply_corners *corners) {
    size_t length;
    const char *line;

    /* empty lines are no records */
    while ((line = wcut_row_peek(s, &length)) != NULL && wcut_is_line_end(wcut_skip_blanks(line)) &&
           e->properties > 0 && line[0] != '\0')
        wcut_row_done(s, length);
    const char *p = line;
    if (!line) return s->failure.status == WCUT_OK && wcut_source_refuse_end(s, "as many lines as elements are stated");

    /* the properties in their order: numbers, and lists that are skipped or are corners */
    for (const wcut_ply_property *q = m->property + e->first; q < m->property + e->first + e->properties; q++) {
        double any;
        if (q->count) {
            p = read_ply_words(s, line, p, q, corners);
            if (!p) return false;
            continue;
        }
        const char *behind = wcut_row_number(p, ' ', false, q->field >= 0 ? &value[q->field] : &any);
        if (!behind) return wcut_source_refuse_text(s, line, wcut_skip_blanks(p), "a number");
        p = behind;
    }

    /* nothing may follow in the line */
    p = wcut_skip_blanks(p);
    if (!wcut_is_line_end(p)) return wcut_source_refuse_text(s, line, p, "the end of the line");
    wcut_row_done(s, length);

    return true;
}

/* ---- either ---- */

bool wcut_ply_record(wcut_source *s, const wcut_ply *m, const wcut_ply_element *e, double *value,
                     wcut_ply_corners *corners) {
    return m->ascii ? read_ascii(s, m, e, value, corners) : read_binary(s, m, e, value, corners);
}

bool wcut_ply_skip(wcut_source *s, const wcut_ply *m, int first, int end) {
    double none[WCUT_FIELDS];
    for (const wcut_ply_element *e = m->element + first; e < m->element + end; e++) {
        const uint64_t count = (uint64_t)e->count;
        if (!m->ascii && !e->has_list) {
            if (e->size > 0 && count > UINT64_MAX / e->size)
                return wcut_source_refuse_end(s, "the elements that are stated");
            if (!wcut_stream_skip(&s->stream, count * e->size))
                return wcut_source_refuse_end(s, "the elements that are stated");
            continue;
        }
        if (e->properties == 0) continue; /* nothing stands for them, however many */
        for (uint64_t k = 0; k < count; k++)
            if (!wcut_ply_record(s, m, e, none, NULL)) return false;
    }
    return true;
}

/* from the vertex's properties to its record */
static bool lay_out_record(wcut_source *s, wcut_ply *m) {
    if (m->vertex < 0) return wcut_source_refuse(s, "found no element vertex, expected one");
    const wcut_ply_element *e = &m->element[m->vertex];

    /* where each coordinate stands in a record */
    bool has[WCUT_FIELDS] = {false};
    size_t offset = 0;
    for (const wcut_ply_property *q = m->property + e->first; q < m->property + e->first + e->properties; q++) {
        if (q->field >= 0) {
            has[q->field] = true;
            m->record.field[q->field].scalar = q->value;
            m->record.field[q->field].offset = offset;
            m->record.field[q->field].factor = 1;
        }

        /* every property takes its room, also those that are not read */
        offset += wcut_scalar_size(q->count ? q->count : q->value);
    }

    /* x, y and z are required, normals count as three */
    for (int k = 0; k < 3; k++)
        if (!has[k]) return wcut_source_refuse(s, "found no property %c of the element vertex, expected one", "xyz"[k]);
    m->record.size = e->size;
    m->record.fields = has[3] && has[4] && has[5] ? 6 : 3;

    return true;
}

bool wcut_ply_begin(wcut_source *s, wcut_ply *m) {
    if (!lay_out_record(s, m)) return false;
    s->binary = !m->ascii;
    if (!m->ascii) s->line = 0;
    const wcut_ply_element *e = &m->element[m->vertex];
    /* a value of text takes a digit and a blank or line feed, but the last one's */
    const uint64_t min = m->ascii ? 2 * (uint64_t)e->properties - 1 : e->size;
    return wcut_ply_skip(s, m, 0, m->vertex) && wcut_source_check_count(s, e->count, min, "vertices");
}
