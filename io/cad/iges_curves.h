/* The curves of IGES files, entity by entity. */
#ifndef WCUT_IO_IGES_CURVES_H
#define WCUT_IO_IGES_CURVES_H

#include "io/cad/iges_read.h"

/* note the pieces of a composite curve, which are read with it; anything else is passed over; false: refused */
bool wcut_iges_note_pieces(wcut_iges *f, const wcut_iges_entry *entry);

/* the curve of an entry into the set, if it is one and none of another's pieces; false: refused */
bool wcut_iges_add(wcut_iges *f, const wcut_iges_entry *entry);

#endif
