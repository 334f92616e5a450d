/* PCD 0.7 (Point Cloud Library): a header of lines, then rows of text or binary records. */
#include <stdlib.h>
#include <string.h>

#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/lzf.h"
#include "io/file/row.h"
#include "io/scan/cloud_source.h"

enum { FIELDS_MAX = 256, COUNT_MAX = 4096 };

/* the header as it is read; line k of the array was seen */
typedef struct pcd_header {
    int fields, columns;
    int kind[FIELDS_MAX]; /* x y z nx ny nz as 0 .. 5, or -1 */
    int size[FIELDS_MAX], count[FIELDS_MAX];
    char type[FIELDS_MAX];
    int64_t width, height, points;
    bool seen[8];
} pcd_header;

typedef struct pcd_rows {
    wcut_record record; /* the state begins with it: wcut_cloud_fill_records reads it */
    int columns;        /* of text */
    int *field;         /* columns: which one each is, or -1; behind the struct */
    /* of compressed data: field by field, behind the columns */
    int64_t points;
    size_t raw;
} pcd_rows;

enum { FIELDS_LINE, SIZE_LINE, TYPE_LINE, COUNT_LINE, WIDTH_LINE, HEIGHT_LINE, POINTS_LINE, DATA_LINE, LINES };
static const char *const keyword[LINES] = {"FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "POINTS", "DATA"};

static const char *word_end(const char *p) {
    while (!wcut_is_blank(*p) && !wcut_is_line_end(p)) p++;
    return p;
}

static bool read_fields(wcut_cloud_source *s, const char *line, const char *p, pcd_header *h) {
    static const char *const name[] = {"x", "y", "z", "normal_x", "normal_y", "normal_z"};
    for (p = wcut_skip_blanks(p); !wcut_is_line_end(p); p = wcut_skip_blanks(word_end(p))) {
        if (h->fields == FIELDS_MAX) return wcut_source_refuse_text(&s->in, line, p, "at most 256 fields");
        h->kind[h->fields] = -1;
        h->count[h->fields] = 1;
        for (int k = 0; k < WCUT_FIELDS; k++)
            if (wcut_row_has_word(p, name[k])) h->kind[h->fields] = k;
        for (int k = 0; k < h->fields; k++)
            if (h->kind[h->fields] >= 0 && h->kind[k] == h->kind[h->fields])
                return wcut_source_refuse_text(&s->in, line, p, "each field once");
        h->fields++;
    }
    return true;
}

/* SIZE or COUNT: an integer a field */
static bool read_integers(wcut_cloud_source *s, const char *line, const char *p, int fields, int max, int *value) {
    for (int k = 0; k < fields; k++) {
        int64_t n;
        const char *behind = wcut_row_count(p, &n);
        if (!behind || n < 1 || n > max)
            return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(p),
                                           "a positive integer for each of the FIELDS");
        value[k] = (int)n;
        p = wcut_skip_blanks(behind);
    }
    return wcut_is_line_end(p) || wcut_source_refuse_text(&s->in, line, p, "as many as there are FIELDS");
}

static bool read_types(wcut_cloud_source *s, const char *line, const char *p, pcd_header *h) {
    for (int k = 0; k < h->fields; k++) {
        p = wcut_skip_blanks(p);
        if (word_end(p) != p + 1 || !strchr("IUF", *p)) return wcut_source_refuse_text(&s->in, line, p, "I, U or F");
        h->type[k] = *p++;
    }
    p = wcut_skip_blanks(p);
    return wcut_is_line_end(p) || wcut_source_refuse_text(&s->in, line, p, "as many as there are FIELDS");
}

static bool read_one(wcut_cloud_source *s, const char *line, const char *p, int64_t *value) {
    const char *behind = wcut_row_count(p, value);
    if (behind && wcut_is_line_end(wcut_skip_blanks(behind))) return true;
    return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(p), "a count, an integer that is not negative");
}

