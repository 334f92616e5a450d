/* On which side of a line a point lies: the sign of a determinant, never wrong (Shewchuk 1997). */
#ifndef WCUT_SOLID_TURN_H
#define WCUT_SOLID_TURN_H

/* a point of a plane */
typedef struct wcut_flat {
    double p, q;
} wcut_flat;

/* positive where a, b, c turn counter-clockwise, negative where clockwise, 0 where they are exactly in line */
double wcut_turn(wcut_flat a, wcut_flat b, wcut_flat c);

#endif
