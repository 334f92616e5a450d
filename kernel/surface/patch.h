/* A piece of a surface as its Taylor polynomial and bounds on the rest: how far it is from a point, and how convex. */
#ifndef WCUT_SURFACE_PATCH_H
#define WCUT_SURFACE_PATCH_H

#include <stdbool.h>
#include <wirecut/surface.h>

/* S over [u0, u1] x [v0, v1]. Derivatives are times the widths, in the middle; bounds hold everywhere in the piece, and
   are infinite where nothing is known. |S - (centre + s side_u + t side_v)| <= thickness for |s|, |t| <= 1/2. */
typedef struct wcut_patch {
    double u0, u1, v0, v1;
    wcut_vec3 centre, side_u, side_v, bow_uu, bow_uv, bow_vv; /* S, S_u, S_v, S_uu, S_uv, S_vv */
    double bend_uu, bend_uv, bend_vv;                         /* bounds on |S_uu|, |S_uv|, |S_vv| */
    double turn_uuu, turn_uuv, turn_uvv, turn_vvv;            /* bounds on the third derivatives */
    double thickness;                                         /* (bend_uu + 2 bend_uv + bend_vv) / 8 (Taylor) */
    double radius;                                            /* of a sphere about the centre that holds the piece */
} wcut_patch;

/* derive what stands in the middle, tighter bends, thickness and radius from the rectangle and the bounds */
void wcut_patch_fit(const wcut_surface *surface, wcut_patch *patch);

/* a piece of which nothing is known but a sphere that holds it */
wcut_patch wcut_patch_ball(double u0, double u1, double v0, double v1, wcut_vec3 centre, double radius);

/* No point of the piece is closer to p than this, which may be negative. Where the sphere alone says at least `enough`,
   its bound will do. s, t: where on the parallelogram p is closest; not written where the sphere sufficed. */
double wcut_patch_distance(const wcut_patch *patch, wcut_vec3 p, double enough, double *s, double *t);

/* is |S - p|^2 convex over the piece? `true` is proven, `false` says nothing; *least: no point is closer to p */
bool wcut_patch_is_convex(const wcut_patch *patch, wcut_vec3 p, double *min);

/* two halves across the longer side */
void wcut_patch_halve(const wcut_surface *surface, const wcut_patch *patch, wcut_patch half[2]);

#endif
