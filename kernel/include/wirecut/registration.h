/* wirecut/registration.h - a rigid motion that brings a scan into the block's frame. */
#ifndef WCUT_REGISTRATION_H
#define WCUT_REGISTRATION_H

#include <wirecut/export.h>
#include <wirecut/mesh_tree.h>
#include <wirecut/projection.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The six degrees of freedom: a shift [mm] and a rotation vector (axis times angle) [rad]. */
enum { WCUT_DOF_TX, WCUT_DOF_TY, WCUT_DOF_TZ, WCUT_DOF_RX, WCUT_DOF_RY, WCUT_DOF_RZ, WCUT_DOF_COUNT };

/** What may become of a degree of freedom. */
typedef enum wcut_dof_kind {
    WCUT_DOF_KIND_FREE,   /**< found from the data, starting at `value` */
    WCUT_DOF_KIND_LOCKED, /**< is `value`, exactly */
    WCUT_DOF_KIND_PRIOR   /**< known beforehand to be `value` with standard deviation `sigma` */
} wcut_dof_kind;

typedef struct wcut_dof {
    wcut_dof_kind kind;
    double value; /**< [mm] or [rad]; a rotation vector is shorter than pi */
    double sigma; /**< [mm] or [rad] positive; read for WCUT_DOF_KIND_PRIOR alone */
} wcut_dof;

/** How the motion was found. */
typedef enum wcut_registration_method {
    WCUT_REGISTRATION_METHOD_NONE, /**< the scan is in the block's frame as it came */
    WCUT_REGISTRATION_METHOD_DATUM,
    WCUT_REGISTRATION_METHOD_FIT
} wcut_registration_method;

/** How a registration is solved. */
typedef struct wcut_registration_options {
    wcut_dof dof[WCUT_DOF_COUNT]; /**< default: all free, value 0 */
    /** default 0: rotation is about the centroid of the scan's points (of all, or of the datum points); 1: about
        `pivot` */
    int pivot_given;
    wcut_vec3 pivot; /**< [mm] in the scan's frame, as the middle of the block */
    /** [mm] standard deviation of a point about the surface, positive; default 0: estimated from the residuals.
        Datums that have sigmas of their own do not read it */
    double noise;
    /** [1] fit: the points over the surface that are farther from it than this share of them lose their weight, from 1
        to 0 at 0.75 to 1.25 times that distance; in 0.5 .. 1, default 0.9. Points beyond a border lose theirs on the
        same distance. */
    double keep;
    /** fit: default 1: where all six degrees of freedom are free, also start from the sheet's centre, plane and
        turns about its normal, both sides up, and take the best; 0: start at the values */
    int coarse;
    int max_points; /**< fit: at most so many points are used, evenly over the file's order; default 20000, from 100 */
    /** [1] a direction of motion that changes the distances by less than this share of the way that points move
        (RMS) is not determined by the data; default 0.003, in 1e-6 .. 0.5 */
    double sensitivity;
    /** [mm] stop where the points move less in a step (RMS); default 1e-7, positive. A fit stops, too, where a step
        is less than a hundredth of the motion's standard error. */
    double tolerance;
    int max_iterations; /**< default 200, 1 or more */
} wcut_registration_options;

/** A motion p -> R (p - pivot) + pivot + t and how well it is known. */
typedef struct wcut_registration {
    wcut_registration_method method;
    double matrix[16];                /**< 4 x 4 row-major, for column vectors (x, y, z, 1): scan -> block frame */
    wcut_vec3 pivot;                  /**< [mm] the rotation is about this point of the scan */
    double parameter[WCUT_DOF_COUNT]; /**< t [mm], then the rotation vector of R [rad] */
    /** 6 x 6, of the parameters, priors included, independent errors assumed; rows and columns of locked and
        undetermined ones are 0 */
    double covariance[WCUT_DOF_COUNT * WCUT_DOF_COUNT];
    /** 1: found from data or prior; 0: locked, or not determined by the data (or only in combination with
        another one) */
    int determined[WCUT_DOF_COUNT];
    int free; /**< degrees of freedom that are not locked */
    /** directions that data and priors determine; where it is less than `free`, the others keep their starting
        values */
    int rank;
    int iterations; /**< Gauss-Newton steps */
    int converged;  /**< 1: the last step was small enough; 0: it stopped before, with the best motion so far */
    double step;    /**< [mm] how far the last step moved the points (RMS) */
    double doubt;   /**< [mm] standard error of where the motion puts the points (RMS), of independent errors */
    int points;     /**< residuals looked at: points of the scan, or 3 per pair and 1 per face point */
    int kept;       /**< of these, used in the last step */
    /** [1] share of the points that lie over the surface, not beyond its border; 1 for datums */
    double overlap;
    /** [mm] standard deviation of a residual, given or estimated; 0 where datums have sigmas */
    double noise;
    double rms;        /**< [mm] of the residuals used, at the motion found */
    double rms_before; /**< [mm] of the same share of residuals, before any motion */
    /** [mm] fit with coarse start: the least RMS reached from a start that led elsewhere: near rms means that the
        answer is ambiguous; 0: none was tried */
    double rival;
} wcut_registration;

/** A point of the scan and where it is in the block's frame. */
typedef struct wcut_datum_pair {
    wcut_vec3 scan, block; /**< [mm] */
    double sigma;          /**< [mm] standard deviation of each coordinate; 0 in all datums: unknown */
} wcut_datum_pair;

