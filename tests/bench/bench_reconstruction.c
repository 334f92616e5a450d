/* How fast and how exactly a scanned face is made into a mesh, beside Open3D's Poisson reconstruction where python3 has
   it.  bench_reconstruction [POINTS [NOISE]]
   POINTS (1000000) with a normal noise of NOISE (0.05) mm on a face of 400 x 600 mm that deviates by a bump, a dent, a
   wave and 1 mm, with a hole of 50 mm. Errors are of the vertices against the true deviation, so of every mesh alike. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include <wirecut/reconstruction.h>

#include "base/random.h"
#include "base/vec3.h"
#include "scan/kd_tree.h"

enum { NODES = 41, STATIONS = 61 };

static const double WIDE = 400, LONG = 600, SUPPORT = 1.5;

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void need(int done, const char *what) {
    if (done) return;
    fprintf(stderr, "bench_reconstruction: %s\n", what);
    exit(1);
}

static double height(double x, double y) {
    return 150 + 30 * sin(0.011 * y + 0.004 * x) + 20 * cos(0.013 * x - 0.003 * y);
}

static double bell(double x, double y, double at_x, double at_y, double size) {
    return exp(-((x - at_x) * (x - at_x) + (y - at_y) * (y - at_y)) / (2 * size * size));
}

static double deviation(double u, double v) {
    const double x = WIDE * u, y = LONG * v;
    return 1 + 2 * bell(x, y, 120, 200, 40) - 1.5 * bell(x, y, 300, 420, 15) + 0.5 * sin(0.02 * x + 0.01 * y);
}

static wcut_surface *make_face(void) {
    static wcut_vec3 node[NODES * STATIONS];
    wcut_surface *surface = NULL;
    for (int k = 0; k < NODES * STATIONS; k++) {
        const int i = k % NODES, j = k / NODES;
        node[k].x = WIDE * i / (NODES - 1), node[k].y = LONG * j / (STATIONS - 1);
        node[k].z = height(node[k].x, node[k].y);
    }
    need(wcut_surface_loft(STATIONS, NODES, node, 1e-3, &surface, NULL, NULL) == WCUT_OK, "no face");
    return surface;
}

/* points and the normals of the face */
static void make_scan(const wcut_surface *face, int count, double noise, wcut_vec3 *point, wcut_vec3 *normal) {
    wcut_random r = wcut_random_seed(1);
    for (int k = 0; k < count;) {
        const double u = wcut_random_uniform(&r), v = wcut_random_uniform(&r);
        wcut_vec3 d[4];
        if (hypot(WIDE * u - 250, LONG * v - 120) < 25) continue;
        need(wcut_surface_eval(face, u, v, 1, d) == WCUT_OK, "no point");
        normal[k] = vec3_unit(vec3_cross(d[2], d[1]));
        point[k] = vec3_add_scaled(d[0], deviation(u, v) + noise * wcut_random_normal(&r), normal[k]);
        k++;
    }
}

/* error of vertices within the support of the scan; how many are not */
static void judge(const char *name, double seconds, const wcut_projection *projection, const wcut_kd_tree *tree,
                  int count, const wcut_vec3 *vertex) {
    wcut_foot *foot = calloc((size_t)count, sizeof *foot);
    double sum = 0, most = 0;
    int inside = 0;
    need(foot && wcut_projection_locate(projection, count, vertex, 2, foot) == WCUT_OK, "no feet");
    for (int k = 0; k < count; k++) {
        if (foot[k].beyond || wcut_kd_tree_distance(tree, vertex[k], 2 * SUPPORT) > SUPPORT) continue;
        const double e = foot[k].height - deviation(foot[k].u, foot[k].v);
        sum += e * e;
        most = fmax(most, fabs(e));
        inside++;
    }
    printf("%-28s %7.2f s  %8d vertices  error %.4f mm RMS, %.3f at most  %6.2f %% beyond the support\n", name, seconds,
           count, sqrt(sum / inside), most, 100.0 * (count - inside) / count);
    free(foot);
}

static void run(const char *name, wcut_reconstruction_options options, const wcut_surface *face,
                const wcut_projection *projection, const wcut_kd_tree *tree, int count, const wcut_vec3 *point,
                const wcut_foot *foot) {
    wcut_reconstruction *r = NULL;
    wcut_error error;
    const double start = now();
    if (wcut_reconstruction_create(face, count, point, foot, &options, 1, &r, &error) != WCUT_OK) {
        printf("%s: %s\n", name, error.text);
        return;
    }
    judge(name, now() - start, projection, tree, r->mesh->vertex_count, r->mesh->vertex);
    printf("    grid %.2f mm, %d steps; lost %.3f %% of %.0f mm^2; furthest %.2f mm; unmeasured %.0f mm^2, %d holes\n",
           r->spacing, r->iterations, 100 * r->lost, r->supported_area, r->farthest, r->unmeasured_area, r->hole_count);
    wcut_reconstruction_destroy(r);
}