/* one line of the header; `which` is the keyword's number, or LINES for a line that says nothing */
static bool read_header_line(wcut_cloud_source *s, const char *line, pcd_header *h, int *which, const char **rest) {
    const char *p = wcut_skip_blanks(line);

    /* comments, VERSION and VIEWPOINT change nothing here */
    *which = LINES;
    if (*p == '#' || wcut_is_line_end(p) || wcut_row_has_word(p, "VERSION") || wcut_row_has_word(p, "VIEWPOINT"))
        return true;

    /* the other keywords stand once each, FIELDS first */
    for (int k = 0; k < LINES; k++)
        if (wcut_row_has_word(p, keyword[k])) *which = k;
    if (wcut_row_has_word(p, "COLUMNS")) *which = FIELDS_LINE; /* of the first versions */
    if (*which == LINES) return wcut_source_refuse_text(&s->in, line, p, "a keyword of a PCD header");
    if (h->seen[*which]) return wcut_source_refuse_text(&s->in, line, p, "each keyword once");
    if (*which != FIELDS_LINE && !h->seen[FIELDS_LINE])
        return wcut_source_refuse_text(&s->in, line, p, "FIELDS before it");
    h->seen[*which] = true;
    *rest = wcut_skip_blanks(word_end(p));

    /* each keyword has a reader of its own */
    switch (*which) {
        case FIELDS_LINE:
            return read_fields(s, line, *rest, h);
        case SIZE_LINE:
            return read_integers(s, line, *rest, h->fields, 8, h->size);
        case TYPE_LINE:
            return read_types(s, line, *rest, h);
        case COUNT_LINE:
            return read_integers(s, line, *rest, h->fields, COUNT_MAX, h->count);
        case WIDTH_LINE:
            return read_one(s, line, *rest, &h->width);
        case HEIGHT_LINE:
            return read_one(s, line, *rest, &h->height);
        case POINTS_LINE:
            return read_one(s, line, *rest, &h->points);
        default:
            return true;
    }
}

/* ---- from the header to the layout ---- */

static wcut_scalar find_scalar(char type, int size) {
    static const wcut_scalar integer[] = {0, WCUT_SCALAR_I8, WCUT_SCALAR_I16, 0, WCUT_SCALAR_I32, 0, 0,
                                          0, WCUT_SCALAR_I64};
    static const wcut_scalar natural[] = {0, WCUT_SCALAR_U8, WCUT_SCALAR_U16, 0, WCUT_SCALAR_U32, 0, 0,
                                          0, WCUT_SCALAR_U64};
    if (type == 'F') return size == 4 ? WCUT_SCALAR_F32 : size == 8 ? WCUT_SCALAR_F64 : WCUT_SCALAR_NONE;
    return type == 'I' ? integer[size] : natural[size];
}

static bool check_header(wcut_cloud_source *s, const char *line, const pcd_header *h) {
    /* keywords that the rows cannot be read without */
    static const int required[] = {FIELDS_LINE, SIZE_LINE, TYPE_LINE, WIDTH_LINE};
    int found = 0;
    for (size_t k = 0; k < sizeof required / sizeof *required; k++)
        if (!h->seen[required[k]])
            return wcut_source_refuse(&s->in, "found DATA, expected %s before it", keyword[required[k]]);

    /* every field must have a type and a size that the reader knows; a coordinate stands once */
    for (int k = 0; k < h->fields; k++) {
        if (h->kind[k] >= 0 && h->kind[k] < 3) found++;
        if (find_scalar(h->type[k], h->size[k]) == WCUT_SCALAR_NONE)
            return wcut_source_refuse(&s->in,
                                      "found a field of type %c and size %d, expected F 4, F 8, I or U of 1, 2, 4, 8",
                                      h->type[k], h->size[k]);
        if (h->kind[k] >= 0 && h->count[k] != 1)
            return wcut_source_refuse(&s->in, "found a coordinate of COUNT %d, expected 1", h->count[k]);
    }
    if (found != 3) return wcut_source_refuse_text(&s->in, line, line, "the FIELDS x y z before it");
    /* both are digits below 2^63 / 10: compare without a product that overflows */
    if (h->seen[POINTS_LINE] && h->points != 0 &&
        (h->height == 0 || h->points % h->height != 0 || h->points / h->height != h->width))
        return wcut_source_refuse(&s->in, "found POINTS %lld, expected WIDTH x HEIGHT, %lld x %lld",
                                  (long long)h->points, (long long)h->width, (long long)h->height);

    return true;
}

/* the points: POINTS, or WIDTH x HEIGHT */
static int64_t count_points(const pcd_header *h) {
    if (h->seen[POINTS_LINE]) return h->points;
    const int64_t height = h->seen[HEIGHT_LINE] ? h->height : 1;
    return height > 0 && h->width > INT64_MAX / height ? INT64_MAX : h->width * height;
}

