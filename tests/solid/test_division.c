/* labels: unit oracle
   What is cut by booleans, against closed forms and against the halves by index; what is refused, and where it says. */
#include "solid/cuts.h"

#include "base/alloc.h"
#include "solid/boolean.h"
#include "solid/check.h"
#include "test.h"

/* ---- stocks ---- */

/* the box between two corners, oriented outwards */
static wcut_mesh *box_of(wcut_vec3 a, wcut_vec3 b) {
    static const int corner[36] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                   1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    wcut_mesh *m = NULL;
    ck_assert_int_eq(wcut_mesh_create(8, 12, 0, &m), WCUT_OK);
    for (int k = 0; k < 8; k++)
        m->vertex[k] = vec3(k % 4 == 1 || k % 4 == 2 ? b.x : a.x, k % 4 >= 2 ? b.y : a.y, k >= 4 ? b.z : a.z);
    memcpy(m->triangle, corner, sizeof corner);
    return m;
}

/* a ball of `rows` rings of as many corners each, its poles in z */
static wcut_mesh *ball_of(wcut_vec3 centre, double radius, int rows) {
    wcut_mesh *m = NULL;
    const int ring = 2 * rows;
    ck_assert_int_eq(wcut_mesh_create(2 + (rows - 1) * ring, 2 * ring * (rows - 1), 0, &m), WCUT_OK);
    m->vertex[0] = vec3(centre.x, centre.y, centre.z - radius);
    m->vertex[1] = vec3(centre.x, centre.y, centre.z + radius);
    int *to = m->triangle;
    for (int j = 1; j < rows; j++)
        for (int i = 0; i < ring; i++) {
            const double up = WCUT_PI * j / rows, around = 2 * WCUT_PI * i / ring;
            const int at = 2 + (j - 1) * ring, here = at + i, next = at + (i + 1) % ring;
            m->vertex[here] = vec3(centre.x + radius * sin(up) * cos(around), centre.y + radius * sin(up) * sin(around),
                                   centre.z - radius * cos(up));
            if (j == 1) *to++ = 0, *to++ = next, *to++ = here;
            if (j == rows - 1) *to++ = 1, *to++ = here, *to++ = next;
            if (j == rows - 1) continue;
            *to++ = here, *to++ = next, *to++ = next + ring;
            *to++ = here, *to++ = next + ring, *to++ = here + ring;
        }
    return m;
}

