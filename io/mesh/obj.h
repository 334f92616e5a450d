/* Lines of an OBJ file (Wavefront). */
#ifndef WCUT_IO_MESH_OBJ_H
#define WCUT_IO_MESH_OBJ_H

#include "io/file/row.h"

/* the next line, of text, as wcut_row_peek gives it; NULL: the end, or refused, then the failure says so */
const char *wcut_obj_line(wcut_source *source, size_t *length);

/* what follows the keyword at p; NULL: another one stands there */
const char *wcut_obj_match(const char *p, const char *keyword);

/* x y z behind "v", then nothing, a weight of 1, or a colour of three numbers; false: refused */
bool wcut_obj_vertex(wcut_source *source, const char *line, const char *p, double value[WCUT_FIELDS]);

/* whether the line changes neither vertices nor faces */
bool wcut_obj_is_passed_over(const char *p);

/* free-form geometry, or no OBJ at all; gives false */
bool wcut_obj_refuse(wcut_source *source, const char *line, const char *p);

#endif
