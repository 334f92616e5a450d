/* The scans of a comparison: cleaned and held in memory, or, beyond what is to be held, read a second time. */
#include "compare_scan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <wirecut/cloud_file.h>
#include <wirecut/deviation_file.h>
#include "command.h"
#include "terminal.h"

enum { SAMPLE = 200000, CLEANED_MAX = 20000000 };

/* a cloud that grows: all that was read, until that is too much, then a thinned sample */
typedef struct growth {
    app_scans *scans;
    size_t room;
    wcut_thinning *thinning; /* of a sample, or of what is only to be thinned */
    bool thin_all;           /* what the thinning leaves is all that is compared */
    wcut_vec3 *piece;        /* APP_SCAN_PIECE */
    unsigned char *keep;     /* APP_SCAN_PIECE */
} growth;

static int fail_scan_memory(void) { return app_fail_status(WCUT_NO_MEMORY, "compare", NULL); }

static bool make_scan_room(growth *g, int more) {
    app_scans *s = g->scans;
    const size_t need = (size_t)s->count + (size_t)more;
    if (need <= g->room) return true;
    const size_t room = need > 2 * g->room ? need : 2 * g->room;
    wcut_vec3 *point = realloc(s->point, room * sizeof *point);
    if (!point) return false;
    s->point = point, g->room = room;
    return true;
}

/* append points that a thinning keeps, or all */
static wcut_status append_points(growth *g, int count, const wcut_vec3 *point) {
    app_scans *s = g->scans;
    if (g->thinning) {
        const wcut_status status = wcut_thinning_add(g->thinning, count, point, g->keep);
        if (status != WCUT_OK) return status;
    }
    if (!make_scan_room(g, count)) return WCUT_NO_MEMORY;
    for (int k = 0; k < count; k++)
        if (!g->thinning || g->keep[k]) s->point[s->count++] = point[k];
    return WCUT_OK;
}

/* from now on only a sample is held */
static wcut_status begin_sample(growth *g) {
    app_scans *s = g->scans;
    s->held = false;
    s->spacing = sqrt(s->options.plan / SAMPLE);
    wcut_status status = wcut_thinning_create(s->spacing, &g->thinning);
    if (status != WCUT_OK) return status;
    wcut_vec3 *all = s->point;
    const int count = s->count;
    s->point = NULL, s->count = 0, g->room = 0;
    for (int k = 0; k < count && status == WCUT_OK; k += APP_SCAN_PIECE)
        status = append_points(g, count - k < APP_SCAN_PIECE ? count - k : APP_SCAN_PIECE, all + k);
    free(all);
    return status;
}

/* what is read once only cannot be read a second time */
static bool is_file(const char *path) {
    struct stat about;
    return stat(path, &about) == 0 && S_ISREG(about.st_mode);
}

/* Take in a piece. Gives an exit code. */
static int take_scan(growth *g, const char *path, int count) {
    /* cleaning needs all points at once */
    app_scans *s = g->scans;
    const bool whole = s->options.cleaned || g->thin_all;
    if (whole && count > CLEANED_MAX - s->count)
        return app_fail(APP_BAD_INPUT, "%s: found more than %d points, expected at most that many to be cleaned", path,
                        CLEANED_MAX);

    /* too many to be held: a sample is kept, and the file is read a second time */
    if (!whole && s->held && count > s->options.hold - s->count) {
        for (int k = 0; k < s->files; k++)
            if (!is_file(s->path[k]))
                return app_fail(APP_BAD_INPUT,
                                "%s: found more than %d points, expected a file, which can be read twice, or --hold "
                                "for more",
                                s->path[k], s->options.hold);
        const wcut_status status = begin_sample(g);
        if (status != WCUT_OK) return app_fail_status(status, path, NULL);
    }
    if (!s->held && s->count >= s->options.hold) return APP_DONE; /* a scan of a room: the sample is full */

    const wcut_status status = append_points(g, count, g->piece);

    return status == WCUT_OK ? APP_DONE : app_fail_status(status, path, NULL);
}

static void widen_scan(app_scans *s, int files_before, const wcut_cloud_info *info) {
    if (info->read == 0) return;
    double *low = &s->low.x, *high = &s->high.x;
    const double *l = &info->low.x, *h = &info->high.x;
    for (int c = 0; c < 3; c++) {
        if (files_before == 0 || l[c] < low[c]) low[c] = l[c];
        if (files_before == 0 || h[c] > high[c]) high[c] = h[c];
    }
}

static int read_file(growth *g, int file) {
    /* the scan's unit and columns */
    app_scans *s = g->scans;
    wcut_cloud_options options = wcut_cloud_options_default();
    wcut_cloud_source *source = NULL;
    wcut_error error = {0};
    options.unit = s->options.unit;
    options.columns = s->options.columns;
    wcut_status status = wcut_cloud_source_create(s->path[file], &options, &source, &error);
    int code = status == WCUT_OK ? APP_DONE : app_fail_status(status, NULL, &error), count = 1;

    /* piece by piece, until the file ends or the user stops */
    while (code == APP_DONE && count > 0) {
        status = wcut_cloud_source_next(source, APP_SCAN_PIECE, g->piece, NULL, &count, &error);
        if (status != WCUT_OK)
            code = app_fail_status(status, NULL, &error);
        else if (app_is_interrupted())
            code = app_fail(APP_INTERRUPTED, "%s: interrupted", s->path[file]);
        else
            code = take_scan(g, s->path[file], count);
    }

    /* what the file held, and its hash */
    if (code == APP_DONE) {
        const wcut_cloud_info *info = wcut_cloud_source_info(source);
        if (info->read == 0)
            code = app_fail(APP_BAD_INPUT, "%s: found no point (%d not finite, %d withheld), expected a scan",
                            s->path[file], info->not_finite, info->withheld);
        widen_scan(s, file, info);
        s->scan[file] =
            (wcut_compared_scan){s->path[file], s->hash[file], info->read, info->not_finite, info->withheld};
        status = wcut_source_hash(s->path[file], s->hash[file], &error);
        if (code == APP_DONE && status != WCUT_OK) code = app_fail_status(status, NULL, &error);
    }

    wcut_cloud_source_destroy(source);
    return code;
}

