/* Units of length: their names as files and people write them, and how many millimetres they are. */
#ifndef WCUT_IO_UNIT_H
#define WCUT_IO_UNIT_H

#include <stddef.h>
#include <wirecut/cloud_file.h>

/* [mm] of a unit in its range */
double wcut_unit_length(wcut_length_unit unit);

/* [mm] of the unit with this name, in any case: "mm", "Metres", "ft"; 0: none is called so */
double wcut_unit_find(const char *name, size_t length);

/* [mm] of the unit that a comment states, "units: mm", "UNIT=m"; 0: it states none */
double wcut_unit_stated(const char *text, size_t length);

#endif
