/* The direction of rills in patches of a rectified picture. */
#ifndef WCUT_PHOTO_RILLS_H
#define WCUT_PHOTO_RILLS_H

#include <wirecut/overlay.h>

#include "photo/face_grid.h"

/* grey levels of a rectified picture, -1 where it shows nothing */
typedef struct wcut_grey {
    int width, height;
    double resolution; /* [mm] */
    double noise;      /* [grey levels] */
    float *level;      /* height x width */
} wcut_grey;

wcut_status wcut_grey_create(const wcut_picture *picture, double resolution, wcut_grey **grey);
void wcut_grey_destroy(wcut_grey *grey);

/* the figures of a patch of which the caller has set place, station and wire. WCUT_OK; WCUT_NO_MEMORY */
wcut_status wcut_rills_measure(const wcut_grey *grey, const wcut_face_grid *grid, wcut_vec3 block, double side,
                               wcut_rill_patch *patch);

#endif
