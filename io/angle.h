/* Files say degrees, the API radians. */
#ifndef WCUT_IO_ANGLE_H
#define WCUT_IO_ANGLE_H

#define DEG_PER_RAD (180 / 3.14159265358979323846)
#define RAD_PER_DEG (3.14159265358979323846 / 180)

#endif
