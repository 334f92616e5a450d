/* The colours of deviations: blue below, grey at zero, orange above. */
#ifndef WCUT_IO_SCAN_COLOUR_H
#define WCUT_IO_SCAN_COLOUR_H

/* the colour of a value, strongest at and beyond +- limit, which is positive */
void wcut_deviation_colour(double value, double limit, unsigned char rgb[3]);

#endif
