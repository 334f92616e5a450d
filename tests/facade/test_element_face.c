/* Faces of elements on shared edges, what is left at joints, and panels: closed forms, and to the last bit. */
#include "facade/given.h"
#include "facade/layout.h"

static const wcut_vec3 block = {300, 240, 160};

static double tilted(double x, double y) { return 60 + 0.1 * x + 0.05 * y; }
static double saddle(double x, double y) { return 80 + (x - 150) * (y - 120) / 600; }
static double wavy(double x, double y) { return 80 + 20 * sin(x / 60) * cos(y / 70); }
static double trough(double x, double y) { return 300 - sqrt(250.0 * 250 - (x - 150) * (x - 150)) + 0 * y; }
static double sharp(double x, double y) { return 60 + 30 * exp(-(x - 150) * (x - 150) / 800) + 0 * y; }

static wcut_element_face *face_of(given_height height, const double *const border[4]) {
    static const double *const none[4];
    wcut_surface *wire = graph(block, height);
    wcut_element_face *face = NULL;
    wcut_error error = {0};
    const wcut_status status =
        wcut_element_face_create(wire, block, border ? border : none, 0, 0, NULL, NULL, &face, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    wcut_surface_destroy(wire);
    return face;
}

TEST(a_face_without_shared_edges_is_the_cut) {
    const given_height height[3] = {tilted, saddle, wavy};
    const double within[3] = {1e-9, 1e-3, 0.06};
    for (int k = 0; k < 3; k++) {
        wcut_element_face *face = face_of(height[k], NULL);
        for (int i = 0; i < POINTS; i++) {
            const wcut_vec3 p = face->point[i];
            const int row = i / N, column = i % N;
            ck_assert(p.x == block.x * column / END && p.y == block.y * row / END);
            ck_assert(fabs(p.z - height[k](p.x, p.y)) < within[k] && face->moved[i] == 0);
        }
        ck_assert(face->fit_error < within[k]);
        if (k == 0) ck_assert(fabs(face->volume - (60 + 15 + 6) * block.x * block.y) < 1e-3);
        if (k == 0) ck_assert(fabs(face->area - block.x * block.y * sqrt(1 + 0.01 + 0.0025)) < 1e-3);
        wcut_element_face_destroy(face);
    }
}

TEST(borders_are_the_shared_edges_exactly_and_the_rest_follows) {
    double edge[4][N];
    for (int b = 0; b < 4; b++)
        for (int k = 0; k < N; k++) {
            const wcut_vec3 p = wcut_border_point(block, b, k, 0);
            edge[b][k] = tilted(p.x, p.y) + 2 + 0.01 * p.x - 0.02 * p.y;
        }
    const double *const border[4] = {edge[0], edge[1], edge[2], edge[3]};
    wcut_element_face *face = face_of(tilted, border);

    /* borders to the last bit, and a bilinear move inside is bilinear */
    for (int i = 0; i < POINTS; i++) {
        const wcut_vec3 p = face->point[i];
        ck_assert(fabs(face->moved[i] - (2 + 0.01 * p.x - 0.02 * p.y)) < 1e-9);
    }
    for (int k = 0; k < N; k++) {
        ck_assert(face->point[k * N].z == edge[0][k] && face->point[k * N + END].z == edge[1][k]);
        ck_assert(fabs(face->point[k].z - edge[2][k]) < 1e-12 &&
                  fabs(face->cut[0][k] - tilted(0, block.y * k / END)) < 1e-9);
    }
    ck_assert(fabs(face->moved_max - 5) < 1e-9);

    /* the same face again from its heights */
    double height[POINTS];
    for (int i = 0; i < POINTS; i++) height[i] = face->point[i].z;
    wcut_element_face *again = NULL;
    ck_assert_int_eq(wcut_element_face_interpolate(block, height, &again), WCUT_OK);
    ck_assert(memcmp(again->surface->control, face->surface->control, POINTS * sizeof(wcut_vec3)) == 0);
    wcut_element_face_destroy(again);
    wcut_element_face_destroy(face);
}

/* 2 x 2 elements of a wave, some of them turned and turned over, with faces of a surface that is not theirs */
TEST(joints_of_exact_surfaces_agree_to_1e_9_mm_and_points_bit_for_bit) {
    wcut_job *job = flat_job(300, 300, 160);
    given_plan g;
    give_plan(&g, job, 3, 3);
    for (int k = 0; k < 9; k++) g.placement[k].turn = (5 * k) % 4, g.placement[k].mirrored = k % 4 == 2;
    wcut_facade *f = NULL;
    ck_assert_int_eq(wcut_facade_create(&g.plan, &f, NULL), WCUT_OK);
    wcut_surface *wire = graph(job->block_size, wavy);
    wcut_element_face *face[9];
    for (int k = 0; k < 9; k++) {
        wcut_error error = {0};
        const double *const border[4] = {f->element[k].border[0], f->element[k].border[1], f->element[k].border[2],
                                         f->element[k].border[3]};
        const wcut_status status =
            wcut_element_face_create(wire, job->block_size, border, 0, 0, NULL, NULL, &face[k], &error);
        ck_assert_msg(status == WCUT_OK, "%s", error.text);
    }

    /* between the samples, too: both border curves in space */
    for (int j = 0; j < f->joints; j++) {
        wcut_joint_report report;
        const wcut_facade_joint *joint = &f->joint[j];
        ck_assert_int_eq(wcut_joint_eval(f, j, face[joint->element[0]], face[joint->element[1]], &report), WCUT_OK);
        ck_assert(report.gap_max == 0 && report.step_max > 0.1 && report.angle_min <= report.angle_median);
        for (int k = 0; k <= 200; k++) {
            wcut_vec3 at[2];
            for (int s = 0; s < 2; s++) {
                const double t = s && joint->reversed ? 1 - k / 200.0 : k / 200.0;
                const int b = joint->border[s];
                wcut_vec3 p;
                ck_assert_int_eq(
                    wcut_surface_eval(face[joint->element[s]]->surface, b < 2 ? b : t, b < 2 ? t : b - 2, 0, &p),
                    WCUT_OK);
                at[s] = wcut_element_point(&f->element[joint->element[s]], p);
            }
            ck_assert(fabs(at[0].x - at[1].x) < 1e-9 && fabs(at[0].y - at[1].y) < 1e-9 &&
                      fabs(at[0].z - at[1].z) < 1e-9);
        }
    }

    /* the points that a mesh is made of */
    static wcut_vec3 point[9 * POINTS];
    ck_assert_int_eq(wcut_facade_points(f, (const wcut_element_face *const *)face, point), WCUT_OK);
    for (int j = 0; j < f->joints; j++)
        for (int k = 0; k < N; k++) {
            const wcut_facade_joint *joint = &f->joint[j];
            wcut_vec3 at[2];
            for (int s = 0; s < 2; s++) {
                const int b = joint->border[s], i = s && joint->reversed ? END - k : k;
                at[s] =
                    point[joint->element[s] * POINTS + (b < 2 ? i * N + (b ? END : 0) : (b == 3 ? END * N : 0) + i)];
            }
            ck_assert(memcmp(&at[0], &at[1], sizeof at[0]) == 0);
        }
    for (int k = 0; k < 9; k++) wcut_element_face_destroy(face[k]);
    wcut_surface_destroy(wire);
    wcut_facade_destroy(f);
    wcut_job_destroy(job);
}

TEST(a_kink_is_the_angle_between_the_faces) {
    wcut_job *job = flat_job(300, 240, 160);
    given_plan g;
    give_plan(&g, job, 1, 2);
    wcut_facade *f = NULL;
    ck_assert_int_eq(wcut_facade_create(&g.plan, &f, NULL), WCUT_OK);
    double up[POINTS], down[POINTS];
    for (int k = 0; k < POINTS; k++) up[k] = 60 + 30.0 * (k % N) / END, down[k] = 90 - 60.0 * (k % N) / END;
    wcut_element_face *a = NULL, *b = NULL;
    wcut_joint_report r;
    ck_assert_int_eq(wcut_element_face_interpolate(block, up, &a), WCUT_OK);
    ck_assert_int_eq(wcut_element_face_interpolate(block, down, &b), WCUT_OK);
    ck_assert_int_eq(wcut_joint_eval(f, 0, a, b, &r), WCUT_OK);
    const double wanted = atan(0.1) + atan(0.2);
    ck_assert(fabs(r.angle_min - wanted) < 1e-9 && fabs(r.angle_max - wanted) < 1e-9 && r.gap_max == 0);
    wcut_element_face_destroy(a);
    wcut_element_face_destroy(b);
    wcut_facade_destroy(f);
    wcut_job_destroy(job);
}

/* ---- refused ---- */

static double too_high(double x, double y) { return 150 + 0.1 * x + 0 * y; }

TEST(a_cut_that_leaves_the_block_has_no_face) {
    static const double *const none[4];
    wcut_surface *wire = graph(block, too_high);
    wcut_element_face *face = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_element_face_create(wire, block, none, 0, 0, NULL, NULL, &face, &error), WCUT_DEGENERATE);
    ck_assert(strstr(error.text, "leaves the block through its top") && !face);
    wcut_surface_destroy(wire);
}

