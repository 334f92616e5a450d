/* Curves on the faces of a block joined end to end over its edges, into the outline of a cut. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/intersect.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* an end of an open trace, 2 * trace + 0 or 1, and the end it is joined to: itself where it stays free */
typedef struct ends {
    int count, *partner; /* 2 * traces; -1: a closed trace has none */
} ends;

static wcut_vec3 outline_point_at(const wcut_traces *t, int end) {
    const wcut_trace *trace = &t->trace[end / 2];
    return trace->point[end % 2 ? trace->count - 1 : 0];
}

/* each free end to the nearest other one within the tolerance */
static void outline_join(const wcut_traces *t, double tolerance, ends *e) {
    for (int k = 0; k < e->count; k++) e->partner[k] = t->trace[k / 2].closed ? -1 : k;
    for (int k = 0; k < e->count; k++) {
        if (e->partner[k] != k) continue;
        double nearest = tolerance;
        int best = k;
        for (int n = k + 1; n < e->count; n++) {
            if (e->partner[n] != n) continue;
            const double distance = vec3_distance(outline_point_at(t, k), outline_point_at(t, n));
            if (distance <= nearest) nearest = distance, best = n;
        }
        e->partner[k] = best, e->partner[best] = k;
    }
}

/* the points of a trace behind those of a line, from one end on; what is there already is left out */
static void outline_append(const wcut_trace *from, bool forth, double tolerance, wcut_trace *to) {
    for (int k = 0; k < from->count; k++) {
        const size_t at = (size_t)(forth ? k : from->count - 1 - k), end = (size_t)to->count;
        if (k == 0 && end > 0 && vec3_distance(to->point[end - 1], from->point[at]) <= tolerance) continue;
        to->point[end] = from->point[at];
        memcpy(to->uv + 2 * end, from->uv + 2 * at, 2 * sizeof *to->uv);
        to->count++;
    }
}

/* the line that begins at an end, its traces marked as used; NULL points: no memory */
static wcut_trace outline_follow(const wcut_traces *t, const ends *e, int start, double tolerance, bool *used) {
    /* first walk: count the points and the faces */
    wcut_trace line = {.face = t->trace[start / 2].face};
    size_t points = 0;
    int at = start;
    do { /* how many points, and over which faces */
        points += (size_t)t->trace[at / 2].count;
        if (t->trace[at / 2].face != line.face) line.face = -1;
        const int next = e->partner[at ^ 1];
        if (next < 0 || next == (at ^ 1)) break;
        at = next;
    } while (at != start);

    /* room for all of them */
    line.point = wcut_alloc(points, sizeof *line.point);
    line.uv = wcut_alloc(points, 2 * sizeof *line.uv);
    if (!line.point || !line.uv) {
        wcut_free(line.point);
        wcut_free(line.uv);
        line.point = NULL;
        return line;
    }

    /* second walk: append the traces in order */
    for (at = start; !used[at / 2]; at = e->partner[at ^ 1]) {
        used[at / 2] = true;
        outline_append(&t->trace[at / 2], at % 2 == 0, tolerance, &line);
        if (e->partner[at ^ 1] < 0 || e->partner[at ^ 1] == (at ^ 1)) break;
    }

    /* closed where the last end leads back to the first */
    line.closed = t->trace[start / 2].closed || (e->partner[start] >= 0 && e->partner[start] != start);
    if (line.closed && line.count > 2 && vec3_distance(line.point[0], line.point[line.count - 1]) <= tolerance)
        line.count--; /* the first point is not repeated */
    return line;
}

wcut_status wcut_traces_join(const wcut_traces *traces, double tolerance, wcut_traces **outline) {
    if (!traces || !outline || !is_positive(tolerance)) return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < traces->count; k++)
        if (traces->trace[k].count < 2) return WCUT_BAD_ARGUMENT;

    /* ends and their partners */
    ends e = {.count = 2 * traces->count, .partner = wcut_alloc(2 * (size_t)traces->count, sizeof(int))};
    bool *used = wcut_alloc((size_t)traces->count, sizeof *used);
    wcut_traces *all = wcut_alloc(1, sizeof *all);
    if (all) all->trace = wcut_alloc((size_t)traces->count, sizeof *all->trace);
    wcut_status status = e.partner && used && all && all->trace ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) outline_join(traces, tolerance, &e);

    for (int pass = 0; pass < 2 && status == WCUT_OK; pass++) /* open lines from their free ends, then closed ones */
        for (int k = 0; k < e.count && status == WCUT_OK; k++) {
            if (used[k / 2] || (pass == 0 && e.partner[k] != k)) continue;
            const wcut_trace line = outline_follow(traces, &e, k, tolerance, used);
            if (line.point) all->trace[all->count++] = line;
            if (!line.point) status = WCUT_NO_MEMORY;
        }

    /* loose ends are those without a partner */
    if (status == WCUT_OK) {
        all->touching = traces->touching, all->touch_u = traces->touch_u, all->touch_v = traces->touch_v;
        for (int k = 0; k < e.count; k++) all->loose += e.partner[k] == k;
        *outline = all;
    } else {
        wcut_traces_destroy(all);
    }

    wcut_free(used);
    wcut_free(e.partner);
    return status;
}
