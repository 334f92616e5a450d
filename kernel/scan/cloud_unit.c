/* Does a cloud's size agree with the block's? Scans come in metres, inches and worse. */
#include <stddef.h>
#include <wirecut/cloud.h>

#include "base/numbers.h"
#include "base/vec3.h"

/* A scan may show a part of the face (the ratio falls) and some of its surroundings (it rises): 0.2 to 1.5 is accepted
   as it is. Another factor must explain a whole scan. */
static const double MIN = 0.2, MAX = 1.5, WHOLE_MIN = 0.5, WHOLE_MAX = 1.25;

wcut_status wcut_cloud_unit_eval(wcut_vec3 low, wcut_vec3 high, wcut_vec3 block_size, wcut_cloud_unit *fit) {
    static const double factor[] = {10, 1 / 10.0, 25.4, 1 / 25.4, 1000, 1 / 1000.0};
    if (!fit || !vec3_is_finite(low) || !vec3_is_finite(high) || !is_positive(block_size.x) ||
        !is_positive(block_size.y) || !is_positive(block_size.z) || low.x > high.x || low.y > high.y || low.z > high.z)
        return WCUT_BAD_ARGUMENT;
    const double ratio = vec3_distance(low, high) / hypot(block_size.x, block_size.y);
    double best = 0;
    if (!isfinite(ratio)) return WCUT_BAD_ARGUMENT;
    for (size_t k = 0; k < sizeof factor / sizeof *factor; k++) {
        const double r = ratio * factor[k];
        if (r < WHOLE_MIN || r > WHOLE_MAX) continue;
        if (best == 0 || fabs(log(r)) < fabs(log(ratio * best))) best = factor[k];
    }
    *fit = (wcut_cloud_unit){ratio, ratio >= MIN && ratio <= MAX ? 1 : best};
    return WCUT_OK;
}
