/* How fast points are measured against a face, exact and triangulated.  bench_deviation [POINTS [FOLDER]]
   With a folder it leaves there mesh.ply, points.ply and distances.f64 (to surface, then to mesh) for
   bench_deviation.py, which asks other programs the same. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <wirecut/deviation.h>
#include <wirecut/mesh.h>
#include <wirecut/write.h>

#include "base/random.h"

enum { ROWS = 500, COLUMNS = 100, SIDE = 708, ROUNDS = 5 };

/* s, the shortest of the rounds: on the exact surface and on the mesh; by one thread and by two */
typedef struct best {
    double prepared[2], measured[2], both[2];
} best;

static double cpu(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double wall(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void *get(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory) exit(1);
    return memory;
}

static void must(wcut_status status) {
    if (status == WCUT_OK) return;
    fprintf(stderr, "failed: %s\n", wcut_status_text(status));
    exit(1);
}

/* waves over 400 x 1200 mm */
static wcut_vec3 waves(double x, double y) { return (wcut_vec3){x, y, 150 + 30 * sin(x / 80) + 20 * cos(y / 130)}; }

static wcut_surface *make_surface(void) {
    wcut_vec3 *node = get((size_t)ROWS * COLUMNS, sizeof *node);
    wcut_surface *surface = NULL;
    for (int k = 0; k < ROWS * COLUMNS; k++)
        node[k] = waves(400.0 * (k % COLUMNS) / (COLUMNS - 1), 1200.0 * (k / COLUMNS) / (ROWS - 1));
    must(wcut_surface_loft(ROWS, COLUMNS, node, 0, &surface, NULL, NULL));
    free(node);
    return surface;
}

/* a grid of points of the surface itself */
static wcut_mesh *make_mesh(const wcut_surface *surface, int side) {
    wcut_mesh *mesh = NULL;
    double *at = get((size_t)side, sizeof *at);
    must(wcut_mesh_create(side * side, 2 * (side - 1) * (side - 1), 0, &mesh));
    for (int k = 0; k < side; k++) at[k] = k / (side - 1.0);
    must(wcut_surface_eval_grid(surface, side, at, side, at, mesh->vertex));
    int *to = mesh->triangle;
    for (int k = 0; k < side * (side - 1); k++) {
        if (k % side == side - 1) continue;
        const int corner[] = {k, k + 1, k + side + 1, k, k + side + 1, k + side};
        for (int i = 0; i < 6; i++) *to++ = corner[i];
    }
    free(at);
    return mesh;
}

/* a scan in random order: an offset, a wave, noise */
static wcut_vec3 *make_points(int count) {
    wcut_random r = wcut_random_seed(1);
    wcut_vec3 *p = get((size_t)count, sizeof *p);
    for (int k = 0; k < count; k++) {
        p[k] = waves(400 * wcut_random_uniform(&r), 1200 * wcut_random_uniform(&r));
        p[k].z += 0.5 * sin(p[k].x / 40) - 0.3 + 0.1 * wcut_random_normal(&r);
    }
    return p;
}

static void write_all(const char *folder, int count, const wcut_vec3 *p, const wcut_mesh *mesh,
                      const wcut_deviation *exact, const wcut_deviation *flat) {
    char path[4096];
    snprintf(path, sizeof path, "%s/mesh.ply", folder);
    must(wcut_mesh_write_ply(mesh, NULL, path, NULL));
    snprintf(path, sizeof path, "%s/points.ply", folder);
    FILE *file = fopen(path, "wb");
    if (!file) exit(1);
    fprintf(file, "ply\nformat binary_little_endian 1.0\nelement vertex %d\n", count);
    fprintf(file, "property double x\nproperty double y\nproperty double z\nend_header\n");
    fwrite(p, sizeof *p, (size_t)count, file);
    fclose(file);
    snprintf(path, sizeof path, "%s/distances.f64", folder);
    file = fopen(path, "wb");
    if (!file) exit(1);
    for (int k = 0; k < count; k++) fwrite(&exact[k].distance, sizeof(double), 1, file);
    for (int k = 0; k < count; k++) fwrite(&flat[k].distance, sizeof(double), 1, file);
    fclose(file);
}

int main(int argc, char **argv) {
    const int count = argc > 1 ? atoi(argv[1]) : 1000000, side = count >= 1000000 ? SIDE : 2 + (int)sqrt(count / 2.0);
    wcut_surface *surface = make_surface();
    wcut_mesh *mesh = make_mesh(surface, side);
    wcut_vec3 *p = make_points(count);
    wcut_deviation *exact = get((size_t)count, sizeof *exact), *flat = get((size_t)count, sizeof *flat);
    wcut_projection *projection = NULL;
    wcut_mesh_tree *tree = NULL;
    printf("%d points, %d triangles; CPU s of one thread, the shortest of %d\n", count, mesh->triangle_count, ROUNDS);

    best shortest = {.prepared = {INFINITY, INFINITY}, .measured = {INFINITY, INFINITY}, .both = {INFINITY, INFINITY}};
    for (int round = 0; round < ROUNDS; round++) {
        wcut_projection_destroy(projection);
        wcut_mesh_tree_destroy(tree);
        double begin = cpu();
        must(wcut_projection_create(surface, &projection));
        must(wcut_projection_prepare_many(projection));
        shortest.prepared[0] = fmin(shortest.prepared[0], cpu() - begin);
        begin = cpu();
        must(wcut_mesh_tree_create(mesh, &tree));
        shortest.prepared[1] = fmin(shortest.prepared[1], cpu() - begin);
        begin = cpu();
        must(wcut_deviation_from_surface(projection, count, p, NULL, 1, exact, NULL));
        shortest.measured[0] = fmin(shortest.measured[0], cpu() - begin);
        begin = cpu();
        must(wcut_deviation_from_mesh(tree, count, p, NULL, 1, flat));
        shortest.measured[1] = fmin(shortest.measured[1], cpu() - begin);
    }
    for (int k = 0; k < 2; k++)
        printf("%-14s prepared %.3f, measured %.3f\n", k ? "mesh:" : "exact surface:", shortest.prepared[k],
               shortest.measured[k]);
    for (int round = 0; round < ROUNDS; round++)
        for (int threads = 1; threads <= 2; threads++) {
            const double begin = wall();
            must(wcut_deviation_from_surface(projection, count, p, NULL, threads, exact, NULL));
            shortest.both[threads - 1] = fmin(shortest.both[threads - 1], wall() - begin);
        }
    printf("exact surface: two threads %.2f times as fast (wall; says little on a busy machine)\n",
           shortest.both[0] / shortest.both[1]);
    double worst = 0;
    for (int k = 0; k < count; k++) worst = fmax(worst, fabs(exact[k].distance - flat[k].distance));
    printf("mesh off the exact surface by up to %.1e mm\n", worst);
    if (argc > 2) write_all(argv[2], count, p, mesh, exact, flat);

    wcut_mesh_tree_destroy(tree);
    wcut_projection_destroy(projection);
    free(flat);
    free(exact);
    free(p);
    wcut_mesh_destroy(mesh);
    wcut_surface_destroy(surface);
    return 0;
}
