/* CSV text to columns of numbers, in one pass through a window that holds a row, after RFC 4180 with comments and four
   separators. */
#include "io/file/csv.h"

#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/decimal.h"

enum { FIRST_ROWS = 64 };

/* where the parser stands: in the row that next_row brought into the window, which ends at `end` */
typedef struct scanner {
    wcut_stream *stream;
    enum { ENDING_UNKNOWN, ENDING_FEED, ENDING_RETURN } ending; /* of lines; CR alone: of programs older than OS X */
    const char *at, *end, *line_start;
    const char *field; /* where the field begins that is being read */
    int line;          /* of `at`, from 1 */
    char separator;    /* of fields: comma, semicolon, tab, or blank for any number of blanks and tabs */
    const char *label;
    wcut_error *error;
    wcut_table *table;
    unsigned char *numeric; /* columns: whether text is refused */
    int known_count;        /* names that are used: each may stand once */
    const char *const *known;
    size_t room;   /* rows for which the table has memory */
    char *scratch; /* a field without its quotes */
    size_t scratch_size;
    wcut_csv_text *take; /* who gets fields that are text; NULL: nobody */
    void *context;
} scanner;

static wcut_status refuse_csv_memory(scanner *s) {
    char name[WCUT_QUOTE_SIZE];
    return wcut_fail(s->error, WCUT_NO_MEMORY, "%s: %s", wcut_quote(name, s->label, WCUT_LABEL_MAX, 1),
                     wcut_status_text(WCUT_NO_MEMORY));
}

/* refuse what stands at s->field: "FILE: line 7, column 12 (NAME): found X, expected Y" */
static wcut_status refuse_csv_field(scanner *s, int column, const char *found, const char *expected) {
    char label[WCUT_QUOTE_SIZE], name[WCUT_QUOTE_SIZE], shown[WCUT_QUOTE_SIZE];
    bool known = column >= 0 && column < s->table->columns && s->table->column[column].name;
    return wcut_fail(s->error, WCUT_BAD_FORMAT, "%s: line %d, column %d%s%s%s: found %s, expected %s",
                     wcut_quote(label, s->label, WCUT_LABEL_MAX, 1), s->line, (int)(s->field - s->line_start) + 1,
                     known ? " (" : "", known ? wcut_quote(name, s->table->column[column].name, WCUT_FOUND_MAX, 0) : "",
                     known ? ")" : "", wcut_quote(shown, found, WCUT_FOUND_MAX, 0), expected);
}

/* what may stand around a field and does not belong to it */
static bool is_csv_blank(const scanner *s, char c) { return c == ' ' || (c == '\t' && s->separator != '\t'); }

/* whether a field ends before this byte, be it by the separator alone */
static bool is_csv_separator(const scanner *s, char c) {
    return s->separator == ' ' ? is_csv_blank(s, c) : c == s->separator;
}

static bool at_line_end(const scanner *s) {
    return s->at == s->end || *s->at == '\n' || (*s->at == '\r' && s->at[1] == '\n');
}

/* ---- rows in the window ---- */

static const char *window_end(const scanner *s) { return (const char *)s->stream->data + s->stream->end; }

/* How lines end, from the first one: CR alone only where no line feed is in the window. Such a CR becomes a line feed. */
static void end_lines(scanner *s, unsigned char *from) {
    const wcut_stream *t = s->stream;
    unsigned char *end = t->data + t->end;
    if (s->ending == ENDING_UNKNOWN) {
        const unsigned char *carriage = memchr(from, '\r', (size_t)(end - from));
        if (memchr(from, '\n', (size_t)(end - from)))
            s->ending = ENDING_FEED;
        else if (carriage && (carriage + 1 < end || t->ended))
            s->ending = ENDING_RETURN;
    }
    if (s->ending == ENDING_RETURN)
        for (unsigned char *p = from; (p = memchr(p, '\r', (size_t)(end - p))) != NULL;) *p = '\n';
}

