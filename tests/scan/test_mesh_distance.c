/* Closest points of a mesh against a full search; the side at faces, edges and corners; what a border is. */
#include <stdio.h>
#include <wirecut/mesh_tree.h>

#include "base/alloc.h"
#include "scan/sheets.h"
#include "test.h"

enum { QUERIES = 400 };

static wcut_mesh *mesh;
static wcut_mesh_tree *tree;
static wcut_vec3 query[QUERIES];
static wcut_mesh_foot foot[QUERIES];

static void forget(void) {
    wcut_mesh_tree_destroy(tree);
    wcut_mesh_destroy(mesh);
    tree = NULL, mesh = NULL;
}

/* triangles without order, of very different sizes, some of them without area */
static void given_soup(int triangles, uint64_t seed) {
    wcut_random r = wcut_random_seed(seed);
    ck_assert_int_eq(wcut_mesh_create(3 * triangles, triangles, 0, &mesh), WCUT_OK);
    for (int t = 0; t < triangles; t++) {
        const wcut_vec3 at = vec3(wcut_random_uniform(&r), wcut_random_uniform(&r), wcut_random_uniform(&r));
        const double size = pow(10, -3 * wcut_random_uniform(&r));
        for (int k = 0; k < 3; k++) {
            const int v = 3 * t + k;
            mesh->triangle[v] = v;
            mesh->vertex[v] = vec3_add(
                vec3_scale(100, at),
                vec3(size * wcut_random_normal(&r), size * wcut_random_normal(&r), size * wcut_random_normal(&r)));
        }
        if (t % 7 == 3) mesh->vertex[3 * t + 2] = vec3_mix(mesh->vertex[3 * (size_t)t], mesh->vertex[3 * t + 1], 0.3);
        if (t % 11 == 5) mesh->vertex[3 * t + 1] = mesh->vertex[3 * t + 2] = mesh->vertex[3 * (size_t)t];
    }
}

/* a sheet of rows x columns points 10 mm apart, seen from above; z = slope x y / 1000 */
static void given_sheet(int rows, int columns, double slope) {
    ck_assert_int_eq(wcut_mesh_create(rows * columns, 2 * (rows - 1) * (columns - 1), 0, &mesh), WCUT_OK);
    int count = 0;
    for (int i = 0; i < rows * columns; i++) {
        const double x = 10 * (i % columns), y = 10 * (i / columns);
        mesh->vertex[i] = vec3(x, y, slope * x * y / 1000);
        if (i % columns == columns - 1 || i / columns == rows - 1) continue;
        const int corner[] = {i, i + 1, i + columns + 1, i, i + columns + 1, i + columns};
        for (int k = 0; k < 6; k++) mesh->triangle[count++] = corner[k];
    }
}

/* a sphere about the origin from an octahedron, halved `rounds` times; corners on the sphere */
static wcut_vec3 sphere_vertex(double radius, wcut_vec3 p) { return vec3_scale(radius, vec3_unit(p)); }

static void put_sphere(double radius, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c, int rounds) {
    if (rounds == 0) {
        const wcut_vec3 corner[3] = {a, b, c};
        for (int k = 0; k < 3; k++) {
            int v = 0;
            while (v < mesh->vertex_count && vec3_distance(mesh->vertex[v], corner[k]) > 1e-9) v++;
            if (v == mesh->vertex_count) mesh->vertex[mesh->vertex_count++] = corner[k];
            mesh->triangle[3 * mesh->triangle_count + k] = v;
        }
        mesh->triangle_count++;
        return;
    }
    const wcut_vec3 ab = sphere_vertex(radius, vec3_add(a, b)), bc = sphere_vertex(radius, vec3_add(b, c)),
                    ca = sphere_vertex(radius, vec3_add(c, a));
    put_sphere(radius, a, ab, ca, rounds - 1);
    put_sphere(radius, ab, b, bc, rounds - 1);
    put_sphere(radius, ca, bc, c, rounds - 1);
    put_sphere(radius, ab, bc, ca, rounds - 1);
}

