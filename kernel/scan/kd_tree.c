/* A balanced k-d tree of points (Bentley 1975): the nearest of them, and those within a radius. */
#include "scan/kd_tree.h"

#include <stdint.h>
#include <string.h>

#include "base/alloc.h"
#include "base/threads.h"
#include "base/vec3.h"

enum { DEPTH_MAX = 32, PARALLEL_LEVEL = 4, INSERTION = 12 };

/* a point on its way to its leaf */
typedef struct item {
    double at[3];
    int index;
} item;

/* ---- building ---- */

static inline void swap_items(item *a, item *b) {
    const item keep = *a;
    *a = *b;
    *b = keep;
}

static double median3(double a, double b, double c) {
    if (a > b) {
        const double keep = a;
        a = b;
        b = keep;
    }
    return c < a ? a : c > b ? b : c;
}

/* a number in 0 .. n-1 that no input can foresee in a way that matters; fixed for a range, so that runs repeat */
static int kd_tree_pick(uint64_t *state, int n) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (int)((*state >> 33) % (uint64_t)n);
}

static void sort_few(item *a, int first, int end, int axis) {
    for (int i = first + 1; i < end; i++) {
        const item keep = a[i];
        int j = i;
        for (; j > first && a[j - 1].at[axis] > keep.at[axis]; j--) a[j] = a[j - 1];
        a[j] = keep;
    }
}

/* put the item of rank `rank` into its place, no larger one before it, no smaller one behind it (Hoare 1961) */
static void select_rank(item *a, int first, int end, int rank, int axis) {
    uint64_t state = (uint64_t)first * 2654435761u + (uint64_t)end;
    while (end - first > INSERTION) {
        /* the pivot is the median of three items drawn by a seed of the range, so that no order of points is slow */
        const int n = end - first;
        const double pivot =
            median3(a[first + kd_tree_pick(&state, n)].at[axis], a[first + kd_tree_pick(&state, n)].at[axis],
                    a[first + kd_tree_pick(&state, n)].at[axis]);
        int i = first, j = end - 1;
        while (i <= j) { /* equal items stop both sides, so that many of them are halved too */
            while (a[i].at[axis] < pivot) i++;
            while (a[j].at[axis] > pivot) j--;
            if (i <= j) swap_items(&a[i++], &a[j--]);
        }

        /* go on in the part that holds the rank */
        if (rank <= j)
            end = j + 1;
        else if (rank >= i)
            first = i;
        else
            return;
    }

    /* few items are sorted at once */
    sort_few(a, first, end, axis);
}

static void kd_tree_bound(const item *a, int first, int end, double low[3], double high[3]) {
    memcpy(low, a[first].at, 3 * sizeof *low);
    memcpy(high, a[first].at, 3 * sizeof *high);
    for (int i = first + 1; i < end; i++) {
        for (int c = 0; c < 3; c++) {
            low[c] = a[i].at[c] < low[c] ? a[i].at[c] : low[c];
            high[c] = a[i].at[c] > high[c] ? a[i].at[c] : high[c];
        }
    }
}

static int widest(const double low[3], const double high[3]) {
    int axis = 0;
    for (int c = 1; c < 3; c++)
        if (high[c] - low[c] > high[axis] - low[axis]) axis = c;
    return axis;
}

/* the ranges below node k, down to the leaves; the upper levels go to other threads */
static void kd_tree_divide(wcut_kd_tree *t, item *a, int k, int level, int first, int end) {
    double low[3], high[3];
    kd_tree_bound(a, first, end, low, high);
    t->node[k] = (wcut_kd_node){vec3(low[0], low[1], low[2]), vec3(high[0], high[1], high[2])};
    if (level == t->levels) return;
    const int middle = first + (end - first) / 2;
    select_rank(a, first, end, middle, widest(low, high));
#pragma omp task if (level < PARALLEL_LEVEL) default(none) firstprivate(t, a, k, level, first, middle)
    kd_tree_divide(t, a, 2 * k + 1, level + 1, first, middle);
    kd_tree_divide(t, a, 2 * k + 2, level + 1, middle, end);
#pragma omp taskwait
}

wcut_status wcut_kd_tree_build(int count, const wcut_vec3 *point, int threads, wcut_kd_tree *tree) {
    /* levels until a leaf holds WCUT_KD_LEAF points at most */
    wcut_kd_tree t = {.count = count};
    while (count >> t.levels > WCUT_KD_LEAF) t.levels++;
    item *items = wcut_alloc((size_t)count, sizeof *items);
    t.point = wcut_alloc((size_t)count, sizeof *t.point);
    t.index = wcut_alloc((size_t)count, sizeof *t.index);
    t.node = wcut_alloc(((size_t)2 << t.levels) - 1, sizeof *t.node);

    /* all or nothing */
    if (!items || !t.point || !t.index || !t.node) {
        wcut_free(items);
        wcut_kd_tree_clear(&t);
        return WCUT_NO_MEMORY;
    }

    /* divide the items in place; the tasks fork where the ranges are large */
    for (int i = 0; i < count; i++) items[i] = (item){{point[i].x, point[i].y, point[i].z}, i};
#pragma omp parallel num_threads(wcut_threads(threads))
#pragma omp single
    kd_tree_divide(&t, items, 0, 0, 0, count);

    /* points in the order of the tree, with their numbers */
    for (int i = 0; i < count; i++) {
        t.point[i] = vec3(items[i].at[0], items[i].at[1], items[i].at[2]);
        t.index[i] = items[i].index;
    }
    wcut_free(items);
    *tree = t;

    return WCUT_OK;
}

