/* Clouds in: which format a file has, points in pieces, whole clouds in memory. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/look.h"
#include "io/file/unit.h"
#include "io/scan/cloud_foreign.h"
#include "io/scan/cloud_source.h"

enum { SNIFF = 512, ORDER_POINTS = 1000 };

wcut_cloud_options wcut_cloud_options_default(void) {
    return (wcut_cloud_options){
        .format = WCUT_CLOUD_FORMAT_ANY, .unit = WCUT_LENGTH_UNIT_MM, .max_points = 20000000, .voxel = 0};
}

static bool cloud_options_are_usable(const wcut_cloud_options *o) {
    return (unsigned)o->format < WCUT_CLOUD_FORMAT_COUNT && (unsigned)o->unit < WCUT_LENGTH_UNIT_COUNT;
}

bool wcut_cloud_state(wcut_cloud_source *s, int64_t count, uint64_t size, const char *what) {
    if (!wcut_source_check_count(&s->in, count, size, what)) return false;
    s->info.stated = (int)count;
    s->left = count;
    return true;
}

/* ---- points ---- */

wcut_vec3 wcut_cloud_unit_normal(const double v[3]) {
    /* scaled first, so that no square overflows or vanishes */
    const double max = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    if (!(max > 0) || !isfinite(v[0]) || !isfinite(v[1]) || !isfinite(v[2])) return (wcut_vec3){0, 0, 0};
    const double x = v[0] / max, y = v[1] / max, z = v[2] / max, length = sqrt(x * x + y * y + z * z);
    return (wcut_vec3){x / length, y / length, z / length};
}

bool wcut_cloud_take_odd(wcut_cloud_source *s, const double value[WCUT_FIELDS]) {
    if (s->info.read == INT_MAX || s->info.not_finite == INT_MAX)
        return wcut_source_refuse(&s->in, "found more points, expected at most %d", INT_MAX);
    for (int k = 0; k < 3; k++) {
        if (isfinite(value[k])) continue;
        s->info.not_finite++;
        return true;
    }
    for (int k = 0; k < 3; k++)
        if (fabs(value[k] * s->in.scale) > WCUT_COORDINATE_FAR)
            return wcut_source_refuse(&s->in, "found %c = %.6g mm, expected at most 1e12: a wrong byte order or unit?",
                                      "xyz"[k], value[k] * s -> in.scale);
    return true;
}

/* lengths below 1e-30 mm: numbers read in the wrong byte order are often that small */
static bool check_order(wcut_cloud_source *s, const wcut_batch *b) {
    const int known = s->info.read - b->count;
    const double min = 1e-30;
    for (int k = 0; s->in.binary && k < b->count && known + k < ORDER_POINTS; k++) {
        const double v[3] = {b->point[k].x, b->point[k].y, b->point[k].z};
        for (int c = 0; c < 3; c++) {
            s->nonzero += v[c] != 0;
            s->tiny += v[c] != 0 && fabs(v[c]) < min;
        }
    }
    const bool judged = known < ORDER_POINTS && (s->info.read >= ORDER_POINTS || b->count < b->capacity);
    if (!judged || 2 * s->tiny <= s->nonzero) return true;
    return wcut_source_refuse(&s->in,
                              "found %d of %d coordinates below 1e-30 mm, expected lengths: a wrong byte order?",
                              s->tiny, s->nonzero);
}

wcut_status wcut_cloud_source_next(wcut_cloud_source *s, int capacity, wcut_vec3 *point, wcut_vec3 *normal, int *count,
                                   wcut_error *error) {
    if (!s || capacity < 1 || !point || !count) return WCUT_BAD_ARGUMENT;
    wcut_batch batch = {capacity, 0, point, normal};
    if (s->in.failure.status == WCUT_OK && s->fill(s, &batch)) check_order(s, &batch);
    if (s->in.failure.status != WCUT_OK && batch.count == 0) {
        if (error) *error = s->in.failure;
        return s->in.failure.status;
    }
    *count = batch.count; /* points before a fault first: the next call reports it */
    return WCUT_OK;
}

const wcut_cloud_info *wcut_cloud_source_info(const wcut_cloud_source *source) { return source ? &source->info : NULL; }

void wcut_cloud_source_destroy(wcut_cloud_source *source) {
    if (!source) return;
    wcut_source_close(&source->in);
    free(source->state);
    free(source);
}

/* ---- which format ---- */

static bool begins(const wcut_stream *s, const char *word) {
    const size_t n = strlen(word);
    return s->end - s->at >= n && memcmp(s->data + s->at, word, n) == 0;
}

static bool ends_with(const char *text, const char *ending) {
    const size_t n = strlen(text), m = strlen(ending);
    return n >= m && strcasecmp(text + n - m, ending) == 0;
}