/* read until n bytes are unread or the file ends; pointers into the window are stale afterwards, but for s->at */
static size_t fill_window(scanner *s, size_t n) {
    wcut_stream *t = s->stream;
    const size_t before = t->end - t->at, unread = wcut_stream_fill(t, n);
    s->at = (const char *)t->data + t->at;
    end_lines(s, t->data + t->at + (s->ending == ENDING_UNKNOWN ? 0 : before));
    return unread;
}

/* what is before `behind` has been read */
static void take_bytes(scanner *s, const char *behind) {
    s->stream->at = (size_t)(behind - (const char *)s->stream->data);
    s->at = s->line_start = s->field = behind;
}

/* Behind the line feed that ends the row in [from, to), where quoted fields may hold others; NULL: it is not there.
   *quote: the opening quote of a field that is not closed there, or NULL. */
static const char *find_row_end(char separator, const char *from, const char *to, const char **quote) {
    const char *feed = memchr(from, '\n', (size_t)(to - from));
    *quote = NULL;
    if (!memchr(from, '"', (size_t)((feed ? feed : to) - from))) return feed ? feed + 1 : NULL;

    /* a quote opens a field only where one begins; another one within it follows at once, or closes it */
    bool begins = true;
    for (const char *p = from; p < to; p++) {
        if (*quote) {
            if (*p == '"' && p + 1 < to && p[1] == '"')
                p++;
            else if (*p == '"')
                *quote = NULL;
            continue;
        }
        if (*p == '\n') return p + 1;
        if (*p == '"' && begins) *quote = p;
        const bool blank = *p == ' ' || *p == '\t';
        begins = (separator ? *p == separator : *p == ',' || *p == ';') ||
                 (blank && (begins || separator == ' ' || !separator));
    }

    return NULL;
}

/* the whole row at s->at into the window; s->end is behind its line feed, or the end of the file */
static wcut_status load_row(scanner *s) {
    for (;;) {
        const char *quote = NULL;
        s->end = find_row_end(s->separator, s->at, window_end(s), &quote);
        if (s->end) return WCUT_OK;
        const size_t unread = s->stream->end - s->stream->at;
        if (s->stream->ended) break;

        /* the window is as long as a row can be */
        if (unread == s->stream->capacity) {
            char most[80];
            s->line_start = s->at;
            s->field = quote ? quote : s->at;
            snprintf(most, sizeof most, quote ? "its closing one within %zu bytes" : "at most %zu bytes", unread);
            return refuse_csv_field(s, -1, quote ? "an opening quote" : "a longer row", most);
        }
        fill_window(s, unread + 1);
        s->line_start = s->at;
    }
    s->end = window_end(s);
    return WCUT_OK;
}

/* go behind the line at s->at, however long it is */
static void skip_csv_line(scanner *s) {
    for (;;) {
        const char *feed = memchr(s->at, '\n', (size_t)(window_end(s) - s->at));
        take_bytes(s, feed ? feed + 1 : window_end(s));
        if (feed) s->line += s->line < INT_MAX;
        if (feed || fill_window(s, 1) == 0) return;
    }
}

/* behind the row that was read */
static void next_csv_line(scanner *s) {
    const char *feed = memchr(s->at, '\n', (size_t)(s->end - s->at));
    s->line += feed != NULL && s->line < INT_MAX;
    take_bytes(s, feed ? feed + 1 : s->end);
}

static wcut_status check_read(scanner *s) {
    if (!s->stream->code) return WCUT_OK;
    return wcut_fail_errno(s->error, WCUT_NOT_FOUND, s->stream->code, s->label, "cannot be read");
}

/* go to the next line that holds fields; *found: false at the end of the text */
static wcut_status next_row(scanner *s, bool *found) {
    *found = false;
    while (fill_window(s, 1) > 0) {
        s->line_start = s->field = s->at;
        if (*s->at == '#') {
            skip_csv_line(s);
            continue;
        }

        /* a row, unless it is empty */
        const wcut_status status = load_row(s);
        if (status != WCUT_OK) return status;
        const char *p = s->at;
        while (is_csv_blank(s, *p)) p++;
        s->line_start = s->field = s->at;
        *found = !(p == s->end || *p == '\n' || (*p == '\r' && p[1] == '\n'));
        if (*found) return check_read(s);
        next_csv_line(s);
    }
    s->line_start = s->field = s->at;
    return check_read(s);
}