static pcd_rows *make_pcd_rows(const pcd_header *h) {
    /* room for the state and for the field of every column behind it */
    int columns = 0;
    for (int k = 0; k < h->fields; k++) columns += h->count[k];
    pcd_rows *r = wcut_alloc(1, sizeof *r + (size_t)columns * sizeof *r->field);
    if (!r) return NULL;
    r->field = (int *)(r + 1);
    bool normal[3] = {false, false, false};
    for (int k = 0; k < h->fields; k++) {
        /* columns of one field belong together; where a coordinate stands in a binary record */
        for (int c = 0; c < h->count[k]; c++) r->field[r->columns++] = h->kind[k];
        if (h->kind[k] >= 3) normal[h->kind[k] - 3] = true;
        if (h->kind[k] >= 0) {
            r->record.field[h->kind[k]].scalar = find_scalar(h->type[k], h->size[k]);
            r->record.field[h->kind[k]].offset = r->record.size;
            r->record.field[h->kind[k]].factor = 1;
        }
        r->record.size += (size_t)h->size[k] * (size_t)h->count[k];
    }

    /* normals count where all three components are there */
    r->record.fields = normal[0] && normal[1] && normal[2] ? 6 : 3;

    return r;
}

/* ---- the data ---- */

static bool fill_pcd_text(wcut_cloud_source *s, wcut_batch *b) {
    const pcd_rows *r = s->state;
    double value[WCUT_FIELDS] = {0};
    size_t length;

    /* a row for each point */
    for (; s->left > 0 && b->count < b->capacity; s->left--) {
        const char *line = wcut_row_peek(&s->in, &length), *p = line;
        if (!line)
            return s->in.failure.status == WCUT_OK ? wcut_source_refuse_truncated(&s->in, s->left, "points") : false;

        /* every column is a number; those that are no coordinates are passed over */
        for (int c = 0; c < r->columns; c++) {
            double any;
            const char *behind = wcut_row_number(p, ' ', false, r->field[c] >= 0 ? &value[r->field[c]] : &any);
            if (!behind) return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(p), "a number");
            p = wcut_skip_blanks(behind);
        }
        if (!wcut_is_line_end(p)) return wcut_source_refuse_text(&s->in, line, p, "the end of the line");
        if (!wcut_cloud_take(s, b, value)) return false;
        wcut_row_done(&s->in, length);
    }

    /* the rows are read: nothing but the end may follow */
    return s->left > 0 || wcut_source_check_end(&s->in, ((const pcd_rows *)s->state)->record.size);
}

static bool fill_binary(wcut_cloud_source *s, wcut_batch *b) {
    return wcut_cloud_fill_records(s, b) &&
           (s->left > 0 || wcut_source_check_end(&s->in, ((const pcd_rows *)s->state)->record.size));
}

/* ---- compressed: the bytes of all points field by field, as one block of LZF ---- */

static bool fill_compressed(wcut_cloud_source *s, wcut_batch *b) {
    const pcd_rows *r = s->state;
    const unsigned char *raw = (const unsigned char *)s->state + r->raw;
    for (; s->left > 0 && b->count < b->capacity; s->left--) {
        const size_t i = (size_t)(r->points - s->left), n = (size_t)r->points;
        double value[WCUT_FIELDS] = {0};
        for (int k = 0; k < r->record.fields; k++) {
            const wcut_scalar scalar = r->record.field[k].scalar;
            value[k] =
                wcut_scalar_load(raw + r->record.field[k].offset * n + i * wcut_scalar_size(scalar), scalar, false);
        }
        if (!wcut_cloud_take(s, b, value)) return false;
    }
    return true;
}

/* the next `size` bytes of the file; NULL: refused */
static unsigned char *read_bytes(wcut_cloud_source *s, size_t size) {
    unsigned char *bytes = wcut_alloc(size, 1);
    if (!bytes) return wcut_source_refuse_memory(&s->in), NULL;
    for (size_t used = 0; used < size;) {
        const size_t got = wcut_stream_fill(&s->in.stream, 1), n = got < size - used ? got : size - used;
        if (got == 0) {
            wcut_source_refuse_end(&s->in, "the compressed points");
            wcut_free(bytes);
            return NULL;
        }
        memcpy(bytes + used, s->in.stream.data + s->in.stream.at, n);
        s->in.stream.at += n;
        used += n;
    }
    return bytes;
}