TEST(borders_that_do_not_meet_are_refused) {
    double low[N] = {0}, high[N];
    for (int k = 0; k < N; k++) high[k] = 10;
    const double *const border[4] = {low, NULL, high, NULL};
    wcut_surface *wire = graph(block, tilted);
    wcut_element_face *face = NULL;
    ck_assert_int_eq(wcut_element_face_create(wire, block, border, 0, 0, NULL, NULL, &face, NULL), WCUT_BAD_ARGUMENT);
    wcut_surface_destroy(wire);
}

TEST(a_face_without_memory_leaves_nothing) {
    static const double *const none[4];
    wcut_surface *wire = graph(block, tilted);
    wcut_element_face *face = NULL;
    EACH_FAILED_ALLOCATION_BY(7, wcut_element_face_create(wire, block, none, 0, 0, NULL, NULL, &face, NULL),
                              face == NULL);
    wcut_element_face_destroy(face);
    wcut_surface_destroy(wire);
}

/* ---- panels ---- */

TEST(a_panel_on_a_plane_is_a_sheared_plate) {
    wcut_element_face *face = face_of(tilted, NULL);
    for (int below = 0; below < 2; below++) {
        wcut_panel *panel = NULL;
        wcut_error error = {0};
        const wcut_status status = wcut_panel_create(face, below ? -12 : 12, 0.1, &panel, &error);
        ck_assert_msg(status == WCUT_OK, "%s", error.text);

        /* upright sides: the base times the upright thickness */
        const double upright = 12 * sqrt(1 + 0.01 + 0.0025);
        ck_assert_msg(fabs(panel->volume - block.x * block.y * upright) < 1, "%.9g mm3", panel->volume);
        ck_assert(panel->solid->face_count == 6);
        for (int k = 0; k < panel->mesh->vertex_count; k++) {
            const wcut_vec3 p = panel->mesh->vertex[k];
            const double off = p.z - tilted(p.x, p.y);
            ck_assert(fabs(off) < 1e-6 || fabs(off - (below ? -upright : upright)) < 1e-6);
        }
        wcut_panel_destroy(panel);
    }
    wcut_element_face_destroy(face);
}

