/* A mesh laid out for closest-point queries: triangles in the order of a tree, boxes eight to a node, edges' sides. */
#ifndef WCUT_SCAN_MESH_LAYOUT_H
#define WCUT_SCAN_MESH_LAYOUT_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <wirecut/mesh_tree.h>

enum { WCUT_MESH_WIDE = 8, WCUT_MESH_LEAF = 8 };

/* Up to eight boxes in single precision, rounded outwards and about the mesh's centre; an unused one is empty. */
typedef struct wcut_mesh_node {
    float low[3][WCUT_MESH_WIDE], high[3][WCUT_MESH_WIDE];
    int child[WCUT_MESH_WIDE]; /* a node's number, or ~ a leaf's */
} wcut_mesh_node;

/* Up to eight triangles, each as the planes of its prism in single precision about the mesh's centre: the distance is
   no less than the height over the face and the furthest way out of the three sides, together. */
typedef struct wcut_mesh_leaf {
    float plane[4][4][WCUT_MESH_LEAF]; /* [face, sides][x, y, z, offset]; the height is infinite where there is none */
    int first, count;                  /* of its triangles */
} wcut_mesh_leaf;

typedef struct wcut_mesh_corners {
    wcut_vec3 a, b, c;
} wcut_mesh_corners;

struct wcut_mesh_tree {
    int triangles;
    wcut_vec3 *point;         /* vertices */
    int *index;               /* triangles, in the order of the leaves: the number that each has in the mesh */
    int *vertex;              /* triangles x 3 in the order of the leaves */
    int *neighbour;           /* triangles x 3, in the order of the leaves: across the edge from corner k to the next;
                                  -1: border, -2: odd */
    wcut_vec3 *normal;        /* vertices: angle-weighted, of length 1 or 0 */
    unsigned char *on_border; /* vertices */
    wcut_mesh_node *node;     /* node[0] is the root */
    wcut_mesh_leaf *leaf;
    wcut_vec3 centre;
    double size; /* [mm] half the box's diagonal */
    wcut_mesh_tree_info info;
};

static inline wcut_mesh_corners wcut_mesh_corners_of(const wcut_mesh_tree *t, int triangle) {
    const int *v = t->vertex + 3 * (size_t)triangle;
    return (wcut_mesh_corners){t->point[v[0]], t->point[v[1]], t->point[v[2]]};
}

/* finite and within 1e12 mm: squares and products stay finite, and a double tells points 1e-4 mm apart */
static inline bool wcut_are_near(int count, const wcut_vec3 *p) {
    const double far = 1e12;
    for (int k = 0; k < count; k++)
        if (!(fabs(p[k].x) <= far && fabs(p[k].y) <= far && fabs(p[k].z) <= far)) return false;
    return true;
}

#endif
