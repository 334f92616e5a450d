/* XYZ, PTS, ASC, CSV: a point a line; separator, columns and normals are told from the header and the first rows. */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/row.h"
#include "io/scan/cloud_source.h"

enum { HEADER_LINES_MAX = 10, COLUMNS_MAX = 1000, SNIFF_ROWS = 50 };

/* how the rows are made */
typedef struct text_layout {
    char separator; /* ' ' for blanks */
    bool comma;     /* numbers may have decimal commas */
    int columns;
    int column[WCUT_FIELDS]; /* where x y z nx ny nz stand, -1 where nowhere */
    int field[16];           /* the other way round, -1 for a column that is not wanted; columns below 16 */
    int last;                /* the last column wanted */
} text_layout;

/* ---- the header: names ---- */

/* "nx_mm" -> field 3; unit is what stands behind the name, "mm", or "" */
static int find_field(const char *word, size_t n, char unit[8]) {
    static const char *const name[] = {"x",        "y",        "z",        "nx",  "ny", "nz",
                                       "normal_x", "normal_y", "normal_z", "//x", "#x", "\"x"};
    static const int field[] = {0, 1, 2, 3, 4, 5, 3, 4, 5, 0, 0, 0};
    unit[0] = '\0';
    for (size_t k = 0; k < sizeof name / sizeof *name; k++) {
        const size_t m = strlen(name[k]);
        if (n < m || strncasecmp(word, name[k], m) != 0) continue;
        if (n > m && !strchr("_([", word[m])) continue;
        size_t length = n > m ? n - m - 1 : 0;
        if (length > 0 && strchr(")]", word[n - 1])) length--;
        if (length >= 8) continue;
        memcpy(unit, word + n - (n > m ? n - m - 1 : 0), length);
        unit[length] = '\0';
        return field[k];
    }
    return -1;
}

static bool is_separator(char c) { return wcut_is_blank(c) || c == ',' || c == ';' || c == '"' || c == '\r'; }

/* a coordinate's unit in the header must be the one that the caller states */
static bool check_unit(wcut_cloud_source *s, const char *line, const char *word, const char *unit) {
    static const char *const name[] = {"mm", "cm", "m", "in", "inch"};
    static const wcut_length_unit value[] = {WCUT_LENGTH_UNIT_MM, WCUT_LENGTH_UNIT_CM, WCUT_LENGTH_UNIT_M,
                                             WCUT_LENGTH_UNIT_INCH, WCUT_LENGTH_UNIT_INCH};
    static const char *const expected[] = {"millimetres, as the option unit says",
                                           "centimetres, as the option unit says", "metres, as the option unit says",
                                           "inches, as the option unit says"};
    for (size_t k = 0; k < sizeof name / sizeof *name; k++)
        if (strcasecmp(unit, name[k]) == 0)
            return value[k] == s->options.unit ||
                   wcut_source_refuse_text(&s->in, line, word, expected[s->options.unit]);
    return true;
}

/* the columns of x, y, z where a line names them; `named` is how many columns it has, 0 where it does not */
static bool read_names(wcut_cloud_source *s, const char *line, const char *end, int column[WCUT_FIELDS], int *named) {
    int found[WCUT_FIELDS] = {-1, -1, -1, -1, -1, -1}, words = 0;
    const char *p = line, *word[3] = {NULL, NULL, NULL};
    char unit[3][8];
    while (p < end && (is_separator(*p) || *p == '#' || *p == '/')) p++;
    while (p < end && *p != '\n') {
        const char *from = p;
        while (p < end && *p != '\n' && !is_separator(*p)) p++;
        char behind[8];
        const int field = find_field(from, (size_t)(p - from), behind);
        if (field >= 0 && found[field] < 0) {
            found[field] = words;
            if (field < 3) word[field] = from, memcpy(unit[field], behind, sizeof behind);
        }
        words++;
        while (p < end && is_separator(*p)) p++;
    }
    *named = found[0] >= 0 && found[1] >= 0 && found[2] >= 0 ? words : 0;
    if (*named == 0) return true;
    if (found[3] < 0 || found[4] < 0 || found[5] < 0) found[3] = found[4] = found[5] = -1;
    memcpy(column, found, sizeof found);
    for (int k = 0; k < 3; k++)
        if (!check_unit(s, line, word[k], unit[k])) return false;
    return true;
}