/* ---- fields ---- */

/* Behind a field: go past the separator to the next one; false at the end of the row. Blanks that separate were passed
   with those behind the field, and such a row may end with some. */
static bool pass_separator(scanner *s) {
    if (at_line_end(s)) return false;
    if (s->separator == ' ') return s->at > s->line_start && is_csv_blank(s, s->at[-1]);
    if (*s->at != s->separator) return false;
    s->at++;
    return true;
}

/* keep one more byte of a field (and a zero behind it) */
static bool keep_byte(scanner *s, size_t used, char c) {
    if (used + 2 > s->scratch_size) {
        size_t size = 2 * s->scratch_size + 64;
        char *grown = wcut_grow(s->scratch, size);
        if (!grown) return false;
        s->scratch = grown;
        s->scratch_size = size;
    }
    s->scratch[used] = c;
    s->scratch[used + 1] = '\0';
    return true;
}

/* the field at s->at, quoted or not, without quotes and outer blanks, into s->scratch; s->at goes to its delimiter */
static wcut_status read_csv_field(scanner *s, int column) {
    size_t used = 0;
    if (!keep_byte(s, 0, '\0')) return refuse_csv_memory(s);

    /* a plain field ends at the separator or the line's end, without the blanks around it */
    while (is_csv_blank(s, *s->at)) s->at++;
    s->field = s->at;
    if (*s->at != '"') {
        for (; !at_line_end(s) && !is_csv_separator(s, *s->at); s->at++) {
            if (*s->at == '"')
                return refuse_csv_field(s, column, "a quote within a field", "quotes around the whole field");
            if (*s->at == '\0') return refuse_csv_field(s, column, "a zero byte", "text");
            if (!keep_byte(s, used++, *s->at)) return refuse_csv_memory(s);
        }

        /* blanks before the separator do not belong to the text */
        while (used > 0 && is_csv_blank(s, s->scratch[used - 1])) s->scratch[--used] = '\0';
        while (is_csv_blank(s, *s->at)) s->at++;
        return WCUT_OK;
    }

    /* a quoted field may run over lines; a doubled quote is one quote of the text */
    const char *row = s->line_start;
    int line = s->line;
    for (s->at++;; s->at++) {
        if (s->at == s->end) {
            s->line_start = row;
            s->line = line;
            return refuse_csv_field(s, column, "an opening quote", "its closing one before the end of the file");
        }
        if (*s->at == '\0') return refuse_csv_field(s, column, "a zero byte", "text");
        if (*s->at == '"' && *++s->at != '"') break;
        if (*s->at == '\n') s->line += s->line < INT_MAX, s->line_start = s->at + 1;
        if (!keep_byte(s, used++, *s->at)) return refuse_csv_memory(s);
    }

    /* only blanks may follow the closing quote */
    while (is_csv_blank(s, *s->at)) s->at++;
    if (at_line_end(s) || is_csv_separator(s, *s->at) || is_csv_separator(s, s->at[-1])) return WCUT_OK;
    s->field = s->at;

    return refuse_csv_field(s, column, "text after a closing quote", "a separator or the end of the line");
}

static bool equal_word(const char *text, const char *word) {
    for (; *text && *word; text++, word++)
        if ((*text | 0x20) != *word) return false;
    return *text == *word;
}

/* a number with one comma and no point, "0,5" */
static bool read_decimal_comma(const char *text, double *value) {
    char point[64];
    const char *comma = strchr(text, ',');
    if (!comma || strchr(text, '.') || strchr(comma + 1, ',') || strlen(text) >= sizeof point) return false;
    memcpy(point, text, strlen(text) + 1);
    point[comma - text] = '.';
    double read;
    if (*wcut_decimal_read(point, &read) != '\0' || !isfinite(read)) return false;
    *value = read;
    return true;
}

