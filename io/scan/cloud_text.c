/* XYZ, PTS, ASC, CSV: a point a line; separator, columns and normals are told from the header and the first rows. */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/row.h"
#include "io/file/unit.h"
#include "io/scan/cloud_columns.h"
#include "io/scan/cloud_source.h"

enum { HEADER_LINES_MAX = 10, SNIFF_ROWS = 50, TELLING_ROWS = 5 };

/* how the rows are made */
typedef struct text_layout {
    char separator; /* ' ' for blanks */
    bool comma;     /* numbers may have decimal commas */
    int columns;
    int column[WCUT_FIELDS];           /* where x y z nx ny nz stand, -1 where nowhere */
    signed char field[WCUT_CELLS_MAX]; /* the other way round, -1 for a column that is not wanted */
    int last;                          /* the last column wanted */
} text_layout;

/* ---- a cell of a row ---- */

/* go to the next column: behind the separator; NULL where the line ends */
static const char *next_column(const char *at, char separator) {
    at = wcut_skip_blanks(at);
    if (wcut_is_line_end(at)) return NULL;
    return at + (separator != ' ' && *at == separator);
}

/* behind the cell at `at`, quoted or not */
static const char *skip_column(const char *at, char separator) {
    at = wcut_skip_blanks(at);
    if (*at == '"') {
        for (at++; *at != '"' && !wcut_is_line_end(at); at++) {
        }
        at += *at == '"';
    }
    while (!wcut_is_line_end(at) && *at != separator && !(separator == ' ' && *at == '\t')) at++;
    return at;
}

/* the number of a cell, in quotes or not, and what is behind it; NULL: it is none */
static const char *read_cell(const char *at, char separator, bool comma, double *value) {
    at = wcut_skip_blanks(at);
    if (*at != '"') return wcut_row_number(at, separator, comma, value);
    at = wcut_row_number(at + 1, '"', comma, value);
    at = at ? wcut_skip_blanks(at) : NULL;
    return at && *at == '"' ? at + 1 : NULL;
}

static int count_columns(const char *line, char separator) {
    int columns = 0;
    for (const char *p = line; p; p = next_column(skip_column(p, separator), separator)) columns++;
    return columns;
}

/* the first numbers of a row; false: fewer are there */
static bool read_first(const char *line, const text_layout *t, int count, double *value) {
    const char *p = line;
    for (int k = 0; k < count; k++) {
        const char *behind = p ? read_cell(p, t->separator, t->comma, &value[k]) : NULL;
        if (!behind) return false;
        p = next_column(behind, t->separator);
    }
    return true;
}

/* ---- separator ---- */

/* whether commas stand within numbers: at most one in each word, digits on both sides, and at least three words */
static bool commas_are_decimal(const char *line, const char *end) {
    int words = 0, commas = 0;
    for (const char *p = line; p < end && !wcut_is_line_end(p); p++) {
        if (wcut_is_blank(*p)) {
            commas = 0;
            continue;
        }
        words += p == line || wcut_is_blank(p[-1]);
        if (*p != ',') continue;
        const bool within = p > line && p[-1] >= '0' && p[-1] <= '9' && p[1] >= '0' && p[1] <= '9';
        if (!within || ++commas > 1) return false;
    }
    return words >= 3;
}

/* commas that do not separate are decimal ones, also where the first row has none */
static void find_separator(const char *line, const char *end, text_layout *t) {
    const size_t n = (size_t)(end - line);
    t->separator = ' ';
    if (memchr(line, ';', n))
        t->separator = ';';
    else if (memchr(line, ',', n) && !commas_are_decimal(line, end))
        t->separator = ',';
    t->comma = t->separator != ',';
}

/* "1,5,2,5,3,5": three numbers with decimal commas, or six? No row of the first ones says so by a decimal point */
static bool check_commas(wcut_cloud_source *s, const char *line, const text_layout *t) {
    const char *end = (const char *)s->in.stream.data + s->in.stream.end, *p = line;
    if (t->separator != ',' || t->columns % 2 != 0 || t->columns < 6) return true;
    for (int row = 0; row < SNIFF_ROWS && p < end; row++) {
        const char *feed = memchr(p, '\n', (size_t)(end - p)), *stop = feed ? feed : end;
        if (memchr(p, '.', (size_t)(stop - p))) return true;
        p = feed ? feed + 1 : end;
    }
    return wcut_source_refuse_text(&s->in, line, line,
                                   "decimal points, semicolons between the columns, or a header with the "
                                   "columns' names: the commas could be decimal ones");
}

