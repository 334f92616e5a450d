/* Points that come again. */
#ifndef WCUT_SCAN_DUPLICATES_H
#define WCUT_SCAN_DUPLICATES_H

#include <wirecut/status.h>
#include <wirecut/vec3.h>

/* Mark points as near as `tolerance` [mm] (0: equal) to an earlier one that is not marked: 1 in duplicate, else it is
   left as it is. Points are finite, up to 1e12. WCUT_NO_MEMORY: duplicate may be written in part. */
wcut_status wcut_duplicates_find(int count, const wcut_vec3 *point, double tolerance, unsigned char *duplicate);

#endif
