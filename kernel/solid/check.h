/* What a half is like: closed, oriented, how many pieces, how large, how it leaves the mould. */
#ifndef WCUT_SOLID_CHECK_H
#define WCUT_SOLID_CHECK_H

#include <stdbool.h>
#include <wirecut/mould.h>

/* Every directed edge once, its opposite once; pieces by shared corners; volume, area and box.
   WCUT_NO_MEMORY: nothing was written. Fields of the cut face are not touched. */
wcut_status wcut_check_boundary(const wcut_mesh *mesh, wcut_half_report *report);

/* The middle of an edge that is not run through once either way; false: there is none. WCUT_NO_MEMORY: nothing. */
wcut_status wcut_check_open_edge(const wcut_mesh *mesh, bool *found, wcut_vec3 *place);

/* Area, draft and undercut of the triangles of the cut face; tag: 1 for those, triangle_count; pull: unit; draft:
   vertex_count, the least at each vertex of the cut face, NaN elsewhere. */
void wcut_check_draft(const wcut_mesh *mesh, const unsigned char *tag, wcut_vec3 pull, wcut_half_report *report,
                      double *draft);

#endif
