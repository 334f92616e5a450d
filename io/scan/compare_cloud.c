/* The scan of a comparison: cleaned and held in memory, or, beyond what is to be held, read a second time. */
#include "io/scan/compare_cloud.h"

#include <math.h>
#include <string.h>
#include <sys/stat.h>

#include "base/alloc.h"
#include "base/fail.h"

enum { SAMPLE = 200000, CLEANED_MAX = 20000000 };

/* a cloud that grows: all that was read, until that is too much, then a thinned sample */
typedef struct growth {
    wcut_compare_cloud *cloud;
    size_t room;
    wcut_thinning *thinning; /* of a sample, or of what is only to be thinned */
    bool thin_all;           /* what the thinning leaves is all that is compared */
    wcut_vec3 *piece;        /* WCUT_COMPARE_PIECE */
    unsigned char *keep;     /* WCUT_COMPARE_PIECE */
} growth;

static const char *part_name(const wcut_compare_scan *part) {
    return part->name ? part->name : part->path ? part->path : "scan";
}

/* a failure whose text does not name a place gets that of the part */
static wcut_status fail_part(wcut_status status, const wcut_compare_scan *part, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    return wcut_fail(error, status, "%s: %s", wcut_quote(name, part_name(part), WCUT_LABEL_MAX, 1),
                     wcut_status_text(status));
}

/* ---- points as they come ---- */

static bool make_scan_room(growth *g, int more) {
    wcut_compare_cloud *c = g->cloud;
    const size_t need = (size_t)c->count + (size_t)more;
    if (need <= g->room) return true;
    const size_t room = need > 2 * g->room ? need : 2 * g->room;
    wcut_vec3 *point = wcut_grow(c->point, room * sizeof *point);
    if (!point) return false;
    c->point = point, g->room = room;
    return true;
}

/* append points that a thinning keeps, or all */
static wcut_status append_points(growth *g, int count, const wcut_vec3 *point) {
    wcut_compare_cloud *c = g->cloud;
    if (g->thinning) {
        const wcut_status status = wcut_thinning_add(g->thinning, count, point, g->keep);
        if (status != WCUT_OK) return status;
    }
    if (!make_scan_room(g, count)) return WCUT_NO_MEMORY;
    for (int k = 0; k < count; k++)
        if (!g->thinning || g->keep[k]) c->point[c->count++] = point[k];
    return WCUT_OK;
}

/* from now on only a sample is held */
static wcut_status begin_sample(growth *g) {
    wcut_compare_cloud *c = g->cloud;
    c->held = false;
    c->spacing = sqrt(c->plan / SAMPLE);
    wcut_status status = wcut_thinning_create(c->spacing, &g->thinning);
    if (status != WCUT_OK) return status;

    /* what came before is thinned, too */
    wcut_vec3 *all = c->point;
    const int count = c->count;
    c->point = NULL, c->count = 0, g->room = 0;
    for (int k = 0; k < count && status == WCUT_OK; k += WCUT_COMPARE_PIECE)
        status = append_points(g, count - k < WCUT_COMPARE_PIECE ? count - k : WCUT_COMPARE_PIECE, all + k);
    wcut_free(all);
    return status;
}

/* what is read once only cannot be read a second time */
static bool can_be_read_again(const wcut_compare_scan *part) {
    struct stat about;
    return !part->path || (stat(part->path, &about) == 0 && S_ISREG(about.st_mode));
}

static wcut_status take_scan(growth *g, const wcut_compare_scan *part, int count, const wcut_vec3 *point,
                             wcut_error *error) {
    wcut_compare_cloud *c = g->cloud;
    char name[WCUT_QUOTE_SIZE];

    /* cleaning and thinning need all points in memory */
    const bool whole = c->cleaned || g->thin_all;
    if (whole && count > CLEANED_MAX - c->count)
        return wcut_fail(error, WCUT_BAD_FORMAT,
                         "%s: found more than %d points, expected at most that many to be cleaned",
                         wcut_quote(name, part_name(part), WCUT_LABEL_MAX, 1), CLEANED_MAX);

    /* too many to be held: a sample is, and all parts will be read again */
    if (!whole && c->held && count > c->hold - c->count) {
        for (int k = 0; k < c->parts; k++)
            if (!can_be_read_again(&c->part[k]))
                return wcut_fail(error, WCUT_BAD_FORMAT,
                                 "%s: found more than %d points, expected a file, which can be read twice, or to hold "
                                 "more of them",
                                 wcut_quote(name, part_name(&c->part[k]), WCUT_LABEL_MAX, 1), c->hold);
        const wcut_status status = begin_sample(g);
        if (status != WCUT_OK) return fail_part(status, part, error);
    }
    if (!c->held && c->count >= c->hold) return WCUT_OK; /* a scan of a room: the sample is full */

    /* the points themselves, or the sample of them */
    const wcut_status status = append_points(g, count, point);
    return status == WCUT_OK ? WCUT_OK : fail_part(status, part, error);
}