/** A face that the wire did not cut, and points of the scan on it. */
typedef struct wcut_datum_face {
    wcut_vec3 point, normal; /**< [mm] of the plane in the block's frame, [1] not 0 */
    double sigma;            /**< [mm] standard deviation of a distance; 0 in all datums: unknown */
    int count;               /**< points, 1 or more */
    const wcut_vec3 *scan;   /**< count [mm]; borrowed */
} wcut_datum_face;

/** The residual of a datum after a motion. */
typedef struct wcut_datum_residual {
    int is_face;      /**< 1: a point of a face; 0: a pair */
    int datum;        /**< which face or pair, from 0 */
    wcut_vec3 moved;  /**< [mm] where the motion puts the scan's point */
    wcut_vec3 offset; /**< [mm] from the block's point to it, or from its foot on the face's plane */
    double distance;  /**< [mm] length of the offset; of a face signed along its normal */
} wcut_datum_residual;

/** The defaults stated at the fields. */
WCUT_API wcut_registration_options wcut_registration_options_default(void);

/** No motion: the identity, everything else 0. */
WCUT_API wcut_registration wcut_registration_none(void);

/**
 * The motion that fits datums best, weighted by their sigmas: where there are at least three pairs off one line and
 * everything is free, the closed form (Horn 1987) first; Gauss-Newton on pairs, distances from faces and priors then.
 *
 *     min  sum |M p - q|^2 / sigma^2  +  sum (n . (M p - a))^2 / sigma^2  +  sum (x_k - value_k)^2 / sigma_k^2
 *
 * @param[in]  pairs        0 or more
 * @param[in]  pair         pairs
 * @param[in]  faces        0 or more; pairs and faces are not both 0
 * @param[in]  face         faces
 * @param[in]  options      NULL for the defaults; keep, coarse, max_points are not read
 * @param[out] registration the motion, its covariance and what is undetermined
 * @param[out] error        may be NULL
 * @return WCUT_OK, also where rank is less than free; WCUT_NOT_CONVERGED: registration holds the last step;
 *         WCUT_BAD_ARGUMENT (also some sigmas 0 and others not), WCUT_DEGENERATE (nothing is left to be determined: all
 *         locked, or data that determine nothing; or, sigmas and noise unknown, no residual more than unknowns),
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_registration_solve_datum(int pairs, const wcut_datum_pair *pair, int faces,
                                                   const wcut_datum_face *face,
                                                   const wcut_registration_options *options,
                                                   wcut_registration *registration, wcut_error *error);

/**
 * The residual of each datum after a motion, pairs first, then the points of each face in their order.
 *
 * @param[in]  registration a motion
 * @param[in]  pairs        0 or more
 * @param[in]  pair         pairs, finite
 * @param[in]  faces        0 or more
 * @param[in]  face         faces, finite, normals not 0
 * @param[out] residual     pairs + the sum of the faces' counts
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_datum_residual_eval(const wcut_registration *registration, int pairs,
                                              const wcut_datum_pair *pair, int faces, const wcut_datum_face *face,
                                              wcut_datum_residual *residual);

/**
 * The motion that brings a scan closest to a surface: distances along the normal of the exact closest point (Chen,
 * Medioni 1991), trimmed (Chetverikov, Stepanov, Krsek 2005), Gauss-Newton.
 *
 * A best fit hides deviations that look like a motion of the scan. Compare with wcut_registration_none, or lock the
 * degrees of freedom that the fixture holds.
 *
 * @param[in]  projection   of the surface
 * @param[in]  count        points, 6 or more
 * @param[in]  point        count [mm], finite, up to 1e12
 * @param[in]  options      NULL for the defaults
 * @param[in]  threads      1 or more; the result does not depend on it
 * @param[out] registration the motion, its covariance and what is undetermined
 * @param[out] error        may be NULL
 * @return WCUT_OK, also where rank is less than free; WCUT_NOT_CONVERGED: registration holds the last step;
 *         WCUT_DEGENERATE (all points in one place or on one line, fewer than six over the surface, nothing to be
 *         determined), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_registration_fit(const wcut_projection *projection, int count, const wcut_vec3 *point,
                                           const wcut_registration_options *options, int threads,
                                           wcut_registration *registration, wcut_error *error);

/**
 * The same beside the triangles of a mesh: distances along the normal of the triangle that holds the closest point.
 *
 * @param[in]  mesh         the face
 * @param[in]  tree         of that mesh, from wcut_mesh_tree_create
 * @param[in]  count, point, options, threads as in wcut_registration_fit
 * @param[out] registration, error            as in wcut_registration_fit
 * @return as wcut_registration_fit.
 */
WCUT_API wcut_status wcut_registration_fit_mesh(const wcut_mesh *mesh, const wcut_mesh_tree *tree, int count,
                                                const wcut_vec3 *point, const wcut_registration_options *options,
                                                int threads, wcut_registration *registration, wcut_error *error);

/**
 * Move points, and turn their normals, as a registration says.
 *
 * @param[in]     registration any
 * @param[in]     count        0 or more
 * @param[in,out] point        count [mm]
 * @param[in,out] normal       count [1]; NULL where there are none
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was changed.
 */
WCUT_API wcut_status wcut_registration_move(const wcut_registration *registration, int count, wcut_vec3 *point,
                                            wcut_vec3 *normal);

#ifdef __cplusplus
}
#endif

#endif