TEST(a_cut_through_top_and_bottom_makes_two_wedges) {
    wcut_surface *s = cut_of(cut_leaving);
    wcut_mould_options o = wcut_mould_default();
    wcut_mould *m = cut_divide(s, cut_block, &o);
    ck_assert(m->by_boolean && !m->lower.brep && !m->upper.brep);
    ck_assert_double_le(fabs(m->lower.report.volume / 54e6 - 1), 1e-9);
    ck_assert_double_le(fabs(m->upper.report.volume / 54e6 - 1), 1e-9);
    ck_assert_double_le(fabs(m->lower.report.cut_area / (400 * 600 * sqrt(1.25)) - 1), 1e-9);
    ck_assert_double_le(fabs(m->lower.report.draft_min - atan(2)), 1e-6);
    ck_assert(isnan(m->lower.report.wall_min) && m->lower.report.wall_held);
    wcut_mould_destroy(m);
    o.kerf = 2, o.wall_asked = 1; /* a wall that is not known does not hold */
    m = cut_divide(s, cut_block, &o);
    ck_assert_double_le(fabs(m->kerf_volume / (2 * 400 * 600 * sqrt(1.25)) - 1), 1e-3);
    ck_assert(!m->lower.report.wall_held);
    wcut_mould_destroy(m);
    const wcut_key key[2] = {{0, 200, 700, 20, 12, -30}, {1, 200, 200, 20, 12, 15}}; /* where the halves are thick */
    o.key = key, o.key_count = 2;
    m = cut_divide(s, cut_block, &o);
    ck_assert(m->lower.report.key_volume < 0 && m->upper.report.key_volume > 0);
    ck_assert_double_eq(m->block_volume, 400.0 * 900 * 300);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

/* hills so high that their tops stand out of the block */
static wcut_vec3 high_hills(double s, double t) {
    const wcut_vec3 p = cut_hilly(s, t);
    return vec3(p.x, p.y, p.z + 120);
}

TEST(hills_that_stand_out_of_the_top_leave_the_upper_half_in_pieces_or_with_holes) {
    wcut_surface *s = cut_of(high_hills);
    wcut_mould_options o = wcut_mould_default();
    o.chord_tolerance = 0.02;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    double sum = 0;
    for (int j = 0; j < 1800; j++)
        for (int i = 0; i < 800; i++) sum += fmin(300, 120 + cut_height((i + 0.5) / 2, (j + 0.5) / 2)) / 4;
    printf("high hills: upper half in %d pieces, volume off by %.2e\n", m->upper.report.pieces,
           m->lower.report.volume / sum - 1);
    ck_assert(m->by_boolean);
    ck_assert_double_le(fabs(m->lower.report.volume / sum - 1), 1e-4);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

TEST(booleans_and_halves_by_index_agree) {
    wcut_surface *s[2] = {cut_of(cut_hilly), cut_of(cut_overhanging)};
    for (int k = 0; k < 4; k++) {
        wcut_mould_options o = wcut_mould_default();
        o.kerf = k % 2;
        wcut_mesh *stock = box_of(vec3(0, 0, 0), cut_block);
        wcut_mould *by_index = cut_divide(s[k / 2], cut_block, &o);
        o.stock = stock;
        wcut_mould *by_boolean = cut_divide(s[k / 2], cut_block, &o);
        ck_assert(!by_index->by_boolean && by_boolean->by_boolean);
        const wcut_half_report *a = &by_index->lower.report, *b = &by_boolean->lower.report;
        printf("by index %.9g, by booleans %.9g mm3, areas %.9g and %.9g, cut %.9g and %.9g mm2\n", a->volume,
               b->volume, a->area, b->area, a->cut_area, b->cut_area);
        /* both are within 0.1 mm of the same face, over 360,000 mm2, in triangles of their own */
        ck_assert_double_le(fabs(a->volume / b->volume - 1), 3e-5);
        ck_assert_double_le(fabs(a->area / b->area - 1), 1e-4);
        ck_assert_double_le(fabs(a->cut_area / b->cut_area - 1), 1e-3);
        ck_assert_double_le(fabs(by_boolean->upper.report.volume / by_index->upper.report.volume - 1), 3e-5);
        ck_assert(b->pieces == 1 && by_boolean->block_volume == by_index->block_volume);
        /* CGAL finds the halves by index to be free of self-intersections, as is claimed */
        int pairs = 999;
        wcut_vec3 at = {999, 999, 999};
        ck_assert_int_eq(wcut_self_intersections(by_index->upper.mesh, &pairs, &at, NULL), WCUT_OK);
        ck_assert(pairs == 0 && at.x == 999);
        wcut_mould_destroy(by_boolean);
        wcut_mould_destroy(by_index);
        wcut_mesh_destroy(stock);
    }
    wcut_surface_destroy(s[0]);
    wcut_surface_destroy(s[1]);
}

TEST(a_ball_in_the_block_is_cut_into_its_caps) {
    wcut_surface *s = cut_of(cut_level);
    wcut_mould_options o = wcut_mould_default();
    wcut_mesh *ball = ball_of(vec3(200, 300, 150), 100, 64);
    o.stock = ball;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    const double h = 90; /* the cap below z = 140: pi h^2 (3 r - h) / 3, and the polyhedron is a little smaller */
    ck_assert_double_le(fabs(m->lower.report.volume / (WCUT_PI * h * h * (300 - h) / 3) - 1), 3e-3);
    ck_assert_double_le(fabs(m->block_volume - cut_volume(ball)), 1e-3);
    ck_assert_double_le(fabs(m->lower.report.cut_area / (WCUT_PI * (100 * 100 - 10 * 10)) - 1), 3e-3);
    ck_assert_double_lt(fabs(m->upper.report.box_low.z - 140), 1e-9);
    wcut_mould_destroy(m);

    wcut_key key[WCUT_KEYS_AT_CORNERS];
    ck_assert_int_eq(wcut_keys_at_corners(cut_block, 10, -5, key), WCUT_OK);
    o.key = key, o.key_count = 1;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "none with a stock");
    o.key_count = 0;
    for (int k = 0; k < ball->vertex_count; k++) ball->vertex[k].z += 60;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "expected it inside the block");
    for (int k = 0; k < ball->vertex_count; k++) ball->vertex[k].z = 0.5 * (ball->vertex[k].z - 210) + 60;
    cut_refused(s, cut_block, &o, WCUT_DEGENERATE, "there is no upper half");
    const int corner = ball->triangle[1];
    ball->triangle[1] = ball->triangle[0];
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "not closed");
    ball->triangle[1] = 100000000;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "names no vertex");
    ball->triangle[1] = corner;
    ball->vertex[7].x = NAN;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "finite");
    wcut_mesh_destroy(ball);

    ball = ball_of(vec3(200, 300, 150), 100, 16);
    o.stock = ball;
    for (int k = 0; k < 3 * ball->triangle_count; k += 3) {
        const int c = ball->triangle[k];
        ball->triangle[k] = ball->triangle[k + 1], ball->triangle[k + 1] = c;
    }
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "not oriented outwards");
    wcut_mesh_destroy(ball);
    ball = ball_of(vec3(200, 300, 150), 100, 16);
    ball->vertex[100] = vec3(200, 300, 280); /* through the skin on the other side */
    o.stock = ball;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "meets itself");
    wcut_mesh_destroy(ball);
    wcut_surface_destroy(s);
}

