/* What the wire bears. */
#ifndef WCUT_CONTROL_ROBOT_LIMITS_H
#define WCUT_CONTROL_ROBOT_LIMITS_H

#include <stdbool.h>
#include <wirecut/robot.h>

/* the wire's temperature in still air [degC] and its strength there [MPa]; false where limits or job are out of range */
bool wcut_limits_wire(const wcut_job *job, const wcut_robot_limits *limits, double *temperature, double *strength);

#endif
