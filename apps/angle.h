/* Options, files and pages say degrees, the API radians. */
#ifndef APP_ANGLE_H
#define APP_ANGLE_H

#define DEG_PER_RAD (180 / 3.14159265358979323846)
#define RAD_PER_DEG (3.14159265358979323846 / 180)

#endif
