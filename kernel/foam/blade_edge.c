/* How much of a straight edge is in foam that no earlier pass of it has cut: intervals along the edge, cell by cell across. */
#include "foam/blade_edge.h"

#include <stddef.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

#define CELL 0.5 /* [mm] across the edge; feeds of a sample are of this size */
#define CELLS_MAX 1e6

/* what has been cut, of every cell: an interval along the edge; begin > end: nothing */
typedef struct cells {
    double first;
    int count;
    double *begin, *end;
} cells;

static void clip_axis(double at, double direction, double low, double high, double *begin, double *end) {
    if (direction == 0) {
        if (at < low || at > high) *end = -HUGE_VAL;
        return;
    }
    const double a = (low - at) / direction, b = (high - at) / direction;
    *begin = fmax(*begin, fmin(a, b));
    *end = fmin(*end, fmax(a, b));
}

double wcut_blade_edge_inside(wcut_vec3 at, wcut_vec3 edge, double from, double to, wcut_vec3 low, wcut_vec3 high,
                              double *begin, double *end) {
    double b = from, e = to;
    clip_axis(at.x, edge.x, low.x, high.x, &b, &e);
    clip_axis(at.y, edge.y, low.y, high.y, &b, &e);
    clip_axis(at.z, edge.z, low.z, high.z, &b, &e);
    *begin = b, *end = e;
    return e > b ? e - b : 0;
}

static bool make_cells(const wcut_blade_way *w, cells *c) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < w->count; i++) {
        const double n = vec3_dot(w->normal, w->place[i]);
        low = fmin(low, n), high = fmax(high, n);
    }
    c->first = low;
    c->count = (int)fmin((high - low) / CELL, CELLS_MAX) + 2;
    c->begin = wcut_alloc((size_t)c->count, sizeof(double));
    c->end = wcut_alloc((size_t)c->count, sizeof(double));
    if (!c->begin || !c->end) return false;
    for (int k = 0; k < c->count; k++) c->begin[k] = HUGE_VAL, c->end[k] = -HUGE_VAL;
    return true;
}

static int cell_at(const cells *c, double across) {
    return (int)clamp((across - c->first) / CELL + 0.5, 0, c->count - 1);
}

/* the piece of the edge that is in the box, from the origin of all places along the edge */
static bool piece(const wcut_blade_way *w, int i, wcut_vec3 low, wcut_vec3 high, double *begin, double *end) {
    const double along = vec3_dot(w->edge, w->place[i]);
    const bool inside = wcut_blade_edge_inside(w->place[i], w->edge, w->from, w->to, low, high, begin, end) > 0;
    *begin += along, *end += along;
    return inside;
}

/* what samples from .. to-1, one pass, have cut */
static void mark_pass(const wcut_blade_way *w, wcut_vec3 low, wcut_vec3 high, int from, int to, cells *c) {
    int last = cell_at(c, vec3_dot(w->normal, w->place[from]));
    for (int i = from; i < to; i++) {
        double begin, end;
        const int here = cell_at(c, vec3_dot(w->normal, w->place[i]));
        if (piece(w, i, low, high, &begin, &end))
            for (int k = here < last ? here : last; k <= (here > last ? here : last); k++)
                c->begin[k] = fmin(c->begin[k], begin), c->end[k] = fmax(c->end[k], end);
        last = here;
    }
}

static double uncut(const wcut_blade_way *w, int i, wcut_vec3 low, wcut_vec3 high, const cells *c) {
    double begin, end;
    if (!piece(w, i, low, high, &begin, &end)) return 0;
    const int k = cell_at(c, vec3_dot(w->normal, w->place[i]));
    const double common = fmin(end, c->end[k]) - fmax(begin, c->begin[k]);
    return end - begin - fmax(common, 0);
}

wcut_status wcut_blade_engaged(const wcut_blade_way *way, wcut_vec3 low, wcut_vec3 high, double *engaged) {
    cells c = {0};
    wcut_status status = make_cells(way, &c) ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK && c.count > CELLS_MAX) status = WCUT_DEGENERATE;

    /* a pass sees what those before it have cut, not what it cuts itself */
    for (int i = 0, from = 0; status == WCUT_OK && i < way->count; i++) {
        if (way->pass[i] != way->pass[from]) mark_pass(way, low, high, from, i, &c), from = i;
        engaged[i] = uncut(way, i, low, high, &c);
    }

    wcut_free(c.begin);
    wcut_free(c.end);
    return status;
}