/* ---- columns that nobody names ---- */

/* x y z, and a normal where there are six and the first row's has length 1 */
static void assume_columns(const char *line, text_layout *t) {
    double v[WCUT_FIELDS] = {0, 0, 0, 0, 0, 0};
    for (int k = 0; k < WCUT_FIELDS; k++) t->column[k] = k < 3 ? k : -1;
    if (t->columns != 6 || !read_first(line, t, 6, v)) return;
    const double size = sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
    for (int k = 3; k < 6 && size > 0.98 && size < 1.02; k++) t->column[k] = k;
}

/* whether the first rows hold two points each, a nominal one and one that was measured: far nearer to each other than
   the rows are; or whether their first column counts them */
static const char *find_doubt(const wcut_cloud_source *s, const char *line, const text_layout *t) {
    const char *end = (const char *)s->in.stream.data + s->in.stream.end, *p = line;
    double low[3], high[3], apart = 0, first = 0;
    bool are_pairs = t->columns >= 6 && t->column[3] < 0, is_counted = t->columns >= 4;
    int rows = 0;

    /* read the first rows as pairs of points and as counted rows */
    for (; rows < SNIFF_ROWS && p < end && (are_pairs || is_counted); rows++) {
        const char *feed = memchr(p, '\n', (size_t)(end - p));
        double v[6] = {0};
        if (!feed || !read_first(p, t, are_pairs ? 6 : 3, v)) break;
        if (rows == 0) first = v[0];
        is_counted = is_counted && (first == 0 || first == 1) && v[0] == first + rows;

        /* the box of the first points, and the largest step from a point to its second */
        for (int k = 0; k < 3; k++) {
            low[k] = rows ? fmin(low[k], v[k]) : v[k], high[k] = rows ? fmax(high[k], v[k]) : v[k];
            apart = fmax(apart, fabs(v[3 + k] - v[k]));
        }
        p = feed + 1;
    }

    /* too few rows prove nothing */
    if (rows < TELLING_ROWS) return NULL;
    const double size = fmax(high[0] - low[0], fmax(high[1] - low[1], high[2] - low[2]));

    /* second points right beside the first ones; a first column that counts */
    if (are_pairs && apart <= 0.05 * size)
        return "a header: the rows seem to hold two points each; say which columns by the option columns, as 4,5,6";
    if (is_counted)
        return "a header: the first column seems to count the rows; say which columns are x, y, z by the option "
               "columns, as 2,3,4";

    return NULL;
}

/* ---- the header ---- */

/* lines before the rows: the last one of words, or a comment that names columns */
typedef struct header {
    char *text; /* of its line, zero-terminated; NULL: none yet */
    long line;
    bool is_comment;
    int words; /* lines of words so far */
} header;

static bool keep_header(wcut_cloud_source *s, const char *line, size_t length, bool is_comment, header *h) {
    char *copy = wcut_alloc(length + 1, 1);
    if (!copy) return wcut_source_refuse_memory(&s->in);
    memcpy(copy, line, length);
    wcut_free(h->text);
    h->text = copy;
    h->line = s->in.line;
    h->is_comment = is_comment;
    return true;
}

/* refuse the header, not the row that is being looked at */
static bool refuse_header(wcut_cloud_source *s, const header *h, const char *expected) {
    s->in.line = h->line;
    return wcut_source_refuse_text(&s->in, h->text, wcut_skip_blanks(h->text), expected);
}

/* the cells of the header, split as the row is, or at tabs where the row is and the header has as many cells then */
static int split_header(const header *h, const text_layout *t, wcut_cell *cell) {
    const char *from = h->text, *end = from + strlen(from);
    while (h->is_comment && from < end && (*from == '#' || *from == '/' || wcut_is_blank(*from))) from++;
    if (t->separator == ' ' && memchr(from, '\t', (size_t)(end - from))) {
        const int tabs = wcut_cells_split(from, end, '\t', cell);
        if (tabs == t->columns) return tabs;
    }
    return wcut_cells_split(from, end, t->separator, cell);
}

