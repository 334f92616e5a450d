/* Curves in: tables of points as people and programs write them, one point a row.
 *
 * Two passes. The first finds the separator. The second reads rows: a header names the columns; what tells the curves
 * apart is, in this order, coordinates of several curves beside each other, a column that names the curve, blank lines
 * and titles between blocks of rows, or a count of points that begins again. What two readings fit is refused. */
#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/cad/curve_set.h"
#include "io/cad/point_columns.h"
#include "io/cad/point_group.h"
#include "io/file/decimal.h"
#include "io/file/unit.h"

/* a line of the table */
typedef struct table_line {
    int number, count;
    wcut_point_cell cell[WCUT_POINT_CELLS_MAX];
} table_line;

/* a row with coordinates: its block, its names in the two id columns, its count of points */
typedef struct table_row {
    int block, id[2];
    double index;
} table_row;

typedef struct curve_table {
    wcut_curve_reader *r;
    char *at, *end;
    int number; /* of the line at `at` */
    char separator;
    double unit; /* [mm] 0: none is stated */
    bool has_columns, has_header;
    wcut_point_columns columns;
    wcut_point_names id[2], title; /* title: of each block, "" for none */
    int blocks;
    bool is_block_over;
    int rows, room;
    table_row *row;
    wcut_points points; /* rows of one set, or of all sets one after the other in a row */
    table_line line;
} curve_table;

static bool is_table_blank(char c) { return c == ' ' || c == '\t'; }

static wcut_point_cell trim_cell(const char *from, const char *to) {
    while (from < to && is_table_blank(*from)) from++;
    while (to > from && is_table_blank(to[-1])) to--;
    const bool quoted = to - from >= 2 && (*from == '"' || *from == '\'') && to[-1] == *from;
    if (quoted) from++, to--;
    while (from < to && is_table_blank(*from)) from++;
    while (to > from && is_table_blank(to[-1])) to--;
    return (wcut_point_cell){from, (int)(to - from), quoted};
}

static bool refuse_cell(curve_table *t, const wcut_point_cell *cell, const char *expected) {
    char found[WCUT_QUOTE_SIZE];
    const int n = cell->length < WCUT_FOUND_MAX ? cell->length : WCUT_FOUND_MAX;
    char text[WCUT_FOUND_MAX + 1] = "";
    if (n > 0) memcpy(text, cell->at, (size_t)n);
    return wcut_curves_refuse(t->r, "line %d: found \"%s\", expected %s", t->line.number,
                              wcut_quote(found, text, WCUT_FOUND_MAX, 0), expected);
}

/* ---- lines ---- */

/* the next line; its end becomes a zero, by which the second pass knows it again. NULL: the end of the text */
static char *next_table_line(curve_table *t) {
    if (t->at >= t->end) return NULL;
    char *line = t->at, *stop = line;
    while (stop < t->end && *stop != '\n' && *stop != '\r' && *stop != '\0') stop++;
    if (stop + 1 < t->end && *stop == '\r' && stop[1] == '\n') *stop++ = ' ';
    *stop = '\0'; /* a zero is behind the text's end */
    t->at = stop + 1;
    t->number += t->number < INT_MAX;
    t->line.number = t->number;
    return line;
}

/* Brackets around a point, "(0, 0, 150)," or "{0, 0, 150}", a semicolon at a line's end and a comment behind a row are no
   part of it. */
static char *strip_line(char *line) {
    char *first = line, *comment = strstr(line, " #");
    if (comment) memset(comment, ' ', strlen(comment));
    while (is_table_blank(*first)) first++;
    char *last = first + strlen(first);
    while (last > first && is_table_blank(last[-1])) last--;
    if (last > first && last[-1] == ';' && strchr(first, ';') == last - 1) last[-1] = ' ';
    if (*first == '(' || *first == '[' || *first == '{')
        for (char *p = first; *p; p++)
            if (strchr("()[]{}", *p)) *p = ' ';
    while (is_table_blank(*first)) first++;
    return first;
}

