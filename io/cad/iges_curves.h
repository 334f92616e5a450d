/* The curves of IGES files, entity by entity. */
#ifndef WCUT_IO_CAD_IGES_CURVES_H
#define WCUT_IO_CAD_IGES_CURVES_H

#include "io/cad/iges_read.h"

/* an entry named by a number of the directory; false: refused */
bool wcut_iges_find_named(wcut_iges *f, const wcut_iges_entry *by, int number, wcut_iges_entry *entry);

/* move a curve by the transformation that an entry names, and by those that that names; false: refused */
bool wcut_iges_transform(wcut_iges *f, const wcut_iges_entry *e, wcut_curve *curve);

/* the curve of an entry that is not composite, moved; NULL: refused or left out */
wcut_curve *wcut_iges_curve(wcut_iges *f, const wcut_iges_entry *e);

#endif
