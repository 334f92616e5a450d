/* A facade laid out: places, turns, shared edges, fields in closed form, and what is refused. */
#include "facade/given.h"
#include "facade/lattice.h"
#include "facade/layout.h"

static wcut_job *job;
static void begin(void) { job = flat_job(300, 300, 160); }
static void end(void) { wcut_job_destroy(job); }
FIXTURE(begin, end);

static wcut_facade *lay_out(const given_plan *g) {
    wcut_facade *f = NULL;
    wcut_error error = {0};
    const wcut_status status = wcut_facade_create(&g->plan, &f, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    return f;
}

static void refuse(const given_plan *g, wcut_status wanted, const char *words) {
    wcut_facade *f = (wcut_facade *)(void *)&job;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_facade_create(&g->plan, &f, &error), wanted);
    ck_assert_msg(strstr(error.text, words) != NULL, "\"%s\" is not in: %s", words, error.text);
    ck_assert(f == (wcut_facade *)(void *)&job);
}

/* ---- fields ---- */

static double field_value(wcut_facade_field f, double u, double v) {
    const double size[2] = {600, 400};
    double value = 999;
    ck_assert_int_eq(wcut_facade_field_eval(1, &f, size, u, v, &value), WCUT_OK);
    return value;
}

TEST(fields_have_their_closed_forms) {
    double place[4] = {100, 50, 300, 50};
    const wcut_facade_field linear = {.kind = WCUT_FACADE_FIELD_LINEAR, .value = 3, .slope = {0.5, -0.25}};
    const wcut_facade_field sine = {
        .kind = WCUT_FACADE_FIELD_SINE, .value = 1, .amplitude = 2, .period = 120, .direction = 0, .phase = 0.3};
    const wcut_facade_field pull = {
        .kind = WCUT_FACADE_FIELD_ATTRACTOR, .value = 1, .amplitude = 4, .radius = 50, .points = 2, .place = place};
    ck_assert(field_value((wcut_facade_field){.value = 7}, 11, 13) == 7);
    ck_assert(fabs(field_value(linear, 40, 8) - 21) < 1e-12);
    ck_assert(fabs(field_value(sine, 30, 99) - (1 + 2 * sin(2 * 3.14159265358979323846 / 4 + 0.3))) < 1e-12);
    ck_assert(fabs(field_value(pull, 200, 80) - (1 + 4 * exp(-0.36))) < 1e-12);
    ck_assert(fabs(field_value(pull, 70, 90) - (1 + 4 * exp(-1))) < 1e-12);

    /* fields add up */
    const wcut_facade_field both[2] = {linear, sine};
    const double size[2] = {600, 400};
    double value;
    ck_assert_int_eq(wcut_facade_field_eval(2, both, size, 40, 8, &value), WCUT_OK);
    ck_assert(value == field_value(linear, 40, 8) + field_value(sine, 40, 8));
}

TEST(a_grid_of_a_plane_is_that_plane_and_passes_its_values) {
    double plane[12], rough[12] = {0, 3, -1, 5, 2, 2, 8, 1, 0, 4, 4, -3};
    for (int k = 0; k < 12; k++) {
        const int row = k / 4, column = k % 4;
        plane[k] = 2 + 5 * column - 3 * row;
    }
    wcut_facade_field f = {.kind = WCUT_FACADE_FIELD_GRID, .rows = 3, .columns = 4, .grid = plane};
    for (int k = 0; k < 50; k++) {
        const double u = 12.0 * k, v = 8.0 * k;
        ck_assert(fabs(field_value(f, u, v) - (2 + 15 * u / 600 - 6 * v / 400)) < 1e-9);
    }
    f.grid = rough;
    for (int k = 0; k < 12; k++) {
        const int row = k / 4, column = k % 4;
        ck_assert(fabs(field_value(f, 200.0 * column, 200.0 * row) - rough[k]) < 1e-12);
    }
}

/* ---- places ---- */

