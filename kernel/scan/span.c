/* Whether points span more than a line: the eigenvalues of their covariance, the second against the first. */
#include "scan/span.h"

#include <wirecut/cloud.h>

#include "base/numbers.h"
#include "base/symmetric.h"
#include "base/vec3.h"
#include "scan/mesh_distance.h"

static const double LINE = 1e-12;  /* [1] variance across over along, below which points are on a line */
static const double PLACE = 1e-12; /* [1] spread over the size of the coordinates, below which they are in one place */

int wcut_span_of(int count, const wcut_vec3 *point, size_t stride, wcut_vec3 *centroid) {
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
    if (!(sqrt(fmax(value[0], 0) / count) > PLACE * vec3_length(centre))) return 0;
    return value[1] > LINE * value[0] ? 2 : 1;
}

wcut_status wcut_cloud_span(int count, const wcut_vec3 *point, int *span) {
    if (count < 1 || !point || !span || !wcut_are_near(count, point)) return WCUT_BAD_ARGUMENT;
    *span = wcut_span_of(count, point, sizeof *point, NULL);
    return WCUT_OK;
}