static void write_rows(const char *path, int count, const wcut_vec3 *row) {
    FILE *f = fopen(path, "wb");
    need(f && fwrite(row, sizeof *row, (size_t)count, f) == (size_t)count && fclose(f) == 0, "scan not written");
}

/* Open3D at one depth, in a process of its own; it prints its time */
static void run_peer(const char *folder, int depth, const wcut_projection *projection, const wcut_kd_tree *tree) {
    char command[600], path[300], name[64];
    double seconds = 0;
    snprintf(command, sizeof command, "/usr/bin/python3 %s/tests/bench/bench_reconstruction.py %s %d", WCUT_SOURCE_DIR,
             folder, depth);
    snprintf(name, sizeof name, "Open3D Poisson, depth %d", depth);
    snprintf(path, sizeof path, "%s/vertices", folder);
    FILE *pipe = popen(command, "r");
    const int told = pipe && fscanf(pipe, "%lf", &seconds) == 1;
    if (!pipe || pclose(pipe) != 0 || !told) {
        printf("%s: skipped, /usr/bin/python3 has no open3d\n", name);
        return;
    }
    FILE *f = fopen(path, "rb");
    need(f && fseek(f, 0, SEEK_END) == 0, "no vertices");
    const int count = (int)(ftell(f) / (long)sizeof(wcut_vec3));
    wcut_vec3 *vertex = calloc((size_t)count, sizeof *vertex);
    rewind(f);
    need(vertex && fread(vertex, sizeof *vertex, (size_t)count, f) == (size_t)count, "no vertices");
    fclose(f);
    judge(name, seconds, projection, tree, count, vertex);
    free(vertex);
}

static void run_peers(int count, const wcut_vec3 *point, const wcut_vec3 *normal, const wcut_projection *projection,
                      const wcut_kd_tree *tree) {
    char folder[] = "/tmp/bench_reconstructionXXXXXX", path[300];
    const char *const file[] = {"points", "normals", "vertices"};
    need(mkdtemp(folder) != NULL, "no folder");
    snprintf(path, sizeof path, "%s/points", folder);
    write_rows(path, count, point);
    snprintf(path, sizeof path, "%s/normals", folder);
    write_rows(path, count, normal);
    for (int depth = 8; depth <= 9; depth++) run_peer(folder, depth, projection, tree);
    for (int k = 0; k < 3; k++) {
        snprintf(path, sizeof path, "%s/%s", folder, file[k]);
        (void)unlink(path);
    }
    (void)rmdir(folder);
}

int main(int argc, char **argv) {
    const int count = argc > 1 ? atoi(argv[1]) : 1000000;
    const double noise = argc > 2 ? atof(argv[2]) : 0.05;
    need(count >= 1000 && noise >= 0, "POINTS at least 1000, NOISE not negative");
    wcut_surface *face = make_face();
    wcut_projection *projection = NULL;
    wcut_kd_tree tree;
    wcut_vec3 *point = calloc((size_t)count, sizeof *point), *normal = calloc((size_t)count, sizeof *normal);
    wcut_foot *foot = calloc((size_t)count, sizeof *foot);
    need(point && normal && foot && wcut_projection_create(face, &projection) == WCUT_OK, "no memory");
    make_scan(face, count, noise, point, normal);
    need(wcut_kd_tree_build(count, point, 1, &tree) == WCUT_OK, "no memory");
    const double start = now();
    need(wcut_projection_locate(projection, count, point, 1, foot) == WCUT_OK, "no feet");
    printf("%d points, noise %g mm; feet %.2f s\n", count, noise, now() - start);
    wcut_reconstruction_options options = wcut_reconstruction_options_default();
    options.support = SUPPORT;
    run("field of deviation", options, face, projection, &tree, count, point, foot);
    options.method = WCUT_RECONSTRUCTION_POISSON;
    run("Poisson of the closed sheet", options, face, projection, &tree, count, point, foot);
    run_peers(count, point, normal, projection, &tree);
    wcut_kd_tree_clear(&tree);
    wcut_projection_destroy(projection);
    wcut_surface_destroy(face);
    free(point), free(normal), free(foot);
    return 0;
}
