/* Whether points are in one place, on one line, or span more. */
#ifndef WCUT_SCAN_SPAN_H
#define WCUT_SCAN_SPAN_H

#include <stdbool.h>
#include <stddef.h>
#include <wirecut/vec3.h>

/* 0 one place, 1 one line, 2 more: count points, 1 or more, each `stride` bytes behind the one before; centroid may be
   NULL */
int wcut_span_of(int count, const wcut_vec3 *point, size_t stride, wcut_vec3 *centroid);

/* more than a line */
static inline bool wcut_spans_plane(int count, const wcut_vec3 *point, size_t stride, wcut_vec3 *centroid) {
    return wcut_span_of(count, point, stride, centroid) == 2;
}

#endif
