/* How near a mount comes to the block along its whole path, between the stations too. */
#include <wirecut/bounds.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* Stations nearer than this are one: a dwell. [mm] */
static const double MERGE = 1e-3;

/* the station, a real number, of a share of the chords' length; kept: their stations, share: theirs */
static double station_of(double u, int count, const int *kept, const double *share) {
    int k = 0;
    while (k + 2 < count && share[k + 1] < u) k++;
    const double width = share[k + 1] - share[k], t = width > 0 ? clamp((u - share[k]) / width, 0, 1) : 0;
    return (1 - t) * kept[k] + t * kept[k + 1];
}

/* a path of at least two places; share: room for them */
static wcut_status path_clearance_measure(int count, const wcut_vec3 *apart, const int *kept, double *share,
                                          const wcut_box *block, double tolerance, wcut_path_near *near) {
    wcut_curve *curve = NULL;
    wcut_path_near found = {.distance = 0};
    double u = 0;
    for (int k = 1; k < count; k++) share[k] = share[k - 1] + vec3_distance(apart[k - 1], apart[k]);
    for (int k = 1; k < count; k++) share[k] /= share[count - 1];
    wcut_status status = wcut_curve_interpolate(count, apart, &curve);
    if (status == WCUT_OK) status = wcut_curve_clearance(curve, block, tolerance, &found.distance, &u);
    if (status == WCUT_OK) status = wcut_curve_eval(curve, u, 0, &found.place);
    wcut_curve_destroy(curve);
    if (status != WCUT_OK) return status;
    found.station = station_of(u, count, kept, share);
    *near = found;
    return WCUT_OK;
}

/* a mount that stands still */
static wcut_status measure_point(wcut_vec3 p, const wcut_box *block, wcut_path_near *near) {
    const wcut_vec3 foot = {clamp(p.x, block->low.x, block->high.x), clamp(p.y, block->low.y, block->high.y),
                            clamp(p.z, block->low.z, block->high.z)};
    *near = (wcut_path_near){.distance = vec3_distance(p, foot), .station = 0, .place = p};
    return WCUT_OK;
}

wcut_status wcut_path_clearance(int count, const wcut_vec3 *mount, const wcut_box *block, double tolerance,
                                wcut_path_near *near) {
    if (count < 1 || !mount || !block || !near || !is_positive(tolerance) || !vec3_all_finite(count, mount) ||
        !vec3_is_finite(block->low) || !vec3_is_finite(block->high) || !(block->low.x <= block->high.x) ||
        !(block->low.y <= block->high.y) || !(block->low.z <= block->high.z))
        return WCUT_BAD_ARGUMENT;

    /* points nearer than MERGE are one, so that no segment has a length of zero */
    wcut_vec3 *apart = wcut_alloc((size_t)count, sizeof *apart);
    double *share = wcut_alloc((size_t)count, sizeof *share);
    int *kept = wcut_alloc((size_t)count, sizeof *kept), n = 0;
    wcut_status status = apart && share && kept ? WCUT_OK : WCUT_NO_MEMORY;
    for (int k = 0; status == WCUT_OK && k < count; k++)
        if (n == 0 || vec3_distance(mount[k], apart[n - 1]) > MERGE) apart[n] = mount[k], kept[n++] = k;

    /* a mount that stands still is a point */
    if (status == WCUT_OK)
        status = n < 2 ? measure_point(mount[0], block, near)
                       : path_clearance_measure(n, apart, kept, share, block, tolerance, near);

    wcut_free(kept);
    wcut_free(share);
    wcut_free(apart);
    return status;
}