/* cells of a line at a separator, a blank for any blanks; an empty cell at the end is none. false: too many */
static bool split_line(const char *line, char separator, table_line *to) {
    const char *p = line;
    to->count = 0;
    while (is_table_blank(*p)) p++;
    while (*p) {
        /* a quoted cell may contain the separator */
        const char *from = p;
        const char quote = *p == '"' || *p == '\'' ? *p : 0;
        if (quote) {
            const char *closing = strchr(p + 1, quote);
            if (closing) p = closing + 1;
        }
        while (*p && (separator == ' ' ? !is_table_blank(*p) : *p != separator)) p++;

        /* the cell without the blanks around it, then the separator and blanks behind it */
        if (to->count == WCUT_POINT_CELLS_MAX) return false;
        to->cell[to->count++] = trim_cell(from, p);
        p += *p != '\0';
        while (is_table_blank(*p)) p++;
    }

    /* separators at the end of a line add no cells */
    while (to->count > 0 && to->cell[to->count - 1].length == 0) to->count--;
    return true;
}

/* the number of a cell: with a decimal comma too where commas do not separate. false: it is none, or not finite */
static bool read_cell_number(const curve_table *t, const wcut_point_cell *cell, double *value) {
    char text[64];
    if (cell->length == 0 || cell->length >= (int)sizeof text) return false;
    memcpy(text, cell->at, (size_t)cell->length); /* of one byte or more */
    text[cell->length] = '\0';
    char *comma = strchr(text, ',');
    if (comma && (t->separator != ',' || cell->quoted) && !strchr(text, '.')) *comma = '.';
    const char *behind = wcut_decimal_read(text, value);
    return behind > text && *behind == '\0' && isfinite(*value);
}

/* empty, or what programs write where there is no number */
static bool is_absent(const wcut_point_cell *cell) {
    static const char *const word[] = {"nan", "na", "n/a", "null", "none", "-", "#n/a"};
    if (cell->length == 0) return true;
    for (size_t k = 0; k < sizeof word / sizeof *word; k++)
        if ((size_t)cell->length == strlen(word[k]) && strncasecmp(cell->at, word[k], strlen(word[k])) == 0)
            return true;
    return false;
}

/* ---- separator ---- */

/* whether commas stand within numbers: "0,5 1,5 2,5" */
static bool has_decimal_commas(const char *line) {
    int words = 0, commas = 0;
    for (const char *p = line; *p; p++) {
        if (is_table_blank(*p)) {
            commas = 0;
            continue;
        }
        words += p == line || is_table_blank(p[-1]);
        if (*p != ',') continue;
        const bool within = p > line && isdigit((unsigned char)p[-1]) && isdigit((unsigned char)p[1]);
        if (!within || ++commas > 1) return false;
    }
    return words >= 3;
}

static char find_line_separator(const char *line) {
    if (strchr(line, ';')) return ';';
    if (strchr(line, '\t')) return '\t';
    if (strchr(line, '|')) return '|';
    return strchr(line, ',') && !has_decimal_commas(line) ? ',' : ' ';
}

/* the separator of the first line that is a row of numbers, or names coordinates; "sep=;" says it itself */
static void find_table_separator(curve_table *t) {
    char *begin = t->at, *line;
    t->separator = ',';
    while ((line = next_table_line(t)) != NULL) {
        if (strncasecmp(line, "sep=", 4) == 0 && line[4]) {
            t->separator = line[4];
            break;
        }
        const char *text = strip_line(line);
        const char separator = find_line_separator(text);
        if (*text == '#' || *text == '%') continue;

        /* a first row of numbers or of names shows which separator is used */
        int numbers = 0;
        double value;
        t->separator = separator;
        if (!split_line(text, separator, &t->line)) break;
        for (int k = 0; k < t->line.count; k++) numbers += read_cell_number(t, &t->line.cell[k], &value);
        if (numbers >= 3 || wcut_point_columns_named(t->line.count, t->line.cell)) break;
    }

    /* back to the begin: the lines are read again with this separator */
    t->at = begin;
    t->number = 0;
}

/* ---- names of columns ---- */

static bool use_unit(curve_table *t, double unit) {
    if (unit <= 0) return true;
    if (t->unit > 0 && t->unit != unit)
        return wcut_curves_refuse(t->r, "line %d: found a second unit, expected one", t->line.number);
    t->unit = unit;
    return true;
}

