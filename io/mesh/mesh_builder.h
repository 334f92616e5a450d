/* A mesh that grows as a file is read: corners in one place are one vertex, polygons become triangles. */
#ifndef WCUT_IO_MESH_MESH_BUILDER_H
#define WCUT_IO_MESH_MESH_BUILDER_H

#include <wirecut/cloud_file.h>
#include <wirecut/read.h>

#include "io/file/source.h"
#include "io/mesh/polygon.h"

typedef struct wcut_mesh_builder {
    wcut_source *source; /* what refuses, at its line or byte */
    int max;             /* triangles */
    int vertices, triangles, collapsed, split;
    size_t vertex_room, triangle_room, slots;
    wcut_vec3 *vertex;
    int *triangle;
    int *slot; /* open addressing: a vertex's index + 1, 0 where empty; at most half of them are taken */
} wcut_mesh_builder;

/* each of these: false (or -1) means refused, the source holds the failure */

/* a position in the file's unit, checked and scaled */
bool wcut_mesh_builder_point(wcut_mesh_builder *builder, const double value[3], wcut_vec3 *point);

/* the index of the vertex at a checked point; -1: refused */
int wcut_mesh_builder_vertex(wcut_mesh_builder *builder, wcut_vec3 point);

/* a triangle, left out and counted where it has collapsed */
bool wcut_mesh_builder_triangle(wcut_mesh_builder *builder, int a, int b, int c);

/* a polygon of 3 .. WCUT_POLYGON_MAX corners */
bool wcut_mesh_builder_polygon(wcut_mesh_builder *builder, int count, const int *corner);

/* vertices as a file numbers them: one becomes a vertex of the mesh when a face first uses it */
typedef struct wcut_numbered {
    int count;
    size_t point_room, vertex_room;
    wcut_vec3 *point;
    int *vertex; /* of the mesh, -1 before it is used */
} wcut_numbered;

bool wcut_numbered_add(wcut_mesh_builder *builder, wcut_numbered *numbered, const double value[3]);

/* the mesh's vertex for number i of 0 .. count - 1; -1: refused */
int wcut_numbered_use(wcut_mesh_builder *builder, wcut_numbered *numbered, int i);

void wcut_numbered_free(wcut_numbered *numbered);

/* the mesh with at least one triangle, and its figures */
bool wcut_mesh_builder_finish(wcut_mesh_builder *builder, wcut_mesh **mesh, wcut_mesh_read_info *info);

void wcut_mesh_builder_free(wcut_mesh_builder *builder);

/* room for `need` elements of `size` bytes in a list that doubles; false: no memory */
bool wcut_mesh_builder_room(void **data, size_t *room, size_t need, size_t size);

#endif
