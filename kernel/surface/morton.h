/* An order of points that keeps neighbours together (Morton 1966). */
#ifndef WCUT_SURFACE_MORTON_H
#define WCUT_SURFACE_MORTON_H

#include <wirecut/status.h>
#include <wirecut/vec3.h>

/* count indices along the Z-curve through the points' bounding box, equal cells in the order given, the same for any
   number of threads; the caller frees them. Points are finite. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_morton_order(int count, const wcut_vec3 *point, int threads, int **order);

#endif