/* ---- cleaning ---- */

static int clean_scans(app_scans *s) {
    unsigned char *removal = malloc(s->count > 0 ? (size_t)s->count : 1);
    wcut_clean_report report = {0};
    if (!removal) return fail_scan_memory();
    const wcut_status status =
        wcut_cloud_clean(s->count, s->point, &s->options.clean, s->options.threads, removal, &report);
    int code = APP_DONE;
    if (status == WCUT_OK) {
        s->count = wcut_cloud_keep(s->count, removal, s->point);
        memcpy(s->removed, report.removed, sizeof s->removed);
    } else {
        code = app_fail_status(status, "cleaning the scan", NULL);
    }
    free(removal);
    return code;
}

/* is thinning all that is asked for? Then it is done as points come, and only what is left is held */
static bool only_thins(const wcut_clean_options *o) {
    return o->voxel > 0 && o->duplicate < 0 && o->radius == 0 && o->neighbours == 0;
}

/* ---- the whole ---- */

static int read_scans(growth *g) {
    app_scans *s = g->scans;

    /* room for a piece; where points are only thinned, they are thinned as they come */
    g->piece = malloc(APP_SCAN_PIECE * sizeof *g->piece);
    g->keep = malloc(APP_SCAN_PIECE);
    if (!g->piece || !g->keep) return fail_scan_memory();
    if (s->options.cleaned && only_thins(&s->options.clean)) {
        const wcut_status status = wcut_thinning_create(s->options.clean.voxel, &g->thinning);
        if (status != WCUT_OK) return app_fail_status(status, "compare", NULL);
        g->thin_all = true;
    }

    /* all files, which together are one scan */
    int code = APP_DONE;
    for (int k = 0; k < s->files && code == APP_DONE; k++) code = read_file(g, k);
    if (code != APP_DONE) return code;

    /* how many points are compared */
    double read = 0;
    for (int k = 0; k < s->files; k++) read += s->scan[k].read;
    if (read > 2147483647.0) return app_fail(APP_BAD_INPUT, "found %.0f points, expected at most 2147483647", read);
    s->removed[WCUT_REMOVAL_KEPT] = s->held ? s->count : (int)read;
    if (g->thin_all) s->removed[WCUT_REMOVAL_THINNED] = (int)read - s->count;

    return s->options.cleaned && !g->thin_all ? clean_scans(s) : APP_DONE;
}

int app_scans_read(app_scans *scans, const app_scan_options *options, int files, const char **path) {
    *scans = (app_scans){.options = *options, .files = files, .path = path, .held = true};
    scans->scan = calloc((size_t)files, sizeof *scans->scan);
    scans->hash = calloc((size_t)files, sizeof *scans->hash);
    if (!scans->scan || !scans->hash) return fail_scan_memory();
    growth g = {.scans = scans};
    const int code = read_scans(&g);
    wcut_thinning_destroy(g.thinning);
    free(g.piece);
    free(g.keep);
    return code;
}

void app_scans_clear(app_scans *scans) {
    free(scans->scan);
    free(scans->hash);
    free(scans->point);
    *scans = (app_scans){0};
}

/* ---- handing out ---- */

static int pass_file(const app_scans *s, int file, wcut_vec3 *piece, int *first, app_scan_visitor *visit,
                     void *context) {
    /* the same options as at the first reading */
    wcut_cloud_options options = wcut_cloud_options_default();
    wcut_cloud_source *source = NULL;
    wcut_error error = {0};
    options.unit = s->options.unit;
    options.columns = s->options.columns;
    wcut_status status = wcut_cloud_source_create(s->path[file], &options, &source, &error);
    int code = APP_DONE, count = 1, read = 0;

    /* the same pieces as at the first reading */
    while (status == WCUT_OK && code == APP_DONE && count > 0) {
        status = wcut_cloud_source_next(source, APP_SCAN_PIECE, piece, NULL, &count, &error);
        if (status == WCUT_OK) code = visit(context, *first, count, piece);
        *first += count, read += count;
    }

    /* a file that has changed meanwhile is refused */
    if (status != WCUT_OK) code = app_fail_status(status, NULL, &error);
    if (code == APP_DONE && read != s->scan[file].read)
        code = app_fail(APP_BAD_INPUT, "%s: found %d points at first and %d when read again", s->path[file],
                        s->scan[file].read, read);

    wcut_cloud_source_destroy(source);
    return code;
}

int app_scans_pass(const app_scans *scans, app_scan_visitor *visit, void *context) {
    int code = APP_DONE, first = 0;
    if (scans->held) {
        for (; first < scans->count && code == APP_DONE; first += APP_SCAN_PIECE) {
            const int left = scans->count - first;
            code = visit(context, first, left < APP_SCAN_PIECE ? left : APP_SCAN_PIECE, scans->point + first);
        }
        return code;
    }
    wcut_vec3 *piece = malloc(APP_SCAN_PIECE * sizeof *piece);
    if (!piece) return fail_scan_memory();
    for (int k = 0; k < scans->files && code == APP_DONE; k++)
        code = pass_file(scans, k, piece, &first, visit, context);
    free(piece);
    return code;
}
