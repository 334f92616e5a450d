/* wirecut/report.h - one self-contained page of results: the results in 3-D, in charts and in tables. */
#ifndef WCUT_REPORT_H
#define WCUT_REPORT_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The structs below borrow everything they point to. Texts are UTF-8 and untrusted: they are escaped, and bytes that
   are not UTF-8 become U+FFFD. A unit is "" or NULL where there is none. NaN means "not there": a gap in a line, grey
   in the view, a dash in a table; numbers beyond 1e30 are refused. */

enum { WCUT_SHA256_TEXT = 65 }; /**< bytes of a SHA-256 as hexadecimal text, with its final zero */

/** How good the verdict is. */
typedef enum wcut_report_tone {
    WCUT_REPORT_TONE_PLAIN,
    WCUT_REPORT_TONE_GOOD,
    WCUT_REPORT_TONE_WARNING,
    WCUT_REPORT_TONE_BAD
} wcut_report_tone;

/** A number with its unit, or a text; also an option in the provenance. */
typedef struct wcut_report_fact {
    const char *label;
    const char *text; /**< NULL: value and unit are shown */
    double value;     /**< shown to four digits */
    const char *unit;
} wcut_report_fact;

/** A column of a table: numbers or texts. */
typedef struct wcut_report_column {
    const char *label;
    const char *unit;
    const double *number;    /**< rows; NULL where the column holds texts */
    const char *const *text; /**< rows, entries may be NULL; NULL where the column holds numbers */
} wcut_report_column;

/** A table. */
typedef struct wcut_report_table {
    const char *title;
    const char *note; /**< may be NULL */
    int rows, columns;
    const wcut_report_column *column;
} wcut_report_table;

/** How a series is drawn. */
typedef enum wcut_report_mark {
    WCUT_REPORT_MARK_LINE,
    WCUT_REPORT_MARK_DASHED,
    WCUT_REPORT_MARK_POINTS
} wcut_report_mark;

/** A series of a chart; beyond 10,000 points the page holds the lowest and the highest of each short run. */
typedef struct wcut_report_series {
    const char *label;
    wcut_report_mark mark;
    int count;
    const double *x[2];       /**< count, not decreasing for lines; x[1] as chart->x_label[1], or NULL */
    const double *y;          /**< count */
    const double *low, *high; /**< count, a band around the series that the reader can hide; NULL where there is none */
} wcut_report_series;

/** A shaded and named interval of x: a phase of the cut, a finding. */
typedef struct wcut_report_span {
    const char *label;
    double from[2], to[2]; /**< in the units of x_label[0] and x_label[1] */
} wcut_report_span;

/** Lines or points over one of two abscissae (time or station) that the reader switches between. */
typedef struct wcut_report_chart {
    const char *title;
    const char *note;                   /**< may be NULL */
    const char *x_label[2], *x_unit[2]; /**< the second may be NULL */
    const char *y_label, *y_unit;
    int series_count;
    const wcut_report_series *series; /**< at most 8 */
    int span_count;
    const wcut_report_span *span;
} wcut_report_chart;

/** How values become colours. */
typedef enum wcut_report_scale {
    WCUT_REPORT_SCALE_SEQUENTIAL, /**< from low to high */
    WCUT_REPORT_SCALE_DIVERGING   /**< centred on zero */
} wcut_report_scale;

/** A grid of values, such as a residual over time and position along the wire. */
typedef struct wcut_report_map {
    const char *title;
    const char *note; /**< may be NULL */
    const char *x_label, *x_unit, *y_label, *y_unit, *label, *unit;
    int columns, rows;   /**< at most 1,000,000 cells */
    const double *x, *y; /**< columns, rows: centres of the cells, increasing */
    const double *value; /**< rows x columns */
    wcut_report_scale scale;
    double limit;                  /**< value of the strongest colour, so that two maps compare; 0: from the values */
    bool blank_missing;            /**< a cell without a value is left blank, not grey */
    int bands;                     /**< 0: y is numbered; else rows come in bands, named beside them and ruled apart */
    const int *band;               /**< bands: the first row of each, increasing from 0 */
    const char *const *band_label; /**< bands */
} wcut_report_map;

/**
 * Cases of a study: parallel coordinates to brush, a scatter of any two columns, the best cases with their pictures. The
 * shapes of the page's scene, where it has one, are those of the best cases, in their order.
 */
typedef struct wcut_report_cases {
    int rows;                         /**< cases, at most 20,000 */
    int columns;                      /**< 2 .. 400 */
    int parameters;                   /**< how many of the columns, from the first, were set; the others came out */
    const wcut_report_column *column; /**< columns of numbers, or of texts */
    const int *number;                /**< rows: what each case is called */
    const char *const *link;          /**< rows: its own page, a relative path; entries may be NULL */
    int goal;                         /**< the column that the best are chosen by; -1: none */
    bool highest;                     /**< else the lowest is the best */
    int best_count;
    const int *best;    /**< best_count rows, the best first */
    const char *called; /**< what a row is; NULL: "case" */
} wcut_report_cases;