/* a header; one that comes again begins a further block */
static bool read_header(curve_table *t) {
    wcut_point_columns found;
    int odd;
    const char *expected = wcut_point_columns_find(t->line.count, t->line.cell, &found, &odd);
    if (expected && odd >= 0) return refuse_cell(t, &t->line.cell[odd], expected);
    if (expected) return wcut_curves_refuse(t->r, "line %d: expected %s", t->line.number, expected);
    t->is_block_over = true;
    if (t->has_header || t->rows > 0) {
        const bool same = found.sets == t->columns.sets && found.id[0] == t->columns.id[0] &&
                          memcmp(found.set[0].column, t->columns.set[0].column, sizeof found.set[0].column) == 0;
        if (!same) return wcut_curves_refuse(t->r, "line %d: found other columns than before", t->line.number);
        return use_unit(t, found.unit);
    }
    t->columns = found;
    t->has_columns = t->has_header = true;
    return use_unit(t, found.unit);
}

/* whether a number of the text has a decimal point */
static bool has_decimal_point(const curve_table *t) {
    for (const char *p = t->line.cell[0].at; p + 1 < t->end; p++)
        if (*p == '.' && isdigit((unsigned char)p[1])) return true;
    return false;
}

/* whether the last three of six numbers are a unit vector */
static bool has_normal(const double value[6]) {
    return fabs(value[3] * value[3] + value[4] * value[4] + value[5] * value[5] - 1) < 2e-3;
}

/* Columns of a first row of numbers without a header: x y z, one word with them, or two points. */
static bool guess_columns(curve_table *t) {
    static const char expected[] = "a header that names the columns: x, y, z, and the column that names the curve";
    wcut_point_columns *c = &t->columns;
    const int count = t->line.count;
    double value[6] = {0};
    bool is_number[6] = {false};

    /* which of the first six cells are numbers */
    for (int k = 0; k < count && k < 6; k++) is_number[k] = read_cell_number(t, &t->line.cell[k], &value[k]);
    *c = (wcut_point_columns){.columns = count, .sets = 1, .id = {-1, -1}, .index = -1};

    /* the word is in front of the numbers or behind them */
    int first = -1;
    if (count == 3) first = 0;
    if (count == 4 && !is_number[0]) first = 1, c->id[0] = 0;
    if (count == 4 && !is_number[3]) first = 0, c->id[0] = 3;
    if (count == 6) first = 0, c->sets = 2;
    for (int k = 0; first >= 0 && k < 3 * c->sets; k++)
        if (!is_number[first + k]) first = -1;
    if (first < 0)
        return wcut_curves_refuse(t->r, "line %d: found %d values without a header, expected %s", t->line.number, count,
                                  expected);

    /* two points a row, unless that may as well be decimal commas or a normal */
    if (c->sets == 2 && t->separator == ',' && !has_decimal_point(t))
        return wcut_curves_refuse(t->r, "line %d: found commas that may be decimal ones, expected %s", t->line.number,
                                  expected);
    if (c->sets == 2 && has_normal(value))
        return wcut_curves_refuse(t->r, "line %d: found points with normals, expected %s", t->line.number, expected);

    /* three columns of each point */
    for (int s = 0; s < c->sets; s++)
        c->set[s] = (wcut_point_set){.column = {first + 3 * s, first + 3 * s + 1, first + 3 * s + 2}};
    t->has_columns = true;
    return true;
}

/* ---- rows ---- */

/* a title for the block that begins */
static bool add_title(curve_table *t, const char *at, int length) {
    wcut_point_names *n = &t->title;
    while (length > 0 && (at[length - 1] == ':' || is_table_blank(at[length - 1]))) length--;
    while (length > 0 && (*at == '#' || is_table_blank(*at))) at++, length--;
    while (n->room <= t->blocks) {
        const int room = n->room ? 2 * n->room : 16;
        struct point_name *grown = wcut_grow(n->name, (size_t)room * sizeof *grown);
        if (!grown) return wcut_curves_refuse_memory(t->r);
        for (int k = n->room; k < room; k++) grown[k] = (struct point_name){"", 0};
        n->name = grown;
        n->room = room;
    }
    n->name[t->blocks] = (struct point_name){at, length};
    n->count = t->blocks + 1;
    t->is_block_over = true;
    return true;
}