/* ---- the first rows: separator, columns ---- */

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

/* go to the next column: behind the separator; NULL where the line ends */
static const char *next_column(const char *at, char separator) {
    at = wcut_skip_blanks(at);
    if (wcut_is_line_end(at)) return NULL;
    return at + (separator != ' ' && *at == separator);
}

static const char *skip_column(const char *at, char separator) {
    if (separator == ' ') at = wcut_skip_blanks(at);
    while (!wcut_is_line_end(at) && *at != separator && !(separator == ' ' && *at == '\t')) at++;
    return at;
}

static int count_columns(const char *line, char separator) {
    int columns = 0;
    for (const char *p = line; p; p = next_column(skip_column(p, separator), separator)) columns++;
    return columns;
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

/* columns that no header names: x y z, and a normal where there are six and the first row's has length 1 */
static void assume_columns(const char *line, text_layout *t) {
    double v[WCUT_FIELDS] = {0, 0, 0, 0, 0, 0};
    const char *p = line;
    for (int k = 0; k < WCUT_FIELDS; k++) t->column[k] = k < 3 ? k : -1;
    if (t->columns != 6) return;
    for (int k = 0; k < 6; k++) {
        const char *behind = wcut_row_number(p, t->separator, t->comma, &v[k]);
        if (!behind) return;
        p = next_column(behind, t->separator);
        if (!p && k < 5) return;
    }
    const double size = sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
    for (int k = 3; k < 6 && size > 0.98 && size < 1.02; k++) t->column[k] = k;
}

static bool find_columns(wcut_cloud_source *s, const char *line, const char *end, int named, bool strict,
                         text_layout *t) {
    find_separator(line, end, t);
    t->columns = count_columns(line, t->separator);
    if (t->columns > COLUMNS_MAX) return wcut_source_refuse_text(&s->in, line, line, "at most 1000 columns");
    if (t->columns < 3) return wcut_source_refuse_text(&s->in, line, line, "at least three numbers, x y z");
    if (named != t->columns) {
        if (named > 0 && strict)
            return wcut_source_refuse_text(&s->in, line, line, "as many columns as the header names");
        if (!check_commas(s, line, t)) return false;
        assume_columns(line, t);
    }
    memset(t->field, -1, sizeof t->field);
    for (int k = 0; k < WCUT_FIELDS; k++) {
        const int c = t->column[k];
        if (c >= (int)(sizeof t->field / sizeof *t->field))
            return wcut_source_refuse_text(&s->in, line, line, "the coordinates among the first 16 columns");
        if (c >= 0) t->field[c] = k;
        if (c > t->last) t->last = c;
    }
    s->info.has_normals = t->column[3] >= 0;
    return true;
}

static bool is_comment(const char *p) { return *p == '#' || (p[0] == '/' && p[1] == '/'); }

static bool begins_number(const char *p) {
    double value;
    if (wcut_row_number(p, ',', true, &value) || wcut_row_number(p, ';', true, &value)) return true;
    p += *p == '-' || *p == '+';
    return (*p >= '0' && *p <= '9') || *p == '.';
}

/* a line that is only a count; the rows will be held to it */
static bool read_count(wcut_cloud_source *s, const char *p, bool *is_count) {
    int64_t count;
    const char *behind = wcut_row_count(p, &count);
    *is_count = s->info.stated < 0 && behind && wcut_is_line_end(wcut_skip_blanks(behind));
    return *is_count ? wcut_cloud_state(s, count, 0, "points") : true;
}

/* ---- the rows ---- */

/* a zero byte ends a line only where the file ends */
static bool check_zero(wcut_cloud_source *s, const char *line, size_t length, const char *at) {
    return *at != '\0' || at == line + length || wcut_source_refuse_text(&s->in, line, at, "text");
}

static bool read_row(wcut_cloud_source *s, const text_layout *t, const char *line, size_t length, double *value) {
    const char *p = line;
    for (int c = 0;; c++) {
        const int k = c <= t->last ? t->field[c] : -1;
        const char *behind =
            k >= 0 ? wcut_row_number(p, t->separator, t->comma, &value[k]) : skip_column(p, t->separator);
        if (!behind) return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(p), "a number");
        behind = wcut_skip_blanks(behind);
        if (wcut_is_line_end(behind)) {
            if (!check_zero(s, line, length, behind)) return false;
            return c + 1 == t->columns ||
                   wcut_source_refuse_text(&s->in, line, behind, "as many columns as the first row has");
        }
        if (t->separator != ' ' && *behind != t->separator)
            return wcut_source_refuse_text(&s->in, line, behind, "the next column");
        if (c + 1 == t->columns)
            return wcut_source_refuse_text(&s->in, line, behind, "the end of the line, as in the first row");
        p = behind + (t->separator != ' ');
    }
}

