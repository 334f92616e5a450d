/* What a comparison's page says of the scan itself: its points, how it was moved, what it was made into. */
#include "io/report/report_scan.h"

#include <math.h>
#include <wirecut/angle.h>

enum { HOLES_MAX = 20 };

/* `count` columns of `rows` numbers each, behind one of texts; NULL without memory */
static wcut_report_column *take_report_columns(wcut_page_memory *m, int count, int rows, double **number) {
    wcut_report_column *column = wcut_page_take(m, (size_t)count + 1, sizeof *column);
    *number = wcut_page_take(m, (size_t)count * (size_t)rows, sizeof **number);
    if (m->failed) return NULL;
    for (int k = 0; k < count; k++) column[k + 1].number = *number + (size_t)k * (size_t)rows;
    return column;
}

/* ---- points ---- */

static wcut_report_table point_table(wcut_page_memory *m, const wcut_compared *c) {
    static const char *const name[] = {"compared",
                                       "removed as duplicates",
                                       "removed as isolated",
                                       "removed as outliers",
                                       "removed by thinning",
                                       "inside the face",
                                       "at its border",
                                       "outside, beyond its border",
                                       "with two equally near places"};
    enum { ROWS = WCUT_REMOVAL_COUNT + WCUT_PLACE_COUNT };

    /* counts of the cleaning, then of the comparison */
    double *count;
    wcut_report_column *column = take_report_columns(m, 1, ROWS, &count);
    if (!column) return (wcut_report_table){0};
    for (int k = 0; k < WCUT_REMOVAL_COUNT; k++) count[k] = c->removed[k];
    for (int k = 0; k < WCUT_PLACE_COUNT; k++) count[WCUT_REMOVAL_COUNT + k] = c->found->place[k];

    /* two columns: what happened to the points, and how many */
    column[0] = (wcut_report_column){.label = "points", .text = name};
    column[1].label = "count";

    return (wcut_report_table){.title = "Use of the points", .rows = ROWS, .columns = 2, .column = column};
}

/* ---- registration ---- */

/* value, standard error, and the rows of the covariance */
static wcut_report_table motion_table(wcut_page_memory *m, const wcut_registration *r) {
    static const char *const name[] = {"shift along x",    "shift along y",    "shift along z",
                                       "rotation about x", "rotation about y", "rotation about z"};
    static const char *const label[] = {"value", "standard error"};
    static const char *const known[] = {"mm", "deg"}, *const unknown[] = {"mm, not determined by the data",
                                                                          "deg, not determined by the data"};

    /* units, which also say what the data did not determine */
    double *number;
    wcut_report_column *column = take_report_columns(m, 3, WCUT_DOF_COUNT, &number);
    const char **unit = wcut_page_take(m, WCUT_DOF_COUNT, sizeof *unit);
    if (m->failed) return (wcut_report_table){0};

    /* in the unit of each, mm or deg */
    for (int k = 0; k < WCUT_DOF_COUNT; k++) {
        const double to = k < 3 ? 1 : WCUT_DEG_PER_RAD;
        number[k] = r->parameter[k] * to;
        number[WCUT_DOF_COUNT + k] = sqrt(r->covariance[k * WCUT_DOF_COUNT + k]) * to;
        unit[k] = (r->determined[k] ? known : unknown)[k >= 3];
    }

    /* names, values with their errors, units */
    column[0] = (wcut_report_column){.label = "parameter", .text = name};
    for (int k = 0; k < 2; k++) column[k + 1].label = label[k];
    column[3] = (wcut_report_column){.label = "unit", .text = unit};
    return (wcut_report_table){.title = "Motion of the scan",
                               .note =
                                   "Rotation about the pivot; standard errors as if the errors of points were "
                                   "independent.",
                               .rows = WCUT_DOF_COUNT,
                               .columns = 4,
                               .column = column};
}