TEST(boxes_that_overlap_or_not_have_the_intersection_that_they_have) {
    wcut_mesh *a = box_of(vec3(0, 0, 0), vec3(2, 2, 2)), *b = box_of(vec3(1, 1, 1), vec3(3, 3, 3));
    wcut_mesh *far = box_of(vec3(5, 5, 5), vec3(6, 6, 6)), *r = NULL;
    unsigned char tag[12], *got = NULL;
    memset(tag, 7, sizeof tag);
    ck_assert_int_eq(wcut_boolean_intersect(a, tag, b, NULL, &r, &got, NULL), WCUT_OK);
    ck_assert_double_le(fabs(cut_volume(r) - 1), 1e-12);
    ck_assert(cut_is_closed(r));
    double tagged = 0; /* three of the unit cube's six faces are of the first box */
    for (int t = 0; t < r->triangle_count; t++) {
        const int *c = r->triangle + 3 * (ptrdiff_t)t;
        ck_assert(got[t] == 7 || got[t] == 0);
        const wcut_vec3 n =
            vec3_cross(vec3_sub(r->vertex[c[1]], r->vertex[c[0]]), vec3_sub(r->vertex[c[2]], r->vertex[c[0]]));
        if (got[t]) tagged += vec3_length(n) / 2;
    }
    ck_assert_double_le(fabs(tagged - 3), 1e-12);
    wcut_mesh_destroy(r);
    wcut_free(got);
    ck_assert_int_eq(wcut_boolean_intersect(a, tag, far, NULL, &r, &got, NULL), WCUT_OK);
    ck_assert_int_eq(r->triangle_count, 0);
    wcut_mesh_destroy(r);
    wcut_free(got);

    wcut_mesh *const mark = a;
    wcut_mesh *kept = mark;
    unsigned char *tags = tag;
    b->triangle[1] = b->triangle[0]; /* no solid */
    ck_assert_int_eq(wcut_boolean_intersect(a, tag, b, NULL, &kept, &tags, NULL), WCUT_DEGENERATE);
    ck_assert(kept == mark && tags == tag);
    int pairs = 999;
    wcut_vec3 at = {999, 999, 999};
    ck_assert_int_eq(wcut_self_intersections(b, &pairs, &at, NULL), WCUT_DEGENERATE);
    ck_assert_int_eq(pairs, 999);
    a->vertex[0] = vec3(3, 3, 3); /* a corner pushed through the opposite one */
    ck_assert_int_eq(wcut_self_intersections(a, &pairs, &at, NULL), WCUT_OK);
    ck_assert(pairs > 0 && at.x >= 0 && at.x <= 3);
    wcut_mesh_destroy(far);
    wcut_mesh_destroy(b);
    wcut_mesh_destroy(a);
}

