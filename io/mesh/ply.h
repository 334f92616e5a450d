/* PLY (Turk 1994): the layout that a header gives, and records read by it. */
#ifndef WCUT_IO_MESH_PLY_H
#define WCUT_IO_MESH_PLY_H

#include "io/file/record.h"
#include "io/mesh/polygon.h"

enum { WCUT_PLY_ELEMENTS = 64, WCUT_PLY_PROPERTIES = 256 };

typedef struct wcut_ply_property {
    wcut_scalar count; /* of a list; WCUT_SCALAR_NONE: a scalar */
    wcut_scalar value;
    int field;       /* x y z nx ny nz as 0 .. 5, or -1 */
    bool is_corners; /* the list of a face's vertices */
} wcut_ply_property;

typedef struct wcut_ply_element {
    int64_t count;
    int first, properties; /* its ones in ply.property */
    bool is_vertex, is_face, has_list;
    size_t size; /* [byte] of a record, a list counting as its count alone: the least it can be */
} wcut_ply_element;

typedef struct wcut_ply {
    wcut_record record; /* the state begins with it: wcut_cloud_fill_records reads it */
    bool ascii;
    int vertex, face; /* the elements of that name, -1 before they are found */
    int elements, properties;
    wcut_ply_element element[WCUT_PLY_ELEMENTS];
    wcut_ply_property property[WCUT_PLY_PROPERTIES];
} wcut_ply;

/* the corners of a face */
typedef struct wcut_ply_corners {
    int count;
    int64_t vertex[WCUT_POLYGON_MAX];
} wcut_ply_corners;

/* each of these: false means refused, the source holds the failure */

/* every line up to end_header */
bool wcut_ply_header(wcut_source *source, wcut_ply *ply);

/* the header is read: the vertex's properties laid out as a record, elements before the vertices skipped, their count
   held against the file; the vertices follow */
bool wcut_ply_begin(wcut_source *source, wcut_ply *ply);

/* one record of an element; value (6) takes the fields there are, corners (may be NULL) the list that is one */
bool wcut_ply_record(wcut_source *source, const wcut_ply *ply, const wcut_ply_element *element, double *value,
                     wcut_ply_corners *corners);

/* the elements first .. end - 1 */
bool wcut_ply_skip(wcut_source *source, const wcut_ply *ply, int first, int end);

#endif
