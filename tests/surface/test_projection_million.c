/* labels: property slow
   A million planted points: every foot found, proven, and right to 1e-9 mm. */
#include <stdio.h>
#include <wirecut/projection.h>

#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

TEST(a_million_planted_feet_are_found_again) {
    enum { STATIONS = 500, NODES = 100, POINTS = 1000000 };
    wcut_vec3 *x = malloc(STATIONS * NODES * sizeof *x), *query = malloc(POINTS * sizeof *query);
    wcut_foot *foot = malloc(POINTS * sizeof *foot);
    double *u = malloc(POINTS * sizeof *u), *v = malloc(POINTS * sizeof *v), *height = malloc(POINTS * sizeof *height);
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) x[j * NODES + i] = sheet_point(i / (NODES - 1.0), j / (STATIONS - 1.0));
    wcut_surface *s = NULL;
    wcut_projection *m = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, x, 0, &s, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_projection_create(s, &m), WCUT_OK);
    wcut_random random = wcut_random_seed(91);
    for (int k = 0; k < POINTS; k++) { /* the sheet's radii of curvature are above 300 mm */
        wcut_vec3 d[4];
        u[k] = k % 101 == 0 ? k / 101 % 2 : wcut_random_uniform(&random);
        v[k] = k % 103 == 0 ? k / 103 % 2 : wcut_random_uniform(&random);
        height[k] = k % 17 == 0 ? 0 : 100 * (2 * wcut_random_uniform(&random) - 1);
        wcut_surface_eval(s, u[k], v[k], 1, d);
        query[k] = vec3_add_scaled(d[0], height[k], vec3_unit(vec3_cross(d[2], d[1])));
    }
    for (int newton = 0; newton < 2; newton++) {
        if (newton) ck_assert_int_eq(wcut_projection_prepare_many(m), WCUT_OK);
        for (int k = 0; k < POINTS; k++) foot[k].distance = foot[k].gap = 999;
        ck_assert_int_eq(wcut_projection_locate(m, POINTS, query, 2, foot), WCUT_OK);
        double worst = 0, worst_point = 0;
        int unproven = 0, beyond = 0;
        for (int k = 0; k < POINTS; k++) {
            wcut_vec3 p;
            wcut_surface_eval(s, u[k], v[k], 0, &p);
            worst = fmax(worst, fmax(fabs(foot[k].distance - fabs(height[k])), fabs(foot[k].height - height[k])));
            worst_point = fmax(worst_point, vec3_distance(p, foot[k].point));
            unproven += foot[k].gap != 0;
            beyond += foot[k].beyond;
        }
        printf("1,000,000 planted points%s: worst distance %.2g mm, worst foot %.2g mm\n", newton ? ", quickly" : "",
               worst, worst_point);
        ck_assert(unproven == 0 && beyond == 0);
        ck_assert_double_lt(worst, 1e-9);
        ck_assert_double_lt(worst_point, 1e-9);
    }
    wcut_projection_destroy(m);
    wcut_surface_destroy(s);
    free(height), free(v), free(u), free(foot), free(query), free(x);
}
