/* The surface jobs as this library does them: one line each for bench_table.sh. */
#include <wirecut/mesh.h>
#include <wirecut/projection.h>
#include <wirecut/surface.h>
#include <wirecut/surface_fit.h>

#include "common.h"

static void check(wcut_status status) {
    if (status == WCUT_OK) return;
    fprintf(stderr, "surface_wirecut: %s\n", wcut_status_text(status));
    exit(EXIT_FAILURE);
}

static wcut_surface *skin(int stations, int nodes, const char *job) {
    double *x = sheet_nodes(stations, nodes), seconds;
    wcut_surface *s = NULL;
    TIMED(5, seconds, {
        wcut_surface_destroy(s);
        check(wcut_surface_loft(stations, nodes, (const wcut_vec3 *)x, 1e-6, &s, NULL, NULL));
    });
    say(job, "wirecut", seconds, "bicubic, through every node");
    free(x);
    return s;
}

static void evaluate(const wcut_surface *s) {
    enum { POINTS = 1000000, SIDE = 1000 };
    double *u = malloc(2 * POINTS * sizeof *u), seconds, sum = 0;
    wcut_vec3 *p = malloc(POINTS * sizeof *p);
    char note[80];
    if (!u || !p) exit(EXIT_FAILURE);
    uint64_t state = 1;
    for (int k = 0; k < 2 * POINTS; k++) u[k] = random_share(&state);
    TIMED(5, seconds, {
        for (int k = 0; k < POINTS; k++) check(wcut_surface_eval(s, u[2 * k], u[2 * k + 1], 0, &p[k]));
    });
    for (int k = 0; k < POINTS; k++) sum += p[k].z;
    snprintf(note, sizeof note, "sum of z %.6f", sum);
    say("eval_random", "wirecut", seconds, note);
    for (int k = 0; k < SIDE; k++) u[k] = (double)k / (SIDE - 1);
    TIMED(5, seconds, check(wcut_surface_eval_grid(s, SIDE, u, SIDE, u, p)));
    say("eval_grid", "wirecut", seconds, "");
    free(p);
    free(u);
}

static void project(const wcut_surface *s, const char *job) {
    enum { POINTS = 200000 };
    wcut_vec3 *p = malloc(POINTS * sizeof *p);
    wcut_foot *foot = malloc(POINTS * sizeof *foot);
    if (!p || !foot) exit(EXIT_FAILURE);
    uint64_t state = 2;
    for (int k = 0; k < POINTS; k++) {
        double q[3];
        query_point(&state, q);
        p[k] = (wcut_vec3){q[0], q[1], q[2]};
    }
    double prepared, located, sum = 0;
    wcut_projection *projection = NULL;
    TIMED(3, prepared, {
        wcut_projection_destroy(projection);
        check(wcut_projection_create(s, &projection));
    });
    TIMED(3, located, check(wcut_projection_locate(projection, POINTS, p, 1, foot)));
    int proven = 0;
    for (int k = 0; k < POINTS; k++) proven += foot[k].gap == 0;
    for (int k = 0; k < 5; k++) sum += foot[k].distance;
    char note[120];
    snprintf(note, sizeof note, "%.4g %% proven closest, prepared in %.3g s; first 5: %.9f", 100.0 * proven / POINTS,
             prepared, sum);
    say(job, "wirecut", located / POINTS, note);
    wcut_projection_destroy(projection);
    free(foot);
    free(p);
}

static void tessellate(const wcut_surface *s, double tolerance, const char *job) {
    double seconds;
    wcut_tessellation_report report = {.rows = 0};
    char note[80];
    TIMED(5, seconds, {
        wcut_mesh *mesh;
        check(wcut_surface_tessellate(s, tolerance, &mesh, &report));
        wcut_mesh_destroy(mesh);
    });
    snprintf(note, sizeof note, "%d triangles, measured %.4f mm", 2 * (report.rows - 1) * (report.columns - 1),
             report.chord_error);
    say(job, "wirecut", seconds, note);
}

static void fit(int stations, int nodes, const char *job) {
    double *x = sheet_nodes(stations, nodes), seconds;
    wcut_surface_fit_report r = {.used = 0};
    TIMED(3, seconds, {
        wcut_surface *s;
        check(wcut_surface_fit(stations, nodes, (const wcut_vec3 *)x, 1e-6, 0.01, &s, NULL, &r));
        wcut_surface_destroy(s);
    });
    char note[120];
    snprintf(note, sizeof note, "%d poles (%.3f %%), worst node %.4f mm", r.control_count,
             100.0 * r.control_count / r.node_count, r.node_error);
    say(job, "wirecut", seconds, note);
    free(x);
}

int main(void) {
    wcut_surface *small = skin(500, 100, "skin_small"), *large = skin(2000, 200, "skin_large");
    evaluate(large);
    project(small, "closest_small");
    project(large, "closest_large");
    tessellate(large, 0.1, "tessellate_coarse");
    tessellate(large, 0.01, "tessellate_fine");
    fit(500, 100, "fit_small");
    fit(2000, 200, "fit_large");
    wcut_surface_destroy(small);
    wcut_surface_destroy(large);
    return EXIT_SUCCESS;
}
