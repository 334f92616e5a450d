/* A comparison of a scan with a face, from the first point to the last figure. */
#include <wirecut/compare.h>

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/sort.h"
#include "io/scan/compare_state.h"

enum { MANY = 100000 };                       /* queries from which a projection is worth preparing */
enum { GLANCE = 20000 };                      /* points that set the colours, the support and the first warnings */
enum { HOLD = 500000, HOLD_WHOLE = 2000000 }; /* points held by default */

wcut_compare_options wcut_compare_options_default(void) {
    wcut_compare_options o = {.distance = WCUT_COMPARE_DISTANCE_SURFACE,
                              .chord_tolerance = 0.01,
                              .clean = wcut_clean_options_default(),
                              .method = WCUT_REGISTRATION_METHOD_NONE,
                              .registration = wcut_registration_options_default(),
                              .bands = 4,
                              .band = {0.25, 0.5, 1, 2},
                              .share = 0.95,
                              .threads = 1};
    o.clean.duplicate = -1, o.clean.neighbours = 0;
    return o;
}

wcut_status wcut_compare_fail(wcut_status status, const char *step, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    if (error && error->text[0] && error->status == status) return status;
    return wcut_fail(error, status, "%s: %s", wcut_quote(name, step, WCUT_LABEL_MAX, 1), wcut_status_text(status));
}

/* ---- what is asked for ---- */

static wcut_status refuse_compare_option(wcut_error *error, const char *option, double found, const char *expected) {
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found %g, expected %s", option, found, expected);
}

static bool is_in(double value, double low, double high) { return value >= low && value <= high; }

/* an option, its range, and what its range is called */
typedef struct number {
    const char *name, *expected;
    double value, low, high;
} number;

static wcut_status check_compare_numbers(const wcut_compare_options *o, wcut_error *error) {
    /* each option with its range; the first one outside is named */
    const number all[] = {
        {.name = "unit", "a wcut_length_unit", o->unit, 0, WCUT_LENGTH_UNIT_COUNT - 1},
        {.name = "reference_unit", "a wcut_length_unit", o->reference_unit, 0, WCUT_LENGTH_UNIT_COUNT - 1},
        {.name = "distance", "a wcut_compare_distance", o->distance, 0, WCUT_COMPARE_DISTANCE_COUNT - 1},
        {.name = "chord_tolerance", "1e-6 to 1e6 mm", o->chord_tolerance, 1e-6, 1e6},
        {.name = "hold", "0 or more points", o->hold, 0, INT_MAX},
        {.name = "method", "a wcut_registration_method", o->method, 0, WCUT_REGISTRATION_METHOD_FIT},
        {.name = "bands", "0 to 7", o->bands, 0, WCUT_BANDS_MAX - 1},
        {.name = "tolerance", "0 to 1e6 mm", o->tolerance, 0, 1e6},
        {.name = "share", "0 to 1", o->share, 0, 1},
        {.name = "normals", "0, or 2 to 128 neighbours", o->normals, o->normals == 1 ? 2 : 0, 128},
        {.name = "support", "0 to 1e6 mm", o->support, 0, 1e6},
        {.name = "threads", "1 or more", o->threads, 1, INT_MAX},
    };

    /* the message names the option, its value and the range */
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        if (!is_in(all[k].value, all[k].low, all[k].high))
            return refuse_compare_option(error, all[k].name, all[k].value, all[k].expected);
    return WCUT_OK;
}

static wcut_status check_compare_options(const wcut_compare_options *o, wcut_error *error) {
    const wcut_status status = check_compare_numbers(o, error);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < o->bands; k++)
        if (!is_in(o->band[k], 1e-9, 1e6)) return refuse_compare_option(error, "band", o->band[k], "1e-9 to 1e6 mm");
    if ((o->method == WCUT_REGISTRATION_METHOD_DATUM) == (o->datums != NULL)) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "datums: expected a file and the method datum together");
}

static wcut_status check_reference(const wcut_compare_reference *r, wcut_error *error) {
    if (r && !r->history == !r->setup &&
        (r->path != NULL) + (r->history != NULL) + (r->mesh != NULL) + (r->surface != NULL) == 1)
        return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT,
                     "reference: expected one of a path, a history with its setup, a mesh and a surface");
}

