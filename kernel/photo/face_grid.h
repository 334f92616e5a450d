/* The simulated face as heights over the block: what a camera above it sees, and the wire that made each place. */
#ifndef WCUT_PHOTO_FACE_GRID_H
#define WCUT_PHOTO_FACE_GRID_H

#include <stdbool.h>
#include <wirecut/history.h>
#include <wirecut/status.h>

/* nodes at (column, row) x cell; a node that no wire passed has station -1 */
typedef struct wcut_face_grid {
    double cell; /* [mm] */
    int columns, rows;
    float *z;                     /* rows x columns [mm] */
    float *station;               /* between those of the history */
    float *tangent_x, *tangent_y; /* [1] direction of the wire seen from above, unit */
    unsigned char *hidden;        /* from the camera that was asked about */
} wcut_face_grid;

/* upper: of several sheets the lowest counts, else the highest. WCUT_OK; WCUT_DEGENERATE: no place of the face is in the
   block; WCUT_NO_MEMORY */
wcut_status wcut_face_grid_create(wcut_vec3 block, const wcut_history *history, bool upper, wcut_face_grid **grid);
void wcut_face_grid_destroy(wcut_face_grid *grid);

/* mark what the face itself hides from a place */
void wcut_face_grid_hide(wcut_face_grid *grid, wcut_vec3 eye, bool upper);

/* a place of the face between the nodes */
typedef struct wcut_face_place {
    bool there, hidden;
    double z, station, tangent_x, tangent_y;
} wcut_face_place;

wcut_face_place wcut_face_grid_locate(const wcut_face_grid *grid, double x, double y);

#endif