/* the unit of the file: its own where the caller's is the default, and the same as the caller's else */
static const char *set_unit(wcut_cloud_source *s, double unit) {
    static const char *const expected[] = {
        "millimetres, as the option unit says", "centimetres, as the option unit says",
        "metres, as the option unit says",      "inches, as the option unit says",
        "feet, as the option unit says",        "decimetres, as the option unit says",
        "micrometres, as the option unit says"};
    if (unit > 0 && s->options.unit != WCUT_LENGTH_UNIT_MM && fabs(unit / s->in.scale - 1) > 1e-9)
        return expected[s->options.unit];
    if (unit > 0) s->in.scale = unit;
    return NULL;
}

/* whether the cells that are wanted hold numbers in a row */
static bool has_numbers(const char *line, const text_layout *t, const wcut_columns *c) {
    const char *p = line;
    int found = 0;
    for (int k = 0; p && k < t->columns; k++, p = next_column(skip_column(p, t->separator), t->separator)) {
        double value;
        for (int f = 0; f < 3; f++)
            if (c->column[f] == k) found += read_cell(p, t->separator, t->comma, &value) != NULL;
    }
    return found == 3;
}

/* the columns of a row by the option, the header, or its numbers; why: what is wrong with the option or header, NULL:
   nothing. false: no memory */
static bool choose_columns(wcut_cloud_source *s, const header *h, const text_layout *t, wcut_columns *c,
                           const char **why) {
    wcut_cell *cell = wcut_alloc(WCUT_CELLS_MAX + 1, sizeof *cell);
    if (!cell) return wcut_source_refuse_memory(&s->in);
    const int names = h->text ? split_header(h, t, cell) : 0;
    *why = NULL;
    if (s->options.columns)
        *why = wcut_columns_choose(s->options.columns, t->columns, names == t->columns ? names : 0, cell, c);
    else if (h->text && names != t->columns && !(h->is_comment && !wcut_columns_named(names, cell)))
        *why = wcut_columns_find(names, cell, c) ? "columns named x, y, z: say which they are by the option columns"
                                                 : "as many names as the rows have columns";
    else if (h->text)
        *why = wcut_columns_find(names, cell, c);
    wcut_free(cell);
    return true;
}

static void lay_cloud_text_out(wcut_cloud_source *s, text_layout *t) {
    memset(t->field, -1, sizeof t->field);
    for (int k = 0; k < WCUT_FIELDS; k++) {
        const int c = t->column[k];
        if (c >= 0) t->field[c] = (signed char)k;
        if (c > t->last) t->last = c;
    }
    s->info.has_normals = t->column[3] >= 0;
}

/* how the rows are made, from the first one; is_row: it is one. false: refused */
static bool find_layout(wcut_cloud_source *s, const char *line, const char *end, bool begins_number, const header *h,
                        text_layout *t, bool *is_row) {
    wcut_columns c = {{0, 1, 2, -1, -1, -1}, 0};
    const char *why = NULL;

    /* how the row is divided, and into how many columns */
    find_separator(line, end, t);
    t->columns = count_columns(line, t->separator);
    *is_row = begins_number;

    /* a line that does not begin with a number is a row only where names or an option tell the columns */
    if (!begins_number && !h->text && !s->options.columns) return true;
    if (begins_number && t->columns > WCUT_CELLS_MAX)
        return wcut_source_refuse_text(&s->in, line, line, "at most 1000 columns");
    if (begins_number && t->columns < 3)
        return wcut_source_refuse_text(&s->in, line, line, "at least three numbers, x y z");
    if (t->columns < 3 || t->columns > WCUT_CELLS_MAX) return true;
    if (!choose_columns(s, h, t, &c, &why)) return false;

    /* a row that begins with a name is known by the numbers in the columns that are wanted */
    if (!begins_number) *is_row = !why && has_numbers(line, t, &c);
    if (!*is_row) return true;

    /* a row it is: the columns must be known */
    if (why && h->text) return refuse_header(s, h, why);
    if (why) return wcut_source_refuse_text(&s->in, line, line, why);

    /* the unit that a header stated */
    why = set_unit(s, c.unit);
    if (why) return h->text ? refuse_header(s, h, why) : wcut_source_refuse_text(&s->in, line, line, why);
    memcpy(t->column, c.column, sizeof c.column);

    /* without names and option the first columns are x y z, unless the rows look otherwise */
    if (!h->text && !s->options.columns) {
        if (!check_commas(s, line, t)) return false;
        assume_columns(line, t);
        why = find_doubt(s, line, t);
        if (why) return wcut_source_refuse_text(&s->in, line, line, why);
    }
    lay_cloud_text_out(s, t);

    return true;
}