/* two lines of a count each: a PTX, since a PTS has one */
static bool begins_ptx(const wcut_stream *s) {
    const char *p = (const char *)s->data + s->at;
    for (int k = 0; k < 2; k++) {
        const size_t digits = strspn(p, "0123456789");
        p += digits;
        p += strspn(p, " \t\r");
        if (digits == 0 || *p++ != '\n') return false;
    }
    return true;
}

static wcut_cloud_format find_cloud_format(wcut_cloud_source *s) {
    const wcut_stream *t = &s->in.stream;
    if (begins(t, "ply\n") || begins(t, "ply\r")) return WCUT_CLOUD_FORMAT_PLY;
    if (begins(t, "LASF")) return WCUT_CLOUD_FORMAT_LAS;
    if (begins(t, "# .PCD") || begins(t, "VERSION .") || begins(t, "VERSION 0.")) return WCUT_CLOUD_FORMAT_PCD;
    if (ends_with(s->in.label, ".ptx") || begins_ptx(t)) return WCUT_CLOUD_FORMAT_PTX;
    if (ends_with(s->in.label, ".obj")) return WCUT_CLOUD_FORMAT_OBJ;
    if (ends_with(s->in.label, ".off")) return WCUT_CLOUD_FORMAT_OFF;
    if (wcut_cloud_foreign_ending((const char *)t->data + t->at, s->in.label)) return WCUT_CLOUD_FORMAT_GLTF;
    if (ends_with(s->in.label, ".stl") || begins(t, "solid ") || begins(t, "solid\n")) return WCUT_CLOUD_FORMAT_STL;
    return WCUT_CLOUD_FORMAT_TEXT;
}

/* text that is no table of points, by its first bytes */
static bool check_readable(wcut_cloud_source *s) {
    const wcut_stream *t = &s->in.stream;
    const char *at = (const char *)t->data + t->at;
    const wcut_look found = wcut_look_at(at, t->end - t->at, s->in.label);
    if (!found.kind || strstr(found.use, "as SCAN")) return true;
    wcut_look_refuse(at, t->end - t->at, s->in.label, "PLY, XYZ/PTS/PTX/CSV text, STL, OBJ, OFF, glTF, LAS or PCD",
                     &s->in.failure);
    return false;
}

static bool begin_format(wcut_cloud_source *s) {
    static wcut_cloud_begin *const begin[] = {NULL,
                                              wcut_cloud_begin_ply,
                                              wcut_cloud_begin_text,
                                              wcut_cloud_begin_stl,
                                              wcut_cloud_begin_las,
                                              wcut_cloud_begin_pcd,
                                              wcut_cloud_begin_obj,
                                              wcut_cloud_begin_off,
                                              wcut_cloud_begin_foreign,
                                              wcut_cloud_begin_ptx};

    /* the scale of the unit, and enough bytes to tell the format */
    s->in.scale = wcut_unit_length(s->options.unit);
    if (wcut_stream_fill(&s->in.stream, SNIFF) == 0) return wcut_source_refuse_end(&s->in, "points");

    /* a reader for each format */
    s->info.format = s->options.format != WCUT_CLOUD_FORMAT_ANY ? s->options.format : find_cloud_format(s);
    if (s->info.format == WCUT_CLOUD_FORMAT_TEXT && !check_readable(s)) return false;

    /* a reader sets how many points its header states; -1: not stated */
    s->info.stated = -1;
    if (!begin[s->info.format](s)) return false;
    s->info.unit = s->in.scale;

    return true;
}

/* the bytes, opened, become the source's; they are closed on failure */
static wcut_status create_source(wcut_source in, const wcut_cloud_options *options, wcut_cloud_source **source,
                                 wcut_error *error) {
    wcut_cloud_source *s = wcut_alloc(1, sizeof *s);
    if (!s) {
        wcut_source_close(&in);
        return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    s->in = in;
    s->options = *options;
    if (begin_format(s)) {
        *source = s;
        return WCUT_OK;
    }
    const wcut_status status = s->in.failure.status;
    if (error) *error = s->in.failure;
    wcut_cloud_source_destroy(s);
    return status;
}

wcut_status wcut_cloud_source_create(const char *path, const wcut_cloud_options *options, wcut_cloud_source **source,
                                     wcut_error *error) {
    const wcut_cloud_options o = options ? *options : wcut_cloud_options_default();
    if (!path || !source || !cloud_options_are_usable(&o)) return WCUT_BAD_ARGUMENT;
    wcut_source in;
    const wcut_status status = wcut_source_open(path, &in, error);
    return status == WCUT_OK ? create_source(in, &o, source, error) : status;
}

wcut_status wcut_cloud_source_create_memory(const void *bytes, size_t size, size_t window, const char *label,
                                            const wcut_cloud_options *options, wcut_cloud_source **source,
                                            wcut_error *error) {
    const wcut_cloud_options o = options ? *options : wcut_cloud_options_default();
    wcut_source in;
    const wcut_status status = wcut_source_open_memory(bytes, size, window, label, &in, error);
    return status == WCUT_OK ? create_source(in, &o, source, error) : status;
}
