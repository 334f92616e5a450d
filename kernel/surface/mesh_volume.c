/* The volume that closed triangles hold: the divergence theorem over tetrahedra from one vertex. */
#include "surface/mesh_volume.h"

#include <stddef.h>

#include "base/vec3.h"

double wcut_mesh_volume(const wcut_mesh *m) {
    double sum = 0, lost = 0; /* compensated (Kahan 1965): a million terms that cancel */
    const wcut_vec3 from = m->vertex_count > 0 ? m->vertex[0] : vec3(0, 0, 0);
    for (int t = 0; t < m->triangle_count; t++) {
        const int *c = m->triangle + 3 * (ptrdiff_t)t;
        const wcut_vec3 a = vec3_sub(m->vertex[c[0]], from), b = vec3_sub(m->vertex[c[1]], from);
        const double term = vec3_dot(vec3_cross(a, b), vec3_sub(m->vertex[c[2]], from)) - lost, next = sum + term;
        lost = next - sum - term;
        sum = next;
    }
    return sum / 6;
}
