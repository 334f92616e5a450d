/* One robot's program in its controller's language. */
#ifndef WCUT_IO_ROBOT_ROBOT_PROGRAM_H
#define WCUT_IO_ROBOT_ROBOT_PROGRAM_H

#include <wirecut/robot.h>
#include <wirecut/robot_file.h>

#include "io/file/text.h"

/* a number with a fixed count of decimals, 0 .. 9, without an exponent whatever it is */
void wcut_text_fixed(wcut_text *text, double value, int decimals);

/* the program of robot 0 or 1; names are checked */
void wcut_urscript_put(wcut_text *text, const wcut_robot_motion *motion, const wcut_robot_names *names, int robot);
void wcut_rapid_put(wcut_text *text, const wcut_robot_motion *motion, const wcut_robot_names *names, int robot);
void wcut_krl_put(wcut_text *text, const wcut_robot_motion *motion, const wcut_robot_names *names, int robot);

#endif
