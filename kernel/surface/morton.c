/* An order of points that keeps neighbours together (Morton 1966). */
#include "surface/morton.h"

#include <stdint.h>

#include "base/alloc.h"
#include "base/numbers.h"

enum { BITS = 10, CELLS = 1 << BITS, BUCKETS = 1 << 10, PASSES = 3 };

/* every third bit: abc -> a00b00c */
static uint32_t spread(uint32_t x) {
    x = (x | x << 16) & 0x030000ffu;
    x = (x | x << 8) & 0x0300f00fu;
    x = (x | x << 4) & 0x030c30c3u;
    return (x | x << 2) & 0x09249249u;
}

static uint32_t cell_of(double x, double low, double high) {
    /* halves keep the difference of the largest doubles finite */
    const double wide = high / 2 - low / 2, share = wide > 0 ? (x / 2 - low / 2) / wide : 0;
    return (uint32_t)clamp(share * CELLS, 0, CELLS - 1);
}

static void code_points(int count, const wcut_vec3 *point, uint32_t *code) {
    wcut_vec3 low = point[0], high = point[0];
    for (int k = 1; k < count; k++) {
        low.x = fmin(low.x, point[k].x), low.y = fmin(low.y, point[k].y), low.z = fmin(low.z, point[k].z);
        high.x = fmax(high.x, point[k].x), high.y = fmax(high.y, point[k].y), high.z = fmax(high.z, point[k].z);
    }
    /* one scale for all axes, so that a flat cloud gets all its bits along its long sides */
    const double wide = fmax(high.x / 2 - low.x / 2, fmax(high.y / 2 - low.y / 2, high.z / 2 - low.z / 2));
    for (int k = 0; k < count; k++)
        code[k] = spread(cell_of(point[k].x, low.x, low.x + 2 * wide)) |
                  spread(cell_of(point[k].y, low.y, low.y + 2 * wide)) << 1 |
                  spread(cell_of(point[k].z, low.z, low.z + 2 * wide)) << 2;
}

/* stable counting sort by one digit */
static void sort_pass(int count, const uint32_t *code, int shift, const int *from, int *to) {
    int start[BUCKETS + 1] = {0};
    for (int k = 0; k < count; k++) start[(code[k] >> shift & (BUCKETS - 1)) + 1]++;
    for (int b = 0; b < BUCKETS; b++) start[b + 1] += start[b];
    for (int k = 0; k < count; k++) to[start[code[from[k]] >> shift & (BUCKETS - 1)]++] = from[k];
}

wcut_status wcut_morton_order(int count, const wcut_vec3 *point, int **order) {
    uint32_t *code = wcut_alloc((size_t)count, sizeof *code);
    int *now = wcut_alloc((size_t)count, sizeof *now), *next = wcut_alloc((size_t)count, sizeof *next);
    const wcut_status status = code && now && next ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK && count > 0) {
        code_points(count, point, code);
        for (int k = 0; k < count; k++) now[k] = k;
        for (int pass = 0; pass < PASSES; pass++) {
            sort_pass(count, code, 10 * pass, now, next);
            int *swap = now;
            now = next, next = swap;
        }
    }
    if (status == WCUT_OK) {
        *order = now;
        now = NULL;
    }
    wcut_free(next);
    wcut_free(now);
    wcut_free(code);
    return status;
}
