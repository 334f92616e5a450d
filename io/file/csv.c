/* CSV text in memory to columns of numbers, in one pass, after RFC 4180 with comments and four separators. */
#include "io/file/csv.h"

#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/decimal.h"

/* where the parser stands; the text ends with a zero byte at `end` */
typedef struct scanner {
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

static void next_csv_line(scanner *s) {
    const char *feed = memchr(s->at, '\n', (size_t)(s->end - s->at));
    s->at = feed ? feed + 1 : s->end;
    s->line += feed != NULL && s->line < INT_MAX;
    s->line_start = s->at;
}

/* go to the next line that holds fields; false at the end of the text */
static bool next_row(scanner *s) {
    while (s->at < s->end) {
        const char *p = s->at;
        if (*p != '#') {
            while (is_csv_blank(s, *p)) p++;
            bool empty = p == s->end || *p == '\n' || (*p == '\r' && p[1] == '\n');
            if (!empty) return true;
        }
        next_csv_line(s);
    }
    return false;
}

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
        c->present = wcut_alloc((size_t)s->table->rows, 1); /* rows is still the most there can be */
        if (!c->present) return refuse_csv_memory(s);
        memset(c->present, 1, (size_t)s->table->rows);
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
    while (row < s->end && (*row == ' ' || *row == '\t' || *row == '\n')) row++;
    const char *behind = wcut_decimal_read(row, &value), *next = behind;
    while (*next == ' ') next++;
    return behind > row && next > behind && next < s->end && *next != '\n' && *next != '\r';
}

/* what separates the names of the header, and every field below: semicolons before commas, because numbers may have
   decimal commas between them */
static char find_separator(const scanner *s) {
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
    s->field = s->at;
    if (!next_row(s))
        return s->field = s->at, refuse_csv_field(s, -1, "no header", "a row with the names of the columns");

    s->separator = find_separator(s);

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

/* the most rows that the rest of the text can hold: a row has a line feed, and a byte a field */
static int count_rows(const scanner *s) {
    size_t feeds = 1, max = (size_t)(s->end - s->at) / (size_t)s->table->columns + 1;
    for (const char *p = s->at; (p = memchr(p, '\n', (size_t)(s->end - p))) != NULL; p++) feeds++;
    size_t rows = feeds < max ? feeds : max;
    return rows < INT_MAX ? (int)rows : INT_MAX;
}

static wcut_status make_columns(scanner *s, int numeric_count, const char *const *numeric) {
    wcut_table *t = s->table;
    t->rows = count_rows(s);
    t->line = wcut_alloc((size_t)t->rows, sizeof *t->line);
    s->numeric = wcut_alloc((size_t)t->columns, 1);
    if (!t->line || !s->numeric) return refuse_csv_memory(s);
    for (int c = 0; c < t->columns; c++) {
        t->column[c].value = wcut_alloc((size_t)t->rows, sizeof(double));
        if (!t->column[c].value) return refuse_csv_memory(s);
        for (int k = 0; k < numeric_count; k++)
            if (strcmp(t->column[c].name, numeric[k]) == 0) s->numeric[c] = 1;
    }
    return WCUT_OK;
}

static wcut_status read_csv_rows(scanner *s) {
    int rows = 0;
    while (next_row(s)) {
        s->field = s->at;
        if (rows == s->table->rows) return refuse_csv_field(s, -1, "too many rows", "at most 2147483647");
        wcut_status status = read_csv_row(s, rows++);
        if (status != WCUT_OK) return status;
    }
    s->table->rows = rows;
    return WCUT_OK;
}

/* the text from its first byte to its last; a table or an error */
static wcut_status scan_csv(scanner *s, wcut_table **table) {
    const char *text = s->at;
    const size_t length = (size_t)(s->end - text);
    s->line = 1;
    s->separator = ',';
    s->table = wcut_alloc(1, sizeof *s->table);
    if (!s->table) return refuse_csv_memory(s);

    /* a byte order mark of UTF-8 is passed over */
    if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) s->at += 3;
    s->line_start = s->field = s->at;

    /* another encoding is refused, not read as garbage */
    wcut_status status = WCUT_OK;
    if (length >= 2 && (memcmp(text, "\xff\xfe", 2) == 0 || memcmp(text, "\xfe\xff", 2) == 0))
        status = refuse_csv_field(s, -1, "UTF-16", "UTF-8");

    /* header, columns, rows */
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

wcut_status wcut_csv_parse(const char *text, size_t length, const char *label, int numeric_count,
                           const char *const *numeric, wcut_table **table, wcut_error *error) {
    scanner s = {.at = text, .end = text + length, .label = label, .error = error};
    s.known = numeric;
    s.known_count = numeric_count;
    return scan_csv(&s, table);
}

wcut_status wcut_csv_parse_texts(const char *text, size_t length, const char *label, wcut_csv_text *take, void *context,
                                 wcut_table **table, wcut_error *error) {
    scanner s = {.at = text, .end = text + length, .label = label, .error = error, .take = take, .context = context};
    return scan_csv(&s, table);
}
