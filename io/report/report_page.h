/* What the parts of the report page share: the view's choice of vertices, the data blocks, the document as JSON. */
#ifndef WCUT_IO_REPORT_REPORT_PAGE_H
#define WCUT_IO_REPORT_REPORT_PAGE_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <wirecut/report.h>

enum {
    WCUT_REPORT_BYTES = 25000000,      /* the largest page */
    WCUT_REPORT_VIEW_BYTES = 17000000, /* of it for all shapes, as base64 */
    WCUT_REPORT_VERTICES = 400000,     /* the most vertices a shape shows */
    WCUT_REPORT_POINTS = 10000,        /* the most points a series shows */
    WCUT_REPORT_QUANTILES = 1025       /* of a field, at equal steps of probability */
};

/* the bundle that the build embeds: apps/report/dist */
extern const unsigned char wcut_report_script[], wcut_report_style[];
extern const size_t wcut_report_script_size, wcut_report_style_size;

/* report_check.c: every limit of wirecut/report.h but the size of the page */
wcut_status wcut_report_check(const wcut_report *report, wcut_error *error);

/* report_thin.c: which vertices of a shape the page holds */
typedef struct wcut_report_view {
    int count;                     /* vertices shown */
    int rows, columns;             /* of the grid shown, or 0 */
    int row_stride, column_stride; /* of the grid; the last row and column are always shown */
    bool triangles;                /* whether the shape's own triangles are shown (then every vertex is) */
    int *index;                    /* count */
} wcut_report_view;

wcut_status wcut_report_view_create(const wcut_report_shape *shape, int shapes, wcut_report_view *view);

/* at most `max` of count samples: the lowest and the highest of each run in their order; gives how many */
int wcut_report_thin(int count, const double *value, int max, int *index);

/* quantiles (order statistics) of the values that are there; gives how many there are, 0 writes nothing */
wcut_status wcut_report_quantiles(int count, const double *value, int quantiles, double *quantile, int *found);

/* report_pool.c: arrays that the page holds as little-endian base64 */
typedef struct wcut_report_array {
    const void *key; /* where it came from; the same key is held once. NULL: never the same */
    size_t size;     /* [byte] */
    void *data;
} wcut_report_array;

typedef struct wcut_report_pool {
    int count, room;
    wcut_report_array *array;
    size_t size; /* [byte] of all arrays as base64 */
} wcut_report_pool;

/* the number of an array in the pool, or -1 without memory; index (may be NULL) chooses count entries */
int wcut_report_pool_add_doubles(wcut_report_pool *pool, int count, const int *index, const double *value);
int wcut_report_pool_add_floats(wcut_report_pool *pool, int count, const int *index, const double *value);
int wcut_report_pool_add_points(wcut_report_pool *pool, int count, const int *index, const wcut_vec3 *point);
int wcut_report_pool_add_ints(wcut_report_pool *pool, int count, const int *value);
void wcut_report_pool_clear(wcut_report_pool *pool);

/* base64 (RFC 4648) of size bytes: 4 ((size + 2) / 3) characters, no terminator */
void wcut_base64_print(size_t size, const void *data, char *text);

/* report_json.c: the document, its arrays in the pool; NULL without memory */
json_t *wcut_report_json(const wcut_report *report, wcut_report_pool *pool);

/* a copy in valid UTF-8: every byte that does not fit becomes U+FFFD; to free(), NULL without memory */
char *wcut_report_text(const char *text);

#endif
