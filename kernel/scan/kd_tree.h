/* A balanced k-d tree of points (Bentley 1975): the nearest of them, and those within a radius. */
#ifndef WCUT_SCAN_KD_TREE_H
#define WCUT_SCAN_KD_TREE_H

#include <wirecut/status.h>
#include <wirecut/vec3.h>

enum { WCUT_KD_LEAF = 16, WCUT_KD_NEAREST_MAX = 128 };

/* Node k has the children 2k + 1 and 2k + 2; the range [first, end) of a node is halved, so ranges need no storing. */
typedef struct wcut_kd_node {
    wcut_vec3 low, high; /* [mm] the box of its points */
} wcut_kd_node;

typedef struct wcut_kd_tree {
    int count;
    int levels;       /* 0: the root is a leaf; all leaves are on the last level */
    wcut_vec3 *point; /* count, leaf after leaf: neighbours are close in memory */
    int *index;       /* count: the number that each had before */
    wcut_kd_node *node;
} wcut_kd_tree;

/* the nearest points of a query, from near to far */
typedef struct wcut_kd_nearest {
    int count;                          /* found: as many as asked for, or all that there are */
    double square[WCUT_KD_NEAREST_MAX]; /* [mm^2] of the distance */
    int place[WCUT_KD_NEAREST_MAX];     /* in tree->point */
} wcut_kd_nearest;

/* A tree of count >= 1 finite points, the same for every number of threads. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_kd_tree_build(int count, const wcut_vec3 *point, int threads, wcut_kd_tree *tree);
void wcut_kd_tree_clear(wcut_kd_tree *tree);

/* The k points nearest to tree->point[place], itself not among them; k at most WCUT_KD_NEAREST_MAX. */
void wcut_kd_tree_nearest(const wcut_kd_tree *tree, int place, int k, wcut_kd_nearest *nearest);

/* how many points, itself not among them, are within the radius of tree->point[place]; counts up to `max` */
int wcut_kd_tree_within(const wcut_kd_tree *tree, int place, double radius, int max);

/* how far [mm] any place is from the nearest point; `limit` where none is nearer than that */
double wcut_kd_tree_distance(const wcut_kd_tree *tree, wcut_vec3 p, double limit);

#endif
