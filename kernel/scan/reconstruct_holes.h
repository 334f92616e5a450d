/* Connected parts of a face that were not scanned. */
#ifndef WCUT_SCAN_RECONSTRUCT_HOLES_H
#define WCUT_SCAN_RECONSTRUCT_HOLES_H

#include <wirecut/reconstruction.h>

#include "scan/reconstruct_lattice.h"

/* Holes of at least `min` [mm^2], the largest first; open_area: rows x columns [mm^2], what of each cell is not
   measured and in the block; outside: rows x columns, 1 where some of a cell is neither. hole: the caller's, to wcut_free; room for one where there is none. WCUT_NO_MEMORY: nothing was
   written. */
wcut_status wcut_holes_find(const wcut_lattice *lattice, const double *open_area, const unsigned char *outside,
                            double min, int *count, wcut_hole **hole);

#endif