/* the three coordinates of a set; *found false: none of them is there */
static bool read_set(curve_table *t, const wcut_point_set *set, bool *found, wcut_vec3 *point) {
    const wcut_point_cell none = {"", 0, false};
    double *to = &point->x;
    int absent = 0;
    for (int a = 0; a < 3; a++)
        absent += is_absent(set->column[a] < t->line.count ? &t->line.cell[set->column[a]] : &none);
    *found = absent < 3;
    for (int a = 0; *found && a < 3; a++) {
        const wcut_point_cell *cell = set->column[a] < t->line.count ? &t->line.cell[set->column[a]] : &none;
        if (is_absent(cell))
            return wcut_curves_refuse(t->r, "line %d: found no %c, expected a number", t->line.number, 'x' + a);
        if (!read_cell_number(t, cell, &to[a])) return refuse_cell(t, cell, "a number");
        if (!(fabs(to[a]) * (t->unit > 0 ? t->unit : 1) <= 1e12))
            return wcut_curves_refuse(t->r, "line %d: found a coordinate beyond 1e12", t->line.number);
    }
    return true;
}

static bool add_row(curve_table *t, const table_row *row) {
    if (t->rows == t->room) {
        const int room = t->room < INT_MAX / 2 ? (t->room ? 2 * t->room : 64) : INT_MAX;
        table_row *grown = t->rows < room ? wcut_grow(t->row, (size_t)room * sizeof *grown) : NULL;
        if (!grown) return wcut_curves_refuse_memory(t->r);
        t->row = grown;
        t->room = room;
    }
    t->row[t->rows++] = *row;
    return true;
}

/* the names of a row: an empty cell repeats the one above, as merged cells of a spreadsheet do */
static bool read_names(curve_table *t, table_row *row) {
    for (int k = 0; k < 2; k++) {
        const int column = t->columns.id[k];
        if (column < 0) continue;
        const wcut_point_cell *cell = column < t->line.count ? &t->line.cell[column] : NULL;
        const bool is_empty = !cell || cell->length == 0;
        if (is_empty && t->rows == 0)
            return wcut_curves_refuse(t->r, "line %d: found no name of the curve", t->line.number);
        row->id[k] =
            is_empty ? t->row[t->rows - 1].id[k] : wcut_point_names_locate(t->r, &t->id[k], cell->at, cell->length);
        if (row->id[k] < 0) return false;
    }
    return true;
}

/* a row of numbers; one without any coordinate ends a block */
static bool read_numbers(curve_table *t) {
    table_row row = {.id = {0, 0}, .index = NAN};
    bool found = false;
    if (!t->has_columns && !guess_columns(t)) return false;
    if (t->line.count > t->columns.columns)
        return wcut_curves_refuse(t->r,
                                  "line %d: found %d values, expected %d (numbers have a decimal point, or semicolons "
                                  "separate the columns)",
                                  t->line.number, t->line.count, t->columns.columns);

    /* a point of each set of columns; an empty set has no point in this row */
    for (int s = 0; s < t->columns.sets; s++) {
        wcut_vec3 point = {0, 0, 0};
        bool here;
        if (!read_set(t, &t->columns.set[s], &here, &point)) return false;
        if (here && !wcut_points_add(t->r, &t->points, s, t->line.number, point)) return false;
        found = found || here;
    }

    /* a row without a point separates two blocks */
    if (!found) {
        t->is_block_over = true;
        return true;
    }

    /* the block, the names, the count */
    if (t->is_block_over || t->rows == 0) {
        if (t->title.count <= t->blocks && !add_title(t, "", 0)) return false;
        t->blocks++;
    }
    t->is_block_over = false;
    row.block = t->blocks - 1;
    if (!read_names(t, &row)) return false;

    /* the number of the point within its curve, where a column has it */
    const int index = t->columns.index;
    if (index >= 0 && (index >= t->line.count || !read_cell_number(t, &t->line.cell[index], &row.index)))
        row.index = NAN;
    return add_row(t, &row);
}

/* ---- lines ---- */

/* a comment may be the header, state the unit, or be a curve's title */
static bool read_comment(curve_table *t, const char *text) {
    while (*text == '#' || *text == '%' || *text == '/' || *text == '>' || is_table_blank(*text)) text++;
    const int length = (int)strnlen(text, 1000);
    if (wcut_point_label_whole(text, length)) return add_title(t, text, length);
    if (t->rows > 0) return true;
    const double unit = wcut_unit_stated(text, (size_t)length);
    if (unit > 0) return use_unit(t, unit);
    if (t->has_header || !split_line(text, find_line_separator(text), &t->line)) return true;
    return !wcut_point_columns_named(t->line.count, t->line.cell) || read_header(t);
}

