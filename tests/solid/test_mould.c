/* labels: unit property
   Halves of a block by index: closed forms, kerf, keys, drafts, exact faces, what is prolonged and what is asked for. */
#include "solid/cuts.h"

#include <wirecut/curvature.h>
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/random.h"
#include "test.h"

static wcut_vec3 low_wall(double s, double t) { return cut_over(s, t, 20); }

TEST(a_level_cut_makes_two_boxes) {
    wcut_surface *s = cut_of(cut_level);
    wcut_mould *m = cut_divide(s, cut_block, NULL);
    ck_assert_double_le(fabs(m->lower.report.volume - 400.0 * 900 * 140), 1e-6);
    ck_assert_double_le(fabs(m->upper.report.volume - 400.0 * 900 * 160), 1e-6);
    ck_assert_double_le(fabs(m->lower.report.area - 2 * (400.0 * 900 + 400.0 * 140 + 900.0 * 140)), 1e-6);
    ck_assert_double_le(fabs(m->lower.report.cut_area - 400.0 * 900), 1e-6);
    ck_assert_double_le(fabs(m->lower.report.draft_min - WCUT_PI / 2), 1e-7);
    ck_assert_double_le(fabs(m->lower.report.wall_min - 140), 1e-9);
    ck_assert_double_le(fabs(m->upper.report.wall_min - 160), 1e-9);
    ck_assert_double_eq(m->block_volume, 400.0 * 900 * 300);
    ck_assert_double_gt(m->radius_min, 1e6);
    ck_assert(m->lower.report.pieces == 1 && m->upper.report.pieces == 1 && !m->by_boolean && !m->kerf);
    ck_assert(m->prolonged_entry == 0 && m->prolonged_exit == 0 && m->prolonged_side == 0);
    const wcut_half_report *r = &m->upper.report;
    ck_assert(r->box_low.x == 0 && r->box_low.y == 0 && fabs(r->box_low.z - 140) < 1e-9);
    ck_assert(r->box_high.x == 400 && r->box_high.y == 900 && r->box_high.z == 300);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

TEST(a_tilted_cut_has_the_volume_and_draft_of_its_plane_with_a_kerf_too) {
    const double slope = hypot(0.1, 0.05), rise = sqrt(1 + slope * slope), area = 400.0 * 900;
    wcut_surface *s = cut_of(cut_tilted);
    wcut_mould_options o = wcut_mould_default();
    for (int k = 0; k < 2; k++) {
        o.kerf = 2.0 * k;
        wcut_mould *m = cut_divide(s, cut_block, &o);
        ck_assert_double_le(fabs(m->lower.report.volume - area * (150 - o.kerf / 2 * rise)), 1e-3);
        ck_assert_double_le(fabs(m->kerf_volume - area * o.kerf * rise), 1e-3);
        ck_assert_double_le(fabs(m->upper.report.volume - m->lower.report.volume), 1e-3);
        ck_assert_double_le(fabs(m->lower.report.cut_area - area * rise), 1e-3);
        ck_assert_double_le(fabs(m->lower.report.draft_min - (WCUT_PI / 2 - atan(slope))), 1e-6);
        ck_assert_double_eq(m->lower.report.undercut_area, 0);
        ck_assert(fabs(m->kerf_min - o.kerf) < 1e-12 && fabs(m->kerf_max - o.kerf) < 1e-12 && (m->kerf != NULL) == k);
        wcut_mould_destroy(m);
    }
    o.kerf = 0; /* pulled along its own normal */
    o.pull = vec3(-0.2, 0.1, 2);
    wcut_mould *m = cut_divide(s, cut_block, &o);
    ck_assert_double_le(fabs(m->lower.report.draft_min - WCUT_PI / 2), 1e-6);
    ck_assert_double_le(fabs(m->upper.report.draft_min - WCUT_PI / 2), 1e-6);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

TEST(hills_have_the_volume_of_their_integral_and_both_halves_share_the_cut_by_index) {
    wcut_surface *s = cut_of(cut_hilly);
    double sum = 0; /* midpoint rule: the error falls with the square of the step, 1e-6 of the volume here */
    for (int j = 0; j < 900; j++)
        for (int i = 0; i < 400; i++) sum += cut_height(i + 0.5, j + 0.5);
    for (double tolerance = 1; tolerance > 0.005; tolerance /= 10) {
        wcut_mould_options o = wcut_mould_default();
        o.chord_tolerance = tolerance;
        wcut_mould *m = cut_divide(s, cut_block, &o);
        ck_assert_double_le(m->chord_error, tolerance);
        ck_assert_double_le(m->fit_error, o.fit_tolerance);
        const double off = fabs(m->lower.report.volume - sum) / (400.0 * 900);
        printf("hills: chord tolerance %g, mean height off by %.6f mm, %d triangles\n", tolerance, off,
               m->lower.mesh->triangle_count);
        ck_assert_double_le(off, tolerance);
        int shared =
            0; /* corners of the cut stand at the same index in the lower half and after the top in the upper */
        for (int v = 0; v < m->lower.mesh->vertex_count; v++) {
            if (isnan(m->lower.draft[v])) continue;
            const wcut_vec3 p = m->lower.mesh->vertex[v], q = m->upper.mesh->vertex[v + 4];
            ck_assert(p.x == q.x && p.y == q.y && p.z == q.z);
            shared++;
        }
        ck_assert_int_eq(shared, m->lower.mesh->vertex_count - 4);
        wcut_mould_destroy(m);
    }
    wcut_surface_destroy(s);
}

/* each vertex of the cut face within `off` of where the wire's surface, moved by `side` kerf(x, y) along its normal, is */
static void check_distance(const wcut_half *half, const wcut_projection *p, double side, double (*kerf)(wcut_vec3 x),
                           double off) {
    int count = 0;
    double worst = 0;
    wcut_foot *foot = malloc((size_t)half->mesh->vertex_count * sizeof *foot);
    ck_assert_ptr_nonnull(foot);
    ck_assert_int_eq(wcut_projection_locate(p, half->mesh->vertex_count, half->mesh->vertex, 1, foot), WCUT_OK);
    for (int v = 0; v < half->mesh->vertex_count; v++) {
        if (isnan(half->draft[v]) || foot[v].beyond) continue;
        worst = fmax(worst, fabs(foot[v].height - side * kerf(foot[v].point)));
        count++;
    }
    free(foot);
    printf("kerf: %d vertices, worst %.6f mm\n", count, worst);
    ck_assert_int_ge(count, 4);
    ck_assert_double_le(worst, off);
}

static double kerf_even(wcut_vec3 x) {
    (void)x;
    return 1.5;
}
static double kerf_growing(wcut_vec3 x) { return 1 + x.x / 800 + x.y / 1800; }

TEST(faces_lie_half_a_kerf_on_either_side_of_the_wires_surface) {
    wcut_surface *s = cut_of(cut_hilly);
    wcut_projection *p = NULL;
    ck_assert_int_eq(wcut_projection_create(s, &p), WCUT_OK);
    wcut_mould_options o = wcut_mould_default();
    o.kerf = 1.5;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    check_distance(&m->lower, p, -0.5, kerf_even, o.fit_tolerance);
    check_distance(&m->upper, p, 0.5, kerf_even, o.fit_tolerance);
    ck_assert_double_le(fabs(m->kerf_volume / (1.5 * m->lower.report.cut_area) - 1), 1e-3);
    wcut_mould_destroy(m);
    wcut_projection_destroy(p);
    wcut_surface_destroy(s);
}

TEST(a_kerf_that_grows_along_wire_and_feed_is_followed) {
    enum { N = 21 };
    wcut_surface *s = cut_of(cut_tilted); /* a plane: u and v are linear in x and y, and so is the kerf */
    double parameter[N], field[N * N];
    for (int j = 0; j < N; j++) {
        parameter[j] = j / (N - 1.0);
        for (int i = 0; i < N; i++) field[j * N + i] = kerf_growing(cut_over(i / (N - 1.0), j / (N - 1.0), 0));
    }
    wcut_projection *p = NULL;
    ck_assert_int_eq(wcut_projection_create(s, &p), WCUT_OK);
    wcut_mould_options o = wcut_mould_default();
    o.kerf_stations = o.kerf_nodes = N, o.kerf_parameter = parameter, o.kerf_field = field;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    check_distance(&m->lower, p, -0.5, kerf_growing, o.fit_tolerance);
    check_distance(&m->upper, p, 0.5, kerf_growing, o.fit_tolerance);
    ck_assert_double_le(fabs(m->kerf_min - 1), 1e-3);
    ck_assert_double_le(fabs(m->kerf_max - 2), 1e-3);
    wcut_mould_destroy(m);
    field[5] = 0; /* closes at one place only */
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "kerf");
    field[5] = -1;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "kerf");
    field[5] = 1, parameter[3] = 0.9;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "kerf");
    wcut_projection_destroy(p);
    wcut_surface_destroy(s);
}