static wcut_status check_scans(int scans, const wcut_compare_scan *scan, wcut_error *error) {
    if (scans < 1 || !scan) return wcut_fail(error, WCUT_BAD_ARGUMENT, "scans: found %d, expected 1 or more", scans);
    for (int k = 0; k < scans; k++) {
        if (scan[k].path) continue;
        if (scan[k].count < 1 || !scan[k].point)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "scan %d: found %d points, expected a file or 1 or more", k + 1,
                             scan[k].count);
        for (int i = 0; i < scan[k].count; i++) {
            const wcut_vec3 p = scan[k].point[i];
            if (!(fabs(p.x) <= 1e12 && fabs(p.y) <= 1e12 && fabs(p.z) <= 1e12))
                return wcut_fail(error, WCUT_BAD_ARGUMENT,
                                 "scan %d: point %d: found (%g, %g, %g), expected numbers up to 1e12 mm", k + 1, i + 1,
                                 p.x, p.y, p.z);
        }
    }
    return WCUT_OK;
}

/* keep the list in order, each tolerance once; there is room for one more than may be listed, that of the gate */
static void add_band(wcut_compare_options *o, double band) {
    int at = o->bands;
    for (int k = 0; k < o->bands; k++)
        if (o->band[k] == band) return;
    for (; at > 0 && o->band[at - 1] > band; at--) o->band[at] = o->band[at - 1];
    o->band[at] = band;
    o->bands++;
}

/* what the options leave to be derived */
static wcut_compare_options complete(const wcut_compare_options *options) {
    wcut_compare_options o = *options;
    o.bands = 0;
    for (int k = 0; k < options->bands; k++) add_band(&o, options->band[k]);
    if (o.tolerance > 0) add_band(&o, o.tolerance);
    if (o.distance == WCUT_COMPARE_DISTANCE_RECONSTRUCTION) o.reconstruct = true;
    if (o.hold == 0) o.hold = o.reconstruct ? HOLD_WHOLE : HOLD;
    return o;
}

/* ---- what is compared ---- */

static const char *scan_name(const wcut_comparing *c) { return c->cloud.scan[0].name; }

/* a point, or a row of them, says nothing of a face */
static wcut_status check_span(const wcut_comparing *c, wcut_error *error) {
    static const char *const where[] = {"in one place", "on one line"};
    char name[WCUT_QUOTE_SIZE];
    int span;
    const wcut_status status = wcut_cloud_span(c->cloud.count, c->cloud.point, &span);
    if (status != WCUT_OK) return wcut_compare_fail(status, scan_name(c), error);
    if (span == 2) return WCUT_OK;
    return wcut_fail(error, WCUT_DEGENERATE, "%s: found %d points %s, expected a scan of a face",
                     wcut_quote(name, scan_name(c), WCUT_LABEL_MAX, 1),
                     c->cloud.held ? c->cloud.count : c->cloud.removed[WCUT_REMOVAL_KEPT], where[span]);
}

static void warn_of_unit(const wcut_comparing *c) {
    const wcut_compare_face *f = &c->face;
    const wcut_vec3 size = {f->high.x - f->low.x, f->high.y - f->low.y, fmax(f->high.z - f->low.z, 1)};
    wcut_cloud_unit fit;
    if (!c->watch.warn || wcut_cloud_unit_eval(c->cloud.low, c->cloud.high, size, &fit) != WCUT_OK || fit.factor == 1)
        return;

    /* by how much, and which factor would do */
    char text[2 * WCUT_QUOTE_SIZE], name[WCUT_QUOTE_SIZE];
    wcut_quote(name, scan_name(c), WCUT_LABEL_MAX, 1);
    if (fit.factor > 0)
        snprintf(text, sizeof text,
                 "%s: warning: the scan is %.3g times as large as the face; multiplied by %.5g it would fit: another "
                 "unit of the scan or of the mesh?",
                 name, fit.ratio, fit.factor);
    else
        snprintf(text, sizeof text, "%s: warning: the scan is %.3g times as large as the face", name, fit.ratio);
    c->watch.warn(text, c->watch.context);
}

/* An even choice of the points held. */
static int glance(const wcut_comparing *c, wcut_vec3 *point) {
    const int count = c->cloud.count, step = count > GLANCE ? count / GLANCE : 1;
    int taken = 0;
    for (int k = 0; k < count && taken < GLANCE; k += step) point[taken++] = c->cloud.point[k];
    return taken;
}

