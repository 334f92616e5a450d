/* The spans of a bicubic surface, each as its polynomial about its middle, with a radius within which a stationary foot
   is proven to be the closest of all. */
#ifndef WCUT_SURFACE_NEWTON_SPANS_H
#define WCUT_SURFACE_NEWTON_SPANS_H

#include <stdbool.h>
#include <wirecut/surface.h>

enum { WCUT_CUBIC = 3, WCUT_SPAN_ORDER = WCUT_CUBIC + 1 };

typedef struct wcut_span {
    wcut_vec3 power[WCUT_SPAN_ORDER][WCUT_SPAN_ORDER]; /* [of t][of s], both from -1/2 to 1/2 */
    double radius;                                     /* [mm] as above; not positive where nothing is proven */
    double speed;                                      /* no less than |S_s| and |S_t| */
    double turn;                                       /* no less than any third derivative */
} wcut_span;

/* where a query's parameters are, nearly: its offset from the middle times both rows; about the surface's centre */
typedef struct wcut_span_guide {
    float middle[3], to_s[3], to_t[3];
} wcut_span_guide;

/* bounds of a span or a block of them, parameters scaled alike everywhere so that derivatives are lengths */
typedef struct wcut_span_bounds {
    wcut_vec3 low, high; /* a box that holds it */
    double sigma;        /* least singular value of (S_u, S_v), from below */
    double bend;         /* second derivatives, from above */
} wcut_span_bounds;

struct wcut_newton_foot {
    int columns, rows;
    double *u, *v; /* columns + 1, rows + 1: where spans begin and end */
    wcut_span *span;
    wcut_span_guide *guide; /* both rows x columns */
    wcut_vec3 centre;
    double tolerance; /* [mm] of a foot */
};

typedef struct wcut_newton_foot wcut_newton_foot;

/* size: [mm] of the surface and its coordinates. *newton is NULL where the surface is not bicubic, polynomial and once
   continuously differentiable, or has more than 200000 spans: then there is no newton way. WCUT_NO_MEMORY: nothing was
   written. */
wcut_status wcut_newton_foot_create(const wcut_surface *surface, double size, wcut_newton_foot **newton);
void wcut_newton_foot_destroy(wcut_newton_foot *newton);

/* fills span, guide and bounds (rows x columns) of a structure whose knots stand; WCUT_NO_MEMORY */
wcut_status wcut_newton_foot_spans(const wcut_surface *surface, struct wcut_newton_foot *q, wcut_span_bounds *bounds);

/* finds every span's radius; WCUT_NO_MEMORY */
wcut_status wcut_newton_foot_prove(struct wcut_newton_foot *newton, wcut_span_bounds *bounds);

#endif