TEST(an_overhanging_cut_is_two_solids_and_its_undercut_is_said) {
    wcut_surface *s = cut_of(cut_overhanging);
    wcut_mould *m = cut_divide(s, cut_block, NULL);
    /* below the curve (y, z)(w): the integral of z dy over the cut, from y = 0 to 900 */
    double sum = 0, last_y = 0, area = 0;
    enum { STEPS = 2000000 };
    wcut_vec3 a = cut_overhanging(0, 0);
    for (int k = 1; k <= STEPS; k++) {
        const wcut_vec3 b = cut_overhanging(0, k / (double)STEPS);
        const double y0 = clamp(a.y, 0, 900), y1 = clamp(b.y, 0, 900);
        sum += (y1 - y0) * (a.z + b.z) / 2;
        if (b.y < a.y) area += hypot(b.y - a.y, b.z - a.z);
        a = b, last_y = b.y;
    }
    ck_assert_double_gt(last_y, 900);
    printf("overhang: volume off by %.2e, undercut %.1f of %.1f mm2, draft %.2f deg\n",
           m->lower.report.volume / (400 * sum) - 1, m->lower.report.undercut_area, 400 * area,
           m->lower.report.draft_min * 180 / WCUT_PI);
    ck_assert_double_le(fabs(m->lower.report.volume / (400 * sum) - 1), 1e-4);
    ck_assert_double_le(fabs(m->lower.report.undercut_area / (400 * area) - 1), 0.02);
    ck_assert_double_lt(m->lower.report.draft_min, -0.5);
    ck_assert_double_lt(m->upper.report.draft_min, -0.5);
    ck_assert(!m->by_boolean && m->lower.brep);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

/* a coedge's ends */
static void ends_of(const wcut_brep *b, const wcut_brep_coedge *c, int end[2]) {
    end[c->reversed ? 1 : 0] = b->edge[c->edge].from;
    end[c->reversed ? 0 : 1] = b->edge[c->edge].to;
}

/* [mm] from a face's own geometry: of its plane, or of its spline surface */
static double off_face(const wcut_brep_face *f, wcut_vec3 p) {
    if (!f->surface) return fabs(vec3_dot(f->normal, vec3_sub(p, f->origin)));
    wcut_projection *projection = NULL;
    wcut_foot foot;
    ck_assert_int_eq(wcut_projection_create(f->surface, &projection), WCUT_OK);
    ck_assert_int_eq(wcut_projection_locate(projection, 1, &p, 1, &foot), WCUT_OK);
    wcut_projection_destroy(projection);
    return foot.distance;
}

/* a point of an edge at t in [0, 1] */
static wcut_vec3 on_edge(const wcut_brep *b, int e, double t) {
    const wcut_brep_edge *edge = &b->edge[e];
    if (!edge->curve) return vec3_mix(b->vertex[edge->from], b->vertex[edge->to], t);
    double first, last;
    wcut_vec3 p;
    wcut_curve_domain(edge->curve, &first, &last);
    ck_assert_int_eq(wcut_curve_eval(edge->curve, (1 - t) * first + t * last, 0, &p), WCUT_OK);
    return p;
}

/* the volume by the divergence theorem over the exact faces, each split finely: to 1e-3 of it */
static void check_brep(const wcut_half *half, int keys, int lugs) {
    const wcut_brep *b = half->brep;
    ck_assert_ptr_nonnull(b);
    ck_assert_int_eq(b->face_count, 6 + 3 * keys + 8 * lugs);
    ck_assert_int_eq(b->loop_count, b->face_count + keys + 2 * lugs);
    /* Euler, Poincare: V - E + F - holes = 2 for one shell without handles */
    ck_assert_int_eq(b->vertex_count - b->edge_count + b->face_count - (b->loop_count - b->face_count), 2);
    int *used = calloc((size_t)b->edge_count * 2, sizeof *used);
    ck_assert_ptr_nonnull(used);
    int seen = 0;
    for (int f = 0; f < b->face_count; f++) {
        const wcut_brep_face *face = &b->face[f];
        if (lugs == 0) ck_assert_int_eq(face->loop_count, face->part == WCUT_BREP_PART_OPPOSITE ? 1 + keys : 1);
        for (int l = face->first_loop; l < face->first_loop + face->loop_count; l++) {
            const wcut_brep_loop *loop = &b->loop[l];
            ck_assert_int_eq(loop->first_coedge, seen);
            for (int k = 0; k < loop->coedge_count; k++, seen++) {
                const wcut_brep_coedge *c = &b->coedge[seen],
                                       *next = &b->coedge[loop->first_coedge + (k + 1) % loop->coedge_count];
                int end[2], after[2];
                ends_of(b, c, end), ends_of(b, next, after);
                ck_assert_int_eq(end[1], after[0]);
                used[2 * c->edge + (c->reversed != 0)]++;
                for (int i = 0; i <= 4; i++) ck_assert_double_le(off_face(face, on_edge(b, c->edge, i / 4.0)), 1e-9);
            }
        }
    }
    ck_assert_int_eq(seen, b->coedge_count);
    for (int e = 0; e < b->edge_count; e++) {
        ck_assert(used[2 * e] == 1 && used[2 * e + 1] == 1);
        ck_assert_double_le(vec3_distance(on_edge(b, e, 0), b->vertex[b->edge[e].from]), 1e-12);
        ck_assert_double_le(vec3_distance(on_edge(b, e, 1), b->vertex[b->edge[e].to]), 1e-12);
        ck_assert_int_ne(b->edge[e].from, b->edge[e].to);
    }
    free(used);
}

/* Does each face lie to the left of its loop, seen along its outward normal? Planes by the loop's signed area, splines
   by the first coedge's direction against the surface's own border. */
static void check_senses(const wcut_half *half) {
    const wcut_brep *b = half->brep;
    for (int f = 0; f < b->face_count; f++) {
        const wcut_brep_face *face = &b->face[f];
        for (int l = face->first_loop; l < face->first_loop + face->loop_count; l++) {
            const wcut_brep_loop *loop = &b->loop[l];
            wcut_vec3 area = {0, 0, 0};
            const wcut_vec3 from = b->vertex[b->edge[b->coedge[loop->first_coedge].edge].from];
            for (int k = 0; k < loop->coedge_count; k++) {
                const wcut_brep_coedge *c = &b->coedge[loop->first_coedge + k];
                for (int i = 0; i < 16; i++) {
                    const double t0 = i / 16.0, t1 = (i + 1) / 16.0;
                    const wcut_vec3 p = on_edge(b, c->edge, c->reversed ? 1 - t0 : t0);
                    const wcut_vec3 q = on_edge(b, c->edge, c->reversed ? 1 - t1 : t1);
                    area = vec3_add(area, vec3_cross(vec3_sub(p, from), vec3_sub(q, from)));
                }
            }
            wcut_vec3 out = face->normal;
            if (face->surface) {
                wcut_vec3 d[4];
                double first[2], last[2];
                wcut_surface_domain(face->surface, first, last);
                ck_assert_int_eq(
                    wcut_surface_eval(face->surface, (first[0] + last[0]) / 2, (first[1] + last[1]) / 2, 1, d),
                    WCUT_OK);
                out = vec3_scale(face->same_sense ? 1 : -1, vec3_cross(d[2], d[1]));
            }
            const double side = vec3_dot(out, area);
            ck_assert_msg(l == face->first_loop ? side > 0 : side < 0, "face %d loop %d", f, l);
        }
    }
}

TEST(exact_faces_are_a_closed_shell_whose_edges_lie_on_both_their_faces) {
    wcut_surface *s = cut_of(cut_hilly);
    wcut_mould_options o = wcut_mould_default();
    wcut_key key[WCUT_KEYS_AT_CORNERS];
    for (int k = 0; k < 3; k++) {
        ck_assert_int_eq(wcut_keys_at_corners(cut_block, 20, k == 1 ? 12 : -12, key), WCUT_OK);
        o.kerf = k;
        o.key = key, o.key_count = k == 0 ? 0 : WCUT_KEYS_AT_CORNERS;
        o.scale = k == 2 ? 1.02 : 1;
        wcut_mould *m = cut_divide(s, cut_block, &o);
        const int keys = k == 0 ? 0 : 3;
        check_brep(&m->lower, keys, 0), check_brep(&m->upper, keys, 0);
        check_senses(&m->lower), check_senses(&m->upper);
        ck_assert(m->lower.brep->face[0].part == WCUT_BREP_PART_CUT && m->lower.brep->face[0].same_sense == 1);
        ck_assert(m->upper.brep->face[0].part == WCUT_BREP_PART_CUT && m->upper.brep->face[0].same_sense == 0);
        /* triangles and exact face are within the chord tolerance, in both halves */
        wcut_projection *p = NULL;
        ck_assert_int_eq(wcut_projection_create(m->upper.brep->face[0].surface, &p), WCUT_OK);
        wcut_foot *foot = malloc((size_t)m->upper.mesh->vertex_count * sizeof *foot);
        ck_assert_ptr_nonnull(foot);
        ck_assert_int_eq(wcut_projection_locate(p, m->upper.mesh->vertex_count, m->upper.mesh->vertex, 1, foot),
                         WCUT_OK);
        for (int v = 0; v < m->upper.mesh->vertex_count; v++)
            if (!isnan(m->upper.draft[v])) ck_assert_double_le(foot[v].distance, 1e-9);
        free(foot);
        wcut_projection_destroy(p);
        wcut_mould_destroy(m);
    }
    wcut_surface_destroy(s);
}

TEST(the_border_lies_in_the_blocks_sides_to_the_last_bit) {
    wcut_surface *s = cut_of(cut_hilly);
    wcut_mould_options o = wcut_mould_default();
    o.kerf = 0.7;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    for (int k = 0; k < 2; k++) {
        const wcut_surface *f = (k ? m->upper : m->lower).brep->face[0].surface;
        for (int j = 0; j < f->count_v; j++) {
            ck_assert(f->control[j * f->count_u].x == 0);
            ck_assert(f->control[j * f->count_u + f->count_u - 1].x == 400);
        }
        for (int i = 0; i < f->count_u; i++) {
            ck_assert(f->control[i].y == 0);
            ck_assert(f->control[(f->count_v - 1) * f->count_u + i].y == 900);
        }
        const wcut_mesh *mesh = (k ? m->upper : m->lower).mesh;
        for (int v = 0; v < mesh->vertex_count; v++) {
            const wcut_vec3 p = mesh->vertex[v];
            ck_assert(p.x >= 0 && p.x <= 400 && p.y >= 0 && p.y <= 900 && p.z >= 0 && p.z <= 300);
            ck_assert((p.x == 0) == (p.x < 1e-9) && (p.x == 400) == (p.x > 400 - 1e-9));
            ck_assert((p.y == 0) == (p.y < 1e-9) && (p.y == 900) == (p.y > 900 - 1e-9));
        }
    }
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

TEST(keys_add_and_take_the_volume_of_frustums_and_leave_a_wall) {
    wcut_surface *s = cut_of(cut_level);
    wcut_mould_options o = wcut_mould_default();
    const wcut_key key[3] = {{0, 100, 100, 20, 12, -30}, {0, 300, 700, 10, 4, 8}, {1, 200, 450, 40, 30, -60}};
    o.key = key, o.key_count = 3, o.chord_tolerance = 0.001;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    const double frustum[3] = {-30 * WCUT_PI / 3 * (400 + 240 + 144), 8 * WCUT_PI / 3 * (100 + 40 + 16),
                               -60 * WCUT_PI / 3 * (1600 + 1200 + 900)};
    ck_assert_double_le(fabs(m->lower.report.key_volume - frustum[0] - frustum[1]), 1e-3 * fabs(frustum[0]));
    ck_assert_double_le(fabs(m->upper.report.key_volume - frustum[2]), 1e-3 * fabs(frustum[2]));
    ck_assert_double_le(fabs(m->lower.report.wall_min - 110), 1e-9);
    ck_assert_double_le(fabs(m->upper.report.wall_min - 100), 1e-9);
    ck_assert(m->lower.report.box_low.z == -8 && m->upper.report.box_high.z == 300);
    wcut_mould_destroy(m);
    wcut_key bad = key[0];
    o.key = &bad, o.key_count = 1;
    bad.height = -140;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "reaches the cut face");
    bad = key[0], bad.x = 19.9;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "reaches the block's side");
    const wcut_key meeting[2] = {key[0], {0, 130, 100, 15, 10, 5}};
    o.key = meeting, o.key_count = 2;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "two of them meet");
    wcut_surface_destroy(s);
}