/** Charts, maps and tables that belong together. */
typedef struct wcut_report_section {
    const char *title;
    const char *note; /**< may be NULL */
    int chart_count, map_count, table_count;
    const wcut_report_chart *chart;
    const wcut_report_map *map;
    const wcut_report_table *table;
    const wcut_report_cases *cases; /**< may be NULL; stands before the others */
} wcut_report_section;

/** A value at every vertex of a shape. */
typedef struct wcut_report_field {
    const char *label, *unit;
    wcut_report_scale scale;
    double tolerance;    /**< diverging: the band that counts as inside to begin with; 0: none */
    const double *value; /**< vertex_count */
} wcut_report_field;

/**
 * A surface or a cloud with its fields. Quantiles, histogram and shares count every vertex; the view holds every vertex
 * as long as the file stays small, beyond that every k-th row and column of a grid, or an even selection of a cloud.
 */
typedef struct wcut_report_shape {
    const char *name;
    int vertex_count;
    const wcut_vec3 *vertex;  /**< [mm] finite */
    int rows, columns;        /**< a grid (stations x nodes): rows * columns = vertex_count; else 0 */
    const char *row_label;    /**< what a row is, "station"; read for grids */
    const char *column_label; /**< what a column is, "node" */
    int triangle_count;       /**< 0 for a cloud and for a grid, which the page triangulates itself */
    const int *triangle;      /**< triangle_count x 3 */
    int field_count;          /**< at most 12 */
    const wcut_report_field *field;
    const int *part; /**< vertex_count: the row of the page's cases that a vertex belongs to; NULL: none */
} wcut_report_shape;

/** A line in the view, or with one point a mark; lines of one group are shown and hidden together. */
typedef struct wcut_report_line {
    const char *group; /**< "path curves" */
    const char *label; /**< may be NULL */
    int count;
    const wcut_vec3 *point; /**< count [mm] finite */
} wcut_report_line;

/** What is seen in space. */
typedef struct wcut_report_scene {
    const char *title;
    const char *note;     /**< may be NULL */
    wcut_vec3 block_size; /**< [mm] the block's outline from the origin; zero for none */
    int shape_count;
    const wcut_report_shape *shape; /**< at least 1, at most 8; one is seen at a time */
    int line_count;
    const wcut_report_line *line;
} wcut_report_scene;

/** A file that the results came from. */
typedef struct wcut_report_source {
    const char *role; /**< "job" */
    const char *name;
    const char *sha256; /**< hexadecimal; NULL where it was not hashed */
} wcut_report_source;

/** A page: the answer first, then the view, the sections, and where it all came from. */
typedef struct wcut_report {
    const char *verb;  /**< "simulate" */
    const char *title; /**< the job's name */
    wcut_report_tone tone;
    const char *verdict; /**< one sentence */
    int fact_count;
    const wcut_report_fact *fact;
    const wcut_report_scene *scene; /**< may be NULL */
    int section_count;
    const wcut_report_section *section;
    int source_count;
    const wcut_report_source *source;
    int option_count;
    const wcut_report_fact *option; /**< settings of the run */
} wcut_report;

/**
 * Write a page that opens from disk in any browser and makes no network request: under 25 MB, scripts pinned by
 * their SHA-256, the same bytes for the same report.
 *
 * @param[in]  report within the limits above
 * @param[in]  path   the target, replaced whole or not at all
 * @param[out] error  may be NULL; which part of the report is wrong
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (a limit above, a number beyond 1e30, more data than
 * 25 MB hold), WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_report_write(const wcut_report *report, const char *path, wcut_error *error);

/**
 * The SHA-256 of a file (FIPS 180-4), for the provenance.
 *
 * @param[in]  path  a regular file
 * @param[out] text  WCUT_SHA256_TEXT bytes, 64 hexadecimal digits
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NOT_FOUND (no such file, not readable, not regular): nothing was written.
 */
WCUT_API wcut_status wcut_file_hash(const char *path, char *text, wcut_error *error);

/**
 * The same for the sources of a report: "" of one that came through a pipe, which cannot be read once more, and of
 * path NULL.
 *
 * @param[in]  path  may be NULL
 * @param[out] text  WCUT_SHA256_TEXT bytes
 * @param[out] error may be NULL
 * @return WCUT_OK; a regular file that cannot be read again is a failure, with the statuses of wcut_file_hash.
 */
WCUT_API wcut_status wcut_source_hash(const char *path, char *text, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
