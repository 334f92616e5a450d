/* An order of points that keeps neighbours together (Morton 1966): a stable sort by digits of the bits of their cells,
   the coordinates' taken in turn. Chunks are sorted side by side; a stable sort has one result, however many there are. */
#include "surface/morton.h"

#include <math.h>
#include <stdint.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/threads.h"

enum { BITS = 11, BUCKETS = 1 << BITS, CHUNKS = 64, SMALL = 10000 };

typedef struct sorter {
    int count, chunks, digits;
    const wcut_vec3 *point;
    wcut_vec3 low[CHUNKS], high[CHUNKS];
    int max[3];                /* the last cell along each axis */
    double by[3];              /* from half a coordinate's difference to cells */
    uint64_t code[3][BUCKETS]; /* the bits of a cell's number, where they stand in the code */
    int (*start)[BUCKETS];     /* chunks: where a chunk's next item of a bucket goes */
    uint64_t *now, *next;      /* count: cell, then index */
} sorter;

static int begin_of(const sorter *s, int chunk) { return (int)((int64_t)s->count * chunk / s->chunks); }

static inline wcut_vec3 lower(wcut_vec3 a, wcut_vec3 b) {
    return (wcut_vec3){a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}

static inline wcut_vec3 higher(wcut_vec3 a, wcut_vec3 b) {
    return (wcut_vec3){a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}

static void morton_find_box(sorter *s, int chunk) {
    const int begin = begin_of(s, chunk), end = begin_of(s, chunk + 1);
    wcut_vec3 low = s->point[begin], high = low;
    for (int k = begin + 1; k < end; k++) low = lower(low, s->point[k]), high = higher(high, s->point[k]);
    s->low[chunk] = low, s->high[chunk] = high;
}

/* Cells are halved across their longest side, so that they become cubes, nearly; a halving is a bit of the code, the
   first one its highest. */
static void plan_cells(sorter *s) {
    const wcut_vec3 low = s->low[0], high = s->high[0];
    /* halves keep the difference of the largest doubles finite */
    const double wide[3] = {high.x / 2 - low.x / 2, high.y / 2 - low.y / 2, high.z / 2 - low.z / 2};
    double cell[3] = {wide[0], wide[1], wide[2]};

    /* the longest cell is halved next, until all bits are given */
    const int all = s->digits * BITS;
    int bits[3] = {0, 0, 0}, axis[3 * BITS] = {0};
    for (int b = all - 1; b >= 0; b--) {
        int c = bits[0] < BITS ? 0 : bits[1] < BITS ? 1 : 2;
        for (int other = c + 1; other < 3; other++)
            if (bits[other] < BITS && cell[other] > cell[c]) c = other;
        axis[b] = c;
        bits[c]++, cell[c] /= 2;
    }

    /* each axis: cells per mm, and the code of every cell number */
    for (int c = 0; c < 3; c++) {
        s->max[c] = (1 << bits[c]) - 1;
        s->by[c] = wide[c] > 1e-290 ? (s->max[c] + 1) / wide[c] : 0;
        for (int k = 0; k <= s->max[c]; k++) {
            s->code[c][k] = 0;
            for (int b = 0, bit = 0; b < all; b++)
                if (axis[b] == c) s->code[c][k] |= (uint64_t)(k >> bit++ & 1) << (b + WCUT_MORTON_INDEX);
        }
    }
}

static inline uint64_t code_along(const sorter *s, int axis, double x, double low) {
    const int cell = (int)((x / 2 - low / 2) * s->by[axis]); /* not negative: low is the lowest of all */
    return s->code[axis][cell < s->max[axis] ? cell : s->max[axis]];
}

static void code_points(sorter *s, int chunk) {
    const wcut_vec3 low = s->low[0];
    const int end = begin_of(s, chunk + 1);
    for (int k = begin_of(s, chunk); k < end; k++) {
        const wcut_vec3 p = s->point[k];
        s->now[k] =
            code_along(s, 0, p.x, low.x) | code_along(s, 1, p.y, low.y) | code_along(s, 2, p.z, low.z) | (uint64_t)k;
    }
}

static inline int digit_of(uint64_t item, int pass) {
    return (int)(item >> (WCUT_MORTON_INDEX + BITS * pass) & (BUCKETS - 1));
}

static void count_digits(sorter *s, int chunk, int pass) {
    int *start = s->start[chunk];
    const int end = begin_of(s, chunk + 1);
    for (int b = 0; b < BUCKETS; b++) start[b] = 0;
    for (int k = begin_of(s, chunk); k < end; k++) start[digit_of(s->now[k], pass)]++;
}

static void sum_counts(sorter *s) {
    int sum = 0;
    for (int b = 0; b < BUCKETS; b++)
        for (int c = 0; c < s->chunks; c++) {
            const int here = s->start[c][b];
            s->start[c][b] = sum;
            sum += here;
        }
}

static void move_items(sorter *s, int chunk, int pass) {
    int *start = s->start[chunk];
    const int end = begin_of(s, chunk + 1);
    for (int k = begin_of(s, chunk); k < end; k++) s->next[start[digit_of(s->now[k], pass)]++] = s->now[k];
}

static void morton_sort(sorter *s) {
#pragma omp parallel for schedule(static) num_threads(wcut_threads(s->chunks))
    for (int c = 0; c < s->chunks; c++) morton_find_box(s, c);
    for (int c = 1; c < s->chunks; c++)
        s->low[0] = lower(s->low[0], s->low[c]), s->high[0] = higher(s->high[0], s->high[c]);
    plan_cells(s);
#pragma omp parallel for schedule(static) num_threads(wcut_threads(s->chunks))
    for (int c = 0; c < s->chunks; c++) code_points(s, c);
    for (int pass = 0; pass < s->digits; pass++) {
#pragma omp parallel for schedule(static) num_threads(wcut_threads(s->chunks))
        for (int c = 0; c < s->chunks; c++) count_digits(s, c, pass);
        sum_counts(s);
#pragma omp parallel for schedule(static) num_threads(wcut_threads(s->chunks))
        for (int c = 0; c < s->chunks; c++) move_items(s, c, pass);
        uint64_t *swap = s->now;
        s->now = s->next, s->next = swap;
    }
}

wcut_status wcut_morton_sort(int count, const wcut_vec3 *point, int threads, int digits, uint64_t **items) {
    sorter s = {.count = count, .digits = digits, .point = point};
    s.chunks = count < SMALL ? 1 : threads < CHUNKS ? threads : CHUNKS;
    s.start = wcut_alloc((size_t)s.chunks, sizeof *s.start);
    s.now = wcut_alloc((size_t)count, sizeof *s.now), s.next = wcut_alloc((size_t)count, sizeof *s.next);
    const wcut_status status = s.start && s.now && s.next ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK && count > 0) morton_sort(&s);
    if (status == WCUT_OK)
        *items = s.now;
    else
        wcut_free(s.now);
    wcut_free(s.next);
    wcut_free(s.start);
    return status;
}

wcut_status wcut_morton_order(int count, const wcut_vec3 *point, int threads, int **order) {
    uint64_t *items;
    int *list = wcut_alloc((size_t)count, sizeof *list);
    const wcut_status status = list ? wcut_morton_sort(count, point, threads, 2, &items) : WCUT_NO_MEMORY;
    if (status != WCUT_OK) {
        wcut_free(list);
        return status;
    }
    for (int k = 0; k < count; k++) list[k] = wcut_morton_index(items[k]);
    wcut_free(items);
    *order = list;
    return WCUT_OK;
}
