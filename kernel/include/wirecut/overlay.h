/* wirecut/overlay.h - a photograph of a cut face laid over the simulated wire: rectified, and its rills measured. */
#ifndef WCUT_OVERLAY_H
#define WCUT_OVERLAY_H

#include <stdbool.h>
#include <wirecut/camera.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A picture in memory, 8 bits a channel. */
typedef struct wcut_picture {
    int width, height;    /**< [px] 1 .. 1,000,000, at most WCUT_PICTURE_PIXELS together */
    int channels;         /**< 1 grey, 3 red green blue, 4 with opacity */
    unsigned char *pixel; /**< height x width x channels */
} wcut_picture;

/** The most pixels of a picture. */
enum { WCUT_PICTURE_PIXELS = 200000000 };

/**
 * A black picture for the caller to fill.
 *
 * @param[in]  width, height within the limits of wcut_picture
 * @param[in]  channels      1, 3 or 4
 * @param[out] picture       the caller's, to wcut_picture_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_picture_create(int width, int height, int channels, wcut_picture **picture);

/** Free a picture; NULL is allowed. */
WCUT_API void wcut_picture_destroy(wcut_picture *picture);

/** Settings of wcut_overlay_create. */
typedef struct wcut_overlay_options {
    bool upper;        /**< the picture shows the face of the upper half, seen from below; default false */
    double resolution; /**< [mm] a pixel of the rectified picture; default 0: the picture's own */
    double patch;      /**< [mm] side of a patch in which the rills are averaged; default 20 */
    int curves;        /**< the most wires that are drawn and measured, evenly chosen; default 24 */
    int threads;       /**< at least 1; no result depends on it; default 1 */
} wcut_overlay_options;

/** The defaults stated at the members. */
WCUT_API wcut_overlay_options wcut_overlay_options_default(void);

/** The rills in one patch of the block. Angles are seen from above, counter-clockwise from x to y. */
typedef struct wcut_rill_patch {
    wcut_vec3 place;   /**< [mm] middle of the patch on the simulated face */
    double station;    /**< at the middle, between the stations of the history */
    double wire;       /**< [rad] direction of the simulated wire, -pi/2 .. pi/2 */
    bool readable;     /**< whether there are rills; else the figures below are 0, but for contrast and coherence */
    double angle;      /**< [rad] rill minus wire, -pi/2 .. pi/2 */
    double sigma;      /**< [rad] standard deviation from the scatter in the patch */
    double systematic; /**< [rad] standard deviation from the camera's uncertainty; common to all patches */
    double coherence;  /**< [1] 0 no direction, 1 one direction; of the better of two scales */
    double contrast;   /**< [grey levels of 255] rms of the brightness about a plane */
    double covered;    /**< [1] share of the patch that the picture shows */
} wcut_rill_patch;

/** A point of a wire that the rills were compared with. */
typedef struct wcut_rill_node {
    wcut_vec3 place;  /**< [mm] of the simulated wire */
    bool readable;    /**< inside the stretch that could be integrated */
    double deviation; /**< [mm] along y: the wire that fits the rills minus the simulated one; the mean over the stretch
                           is 0, since rills tell directions and no place */
    double sigma;     /**< [mm] its standard deviation, the camera's part included */
} wcut_rill_node;

/** A simulated wire and its fit to the rills. */
typedef struct wcut_rill_curve {
    int station;          /**< of the history */
    int count;            /**< nodes, at equal steps of x */
    wcut_rill_node *node; /**< count */
    int readable;         /**< nodes in the stretch; 0: none could be integrated */
    double range;         /**< [mm] largest minus smallest deviation */
    double range_sigma;   /**< [mm] its standard deviation */
    bool differs;         /**< whether a deviation is beyond four of its standard deviations */
} wcut_rill_curve;

/** Medians of the angles over the patches of a phase. */
typedef struct wcut_rill_phase {
    int patches, readable;
    double median; /**< [rad] 0 where nothing is readable */
    double sigma;  /**< [rad] its standard deviation, the camera's part included */
} wcut_rill_phase;

/** The most patches that are listed as the worst. */
enum { WCUT_OVERLAY_WORST = 10 };

