/* On which side of a line a point lies: the sign of a determinant, never wrong (Shewchuk 1997). */
#ifndef WCUT_SOLID_ORIENT2D_H
#define WCUT_SOLID_ORIENT2D_H

/* a point of a plane */
typedef struct wcut_point2d {
    double p, q;
} wcut_point2d;

/* positive where a, b, c turn counter-clockwise, negative where clockwise, 0 where they are exactly in line */
double wcut_orient2d(wcut_point2d a, wcut_point2d b, wcut_point2d c);

#endif