static bool is_comment(const char *p) { return *p == '#' || (p[0] == '/' && p[1] == '/'); }

static bool begins_number(const char *p) {
    double value;
    p += *p == '"';
    if (wcut_row_number(p, ',', true, &value) || wcut_row_number(p, ';', true, &value)) return true;
    if (wcut_row_number(p, '"', true, &value)) return true;
    p += *p == '-' || *p == '+';
    return (*p >= '0' && *p <= '9') || *p == '.';
}

/* a line that is only a count; the rows will be held to it */
static bool read_lone_count(wcut_cloud_source *s, const char *p, const char *end, bool *is_count) {
    int64_t count;
    const char *behind = wcut_row_count(p, &count);

    /* a zero byte ends a line only where the file ends */
    if (behind) behind = wcut_skip_blanks(behind);
    *is_count = behind && wcut_is_line_end(behind) && (*behind != '\0' || behind == end);
    if (!*is_count) return true;

    /* of several scans in one file, the sum */
    const int64_t before = s->info.stated > 0 ? s->info.stated : 0;
    if (count <= INT32_MAX && !wcut_source_check_count(&s->in, before + count, 0, "points")) return false;
    if (!wcut_cloud_state(s, count, 0, "points")) return false;
    s->info.stated = (int)(before + count);
    return true;
}

/* ---- the rows ---- */

/* a zero byte ends a line only where the file ends */
static bool check_zero(wcut_cloud_source *s, const char *line, size_t length, const char *at) {
    return *at != '\0' || at == line + length || wcut_source_refuse_text(&s->in, line, at, "text");
}

static bool read_cloud_text_row(wcut_cloud_source *s, const text_layout *t, const char *line, size_t length,
                                double *value) {
    /* column by column; those behind the last one that is wanted are only counted */
    const char *p = line;
    for (int c = 0;; c++) {
        const int k = c <= t->last ? t->field[c] : -1;
        const char *behind = k >= 0 ? read_cell(p, t->separator, t->comma, &value[k]) : skip_column(p, t->separator);
        if (!behind) return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(p), "a number");
        behind = wcut_skip_blanks(behind);

        /* the end of the line: as many columns as in the first row */
        if (wcut_is_line_end(behind)) {
            if (!check_zero(s, line, length, behind)) return false;
            return c + 1 == t->columns ||
                   wcut_source_refuse_text(&s->in, line, behind, "as many columns as the first row has");
        }

        /* between two columns stands the separator */
        if (t->separator != ' ' && *behind != t->separator)
            return wcut_source_refuse_text(&s->in, line, behind, "the next column");
        if (c + 1 == t->columns)
            return wcut_source_refuse_text(&s->in, line, behind, "the end of the line, as in the first row");
        p = behind + (t->separator != ' ');
    }
}