/* A line of words alone: above the table, or the title of a curve, which says edge, curve, a ..., or anything where the
   first curve has one too. */
static bool read_words(curve_table *t, const char *text) {
    const int length = (int)strnlen(text, 1000);
    const bool is_titled = t->title.count > 0 && t->title.name[0].length > 0;
    if (wcut_point_label_whole(text, length)) return add_title(t, text, length);
    if (t->line.count <= 2 && (t->rows == 0 || is_titled)) return add_title(t, text, length);
    if (t->rows > 0) return refuse_cell(t, &t->line.cell[0], "a number");
    return refuse_cell(t, &t->line.cell[0], "columns named x_mm, y_mm, z_mm");
}

static bool read_line(curve_table *t, char *line) {
    const char *text = line;
    while (is_table_blank(*text)) text++;

    /* comments; ">" begins a curve, as in files of GMT */
    if (*text == '#' || *text == '%' || (*text == '/' && text[1] == '/')) return read_comment(t, text);
    if (*text == '>') {
        t->is_block_over = true;
        return read_comment(t, text);
    }
    if (strncasecmp(text, "sep=", 4) == 0 && t->rows == 0) return true;

    /* the cells of the line; an empty line ends a block */
    text = strip_line(line);
    if (!split_line(text, t->separator, &t->line))
        return wcut_curves_refuse(t->r, "line %d: found more than %d values", t->number, WCUT_POINT_CELLS_MAX);
    if (t->line.count == 0) {
        t->is_block_over = true;
        return true;
    }

    /* a header with names, and a line of units below it */
    if (wcut_point_columns_named(t->line.count, t->line.cell)) return read_header(t);
    const double unit = t->has_header && t->rows == 0 ? wcut_point_columns_unit(t->line.count, t->line.cell) : 0;
    if (unit < 0) return wcut_curves_refuse(t->r, "line %d: found several units, expected one", t->line.number);
    if (unit > 0) return use_unit(t, unit);

    /* numbers, or the absence of them */
    int numbers = 0, absent = 0;
    double value;
    for (int k = 0; k < t->line.count; k++) {
        absent += is_absent(&t->line.cell[k]);
        numbers += read_cell_number(t, &t->line.cell[k], &value);
    }
    if (numbers >= 2 || (t->has_columns && numbers > 0 && t->line.count > 1)) return read_numbers(t);

    /* a row of absent values separates two blocks, as an empty line does */
    if (absent == t->line.count) {
        t->is_block_over = true;
        return true;
    }
    return read_words(t, text);
}

/* ---- which row belongs to which curve ---- */

/* whether a column names curves: more than one, and not each row for itself */
static bool is_name_used(const curve_table *t, int k) {
    return t->columns.id[k] >= 0 && t->id[k].count > 1 && t->id[k].count < t->rows;
}

/* whether two columns name the same curves */
static bool are_names_alike(const curve_table *t, int *seen) {
    for (int k = 0; k < t->rows; k++) {
        int *other = &seen[t->row[k].id[0]];
        if (*other == 0) *other = t->row[k].id[1] + 1;
        if (*other != t->row[k].id[1] + 1) return false;
    }
    return t->id[0].count == t->id[1].count;
}

static bool use_names(curve_table *t, int k) {
    if (k == 0 && is_name_used(t, 1)) {
        int *seen = wcut_alloc((size_t)t->id[0].count, sizeof *seen);
        if (!seen) return wcut_curves_refuse_memory(t->r);
        const bool alike = are_names_alike(t, seen);
        wcut_free(seen);
        if (!alike) return wcut_curves_refuse(t->r, "found two columns that name curves differently, expected one");
    }
    for (int row = 0; row < t->rows; row++) t->points.point[row].curve = t->row[row].id[k];
    return true;
}

static bool use_blocks(curve_table *t) {
    if (t->blocks == t->rows && t->blocks > 1)
        return wcut_curves_refuse(t->r, "found a blank line behind each row, expected one between the curves");
    for (int row = 0; row < t->rows; row++) t->points.point[row].curve = t->row[row].block;
    return true;
}