/* a sample that is not there */
static wcut_status miss_sample(scanner *s, int column, int row) {
    wcut_column *c = &s->table->column[column];
    if (!c->present) {
        c->present = wcut_alloc(s->room, 1);
        if (!c->present) return refuse_csv_memory(s);
        memset(c->present, 1, s->room);
    }
    c->present[row] = 0;
    c->value[row] = 0;
    c->missing++;
    return WCUT_OK;
}

/* a field that is no plain number: quoted, empty, nan, or text */
static wcut_status read_odd_sample(scanner *s, int column, int row) {
    wcut_status status = read_csv_field(s, column);
    if (status != WCUT_OK) return status;
    double *value = &s->table->column[column].value[row];
    const char *behind = wcut_decimal_read(s->scratch, value);
    if (behind > s->scratch && *behind == '\0' && isfinite(*value)) return WCUT_OK;

    /* where no commas separate, a number may have a decimal comma */
    double comma;
    const bool decimal_comma = read_decimal_comma(s->scratch, &comma);
    if (decimal_comma && s->separator != ',') return *value = comma, WCUT_OK;

    /* nothing, or text */
    bool absent = s->scratch[0] == '\0' || equal_word(s->scratch, "nan");
    if (absent || !s->numeric[column]) {
        s->table->column[column].text += !absent;
        if (!absent && s->take && !s->take(s->context, row, column, s->scratch)) return refuse_csv_memory(s);
        return miss_sample(s, column, row);
    }
    if (decimal_comma) return refuse_csv_field(s, column, s->scratch, "a decimal point, not a decimal comma");
    if (behind > s->scratch && *behind == '\0')
        return refuse_csv_field(s, column, s->scratch, "a number a double can hold");
    return refuse_csv_field(s, column, s->scratch, "a number, nan or an empty field");
}

/* the common case, a bare number and its separator or line end, goes straight to its place */
static wcut_status read_sample(scanner *s, int column, int row) {
    const char *start = s->at;
    while (is_csv_blank(s, *s->at)) s->at++;
    s->field = s->at;
    double *value = &s->table->column[column].value[row];
    const char *behind = wcut_decimal_read(s->at, value);
    if (behind > s->at && isfinite(*value)) {
        const bool ends = is_csv_separator(s, *behind) || is_csv_blank(s, *behind);
        s->at = behind;
        while (is_csv_blank(s, *s->at)) s->at++;
        if ((s->separator == ' ' && ends) || *s->at == s->separator || at_line_end(s)) return WCUT_OK;
    }
    s->at = start;
    return read_odd_sample(s, column, row);
}

static wcut_status read_csv_row(scanner *s, int row) {
    s->table->line[row] = s->line;
    for (int c = 0; c < s->table->columns; c++) {
        wcut_status status = read_sample(s, c, row);
        if (status != WCUT_OK) return status;
        if (c + 1 < s->table->columns && !pass_separator(s)) {
            s->field = s->at;
            return refuse_csv_field(s, c + 1, "the end of the row", "as many fields as the header has");
        }
    }
    s->field = s->at;
    if (!at_line_end(s))
        return refuse_csv_field(s, -1, "more fields than the header has",
                                "as many (numbers have a decimal point, not a decimal comma)");
    next_csv_line(s);
    return WCUT_OK;
}

/* whether a column of this name stands before and is used; the others are kept, and nobody asks which one is meant */
static bool is_ambiguous(const scanner *s, int c) {
    bool twice = false, used = false;
    for (int k = 0; k < c; k++) twice = twice || strcmp(s->table->column[k].name, s->scratch) == 0;
    for (int k = 0; k < s->known_count; k++) used = used || strcmp(s->known[k], s->scratch) == 0;
    return twice && used;
}