/* the area between a chord of 300 mm and a circle of radius r that it is concentric with, and twice the triangles */
static double under_arc(double r) { return 150 * sqrt(r * r - 150 * 150) + r * r * asin(150 / r); }

TEST(a_panel_in_a_round_trough_is_between_two_circles) {
    wcut_element_face *face = face_of(trough, NULL);
    for (int below = 0; below < 2; below++) {
        wcut_panel *panel = NULL;
        wcut_error error = {0};
        const wcut_status status = wcut_panel_create(face, below ? -10 : 10, 0.01, &panel, &error);
        ck_assert_msg(status == WCUT_OK, "%s", error.text);
        const double wanted = block.y * fabs(under_arc(250) - under_arc(below ? 260 : 240));
        ck_assert_msg(fabs(panel->volume / wanted - 1) < 1e-3, "%.9g, expected %.9g mm3", panel->volume, wanted);
        wcut_panel_destroy(panel);
    }
    wcut_element_face_destroy(face);
}

TEST(a_panel_thicker_than_the_radius_is_refused_with_the_place) {
    wcut_element_face *face = face_of(sharp, NULL);
    wcut_panel *panel = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_panel_create(face, -60, 0.1, &panel, &error), WCUT_DEGENERATE);
    ck_assert_msg(strstr(error.text, "panel of 60 mm: its offset folds: at (1"), "%s", error.text);
    ck_assert(!panel);
    wcut_element_face_destroy(face);
}

TEST(a_panel_without_memory_leaves_nothing) {
    wcut_element_face *face = face_of(tilted, NULL);
    wcut_panel *panel = NULL;
    EACH_FAILED_ALLOCATION_BY(11, wcut_panel_create(face, 12, 1, &panel, NULL), panel == NULL);
    wcut_panel_destroy(panel);
    wcut_element_face_destroy(face);
}
