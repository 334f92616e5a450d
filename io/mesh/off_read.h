/* OFF (Geomview): its header and vertices, for clouds and meshes. */
#ifndef WCUT_IO_MESH_OFF_READ_H
#define WCUT_IO_MESH_OFF_READ_H

#include "io/file/source.h"

typedef struct wcut_off_reader {
    wcut_source *source;
    int64_t vertices, faces; /* not yet read */
    bool has_normals;        /* NOFF */
} wcut_off_reader;

/* each of these: false means refused, the source holds the failure */

/* the keyword, OFF with the prefixes ST, C and N, and the counts */
bool wcut_off_begin(wcut_source *source, wcut_off_reader *reader);

/* the next vertex: x y z, and its normal where there are some, in the file's unit */
bool wcut_off_vertex(wcut_off_reader *reader, double value[WCUT_FIELDS]);

/* the corners of the next face, 3 to `max` */
bool wcut_off_face(wcut_off_reader *reader, int max, int *corner, int *count);

/* nothing but comments and blank lines follows */
bool wcut_off_end(wcut_off_reader *reader);

#endif
