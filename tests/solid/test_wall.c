/* labels: unit
   Walls, edges and drafts of halves whose cut has a closed form. */
#include "solid/cuts.h"
#include "test.h"

TEST(a_wall_is_measured_in_any_direction_and_an_edge_by_its_angle) {
    wcut_surface *s = cut_of(cut_tilted);
    wcut_mould_options o = wcut_mould_default();
    const wcut_key key = {0, 200, 450, 40, 30, -60};
    o.key = &key, o.key_count = 1;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    const double slope = hypot(0.1, 0.05), size = hypot(1, slope); /* from the plane to the rim of the pocket's end */
    ck_assert_double_le(fabs(m->lower.report.wall_min - (150 - 60 - 30 * slope) / size), 1e-6);
    ck_assert_double_le(fabs(m->upper.report.wall_min - (300 - 150 - 20 - 22.5)), 1e-9);
    ck_assert_double_le(vec3_distance(m->upper.report.wall_place, vec3(400, 0, 192.5)), 1e-6);
    for (int upper = 0; upper < 2; upper++) {
        const wcut_half_report *r = upper ? &m->upper.report : &m->lower.report;
        ck_assert_double_le(fabs(r->edge_min - acos(0.1 / size)), 1e-9);
        ck_assert_double_le(fabs(r->edge_place.x - (upper ? 0 : 400)), 1e-9);
    }
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

/* a flank that rises at y = flank_at, steeper than 45 deg within 5.48 mm of it */
static double flank_at;
static wcut_vec3 flank(double s, double t) {
    const double w = 2 * t - 1;
    return vec3(500 * s - 50, flank_at + 900 * w * w * w, 150 + 90 * w);
}

TEST(a_flank_along_a_side_is_a_wall_and_a_sharp_edge_is_one_of_no_thickness) {
    wcut_mould_options o = wcut_mould_default();
    flank_at = 850;
    wcut_surface *s = cut_of(flank);
    wcut_mould *m = cut_divide(s, cut_block, &o);
    const double steep = sqrt(90 / 2700.0), thin = 50 - 900 * steep * steep * steep;
    ck_assert_double_le(fabs(m->lower.report.wall_min - thin), 1);
    ck_assert_double_le(fabs(m->lower.report.wall_place.y + m->lower.report.wall_min - 900), 1e-9);
    ck_assert_double_le(fabs(m->upper.report.wall_min - (150 - 90 * cbrt(50 / 900.0))), 0.2);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
    flank_at = 899.5;
    s = cut_of(flank);
    o.wall_asked = 1;
    m = cut_divide(s, cut_block, &o);
    ck_assert_double_eq(m->lower.report.wall_min, 0);
    ck_assert(!m->lower.report.wall_held && m->upper.report.wall_held);
    ck_assert_double_lt(m->lower.report.edge_min, WCUT_PI / 4);
    ck_assert_double_gt(m->upper.report.edge_min, WCUT_PI / 4);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

TEST(drafts_are_of_the_pull_that_is_asked_for) {
    wcut_surface *s = cut_of(cut_tilted);
    wcut_mould_options o = wcut_mould_default();
    o.pull = vec3(-0.2, 0.1, 2); /* the plane's normal, of any length */
    wcut_mould *m = cut_divide(s, cut_block, &o);
    ck_assert_double_le(fabs(m->lower.report.draft_min - WCUT_PI / 2), 1e-6);
    ck_assert_double_le(fabs(m->upper.report.draft_min - WCUT_PI / 2), 1e-6);
    ck_assert_double_le(fabs(vec3_length(m->pull) - 1), 1e-15);
    wcut_mould_destroy(m);
    o.pull = vec3(1, 0, 0); /* along the block: the lower half's face leans against it */
    m = cut_divide(s, cut_block, &o);
    ck_assert_double_lt(m->lower.report.draft_min, 0);
    ck_assert_double_le(fabs(m->lower.report.undercut_area - m->lower.report.cut_area), 1e-6);
    ck_assert_double_le(fabs(m->lower.report.draft_min + asin(0.1 / sqrt(1.0125))), 1e-6);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}