static bool fill_text(wcut_cloud_source *s, wcut_batch *b) {
    const text_layout *t = s->state;
    double value[WCUT_FIELDS] = {0, 0, 0, 0, 0, 0};
    size_t length;
    while (b->count < b->capacity) {
        const char *line = wcut_row_peek(&s->in, &length);
        if (!line) {
            if (s->in.failure.status != WCUT_OK) return false;
            return s->info.stated < 0 || s->left == 0 || wcut_source_refuse_truncated(&s->in, s->left, "points");
        }
        const char *p = wcut_skip_blanks(line);
        if (wcut_is_line_end(p) || is_comment(p)) {
            if (!is_comment(p) && !check_zero(s, line, length, p)) return false;
        } else {
            if (s->left == 0)
                return wcut_source_refuse_text(&s->in, line, p, "the end: the file states no more points");
            if (!read_row(s, t, line, length, value) || !wcut_cloud_take(s, b, value)) return false;
            s->left--;
        }
        wcut_row_done(&s->in, length);
    }
    return true;
}

/* what a line before the first row says; `words` counts those that are no comment */
static bool read_header_line(wcut_cloud_source *s, const char *line, size_t length, text_layout *t, int *named,
                             int *words) {
    const char *p = wcut_skip_blanks(line);
    if (wcut_is_line_end(p)) return check_zero(s, line, length, p);
    if (!is_comment(p) && ++*words > HEADER_LINES_MAX)
        return wcut_source_refuse_text(&s->in, line, p, "a row that begins with numbers");
    int found = 0, column[WCUT_FIELDS];
    if (!read_names(s, line, line + length, column, &found)) return false;
    if (found > 0) *named = found, memcpy(t->column, column, sizeof column);
    return true;
}

bool wcut_cloud_begin_text(wcut_cloud_source *s) {
    text_layout *t = wcut_alloc(1, sizeof *t);
    if (!t) return wcut_source_refuse_memory(&s->in);
    s->state = t;
    s->in.line = 1;
    s->left = INT64_MAX;
    s->fill = fill_text;
    if (s->in.stream.end - s->in.stream.at >= 3 && memcmp(s->in.stream.data + s->in.stream.at, "\xef\xbb\xbf", 3) == 0)
        s->in.stream.at += 3;
    int named = 0, words = 0;
    size_t length;
    for (const char *line; (line = wcut_row_peek(&s->in, &length)) != NULL; wcut_row_done(&s->in, length)) {
        const char *p = wcut_skip_blanks(line);
        bool is_count = false;
        if (!wcut_is_line_end(p) && !is_comment(p) && begins_number(p)) {
            if (!read_count(s, p, &is_count)) return false;
            if (!is_count) return find_columns(s, line, line + length, named, words > 0, t);
        } else if (!read_header_line(s, line, length, t, &named, &words)) {
            return false;
        }
    }
    return s->in.failure.status == WCUT_OK && wcut_source_refuse_end(&s->in, "a row with the numbers x y z");
}