static void given_sphere(double radius, int rounds) {
    ck_assert_int_eq(wcut_mesh_create(8 << (2 * rounds), 8 << (2 * rounds), 0, &mesh), WCUT_OK);
    mesh->vertex_count = mesh->triangle_count = 0;
    for (int k = 0; k < 8; k++) {
        const wcut_vec3 x = vec3(k & 1 ? -radius : radius, 0, 0), y = vec3(0, k & 2 ? -radius : radius, 0),
                        z = vec3(0, 0, k & 4 ? -radius : radius);
        const bool turned = (k & 1) ^ (k >> 1 & 1) ^ (k >> 2 & 1);
        put_sphere(radius, x, turned ? z : y, turned ? y : z, rounds);
    }
}

static void build(void) { ck_assert_int_eq(wcut_mesh_tree_create(mesh, &tree), WCUT_OK); }

static void given_queries(double low, double high, uint64_t seed) {
    wcut_random r = wcut_random_seed(seed);
    for (int k = 0; k < QUERIES; k++) {
        double p[3];
        for (int c = 0; c < 3; c++) p[c] = low + (high - low) * wcut_random_uniform(&r);
        query[k] = vec3(p[0], p[1], p[2]);
    }
}

static double segment_distance(wcut_vec3 p, wcut_vec3 a, wcut_vec3 b) {
    const wcut_vec3 ab = vec3_sub(b, a);
    const double square = vec3_dot(ab, ab), t = square > 0 ? vec3_dot(vec3_sub(p, a), ab) / square : 0;
    return vec3_distance(p, vec3_mix(a, b, t < 0 ? 0 : t > 1 ? 1 : t));
}

/* by another way than the tree's: over the face if the plane's foot is in it, else from the three edges */
static double triangle_distance(wcut_vec3 p, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c) {
    const wcut_vec3 n = vec3_unit(vec3_cross(vec3_sub(b, a), vec3_sub(c, a)));
    const double height = vec3_dot(vec3_sub(p, a), n);
    const wcut_vec3 q = vec3_add_scaled(p, -height, n), corner[3] = {a, b, c};
    bool inside = vec3_length(n) > 0;
    for (int k = 0; k < 3 && inside; k++)
        inside = vec3_dot(n, vec3_cross(vec3_sub(corner[(k + 1) % 3], corner[k]), vec3_sub(q, corner[k]))) >= 0;
    if (inside) return fabs(height);
    return fmin(segment_distance(p, a, b), fmin(segment_distance(p, b, c), segment_distance(p, c, a)));
}

static double full_search(wcut_vec3 p) {
    double best = INFINITY;
    for (int t = 0; t < mesh->triangle_count; t++) {
        const int *v = mesh->triangle + 3 * (size_t)t;
        best = fmin(best, triangle_distance(p, mesh->vertex[v[0]], mesh->vertex[v[1]], mesh->vertex[v[2]]));
    }
    return best;
}

TEST(the_closest_point_is_that_of_a_full_search) {
    const int counts[] = {1, 2, 4, 5, 9, 33, 300, 3000};
    for (int t = 0; t < 8; t++) {
        given_soup(counts[t], (uint64_t)t + 1);
        build();
        given_queries(-30, 130, (uint64_t)t + 50);
        for (int k = 0; k < QUERIES / 2; k++) /* on the mesh's corners, and nearly */
            query[k] = vec3_add(mesh->vertex[(k * 7) % mesh->vertex_count], vec3(k % 3 ? 1e-7 : 0, 0, 0));
        ck_assert_int_eq(wcut_mesh_tree_locate(tree, QUERIES, query, 1, foot), WCUT_OK);
        for (int k = 0; k < QUERIES; k++) {
            const wcut_mesh_foot *f = &foot[k];
            const int *v = mesh->triangle + 3 * (size_t)f->triangle;
            wcut_vec3 at = vec3_scale(1 - f->b - f->c, mesh->vertex[v[0]]);
            at = vec3_add_scaled(vec3_add_scaled(at, f->b, mesh->vertex[v[1]]), f->c, mesh->vertex[v[2]]);
            ck_assert_double_eq_tol(f->distance, full_search(query[k]), 1e-9);
            ck_assert_double_eq_tol(vec3_distance(f->point, query[k]), f->distance, 1e-9);
            ck_assert(vec3_distance(at, f->point) < 1e-9 && f->b >= 0 && f->c >= 0 && f->b + f->c <= 1 + 1e-12);
        }
        forget();
    }
}

