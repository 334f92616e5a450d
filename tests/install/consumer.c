/* The smallest user of an installed library: one version in header and library, and a solve in equilibrium. */
#include <stdio.h>
#include <string.h>
#include <wirecut/wirecut.h>

int main(void) {
    if (strcmp(wcut_version_text(), WCUT_VERSION) != 0) return 1;
    const wcut_vec3 force[3] = {{0, 0, 0}, {0, 2, 0}, {0, 0, 0}};
    const double length[2] = {5, 5};
    double q[2] = {1, 1};
    wcut_vec3 x[3] = {{0, 0, 0}, {0, 0, 0}, {8, 0, 0}};
    if (wcut_fdm_solve(3, force, length, NULL, q, x, NULL) != WCUT_OK) return 2;
    if (x[1].y < 3 - 1e-6 || x[1].y > 3 + 1e-6) return 3; /* a 3-4-5 triangle */
    return puts(wcut_version_text()) < 0;
}
