/* How fast and how exactly a scanned face is made into a mesh, beside Open3D's Poisson reconstruction where python3 has
   it.  bench_reconstruction [POINTS [NOISE [HOLE]]]
   POINTS (1000000) with a normal noise of NOISE (0.05) mm on a face of 400 x 600 mm that deviates by a bump, a dent, a
   wave and 1 mm, with a hole of HOLE (50) mm. Errors are of the vertices against the true deviation, and lost is where
   the true face has a point of the scan within the support and no triangle within 1 mm, so of every mesh alike. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include <wirecut/mesh_tree.h>
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
static void make_scan(const wcut_surface *face, int count, double noise, double hole, wcut_vec3 *point,
                      wcut_vec3 *normal) {
    wcut_random r = wcut_random_seed(1);
    for (int k = 0; k < count;) {
        const double u = wcut_random_uniform(&r), v = wcut_random_uniform(&r);
        wcut_vec3 d[4];
        if (hypot(WIDE * u - 250, LONG * v - 120) < hole / 2) continue;
        need(wcut_surface_eval(face, u, v, 1, d) == WCUT_OK, "no point");
        normal[k] = vec3_unit(vec3_cross(d[2], d[1]));
        point[k] = vec3_add_scaled(d[0], deviation(u, v) + noise * wcut_random_normal(&r), normal[k]);
        k++;
    }
}

/* what every mesh is judged by */
typedef struct court {
    const wcut_surface *face;
    const wcut_projection *projection;
    const wcut_kd_tree *tree; /* of the scan */
    int count;
    wcut_vec3 *truth; /* places of the scanned face 2 mm apart that have support */
} court;

static court make_court(const wcut_surface *face, const wcut_projection *projection, const wcut_kd_tree *tree) {
    enum { COLUMNS = 200, ROWS = 300 };
    court c = {face, projection, tree, 0, calloc(COLUMNS * ROWS, sizeof *c.truth)};
    need(c.truth != NULL, "no memory");
    for (int k = 0; k < COLUMNS * ROWS; k++) {
        const double u = (k % COLUMNS + 0.5) / COLUMNS, v = (k / COLUMNS + 0.5) / ROWS;
        wcut_vec3 d[4];
        need(wcut_surface_eval(face, u, v, 1, d) == WCUT_OK, "no point");
        c.truth[c.count] = vec3_add_scaled(d[0], deviation(u, v), vec3_unit(vec3_cross(d[2], d[1])));
        c.count += wcut_kd_tree_distance(tree, c.truth[c.count], 2 * SUPPORT) <= SUPPORT;
    }
    return c;
}

/* [%] of the places that the mesh leaves out */
static double lost_of(const court *c, const wcut_mesh *mesh) {
    wcut_mesh_tree *tree = NULL;
    wcut_mesh_foot *foot = calloc((size_t)c->count, sizeof *foot);
    int lost = 0;
    need(foot && wcut_mesh_tree_create(mesh, &tree) == WCUT_OK, "no mesh");
    need(wcut_mesh_tree_locate(tree, c->count, c->truth, 2, foot) == WCUT_OK, "no distances");
    for (int k = 0; k < c->count; k++) lost += foot[k].distance > 1;
    wcut_mesh_tree_destroy(tree);
    free(foot);
    return 100.0 * lost / c->count;
}

/* error of vertices within the support of the scan; how many are not */
static void judge(const char *name, double seconds, const court *c, const wcut_mesh *mesh) {
    const int count = mesh->vertex_count;
    wcut_foot *foot = calloc((size_t)count, sizeof *foot);
    double sum = 0, max = 0;
    int inside = 0;
    need(foot && wcut_projection_locate(c->projection, count, mesh->vertex, 2, foot) == WCUT_OK, "no feet");
    for (int k = 0; k < count; k++) {
        if (foot[k].beyond || wcut_kd_tree_distance(c->tree, mesh->vertex[k], 2 * SUPPORT) > SUPPORT) continue;
        const double e = foot[k].height - deviation(foot[k].u, foot[k].v);
        sum += e * e;
        max = fmax(max, fabs(e));
        inside++;
    }
    printf("%-28s %7.2f s  %8d vertices  error %.4f mm RMS, %.3f at most  %6.2f %% beyond the support  %5.2f %% lost\n",
           name, seconds, count, sqrt(sum / inside), max, 100.0 * (count - inside) / count, lost_of(c, mesh));
    fflush(stdout);
    free(foot);
}

