/* Pages for the tests: a cut as a grid with hostile names, and a cloud of a million points. */
#ifndef WCUT_TESTS_REPORT_PAGES_H
#define WCUT_TESTS_REPORT_PAGES_H

#include <math.h>
#include <stdlib.h>
#include <wirecut/report.h>

/* what an attacker would call a file: ends of elements, quotes, line separators, bytes that are no UTF-8 */
#define HOSTILE                                                                                                     \
    "</script><script>window.broken=1</script><img src=x onerror=\"window.broken=1\">'\" \xe2\x80\xa8\xe2\x80\xa9 " \
    "\xff--><!--"

enum { STATIONS = 161, NODES = 121, CLOUD = 1000000 };

/* everything that a page borrows; zero it before it is filled */
typedef struct pages_data {
    wcut_vec3 vertex[STATIONS * NODES], mount_a[STATIONS], mount_b[STATIONS];
    double force[STATIONS * NODES], curvature[STATIONS * NODES], deviation[STATIONS * NODES];
    double time[STATIONS], station[STATIONS], speed[2][STATIONS], alpha[2][STATIONS], low[STATIONS], high[STATIONS];
    wcut_vec3 *point; /* CLOUD */
    double *distance; /* CLOUD */
} pages_data;

/* a wire that trails in the middle over a bump; an unmeasured patch */
static inline void pages_fill(pages_data *d) {
    for (int s = 0; s < STATIONS; s++) {
        const double v = s / (STATIONS - 1.0), hill = sin(3.14159265358979 * v);
        d->station[s] = s;
        d->time[s] = 0.9 * s + 6 * v * v;
        for (int k = 0; k < 2; k++) {
            d->speed[k][s] = 9 + 5 * hill + (k ? 0.6 * sin(9 * v) : 0);
            d->alpha[k][s] = 12 * hill - (k ? 0.8 * v : 0);
        }
        d->low[s] = d->speed[0][s] - 0.5;
        d->high[s] = d->speed[0][s] + 0.5;
        d->mount_a[s] = (wcut_vec3){-110, 1200 * v, 150 + 60 * hill};
        d->mount_b[s] = (wcut_vec3){510, 1200 * v, 150 + 20 * hill};
        for (int n = 0; n < NODES; n++) {
            const double u = n / (NODES - 1.0), bow = sin(3.14159265358979 * u);
            const int i = s * NODES + n;
            d->vertex[i] = (wcut_vec3){-110 + 620 * u, 1200 * v - 90 * bow * hill,
                                       150 + 60 * hill * (1 - 0.66 * u) + 25 * bow * cos(6 * v)};
            d->force[i] = u > 0.18 && u < 0.82 ? 0.009 + 0.003 * bow * hill : 0;
            d->curvature[i] = 0.004 * bow * cos(6 * v) - 0.001;
            d->deviation[i] = u > 0.4 && u < 0.5 && v > 0.4 && v < 0.5 ? NAN : 1.4 * sin(7 * u + 2 * v) * hill;
        }
    }
}

/* a scan of the same cut, line by line; false: no memory */
static inline bool pages_fill_cloud(pages_data *d) {
    d->point = malloc(CLOUD * sizeof *d->point);
    d->distance = malloc(CLOUD * sizeof *d->distance);
    if (!d->point || !d->distance) return false;
    for (int i = 0; i < CLOUD; i++) {
        const double u = (i % 1000) / 999.0, v = (i / 1000) / 999.0, hill = sin(3.14159265358979 * v);
        d->distance[i] = 0.8 * sin(7 * u + 2 * v) * hill;
        d->point[i] = (wcut_vec3){400 * u, 1200 * v, 150 + 40 * hill * (1 - u) + d->distance[i]};
    }
    d->distance[123457] = 7.5; /* the one outlier that thinning must not lose */
    return true;
}

static inline void pages_free(pages_data *d) {
    free(d->point);
    free(d->distance);
}

