/* wirecut/regions.h - zones and sections that a user lays over a face. */
#ifndef WCUT_REGIONS_H
#define WCUT_REGIONS_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { WCUT_REGION_NAME = 64, WCUT_REGIONS_MAX = 200, WCUT_SECTIONS_MAX = 50, WCUT_REGION_POINTS_MAX = 1000 };

/** A zone: a box, or a polygon seen along z, such as the border of a face. */
typedef struct wcut_region {
    char name[WCUT_REGION_NAME];
    wcut_vec3 low, high; /**< [mm] of a polygon its box in x and y and all heights */
    int corners;         /**< of the polygon; 0: the box */
    double *corner;      /**< corners x 2 [mm] */
    double tolerance;    /**< [mm] 0: none, so no verdict */
    double share;        /**< [1] of the deviations that must be within it */
} wcut_region;

/** A section: a line of two points or more seen along z. */
typedef struct wcut_section {
    char name[WCUT_REGION_NAME];
    int points;
    double *point; /**< points x 2 [mm] */
    double width;  /**< [mm] feet up to half of it from the line belong to the section */
    double step;   /**< [mm] along the line that is one value of the profile */
} wcut_section;

/** What a user lays over a face. */
typedef struct wcut_regions {
    int regions;
    wcut_region *region;
    int sections;
    wcut_section *section;
} wcut_regions;

/**
 * Read zones and sections, "wirecut-zones/1" (FORMATS.md, Zones).
 *
 * @param[in]  path    a file
 * @param[out] regions the caller's, to wcut_regions_destroy
 * @param[out] error   may be NULL; the JSON path, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND, WCUT_BAD_FORMAT, WCUT_BAD_ARGUMENT (also a value out of its range), WCUT_NO_MEMORY:
 *         nothing was written.
 */
WCUT_API wcut_status wcut_regions_read(const char *path, wcut_regions **regions, wcut_error *error);

/** Free zones and sections; NULL is allowed. */
WCUT_API void wcut_regions_destroy(wcut_regions *regions);

#ifdef __cplusplus
}
#endif

#endif