/* whether a byte stands in the header's line outside quotes */
static bool header_has(const scanner *s, char byte) {
    bool quoted = false;
    for (const char *p = s->at; p < s->end && *p != '\n'; p++) {
        if (*p == '"') quoted = !quoted;
        if (*p == byte && !quoted) return true;
    }
    return false;
}

/* whether blanks separate: in the header and in the row below too, because a single name may have one */
static bool blanks_separate(const scanner *s) {
    const char *row = memchr(s->at, '\n', (size_t)(s->end - s->at));
    if (!row || !header_has(s, ' ')) return false;

    /* the row below: a number, blanks, and something else */
    double value;
    while (row < window_end(s) && (*row == ' ' || *row == '\t' || *row == '\n')) row++;
    const char *behind = wcut_decimal_read(row, &value), *next = behind;
    while (*next == ' ') next++;
    return behind > row && next > behind && next < window_end(s) && *next != '\n' && *next != '\r';
}

/* what separates the names of the header, and every field below: semicolons before commas, because numbers may have
   decimal commas between them */
static char find_csv_separator(const scanner *s) {
    return header_has(s, ';')    ? ';'
           : header_has(s, ',')  ? ','
           : header_has(s, '\t') ? '\t'
           : blanks_separate(s)  ? ' '
                                 : ',';
}

/* a name of the header into its column; the index of a table program has none, and is kept as a further column */
static wcut_status name_column(scanner *s, int c) {
    if (is_ambiguous(s, c)) return refuse_csv_field(s, -1, s->scratch, "every column that is used named once");
    s->table->column[c].name = s->scratch; /* the scratch buffer becomes the name: the next field gets its own */
    s->scratch = NULL;
    s->scratch_size = 0;
    s->table->columns = c + 1;
    return WCUT_OK;
}

static wcut_status read_csv_header(scanner *s) {
    /* the first row that is no comment */
    bool found;
    const wcut_status begun = next_row(s, &found);
    if (begun != WCUT_OK) return begun;
    if (!found) return refuse_csv_field(s, -1, "no header", "a row with the names of the columns");

    s->separator = find_csv_separator(s);

    /* names up to the end of the row */
    s->table->column = wcut_alloc(WCUT_CSV_COLUMNS_MAX, sizeof *s->table->column);
    if (!s->table->column) return refuse_csv_memory(s);
    for (int c = 0;; c++) {
        if (c == WCUT_CSV_COLUMNS_MAX) return refuse_csv_field(s, -1, "more than 1000 columns", "at most that");
        wcut_status status = read_csv_field(s, -1);
        if (status == WCUT_OK) status = name_column(s, c);
        if (status != WCUT_OK) return status;
        if (!pass_separator(s)) break;
    }

    /* a row of numbers is no header */
    double first;
    const char *name = s->table->column[0].name;
    if (name[0] && *wcut_decimal_read(name, &first) == '\0')
        return refuse_csv_field(s, -1, name, "the names of the columns before numbers");
    next_csv_line(s);

    return WCUT_OK;
}

/* memory for twice as many rows */
static wcut_status grow_rows(scanner *s) {
    wcut_table *t = s->table;
    const size_t room = s->room ? 2 * s->room : FIRST_ROWS;
    int *line = wcut_grow(t->line, room * sizeof *line);
    if (!line) return refuse_csv_memory(s);
    t->line = line;

    /* every column; where some were missing, those to come are there */
    for (int c = 0; c < t->columns; c++) {
        wcut_column *column = &t->column[c];
        double *value = wcut_grow(column->value, room * sizeof *value);
        if (!value) return refuse_csv_memory(s);
        column->value = value;
        if (!column->present) continue;
        unsigned char *present = wcut_grow(column->present, room);
        if (!present) return refuse_csv_memory(s);
        column->present = present;
        memset(present + s->room, 1, room - s->room);
    }
    s->room = room;
    return WCUT_OK;
}

