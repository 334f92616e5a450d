/* Binary STL: a header and facets of 50 bytes. */
#ifndef WCUT_IO_MESH_STL_H
#define WCUT_IO_MESH_STL_H

#include <stdint.h>
#include <wirecut/vec3.h>

#include "io/file/text.h"

/* where the count of the facets stands in a file */
enum { WCUT_STL_COUNT_AT = 80 };

/* 80 bytes that say millimetres, and the count */
void wcut_stl_put_header(wcut_text *text, uint32_t count);

/* count facets with their normals, three indices each, counter-clockwise */
void wcut_stl_put_facets(wcut_text *text, size_t count, const wcut_vec3 *vertex, const int *triangle);

#endif
