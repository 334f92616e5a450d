/* What gives way to the wire's tension: its own length, and the mounts. */
#ifndef WCUT_CUT_COMPLIANCE_H
#define WCUT_CUT_COMPLIANCE_H

#include <stdbool.h>
#include <wirecut/vec3.h>

typedef struct wcut_mount { /* A or B: where it is led to, and how it was bent at the beginning of the step */
    wcut_vec3 at;           /* [mm] */
    wcut_vec3 offset;       /* [mm] of the wire's end from it */
    wcut_vec3 pull;         /* [N] of the wire */
    bool set;               /* false: nothing yet, it is in its steady state */
} wcut_mount;

/* A step without has NULL in its place. */
typedef struct wcut_compliance {
    const double *rest; /* n-1 [mm] edges warm and without tension; NULL: all as the step says, and stiff */
    double softness;    /* [1/N] stretch of an edge a tension, 1/EA */
    wcut_vec3 give[2];  /* [mm/N] of mounts A and B along x, y, z; 0: rigid */
    double settling;    /* [s] of a mount */
    wcut_mount mount[2];
} wcut_compliance;

/* An end of the wire on its mount: X_0 = (c + kappa X_1) / (1 + kappa) in each coordinate, and how that moves with X_1, S_0
   and ln r. */
typedef struct wcut_end {
    wcut_vec3 at;
    wcut_vec3 by_next;     /* [1] of each coordinate by its own */
    wcut_vec3 by_tension;  /* [mm/N] */
    wcut_vec3 by_log_rate; /* [mm] */
} wcut_end;

/* length of edge e of rest length l under tension s [mm] */
static inline double wcut_edge_length(const wcut_compliance *y, double l, int e, double s) {
    return y && y->rest ? y->rest[e] * (1 + y->softness * s) : l;
}

/* d length / d s of that edge [mm/N] */
static inline double wcut_edge_softness(const wcut_compliance *y, int e) {
    return y && y->rest ? y->rest[e] * y->softness : 0;
}

/* The end on mount 0 or 1, the next node at x, the tension s in the edge between, which is as long as `length` and gets
   longer by `softness` a unit of s. */
wcut_end wcut_compliance_end(const wcut_compliance *y, int mount, wcut_vec3 x, double s, double length, double softness,
                             double rate);

#endif