static wcut_status make_columns(scanner *s, int numeric_count, const char *const *numeric) {
    wcut_table *t = s->table;
    s->numeric = wcut_alloc((size_t)t->columns, 1);
    if (!s->numeric) return refuse_csv_memory(s);
    for (int c = 0; c < t->columns; c++)
        for (int k = 0; k < numeric_count; k++)
            if (strcmp(t->column[c].name, numeric[k]) == 0) s->numeric[c] = 1;
    return grow_rows(s);
}

static wcut_status read_csv_rows(scanner *s) {
    size_t rows = 0;
    const size_t max = WCUT_CSV_VALUES_MAX / (size_t)s->table->columns;
    for (;;) {
        bool found;
        wcut_status status = next_row(s, &found);
        if (status == WCUT_OK && found && rows == max) {
            char most[80];
            snprintf(most, sizeof most, "at most %zu of as many columns", max);
            return refuse_csv_field(s, -1, "more rows", most);
        }
        if (status == WCUT_OK && found && rows == s->room) status = grow_rows(s);
        if (status == WCUT_OK && found) status = read_csv_row(s, (int)rows++);
        if (status != WCUT_OK) return status;
        if (!found) break;
    }
    s->table->rows = (int)rows;
    return WCUT_OK;
}

/* what the first bytes say of the whole text */
static wcut_status begin_text(scanner *s) {
    const size_t length = fill_window(s, s->stream->capacity);
    s->line_start = s->field = s->at;

    /* another encoding is refused, not read as garbage */
    if (length >= 2 && (memcmp(s->at, "\xff\xfe", 2) == 0 || memcmp(s->at, "\xfe\xff", 2) == 0))
        return refuse_csv_field(s, -1, "UTF-16", "UTF-8");

    /* a byte order mark of UTF-8 is passed over */
    if (length >= 3 && memcmp(s->at, "\xef\xbb\xbf", 3) == 0) take_bytes(s, s->at + 3);

    return WCUT_OK;
}

/* the stream from its first byte to its last; a table or an error */
static wcut_status scan_csv(scanner *s, wcut_table **table) {
    s->line = 1;
    s->table = wcut_alloc(1, sizeof *s->table);
    if (!s->table) return refuse_csv_memory(s);

    /* header, columns, rows */
    wcut_status status = begin_text(s);
    if (status == WCUT_OK) status = read_csv_header(s);
    if (status == WCUT_OK) status = make_columns(s, s->known_count, s->known);
    if (status == WCUT_OK) status = read_csv_rows(s);

    /* the scanner's own memory */
    free(s->numeric);
    free(s->scratch);
    if (status == WCUT_OK)
        *table = s->table;
    else
        wcut_table_destroy(s->table);

    return status;
}

wcut_status wcut_csv_read(wcut_stream *stream, const char *label, int numeric_count, const char *const *numeric,
                          wcut_table **table, wcut_error *error) {
    scanner s = {.stream = stream, .label = label, .error = error};
    s.known = numeric;
    s.known_count = numeric_count;
    return scan_csv(&s, table);
}

/* a text in memory as a stream */
static wcut_status scan_text(scanner *s, const char *text, size_t length, size_t window, wcut_table **table) {
    /* a short text needs no long window */
    wcut_stream stream;
    if (length < window) window = length + 1;
    if (wcut_stream_open_memory(text, length, window, &stream) != WCUT_OK) return refuse_csv_memory(s);
    s->stream = &stream;
    const wcut_status status = scan_csv(s, table);
    s->stream = NULL;
    wcut_stream_close(&stream);
    return status;
}

wcut_status wcut_csv_parse(const char *text, size_t length, size_t window, const char *label, int numeric_count,
                           const char *const *numeric, wcut_table **table, wcut_error *error) {
    scanner s = {.label = label, .error = error, .known = numeric, .known_count = numeric_count};
    return scan_text(&s, text, length, window, table);
}

wcut_status wcut_csv_parse_texts(const char *text, size_t length, const char *label, wcut_csv_text *take, void *context,
                                 wcut_table **table, wcut_error *error) {
    scanner s = {.label = label, .error = error, .take = take, .context = context};
    return scan_text(&s, text, length, WCUT_STREAM_WINDOW, table);
}