TEST(an_open_or_inverted_mesh_is_seen_as_such) {
    wcut_mesh *m = box_of(vec3(0, 0, 0), vec3(1, 2, 3));
    wcut_half_report r = {.closed = 999};
    ck_assert_int_eq(wcut_check_boundary(m, &r), WCUT_OK);
    ck_assert(r.closed == 1 && r.oriented == 1 && r.pieces == 1);
    ck_assert(fabs(r.volume - 6) < 1e-12 && fabs(r.area - 22) < 1e-12);
    ck_assert(r.box_low.x == 0 && r.box_low.y == 0 && r.box_low.z == 0);
    ck_assert(r.box_high.x == 1 && r.box_high.y == 2 && r.box_high.z == 3);
    const int first = m->triangle[0];
    m->triangle[0] = m->triangle[1], m->triangle[1] = first; /* one triangle turned */
    ck_assert_int_eq(wcut_check_boundary(m, &r), WCUT_OK);
    ck_assert(r.closed == 1 && r.oriented == 0);
    m->triangle[1] = m->triangle[0], m->triangle[0] = first;
    m->triangle_count = 11; /* one left out */
    ck_assert_int_eq(wcut_check_boundary(m, &r), WCUT_OK);
    ck_assert(r.closed == 0 && r.oriented == 0);
    m->triangle_count = 12;
    for (int k = 0; k < 36; k += 3) {
        const int c = m->triangle[k];
        m->triangle[k] = m->triangle[k + 1], m->triangle[k + 1] = c;
    }
    ck_assert_int_eq(wcut_check_boundary(m, &r), WCUT_OK);
    ck_assert(r.closed == 1 && r.oriented == 0 && r.volume < 0);
    wcut_mesh_destroy(m);
}

/* ---- what divides nothing ---- */

static double tilt_x, tilt_y, base;
static wcut_vec3 any_plane(double s, double t) {
    const wcut_vec3 p = cut_over(s, t, 0);
    return vec3(p.x, p.y, base + tilt_x * p.x + tilt_y * p.y);
}
static void plane_refused(double z, double by_x, double by_y, const char *words) {
    base = z, tilt_x = by_x, tilt_y = by_y;
    wcut_surface *s = cut_of(any_plane);
    cut_refused(s, cut_block, NULL, WCUT_DEGENERATE, words);
    wcut_surface_destroy(s);
}

static wcut_vec3 before_block(double s, double t) { return vec3(500 * s - 50, 40 * t - 50, 150); }
static wcut_vec3 beside_block(double s, double t) { return vec3(30 * s - 50, 1000 * t - 50, 150); }
static wcut_vec3 half_way(double s, double t) { return vec3(500 * s - 50, 400 * t - 50, 150); }
static wcut_vec3 turning_wire(double s, double t) {
    return vec3(500 * s - 50 + 300 * sin(2 * WCUT_PI * s), 1000 * t - 50, 150 + 60 * cos(2 * WCUT_PI * s));
}
static wcut_vec3 in_and_out(double s, double t) {
    return vec3(500 * s - 50, 1000 * t - 50 + 300 * sin(6 * WCUT_PI * t), 150 + 50 * t);
}
static wcut_vec3 against_feed(double s, double t) { return vec3(500 * s - 50, 950 - 1000 * t, 150); }
static wcut_vec3 ridge(double s, double t) {
    return vec3(500 * s - 50, 1000 * t - 50, 150 + 40 * exp(-pow((1000 * t - 500) / 20, 2)));
}

TEST(a_cut_that_divides_nothing_says_why_and_where) {
    plane_refused(310, 0, 0, "passes above");
    plane_refused(-5, 0, 0, "passes below");
    plane_refused(300, 0, 0, "grazes the block's face z = 300");
    plane_refused(0.05, 0, 0, "grazes the block's face z = 0");
    plane_refused(300, -0.2, 0, "along the block's edge x = 0, z = 300");
    plane_refused(80, -0.2, 0, "along the block's edge x = 400, z = 0");
    plane_refused(0, 0, 0.1, "along the block's edge y = 0, z = 0");
    plane_refused(210, 0, 0.1, "along the block's edge y = 900, z = 300");
    plane_refused(300, -0.2, -0.1, "through the block's corner (0, 0, 300)");
    plane_refused(130, -0.1, -0.1, "through the block's corner (400, 900, 0)");
    wcut_surface *s = cut_of(before_block);
    cut_refused(s, cut_block, NULL, WCUT_DEGENERATE, "misses the block");
    wcut_surface_destroy(s);
    s = cut_of(beside_block);
    cut_refused(s, cut_block, NULL, WCUT_DEGENERATE, "misses the block");
    wcut_surface_destroy(s);
    s = cut_of(half_way);
    cut_refused(s, cut_block, NULL, WCUT_DEGENERATE, "ends inside the block, up to 5");
    wcut_surface_destroy(s);
}