static wcut_report_table covariance_table(wcut_page_memory *m, const wcut_registration *r) {
    static const char *const name[] = {"tx, mm", "ty, mm", "tz, mm", "rx, deg", "ry, deg", "rz, deg"};
    double *number;
    wcut_report_column *column = take_report_columns(m, WCUT_DOF_COUNT, WCUT_DOF_COUNT, &number);
    if (!column) return (wcut_report_table){0};
    column[0] = (wcut_report_column){.label = "parameter", .text = name};
    for (int i = 0; i < WCUT_DOF_COUNT; i++) {
        column[i + 1].label = name[i];
        for (int j = 0; j < WCUT_DOF_COUNT; j++)
            number[i * WCUT_DOF_COUNT + j] =
                r->covariance[j * WCUT_DOF_COUNT + i] * (i < 3 ? 1 : WCUT_DEG_PER_RAD) * (j < 3 ? 1 : WCUT_DEG_PER_RAD);
    }
    return (wcut_report_table){.title = "Covariance of the motion",
                               .note = "In products of the units; 0 for what was locked or not determined by the data.",
                               .rows = WCUT_DOF_COUNT,
                               .columns = WCUT_DOF_COUNT + 1,
                               .column = column};
}

/* to ten digits, as texts: a table shows numbers to four */
static wcut_report_table matrix_table(wcut_page_memory *m, const wcut_registration *r) {
    enum { SIDE = 4 };
    static const char *const label[] = {"x", "y", "z", "shift"};
    wcut_report_column *column = wcut_page_take(m, SIDE, sizeof *column);
    const char **text = wcut_page_take(m, (size_t)SIDE * SIDE, sizeof *text);
    if (m->failed) return (wcut_report_table){0};
    for (size_t i = 0; i < SIDE; i++) {
        column[i] = (wcut_report_column){.label = label[i], .text = text + SIDE * i};
        for (size_t j = 0; j < SIDE; j++) text[SIDE * i + j] = wcut_page_text(m, "%.10g", r->matrix[SIDE * j + i]);
    }
    return (wcut_report_table){.title = "Matrix, scan to block, mm", .rows = SIDE, .columns = SIDE, .column = column};
}

static wcut_report_table datum_table(wcut_page_memory *m, const wcut_compared *c) {
    /* columns: place, offset and distance of each datum */
    static const char *const label[] = {"x", "y", "z", "dx", "dy", "dz", "distance"};

    /* a row for each datum */
    double *number;
    wcut_report_column *column = take_report_columns(m, 7, c->datums, &number);
    const char **name = wcut_page_take(m, (size_t)c->datums, sizeof *name);
    if (!column || !name) return (wcut_report_table){0};

    /* where the datum came to lie, and what is left */
    for (int k = 0; k < c->datums; k++) {
        const wcut_datum_residual *d = &c->datum[k];
        const double figure[7] = {d->moved.x,  d->moved.y,  d->moved.z, d->offset.x,
                                  d->offset.y, d->offset.z, d->distance};
        name[k] = wcut_page_text(m, "%s %d", d->is_face ? "face" : "point", d->datum + 1);
        for (size_t f = 0; f < 7; f++) number[f * (size_t)c->datums + (size_t)k] = figure[f];
    }

    column[0] = (wcut_report_column){.label = "datum", .text = name};
    for (int f = 0; f < 7; f++) column[f + 1].label = label[f], column[f + 1].unit = "mm";
    return (wcut_report_table){.title = "Datums",
                               .note =
                                   "Each datum of the scan after registration, and its remaining distance to the "
                                   "block's datum; of a face along its normal.",
                               .rows = c->datums,
                               .columns = 8,
                               .column = column};
}

bool wcut_report_fill_registration(wcut_page_memory *m, const wcut_compared *c, wcut_report_section *section) {
    /* the points are told even where nothing was moved */
    const wcut_registration *r = c->registration;
    const bool moved = r->method != WCUT_REGISTRATION_METHOD_NONE;
    wcut_report_table *table = wcut_page_take(m, 5, sizeof *table);
    if (!table) return false;
    table[0] = point_table(m, c);
    *section = (wcut_report_section){.title = "Points", .table_count = 1, .table = table};
    if (!moved) return !m->failed;

    /* the motion, how certain it is, and its matrix */
    table[1] = motion_table(m, r);
    table[2] = covariance_table(m, r);
    table[3] = matrix_table(m, r);
    section->title = "Points and registration";
    section->note = wcut_page_text(m,
                                   "Overlap %.3g %%, RMS of the points used %.4g mm, before %.4g mm; uncertainty of "
                                   "the points from the registration \xc2\xb1 %.2g mm (standard error, RMS).%s",
                                   100 * r->overlap, r->rms, r->rms_before, r->doubt,
                                   r->converged ? "" : " The fit stopped before it had converged.");
    section->table_count = 4;
    if (c->datums > 0) table[section->table_count++] = datum_table(m, c);

    return !m->failed;
}