TEST(every_turn_is_a_rotation_that_keeps_the_block_in_its_cell) {
    const wcut_vec3 block = {300, 200, 90};
    const wcut_cell cell = {{10, 20, 30}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int k = 0; k < 8; k++) {
        const int turn = k % 4;
        const bool mirrored = k >= 4;
        const wcut_cell c = wcut_cell_turn(&cell, block, turn, mirrored);
        const double det = c.x.x * (c.y.y * c.z.z - c.y.z * c.z.y) - c.x.y * (c.y.x * c.z.z - c.y.z * c.z.x) +
                           c.x.z * (c.y.x * c.z.y - c.y.y * c.z.x);
        ck_assert(det == 1);
        ck_assert((c.z.z < 0) == mirrored);

        /* its corners are those of the cell, where wcut_cell_share says */
        const double wide = turn % 2 ? 200 : 300, deep = turn % 2 ? 300 : 200;
        for (int corner = 0; corner < 4; corner++) {
            const int right = corner % 2, up = corner / 2;
            const double i = right, j = up;
            double share[2];
            wcut_cell_share(turn, mirrored, i, j, share);
            const double x = c.origin.x + i * 300 * c.x.x + j * 200 * c.y.x,
                         y = c.origin.y + i * 300 * c.x.y + j * 200 * c.y.y;
            ck_assert(fabs(x - 10 - share[0] * wide) < 1e-12 && fabs(y - 20 - share[1] * deep) < 1e-12);
        }
        const double bottom = c.origin.z + (mirrored ? c.z.z * 90 : 0);
        ck_assert(bottom == 30);
    }
}

TEST(neighbours_have_one_edge_bit_for_bit_in_every_mix_of_turns) {
    given_plan g;
    give_plan(&g, job, 4, 4);
    for (int k = 0; k < 16; k++) g.placement[k].turn = (k * 7 / 3) % 4, g.placement[k].mirrored = k % 3 == 1;
    wcut_facade *f = lay_out(&g);
    ck_assert_int_eq(f->joints, 24);
    for (int j = 0; j < f->joints; j++) {
        const wcut_facade_joint *joint = &f->joint[j];
        const wcut_facade_element *a = &f->element[joint->element[0]], *b = &f->element[joint->element[1]];
        for (int k = 0; k < N; k++) {
            const double p = a->border[joint->border[0]][k],
                         q = b->border[joint->border[1]][joint->reversed ? END - k : k];
            ck_assert((a->mirrored ? 160 - p : p) == (b->mirrored ? 160 - q : q));
        }
        ck_assert(joint->opening_max == 0);
    }
    wcut_facade_destroy(f);
}

TEST(edges_are_the_field_along_the_feed_and_straight_across) {
    given_plan g;
    give_plan(&g, job, 2, 3);
    wcut_facade *f = lay_out(&g);
    const double size[2] = {900, 600};
    const wcut_facade_element *e = &f->element[4]; /* row 1, column 1 */
    for (int k = 0; k < N; k++) {
        double value;
        ck_assert_int_eq(wcut_facade_field_eval(1, g.height, size, 300, 300 + 300.0 * k / END, &value), WCUT_OK);
        ck_assert(fabs(e->border[0][k] - value) < 1e-6);
        ck_assert(fabs(e->border[2][k] - (e->border[0][0] + (e->border[1][0] - e->border[0][0]) * k / END)) < 1e-6);
    }

    /* the job's edges pass the shared heights, and go on beyond the block */
    wcut_vec3 from;
    ck_assert_int_eq(wcut_curve_eval(e->job->edge_a, 0, 0, &from), WCUT_OK);
    ck_assert(from.x == 0 && from.y < -10 && -from.y <= e->job->overrun);
    wcut_facade_destroy(f);
}

TEST(blocks_on_a_cylinder_meet_at_their_bases_and_open_outside) {
    given_plan g;
    give_plan(&g, job, 2, 6);
    g.plan.lattice = WCUT_FACADE_LATTICE_CYLINDER;
    for (int inside = 0; inside < 2; inside++) {
        g.plan.radius = inside ? -1500 : 1500;
        g.plan.joint = 4;
        wcut_facade *f = lay_out(&g);
        for (int k = 0; k < f->elements; k++) {
            const wcut_facade_element *e = &f->element[k];
            const wcut_vec3 p = wcut_element_point(e, (wcut_vec3){300, 0, inside ? 160 : 0});
            ck_assert(fabs(hypot(p.x, p.z) - 1500) < 1e-9);
            const double out = e->z.x * p.x + e->z.z * p.z;
            ck_assert((out > 0) == !inside);
        }

        /* along the axis the gap is the joint, around it more */
        for (int j = 0; j < f->joints; j++) {
            const bool around = f->joint[j].border[0] < 2;
            ck_assert(fabs(f->joint[j].opening_min - 4) < (around ? 40 : 1e-9) && f->joint[j].opening_min > 4 - 1e-9);
        }
        wcut_facade_destroy(f);
    }
}

