/* Smooth lines in a picture. */
#ifndef WCUT_PHOTO_DRAW_H
#define WCUT_PHOTO_DRAW_H

#include <wirecut/overlay.h>

typedef struct wcut_colour {
    unsigned char red, green, blue;
} wcut_colour;

/* a straight line from (u0, v0) to (u1, v1) [px], smooth at its sides; what is outside the picture is left out */
void wcut_draw_line(wcut_picture *picture, double u0, double v0, double u1, double v1, double width,
                    wcut_colour colour);

/* a value from 0 to 1 on a scale that is readable on grey (turbo-like: blue, green, yellow, red) */
wcut_colour wcut_colour_of(double value);

/* of a phase of the cut */
wcut_colour wcut_colour_of_phase(wcut_phase phase);

#endif