TEST(keys_at_corners_fit_in_one_way_only_and_refuse_what_has_no_tip) {
    wcut_key key[WCUT_KEYS_AT_CORNERS];
    memset(key, 0x5a, sizeof key);
    const wcut_key before = key[0];
    ck_assert_int_eq(wcut_keys_at_corners(cut_block, 10, 28, key), WCUT_BAD_ARGUMENT); /* 28 tan 20 deg > 10 */
    ck_assert_int_eq(wcut_keys_at_corners(cut_block, 0, 5, key), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_keys_at_corners(cut_block, 10, 0, key), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_keys_at_corners(cut_block, 10, NAN, key), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_keys_at_corners(vec3(0, 1, 1), 10, 5, key), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_keys_at_corners(cut_block, 10, 5, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(memcmp(&before, &key[0], sizeof before), 0);
    ck_assert_int_eq(wcut_keys_at_corners(cut_block, 10, -5, key), WCUT_OK);
    double across = 0; /* turned by half a turn about the block's axis, no three keys meet three others */
    for (int k = 0; k < WCUT_KEYS_AT_CORNERS; k++) {
        ck_assert_int_eq(key[k].upper, k / 3);
        ck_assert_double_eq(key[k].height, -5);
        ck_assert_double_le(fabs((key[k].radius - key[k].tip_radius) / 5 - tan(20 * WCUT_PI / 180)), 1e-12);
        across += k < 3 ? (key[k].x - 200) * (key[k].y - 450) : 0;
    }
    ck_assert_double_ne(across, 0);
}

/* the cone (first of a lower half's lugs) or pocket of every lug: z of foot and end, radius at both, axis */
typedef struct lug_key {
    double x, y, foot, end, radius, tip;
} lug_key;

static int lug_keys(const wcut_brep *b, lug_key *key) {
    int count = 0;
    for (int f = 0; f < b->face_count; f++) {
        if (b->face[f].part != WCUT_BREP_PART_KEY_FLANK || b->face[f + 1].part != WCUT_BREP_PART_KEY_FLANK) continue;
        const wcut_vec3 *c = b->face[f].surface->control; /* from angle 0 to pi on the face, then at the end */
        key[count++] = (lug_key){(c[0].x + c[3].x) / 2, (c[0].y + c[3].y) / 2, c[0].z, c[4].z,
                                 (c[0].x - c[3].x) / 2, (c[4].x - c[7].x) / 2};
    }
    return count;
}

TEST(lugs_register_the_halves_to_each_other_and_all_stays_closed_and_exact) {
    wcut_surface *s = cut_of(cut_hilly);
    for (int k = 0; k < 3; k++) {
        wcut_mould_options o = wcut_mould_default();
        o.chord_tolerance = 1, o.lug_radius = 12, o.lug_height = 10, o.lug_clearance = 0.15;
        o.thickness = 8 * k, o.scale = k == 2 ? 1.02 : 1;
        wcut_mould *m = cut_divide(s, cut_block, &o);
        const double f = o.scale;
        check_brep(&m->lower, 0, 3), check_brep(&m->upper, 0, 3);
        check_senses(&m->lower), check_senses(&m->upper);
        ck_assert(m->lugs == 3 && m->lower.report.pieces == 1 && m->upper.report.pieces == 1);
        ck_assert(m->lower.report.box_low.x < -f * 30 && m->lower.report.box_high.x > f * 430);

        /* every cone stands in a pocket: on its floor, with the clearance around its flank */
        lug_key cone[3], pocket[3];
        ck_assert(lug_keys(m->lower.brep, cone) == 3 && lug_keys(m->upper.brep, pocket) == 3);
        for (int j = 0; j < 3; j++) {
            const lug_key *a = &cone[j], *b = &pocket[j];
            ck_assert(a->x < 0 || a->x > 400 * f);
            ck_assert_double_le(fabs(a->x - b->x) + fabs(a->y - b->y) + fabs(a->end - b->end), 1e-9);
            ck_assert_double_le(fabs(b->end - b->foot - 10 * f), 1e-9);
            const double share = (b->foot - a->foot) / (a->end - a->foot);
            ck_assert(share > 0 && share < 1 && a->tip >= 6 * f - 1e-9);
            ck_assert_double_le(fabs(b->radius - (a->radius + share * (a->tip - a->radius)) - 0.15 * f), 1e-9);
            ck_assert_double_le(fabs(b->tip - a->tip - 0.15 * f), 1e-9);
        }

        /* one way only: two at x = 0, one at x = W */
        ck_assert(cone[0].x < 0 && cone[1].x < 0 && cone[2].x > 400 * f && cone[1].y > cone[0].y);
        wcut_mould_destroy(m);
    }
    wcut_surface_destroy(s);
}

TEST(lugs_without_room_are_refused_with_their_place) {
    wcut_surface *s = cut_of(low_wall);
    wcut_mould_options o = wcut_mould_default();
    o.lug_radius = 12, o.lug_height = 10;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "no room at x = 0");
    o.frame_wall = 10;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "lugs and a frame");
    o.frame_wall = 0, o.lug_height = 0;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "positive height");
    o.lug_radius = 0, o.frame_wall = -1;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "frame: found a wall of -1");
    o.frame_wall = 0, o.thickness = -1;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "thickness: found -1");
    wcut_surface_destroy(s);
    s = cut_of(cut_tilted);
    o = wcut_mould_default();
    o.lug_radius = 200, o.lug_height = 10;
    cut_refused(s, cut_block, &o, WCUT_BAD_ARGUMENT, "no room");
    wcut_surface_destroy(s);
}