TEST(tangents_make_kinks_between_lines_smaller_and_move_no_further_than_asked) {
    given_plan g;
    give_plan(&g, job, 2, 6);
    g.plan.match_move = 10;
    double kink[2];
    for (int tangent = 0; tangent < 2; tangent++) {
        g.plan.match = tangent ? WCUT_FACADE_MATCH_TANGENT : WCUT_FACADE_MATCH_EDGE;
        wcut_facade *f = lay_out(&g);
        kink[tangent] = 0;
        for (int c = 0; c < 5; c++)
            for (int k = 0; k < N; k++) {
                const wcut_facade_element *a = &f->element[c], *b = &f->element[c + 1];
                kink[tangent] = fmax(kink[tangent], fabs(a->border[0][k] - 2 * a->border[1][k] + b->border[1][k]));
            }
        ck_assert(tangent ? f->moved > 9.9 && f->moved <= 10 : f->moved == 0);
        wcut_facade_destroy(f);
    }
    ck_assert_msg(kink[1] < 0.65 * kink[0], "second differences %g and %g mm", kink[0], kink[1]);
}

TEST(free_placements_find_their_neighbours_wherever_they_stand) {
    given_plan g;
    give_plan(&g, job, 1, 3);
    g.plan.lattice = WCUT_FACADE_LATTICE_FREE;
    g.plan.heights = 0;
    const double c = cos(0.4), s = sin(0.4);
    for (int k = 0; k < 3; k++) {
        g.placement[k].x = (wcut_vec3){c, s, 0}, g.placement[k].y = (wcut_vec3){-s, c, 0};
        g.placement[k].origin = (wcut_vec3){300 * k * c, 300 * k * s, 5};
        g.placement[k].turn = k == 1 ? 2 : 0;
    }
    wcut_facade *f = lay_out(&g);
    ck_assert_int_eq(f->joints, 2);
    ck_assert(f->joint[0].border[0] == 1 && f->joint[0].border[1] == 1 && f->joint[0].reversed);
    ck_assert(f->joint[0].opening_max < 1e-9);
    wcut_facade_destroy(f);
}

/* ---- what is refused ---- */

TEST(two_elements_in_one_cell_or_place_are_named) {
    given_plan g;
    give_plan(&g, job, 2, 2);
    g.placement[3] = (wcut_facade_placement){.row = 0, .column = 1};
    refuse(&g, WCUT_BAD_ARGUMENT, "elements 1 and 3 claim the cell in row 0, column 1");
    give_plan(&g, job, 1, 2);
    g.plan.lattice = WCUT_FACADE_LATTICE_FREE;
    g.plan.heights = 0;
    for (int k = 0; k < 2; k++) g.placement[k].x.x = g.placement[k].y.y = 1, g.placement[k].origin.x = 20 * k;
    refuse(&g, WCUT_BAD_ARGUMENT, "claim one place");
}

TEST(an_edge_of_three_is_refused_with_all_three) {
    given_plan g;
    give_plan(&g, job, 1, 3);
    g.plan.lattice = WCUT_FACADE_LATTICE_FREE;
    g.plan.heights = 0;
    const double angle[3] = {0, 2, 4};
    for (int k = 0; k < 3; k++) {
        /* three blocks around one upright line at half their height */
        const wcut_vec3 x = {cos(angle[k]), 0, sin(angle[k])}, z = {-sin(angle[k]), 0, cos(angle[k])};
        g.placement[k].x = x, g.placement[k].y = (wcut_vec3){0, 1, 0};
        g.placement[k].origin = (wcut_vec3){-80 * z.x, 0, -80 * z.z};
    }
    refuse(&g, WCUT_BAD_ARGUMENT, "element 2");
}