/* [mm] the distance of neighbouring points, if they cover the face evenly */
static double spacing_of(const wcut_comparing *c) {
    const int count = c->cloud.held ? c->cloud.count : c->cloud.removed[WCUT_REMOVAL_KEPT];
    return sqrt(c->face.plan / fmax(count, 1));
}

/* ---- what comes before the points ---- */

/* The strongest colour is for the deviation that one point in a hundred exceeds, two digits of it; a scan of which no
   point is over the face is refused before it is read on. */
static wcut_status look(wcut_comparing *c, int *counted) {
    /* GLANCE points spread over the scan, as registered, with their distances */
    wcut_vec3 *point = wcut_alloc(GLANCE, sizeof *point);
    wcut_deviation *d = wcut_alloc(GLANCE, sizeof *d);
    double *size = wcut_alloc(GLANCE, sizeof *size);
    wcut_status status = point && d && size ? WCUT_OK : WCUT_NO_MEMORY;
    const int count = status == WCUT_OK ? glance(c, point) : 0;
    if (status == WCUT_OK) status = wcut_registration_move(&c->registration, count, point, NULL);
    if (status == WCUT_OK) status = wcut_compare_face_locate(&c->face, count, point, c->options.threads, d, NULL);

    /* the sizes of those that count, in order */
    *counted = 0;
    for (int k = 0; k < count && status == WCUT_OK; k++)
        if (d[k].place <= WCUT_PLACE_BORDER) size[(*counted)++] = fabs(d[k].distance);

    /* the limit of the colours: the 99 % quantile, rounded up to two digits */
    if (*counted > 0) {
        wcut_sort(*counted, size);
        const double max = fmax(size[(int)(0.99 * (*counted - 1))], 1e-3), unit = pow(10, floor(log10(max)) - 1);
        c->limit = ceil(max / unit) * unit;
    }
    wcut_free(size);
    wcut_free(d);
    wcut_free(point);
    return status;
}

wcut_status wcut_compare_refuse_elsewhere(const wcut_comparing *comparing, wcut_error *error) {
    const wcut_comparing *c = comparing;
    char name[WCUT_QUOTE_SIZE];
    const wcut_vec3 *l = &c->cloud.low, *h = &c->cloud.high, *from = &c->face.low, *to = &c->face.high;
    return wcut_fail(error, WCUT_BAD_FORMAT,
                     "%s: found points from (%.6g, %.6g, %.6g) to (%.6g, %.6g, %.6g) mm, none of them over the face, "
                     "expected some in (%.6g, %.6g, %.6g) to (%.6g, %.6g, %.6g) mm: another unit, or a registration?",
                     wcut_quote(name, scan_name(c), WCUT_LABEL_MAX, 1), l->x, l->y, l->z, h->x, h->y, h->z, from->x,
                     from->y, from->z, to->x, to->y, to->z);
}

static wcut_status begin_summary(wcut_comparing *c, int which) {
    wcut_deviation_summary_options options = wcut_deviation_summary_options_default();
    options.low = c->face.low, options.high = c->face.high;
    options.bands = c->options.bands;
    memcpy(options.band, c->options.band, sizeof options.band);
    return wcut_deviation_summary_create(&options, c->face.face, &c->summary[which]);
}

/* a face of too many zones: a vertex far from the others, or another unit */
static wcut_status refuse_zones(const wcut_comparing *c, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    const wcut_vec3 *low = &c->face.low, *high = &c->face.high;
    return wcut_fail(error, WCUT_BAD_FORMAT,
                     "%s: found a face from (%.6g, %.6g, %.6g) to (%.6g, %.6g, %.6g) mm, too large for its zones: a "
                     "stray vertex, or another unit of the mesh?",
                     wcut_quote(name, c->face.name, WCUT_LABEL_MAX, 1), low->x, low->y, low->z, high->x, high->y,
                     high->z);
}

