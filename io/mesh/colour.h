/* A value as a colour that the eye orders: viridis. */
#ifndef WCUT_IO_MESH_COLOUR_H
#define WCUT_IO_MESH_COLOUR_H

/* t in [0, 1] (clamped) as red, green, blue in sRGB, 0 .. 255 */
void wcut_colour(double t, double rgb[3]);

/* where value lies between least and greatest, 0 where those are equal */
double wcut_colour_parameter(double value, double min, double greatest);

#endif
