/* The surface jobs as SISL does them, on the same sheet: one line each for bench_table.sh. A program of its own: SISL
   is under the AGPL, and nothing of it is linked into the library. */
#include <sisl.h>
#include <wirecut/surface.h>

#include "common.h"

static void check(int status, const char *what) {
    if (status >= 0) return;
    fprintf(stderr, "surface_sisl: %s ended with %d\n", what, status);
    exit(EXIT_FAILURE);
}

static void skin(int stations, int nodes, const char *job) {
    double *x = sheet_nodes(stations, nodes), seconds, *u, *v;
    u = malloc((size_t)nodes * sizeof *u), v = malloc((size_t)stations * sizeof *v);
    if (!u || !v) exit(EXIT_FAILURE);
    for (int i = 0; i < nodes; i++) u[i] = (double)i / (nodes - 1);
    for (int j = 0; j < stations; j++) v[j] = (double)j / (stations - 1);
    SISLSurf *s = NULL;
    TIMED(5, seconds, {
        int status = 0;
        if (s) freeSurf(s);
        s1537(x, nodes, stations, 3, u, v, 0, 0, 0, 0, 4, 4, 1, 1, &s, &status);
        check(status, "s1537");
    });
    say(job, "SISL", seconds, "s1537, bicubic, parameters given");
    if (s) freeSurf(s);
    free(v);
    free(u);
    free(x);
}

/* exactly the loft of this library, so that points and distances can be compared */
static SISLSurf *same_surface(int stations, int nodes) {
    double *x = sheet_nodes(stations, nodes);
    wcut_surface *w;
    if (wcut_surface_loft(stations, nodes, (const wcut_vec3 *)x, 1e-6, &w, NULL, NULL) != WCUT_OK) exit(EXIT_FAILURE);
    SISLSurf *s = newSurf(w->count_u, w->count_v, 4, 4, w->knots_u, w->knots_v, &w->control->x, 1, 3, 1);
    if (!s) exit(EXIT_FAILURE);
    wcut_surface_destroy(w);
    free(x);
    return s;
}

static void evaluate(SISLSurf *s) {
    enum { POINTS = 1000000, SIDE = 1000 };
    double *u = malloc(2 * POINTS * sizeof *u), seconds, sum = 0;
    double *p = malloc(3 * POINTS * sizeof *p), *q = malloc(3 * POINTS * sizeof *q);
    char note[80];
    if (!u || !p || !q) exit(EXIT_FAILURE);
    uint64_t state = 1;
    for (int k = 0; k < 2 * POINTS; k++) u[k] = random_share(&state);
    int left_u = 0, left_v = 0;
    TIMED(3, seconds, {
        for (int k = 0; k < POINTS; k++) {
            int status = 0;
            s1424(s, 0, 0, &u[2 * k], &left_u, &left_v, &p[3 * k], &status);
            check(status, "s1424");
        }
    });
    for (int k = 0; k < POINTS; k++) sum += p[3 * k + 2];
    snprintf(note, sizeof note, "s1424, sum of z %.6f", sum);
    say("eval_random", "SISL", seconds, note);
    for (int k = 0; k < SIDE; k++) u[k] = (double)k / (SIDE - 1);
    int status = 0;
    TIMED(3, seconds, s1506(s, 0, SIDE, u, SIDE, u, p, q, &status));
    check(status, "s1506");
    say("eval_grid", "SISL", seconds, "s1506");
    free(q);
    free(p);
    free(u);
}

static void project(SISLSurf *s, int points, const char *job) {
    uint64_t state = 2;
    double sum = 0;
    const double start = cpu_now();
    for (int k = 0; k < points; k++) {
        double p[3], parameter[2], distance = 0;
        int status = 0;
        query_point(&state, p);
        s1958(s, p, 3, 1e-9, 1e-9, parameter, &distance, &status);
        check(status, "s1958");
        if (k < 5) sum += distance;
    }
    char note[80];
    snprintf(note, sizeof note, "s1958; first 5: %.9f", sum);
    say(job, "SISL", (cpu_now() - start) / points, note);
}

int main(void) {
    skin(500, 100, "skin_small");
    skin(2000, 200, "skin_large");
    SISLSurf *small = same_surface(500, 100), *large = same_surface(2000, 200);
    evaluate(large);
    project(small, 1000, "closest_small");
    project(large, 100, "closest_large");
    freeSurf(small);
    freeSurf(large);
    return EXIT_SUCCESS;
}
