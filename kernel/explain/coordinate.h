/* What is fitted of an effect: one of its values, on a scale, with a prior and bounds. */
#ifndef WCUT_EXPLAIN_COORDINATE_H
#define WCUT_EXPLAIN_COORDINATE_H

/* how a value is fitted: as it is, by its logarithm, or by its reciprocal (a stiffness without end is no effect) */
typedef enum wcut_coordinate_scale {
    WCUT_COORDINATE_SCALE_LINEAR,
    WCUT_COORDINATE_SCALE_LOG,
    WCUT_COORDINATE_SCALE_RECIPROCAL
} wcut_coordinate_scale;

/* A value of an effect that is fitted; centre, spread, step and bounds are on the fitted scale. */
typedef struct wcut_coordinate {
    int at; /* of effect.value */
    wcut_coordinate_scale scale;
    double centre,
        spread;       /* normal prior: wide enough to leave the plausible range (NOTATION.md, Effects) to the data */
    double step;      /* of the finite difference */
    double low, high; /* the fit stays inside */
} wcut_coordinate;

#endif
