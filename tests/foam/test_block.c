/* Engagement of a piece of wire in the block against clipping by hand, a fine sum, and its own differences.
   labels: unit plain */

#include "base/numbers.h"
#include "base/random.h"
#include "base/vec3.h"
#include "foam/block.h"
#include "test.h"

static const wcut_block block = {.size = {400, 600, 300}, .depth = 0.15};

static double share_of(const wcut_block *b, wcut_vec3 p, wcut_vec3 q) {
    wcut_vec3 dp, dq;
    return wcut_block_engagement(b, p, q, &dp, &dq);
}

static wcut_vec3 random_point(wcut_random *random, double margin) {
    return vec3(-margin + (block.size.x + 2 * margin) * wcut_random_uniform(random),
                -margin + (block.size.y + 2 * margin) * wcut_random_uniform(random),
                -margin + (block.size.z + 2 * margin) * wcut_random_uniform(random));
}

TEST(a_wire_across_the_block_is_clipped_exactly_at_its_sides) {
    ck_assert_double_eq_tol(share_of(&block, vec3(-100, 50, 150), vec3(500, 50, 150)), 400.0 / 600, 1e-15);
    ck_assert_double_eq_tol(share_of(&block, vec3(-30, 50, 150), vec3(10, 80, 170)), 0.25, 1e-15);
    ck_assert_double_eq_tol(share_of(&block, vec3(390, 80, 170), vec3(430, 50, 150)), 0.25, 1e-15);
    ck_assert_double_eq(share_of(&block, vec3(10, 50, 150), vec3(20, 60, 140)), 1);
    ck_assert_double_eq(share_of(&block, vec3(0, 50, 150), vec3(400, 60, 140)), 1);
    ck_assert_double_eq(share_of(&block, vec3(-20, 50, 150), vec3(0, 60, 140)), 0);
    ck_assert_double_eq(share_of(&block, vec3(10, -50, 150), vec3(20, -60, 140)), 0);
    ck_assert_double_eq(share_of(&block, vec3(10, 50, 350), vec3(20, 60, 320)), 0);
}

TEST(a_wire_through_a_front_or_top_face_is_cut_at_the_face_in_the_mean) {
    /* the weight rises from 0 to 1 over the depth about the face: its integral is that of a hard face */
    ck_assert_double_eq_tol(share_of(&block, vec3(100, -30, 150), vec3(120, 10, 150)), 0.25, 1e-14);
    ck_assert_double_eq_tol(share_of(&block, vec3(100, 590, 150), vec3(120, 630, 150)), 0.25, 1e-14);
    ck_assert_double_eq_tol(share_of(&block, vec3(100, 50, -5), vec3(120, 50, 15)), 0.75, 1e-14);
    ck_assert_double_eq_tol(share_of(&block, vec3(100, -30, 290), vec3(120, 10, 310)), 0, 1e-14);
    ck_assert_double_eq_tol(share_of(&block, vec3(100, -10, 280), vec3(120, 30, 320)), 0.25, 1e-2);
}

TEST(a_wire_flat_in_a_face_is_half_engaged_and_enters_over_its_depth) {
    for (double y = -0.2; y <= 0.2; y += 0.01)
        ck_assert_double_eq_tol(share_of(&block, vec3(50, y, 150), vec3(90, y, 150)), clamp(y / 0.15 + 0.5, 0, 1),
                                1e-14);
    ck_assert_double_eq_tol(share_of(&block, vec3(50, 100, 300), vec3(90, 120, 300)), 0.5, 1e-14);
    ck_assert_double_eq_tol(share_of(&block, vec3(-40, 0, 150), vec3(40, 0, 150)), 0.25, 1e-14);
}

TEST(random_pieces_agree_with_a_fine_sum_of_point_weights) {
    wcut_random random = wcut_random_seed(5);
    const wcut_block soft = {.size = block.size, .depth = 40};
    for (int k = 0; k < 300; k++) {
        const wcut_vec3 p = random_point(&random, 60), q = random_point(&random, 60);
        enum { PARTS = 20000 };
        double sum = 0;
        for (int i = 0; i < PARTS; i++) {
            const wcut_vec3 m = vec3_mix(p, q, (i + 0.5) / PARTS);
            const double y = clamp(fmin(m.y, soft.size.y - m.y) / soft.depth + 0.5, 0, 1);
            const double z = clamp(fmin(m.z, soft.size.z - m.z) / soft.depth + 0.5, 0, 1);
            sum += m.x >= 0 && m.x <= soft.size.x ? y * z : 0;
        }
        ck_assert_double_eq_tol(share_of(&soft, p, q), sum / PARTS, 2e-4); /* two ends of a part each */
    }
}