static wcut_status make_map(wcut_comparing *c) {
    wcut_status status = WCUT_OK;
    c->mesh = c->face.mesh;
    if (c->face.face) {
        status = wcut_face_mesh(c->face.face, &c->grid);
        if (status == WCUT_OK) status = wcut_face_map_create(c->face.face, &c->map);
        c->mesh = c->grid;
    }
    if (status != WCUT_OK) return status;

    /* a value for each vertex, and what it is made from */
    const size_t count = (size_t)c->mesh->vertex_count;
    c->value = wcut_alloc(count, sizeof *c->value);
    c->present = wcut_alloc(count, 1);
    c->sum = wcut_alloc(c->map ? 1 : count, sizeof *c->sum);
    c->weight = wcut_alloc(c->map ? 1 : count, sizeof *c->weight);
    return c->value && c->present && c->sum && c->weight ? WCUT_OK : WCUT_NO_MEMORY;
}

/* the points' normals, where they are wanted: of what is held, as registered, to the side of the removed half */
static wcut_status find_normals(wcut_comparing *c, wcut_error *error) {
    /* without held points there is nothing to fit planes to */
    const size_t count = (size_t)c->cloud.count;
    wcut_normals_options options = wcut_normals_options_default();
    options.neighbours = c->options.normals;
    if (c->options.normals == 0) return WCUT_OK;
    if (!c->cloud.held)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "normals: found %d points, expected to hold at least as many",
                         c->cloud.removed[WCUT_REMOVAL_KEPT]);

    /* of the points as registered */
    c->normal = wcut_alloc(count, sizeof *c->normal);
    wcut_vec3 *moved = wcut_alloc(count, sizeof *moved);
    wcut_status status = c->normal && moved ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        memcpy(moved, c->cloud.point, count * sizeof *moved);
        status = wcut_registration_move(&c->registration, c->cloud.count, moved, NULL);
    }
    if (status == WCUT_OK)
        status = wcut_cloud_normals(c->cloud.count, moved, &options, c->options.threads, c->normal, NULL);
    wcut_free(moved);
    return status == WCUT_OK ? WCUT_OK : wcut_compare_fail(status, "finding the points' normals", error);
}

/* room for what is known of each point held */
static wcut_status make_point_rows(wcut_comparing *c) {
    const size_t count = (size_t)c->cloud.count;
    c->deviation = wcut_alloc(count, sizeof *c->deviation);
    if (c->options.reconstruct) c->foot = wcut_alloc(count, sizeof *c->foot);
    if (c->options.feet) c->row = wcut_alloc(count, sizeof *c->row);
    const bool whole = c->deviation && (c->foot || !c->options.reconstruct) && (c->row || !c->options.feet);
    return whole ? WCUT_OK : WCUT_NO_MEMORY;
}

static wcut_status prepare_comparison(wcut_comparing *c, wcut_error *error) {
    /* the support of a point on the face comes from the spacing of the scan */
    int counted = 0;
    wcut_status status = look(c, &counted);
    if (status == WCUT_OK && counted == 0) return wcut_compare_refuse_elsewhere(c, error);
    c->support = c->options.support > 0 ? c->options.support : fmax(1.5, 2.5 * spacing_of(c));

    /* what the figures are gathered in */
    if (status == WCUT_OK) status = begin_summary(c, WCUT_COMPARE_FOUND);
    if (status == WCUT_BAD_ARGUMENT) return refuse_zones(c, error);
    if (status == WCUT_OK && c->options.method != WCUT_REGISTRATION_METHOD_NONE)
        status = begin_summary(c, WCUT_COMPARE_UNMOVED);
    if (status == WCUT_OK) status = make_map(c);
    if (status == WCUT_OK) status = make_point_rows(c);

    /* the file that is written on the way */
    if (status == WCUT_OK && c->results) {
        const char *path = wcut_results_path(c->results, "deviation.ply");
        status =
            path ? wcut_deviation_stream_create(path, c->limit, c->normal != NULL, &c->points, error) : WCUT_NO_MEMORY;
        wcut_results_reword(c->results, error);
    }
    return status == WCUT_OK ? WCUT_OK : wcut_compare_fail(status, "compare", error);
}

/* ---- the end ---- */

