/* A whole cloud in memory: pieces one after the other, thinned as they come where that is asked for. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/scan/cloud_source.h"

enum { PIECE = 4096 };

/* a cloud that grows */
typedef struct growth {
    wcut_cloud *cloud;
    size_t room;
    wcut_thinning *thinning; /* or NULL */
    unsigned char keep[PIECE];
} growth;

/* room for a piece more: as much as a file that was held to its header states, or twice as much as before */
static bool make_cloud_room(growth *g, const wcut_cloud_source *s) {
    const wcut_cloud_info *info = &s->info;
    const size_t need = (size_t)g->cloud->count + PIECE;
    if (need <= g->room) return true;
    size_t room = 2 * g->room > need ? 2 * g->room : need;
    if (g->room == 0 && info->stated > 0 && s->in.stream.size >= 0 && !g->thinning) room = (size_t)info->stated + PIECE;
    if (room > (size_t)s->options.max_points + PIECE) room = (size_t)s->options.max_points + PIECE;
    wcut_vec3 *point = wcut_grow(g->cloud->point, room * sizeof *point);
    if (point) g->cloud->point = point;
    wcut_vec3 *normal = NULL;
    if (point && info->has_normals) {
        normal = wcut_grow(g->cloud->normal, room * sizeof *normal);
        if (normal) g->cloud->normal = normal;
    }
    if (!point || (info->has_normals && !normal)) return false;
    g->room = room;
    return true;
}

/* move the points that stay to the front of the piece; gives how many, or -1 without memory */
static int thin_piece(growth *g, int count) {
    wcut_vec3 *point = g->cloud->point + g->cloud->count;
    wcut_vec3 *normal = g->cloud->normal ? g->cloud->normal + g->cloud->count : NULL;
    if (wcut_thinning_add(g->thinning, count, point, g->keep) != WCUT_OK) return -1;
    int kept = 0;
    for (int k = 0; k < count; k++) {
        if (!g->keep[k]) continue;
        point[kept] = point[k];
        if (normal) normal[kept] = normal[k];
        kept++;
    }
    return kept;
}

static wcut_status read_pieces(wcut_cloud_source *s, growth *g, wcut_error *error) {
    wcut_cloud *c = g->cloud;
    for (;;) {
        int count = 0;
        if (!make_cloud_room(g, s)) return wcut_source_refuse_memory(&s->in), WCUT_NO_MEMORY;
        wcut_vec3 *normal = c->normal ? c->normal + c->count : NULL;
        wcut_status status = wcut_cloud_source_next(s, PIECE, c->point + c->count, normal, &count, error);
        if (status != WCUT_OK || count == 0) return status;
        const int kept = g->thinning ? thin_piece(g, count) : count;
        if (kept < 0) return wcut_source_refuse_memory(&s->in), WCUT_NO_MEMORY;
        c->info.thinned += count - kept;
        if (kept > s->options.max_points - c->count) {
            wcut_source_refuse(&s->in, "found more than %d points, expected at most that: thin them or raise the limit",
                               s->options.max_points);
            return WCUT_BAD_FORMAT;
        }
        c->count += kept;
    }
}

static wcut_status refuse_empty(wcut_cloud_source *s) {
    const wcut_cloud_info *info = &s->info;
    if (info->not_finite + info->withheld > 0)
        wcut_source_refuse(&s->in, "found no point (%d not finite, %d withheld), expected at least one",
                           info->not_finite, info->withheld);
    else
        wcut_source_refuse(&s->in, "found no point, expected at least one");
    return WCUT_BAD_FORMAT;
}

static wcut_status read_whole(wcut_cloud_source *s, growth *g, wcut_error *error) {
    wcut_status status = read_pieces(s, g, error);
    if (status == WCUT_OK && g->cloud->count == 0) status = refuse_empty(s);
    const int thinned = g->cloud->info.thinned;
    g->cloud->info = *wcut_cloud_source_info(s);
    g->cloud->info.thinned = thinned;
    if (status != WCUT_OK && error && s->in.failure.status != WCUT_OK) *error = s->in.failure;
    return status;
}

wcut_status wcut_cloud_read(const char *path, const wcut_cloud_options *options, wcut_cloud **cloud,
                            wcut_error *error) {
    const wcut_cloud_options o = options ? *options : wcut_cloud_options_default();
    if (!cloud || o.max_points < 1 || !(o.voxel == 0 || o.voxel >= 1e-3) || !isfinite(o.voxel))
        return WCUT_BAD_ARGUMENT;

    /* a source of pieces, a cloud that grows, a grid that thins it */
    wcut_cloud_source *source = NULL;
    wcut_status status = wcut_cloud_source_create(path, &o, &source, error);
    if (status != WCUT_OK) return status;
    growth *g = wcut_alloc(1, sizeof *g);
    if (g) g->cloud = wcut_alloc(1, sizeof *g->cloud);
    status = g && g->cloud ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK && o.voxel > 0) status = wcut_thinning_create(o.voxel, &g->thinning);

    /* read it piece by piece */
    if (status == WCUT_OK)
        status = read_whole(source, g, error);
    else
        wcut_fail(error, status, "%s", wcut_status_text(status));

    /* only a whole cloud is handed out */
    if (status == WCUT_OK) {
        *cloud = g->cloud;
        g->cloud = NULL;
    }

    if (g) {
        /* scratch of the reading */
        wcut_thinning_destroy(g->thinning);
        wcut_cloud_destroy(g->cloud);
    }

    free(g);
    wcut_cloud_source_destroy(source);
    return status;
}

void wcut_cloud_destroy(wcut_cloud *cloud) {
    if (!cloud) return;
    free(cloud->point);
    free(cloud->normal);
    free(cloud);
}
