/* A camera's parameters and its projection, for the rooms that fit and use it. */
#ifndef WCUT_PHOTO_CAMERA_H
#define WCUT_PHOTO_CAMERA_H

#include <stdbool.h>
#include <wirecut/camera.h>

#include "base/vec3.h"

/* a place in the picture; depth 0 where it cannot be seen */
typedef struct wcut_pixel {
    double u, v, depth;
} wcut_pixel;

wcut_pixel wcut_camera_pixel(const wcut_camera *camera, wcut_vec3 place);

/* the camera moved by its parameters: rotation vector [rad], translation [mm], ln(focal) [1], k1, k2 */
wcut_camera wcut_camera_moved(const wcut_camera *camera, const double step[WCUT_CAMERA_PARAMETERS]);

/* Linear starts, all in places relative to their mean. False: the points do not determine it. */
typedef struct wcut_camera_points {
    int count;
    const wcut_photo_point *point;
    wcut_vec3 mean;    /* [mm] of the places */
    wcut_vec3 axis[3]; /* principal axes of the places, right-handed */
    double spread[3];  /* [mm] rms along them, descending */
    double middle[2];  /* [px] of the picture */
    double scale_px;   /* [px] half of the picture's diagonal */
} wcut_camera_points;

void wcut_camera_points_measure(int count, const wcut_photo_point *point, int width, int height,
                                wcut_camera_points *points);

/* 6 points and more off a plane; *mirrored: the points are a mirror image of what any camera sees */
wcut_status wcut_camera_direct(const wcut_camera_points *points, wcut_camera *camera, bool *mirrored);

/* 4 points and more of a plane: its image, and a pinhole camera where *determined */
wcut_status wcut_camera_plane(const wcut_camera_points *points, wcut_camera *camera, bool *determined);

#endif