TEST(a_field_that_leaves_the_block_is_placed) {
    given_plan g;
    give_plan(&g, job, 2, 2);
    g.height[0].amplitude = 100;
    refuse(&g, WCUT_DEGENERATE, "the field leaves the block: an edge of height");
    give_plan(&g, job, 2, 2);
    g.extra[0].value = -1;
    refuse(&g, WCUT_DEGENERATE, "extra length");
}

TEST(a_surface_that_folds_or_is_too_small_is_placed) {
    given_plan g;
    give_plan(&g, job, 2, 2);
    g.plan.lattice = WCUT_FACADE_LATTICE_SURFACE;
    const double knots[6] = {0, 0, 1, 1, 0, 0};
    const wcut_vec3 folded[4] = {{0, 0, 0}, {700, 0, 0}, {700, 700, 0}, {0, 700, 0}},
                    small[4] = {{0, 0, 0}, {500, 0, 0}, {0, 700, 0}, {500, 700, 0}};
    const wcut_vec3 fine[4] = {{0, 0, 0}, {620, 0, 40}, {0, 620, 0}, {620, 620, -40}};
    const wcut_vec3 *control[3] = {folded, small, fine};
    for (int k = 0; k < 3; k++) {
        wcut_surface *surface = NULL;
        ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, knots, knots, control[k], NULL, &surface), WCUT_OK);
        g.plan.surface = surface;
        if (k == 0) refuse(&g, WCUT_DEGENERATE, "folds");
        if (k == 1) refuse(&g, WCUT_DEGENERATE, "neighbours would claim one place");
        if (k == 2) wcut_facade_destroy(lay_out(&g));
        wcut_surface_destroy(surface);
    }
}

TEST(edges_of_neighbours_that_differ_are_refused_with_how_much) {
    given_plan g;
    give_plan(&g, job, 1, 2);
    wcut_job *other = flat_job(300, 300, 160);
    wcut_curve_destroy(other->edge_a);
    const wcut_vec3 up[2] = {{0, 0, 83}, {0, 300, 83}};
    ck_assert_int_eq(wcut_curve_interpolate(2, up, &other->edge_a), WCUT_OK);
    g.job[1] = other;
    g.plan.jobs = 2, g.plan.heights = 0;
    g.placement[1].job = 1;
    refuse(&g, WCUT_BAD_ARGUMENT, "their edges are 3 mm apart");
    g.plan.match = WCUT_FACADE_MATCH_NONE;
    wcut_facade *f = lay_out(&g);
    ck_assert(f->joints == 1 && !f->element[0].border[0]);
    wcut_facade_destroy(f);
    wcut_job_destroy(other);
}

TEST(other_plans_out_of_range_are_refused) {
    given_plan g;
    give_plan(&g, job, 2, 2);
    g.placement[2].column = 5;
    refuse(&g, WCUT_BAD_ARGUMENT, "column 5");
    give_plan(&g, job, 2, 2);
    g.plan.joint = NAN;
    refuse(&g, WCUT_BAD_ARGUMENT, "joint");
    give_plan(&g, job, 2, 30);
    g.plan.placements = 4;
    g.plan.lattice = WCUT_FACADE_LATTICE_CYLINDER, g.plan.radius = 1000;
    refuse(&g, WCUT_BAD_ARGUMENT, "360 deg");
    wcut_job *deep = flat_job(300, 400, 160);
    give_plan(&g, deep, 2, 2);
    g.placement[1].turn = 1;
    refuse(&g, WCUT_BAD_ARGUMENT, "its block, turned, is");
    wcut_job_destroy(deep);
    give_plan(&g, job, 2, 2);
    g.placement[1].turn = 1, g.plan.match = WCUT_FACADE_MATCH_TANGENT;
    refuse(&g, WCUT_BAD_ARGUMENT, "one direction of feed");
}

TEST(a_layout_without_memory_leaves_nothing) {
    given_plan g;
    give_plan(&g, job, 1, 2);
    g.plan.match = WCUT_FACADE_MATCH_TANGENT;
    wcut_facade *f = NULL;
    EACH_FAILED_ALLOCATION(wcut_facade_create(&g.plan, &f, NULL), f == NULL);
    wcut_facade_destroy(f);
}
