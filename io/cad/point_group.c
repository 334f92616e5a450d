/* Points that a text gives one after the other, and which curve each belongs to. */
#include "io/cad/point_group.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"

/* ---- names ---- */

static unsigned hash_name(const char *at, int length) {
    unsigned h = 2166136261u; /* FNV-1a */
    for (int k = 0; k < length; k++) h = (h ^ (unsigned char)at[k]) * 16777619u;
    return h;
}

/* the slot that holds a name, or the free one where it would be */
static int find_slot(const wcut_point_names *n, const char *at, int length) {
    int k = (int)(hash_name(at, length) % (unsigned)n->slots);
    for (; n->slot[k]; k = (k + 1) % n->slots) {
        const struct point_name *one = &n->name[n->slot[k] - 1];
        if (one->length == length && memcmp(one->at, at, (size_t)length) == 0) break;
    }
    return k;
}

/* twice as many slots as names at least */
static bool make_slots(wcut_point_names *n) {
    if (2 * (n->count + 1) <= n->slots) return true;
    const int slots = n->slots ? 2 * n->slots : 64;
    int *slot = n->count < INT_MAX / 8 ? wcut_alloc((size_t)slots, sizeof *slot) : NULL;
    if (!slot) return false;
    wcut_free(n->slot);
    n->slot = slot;
    n->slots = slots;
    for (int k = 0; k < n->count; k++) n->slot[find_slot(n, n->name[k].at, n->name[k].length)] = k + 1;
    return true;
}

int wcut_point_names_locate(wcut_curve_reader *r, wcut_point_names *n, const char *at, int length) {
    if (!make_slots(n)) return wcut_curves_refuse_memory(r), -1;
    const int k = find_slot(n, at, length);
    if (n->slot[k]) return n->slot[k] - 1;

    /* a new one */
    if (n->count == n->room) {
        const int room = n->room ? 2 * n->room : 16;
        struct point_name *grown = wcut_grow(n->name, (size_t)room * sizeof *grown);
        if (!grown) return wcut_curves_refuse_memory(r), -1;
        n->name = grown;
        n->room = room;
    }
    n->name[n->count] = (struct point_name){at, length};
    n->slot[k] = ++n->count;
    return n->count - 1;
}

void wcut_point_names_clear(wcut_point_names *n) {
    wcut_free(n->name);
    wcut_free(n->slot);
    *n = (wcut_point_names){0};
}

/* ---- points ---- */

bool wcut_points_add(wcut_curve_reader *r, wcut_points *p, int curve, int line, wcut_vec3 at) {
    if (p->count == p->room) {
        const int room = p->room < INT_MAX / 2 ? (p->room ? 2 * p->room : 64) : INT_MAX;
        wcut_point *grown = p->count < room ? wcut_grow(p->point, (size_t)room * sizeof *grown) : NULL;
        if (!grown) return wcut_curves_refuse_memory(r);
        p->point = grown;
        p->room = room;
    }
    p->point[p->count++] = (wcut_point){at, curve, line};
    return true;
}

void wcut_points_clear(wcut_points *p) {
    wcut_free(p->point);
    *p = (wcut_points){0};
}

/* ---- curves ---- */

wcut_curve *wcut_points_curve(wcut_curve_reader *r, const char *place, int count, const wcut_vec3 *point) {
    wcut_curve *curve = NULL;
    if (!r->options->interpolate) return wcut_curves_polyline(r, place, count, point);
    const wcut_status status = count >= 2 ? wcut_curve_interpolate(count, point, &curve) : WCUT_DEGENERATE;
    if (status == WCUT_NO_MEMORY) wcut_curves_refuse_memory(r);
    if (status != WCUT_OK && status != WCUT_NO_MEMORY)
        wcut_curves_refuse(r, "%s: found %d points, expected two or more, neighbours apart", place, count);
    return curve;
}

/* points in the order of their curves, and where each curve begins */
static void sort_points(const wcut_points *p, int curves, int *from, int *order) {
    for (int k = 0; k < p->count; k++) from[p->point[k].curve + 1]++;
    for (int c = 0; c < curves; c++) from[c + 1] += from[c];
    for (int k = 0; k < p->count; k++) order[from[p->point[k].curve]++] = k;
    for (int c = curves; c > 0; c--) from[c] = from[c - 1];
    from[0] = 0;
}

static bool add_curve(wcut_curve_reader *r, const wcut_points *p, const int *order, int count, wcut_vec3 *point,
                      const struct point_name *name, const char *word) {
    char place[60];
    if (count == 0) return true;
    for (int k = 0; k < count; k++) point[k] = p->point[order[k]].at;
    snprintf(place, sizeof place, "%s %d", word, p->point[order[0]].line);
    wcut_curve *curve = wcut_points_curve(r, place, count, point);
    return curve && wcut_curves_add(r, curve, name ? name->at : "", name ? (size_t)name->length : 0);
}

bool wcut_points_end(wcut_curve_reader *r, const wcut_points *p, int curves, const wcut_point_names *names,
                     const char *place) {
    if (curves > r->options->max_curves)
        return wcut_curves_refuse(r, "found more than %d curves, expected at most that", r->options->max_curves);

    /* counting sort by curve, stable, so that the points keep their order */
    int *from = wcut_alloc((size_t)curves + 2, sizeof *from), *order = wcut_alloc((size_t)p->count, sizeof *order);
    wcut_vec3 *point = wcut_alloc((size_t)p->count, sizeof *point);
    bool done = from && order && point;
    if (!done) wcut_curves_refuse_memory(r);
    if (from && order && point) {
        /* a curve from the points of each group */
        sort_points(p, curves, from, order);
        for (int c = 0; done && c < curves; c++) {
            const struct point_name *name = names && c < names->count ? &names->name[c] : NULL;
            done = add_curve(r, p, order + from[c], from[c + 1] - from[c], point, name, place);
        }
    }
    wcut_free(from);
    wcut_free(order);
    wcut_free(point);
    return done;
}
