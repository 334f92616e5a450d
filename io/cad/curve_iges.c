/* Curves from IGES files: the pieces of composite curves are noted first, then every curve of the directory is read. */
#include "io/cad/iges_curves.h"

bool wcut_curves_fill_iges(wcut_curve_reader *r, char *text, size_t length) {
    wcut_iges f;
    bool done = wcut_iges_begin(r, text, length, &f);
    for (int pass = 0; pass < 2; pass++)
        for (int at = f.directory; done && at < f.data; at += 2) {
            wcut_iges_entry entry;
            done = wcut_iges_find(&f, at, &entry) &&
                   (pass ? wcut_iges_add(&f, &entry) : wcut_iges_note_pieces(&f, &entry));
        }
    wcut_iges_end(&f);
    return done;
}