/* the block behind the header: two sizes, then LZF; into memory behind the state */
static bool read_compressed(wcut_cloud_source *s, int64_t points) {
    const uint64_t max = (uint64_t)1 << 31;
    pcd_rows *r = s->state;
    const size_t head = sizeof *r + (size_t)r->columns * sizeof *r->field;

    /* two sizes of 32 bits: packed and unpacked */
    if (wcut_stream_fill(&s->in.stream, 8) < 8) return wcut_source_refuse_end(&s->in, "the sizes of compressed points");
    const unsigned char *at = s->in.stream.data + s->in.stream.at;
    const uint64_t packed = wcut_load_32(at, false), plain = wcut_load_32(at + 4, false);
    const uint64_t wanted = (uint64_t)points * r->record.size;

    /* the unpacked size must be that of the points, and no more than LZF can pack */
    if (points > INT32_MAX || plain != wanted || plain > max || plain > packed * WCUT_LZF_RATIO_MAX)
        return wcut_source_refuse(&s->in, "found %llu bytes compressed to %llu, expected %llu for the points stated",
                                  (unsigned long long)plain, (unsigned long long)packed, (unsigned long long)wanted);
    if (packed > wcut_stream_left(&s->in.stream)) return wcut_source_refuse_end(&s->in, "the compressed points");

    /* the packed bytes */
    s->in.stream.at += 8;
    unsigned char *bytes = read_bytes(s, (size_t)packed);
    if (!bytes) return false;

    /* the state grows: what points into it follows */
    pcd_rows *grown = wcut_grow(r, head + (size_t)plain);
    bool done = grown || wcut_source_refuse_memory(&s->in);
    if (grown) {
        s->state = grown;
        grown->field = (int *)(grown + 1);
        grown->raw = head;
        grown->points = points;
        done = wcut_lzf_read(bytes, (size_t)packed, (unsigned char *)s->state + head, (size_t)plain) ||
               wcut_source_refuse(&s->in, "found compressed points that do not unpack, expected LZF");
    }

    wcut_free(bytes);
    return done && wcut_cloud_state(s, points, 0, "points") && wcut_source_check_end(&s->in, 0);
}

static bool begin_data(wcut_cloud_source *s, const char *line, const char *how, size_t length, const pcd_header *h) {
    const bool packed = wcut_row_has_word(how, "binary_compressed"),
               binary = packed || wcut_row_has_word(how, "binary");
    if (!binary && !wcut_row_has_word(how, "ascii"))
        return wcut_source_refuse_text(&s->in, line, how, "ascii, binary or binary_compressed");
    if (!check_header(s, line, h)) return false;
    pcd_rows *r = make_pcd_rows(h);
    if (!r) return wcut_source_refuse_memory(&s->in);
    s->state = r;
    s->info.has_normals = r->record.fields == 6;
    s->fill = packed ? fill_compressed : binary ? fill_binary : fill_pcd_text;
    wcut_row_done(&s->in, length);
    if (binary) s->in.line = 0, s->in.binary = true;
    if (packed) return read_compressed(s, count_points(h));
    return wcut_cloud_state(s, count_points(h), binary ? r->record.size : 2 * (uint64_t)r->columns - 1, "points");
}

static bool read_pcd_header(wcut_cloud_source *s, pcd_header *h) {
    size_t length;
    for (const char *line; (line = wcut_row_peek(&s->in, &length)) != NULL; wcut_row_done(&s->in, length)) {
        int which;
        const char *rest = line;
        if (!read_header_line(s, line, h, &which, &rest)) return false;
        if (which == DATA_LINE) return begin_data(s, line, rest, length, h);
    }
    return s->in.failure.status == WCUT_OK && wcut_source_refuse_end(&s->in, "DATA");
}

bool wcut_cloud_begin_pcd(wcut_cloud_source *s) {
    pcd_header *h = wcut_alloc(1, sizeof *h);
    if (!h) return wcut_source_refuse_memory(&s->in);
    h->height = 1;
    s->in.line = 1;
    const bool read = read_pcd_header(s, h);
    free(h);
    return read;
}