static void fill_compared(wcut_comparing *c, const wcut_deviation_summary_result *found,
                          const wcut_deviation_summary_result *unmoved, double unmeasured) {
    static const char *const distance[] = {"surface", "mesh", "reconstruction"};
    const wcut_compare_options *o = &c->options;
    wcut_compared *to = &c->result.compared;

    /* names, options and figures: pointers into the comparison, which outlives them */
    *to = (wcut_compared){.reference = c->face.name,
                          .distance = distance[c->face.distance],
                          .part = o->part,
                          .inspector = o->inspector,
                          .instrument = o->instrument,
                          .date = o->date,
                          .datum_file = o->datums,
                          .cleaning = c->cloud.cleaned ? &o->clean : NULL,
                          .scans = c->cloud.parts,
                          .scan = c->cloud.scan,
                          .registration = &c->registration,
                          .datums = c->datums,
                          .datum = c->datum,
                          .found = found,
                          .unmoved = unmoved ? unmoved : found,
                          .face_to_scan = &c->face_to_scan,
                          .resolution = sqrt(3) * c->cloud.spacing,
                          .kerf = c->face.kerf,
                          .has_kerf = c->face.face != NULL,
                          .unmeasured = unmeasured,
                          .support = c->support,
                          .tolerance = o->tolerance,
                          .share = o->share,
                          .within = 1};
    memcpy(to->removed, c->cloud.removed, sizeof to->removed);

    /* the gate */
    for (int k = 0; k < found->statistics.bands; k++)
        if (found->statistics.band[k] == o->tolerance) to->within = found->statistics.within[k] >= o->share;

    /* zones of the user, each a gate of its own */
    to->zones_file = o->zones;
    to->survey = wcut_survey_eval(c->survey);

    /* the scan as a mesh, where one was made */
    if (!c->reconstruction) return;
    to->reconstruction_method = "field";
    to->reconstruction = c->reconstruction;
    to->to_scan = &c->to_scan, to->to_face = &c->to_face;
}

static void fill_compare_page(wcut_comparing *c) {
    static const char *const unit[WCUT_LENGTH_UNIT_COUNT] = {"mm", "cm", "m", "inch", "ft", "dm", "um"};
    const wcut_compare_face *f = &c->face;

    /* the page shows the arrays of the comparison: no copies */
    c->result.page = (wcut_report_compare){.compared = &c->result.compared,
                                           .title = f->job ? f->job->name : NULL,
                                           .reference_sha256 = f->hash[0] ? f->hash : NULL,
                                           .face = f->face,
                                           .stations = f->history ? f->history->stations : 0,
                                           .mount_a = f->mount_a,
                                           .mount_b = f->mount_b,
                                           .mesh = c->mesh,
                                           .value = c->value,
                                           .present = c->present,
                                           .points = c->cloud.count,
                                           .point = c->cloud.point,
                                           .deviation = c->deviation,
                                           .spacing = c->cloud.spacing,
                                           .unit = unit[c->options.unit],
                                           .border = f->options.border};

    /* what the files need beside the page */
    c->result.row = c->row, c->result.normal = c->normal, c->result.limit = c->limit;
}

/* everything that is told, in one place */
static wcut_status conclude_comparison(wcut_comparing *c, wcut_error *error) {
    /* way back from face to scan, then the figures of both positions of the scan */
    double unmeasured = 0;
    wcut_status status = wcut_compare_measure_back(c, &unmeasured, error);
    if (status != WCUT_OK) return status;
    const wcut_deviation_summary_result *found = NULL, *unmoved = NULL;
    status = wcut_deviation_summary_eval(c->summary[WCUT_COMPARE_FOUND], &found);
    if (status == WCUT_OK && c->summary[WCUT_COMPARE_UNMOVED])
        status = wcut_deviation_summary_eval(c->summary[WCUT_COMPARE_UNMOVED], &unmoved);
    if (status != WCUT_OK) return wcut_compare_fail(status, "compare", error);
    if (found->statistics.count == 0) return wcut_compare_refuse_elsewhere(c, error);

    /* the structs that deviation.json and the page are written from */
    fill_compared(c, found, unmoved, unmeasured);
    fill_compare_page(c);
    if (!c->points) return WCUT_OK;

    /* deviation.ply is whole */
    status = wcut_deviation_stream_commit(c->points, error);
    if (status == WCUT_OK) status = wcut_results_add(c->results, "deviation.ply", error);
    c->result.streamed = status == WCUT_OK;
    if (c->result.streamed) return WCUT_OK;
    wcut_results_reword(c->results, error);
    return wcut_compare_fail(status, "deviation.ply", error);
}

