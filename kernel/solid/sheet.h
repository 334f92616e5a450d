/* The cut as a function of the surface's parameters: the wire's surface, or beside it by half the kerf, prolonged. */
#ifndef WCUT_SOLID_SHEET_H
#define WCUT_SOLID_SHEET_H

#include <wirecut/surface.h>

/* X(u, v) = S + side width n, S prolonged straight beyond its domain (bilinear at the corners), n = S_u x S_v / |...| */
typedef struct wcut_sheet {
    const wcut_surface *surface;
    const wcut_surface *width; /* [mm] its z, over the same parameters; NULL where the sheet is the surface itself */
    double side;               /* +1/2 above, -1/2 below */
    double first[2], last[2];  /* the part of the surface's domain that is taken; beyond it the sheet is straight */
} wcut_sheet;

typedef struct wcut_sheet_point {
    wcut_vec3 at, along_u, along_v; /* X, X_u, X_v */
    double facing;                  /* (X_u x X_v) . n / (|S_u| |S_v|): not positive where the sheet is folded over */
} wcut_sheet_point;

/* the surface itself */
wcut_sheet wcut_sheet_of(const wcut_surface *surface);

/* a point, at any finite u and v */
wcut_sheet_point wcut_sheet_eval(const wcut_sheet *sheet, double u, double v);

/* [mm] how far beyond the part that is taken the sheet is prolonged at u, v: along the wire and along the feed */
void wcut_sheet_prolonged(const wcut_sheet *sheet, double u, double v, double *wire, double *feed);

#endif