TEST(far_queries_and_far_meshes_lose_nothing) {
    given_sheet(20, 30, 3);
    for (int i = 0; i < mesh->vertex_count; i++) mesh->vertex[i] = vec3_add(mesh->vertex[i], vec3(1e6, -3e6, 2e6));
    build();
    given_queries(-1e7, 1e7, 8);
    ck_assert_int_eq(wcut_mesh_tree_locate(tree, QUERIES, query, 1, foot), WCUT_OK);
    for (int k = 0; k < QUERIES; k++) ck_assert_double_eq_tol(foot[k].distance, full_search(query[k]), 1e-7);
    forget();
}

TEST(the_side_is_right_everywhere_about_a_closed_mesh) {
    given_sphere(50, 3);
    build();
    const wcut_mesh_tree_info *info = wcut_mesh_tree_view(tree);
    ck_assert(info->border_edges == 0 && info->nonmanifold_edges == 0 && info->flat == 0);
    ck_assert_double_eq_tol(vec3_length(info->area_sum), 0, 1e-9 * info->area);
    given_queries(-90, 90, 9);
    for (int k = 0; k < QUERIES / 2; k++) { /* over corners and the middles of edges, on both sides */
        const int *v = mesh->triangle + 3 * (size_t)(k % mesh->triangle_count);
        const wcut_vec3 on = k % 2 ? mesh->vertex[v[0]] : vec3_mix(mesh->vertex[v[0]], mesh->vertex[v[1]], 0.5);
        query[k] = vec3_scale(k % 4 < 2 ? 1.3 : 0.7, on);
    }
    ck_assert_int_eq(wcut_mesh_tree_locate(tree, QUERIES, query, 1, foot), WCUT_OK);
    for (int k = 0; k < QUERIES; k++) {
        const double r = vec3_length(query[k]);
        if (r > 48 && r < 50) continue; /* between the sphere and its chords */
        ck_assert_msg((foot[k].height > 0) == (r > 49), "query %d at %g: height %g", k, r, foot[k].height);
        ck_assert(fabs(foot[k].height) > 0.9 * foot[k].distance && !foot[k].border && !foot[k].beyond);
    }
    forget();
}

TEST(the_side_is_right_everywhere_about_an_open_sheet) {
    given_sheet(21, 31, 4);
    build();
    ck_assert_int_eq(wcut_mesh_tree_view(tree)->border_edges, 2 * (20 + 30));
    wcut_random r = wcut_random_seed(4);
    for (int k = 0; k < QUERIES; k++) {
        const double x = 5 + 290 * wcut_random_uniform(&r), y = 5 + 190 * wcut_random_uniform(&r);
        query[k] = vec3(x, y, 4 * x * y / 1000 + (k % 2 ? 2 : -2));
    }
    ck_assert_int_eq(wcut_mesh_tree_locate(tree, QUERIES, query, 1, foot), WCUT_OK);
    for (int k = 0; k < QUERIES; k++) {
        ck_assert((foot[k].height > 0) == (k % 2 == 1) && !foot[k].beyond);
        ck_assert_double_gt(fabs(foot[k].height), 0.99 * foot[k].distance);
    }
    forget();
}

TEST(what_is_beyond_the_border_is_told_from_what_is_above_it) {
    given_sheet(5, 5, 0); /* 0 .. 40 mm, flat */
    build();
    const struct {
        wcut_vec3 p;
        int border, beyond;
    } given[] = {
        {{20, 20, 3}, 0, 0},    {{0, 20, 3}, 1, 0},    {{-1e-3, 20, 3}, 1, 1}, {{-5, 20, 0}, 1, 1},
        {{0, 0, -2}, 1, 0},     {{-1, -1, 0.5}, 1, 1}, {{41, 20, -7}, 1, 1},   {{20, 40 + 1e-3, 0}, 1, 1},
        {{39.99, 20, 3}, 0, 0}, {{10, 20, -3}, 0, 0},
    };
    for (size_t k = 0; k < sizeof given / sizeof *given; k++) {
        ck_assert_int_eq(wcut_mesh_tree_locate(tree, 1, &given[k].p, 1, foot), WCUT_OK);
        ck_assert_msg(foot->border == given[k].border && foot->beyond == given[k].beyond, "point %zu", k);
        ck_assert_double_eq_tol(foot->height, given[k].p.z, 1e-12);
    }
    forget();
}