static wcut_status run_steps(wcut_comparing *c, const wcut_compare_reference *reference, int scans,
                             const wcut_compare_scan *scan, wcut_error *error) {
    const wcut_compare_options *o = &c->options;
    const wcut_surface *surface;

    /* the face; a mesh that cannot be reconstructed over is refused before the scan is read */
    wcut_status status = o->zones ? wcut_regions_read(o->zones, &c->regions, error) : WCUT_OK;
    if (status == WCUT_OK && c->regions) {
        status = wcut_survey_create(c->regions, o->bands, o->band, &c->survey);
        if (status != WCUT_OK) return wcut_compare_fail(status, o->zones, error);
    }
    if (status == WCUT_OK) status = wcut_compare_face_load(reference, o, &c->watch, &c->face, error);
    if (status == WCUT_OK && o->reconstruct) status = wcut_compare_face_base(&c->face, &surface, error);
    if (status != WCUT_OK) return status;

    /* the scan */
    c->cloud = (wcut_compare_cloud){.options = o,
                                    .watch = &c->watch,
                                    .parts = scans,
                                    .part = scan,
                                    .hold = o->hold,
                                    .cleaned = wcut_compare_cleans(&o->clean),
                                    .plan = c->face.plan};
    status = wcut_compare_cloud_read(&c->cloud, error);
    if (status == WCUT_OK) status = check_span(c, error);
    if (status != WCUT_OK) return status;
    warn_of_unit(c);

    /* many queries are worth a preparation */
    if (c->face.projection && c->cloud.removed[WCUT_REMOVAL_KEPT] >= MANY) status = wcut_compare_face_prepare(&c->face);
    if (status != WCUT_OK) return wcut_compare_fail(status, "compare", error);

    /* one beside the other */
    status = wcut_compare_register(c, error);
    if (status == WCUT_OK) status = find_normals(c, error);
    if (status == WCUT_OK) status = prepare_comparison(c, error);
    if (status == WCUT_OK) status = wcut_compare_measure(c, error);
    if (status == WCUT_OK) status = wcut_compare_reconstruct(c, error);
    return status == WCUT_OK ? conclude_comparison(c, error) : status;
}

wcut_status wcut_compare_run(const wcut_compare_reference *reference, int scans, const wcut_compare_scan *scan,
                             const wcut_compare_options *options, wcut_results *results,
                             const wcut_compare_watch *watch, wcut_compare_result **result, wcut_error *error) {
    /* check everything before the first file is opened */
    const wcut_compare_options standard = wcut_compare_options_default(), *o = options ? options : &standard;
    wcut_error unread = {0};
    if (!error) error = &unread;
    *error = (wcut_error){0};
    if (!result) return wcut_fail(error, WCUT_BAD_ARGUMENT, "result: found NULL, expected where it goes");
    wcut_status status = check_reference(reference, error);
    if (status == WCUT_OK) status = check_scans(scans, scan, error);
    if (status == WCUT_OK) status = check_compare_options(o, error);
    if (status != WCUT_OK) return status;

    /* the result owns all that was computed; on failure it is destroyed */
    wcut_comparing *c = wcut_alloc(1, sizeof *c);
    if (!c) return wcut_fail(error, WCUT_NO_MEMORY, "compare: %s", wcut_status_text(WCUT_NO_MEMORY));
    c->options = complete(o);
    c->results = results;
    if (watch) c->watch = *watch;
    status = run_steps(c, reference, scans, scan, error);
    if (status == WCUT_OK)
        *result = &c->result;
    else
        wcut_compare_destroy(&c->result);
    return status;
}

void wcut_compare_destroy(wcut_compare_result *result) {
    wcut_comparing *c = (wcut_comparing *)result;
    if (!c) return;
    wcut_survey_destroy(c->survey);
    wcut_regions_destroy(c->regions);
    wcut_deviation_stream_destroy(c->points);
    wcut_reconstruction_destroy(c->reconstruction);
    wcut_face_map_destroy(c->map);
    wcut_mesh_destroy(c->grid);
    for (int k = 0; k < 2; k++) wcut_deviation_summary_destroy(c->summary[k]);
    void *const memory[] = {c->value, c->present, c->sum,  c->weight, c->deviation,
                            c->row,   c->normal,  c->foot, c->datum};
    for (size_t k = 0; k < sizeof memory / sizeof *memory; k++) wcut_free(memory[k]);
    wcut_compare_cloud_clear(&c->cloud);
    wcut_compare_face_clear(&c->face);
    wcut_free(c);
}
