/* wirecut/angle.h - degrees and radians: files and options say degrees, the API radians. */
#ifndef WCUT_ANGLE_H
#define WCUT_ANGLE_H

#define WCUT_DEG_PER_RAD (180 / 3.14159265358979323846)
#define WCUT_RAD_PER_DEG (3.14159265358979323846 / 180)

#endif