TEST(a_cut_that_folds_over_itself_is_refused_with_its_place) {
    wcut_surface *s = cut_of(turning_wire);
    cut_refused(s, cut_block, NULL, WCUT_DEGENERATE, "folds over itself");
    wcut_surface_destroy(s);
    s = cut_of(in_and_out);
    cut_refused(s, cut_block, NULL, WCUT_DEGENERATE, "folds over itself");
    wcut_surface_destroy(s);
    s = cut_of(cut_looped);
    cut_refused(s, cut_block, NULL, WCUT_DEGENERATE, "folds over itself");
    wcut_mould_options o = wcut_mould_default();
    wcut_mesh *stock = box_of(vec3(10, 10, 10), vec3(390, 890, 290));
    o.stock = stock;
    cut_refused(s, cut_block, &o, WCUT_DEGENERATE, "folds over itself");
    wcut_mesh_destroy(stock);
    wcut_surface_destroy(s);
    s = cut_of(against_feed);
    cut_refused(s, cut_block, NULL, WCUT_DEGENERATE, "");
    wcut_surface_destroy(s);
    s = cut_of(ridge); /* radius 5 mm at its crest */
    wcut_mould *m = cut_divide(s, cut_block, NULL);
    const double radius = m->radius_min;
    wcut_mould_destroy(m);
    o = wcut_mould_default();
    o.kerf = 2.2 * radius;
    cut_refused(s, cut_block, &o, WCUT_DEGENERATE, "kerf folds over itself");
    wcut_surface_destroy(s);
}

TEST(options_out_of_range_are_refused) {
    wcut_surface *s = cut_of(cut_level);
    const wcut_mould_options good = wcut_mould_default();
    wcut_mould_options o = good;
    double nothing[4] = {0};
    const wcut_key key = {0, 100, 100, 20, 20, 5}, point = {0, 100, 100, 20, 0, 5}, flat = {0, 100, 100, 20, 10, 0};
#define REFUSED(field, value, words) o = good, o.field = value, cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, words)
    REFUSED(chord_tolerance, 0, "tolerances");
    REFUSED(chord_tolerance, NAN, "tolerances");
    REFUSED(fit_tolerance, -1, "tolerances");
    REFUSED(fit_tolerance, INFINITY, "tolerances");
    REFUSED(prolong, -1, "prolong");
    REFUSED(prolong, NAN, "prolong");
    REFUSED(kerf, -1, "kerf");
    REFUSED(kerf, INFINITY, "kerf");
    REFUSED(kerf_stations, 1, "field");
    REFUSED(kerf_stations, 2, "field");
    REFUSED(kerf_stations, -2, "field");
    REFUSED(wire_diameter, -1, "wire");
    REFUSED(scale, 0, "scale");
    REFUSED(scale, NAN, "scale");
    REFUSED(pull, vec3(0, 0, 0), "pull");
    REFUSED(pull, vec3(0, 0, NAN), "pull");
    REFUSED(wall_asked, -1, "wall");
    REFUSED(draft_asked, 2, "draft");
    REFUSED(draft_asked, NAN, "draft");
    REFUSED(key_count, -1, "keys");
    REFUSED(key_count, 1, "keys");
    o = good, o.key_count = 1;
    o.key = &key, cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "tip");
    o.key = &point, cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "tip");
    o.key = &flat, cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "height");
    o = good, o.kerf_stations = o.kerf_nodes = 2, o.kerf_parameter = o.kerf_field = nothing;
    nothing[1] = NAN;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "kerf");
    cut_refused(NULL, cut_block, NULL, WCUT_BAD_ARGUMENT, "surface");
    cut_refused(s, vec3(0, 900, 300), NULL, WCUT_BAD_ARGUMENT, "block");
    cut_refused(s, vec3(400, NAN, 300), NULL, WCUT_BAD_ARGUMENT, "block");
    cut_refused(s, vec3(400, 900, -300), NULL, WCUT_BAD_ARGUMENT, "block");
    ck_assert_int_eq(wcut_mould_create(s, cut_block, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    wcut_mould_destroy(NULL);
    wcut_surface_destroy(s);
}
