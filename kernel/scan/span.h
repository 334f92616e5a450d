/* Whether points span more than a line. */
#ifndef WCUT_SCAN_SPAN_H
#define WCUT_SCAN_SPAN_H

#include <stdbool.h>
#include <stddef.h>
#include <wirecut/vec3.h>

/* count points, 1 or more, each `stride` bytes behind the one before; centroid may be NULL */
bool wcut_spans_plane(int count, const wcut_vec3 *point, size_t stride, wcut_vec3 *centroid);

#endif
