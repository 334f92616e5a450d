/* PTX (Leica Cyclone): scans one after the other, each a grid of points behind two counts, the scanner's place and a
   matrix that moves its points. */
#include <limits.h>
#include <string.h>

#include "base/alloc.h"
#include "io/file/row.h"
#include "io/scan/cloud_source.h"

typedef struct ptx_scan {
    double matrix[4][3]; /* p -> p R + t: the rows of R, then t, in the file's unit */
} ptx_scan;

/* the next line, which the format needs; NULL: refused */
static const char *expect_ptx_line(wcut_cloud_source *s, size_t *length, const char *expected) {
    const char *line = wcut_row_peek(&s->in, length);
    if (!line && s->in.failure.status == WCUT_OK) wcut_source_refuse_end(&s->in, expected);
    return line;
}

static bool read_ptx_count(wcut_cloud_source *s, const char *expected, int64_t *count) {
    size_t length;
    const char *line = expect_ptx_line(s, &length, expected);
    if (!line) return false;
    const char *behind = wcut_row_count(line, count);
    if (!behind || !wcut_is_line_end(wcut_skip_blanks(behind)))
        return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(line), expected);
    wcut_row_done(&s->in, length);
    return true;
}

/* a line of so many numbers, finite ones */
static bool read_ptx_numbers(wcut_cloud_source *s, int count, const char *expected, double *value) {
    size_t length;
    const char *line = expect_ptx_line(s, &length, expected), *p = line;
    if (!line) return false;
    for (int k = 0; k < count; k++) {
        const char *behind = wcut_row_number(p, ' ', false, &value[k]);
        if (!behind || !isfinite(value[k])) return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(p), expected);
        p = behind;
    }
    p = wcut_skip_blanks(p);
    if (!wcut_is_line_end(p)) return wcut_source_refuse_text(&s->in, line, p, "the end of the line");
    wcut_row_done(&s->in, length);
    return true;
}

/* ten lines: columns, rows, the scanner's place and axes, and the matrix, whose last row is the shift */
static bool read_ptx_header(wcut_cloud_source *s, ptx_scan *scan) {
    /* the grid's size; its product is checked below */
    int64_t columns = 0, rows = 0;
    double unused[3], row[4];
    if (!read_ptx_count(s, "the number of columns of a PTX scan", &columns) ||
        !read_ptx_count(s, "the number of rows of a PTX scan", &rows))
        return false;

    /* place and axes of the scanner are not used: the matrix has them */
    for (int k = 0; k < 4; k++)
        if (!read_ptx_numbers(s, 3, "three numbers, the scanner's place and axes", unused)) return false;
    for (int k = 0; k < 4; k++) {
        if (!read_ptx_numbers(s, 4, "four numbers, a row of the scan's matrix", row)) return false;
        if (row[3] != (k == 3)) return wcut_source_refuse(&s->in, "found a matrix that is no motion of a PTX scan");
        memcpy(scan->matrix[k], row, 3 * sizeof *row);
    }

    /* the points of this scan, and of all so far */
    const int64_t before = s->info.stated > 0 ? s->info.stated : 0;
    const int64_t count = rows > 0 && columns > INT_MAX / rows ? INT64_MAX : columns * rows;
    if (!wcut_cloud_state(s, count, 8, "points") || !wcut_source_check_count(&s->in, before + count, 0, "points"))
        return false;
    s->info.stated = (int)(before + count);

    return true;
}

static bool read_point(wcut_cloud_source *s, const ptx_scan *scan, wcut_batch *b) {
    /* three numbers; an intensity behind them is passed over */
    size_t length;
    const char *line = wcut_row_peek(&s->in, &length), *p = line;
    double at[3], value[WCUT_FIELDS] = {0};
    if (!line) return s->in.failure.status == WCUT_OK && wcut_source_refuse_truncated(&s->in, s->left, "points");
    for (int k = 0; k < 3; k++) {
        const char *behind = wcut_row_number(p, ' ', false, &at[k]);
        if (!behind) return wcut_source_refuse_text(&s->in, line, wcut_skip_blanks(p), "a number");
        p = behind;
    }

    /* the row is read, whatever it says */
    wcut_row_done(&s->in, length);
    s->left--;

    /* a beam that came back from nowhere stands at the scanner */
    if (at[0] == 0 && at[1] == 0 && at[2] == 0) {
        s->info.withheld++;
        return true;
    }

    /* the scan's matrix moves the point, row vectors as the format has them */
    for (int k = 0; k < 3; k++)
        value[k] =
            at[0] * scan->matrix[0][k] + at[1] * scan->matrix[1][k] + at[2] * scan->matrix[2][k] + scan->matrix[3][k];

    return wcut_cloud_take(s, b, value);
}

/* whether another scan follows */
static bool has_more(wcut_cloud_source *s) {
    size_t length;
    const char *line;
    while ((line = wcut_row_peek(&s->in, &length)) != NULL) {
        if (!wcut_is_line_end(wcut_skip_blanks(line))) return true;
        wcut_row_done(&s->in, length);
    }
    return false;
}

static bool fill_ptx(wcut_cloud_source *s, wcut_batch *b) {
    ptx_scan *scan = s->state;
    while (b->count < b->capacity) {
        if (s->left == 0) {
            if (!has_more(s)) return s->in.failure.status == WCUT_OK;
            if (!read_ptx_header(s, scan)) return false;
            continue;
        }
        if (!read_point(s, scan, b)) return false;
    }
    return true;
}

bool wcut_cloud_begin_ptx(wcut_cloud_source *s) {
    ptx_scan *scan = wcut_alloc(1, sizeof *scan);
    if (!scan) return wcut_source_refuse_memory(&s->in);
    s->state = scan;
    s->fill = fill_ptx;
    s->in.line = 1;
    return read_ptx_header(s, scan);
}
