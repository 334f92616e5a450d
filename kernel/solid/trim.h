/* The part of a sheet over the block: where it meets the block's four sides, and a point of it by (s, t). */
#ifndef WCUT_SOLID_TRIM_H
#define WCUT_SOLID_TRIM_H

#include <wirecut/status.h>

#include "solid/sheet.h"

/* the four sides that a sheet is cut off at, upright planes */
typedef struct wcut_sides {
    double x[2], y[2]; /* [mm] low, high */
} wcut_sides;

/* where the plane x = const meets the border: parameters at y = low and at y = high */
typedef struct wcut_rib {
    double x, u[2], v[2];
} wcut_rib;

typedef struct wcut_trim {
    const wcut_sheet *sheet;
    wcut_sides sides;
    int ribs;
    wcut_rib *rib; /* ribs, at equal steps of x from side to side */
} wcut_trim;

/* Find the sheet's border over the sides: every plane x = const between them meets the sheet in one curve that enters
   at y low and leaves at y high, once each. WCUT_DEGENERATE (it does not: error says where), WCUT_NO_MEMORY: nothing
   was written. The caller ends it with wcut_trim_clear. */
wcut_status wcut_trim_begin(const wcut_sheet *sheet, wcut_sides sides, wcut_trim *trim, wcut_error *error);

/* free what wcut_trim_begin gave; a zeroed trim is allowed */
void wcut_trim_clear(wcut_trim *trim);

/* the border at any x between the sides, exact; WCUT_DEGENERATE: nothing was written */
wcut_status wcut_trim_rib(const wcut_trim *trim, double x, wcut_rib *rib, wcut_error *error);

/* The sheet's point at v in the plane of a rib. *u: a guess, then the parameter. WCUT_DEGENERATE: *u is as it was. */
wcut_status wcut_trim_point(const wcut_trim *trim, double x, double v, double *u, wcut_sheet_point *point,
                            wcut_error *error);

#endif
