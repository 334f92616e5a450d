/* Whether points span more than a line: the second eigenvalue of their covariance against the first. */
#include "scan/span.h"

#include "base/vec3.h"
#include "scan/register_symmetric.h"

static const double LINE = 1e-12; /* [1] variance across over along, below which points are on a line */

bool wcut_spans_plane(int count, const wcut_vec3 *point, size_t stride, wcut_vec3 *centroid) {
    const char *first = (const char *)point;
    wcut_vec3 sum = {0, 0, 0};
    double a[9] = {0}, value[3], vector[9];
    for (size_t k = 0; k < (size_t)count; k++)
        sum = vec3_add(sum, vec3_sub(*(const wcut_vec3 *)(const void *)(first + k * stride), point[0]));
    const wcut_vec3 centre = vec3_add_scaled(point[0], 1.0 / count, sum);
    for (size_t k = 0; k < (size_t)count; k++) {
        const wcut_vec3 p = vec3_sub(*(const wcut_vec3 *)(const void *)(first + k * stride), centre);
        const double row[3] = {p.x, p.y, p.z};
        for (int i = 0; i < 9; i++) a[i] += row[i / 3] * row[i % 3];
    }
    if (centroid) *centroid = centre;
    wcut_symmetric_eigen(3, a, value, vector);
    return value[1] > LINE * value[0];
}