/** What a photograph says. */
typedef struct wcut_overlay {
    double resolution;             /**< [mm] a pixel */
    double covered;                /**< [1] share of the face that the picture shows */
    wcut_picture *rectified;       /**< 4 channels, opacity 0 where the face is hidden; pixel (column c, row r) is at
                                  x = (c + 1/2) resolution, y = block length - (r + 1/2) resolution */
    int columns, rows;             /**< of patches; row 0 at y = 0 */
    wcut_rill_patch *patch;        /**< rows x columns */
    int readable;                  /**< patches */
    int worst_count;               /**< readable patches, at most WCUT_OVERLAY_WORST */
    int worst[WCUT_OVERLAY_WORST]; /**< those whose angle is the most standard deviations from 0, that one first */
    double readable_share;         /**< [1] of the patches that the picture covers by half */
    wcut_rill_phase phase[WCUT_PHASE_LEFT + 1];
    int curve_count;
    wcut_rill_curve *curve; /**< curve_count */
    int differing;          /**< curves that differ */
    double noise;           /**< [grey levels] of the picture, from its finest differences */
} wcut_overlay;

/**
 * Rectify a photograph onto the simulated face and compare the direction of its rills with the wire's tangent.
 *
 * Every place of the face is projected into the camera, so its relief shifts nothing; places that the face itself hides
 * are left out. The rills' direction is that of least variation of the brightness: the smaller principal axis of the
 * covariance of its gradients (structure tensor, Bigun, Granlund 1987) in the frame of the simulated wire, at two scales.
 * Slowly changing light leaves no covariance. The shape is the integral of the difference of slopes.
 *
 * @param[in]  block    [mm] W, L, H of the block
 * @param[in]  history  at least 2 stations and 2 nodes, wires that cross the block in x
 * @param[in]  camera   of the picture
 * @param[in]  report   of its fit, for its covariance; may be NULL: the camera is taken as exact
 * @param[in]  picture  of the camera's width and height
 * @param[in]  options  may be NULL
 * @param[in]  progress may be NULL; counts rows of patches
 * @param[in]  context  handed to progress
 * @param[out] overlay  the caller's, to wcut_overlay_destroy; also where nothing is readable
 * @param[out] error    may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT; WCUT_DEGENERATE (the face has no place in the block, the camera does not see it or
 *         sees it from its back); WCUT_INTERRUPTED, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_overlay_create(wcut_vec3 block, const wcut_history *history, const wcut_camera *camera,
                                         const wcut_camera_report *report, const wcut_picture *picture,
                                         const wcut_overlay_options *options, wcut_progress progress, void *context,
                                         wcut_overlay **overlay, wcut_error *error);

/** Free an overlay; NULL is allowed. */
WCUT_API void wcut_overlay_destroy(wcut_overlay *overlay);

/** What is drawn over a picture. */
typedef struct wcut_overlay_style {
    bool by_force; /**< wires coloured by the force of the foam, else by the phase; default true */
    double width;  /**< [px] of a line; default 2 */
} wcut_overlay_style;

/** The defaults stated at the members. */
WCUT_API wcut_overlay_style wcut_overlay_style_default(void);

/**
 * The rectified picture with the simulated wires and the block's outline.
 *
 * @param[in]  overlay with the wires to draw
 * @param[in]  block, history as in wcut_overlay_create
 * @param[in]  style   may be NULL
 * @param[out] picture 4 channels; the caller's, to wcut_picture_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_overlay_draw(const wcut_overlay *overlay, wcut_vec3 block, const wcut_history *history,
                                       const wcut_overlay_style *style, wcut_picture **picture);

/**
 * The photograph itself with wires, outline and the paths of the mounts, in its own perspective.
 *
 * @param[in]  overlay, block, history, style as in wcut_overlay_draw
 * @param[in]  camera
 * @param[in]  photo   the photograph
 * @param[out] picture 3 channels; the caller's, to wcut_picture_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_overlay_draw_photo(const wcut_overlay *overlay, wcut_vec3 block, const wcut_history *history,
                                             const wcut_overlay_style *style, const wcut_camera *camera,
                                             const wcut_picture *photo, wcut_picture **picture);

/**
 * Squares of a rectified picture side by side: around the middle of the wire halfway through entry, steady cut and exit.
 *
 * @param[in]  overlay, block, history as in wcut_overlay_draw
 * @param[in]  drawn   the rectified picture, plain or drawn over, 4 channels
 * @param[in]  side    [mm] of a square, positive
 * @param[out] picture 4 channels; the caller's, to wcut_picture_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (no wire is in the block), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_overlay_details(const wcut_overlay *overlay, wcut_vec3 block, const wcut_history *history,
                                          const wcut_picture *drawn, double side, wcut_picture **picture);

#ifdef __cplusplus
}
#endif

#endif
