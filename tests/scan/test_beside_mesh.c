/* A mesh in the place of an exact face: registration to it, reconstruction over its plane, the map of its vertices.
   labels: unit plain */
#include <string.h>
#include <wirecut/face.h>
#include <wirecut/reconstruction.h>
#include <wirecut/registration.h>

#include "base/alloc.h"
#include "base/random.h"
#include "scan/faces.h"
#include "scan/register_motion.h"
#include "scan/sheets.h"
#include "test.h"

enum { N = 40000, FEW = 800 };
static wcut_vec3 scan[N], truth[N];
static wcut_foot foot[N];
static wcut_surface *surface, *plane;
static wcut_projection *projection;
static wcut_mesh *mesh;
static wcut_mesh_tree *tree;

static const double CHORD = 0.01;

static void given(void) {
    surface = given_face(wavy_height);
    ck_assert_int_eq(wcut_surface_tessellate(surface, CHORD, &mesh, NULL), WCUT_OK);
    plane = NULL, projection = NULL, tree = NULL;
}

static void given_tree(void) { ck_assert_int_eq(wcut_mesh_tree_create(mesh, &tree), WCUT_OK); }

static void given_plane(int flip) {
    ck_assert_int_eq(wcut_mesh_base(mesh, flip, &plane), WCUT_OK);
    projection = given_projection(plane);
}

static void end(void) {
    wcut_mesh_tree_destroy(tree);
    wcut_projection_destroy(projection);
    wcut_surface_destroy(plane);
    wcut_mesh_destroy(mesh);
    wcut_surface_destroy(surface);
}

/* only triangles whose middle is not in the corner x > 250 mm, y > 400 mm: an L */
static void cut_corner(void) {
    int kept = 0;
    for (int t = 0; t < mesh->triangle_count; t++) {
        const int *v = mesh->triangle + 3 * (size_t)t;
        const wcut_vec3 m = vec3_add(vec3_add(mesh->vertex[v[0]], mesh->vertex[v[1]]), mesh->vertex[v[2]]);
        if (m.x > 3 * 250 && m.y > 3 * 400) continue;
        memmove(mesh->triangle + 3 * (size_t)kept++, v, 3 * sizeof *v);
    }
    mesh->triangle_count = kept;
}

static double area_of(const wcut_mesh *m, int t) {
    const int *v = m->triangle + 3 * (size_t)t;
    const wcut_vec3 a = m->vertex[v[0]];
    return vec3_length(vec3_cross(vec3_sub(m->vertex[v[1]], a), vec3_sub(m->vertex[v[2]], a))) / 2;
}

static double mesh_area(void) {
    double area = 0;
    for (int t = 0; t < mesh->triangle_count; t++) area += area_of(mesh, t);
    return area;
}

/* ---- registration ---- */

static wcut_registration found;

static wcut_status fit(int count, const wcut_registration_options *options, int threads) {
    return wcut_registration_fit_mesh(mesh, tree, count, scan, options, threads, &found, NULL);
}

/* points of the exact face, misplaced by a motion about the middle of the block */
static void misplace(const double *x) {
    given_scan(surface, FEW, 0.02, 0, 3, truth);
    const wcut_motion m = wcut_motion_of(vec3(200, 300, 150), x);
    for (int k = 0; k < FEW; k++) scan[k] = motion_apply(&m, truth[k]);
}

static double furthest(void) {
    double max = 0;
    ck_assert_int_eq(wcut_registration_move(&found, FEW, scan, NULL), WCUT_OK);
    for (int k = 0; k < FEW; k++) max = fmax(max, vec3_distance(scan[k], truth[k]));
    return max;
}

TEST(a_scan_comes_back_onto_a_mesh_as_far_as_the_mesh_is_the_face) {
    static const double near[6] = {1, -2, 3, 0.01, -0.02, 0.015}, far[6] = {500, 300, -200, 1, 2, -0.5};
    given();
    given_tree();
    misplace(near);
    ck_assert_int_eq(fit(FEW, NULL, 1), WCUT_OK);
    ck_assert(found.method == WCUT_REGISTRATION_METHOD_FIT && found.rank == 6 && found.overlap > 0.99);
    ck_assert_double_lt(found.rms, CHORD);
    ck_assert_double_lt(furthest(), 2 * CHORD);
    misplace(far);
    ck_assert_int_eq(fit(FEW, NULL, 1), WCUT_OK);
    ck_assert_double_lt(furthest(), 2 * CHORD);
    end();
}