TEST(a_casting_has_its_thickness_along_the_normals_and_a_frame_closes_around_the_block) {
    wcut_surface *s = cut_of(cut_tilted);
    wcut_mould_options o = wcut_mould_default();
    o.thickness = 20, o.kerf = 3, o.frame_wall = 15, o.frame_clearance = 0.5, o.scale = 2;
    wcut_mould *m = cut_divide(s, cut_block, &o);

    /* of a plane: area over the block times thickness, whatever the kerf */
    const double area = 400.0 * 900 * sqrt(1 + 0.1 * 0.1 + 0.05 * 0.05);
    ck_assert_double_le(fabs(m->kerf_volume / 8 / (20 * area) - 1), 1e-9);
    ck_assert(m->thickness == 20 && fabs(m->kerf_min - 20) < 1e-9 && fabs(m->kerf_max - 20) < 1e-9);

    /* outer box less inner box, closed, by triangles and by faces */
    const double outer = 431.0 * 931 * 300, inner = 401.0 * 901 * 300;
    ck_assert(cut_is_closed(m->frame));
    ck_assert_double_le(fabs(cut_volume(m->frame) / 8 / (outer - inner) - 1), 1e-12);
    ck_assert_double_le(fabs(m->frame_volume / 8 / (outer - inner) - 1), 1e-12);
    const wcut_half frame = {.brep = m->frame_brep};
    check_senses(&frame);
    ck_assert(m->frame_brep->face_count == 10 && m->frame_brep->loop_count == 12);
    int used[48] = {0};
    for (int k = 0; k < m->frame_brep->coedge_count; k++)
        used[2 * m->frame_brep->coedge[k].edge + (m->frame_brep->coedge[k].reversed != 0)]++;
    for (int k = 0; k < 48; k++) ck_assert_int_eq(used[k], 1);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

TEST(halves_grow_with_the_shrinkage) {
    wcut_surface *s = cut_of(cut_hilly);
    wcut_mould_options o = wcut_mould_default();
    o.kerf = 1;
    wcut_mould *plain = cut_divide(s, cut_block, &o);
    o.scale = 1.03;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    const double f = 1.03;
    ck_assert_double_le(fabs(m->lower.report.volume / plain->lower.report.volume / (f * f * f) - 1), 1e-12);
    ck_assert_double_le(fabs(m->upper.report.area / plain->upper.report.area / (f * f) - 1), 1e-12);
    ck_assert_double_le(fabs(m->lower.report.wall_min / plain->lower.report.wall_min / f - 1), 1e-12);
    ck_assert_double_le(fabs(m->kerf_volume / plain->kerf_volume / (f * f * f) - 1), 1e-9);
    ck_assert_double_eq(m->scale, 1.03);
    ck_assert_int_eq(m->lower.mesh->vertex_count, plain->lower.mesh->vertex_count);
    for (int v = 0; v < m->lower.mesh->vertex_count; v++)
        ck_assert_double_eq(m->lower.mesh->vertex[v].z, f * plain->lower.mesh->vertex[v].z);
    ck_assert_double_eq(m->upper.brep->vertex[6].z, f * 300);
    wcut_mould_destroy(m);
    wcut_mould_destroy(plain);
    wcut_surface_destroy(s);
}

TEST(walls_and_drafts_are_held_against_what_was_asked_for) {
    wcut_surface *s = cut_of(low_wall);
    wcut_mould_options o = wcut_mould_default();
    o.wall_asked = 20.5, o.draft_asked = WCUT_PI / 2 - 1e-5, o.wire_diameter = 0.3;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    ck_assert(!m->lower.report.wall_held && m->upper.report.wall_held && m->lower.report.draft_held);
    ck_assert(m->wall_asked == 20.5 && m->wire_radius == 0.15 && m->draft_asked == o.draft_asked);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
    s = cut_of(cut_overhanging);
    o.draft_asked = 0;
    m = cut_divide(s, cut_block, &o);
    ck_assert(!m->lower.report.draft_held && !m->upper.report.draft_held);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

/* as a design's wire ends: on the block's sides, sagging behind its last station at y = 900 */
static wcut_vec3 design(double s, double t) {
    const double y = 900 * t - 120 * s * (1 - s);
    return vec3(400 * s, y, cut_height(400 * s, y));
}

TEST(a_cut_that_ends_inside_is_continued_straight_as_far_as_is_allowed) {
    wcut_surface *s = cut_of(design);
    wcut_mould_options o = wcut_mould_default();
    o.prolong = 0;
    cut_refused(s, cut_block, &o, WCUT_DEGENERATE, "ends inside the block");
    o.prolong = 29;
    cut_refused(s, cut_block, &o, WCUT_DEGENERATE, "ends inside the block");
    o.prolong = 32;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    ck_assert_double_gt(m->prolonged_exit, 29.9);
    ck_assert_double_lt(m->prolonged_exit, 32);
    ck_assert_double_le(m->prolonged_entry, 1e-6);
    ck_assert_double_le(m->prolonged_side, 1e-6);
    wcut_mould_destroy(m);
    /* the continuation is the tangent plane's: a plane stays a plane */
    wcut_surface_destroy(s);
    s = cut_of(cut_tilted);
    const wcut_vec3 wider = {480, 900, 300}, larger = {480, 1000, 300};
    o.prolong = 29;
    cut_refused(s, wider, &o, WCUT_DEGENERATE, "too short for the block's sides");
    o.prolong = 60;
    m = cut_divide(s, larger, &o);
    double mean = 150 + 0.1 * 40 - 0.05 * 50;
    ck_assert_double_le(fabs(m->lower.report.volume / (480.0 * 1000 * mean) - 1), 1e-9);
    ck_assert_double_gt(m->prolonged_exit, 49.9);
    ck_assert_double_gt(m->prolonged_side, 29.9);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

TEST(a_wire_that_stops_where_it_meets_the_block_may_begin_a_station_later) {
    enum { STATIONS = 275, NODES = 41 };
    static wcut_vec3 x[STATIONS * NODES];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) { /* 3.75 mm a station in air, then a stop at the side */
            const double s = i / (NODES - 1.0), free = -40 + 3.75 * j - 48 * s * (1 - s);
            x[j * NODES + i] = vec3(500 * s - 50, free < 0 ? free : fmax(-0.07, free - 7.5), 150 + 0.02 * free);
        }
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, x, 0, &s, NULL, NULL), WCUT_OK);
    wcut_mould_options o = wcut_mould_default();
    o.prolong = 0;
    cut_refused(s, cut_block, &o, WCUT_DEGENERATE, "side y = 0 mm");
    o.prolong = 20;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    printf("stopped at the side: begins %.3f mm later\n", m->prolonged_entry);
    ck_assert_double_gt(m->prolonged_entry, 0);
    ck_assert_double_lt(m->prolonged_entry, 20);
    ck_assert_double_le(m->prolonged_exit, 1e-9);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

TEST(a_finer_fit_is_asked_for_and_held_where_nobody_looked) {
    wcut_surface *s = cut_of(cut_hilly);
    wcut_projection *p = NULL;
    ck_assert_int_eq(wcut_projection_create(s, &p), WCUT_OK);
    wcut_random random = wcut_random_seed(3);
    int poles = 0;
    for (double tolerance = 0.1; tolerance > 5e-5; tolerance /= 10) {
        wcut_mould_options o = wcut_mould_default();
        o.fit_tolerance = tolerance;
        wcut_mould *m = cut_divide(s, cut_block, &o);
        const wcut_surface *f = m->lower.brep->face[0].surface;
        double worst = 0;
        for (int k = 0; k < 20000; k++) {
            wcut_vec3 q;
            wcut_foot foot;
            const double u = wcut_random_uniform(&random), v = wcut_random_uniform(&random);
            ck_assert_int_eq(wcut_surface_eval(f, u, v, 0, &q), WCUT_OK);
            ck_assert_int_eq(wcut_projection_locate(p, 1, &q, 1, &foot), WCUT_OK);
            worst = fmax(worst, foot.distance);
        }
        printf("fit: asked %g, measured %.6f, sampled again %.6f mm, %d x %d control points\n", tolerance, m->fit_error,
               worst, f->count_u, f->count_v);
        ck_assert_double_le(m->fit_error, tolerance);
        ck_assert_double_le(worst, tolerance);
        ck_assert_int_gt(f->count_u * f->count_v, poles);
        poles = f->count_u * f->count_v;
        wcut_mould_destroy(m);
    }
    wcut_mould_options o = wcut_mould_default();
    o.fit_tolerance = 1e-14;
    cut_refused(s, cut_block, &o, WCUT_NOT_CONVERGED, "no bicubic cut face");
    wcut_projection_destroy(p);
    wcut_surface_destroy(s);
}

TEST(the_least_radius_is_that_of_the_wires_surface) {
    wcut_surface *s = cut_of(cut_hilly);
    wcut_mould *m = cut_divide(s, cut_block, NULL);
    double min = INFINITY;
    for (int j = 0; j <= 200; j++)
        for (int i = 0; i <= 200; i++) {
            double k;
            ck_assert_int_eq(wcut_surface_curvature(s, 0.1 + 0.8 * i / 200, 0.08 + 0.84 * j / 200, &k, NULL), WCUT_OK);
            min = fmin(min, 1 / fabs(k));
        }
    ck_assert_double_le(fabs(m->radius_min / min - 1), 0.05);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

TEST(the_same_cut_gives_the_same_bytes) {
    wcut_surface *s = cut_of(cut_hilly);
    wcut_mould *a = cut_divide(s, cut_block, NULL), *b = cut_divide(s, cut_block, NULL);
    ck_assert_int_eq(a->upper.mesh->vertex_count, b->upper.mesh->vertex_count);
    ck_assert_int_eq(memcmp(a->upper.mesh->vertex, b->upper.mesh->vertex,
                            (size_t)a->upper.mesh->vertex_count * sizeof *a->upper.mesh->vertex),
                     0);
    ck_assert_int_eq(memcmp(a->upper.mesh->triangle, b->upper.mesh->triangle,
                            (size_t)a->upper.mesh->triangle_count * 3 * sizeof *a->upper.mesh->triangle),
                     0);
    wcut_mould_destroy(b);
    wcut_mould_destroy(a);
    wcut_surface_destroy(s);
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    wcut_surface *s = cut_of(cut_tilted);
    wcut_mould_options o = wcut_mould_default();
    wcut_key key[WCUT_KEYS_AT_CORNERS];
    ck_assert_int_eq(wcut_keys_at_corners(cut_block, 20, -12, key), WCUT_OK);
    o.kerf = 1, o.key = key, o.key_count = WCUT_KEYS_AT_CORNERS, o.chord_tolerance = 1;
    wcut_mould *const mark = (wcut_mould *)&cut_block, *m = mark;
    wcut_error error = {.text = ""};
    EACH_FAILED_ALLOCATION(wcut_mould_create(s, cut_block, &o, &m, &error),
                           error.status == WCUT_NO_MEMORY && m == mark);
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}
