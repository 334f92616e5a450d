/* What the readers of the cloud formats share: a source's state, how a point is taken, how a file is refused. */
#ifndef WCUT_IO_SCAN_CLOUD_SOURCE_H
#define WCUT_IO_SCAN_CLOUD_SOURCE_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <wirecut/cloud.h>
#include <wirecut/cloud_file.h>

#include "io/file/record.h"
#include "io/file/source.h"

/* the caller's arrays and how far they are filled */
typedef struct wcut_batch {
    int capacity, count;
    wcut_vec3 *point, *normal;
} wcut_batch;

/* a format's reader: fill the batch; false: refused, the source holds the failure */
typedef bool wcut_cloud_fill(wcut_cloud_source *source, wcut_batch *batch);

struct wcut_cloud_source {
    wcut_source in; /* its scale is that of the option unit, unless the file states its own */
    wcut_cloud_info info;
    wcut_cloud_options options;
    wcut_cloud_fill *fill; /* of the format */
    void *state;           /* of the format, to free() */
    int64_t left;          /* points or records not yet read, of formats that state them */
    int nonzero, tiny;     /* coordinates among the first points, and those too small to be lengths */
};

/* what begins each format: the header is read, info, fill and state are set */
typedef bool wcut_cloud_begin(wcut_cloud_source *source);
wcut_cloud_begin wcut_cloud_begin_ply, wcut_cloud_begin_text, wcut_cloud_begin_stl, wcut_cloud_begin_las,
    wcut_cloud_begin_pcd, wcut_cloud_begin_obj, wcut_cloud_begin_off, wcut_cloud_begin_foreign, wcut_cloud_begin_ptx;

/* begin with bytes in memory through a small window; for tests and fuzzers */
wcut_status wcut_cloud_source_create_memory(const void *bytes, size_t size, size_t window, const char *label,
                                            const wcut_cloud_options *options, wcut_cloud_source **source,
                                            wcut_error *error);

/* hold a header to its claim: false, refused, where `count` of at least `size` bytes do not fit into the file, or are
   more than an int counts; sets info.stated and left */
bool wcut_cloud_state(wcut_cloud_source *source, int64_t count, uint64_t size, const char *what);

/* a wcut_cloud_fill of a source whose state is (or begins with) a wcut_record; source->left records are read */
bool wcut_cloud_fill_records(wcut_cloud_source *source, wcut_batch *batch);

/* a point that is left out or refused */
bool wcut_cloud_take_odd(wcut_cloud_source *source, const double value[WCUT_FIELDS]);
wcut_vec3 wcut_cloud_unit_normal(const double value[3]);

/* one point in file units into the batch, which has room; false: refused */
static inline bool wcut_cloud_take(wcut_cloud_source *s, wcut_batch *b, const double value[WCUT_FIELDS]) {
    const wcut_vec3 p = {value[0] * s->in.scale, value[1] * s->in.scale, value[2] * s->in.scale};
    const bool usual =
        fabs(p.x) <= WCUT_COORDINATE_FAR && fabs(p.y) <= WCUT_COORDINATE_FAR && fabs(p.z) <= WCUT_COORDINATE_FAR;
    if (!usual || s->info.read == INT32_MAX) return wcut_cloud_take_odd(s, value);
    wcut_vec3 *low = &s->info.low, *high = &s->info.high;
    if (s->info.read++ == 0) *low = *high = p;
    low->x = p.x < low->x ? p.x : low->x, high->x = p.x > high->x ? p.x : high->x;
    low->y = p.y < low->y ? p.y : low->y, high->y = p.y > high->y ? p.y : high->y;
    low->z = p.z < low->z ? p.z : low->z, high->z = p.z > high->z ? p.z : high->z;
    if (s->info.has_normals && b->normal) b->normal[b->count] = wcut_cloud_unit_normal(value + 3);
    b->point[b->count++] = p;
    return true;
}

#endif