static void run(const char *name, wcut_reconstruction_options options, const court *c, int count,
                const wcut_vec3 *point, const wcut_foot *foot) {
    wcut_reconstruction *r = NULL;
    wcut_error error;
    const double start = now();
    if (wcut_reconstruction_create(c->face, count, point, foot, &options, 1, &r, &error) != WCUT_OK) {
        printf("%s: %s\n", name, error.text);
        return;
    }
    judge(name, now() - start, c, r->mesh);
    printf("    grid %.2f mm, %d steps; lost %.3f %% of %.0f mm^2; furthest %.2f mm; unmeasured %.0f mm^2, %d holes\n",
           r->spacing, r->iterations, 100 * r->lost, r->supported_area, r->farthest, r->unmeasured_area, r->hole_count);
    wcut_reconstruction_destroy(r);
}

static void write_rows(const char *path, int count, const wcut_vec3 *row) {
    FILE *f = fopen(path, "wb");
    need(f && fwrite(row, sizeof *row, (size_t)count, f) == (size_t)count && fclose(f) == 0, "scan not written");
}

/* rows of three of `size` bytes each, and how many */
static void *read_rows(const char *folder, const char *file, size_t size, int *count) {
    char path[300];
    snprintf(path, sizeof path, "%s/%s", folder, file);
    FILE *f = fopen(path, "rb");
    need(f && fseek(f, 0, SEEK_END) == 0, "a peer's mesh is missing");
    *count = (int)((size_t)ftell(f) / (3 * size));
    void *row = calloc((size_t)*count, 3 * size);
    rewind(f);
    need(row && fread(row, 3 * size, (size_t)*count, f) == (size_t)*count, "a peer's mesh is cut short");
    fclose(f);
    return row;
}

/* Open3D at one depth, in a process of its own; it prints its time */
static void run_peer(const char *folder, int depth, const court *c) {
    char command[600], name[64];
    double seconds = 0;
    snprintf(command, sizeof command, "/usr/bin/python3 %s/tests/bench/bench_reconstruction.py %s %d", WCUT_SOURCE_DIR,
             folder, depth);
    snprintf(name, sizeof name, "Open3D Poisson, depth %d", depth);
    FILE *pipe = popen(command, "r");
    const int told = pipe && fscanf(pipe, "%lf", &seconds) == 1;
    if (!pipe || pclose(pipe) != 0 || !told) {
        printf("%s: skipped, /usr/bin/python3 has no open3d\n", name);
        return;
    }
    wcut_mesh mesh = {0};
    mesh.vertex = read_rows(folder, "vertices", sizeof(double), &mesh.vertex_count);
    mesh.triangle = read_rows(folder, "triangles", sizeof(int), &mesh.triangle_count);
    judge(name, seconds, c, &mesh);
    free(mesh.vertex);
    free(mesh.triangle);
}

static void run_peers(int count, const wcut_vec3 *point, const wcut_vec3 *normal, const court *c) {
    char folder[] = "/tmp/bench_reconstructionXXXXXX", path[300];
    const char *const file[] = {"points", "normals", "vertices", "triangles"};
    need(mkdtemp(folder) != NULL, "no folder");
    snprintf(path, sizeof path, "%s/points", folder);
    write_rows(path, count, point);
    snprintf(path, sizeof path, "%s/normals", folder);
    write_rows(path, count, normal);
    for (int depth = 8; depth <= 9; depth++) run_peer(folder, depth, c);
    for (int k = 0; k < 4; k++) {
        snprintf(path, sizeof path, "%s/%s", folder, file[k]);
        (void)unlink(path);
    }
    (void)rmdir(folder);
}

int main(int argc, char **argv) {
    const int count = argc > 1 ? atoi(argv[1]) : 1000000;
    const double noise = argc > 2 ? atof(argv[2]) : 0.05, hole = argc > 3 ? atof(argv[3]) : 50;
    need(count >= 1000 && noise >= 0 && hole >= 0, "POINTS at least 1000, NOISE and HOLE not negative");
    wcut_surface *face = make_face();
    wcut_projection *projection = NULL;
    wcut_kd_tree tree;
    wcut_vec3 *point = calloc((size_t)count, sizeof *point), *normal = calloc((size_t)count, sizeof *normal);
    wcut_foot *foot = calloc((size_t)count, sizeof *foot);
    need(point && normal && foot && wcut_projection_create(face, &projection) == WCUT_OK, "no memory");
    make_scan(face, count, noise, hole, point, normal);
    need(wcut_kd_tree_build(count, point, 1, &tree) == WCUT_OK, "no memory");
    const double start = now();
    need(wcut_projection_locate(projection, count, point, 1, foot) == WCUT_OK, "no feet");
    printf("%d points, noise %g mm, hole %g mm; feet %.2f s\n", count, noise, hole, now() - start);
    court c = make_court(face, projection, &tree);
    wcut_reconstruction_options options = wcut_reconstruction_options_default();
    options.support = SUPPORT;
    run("field of deviation", options, &c, count, point, foot);
    run_peers(count, point, normal, &c);
    free(c.truth);
    wcut_kd_tree_clear(&tree);
    wcut_projection_destroy(projection);
    wcut_surface_destroy(face);
    free(point), free(normal), free(foot);
    return 0;
}