TEST(a_fit_to_a_mesh_does_not_depend_on_threads) {
    static const double near[6] = {1, -2, 3, 0.01, -0.02, 0.015};
    given();
    given_tree();
    misplace(near);
    ck_assert_int_eq(fit(FEW, NULL, 1), WCUT_OK);
    const wcut_registration first = found;
    ck_assert_int_eq(fit(FEW, NULL, 3), WCUT_OK);
    ck_assert_mem_eq(&first, &found, sizeof first);
    end();
}

TEST(a_fit_to_a_mesh_refuses_what_a_fit_refuses) {
    wcut_registration_options options = wcut_registration_options_default();
    wcut_registration blank;
    wcut_error error = {WCUT_OK, ""};
    given();
    given_tree();
    given_scan(surface, FEW, 0.02, 0, 3, scan);
    memset(&found, 0x99, sizeof found);
    blank = found;
    ck_assert_int_eq(fit(5, NULL, 1), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(fit(FEW, NULL, 0), WCUT_BAD_ARGUMENT);
    options.keep = 0.1;
    ck_assert_int_eq(fit(FEW, &options, 1), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_fit_mesh(NULL, tree, FEW, scan, NULL, 1, &found, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_fit_mesh(mesh, NULL, FEW, scan, NULL, 1, &found, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_fit_mesh(mesh, tree, FEW, NULL, NULL, 1, &found, NULL), WCUT_BAD_ARGUMENT);
    mesh->triangle_count--; /* not the tree's */
    ck_assert_int_eq(fit(FEW, NULL, 1), WCUT_BAD_ARGUMENT);
    mesh->triangle_count++;
    for (int k = 0; k < FEW; k++) scan[k] = vec3(k, 2 * k, 3 * k);
    ck_assert_int_eq(wcut_registration_fit_mesh(mesh, tree, FEW, scan, NULL, 1, &found, &error), WCUT_DEGENERATE);
    ck_assert_ptr_nonnull(strstr(error.text, "on one line"));
    for (int k = 0; k < FEW; k++) scan[k] = vec3(5000 + k, 5000 + k % 7, 0); /* beyond the border, all of them */
    options = wcut_registration_options_default();
    options.coarse = 0;
    ck_assert_int_eq(fit(FEW, &options, 1), WCUT_DEGENERATE);
    ck_assert_mem_eq(&found, &blank, sizeof blank);
    end();
}

TEST(a_fit_to_a_mesh_tells_that_memory_ends) {
    given();
    given_tree();
    given_scan(surface, FEW, 0.02, 0.1, 3, scan);
    EACH_FAILED_ALLOCATION_BY(9, fit(FEW, NULL, 1), true);
    end();
}

/* ---- noise: points that come and go at borders and creases do not stop a fit ---- */

/* a box of 100 x 60 x 40 mm, open at the top where `open` */
static void given_box(int open) {
    static const int face[12][3] = {{0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}, {0, 5, 1}, {0, 4, 5},
                                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    surface = plane = NULL, projection = NULL;
    ck_assert_int_eq(wcut_mesh_create(8, open ? 10 : 12, 0, &mesh), WCUT_OK);
    for (int k = 0; k < 8; k++) mesh->vertex[k] = vec3(k & 4 ? 100 : 0, k & 2 ? 60 : 0, k & 1 ? 40 : 0);
    memcpy(mesh->triangle, face, 3 * (size_t)mesh->triangle_count * sizeof(int));
    given_tree();
}

/* so many points evenly over the area, each coordinate with noise */
static void scan_box(int count, double noise, uint64_t seed) {
    wcut_random r = wcut_random_seed(seed);
    double reach[12] = {0}, sum = 0;
    for (int t = 0; t < mesh->triangle_count; t++) reach[t] = sum += area_of(mesh, t);
    for (int k = 0; k < count; k++) {
        int t = 0;
        for (const double at = sum * wcut_random_uniform(&r); reach[t] < at; t++) {
        }
        double u = wcut_random_uniform(&r), v = wcut_random_uniform(&r);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const wcut_vec3 *p = mesh->vertex;
        const int *c = mesh->triangle + 3 * (size_t)t;
        truth[k] = vec3_add(
            p[c[0]], vec3_add(vec3_scale(u, vec3_sub(p[c[1]], p[c[0]])), vec3_scale(v, vec3_sub(p[c[2]], p[c[0]]))));
        truth[k] = vec3_add(truth[k], vec3(noise * wcut_random_normal(&r), noise * wcut_random_normal(&r),
                                           noise * wcut_random_normal(&r)));
    }
}

TEST(noise_at_borders_and_creases_does_not_stop_a_fit) {
    enum { POINTS = 6000 };
    static const double x[WCUT_DOF_COUNT] = {1, -1, 1, 0.00617, 0.00617, 0}, noise[] = {0.02, 0.05, 0.2, 1};
    const wcut_motion m = wcut_motion_of(vec3(50, 30, 20), x);
    for (int trial = 0; trial < 16; trial++) {
        given_box(trial % 2);
        scan_box(POINTS, noise[trial / 4], (uint64_t)trial);
        for (int k = 0; k < POINTS; k++) scan[k] = motion_apply(&m, truth[k]);
        ck_assert_int_eq(fit(POINTS, NULL, 1), WCUT_OK);

        /* the points come back as far as the noise lets them, and the standard error says how far that is */
        double square = 0;
        ck_assert_int_eq(wcut_registration_move(&found, POINTS, scan, NULL), WCUT_OK);
        for (int k = 0; k < POINTS; k++) square += vec3_dot(vec3_sub(scan[k], truth[k]), vec3_sub(scan[k], truth[k]));
        const double off = sqrt(square / POINTS), error = noise[trial / 4] * sqrt(6.0 / POINTS) * sqrt(3);
        ck_assert_double_lt(off, 3 * error + 0.02 * noise[trial / 4]);
        ck_assert_double_lt(found.step, fmax(1e-7, 0.011 * found.doubt));
        ck_assert(found.doubt > 0.5 * error && found.doubt < 2 * error);
        ck_assert_double_eq_tol(found.noise, noise[trial / 4], 0.1 * noise[trial / 4]);
        end();
    }
}

/* ---- reconstruction ---- */

static double deviation(double x, double y) {
    return -1 + exp(-((x - 60) * (x - 60) + (y - 80) * (y - 80)) / (2 * 15 * 15)) + 0.004 * x;
}

/* a part of the face 100 mm wide and 150 mm long, without a disc of `radius` in its middle; how many points */
static int given_points(double radius, double noise) {
    wcut_random r = wcut_random_seed(3);
    int kept = 0;
    while (kept < N) {
        const double x = 100 * wcut_random_uniform(&r), y = 150 * wcut_random_uniform(&r);
        const double by = deviation(x, y) + noise * wcut_random_normal(&r);
        if (hypot(x - 50, y - 75) < radius) continue;
        scan[kept++] = above(surface, x / 400, y / 600, by);
    }
    ck_assert_int_eq(wcut_projection_locate(projection, kept, scan, 1, foot), WCUT_OK);
    return kept;
}

static wcut_reconstruction *reconstruct(int count) {
    wcut_reconstruction *made = NULL;
    wcut_reconstruction_options options = wcut_reconstruction_options_default();
    options.mesh = mesh;
    ck_assert_int_eq(wcut_reconstruction_create(plane, count, scan, foot, &options, 1, &made, NULL), WCUT_OK);
    return made;
}

/* RMS of the vertices' heights over the exact face less the truth */
static double error_of(const wcut_mesh *m, double *max) {
    wcut_projection *exact = given_projection(surface);
    wcut_foot *at = calloc((size_t)m->vertex_count, sizeof *at);
    double sum = 0;
    ck_assert_int_eq(wcut_projection_locate(exact, m->vertex_count, m->vertex, 1, at), WCUT_OK);
    *max = 0;
    for (int k = 0; k < m->vertex_count; k++) {
        const double e = at[k].height - deviation(400 * at[k].u, 600 * at[k].v);
        sum += e * e;
        *max = fmax(*max, fabs(e));
    }
    free(at);
    wcut_projection_destroy(exact);
    return sqrt(sum / m->vertex_count);
}

TEST(a_scan_is_reconstructed_beside_a_mesh_as_beside_its_surface) {
    double max;
    given();
    given_plane(0);
    const int count = given_points(20, 0.05);
    wcut_reconstruction *made = reconstruct(count);
    ck_assert_double_lt(error_of(made->mesh, &max), 0.015);
    ck_assert_double_lt(max, 0.15);
    ck_assert_double_lt(made->lost, 0.02); /* half a cell along its border */
    ck_assert_double_le(made->farthest, 1.5);
    /* what is not scanned is the mesh itself, not the plane */
    double area = made->unmeasured_area, height;
    const wcut_mesh *m = made->unmeasured;
    for (int k = 0; k < m->vertex_count; k += 37) {
        height = wavy_height(m->vertex[k].x, m->vertex[k].y);
        ck_assert_double_eq_tol(m->vertex[k].z, height, 0.15);
    }
    for (int t = 0; t < m->triangle_count; t++) area -= area_of(m, t);
    ck_assert_double_eq_tol(area, 0, 1e-6 * made->unmeasured_area);
    ck_assert_int_eq(made->hole_count, 2);
    ck_assert(made->hole[0].open && !made->hole[1].open);
    ck_assert_double_lt(fabs(made->hole[1].centre.z - wavy_height(50, 75)), 2);
    wcut_reconstruction_destroy(made);
    end();
}

TEST(where_the_mesh_is_not_nothing_is_missed) {
    given();
    cut_corner();
    given_plane(0);
    const int count = given_points(0, 0);
    wcut_reconstruction *made = reconstruct(count);
    ck_assert_double_eq_tol(made->area + made->unmeasured_area, mesh_area(), 0.01 * mesh_area());
    wcut_reconstruction_destroy(made);
    end();
}

TEST(a_turned_mesh_has_a_turned_plane) {
    wcut_vec3 d[4];
    given();
    for (int flip = 0; flip < 2; flip++) {
        given_plane(flip);
        ck_assert_int_eq(wcut_surface_eval(plane, 0.5, 0.5, 1, d), WCUT_OK);
        ck_assert(flip ? vec3_cross(d[2], d[1]).z < 0 : vec3_cross(d[2], d[1]).z > 0);
        wcut_projection_destroy(projection);
        wcut_surface_destroy(plane);
    }
    plane = NULL, projection = NULL;
    end();
}

TEST(what_is_no_sheet_has_no_plane) {
    static const int sides[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    wcut_mesh *solid = NULL;
    plane = (void *)sides;
    ck_assert_int_eq(wcut_mesh_create(4, 4, 0, &solid), WCUT_OK);
    ck_assert_int_eq(wcut_mesh_base(solid, 0, &plane), WCUT_DEGENERATE); /* all in one place */
    memcpy(solid->triangle, sides, sizeof sides);
    for (int k = 1; k < 4; k++) solid->vertex[k] = vec3(k == 1, k == 2, k == 3);
    ck_assert_int_eq(wcut_mesh_base(solid, 0, &plane), WCUT_DEGENERATE); /* closed */
    solid->triangle[5] = 4;
    ck_assert_int_eq(wcut_mesh_base(solid, 0, &plane), WCUT_BAD_ARGUMENT);
    solid->triangle[5] = -1;
    ck_assert_int_eq(wcut_mesh_base(solid, 0, &plane), WCUT_BAD_ARGUMENT);
    solid->triangle[5] = 3, solid->vertex[2].x = NAN;
    ck_assert_int_eq(wcut_mesh_base(solid, 0, &plane), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_base(NULL, 0, &plane), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_eq(plane, (void *)sides);
    solid->vertex[2].x = 0, solid->triangle_count = 1;
    ck_assert_int_eq(wcut_mesh_base(solid, 0, NULL), WCUT_BAD_ARGUMENT);
    wcut_mesh_destroy(solid);
}

TEST(a_reconstruction_beside_a_mesh_tells_that_memory_ends) {
    given();
    given_plane(0);
    wcut_reconstruction *made = NULL;
    wcut_reconstruction_options options = wcut_reconstruction_options_default();
    const int count = given_points(0, 0.05);
    options.mesh = mesh, options.spacing = 5, options.support = 6;
    EACH_FAILED_ALLOCATION(wcut_reconstruction_create(plane, count, scan, foot, &options, 1, &made, NULL), !made);
    wcut_reconstruction_destroy(made);
    end();
}

/* ---- the map of a mesh ---- */

/* two triangles of 10 x 10 mm, divided into 2 x SIDE^2 */
static void given_square(int side) {
    ck_assert_int_eq(wcut_mesh_create((side + 1) * (side + 1), 2 * side * side, 0, &mesh), WCUT_OK);
    for (int k = 0; k < mesh->vertex_count; k++)
        mesh->vertex[k] = vec3(10.0 * (k % (side + 1)) / side, 10.0 * (k / (side + 1)) / side, 0);
    for (int t = 0; t < mesh->triangle_count; t++) {
        const int k = t / 2 / side * (side + 1) + t / 2 % side,
                  *to = t % 2 ? (int[]){k, k + side + 2, k + side + 1} : (int[]){k, k + 1, k + side + 2};
        memcpy(mesh->triangle + 3 * (size_t)t, to, 3 * sizeof *to);
    }
}

/* points at a pitch of 0.1 mm where x is at most `max` */
static int given_half(double max) {
    int count = 0;
    for (int j = 0; j <= 100; j++)
        for (int i = 0; i <= 10 * max; i++) scan[count++] = vec3(0.1 * i, 0.1 * j, 0.2);
    return count;
}

TEST(vertices_without_points_of_their_own_take_their_neighbours_value) {
    enum { SIDE = 20, VERTICES = (SIDE + 1) * (SIDE + 1) };
    double sum[VERTICES] = {0}, weight[VERTICES] = {0}, value[VERTICES], area = 999;
    unsigned char present[VERTICES];
    given_square(SIDE);
    const int count = given_half(6);
    /* every third vertex was hit, all of them 0.2 mm above */
    for (int k = 0; k < VERTICES; k += 3)
        if (mesh->vertex[k].x < 6) sum[k] = 0.6, weight[k] = 3;
    for (int threads = 1; threads < 3; threads++) {
        for (int k = 0; k < VERTICES; k++) value[k] = 999, present[k] = 99;
        ck_assert_int_eq(wcut_mesh_map_eval(mesh, sum, weight, count, scan, 0.3, threads, value, present, &area),
                         WCUT_OK);
        for (int k = 0; k < VERTICES; k++) {
            const int there = mesh->vertex[k].x < 6.1;
            ck_assert(present[k] == there);
            ck_assert_double_eq_tol(value[k], there ? 0.2 : 0, 1e-12);
        }
        ck_assert_double_eq_tol(area, 100 - 62.2, 1.5); /* points reach sqrt(0.3^2 - 0.2^2) further */
    }
    wcut_mesh_destroy(mesh);
}

TEST(the_area_without_points_does_not_depend_on_the_triangles) {
    enum { SIDES = 5, VERTICES = 41 * 41 };
    static const int side[SIDES] = {1, 2, 5, 13, 40};
    static double sum[VERTICES], weight[VERTICES], value[VERTICES];
    static unsigned char present[VERTICES];
    double area[SIDES];
    const int count = given_half(6);
    for (int k = 0; k < SIDES; k++) {
        given_square(side[k]);
        area[k] = 999;
        ck_assert_int_eq(wcut_mesh_map_eval(mesh, sum, weight, count, scan, 0.3, 1, value, present, &area[k]), WCUT_OK);
        wcut_mesh_destroy(mesh);

        /* points reach sqrt(0.3^2 - 0.2^2) further than x = 6; places are 0.3 mm apart */
        ck_assert_double_eq_tol(area[k], 100 - 62.2, 0.5);
        ck_assert_double_eq_tol(area[k], area[0], 0.75); /* a quarter of a column of places */
    }
}

TEST(a_map_of_a_mesh_refuses_what_is_none) {
    double sum[4] = {0}, weight[4] = {0}, value[4], area = 999;
    unsigned char present[4];
    given_square(1);
    const int count = given_half(6);
    weight[0] = 1, sum[0] = 0.2;
    ck_assert_int_eq(wcut_mesh_map_eval(mesh, sum, weight, count, scan, 0.3, 1, value, present, &area), WCUT_OK);
    ck_assert(present[0] && present[2] && !present[1] && !present[3]);
    area = 999;
    wcut_vec3 nan = {0, NAN, 0};
    ck_assert_int_eq(wcut_mesh_map_eval(NULL, sum, weight, 1, scan, 1, 1, value, present, &area), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_map_eval(mesh, NULL, weight, 1, scan, 1, 1, value, present, &area), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_map_eval(mesh, sum, weight, 0, scan, 1, 1, value, present, &area), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_map_eval(mesh, sum, weight, 1, &nan, 1, 1, value, present, &area), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_map_eval(mesh, sum, weight, 1, scan, 0, 1, value, present, &area), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_map_eval(mesh, sum, weight, 1, scan, 1, 0, value, present, &area), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_map_eval(mesh, sum, weight, 1, scan, 1, 1, value, NULL, &area), WCUT_BAD_ARGUMENT);
    EACH_FAILED_ALLOCATION(wcut_mesh_map_eval(mesh, sum, weight, count, scan, 0.3, 1, value, present, &area),
                           area == 999);
    wcut_mesh_destroy(mesh);
}
