/* An order of points that keeps neighbours together (Morton 1966). */
#ifndef WCUT_SURFACE_MORTON_H
#define WCUT_SURFACE_MORTON_H

#include <stdint.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

/* an item of a sorted cloud: the code of its cell in the higher bits, its index in the lower ones */
enum { WCUT_MORTON_INDEX = 31 };
static inline int wcut_morton_index(uint64_t item) { return (int)(item & (((uint64_t)1 << WCUT_MORTON_INDEX) - 1)); }

/* count items in their order, codes of 11 `digits` bits (2 or 3 digits); else as below */
wcut_status wcut_morton_sort(int count, const wcut_vec3 *point, int threads, int digits, uint64_t **items);

/* count indices along the Z-curve through the points' bounding box, equal cells in the order given, the same for any
   number of threads; the caller frees them. Points are finite. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_morton_order(int count, const wcut_vec3 *point, int threads, int **order);

#endif