/* largest difference of a gradient from central differences */
static double gradient_error(const wcut_block *b, wcut_vec3 p, wcut_vec3 q, double h) {
    wcut_vec3 dp, dq;
    wcut_block_engagement(b, p, q, &dp, &dq);
    const double given[6] = {dp.x, dp.y, dp.z, dq.x, dq.y, dq.z};
    double worst = 0;
    for (int k = 0; k < 6; k++) {
        wcut_vec3 end[2][2] = {{p, q}, {p, q}};
        for (int side = 0; side < 2; side++) {
            double *component = &(k < 3 ? &end[side][0] : &end[side][1])->x + k % 3;
            *component += side == 0 ? -h : h;
        }
        const double difference = (share_of(b, end[1][0], end[1][1]) - share_of(b, end[0][0], end[0][1])) / (2 * h);
        worst = fmax(worst, fabs(difference - given[k]));
    }
    return worst;
}

TEST(gradients_are_those_of_central_differences) {
    wcut_random random = wcut_random_seed(9);
    const wcut_block soft = {.size = block.size, .depth = 60};
    int engaged = 0;
    for (int k = 0; k < 3000; k++) {
        const wcut_vec3 p = random_point(&random, 50);
        const wcut_vec3 q = vec3_add(p, vec3_scale(0.15, vec3_sub(random_point(&random, 0), vec3(200, 300, 150))));
        engaged += share_of(&soft, p, q) > 0 && share_of(&soft, p, q) < 1;
        /* the gradient itself jumps where an end crosses the border of a ramp: there the difference is off by its step
         */
        ck_assert_double_lt(gradient_error(&soft, p, q, 1e-5), 2e-6);
    }
    ck_assert_int_gt(engaged, 500);
}

TEST(gradients_hold_for_a_wire_that_lies_in_a_face) {
    const struct {
        wcut_vec3 p, q;
    } piece[] = {{{50, 0, 150}, {90, 0, 150}},     {{50, 600, 150}, {90, 600, 150}},
                 {{50, 100, 300}, {90, 140, 300}}, {{-40, 0, 150}, {40, 0, 150}},
                 {{50, 0, 0.02}, {90, 0, 0.02}},   {{50, 0.03, 150}, {90, -0.04, 150}},
                 {{360, 0, 150}, {440, 0, 150}},   {{50, 0.05, 299.98}, {90, 0.01, 300.03}}};
    for (size_t k = 0; k < sizeof piece / sizeof *piece; k++)
        ck_assert_double_lt(gradient_error(&block, piece[k].p, piece[k].q, 1e-5), 1e-6);
}

TEST(engagement_does_not_jump_while_a_piece_crosses_the_faces) {
    wcut_random random = wcut_random_seed(2);
    for (int k = 0; k < 40; k++) {
        const wcut_vec3 p = random_point(&random, 30), way = vec3_sub(random_point(&random, 30), p);
        const wcut_vec3 across = vec3_scale(0.05, vec3_sub(random_point(&random, 0), vec3(200, 300, 150)));
        double before = -1;
        for (int i = 0; i <= 20000; i++) {
            const wcut_vec3 at = vec3_add_scaled(p, i / 20000.0, way);
            const double share = share_of(&block, at, vec3_add(at, across));
            ck_assert(share >= 0 && share <= 1);
            /* 0.04 mm a step, against the depth of 0.15 mm that a piece flat to a face enters over */
            if (before >= 0) ck_assert_double_lt(fabs(share - before), 0.3);
            before = share;
        }
    }
}

TEST(distance_from_the_block_is_to_face_edge_and_corner) {
    ck_assert_double_eq(wcut_block_distance(&block, vec3(100, 100, 100)), 0);
    ck_assert_double_eq(wcut_block_distance(&block, vec3(0, 0, 0)), 0);
    ck_assert_double_eq(wcut_block_distance(&block, vec3(-7, 100, 100)), 7);
    ck_assert_double_eq(wcut_block_distance(&block, vec3(403, -4, 100)), 5);
    ck_assert_double_eq(wcut_block_distance(&block, vec3(402, 603, 306)), 7);
}