/* a count of points that begins again begins a curve; gives how many */
static int use_counts(curve_table *t) {
    int curve = 0;
    for (int k = 1; k < t->rows; k++) {
        curve += t->row[k].index == t->row[0].index;
        t->points.point[k].curve = curve;
    }
    return curve + 1;
}

/* the counts of a curve's points rise, or fall, from row to row; -1 where a count is none */
static bool check_counts(curve_table *t, int curves) {
    bool done = true;
    double *last = wcut_alloc((size_t)curves, sizeof *last), *way = wcut_alloc((size_t)curves, sizeof *way);
    for (int k = 0; k < curves && last; k++) last[k] = NAN;
    for (int k = 0; k < t->rows && last && way && done; k++) {
        const int c = t->points.point[k].curve;
        const double step = t->row[k].index - last[c]; /* not a number at the first row */
        done = !(step * way[c] < 0 || step == 0) ||
               wcut_curves_refuse(t->r, "line %d: found point %g behind %g, expected counts in order along a curve",
                                  t->points.point[k].line, t->row[k].index, last[c]);
        if (step < 0 || step > 0) way[c] = step;
        last[c] = t->row[k].index;
    }
    if (!last || !way) done = wcut_curves_refuse_memory(t->r);
    wcut_free(last);
    wcut_free(way);
    return done;
}

/* curves beside each other; a name for each */
static bool end_beside(curve_table *t) {
    struct point_name name[WCUT_POINT_SETS_MAX];
    const wcut_point_names names = {.count = t->columns.sets, .name = name};
    if (t->blocks > 1 || is_name_used(t, 0) || is_name_used(t, 1))
        return wcut_curves_refuse(t->r, "found curves beside each other and below each other, expected one of both");
    for (int s = 0; s < t->columns.sets; s++)
        name[s] = (struct point_name){t->columns.set[s].label, (int)strlen(t->columns.set[s].label)};
    return wcut_points_end(t->r, &t->points, t->columns.sets, &names, "line");
}

static bool end_table(curve_table *t) {
    if (t->rows == 0) return wcut_curves_refuse(t->r, "found no row of numbers, expected points x, y, z");

    /* all coordinates in mm */
    if (t->unit > 0)
        for (int k = 0; k < t->points.count; k++) {
            wcut_vec3 *p = &t->points.point[k].at;
            *p = (wcut_vec3){t->unit * p->x, t->unit * p->y, t->unit * p->z};
        }
    if (t->columns.sets > 1) return end_beside(t);

    /* below each other: by names, else by blocks, else by counts */
    const wcut_point_names *names = NULL;
    int curves = 1;
    bool done = true;
    for (int k = 1; k >= 0; k--)
        if (is_name_used(t, k)) names = &t->id[k];
    if (names) {
        curves = names->count;
        done = use_names(t, names == &t->id[0] ? 0 : 1);
    } else if (t->blocks > 1) {
        names = &t->title;
        curves = t->blocks;
        done = use_blocks(t);
    } else if (t->columns.index >= 0 && isfinite(t->row[0].index)) {
        curves = use_counts(t);
    }
    if (done && t->columns.index >= 0) done = check_counts(t, curves);
    return done && wcut_points_end(t->r, &t->points, curves, names, "line");
}

bool wcut_curves_fill_csv(wcut_curve_reader *r, char *text, size_t length) {
    curve_table *t = wcut_alloc(1, sizeof *t);
    if (!t) return wcut_curves_refuse_memory(r);
    *t = (curve_table){.r = r, .at = text, .end = text + length};
    char *line;
    bool done = true;

    /* text of one byte a letter */
    if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) t->at += 3;
    if (length >= 2 && (memcmp(text, "\xff\xfe", 2) == 0 || memcmp(text, "\xfe\xff", 2) == 0))
        done = wcut_curves_refuse(r, "found UTF-16, expected UTF-8");
    else if (memchr(text, 0, length))
        done = wcut_curves_refuse(r, "found a zero byte, expected text");

    /* the rows, then the curves */
    if (done) find_table_separator(t);
    while (done && (line = next_table_line(t)) != NULL) done = read_line(t, line);
    if (done) done = end_table(t);

    for (int k = 0; k < 2; k++) wcut_point_names_clear(&t->id[k]);
    wcut_point_names_clear(&t->title);
    wcut_points_clear(&t->points);
    wcut_free(t->row);
    wcut_free(t);
    return done;
}