TEST(edges_that_are_wound_against_each_other_are_noticed) {
    given_sheet(3, 3, 0);
    const int keep = mesh->triangle[1];
    mesh->triangle[1] = mesh->triangle[2], mesh->triangle[2] = keep;
    build();
    ck_assert_int_gt(wcut_mesh_tree_view(tree)->nonmanifold_edges, 0);
    forget();
}

TEST(threads_change_no_byte) {
    static wcut_mesh_foot other[QUERIES];
    given_sheet(40, 60, 5);
    build();
    given_queries(-50, 600, 3);
    memset(foot, 0, sizeof foot), memset(other, 0, sizeof other);
    ck_assert_int_eq(wcut_mesh_tree_locate(tree, QUERIES, query, 1, foot), WCUT_OK);
    ck_assert_int_eq(wcut_mesh_tree_locate(tree, QUERIES, query, 3, other), WCUT_OK);
    ck_assert(memcmp(foot, other, sizeof foot) == 0);
    forget();
}

TEST(bad_meshes_and_queries_are_refused) {
    wcut_mesh_tree *none = (wcut_mesh_tree *)999;
    given_sheet(3, 3, 0);
    ck_assert_int_eq(wcut_mesh_tree_create(NULL, &none), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_tree_create(mesh, NULL), WCUT_BAD_ARGUMENT);
    const double odd[] = {NAN, INFINITY, -2e12};
    for (int k = 0; k < 3; k++) {
        mesh->vertex[4].y = odd[k];
        ck_assert_int_eq(wcut_mesh_tree_create(mesh, &none), WCUT_BAD_ARGUMENT);
    }
    mesh->vertex[4].y = 10;
    mesh->triangle[5] = 9;
    ck_assert_int_eq(wcut_mesh_tree_create(mesh, &none), WCUT_BAD_ARGUMENT);
    mesh->triangle[5] = -1;
    ck_assert_int_eq(wcut_mesh_tree_create(mesh, &none), WCUT_BAD_ARGUMENT);
    for (int k = 0; k < 3 * mesh->triangle_count; k++) mesh->triangle[k] = k / 3 % 9;
    ck_assert_int_eq(wcut_mesh_tree_create(mesh, &none), WCUT_DEGENERATE);
    ck_assert_ptr_eq(none, (wcut_mesh_tree *)999);
    ck_assert_ptr_null(wcut_mesh_tree_view(NULL));
    wcut_mesh_tree_destroy(NULL);
    forget();
    given_sheet(3, 3, 0);
    build();
    query[0] = vec3(0, NAN, 0);
    foot[0].distance = 999;
    ck_assert_int_eq(wcut_mesh_tree_locate(tree, 1, query, 1, foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_tree_locate(tree, -1, query, 1, foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_tree_locate(tree, 1, query, 0, foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_tree_locate(NULL, 0, NULL, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_tree_locate(tree, 0, NULL, 1, NULL), WCUT_OK);
    ck_assert(foot[0].distance == 999);
    forget();
}

TEST(without_memory_nothing_is_made_or_lost) {
    given_sheet(9, 9, 1);
    tree = (wcut_mesh_tree *)999;
    EACH_FAILED_ALLOCATION(wcut_mesh_tree_create(mesh, &tree), tree == (wcut_mesh_tree *)999);
    query[0] = vec3(1, 1, 1);
    foot[0].distance = 999;
    EACH_FAILED_ALLOCATION(wcut_mesh_tree_locate(tree, 1, query, 1, foot), foot[0].distance == 999);
    forget();
}
