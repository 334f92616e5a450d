/* Less on the page than was measured: an even choice for the eye, quantiles from all. */
#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/sort.h"
#include "io/report/report_page.h"

static int at_stride(int k, int stride, int count) {
    const long long i = (long long)k * stride;
    return i < count ? (int)i : count - 1;
}

/* rows or columns left by a stride: every stride-th and the last */
static int strided(int count, int stride) { return (count + stride - 2) / stride + 1; }

/* thin the finer direction first, until the grid is small enough */
static void choose_grid(const wcut_report_shape *shape, int max, wcut_report_view *view) {
    int rs = 1, cs = 1, rows = shape->rows, columns = shape->columns;
    while ((double)rows * columns > max && (rows > 2 || columns > 2)) {
        if (rows >= columns)
            rows = strided(shape->rows, ++rs);
        else
            columns = strided(shape->columns, ++cs);
    }
    *view = (wcut_report_view){
        .count = rows * columns, .rows = rows, .columns = columns, .row_stride = rs, .column_stride = cs};
}

static void fill_view_grid(const wcut_report_shape *shape, wcut_report_view *view) {
    for (int r = 0, k = 0; r < view->rows; r++) {
        const int row = at_stride(r, view->row_stride, shape->rows);
        for (int c = 0; c < view->columns; c++)
            view->index[k++] = row * shape->columns + at_stride(c, view->column_stride, shape->columns);
    }
}

/* One vertex from each of count runs, at a place that wanders by the golden ratio: a plain stride would pick the same
   column of a scan line by line. Each field's lowest and highest vertex is always there. */
static void fill_cloud(const wcut_report_shape *shape, wcut_report_view *view) {
    const double run = (double)shape->vertex_count / view->count;
    for (int k = 0; k < view->count; k++) {
        const double place = fmod(k * 0.6180339887498949, 1.0);
        view->index[k] = (int)fmin((k + place) * run, shape->vertex_count - 1.0);
    }
    for (int f = 0; f < shape->field_count; f++) {
        const double *value = shape->field[f].value;
        int low = -1, high = -1;
        for (int i = 0; i < shape->vertex_count; i++) {
            if (isnan(value[i])) continue;
            if (low < 0 || value[i] < value[low]) low = i;
            if (high < 0 || value[i] > value[high]) high = i;
        }
        if (low >= 0) view->index[(int)fmin(low / run, view->count - 1.0)] = low;
        if (high >= 0) view->index[(int)fmin(high / run, view->count - 1.0)] = high;
    }
}

wcut_status wcut_report_view_create(const wcut_report_shape *shape, int shapes, wcut_report_view *view) {
    /* how many vertices there is room for, as text */
    const double base64 = 4.0 / 3.0, room = (double)WCUT_REPORT_VIEW_BYTES / shapes;
    const double vertex_size = base64 * sizeof(float) * (3 + shape->field_count);
    const double triangle_size = base64 * 3 * sizeof(int) * shape->triangle_count;
    const int max = (int)fmin(WCUT_REPORT_VERTICES, room / vertex_size);

    /* a grid keeps its rows, triangles are kept where they fit, else points are chosen */
    wcut_report_view v = {.count = shape->vertex_count < max ? shape->vertex_count : max};
    if (shape->rows > 0) {
        choose_grid(shape, max, &v);
    } else if (shape->triangle_count > 0 && shape->vertex_count * vertex_size + triangle_size <= room) {
        v.count = shape->vertex_count;
        v.triangles = true;
    }

    /* the chosen vertices */
    v.index = wcut_alloc((size_t)v.count, sizeof *v.index);
    if (!v.index) return WCUT_NO_MEMORY;
    if (v.rows > 0)
        fill_view_grid(shape, &v);
    else if (v.count < shape->vertex_count)
        fill_cloud(shape, &v);
    else
        for (int i = 0; i < v.count; i++) v.index[i] = i;
    *view = v;

    return WCUT_OK;
}

int wcut_report_thin(int count, const double *value, int max, int *index) {
    /* few values stay as they are */
    if (count <= max) {
        for (int i = 0; i < count; i++) index[i] = i;
        return count;
    }

    /* of each run its lowest and its highest value, in their order */
    int kept = 0;
    const int runs = max / 2;
    for (int r = 0; r < runs; r++) {
        /* the run's lowest, highest and missing value */
        const int from = (int)((long long)count * r / runs), to = (int)((long long)count * (r + 1) / runs);
        int low = -1, high = -1, gap = -1;
        for (int i = from; i < to; i++) {
            if (isnan(value[i])) {
                gap = i;
                continue;
            }
            if (low < 0 || value[i] < value[low]) low = i;
            if (high < 0 || value[i] > value[high]) high = i;
        }

        /* a run of gaps alone keeps one of them */
        if (low < 0)
            index[kept++] = gap;
        else {
            index[kept++] = low < high ? low : high;
            if (low != high) index[kept++] = low < high ? high : low;
        }
    }

    return kept;
}

wcut_status wcut_report_quantiles(int count, const double *value, int quantiles, double *quantile, int *found) {
    double *sorted = wcut_alloc((size_t)count, sizeof *sorted);
    if (!sorted) return WCUT_NO_MEMORY;
    int n = 0;
    for (int i = 0; i < count; i++)
        if (!isnan(value[i])) sorted[n++] = value[i];
    wcut_sort(n, sorted);
    for (int k = 0; n > 0 && k < quantiles; k++)
        quantile[k] = sorted[(int)(((long long)k * (n - 1) + (quantiles - 1) / 2) / (quantiles - 1))];
    free(sorted);
    *found = n;
    return WCUT_OK;
}