static void widen_scan(wcut_compare_cloud *c, int parts_before, const wcut_cloud_info *info) {
    if (info->read == 0) return;
    double *low = &c->low.x, *high = &c->high.x;
    const double *l = &info->low.x, *h = &info->high.x;
    for (int k = 0; k < 3; k++) {
        if (parts_before == 0 || l[k] < low[k]) low[k] = l[k];
        if (parts_before == 0 || h[k] > high[k]) high[k] = h[k];
    }
}

static wcut_status step_reading(const wcut_compare_cloud *c, int part, int read, wcut_error *error) {
    const wcut_compare_watch *w = c->watch;
    char name[WCUT_QUOTE_SIZE];
    if (!w || !w->progress || !w->progress(WCUT_COMPARE_STAGE_READ, read, 0, w->context)) return WCUT_OK;
    return wcut_fail(error, WCUT_INTERRUPTED, "%s: interrupted",
                     wcut_quote(name, part_name(&c->part[part]), WCUT_LABEL_MAX, 1));
}

/* ---- a part ---- */

static wcut_status open_part(const wcut_compare_cloud *c, int part, wcut_cloud_source **source, wcut_error *error) {
    wcut_cloud_options options = wcut_cloud_options_default();
    options.unit = c->options->unit;
    options.columns = c->options->columns;
    return wcut_cloud_source_create(c->part[part].path, &options, source, error);
}

static wcut_status read_file(growth *g, int part, wcut_error *error) {
    wcut_compare_cloud *c = g->cloud;
    const wcut_compare_scan *p = &c->part[part];
    char name[WCUT_QUOTE_SIZE];
    wcut_cloud_source *source = NULL;
    wcut_status status = open_part(c, part, &source, error);

    /* piece by piece, until the file ends or the user stops */
    for (int count = 1, read = 0; status == WCUT_OK && count > 0; read += count) {
        status = wcut_cloud_source_next(source, WCUT_COMPARE_PIECE, g->piece, NULL, &count, error);
        if (status == WCUT_OK) status = step_reading(c, part, read + count, error);
        if (status == WCUT_OK) status = take_scan(g, p, count, g->piece, error);
    }

    /* what the file held, and its hash */
    if (status == WCUT_OK) {
        const wcut_cloud_info *info = wcut_cloud_source_info(source);
        if (info->read == 0)
            status =
                wcut_fail(error, WCUT_BAD_FORMAT, "%s: found no point (%d not finite, %d withheld), expected a scan",
                          wcut_quote(name, part_name(p), WCUT_LABEL_MAX, 1), info->not_finite, info->withheld);
        widen_scan(c, part, info);
        c->scan[part] = (wcut_compared_scan){part_name(p), c->hash[part], info->read, info->not_finite, info->withheld};
    }

    /* the whole file has been read: its hash is recorded with the figures */
    if (status == WCUT_OK) status = wcut_source_hash(p->path, c->hash[part], error);

    wcut_cloud_source_destroy(source);
    return status;
}

static wcut_status read_part_points(growth *g, int part, wcut_error *error) {
    wcut_compare_cloud *c = g->cloud;
    const wcut_compare_scan *p = &c->part[part];

    /* bounds of the points */
    wcut_cloud_info info = {.read = p->count, .low = p->point[0], .high = p->point[0]};
    for (int k = 1; k < p->count; k++) {
        const wcut_vec3 *at = &p->point[k];
        info.low = (wcut_vec3){fmin(info.low.x, at->x), fmin(info.low.y, at->y), fmin(info.low.z, at->z)};
        info.high = (wcut_vec3){fmax(info.high.x, at->x), fmax(info.high.y, at->y), fmax(info.high.z, at->z)};
    }
    widen_scan(c, part, &info);
    c->scan[part] = (wcut_compared_scan){.name = part_name(p), .sha256 = "", .read = p->count};

    /* in pieces, as from a file, so that a callback can stop it */
    wcut_status status = WCUT_OK;
    for (int k = 0; k < p->count && status == WCUT_OK; k += WCUT_COMPARE_PIECE) {
        const int left = p->count - k, count = left < WCUT_COMPARE_PIECE ? left : WCUT_COMPARE_PIECE;
        status = step_reading(c, part, k + count, error);
        if (status == WCUT_OK) status = take_scan(g, p, count, p->point + k, error);
    }
    return status;
}

/* ---- cleaning ---- */

bool wcut_compare_cleans(const wcut_clean_options *clean) {
    return clean->duplicate >= 0 || clean->radius > 0 || clean->neighbours > 0 || clean->voxel > 0;
}

/* is thinning all that is asked for? Then it is done as points come, and only what is left is held */
static bool only_thins(const wcut_clean_options *o) {
    return o->voxel > 0 && o->duplicate < 0 && o->radius == 0 && o->neighbours == 0;
}

static wcut_status clean_scan(wcut_compare_cloud *c, wcut_error *error) {
    unsigned char *removal = wcut_alloc((size_t)c->count, 1);
    wcut_clean_report report = {0};
    wcut_status status = WCUT_NO_MEMORY;
    if (removal)
        status = wcut_cloud_clean(c->count, c->point, &c->options->clean, c->options->threads, removal, &report);
    if (status == WCUT_OK) {
        c->count = wcut_cloud_keep(c->count, removal, c->point);
        memcpy(c->removed, report.removed, sizeof c->removed);
    } else {
        wcut_fail(error, status, "cleaning the scan: %s", wcut_status_text(status));
    }
    wcut_free(removal);
    return status;
}

