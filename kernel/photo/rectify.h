/* A photograph brought onto the simulated face. */
#ifndef WCUT_PHOTO_RECTIFY_H
#define WCUT_PHOTO_RECTIFY_H

#include <wirecut/overlay.h>

#include "photo/face_grid.h"

/* [mm] 0.7 of what a pixel of the photograph shows of the face in the direction in which it shows most, the median over
   the face: fine rills keep their contrast. 0 where the photograph does not show the face. */
double wcut_rectify_resolution(const wcut_face_grid *grid, wcut_vec3 block, const wcut_camera *camera);

/* the picture of wcut_overlay, and the share of the face that it shows. WCUT_OK; WCUT_BAD_ARGUMENT (more pixels than a
   picture may have), WCUT_NO_MEMORY */
wcut_status wcut_rectify(const wcut_face_grid *grid, wcut_vec3 block, const wcut_camera *camera,
                         const wcut_picture *photo, double resolution, int threads, wcut_picture **rectified,
                         double *covered);

#endif
