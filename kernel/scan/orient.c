/* One side for the normals of a sheet: by a direction where that is clear, else along a minimum spanning forest (Hoppe,
   DeRose, Duchamp, McDonald, Stuetzle 1992; Prim 1957). */
#include "scan/orient.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "base/threads.h"
#include "base/vec3.h"

enum { NEIGHBOURS_MAX = 8, BLOCK = 1024 };

/* A point that waits for its sign. Numbers of waiting points are theirs in `waiting`. */
typedef struct waiting_point {
    int place;      /* in the tree */
    int from;       /* place of the neighbour it would follow; -1: none yet */
    int heap;       /* where it is in the heap; -1: not there */
    double weight;  /* 1 - |n n'| of that edge */
    double upright; /* |n . side| */
} waiting_point;

typedef struct orientation {
    const wcut_kd_tree *tree;
    int k; /* neighbours an edge leads to */
    wcut_vec3 side, *normal;
    int waiting_count, heap_count;
    waiting_point *waiting;
    int *number;    /* tree->count: of the waiting point, plus 1; 0: it does not wait (any more) */
    int *neighbour; /* waiting_count x k: places, -1 behind the last */
    size_t *first;  /* waiting_count + 1: where each one's part of `back` begins */
    int *back;      /* numbers of the waiting points whose neighbour it is */
    int *heap;      /* waiting_count */
    int *done;      /* waiting_count: places in the order they were turned */
    int done_count;
} orientation;

/* ---- a heap of waiting points, the lightest edge first, equal ones by number ---- */

static bool before(const orientation *o, int a, int b) {
    const double x = o->waiting[a].weight, y = o->waiting[b].weight;
    return x < y || (x == y && a < b);
}

static void orient_put(orientation *o, int at, int number) {
    o->heap[at] = number;
    o->waiting[number].heap = at;
}

static void rise(orientation *o, int at) {
    const int number = o->heap[at];
    for (; at > 0 && before(o, number, o->heap[(at - 1) / 2]); at = (at - 1) / 2)
        orient_put(o, at, o->heap[(at - 1) / 2]);
    orient_put(o, at, number);
}

static int take_first(orientation *o) {
    const int first = o->heap[0], number = o->heap[--o->heap_count];
    o->waiting[first].heap = -1;
    int at = 0;
    for (int child; (child = 2 * at + 1) < o->heap_count; at = child) {
        if (child + 1 < o->heap_count && before(o, o->heap[child + 1], o->heap[child])) child++;
        if (!before(o, o->heap[child], number)) break;
        orient_put(o, at, o->heap[child]);
    }
    if (o->heap_count > 0) orient_put(o, at, number);
    return first;
}

/* the turned point at `place` offers itself to a waiting one */
static void orient_offer(orientation *o, int place, int number) {
    waiting_point *w = &o->waiting[number];
    const double weight = 1 - fabs(vec3_dot(o->normal[place], o->normal[w->place]));
    if (w->from >= 0 && weight >= w->weight) return;
    w->from = place;
    w->weight = weight;
    if (w->heap < 0) {
        o->heap[o->heap_count] = number;
        w->heap = o->heap_count++;
    }
    rise(o, w->heap);
}

/* ---- the graph ---- */

/* |n . side| of every point that has a normal; who waits is listed, who does not is turned */
static wcut_status list_waiting(orientation *o, double steep, wcut_normals_report *report) {
    /* turn each normal towards the side; those at too flat an angle are numbered and wait */
    const int count = o->tree->count;
    for (int p = 0; p < count; p++) {
        const double along = vec3_dot(o->normal[p], o->side);
        const bool defined = vec3_dot(o->normal[p], o->normal[p]) > 0;
        if (along < 0) o->normal[p] = vec3_scale(-1, o->normal[p]);
        if (!defined || fabs(along) >= steep) continue;
        o->number[p] = ++o->waiting_count;
    }
    report->propagated = o->waiting_count;

    /* arrays for the points that wait */
    const size_t n = (size_t)o->waiting_count;
    o->waiting = wcut_alloc(n, sizeof *o->waiting);
    o->neighbour = wcut_alloc(n * (size_t)o->k, sizeof *o->neighbour);
    o->first = wcut_alloc(n + 1, sizeof *o->first);
    o->heap = wcut_alloc(n, sizeof *o->heap);
    o->done = wcut_alloc(n, sizeof *o->done);
    if (!o->waiting || !o->neighbour || !o->first || !o->heap || !o->done) return WCUT_NO_MEMORY;

    /* how upright each waiting one is, as the order in which guesses are made */
    for (int p = 0; p < count; p++) {
        if (o->number[p] == 0) continue;
        const double upright = fabs(vec3_dot(o->normal[p], o->side));
        o->waiting[o->number[p] - 1] = (waiting_point){p, -1, -1, 0, upright};
    }

    return WCUT_OK;
}

static void find_neighbours(orientation *o, int first, int end) {
    wcut_kd_nearest nearest;
    for (int w = first; w < end; w++) {
        wcut_kd_tree_nearest(o->tree, o->waiting[w].place, o->k, &nearest);
        for (int j = 0; j < o->k; j++)
            o->neighbour[(size_t)w * (size_t)o->k + j] = j < nearest.count ? nearest.place[j] : -1;
    }
}