/* ---- the whole ---- */

static wcut_status read_parts(growth *g, wcut_error *error) {
    wcut_compare_cloud *c = g->cloud;

    /* room for a piece; where points are only thinned, they are thinned as they come */
    g->piece = wcut_alloc(WCUT_COMPARE_PIECE, sizeof *g->piece);
    g->keep = wcut_alloc(WCUT_COMPARE_PIECE, 1);
    wcut_status status = g->piece && g->keep ? WCUT_OK : WCUT_NO_MEMORY;
    g->thin_all = c->cleaned && only_thins(&c->options->clean);
    if (status == WCUT_OK && g->thin_all) status = wcut_thinning_create(c->options->clean.voxel, &g->thinning);
    if (status != WCUT_OK) return fail_part(status, c->part, error);

    /* all parts, which together are one scan */
    for (int k = 0; k < c->parts && status == WCUT_OK; k++)
        status = c->part[k].path ? read_file(g, k, error) : read_part_points(g, k, error);
    if (status != WCUT_OK) return status;

    /* how many points are compared */
    double read = 0;
    for (int k = 0; k < c->parts; k++) read += c->scan[k].read;
    if (read > 2147483647.0)
        return wcut_fail(error, WCUT_BAD_FORMAT, "found %.0f points, expected at most 2147483647", read);
    c->removed[WCUT_REMOVAL_KEPT] = c->held ? c->count : (int)read;
    if (g->thin_all) c->removed[WCUT_REMOVAL_THINNED] = (int)read - c->count;
    return c->cleaned && !g->thin_all ? clean_scan(c, error) : WCUT_OK;
}

wcut_status wcut_compare_cloud_read(wcut_compare_cloud *cloud, wcut_error *error) {
    wcut_compare_cloud *c = cloud;
    c->held = true;
    c->scan = wcut_alloc((size_t)c->parts, sizeof *c->scan);
    c->hash = wcut_alloc((size_t)c->parts, sizeof *c->hash);
    if (!c->scan || !c->hash) return fail_part(WCUT_NO_MEMORY, c->part, error);
    growth g = {.cloud = c};
    const wcut_status status = read_parts(&g, error);
    wcut_thinning_destroy(g.thinning);
    wcut_free(g.piece);
    wcut_free(g.keep);
    return status;
}

void wcut_compare_cloud_clear(wcut_compare_cloud *cloud) {
    wcut_free(cloud->scan);
    wcut_free(cloud->hash);
    wcut_free(cloud->point);
    *cloud = (wcut_compare_cloud){0};
}

/* ---- handing out ---- */

static wcut_status pass_array(int count, const wcut_vec3 *point, int *first, wcut_compare_visitor *visit, void *context,
                              wcut_error *error) {
    wcut_status status = WCUT_OK;
    for (int k = 0; k < count && status == WCUT_OK; k += WCUT_COMPARE_PIECE) {
        const int left = count - k, size = left < WCUT_COMPARE_PIECE ? left : WCUT_COMPARE_PIECE;
        status = visit(context, *first, size, point + k, error);
        *first += size;
    }
    return status;
}

static wcut_status pass_file(const wcut_compare_cloud *c, int part, wcut_vec3 *piece, int *first,
                             wcut_compare_visitor *visit, void *context, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    wcut_cloud_source *source = NULL;
    wcut_status status = open_part(c, part, &source, error);
    int read = 0;

    /* the same pieces as at the first reading */
    for (int count = 1; status == WCUT_OK && count > 0; *first += count, read += count) {
        status = wcut_cloud_source_next(source, WCUT_COMPARE_PIECE, piece, NULL, &count, error);
        if (status == WCUT_OK) status = visit(context, *first, count, piece, error);
    }
    if (status == WCUT_OK && read != c->scan[part].read)
        status = wcut_fail(error, WCUT_BAD_FORMAT, "%s: found %d points at first and %d when read again",
                           wcut_quote(name, part_name(&c->part[part]), WCUT_LABEL_MAX, 1), c->scan[part].read, read);

    wcut_cloud_source_destroy(source);
    return status;
}

wcut_status wcut_compare_cloud_pass(const wcut_compare_cloud *cloud, wcut_compare_visitor *visit, void *context,
                                    wcut_error *error) {
    const wcut_compare_cloud *c = cloud;
    int first = 0;
    if (c->held) return pass_array(c->count, c->point, &first, visit, context, error);

    wcut_vec3 *piece = wcut_alloc(WCUT_COMPARE_PIECE, sizeof *piece);
    wcut_status status = piece ? WCUT_OK : fail_part(WCUT_NO_MEMORY, c->part, error);
    for (int k = 0; k < c->parts && status == WCUT_OK; k++)
        status = c->part[k].path ? pass_file(c, k, piece, &first, visit, context, error)
                                 : pass_array(c->part[k].count, c->part[k].point, &first, visit, context, error);
    wcut_free(piece);
    return status;
}