void wcut_kd_tree_clear(wcut_kd_tree *tree) {
    wcut_free(tree->point);
    wcut_free(tree->index);
    wcut_free(tree->node);
    *tree = (wcut_kd_tree){0};
}

/* ---- queries ---- */

/* how far x is outside low .. high; comparisons, since fmax is a call that minds NaN */
static inline double outside(double x, double low, double high) { return x < low ? low - x : x > high ? x - high : 0; }

/* squared distance from a box; 0 inside */
static inline double box_square(const wcut_kd_node *n, wcut_vec3 p) {
    const double x = outside(p.x, n->low.x, n->high.x), y = outside(p.y, n->low.y, n->high.y),
                 z = outside(p.z, n->low.z, n->high.z);
    return x * x + y * y + z * z;
}

static inline double point_square(wcut_vec3 a, wcut_vec3 b) {
    const wcut_vec3 d = vec3_sub(a, b);
    return vec3_dot(d, d);
}

/* a node that is still to be visited */
typedef struct visit {
    int k, level, first, end;
    double square; /* of its box */
} visit;

/* the leaf nearest to p first: go down from v, the further children go onto the stack */
static visit kd_tree_descend(const wcut_kd_tree *t, visit v, wcut_vec3 p, double limit, visit *stack, int *depth) {
    while (v.level < t->levels) {
        const int middle = v.first + (v.end - v.first) / 2;
        visit a = {2 * v.k + 1, v.level + 1, v.first, middle, box_square(&t->node[2 * v.k + 1], p)};
        visit b = {2 * v.k + 2, v.level + 1, middle, v.end, box_square(&t->node[2 * v.k + 2], p)};
        if (b.square < a.square) {
            const visit keep = a;
            a = b;
            b = keep;
        }
        if (b.square < limit) stack[(*depth)++] = b;
        v = a;
    }
    return v;
}

/* a point into the list of the k nearest, by distance */
static inline void insert(wcut_kd_nearest *n, int k, double square, int place) {
    int j = n->count < k ? n->count++ : k - 1;
    for (; j > 0 && n->square[j - 1] > square; j--) {
        n->square[j] = n->square[j - 1];
        n->place[j] = n->place[j - 1];
    }
    n->square[j] = square;
    n->place[j] = place;
}

void wcut_kd_tree_nearest(const wcut_kd_tree *t, int place, int k, wcut_kd_nearest *nearest) {
    const wcut_vec3 p = t->point[place];
    visit stack[DEPTH_MAX];
    int depth = 1;
    double limit = INFINITY;
    stack[0] = (visit){0, 0, 0, t->count, 0};
    nearest->count = 0;
    while (depth > 0) {
        const visit top = stack[--depth];
        if (top.square >= limit) continue;
        const visit leaf = kd_tree_descend(t, top, p, limit, stack, &depth);
        for (int i = leaf.first; i < leaf.end; i++) {
            const double square = point_square(t->point[i], p);
            if (square >= limit || i == place) continue;
            insert(nearest, k, square, i);
            if (nearest->count == k) limit = nearest->square[k - 1];
        }
    }
}

int wcut_kd_tree_within(const wcut_kd_tree *t, int place, double radius, int max) {
    const wcut_vec3 p = t->point[place];
    const double limit = radius * radius;
    visit stack[DEPTH_MAX];
    int depth = 1, count = 0;
    stack[0] = (visit){0, 0, 0, t->count, 0};
    while (depth > 0) {
        const visit leaf = kd_tree_descend(t, stack[--depth], p, nextafter(limit, INFINITY), stack, &depth);
        for (int i = leaf.first; i < leaf.end; i++)
            if (i != place && point_square(t->point[i], p) <= limit && ++count == max) return count;
    }
    return count;
}

double wcut_kd_tree_distance(const wcut_kd_tree *t, wcut_vec3 p, double limit) {
    visit stack[DEPTH_MAX];
    int depth = 1;
    double min = limit * limit;
    stack[0] = (visit){0, 0, 0, t->count, 0};
    while (depth > 0) {
        const visit top = stack[--depth];
        if (top.square >= min) continue;
        const visit leaf = kd_tree_descend(t, top, p, min, stack, &depth);
        for (int i = leaf.first; i < leaf.end; i++) {
            const double square = point_square(t->point[i], p);
            min = square < min ? square : min;
        }
    }
    return sqrt(min);
}