/* edges lead both ways: list for each waiting point whose neighbour it is */
static wcut_status turn_edges(orientation *o) {
    const size_t edges = (size_t)o->waiting_count * (size_t)o->k;
    for (size_t e = 0; e < edges; e++) {
        const int to = o->neighbour[e] >= 0 ? o->number[o->neighbour[e]] : 0;
        if (to > 0) o->first[to]++;
    }
    for (int w = 0; w < o->waiting_count; w++) o->first[w + 1] += o->first[w];
    const size_t total = o->first[o->waiting_count];
    o->back = wcut_alloc(total, sizeof *o->back);
    if (!o->back) return WCUT_NO_MEMORY;
    /* filled from behind, the end of each part becomes its begin */
    for (size_t e = edges; e-- > 0;) {
        const int to = o->neighbour[e] >= 0 ? o->number[o->neighbour[e]] : 0;
        if (to > 0) o->back[--o->first[to]] = (int)(e / (size_t)o->k);
    }
    for (int w = 0; w < o->waiting_count; w++) o->first[w] = o->first[w + 1];
    o->first[o->waiting_count] = total;
    return WCUT_OK;
}

/* ---- walking it ---- */

/* the point has its sign: its waiting neighbours hear of it */
static void orient_settle(orientation *o, int number) {
    const int place = o->waiting[number].place;
    o->number[place] = 0;
    o->done[o->done_count++] = place;
    for (int j = 0; j < o->k; j++) {
        const int p = o->neighbour[(size_t)number * (size_t)o->k + j];
        if (p >= 0 && o->number[p] > 0) orient_offer(o, place, o->number[p] - 1);
    }
    for (size_t e = o->first[number]; e < o->first[number + 1]; e++)
        if (o->number[o->waiting[o->back[e]].place] > 0) orient_offer(o, place, o->back[e]);
}

static void orient_follow(orientation *o) {
    while (o->heap_count > 0) {
        const int number = take_first(o);
        wcut_vec3 *n = &o->normal[o->waiting[number].place];
        if (vec3_dot(*n, o->normal[o->waiting[number].from]) < 0) *n = vec3_scale(-1, *n);
        orient_settle(o, number);
    }
}

/* a piece that nothing fixed reaches begins at its most upright point, and is turned as a whole */
static void follow_piece(orientation *o, int number) {
    const int first = o->done_count;
    orient_settle(o, number);
    orient_follow(o);
    double sum = 0;
    for (int d = first; d < o->done_count; d++) sum += vec3_dot(o->normal[o->done[d]], o->side);
    for (int d = first; sum < 0 && d < o->done_count; d++)
        o->normal[o->done[d]] = vec3_scale(-1, o->normal[o->done[d]]);
}

/* waiting points by uprightness, the most upright first, equal ones by number */
typedef struct rank {
    double upright;
    int number;
} rank;

static int orient_compare(const void *a, const void *b) {
    const rank *x = a, *y = b;
    if (x->upright != y->upright) return x->upright < y->upright ? 1 : -1;
    return (x->number > y->number) - (x->number < y->number);
}

static wcut_status orient_walk(orientation *o, wcut_normals_report *report) {
    const int n = o->waiting_count;
    rank *order = wcut_alloc((size_t)n, sizeof *order);
    const wcut_status status = order ? WCUT_OK : WCUT_NO_MEMORY;

    /* most upright first, in case a piece has no neighbour that is known */
    if (status == WCUT_OK) {
        for (int w = 0; w < n; w++) order[w] = (rank){o->waiting[w].upright, w};
        qsort(order, (size_t)n, sizeof *order, orient_compare);

        /* edges from known points into waiting ones */
        for (size_t e = 0; e < (size_t)n * (size_t)o->k; e++) {
            const int p = o->neighbour[e];
            if (p >= 0 && o->number[p] == 0 && vec3_dot(o->normal[p], o->normal[p]) > 0)
                orient_offer(o, p, (int)(e / (size_t)o->k));
        }

        /* follow the forest; each piece without a known neighbour begins with a guess */
        orient_follow(o);
        for (int w = 0; w < n; w++) {
            if (o->number[o->waiting[order[w].number].place] == 0) continue;
            follow_piece(o, order[w].number);
            report->guessed++;
        }
    }

    wcut_free(order);
    return status;
}

wcut_status wcut_orient(const wcut_kd_tree *tree, int neighbours, wcut_vec3 side, double steep, int threads,
                        wcut_vec3 *normal, wcut_normals_report *report) {
    /* number the points that wait */
    orientation o = {.tree = tree, .side = side, .normal = normal};
    o.k = neighbours < NEIGHBOURS_MAX ? neighbours : NEIGHBOURS_MAX;
    o.number = wcut_alloc((size_t)tree->count, sizeof *o.number);
    wcut_status status = o.number ? list_waiting(&o, steep, report) : WCUT_NO_MEMORY;

    /* find neighbours in blocks, then both directions of every edge, then walk */
    if (status == WCUT_OK && o.waiting_count > 0) {
        const int blocks = o.waiting_count / BLOCK + (o.waiting_count % BLOCK > 0);
#pragma omp parallel for schedule(dynamic) num_threads(wcut_threads(threads))
        for (int b = 0; b < blocks; b++)
            find_neighbours(&o, b * BLOCK, b == blocks - 1 ? o.waiting_count : (b + 1) * BLOCK);
        status = turn_edges(&o);
        if (status == WCUT_OK) status = orient_walk(&o, report);
    }

    /* release the graph */
    wcut_free(o.number);
    wcut_free(o.waiting);
    wcut_free(o.neighbour);
    wcut_free(o.first);
    wcut_free(o.back);
    wcut_free(o.heap);
    wcut_free(o.done);
    return status;
}
