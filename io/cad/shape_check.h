/* Shapes as writers of exact geometry ask for them. */
#ifndef WCUT_IO_CAD_SHAPE_CHECK_H
#define WCUT_IO_CAD_SHAPE_CHECK_H

#include <stdbool.h>
#include <wirecut/exchange.h>

/* every shape sound, as wcut_step_write states. WCUT_OK; WCUT_BAD_ARGUMENT: error says which and why */
wcut_status wcut_shapes_check(int count, const wcut_shape *shape, const char *path, wcut_error *error);

#endif