/* ---- reconstruction ---- */

static wcut_report_table both_table(wcut_page_memory *m, const wcut_compared *c) {
    /* figures of both directions side by side */
    static const char *const name[] = {
        "vertices",       "mean",   "median",  "standard deviation", "root mean square", "mean |d|", "1 % are below",
        "99 % are below", "lowest", "highest", "largest (Hausdorff)"};
    static const char *const unit[] = {"", "mm", "mm", "mm", "mm", "mm", "mm", "mm", "mm", "mm", "mm"};
    enum { ROWS = sizeof name / sizeof *name };

    const wcut_statistics *const side[] = {c->to_face, c->to_scan};
    double *number;
    wcut_report_column *column = take_report_columns(m, 3, ROWS, &number);
    if (!column) return (wcut_report_table){0};

    /* the same figures from both sides */
    for (int k = 0; k < 2; k++) {
        const wcut_statistics *s = side[k];
        const double figure[ROWS] = {s->count, s->mean, s->median, s->std, s->rms,      s->mae,
                                     s->p01,   s->p99,  s->min,    s->max, s->hausdorff};
        for (int f = 0; f < ROWS; f++) number[k * ROWS + f] = figure[f];
    }

    /* names, one column for each direction, units */
    column[0] = (wcut_report_column){.label = "figure", .text = name};
    column[1].label = "scan to face", column[2].label = "face to scan";
    column[3] = (wcut_report_column){.label = "unit", .text = unit};
    return (wcut_report_table){
        .title = "Deviation of the reconstructed scan",
        .note = "From the scan's mesh to the face, and from the face to the mesh; positive: material left.",
        .rows = ROWS,
        .columns = 4,
        .column = column};
}

static wcut_report_table hole_table(wcut_page_memory *m, const wcut_reconstruction *r) {
    /* columns: where, and how large */
    static const char *const label[] = {"x", "y", "z", "area"};
    static const char *const unit[] = {"mm", "mm", "mm", "mm\xc2\xb2"};

    const int rows = r->hole_count < HOLES_MAX ? r->hole_count : HOLES_MAX;
    double *number;
    wcut_report_column *column = take_report_columns(m, 4, rows, &number);
    const char **kind = wcut_page_take(m, (size_t)rows, sizeof *kind);
    if (m->failed) return (wcut_report_table){0};

    /* the largest holes come first */
    for (int k = 0; k < rows; k++) {
        const wcut_hole *h = &r->hole[k];
        const double figure[] = {h->centre.x, h->centre.y, h->centre.z, h->area};
        for (int f = 0; f < 4; f++) number[f * rows + k] = figure[f];
        kind[k] = h->open ? "at the border" : "within the scan";
    }

    /* where a hole is, its centre and its area */
    column[0] = (wcut_report_column){.label = "where", .text = kind};
    for (int f = 0; f < 4; f++) column[f + 1].label = label[f], column[f + 1].unit = unit[f];
    return (wcut_report_table){.title = "Holes in the scan",
                               .note = "The largest ones; they are not filled.",
                               .rows = rows,
                               .columns = 5,
                               .column = column};
}

bool wcut_report_fill_reconstruction(wcut_page_memory *m, const wcut_compared *c, wcut_report_section *section) {
    const wcut_reconstruction *r = c->reconstruction;
    wcut_report_table *table = wcut_page_take(m, 2, sizeof *table);
    if (!table) return false;
    table[0] = both_table(m, c);
    const bool holed = r->hole_count > 0;
    if (holed) table[1] = hole_table(m, r);
    const char *note =
        wcut_page_text(m,
                       "%d vertices %.3g mm apart, smoothed over %.3g mm; every vertex is within %.3g mm "
                       "of a point of the scan. Face without points: %.5g mm\xc2\xb2.",
                       r->mesh->vertex_count, r->spacing, r->smoothing, r->farthest, r->unmeasured_area);
    *section =
        (wcut_report_section){.title = "Reconstruction", .note = note, .table_count = holed ? 2 : 1, .table = table};
    return !m->failed;
}