static inline wcut_status pages_write_cut(const pages_data *d, const char *path, wcut_error *error) {
    const wcut_report_field field[] = {
        {"force across the wire", "N/mm", WCUT_REPORT_SCALE_SEQUENTIAL, 0, d->force},
        {"mean curvature", "1/mm", WCUT_REPORT_SCALE_DIVERGING, 0, d->curvature},
        {"deviation", "mm", WCUT_REPORT_SCALE_DIVERGING, 0.5, d->deviation},
    };
    const wcut_report_shape shape = {.name = "cut surface",
                                     .vertex_count = STATIONS * NODES,
                                     .vertex = d->vertex,
                                     .rows = STATIONS,
                                     .columns = NODES,
                                     .row_label = "station",
                                     .column_label = "node",
                                     .field_count = 3,
                                     .field = field};
    const wcut_vec3 worst = d->vertex[80 * NODES + 90];
    const wcut_report_line line[] = {{"path curves", "A", STATIONS, d->mount_a},
                                     {"path curves", "B", STATIONS, d->mount_b},
                                     {"worst areas", HOSTILE, 1, &worst}};
    const wcut_report_scene scene = {.title = "Cut surface",
                                     .block_size = {400, 1200, 300},
                                     .shape_count = 1,
                                     .shape = &shape,
                                     .line_count = 3,
                                     .line = line};
    const wcut_report_series speed[] = {
        {"mount A", WCUT_REPORT_MARK_LINE, STATIONS, {d->time, d->station}, d->speed[0], d->low, d->high},
        {"mount B", WCUT_REPORT_MARK_DASHED, STATIONS, {d->time, d->station}, d->speed[1], NULL, NULL}};
    const wcut_report_series alpha[] = {
        {"mount A", WCUT_REPORT_MARK_LINE, STATIONS, {d->time, d->station}, d->alpha[0], NULL, NULL},
        {"mount B", WCUT_REPORT_MARK_DASHED, STATIONS, {d->time, d->station}, d->alpha[1], NULL, NULL}};
    const wcut_report_span span[] = {
        {"entry", {0, 0}, {28, 30}}, {"steady", {28, 30}, {118, 128}}, {"exit", {118, 128}, {150, 160}}};
    const wcut_report_chart chart[] = {{.title = "Speed",
                                        .x_label = {"time", "station"},
                                        .x_unit = {"s", ""},
                                        .y_label = "speed",
                                        .y_unit = "mm/s",
                                        .series_count = 2,
                                        .series = speed,
                                        .span_count = 3,
                                        .span = span},
                                       {.title = "Angle alpha, trailing",
                                        .x_label = {"time", "station"},
                                        .x_unit = {"s", ""},
                                        .y_label = "alpha",
                                        .y_unit = "deg",
                                        .series_count = 2,
                                        .series = alpha,
                                        .span_count = 3,
                                        .span = span}};
    static const char *const channel[] = {"speed", HOSTILE, "tension"};
    static const double nrmsd[] = {0.0412, 0.173, NAN}, bias[] = {-0.31, 1.25, 0.004};
    const wcut_report_column column[] = {
        {"channel", "", NULL, channel}, {"NRMSD", "", nrmsd, NULL}, {"bias", "mm/s", bias, NULL}};
    const wcut_report_table table = {"Fit", NULL, 3, 3, column};
    const wcut_report_section section = {"Along the cut", NULL, 2, 0, 1, chart, NULL, &table, NULL};
    const wcut_report_fact fact[] = {{"duration", NULL, 150, "s"},
                                     {"stations", NULL, STATIONS, ""},
                                     {"speed, median", NULL, 12.1834, "mm/s"},
                                     {"alpha, largest", NULL, 11.98, "deg"},
                                     {"residual, largest", NULL, 3.2e-11, ""},
                                     {"material", HOSTILE, 0, ""}};
    const wcut_report_source source[] = {
        {"job", HOSTILE, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"}};
    const wcut_report_fact option[] = {{"integrator", "implicit", 0, ""}, {"chord tolerance", NULL, 0.01, "mm"}};
    const wcut_report report = {.verb = "simulate",
                                .title = "entry-steady-exit 400 " HOSTILE,
                                .tone = WCUT_REPORT_TONE_GOOD,
                                .verdict = "The wire passes the block in 150 s; both mounts stay within their limits.",
                                .fact_count = 6,
                                .fact = fact,
                                .scene = &scene,
                                .section_count = 1,
                                .section = &section,
                                .source_count = 1,
                                .source = source,
                                .option_count = 2,
                                .option = option};
    return wcut_report_write(&report, path, error);
}

static inline wcut_status pages_write_cloud(const pages_data *d, const char *path, wcut_error *error) {
    enum { SIDE = 60 };
    double x[SIDE], y[SIDE], value[SIDE * SIDE], px[SIDE], py[SIDE], low[SIDE], high[SIDE];
    for (int i = 0; i < SIDE; i++) {
        x[i] = 2.5 * i;
        y[i] = 400.0 * i / (SIDE - 1);
        px[i] = 3 * i;
        py[i] = 0.02 * exp(-0.01 * px[i]);
        low[i] = py[i] - 0.001, high[i] = py[i] + 0.001;
        for (int j = 0; j < SIDE; j++) value[i * SIDE + j] = i == 30 ? NAN : sin(0.1 * i) * cos(0.2 * j);
    }
    const double sx[] = {3, 3, 160, 60, 9}, sy[] = {0.0195, 0.0193, 0.004, 0.0109, 0.018};
    const wcut_report_field field = {"deviation", "mm", WCUT_REPORT_SCALE_DIVERGING, 0.25, d->distance};
    const wcut_report_shape shape = {
        .name = "scan", .vertex_count = CLOUD, .vertex = d->point, .field_count = 1, .field = &field};
    /* a small mesh beside it, with a field of which nothing was measured */
    enum { PATCH = 20 };
    wcut_vec3 corner[PATCH * PATCH];
    double height[PATCH * PATCH], nothing[PATCH * PATCH];
    int triangle[6 * (PATCH - 1) * (PATCH - 1)], corners = 0;
    for (int i = 0; i < PATCH * PATCH; i++) {
        height[i] = 0.001 * i;
        nothing[i] = NAN;
        corner[i] = (wcut_vec3){20.0 * (i % PATCH), 60.0 * (i / PATCH), 150};
        if (i % PATCH == PATCH - 1 || i / PATCH == PATCH - 1) continue;
        const int quad[] = {i, i + 1, i + PATCH, i + 1, i + PATCH + 1, i + PATCH};
        for (int k = 0; k < 6; k++) triangle[corners++] = quad[k];
    }
    const wcut_report_field patch_field[] = {{"height", "mm", WCUT_REPORT_SCALE_SEQUENTIAL, 0, height},
                                             {"unknown", "", WCUT_REPORT_SCALE_DIVERGING, 0, nothing}};
    const wcut_report_shape shapes[] = {shape,
                                        {.name = "patch",
                                         .vertex_count = PATCH * PATCH,
                                         .vertex = corner,
                                         .triangle_count = corners / 3,
                                         .triangle = triangle,
                                         .field_count = 2,
                                         .field = patch_field}};
    const wcut_report_scene scene = {.title = "Deviation",
                                     .note = "Positive: material left above the simulated face.",
                                     .block_size = {400, 1200, 300},
                                     .shape_count = 2,
                                     .shape = shapes};
    const wcut_report_series series[] = {{"fit", WCUT_REPORT_MARK_LINE, SIDE, {px, NULL}, py, low, high},
                                         {"test cuts", WCUT_REPORT_MARK_POINTS, 5, {sx, NULL}, sy, NULL, NULL}};
    const wcut_report_chart chart = {.title = "Force law",
                                     .x_label = {"effective heat"},
                                     .x_unit = {"J/m\xc2\xb2"},
                                     .y_label = "force",
                                     .y_unit = "N/mm",
                                     .series_count = 2,
                                     .series = series};
    static const char *const band_label[] = {"tension", "angle"};
    static const int band[] = {0, 10};
    const wcut_report_map map = {"Residual before",
                                 NULL,
                                 "time",
                                 "s",
                                 "position along the wire",
                                 "mm",
                                 "residual",
                                 "N",
                                 SIDE,
                                 SIDE,
                                 x,
                                 y,
                                 value,
                                 WCUT_REPORT_SCALE_DIVERGING,
                                 1.5,
                                 true,
                                 2,
                                 band,
                                 band_label};
    const wcut_report_section section = {
        "Evidence", "Where recording and prediction differ.", 1, 1, 0, &chart, &map, NULL, NULL};
    const wcut_report report = {.verb = "compare",
                                .title = "mould 7, lower half",
                                .tone = WCUT_REPORT_TONE_WARNING,
                                .verdict =
                                    "38 % of the face lies outside \xc2\xb1"
                                    "0.25 mm.",
                                .scene = &scene,
                                .section_count = 1,
                                .section = &section};
    return wcut_report_write(&report, path, error);
}

/* 100 cases: a from 0 to 99, b its square, a word; hostile names and links that lead nowhere */
static inline wcut_status pages_write_cases(const char *path, wcut_error *error) {
    enum { ROWS = 100 };
    static double a[ROWS], b[ROWS];
    static int number[ROWS];
    static const char *word[ROWS], *link[ROWS];
    static const int best[] = {99, 98};
    for (int r = 0; r < ROWS; r++) {
        a[r] = r;
        b[r] = r == 7 ? (double)NAN : (double)r * r;
        number[r] = 2 * r;
        word[r] = r % 2 ? "odd" : HOSTILE;
        link[r] = r == 5 ? NULL : "cases/00/report.html";
    }
    const wcut_report_column column[] = {{"/a" HOSTILE, "mm", a, NULL}, {"b", "", b, NULL}, {"word", NULL, NULL, word}};
    const wcut_report_cases cases = {ROWS, 3, 1, column, number, link, 1, true, 2, best, NULL};
    const wcut_report_section section = {.title = "Cases", .cases = &cases};
    const wcut_report report = {
        .verb = "sweep", .title = HOSTILE, .verdict = "100 cases.", .section_count = 1, .section = &section};
    return wcut_report_write(&report, path, error);
}

#endif
