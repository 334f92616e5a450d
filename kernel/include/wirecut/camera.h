/* wirecut/camera.h - where a photograph was taken from: a camera fitted to points whose places are known. */
#ifndef WCUT_CAMERA_H
#define WCUT_CAMERA_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A point of the picture and its place in the block's frame. */
typedef struct wcut_photo_point {
    double u, v;     /**< [px] column and row as stored; the centre of the first pixel is (0, 0) */
    wcut_vec3 place; /**< [mm] */
} wcut_photo_point;

/** What could be determined from the points. */
typedef enum wcut_camera_kind {
    WCUT_CAMERA_KIND_PLANE,   /**< the image of one plane alone (a homography): 4 or 5 points that do not tell the
                                   focal length; places off the plane are dropped onto it along its normal */
    WCUT_CAMERA_KIND_PINHOLE, /**< pose and focal length from 4 or 5 points of a plane; no distortion */
    WCUT_CAMERA_KIND_FULL     /**< pose, focal length, k1, and k2 from 10 points on */
} wcut_camera_kind;

/**
 * A camera with square pixels, the principal point in the middle of the picture, and radial distortion (Brown 1971):
 * with (x, y, z) = R (place - centre), x to the right, y down, z forward, m = (x, y) / z and r^2 = |m|^2,
 * (u, v) = middle + focal m (1 + k1 r^2 + k2 r^4).
 */
typedef struct wcut_camera {
    wcut_camera_kind kind;
    int width, height;    /**< [px] of the picture */
    double rotation[9];   /**< R, row-major, from the block's frame to the camera's */
    wcut_vec3 centre;     /**< [mm] where the camera stands */
    double focal;         /**< [px] */
    double k1, k2;        /**< [1] */
    double homography[9]; /**< WCUT_CAMERA_KIND_PLANE: from plane coordinates (x, y, 1) [mm] to pixels, row-major */
    wcut_vec3 plane;      /**< [mm] origin of the plane coordinates; with homography only */
    wcut_vec3 plane_x, plane_y; /**< [1] their axes */
} wcut_camera;

/** The most parameters of a camera: three of rotation, three of place, focal length, k1, k2. */
enum { WCUT_CAMERA_PARAMETERS = 9 };

/** How well the points hold the camera. */
typedef struct wcut_camera_report {
    int parameters; /**< fitted: 8 of a homography, 7 of a pinhole, 8 or 9 of a full camera */
    int iterations;
    double rms;   /**< [px] of the reprojection, per point */
    double sigma; /**< [px] standard deviation of a coordinate: from the residuals, at least the option's pixel_sigma */
    double covariance[WCUT_CAMERA_PARAMETERS * WCUT_CAMERA_PARAMETERS]; /**< row-major; rotation vector [rad] about the
                      camera's axes, translation -R centre [mm], ln(focal) [1], k1, k2; zero for parameters not fitted */
    double focal_sigma; /**< [px] standard deviation of the focal length; 0 for a homography */
    bool left_out;      /**< whether leave_one_out was made: more points than the fit needs */
    int suspect;        /**< the point whose removal explains most of the misfit: a typing error; -1: none */
    double flatness;    /**< [mm] rms distance of the places from their best plane */
} wcut_camera_report;

/** Settings of wcut_camera_fit. */
typedef struct wcut_camera_options {
    double pixel_sigma; /**< [px] how well a point is measured at best; default 0.25 */
    double rms_max;     /**< [px] a larger misfit is refused; default 0: 2, or a thousandth of the diagonal if larger */
} wcut_camera_options;

/** The defaults stated at the members. */
WCUT_API wcut_camera_options wcut_camera_options_default(void);

/**
 * A camera from points: direct linear transformation (Abdel-Aziz, Karara 1971) with scaled coordinates (Hartley 1997),
 * then Levenberg-Marquardt on the pixels.
 *
 * 4 or 5 points: they must lie in a plane; where the perspective tells the focal length to 10 % the camera is a
 * pinhole, else a homography. 6 points and more: they must not lie in a plane.
 *
 * @param[in]  count   4 .. 500
 * @param[in]  point   count; inside the picture
 * @param[in]  width, height [px] of the picture, 2 .. 1,000,000
 * @param[in]  options may be NULL
 * @param[out] camera
 * @param[out] report  may be NULL
 * @param[out] residual count x 2 [px], observed minus projected; may be NULL
 * @param[out] leave_one_out count [px], distance of each point from a camera that was fitted without it; untouched
 *                     where report->left_out is false; may be NULL
 * @param[out] error   may be NULL; which points, what is wrong with them
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (outside the ranges above, a point outside the picture); WCUT_DEGENERATE (points
 *         on a line, in a plane or off it, two at one place, mirrored); WCUT_NOT_CONVERGED (no camera sees the points
 *         so: a misfit above rms_max; the text names a suspect); WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_camera_fit(int count, const wcut_photo_point *point, int width, int height,
                                     const wcut_camera_options *options, wcut_camera *camera,
                                     wcut_camera_report *report, double *residual, double *leave_one_out,
                                     wcut_error *error);

/**
 * Where places are in the picture.
 *
 * @param[in]  camera
 * @param[in]  count  0 or more
 * @param[in]  place  count [mm], finite
 * @param[out] pixel  count x 2 [px]; also outside the picture
 * @param[out] depth  count [mm] in front of the camera; 0 where the place is behind it or beyond the range in which the
 *                    distortion is monotonic, there pixel is 0; may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_camera_project(const wcut_camera *camera, int count, const wcut_vec3 *place, double *pixel,
                                         double *depth);

#ifdef __cplusplus
}
#endif

#endif
