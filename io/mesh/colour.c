/* A value as a colour that the eye orders: viridis (van der Walt, Smith 2015; CC0), ten of its colours and lines
   between them; lightness grows evenly, also in print and for the colour-blind. */
#include "io/mesh/colour.h"

enum { ANCHORS = 10 };
static const unsigned char anchor[ANCHORS][3] = {{68, 1, 84},    {72, 40, 120},  {62, 73, 137},  {49, 104, 142},
                                                 {38, 130, 142}, {31, 158, 137}, {53, 183, 121}, {110, 206, 88},
                                                 {181, 222, 43}, {253, 231, 37}};

void wcut_colour(double t, double rgb[3]) {
    double at = t > 0 ? (t < 1 ? t : 1) * (ANCHORS - 1) : 0;
    int low = at < ANCHORS - 2 ? (int)at : ANCHORS - 2;
    for (int k = 0; k < 3; k++) rgb[k] = anchor[low][k] + (at - low) * (anchor[low + 1][k] - anchor[low][k]);
}

double wcut_colour_parameter(double value, double min, double greatest) {
    /* halves, so that the range of two huge values does not overflow */
    double range = greatest / 2 - min / 2;
    return range > 0 ? (value / 2 - min / 2) / range : 0;
}