static bool fill_text(wcut_cloud_source *s, wcut_batch *b) {
    const text_layout *t = s->state;

    /* until the batch is full or the file ends */
    double value[WCUT_FIELDS] = {0, 0, 0, 0, 0, 0};
    size_t length;
    while (b->count < b->capacity) {
        const char *line = wcut_row_peek(&s->in, &length);

        /* the end of the file, with as many points as it stated */
        if (!line) {
            if (s->in.failure.status != WCUT_OK) return false;
            return s->info.stated < 0 || s->left == 0 || wcut_source_refuse_truncated(&s->in, s->left, "points");
        }

        /* empty lines and comments are passed over */
        const char *p = wcut_skip_blanks(line);
        if (wcut_is_line_end(p) || is_comment(p)) {
            if (!is_comment(p) && !check_zero(s, line, length, p)) return false;
        } else {
            /* a count is that of the next scan in the file */
            bool is_count = false;
            if (s->left == 0 && !read_lone_count(s, p, line + length, &is_count)) return false;
            if (s->left == 0 && !is_count)
                return wcut_source_refuse_text(&s->in, line, p, "the end: the file states no more points");
            if (!is_count) {
                if (!read_cloud_text_row(s, t, line, length, value) || !wcut_cloud_take(s, b, value)) return false;
                s->left--;
            }
        }
        wcut_row_done(&s->in, length);
    }

    return true;
}

/* a line before the first row: a comment, which may name columns or a unit, or words */
static bool read_cloud_text_header_line(wcut_cloud_source *s, const char *line, size_t length, header *h) {
    const char *p = wcut_skip_blanks(line);
    if (wcut_is_line_end(p)) return check_zero(s, line, length, p);

    /* a unit may be told by any line */
    const double unit = wcut_unit_stated(p, length - (size_t)(p - line));
    const char *why = set_unit(s, unit);
    if (why) return wcut_source_refuse_text(&s->in, line, p, why);

    /* a line without a comment's mark: the names of columns, or words before the data */
    if (!is_comment(p)) {
        if (++h->words > HEADER_LINES_MAX)
            return wcut_source_refuse_text(&s->in, line, p, "a row that begins with numbers");
        return unit > 0 || keep_header(s, line, length, false, h);
    }

    /* a comment counts where it names the columns */
    if (h->words > 0) return true;
    wcut_cell *cell = wcut_alloc(WCUT_CELLS_MAX + 1, sizeof *cell);
    if (!cell) return wcut_source_refuse_memory(&s->in);

    /* the marks of a comment are no text */
    while (*p == '#' || *p == '/' || wcut_is_blank(*p)) p++;
    const char *end = line + length;
    bool is_named = false;
    for (int k = 0; k < 3; k++)
        is_named = is_named || wcut_columns_named(wcut_cells_split(p, end, " ,;"[k], cell), cell);

    wcut_free(cell);
    return !is_named || keep_header(s, line, length, true, h);
}

static bool read_cloud_text_header(wcut_cloud_source *s, text_layout *t, header *h) {
    size_t length;

    /* lines before the first row */
    for (const char *line; (line = wcut_row_peek(&s->in, &length)) != NULL; wcut_row_done(&s->in, length)) {
        const char *p = wcut_skip_blanks(line);
        bool is_count = false, is_row = false;
        if (!wcut_is_line_end(p) && !is_comment(p)) {
            const bool is_number = begins_number(p);
            const bool is_counted = s->info.stated >= 0;
            if (is_number && !read_lone_count(s, p, line + length, &is_count)) return false;
            if (is_count && is_counted)
                return wcut_source_refuse_text(&s->in, line, p, "a row with the numbers x y z behind the count");

            /* words before a count are a title */
            if (is_count && h->words > 0) wcut_free(h->text), h->text = NULL;
            if (!is_count && !find_layout(s, line, line + length, is_number, h, t, &is_row)) return false;
        }

        /* the first row ends the header */
        if (is_row) return true;
        if (!is_count && !read_cloud_text_header_line(s, line, length, h)) return false;
    }

    return s->in.failure.status == WCUT_OK && wcut_source_refuse_end(&s->in, "a row with the numbers x y z");
}

bool wcut_cloud_begin_text(wcut_cloud_source *s) {
    text_layout *t = wcut_alloc(1, sizeof *t);
    header h = {0};
    if (!t) return wcut_source_refuse_memory(&s->in);
    s->state = t;
    s->in.line = 1;
    s->left = INT64_MAX;
    s->fill = fill_text;
    wcut_stream *in = &s->in.stream;
    if (in->end - in->at >= 3 && memcmp(in->data + in->at, "\xef\xbb\xbf", 3) == 0) in->at += 3;
    const bool done = read_cloud_text_header(s, t, &h);
    wcut_free(h.text);
    return done;
}
