/* What a design consists of: lag, sag and the rise of both edges over the feed, as splines, and the wire's ends from
   them. */
#ifndef WCUT_INVERSE_CURVES_H
#define WCUT_INVERSE_CURVES_H

#include "inverse/scan.h"

typedef enum wcut_design_curve {
    WCUT_DESIGN_CURVE_SAG,
    WCUT_DESIGN_CURVE_LAG,
    WCUT_DESIGN_CURVE_RISE_A,
    WCUT_DESIGN_CURVE_RISE_B,
    WCUT_DESIGN_CURVES
} wcut_design_curve;

enum { WCUT_KNOTS_MAX = 40 };

/* Clamped uniform cubic splines over t in 0 .. 1, the middle of the wire's ends at y = first + t (last - first). */
typedef struct wcut_design_curves {
    int coefficients;                                 /* of each curve, 4 .. WCUT_KNOTS_MAX */
    bool free_edges;                                  /* the rises are unknowns; else 0 */
    double first, last;                               /* [mm] */
    double value[WCUT_DESIGN_CURVES][WCUT_KNOTS_MAX]; /* [mm] */
} wcut_design_curves;

/* how many unknowns there are; unknown k belongs to curve k / coefficients */
int wcut_design_unknowns(const wcut_design_curves *curves);

/* a curve at t, with its slope by t [mm] where it is not NULL */
double wcut_design_curve_at(const wcut_design_curves *curves, wcut_design_curve which, double t, double *slope);

/* the four coefficients that matter at t, their weights and the weights of the slope; gives the first of them */
int wcut_design_basis(int coefficients, double t, double weight[4], double slope[4]);

/* the same curves with more coefficients, to rounding where the new knots hold the old ones, else nearly */
void wcut_design_refine(wcut_design_curves *curves, int coefficients);

/* the curves through the rows of a scan; false where no row lies in the block */
bool wcut_design_start(const wcut_design_target *target, const wcut_scan *scan, bool free_edges, int coefficients,
                       wcut_design_curves *out);

/* wires of an ordinary sag without lag, their ends on the target */
void wcut_design_start_flat(const wcut_design_target *target, int coefficients, wcut_design_curves *out);

/* The same for corrections of paths: curves as what the mounts' ends get beside where base_a and base_b have them, the lag
   as before, the rises in z, the sag as by how much their distance gets less, which is set along x. The wire keeps its
   length. */
void wcut_design_correct(const wcut_design_curves *curves, int stations, const wcut_vec3 *base_a,
                         const wcut_vec3 *base_b, wcut_vec3 *end_a, wcut_vec3 *end_b, wcut_vec3 *by_a, wcut_vec3 *by_b,
                         double *by_length);

/* The wire's ends at `stations` even values of t, its length, and how each unknown moves them (unknowns x stations each,
   or NULL): y = middle +- lag/2, z = target + rise, length = chord + 8 sag^2 / (3 W), a flat parabola's. */
void wcut_design_place(const wcut_design_curves *curves, const wcut_design_target *target, int stations,
                       wcut_vec3 *end_a, wcut_vec3 *end_b, double *length, wcut_vec3 *by_a, wcut_vec3 *by_b,
                       double *by_length);

#endif
