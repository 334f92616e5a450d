/* labels: unit property
   Surfaces cut by planes and blocks: circles of spheres and tori, every crossing of dense grid lines, corners that meet. */
#include <stdio.h>
#include <wirecut/intersect.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

static double trace_length(const wcut_trace *t) {
    double sum = 0;
    for (int k = 1; k < t->count; k++) sum += vec3_distance(t->point[k - 1], t->point[k]);
    return t->closed ? sum + vec3_distance(t->point[t->count - 1], t->point[0]) : sum;
}

/* points are where their parameters say, and on the plane */
static void check_trace(const wcut_surface *s, const wcut_trace *t, wcut_vec3 point, wcut_vec3 normal) {
    double max = 0, off = 0;
    for (int k = 0; k < t->count; k++) {
        wcut_vec3 p;
        wcut_surface_eval(s, t->uv[2 * k], t->uv[2 * k + 1], 0, &p);
        max = fmax(max, vec3_distance(p, t->point[k]));
        off = fmax(off, fabs(vec3_dot(vec3_sub(p, point), vec3_unit(normal))));
    }
    ck_assert(t->count >= 2 && max <= 1e-12);
    ck_assert_double_le(off, 1e-10);
}

TEST(a_sphere_and_a_plane_meet_in_one_circle) {
    wcut_random random = wcut_random_seed(61);
    wcut_surface *s = shape_sphere(40);
    for (int trial = 0; trial < 120; trial++) {
        const wcut_vec3 normal = trial < 3 ? vec3(trial == 0, trial == 1, trial == 2)
                                           : vec3_unit(vec3(wcut_random_normal(&random), wcut_random_normal(&random),
                                                            wcut_random_normal(&random)));
        /* from the middle to a loop of 0.01 mm */
        const double d = trial % 3 == 0 ? 0 : trial % 3 == 1 ? 39 * wcut_random_uniform(&random) : 40 - 1e-6;
        const double radius = sqrt(1600 - d * d), tolerance = trial % 2 ? 1e-2 : 1e-3;
        wcut_traces *t = NULL;
        ck_assert_int_eq(wcut_surface_intersect_plane(s, vec3_scale(d, normal), vec3_scale(7, normal), tolerance, &t),
                         WCUT_OK);
        ck_assert_msg(t->count == 1 && t->trace[0].closed && t->touching == 0 && t->loose == 0,
                      "trial %d: %d curves, %d loose", trial, t->count, t->loose);
        check_trace(s, &t->trace[0], vec3_scale(d, normal), normal);
        const double length = trace_length(&t->trace[0]), want = 2 * WCUT_PI * radius;
        ck_assert_msg(length <= want + 1e-6 && length >= want - 40 * tolerance, "trial %d: length %.9g, not %.9g",
                      trial, length, want);
        wcut_traces_destroy(t);
    }
    wcut_surface_destroy(s);
}

TEST(a_torus_gives_two_circles_four_times_over) {
    wcut_surface *s = shape_torus(50, 20);
    const wcut_vec3 origin = {0, 0, 0}, normal[3] = {{0, 0, 1}, {0, 1, 0}, {1, 1e-9, 0}};
    const double want[3] = {2 * WCUT_PI * 100, 2 * WCUT_PI * 40, 2 * WCUT_PI * 40};
    for (int k = 0; k < 3; k++) {
        wcut_traces *t = NULL;
        ck_assert_int_eq(wcut_surface_intersect_plane(s, origin, normal[k], 1e-4, &t), WCUT_OK);
        double sum = 0;
        for (int i = 0; i < t->count; i++) {
            ck_assert(t->trace[i].closed);
            check_trace(s, &t->trace[i], origin, normal[k]);
            sum += trace_length(&t->trace[i]);
        }
        ck_assert_msg(t->count == 2 && t->loose == 0, "%d curves", t->count);
        ck_assert_double_eq_tol(sum, want[k], 0.02);
        wcut_traces_destroy(t);
    }
    /* a plane that touches at two points cuts two circles that cross there (Villarceau 1848) */
    wcut_traces *t = NULL;
    const double lean = asin(20.0 / 50);
    ck_assert_int_eq(wcut_surface_intersect_plane(s, origin, vec3(sin(lean), 0, -cos(lean)), 1e-3, &t), WCUT_OK);
    double sum = 0;
    for (int i = 0; i < t->count; i++) sum += trace_length(&t->trace[i]);
    ck_assert_double_eq_tol(sum, 4 * WCUT_PI * 50, 0.1);
    wcut_traces_destroy(t);
    /* beside it: nothing */
    ck_assert_int_eq(wcut_surface_intersect_plane(s, vec3(0, 0, 20.001), vec3(0, 0, 1), 1e-3, &t), WCUT_OK);
    ck_assert(t->count == 0 && t->touching == 0);
    wcut_traces_destroy(t);
    /* just inside: two circles a hair apart */
    ck_assert_int_eq(wcut_surface_intersect_plane(s, vec3(0, 0, 20 - 1e-7), vec3(0, 0, 1), 1e-3, &t), WCUT_OK);
    ck_assert(t->count == 2 && t->trace[0].closed && t->trace[1].closed);
    wcut_traces_destroy(t);
    wcut_surface_destroy(s);
}

TEST(a_plane_that_touches_along_a_circle_ends_in_good_time) {
    wcut_surface *s = shape_torus(50, 20);
    wcut_traces *t = NULL;
    const wcut_status status = wcut_surface_intersect_plane(s, vec3(0, 0, 20), vec3(0, 0, 1), 1e-3, &t);
    ck_assert(status == WCUT_OK || status == WCUT_NOT_CONVERGED);
    if (status == WCUT_OK) printf("touching along a circle: %d curves, %d places\n", t->count, t->touching);
    if (status == WCUT_OK) wcut_traces_destroy(t);
    wcut_surface_destroy(s);
}

static wcut_surface *crumpled(wcut_random *random, int stations, int nodes, double height) {
    wcut_vec3 *x = malloc((size_t)stations * (size_t)nodes * sizeof *x);
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) x[j * nodes + i] = vec3(10 * i, 10 * j, height * wcut_random_normal(random));
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(stations, nodes, x, 0, &s, NULL, NULL), WCUT_OK);
    free(x);
    return s;
}

/* how often polylines pass u = at (or v = at) */
static int passes(const wcut_traces *t, int direction, double at) {
    int count = 0;
    for (int k = 0; k < t->count; k++) {
        const wcut_trace *r = &t->trace[k];
        for (int i = 0; i + 1 < r->count + r->closed; i++)
            count += (r->uv[2 * i + direction] < at) != (r->uv[2 * ((i + 1) % r->count) + direction] < at);
    }
    return count;
}

TEST(no_curve_of_a_crumpled_sheet_is_missed) {
    enum { LINES = 40, SAMPLES = 4000 };
    wcut_random random = wcut_random_seed(62);
    int curves = 0, closed = 0;
    for (int trial = 0; trial < 8; trial++) {
        wcut_surface *s = crumpled(&random, 14, 17, 5);
        const wcut_vec3 point = {70, 60, 0.5}, normal = {0.02 * trial, 0.01, 1};
        wcut_traces *t = NULL;
        ck_assert_int_eq(wcut_surface_intersect_plane(s, point, normal, 1e-3, &t), WCUT_OK);
        ck_assert(t->loose == 0 && t->touching == 0);
        for (int k = 0; k < t->count; k++) {
            check_trace(s, &t->trace[k], point, normal);
            curves++, closed += t->trace[k].closed;
        }
        for (int d = 0; d < 2; d++)
            for (int line = 0; line < LINES; line++) {
                const double at = wcut_random_uniform(&random);
                int changes = 0;
                double before = 0;
                for (int i = 0; i <= SAMPLES; i++) {
                    wcut_vec3 p;
                    const double other = (double)i / SAMPLES;
                    wcut_surface_eval(s, d ? other : at, d ? at : other, 0, &p);
                    const double height = vec3_dot(vec3_sub(p, point), normal);
                    changes += i > 0 && (height < 0) != (before < 0);
                    before = height;
                }
                ck_assert_msg(changes == passes(t, d, at), "trial %d: %d crossings, %d found", trial, changes,
                              passes(t, d, at));
            }
        wcut_traces_destroy(t);
        wcut_surface_destroy(s);
    }
    printf("%d curves, %d of them closed\n", curves, closed);
    ck_assert(closed > 50 && curves > closed);
}

TEST(chords_stay_within_the_tolerance) {
    wcut_random random = wcut_random_seed(63);
    wcut_surface *s = crumpled(&random, 9, 9, 8);
    wcut_traces *coarse = NULL, *fine = NULL;
    ck_assert_int_eq(wcut_surface_intersect_plane(s, vec3(0, 0, 1), vec3(0, 0, 1), 0.05, &coarse), WCUT_OK);
    ck_assert_int_eq(wcut_surface_intersect_plane(s, vec3(0, 0, 1), vec3(0, 0, 1), 1e-5, &fine), WCUT_OK);
    ck_assert_int_eq(coarse->count, fine->count);
    double max = 0;
    for (int k = 0; k < fine->count; k++) /* every point of the fine curves is near a chord of the coarse ones */
        for (int i = 0; i < fine->trace[k].count; i++) {
            double min = INFINITY;
            for (int n = 0; n < coarse->count; n++)
                for (int c = 0; c + 1 < coarse->trace[n].count + coarse->trace[n].closed; c++) {
                    const wcut_vec3 a = coarse->trace[n].point[c],
                                    side = vec3_sub(coarse->trace[n].point[(c + 1) % coarse->trace[n].count], a),
                                    to = vec3_sub(fine->trace[k].point[i], a);
                    const double share = clamp(vec3_dot(to, side) / vec3_dot(side, side), 0, 1);
                    min = fmin(min, vec3_length(vec3_add_scaled(to, -share, side)));
                }
            max = fmax(max, min);
        }
    printf("chords of curves at 0.05 mm: off by %.4f mm\n", max);
    ck_assert_double_le(max, 0.05);
    wcut_traces_destroy(coarse);
    wcut_traces_destroy(fine);
    wcut_surface_destroy(s);
}

TEST(a_sheet_through_a_block_has_a_curve_on_each_side_and_their_ends_meet) {
    enum { STATIONS = 50, NODES = 30 };
    static wcut_vec3 x[STATIONS * NODES];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) x[j * NODES + i] = sheet_point(i / (NODES - 1.0), j / (STATIONS - 1.0));
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, x, 0, &s, NULL, NULL), WCUT_OK);
    const wcut_box block = {{50, 50, 0}, {350, 700, 400}};
    wcut_traces *t = NULL;
    ck_assert_int_eq(wcut_surface_intersect_box(s, &block, 1e-3, &t), WCUT_OK);
    ck_assert_int_eq(t->count, 4);
    int seen = 0;
    for (int k = 0; k < 4; k++) {
        const wcut_trace *a = &t->trace[k];
        seen |= 1 << a->face;
        ck_assert(!a->closed);
        for (int e = 0; e < 2; e++) {
            const wcut_vec3 end = a->point[e ? a->count - 1 : 0];
            double nearest = INFINITY;
            for (int n = 0; n < 4; n++)
                if (n != k)
                    nearest = fmin(nearest, fmin(vec3_distance(end, t->trace[n].point[0]),
                                                 vec3_distance(end, t->trace[n].point[t->trace[n].count - 1])));
            ck_assert_double_le(nearest, 1e-9);
        }
        for (int i = 0; i < a->count; i++) {
            const wcut_vec3 p = a->point[i];
            ck_assert(p.x >= 50 - 1e-9 && p.x <= 350 + 1e-9 && p.y >= 50 - 1e-9 && p.y <= 700 + 1e-9);
        }
    }
    ck_assert_int_eq(seen, 15);
    wcut_traces_destroy(t);
    /* a block that the sheet leaves through the top, one beside it, and one whose side cuts loops off the hills */
    const wcut_box low = {{50, 50, 0}, {350, 700, 160}}, aside = {{1000, 0, 0}, {1100, 10, 10}};
    ck_assert_int_eq(wcut_surface_intersect_box(s, &low, 1e-3, &t), WCUT_OK);
    int top = 0;
    for (int k = 0; k < t->count; k++) top += t->trace[k].face == 5;
    ck_assert_int_gt(top, 0);
    wcut_traces_destroy(t);
    ck_assert_int_eq(wcut_surface_intersect_box(s, &aside, 1e-3, &t), WCUT_OK);
    ck_assert_int_eq(t->count, 0);
    wcut_traces_destroy(t);
    wcut_surface_destroy(s);
}

/* every line closed, its points on the block's skin, steps no longer than those it came from */
static void check_outline(const wcut_traces *parts, const wcut_box *block, int lines) {
    wcut_traces *t = NULL;
    double length = 0, joined = 0;
    ck_assert_int_eq(wcut_traces_join(parts, 1e-6, &t), WCUT_OK);
    ck_assert_int_eq(t->count, lines);
    ck_assert_int_eq(t->loose, 0);
    for (int k = 0; k < parts->count; k++)
        for (int i = 0; i + 1 < parts->trace[k].count + parts->trace[k].closed; i++)
            length += vec3_distance(parts->trace[k].point[i], parts->trace[k].point[(i + 1) % parts->trace[k].count]);
    for (int k = 0; k < t->count; k++) {
        const wcut_trace *a = &t->trace[k];
        ck_assert(a->closed);
        for (int i = 0; i < a->count; i++) {
            const wcut_vec3 p = a->point[i];
            const double step = vec3_distance(p, a->point[(i + 1) % a->count]);
            const double x = fmin(fabs(p.x - block->low.x), fabs(p.x - block->high.x));
            const double y = fmin(fabs(p.y - block->low.y), fabs(p.y - block->high.y));
            ck_assert_double_le(fmin(fmin(x, y), fabs(p.z - block->high.z)), 1e-9);
            ck_assert_double_gt(step, 0);
            joined += step;
        }
    }
    ck_assert_double_le(fabs(joined - length), 1e-9 * length);
    wcut_traces_destroy(t);
}

TEST(curves_on_a_blocks_faces_join_into_closed_outlines) {
    enum { STATIONS = 50, NODES = 30 };
    static wcut_vec3 x[STATIONS * NODES];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) x[j * NODES + i] = sheet_point(i / (NODES - 1.0), j / (STATIONS - 1.0));
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, x, 0, &s, NULL, NULL), WCUT_OK);
    const wcut_box block = {{50, 50, 0}, {350, 700, 400}}, low = {{50, 50, 0}, {350, 700, 160}};
    wcut_traces *t = NULL, *joined = NULL;
    ck_assert_int_eq(wcut_surface_intersect_box(s, &block, 1e-3, &t), WCUT_OK);
    check_outline(t, &block, 1);
    ck_assert_int_eq(wcut_traces_join(t, 1e-6, &joined), WCUT_OK);
    ck_assert_int_eq(joined->trace[0].face, -1);
    wcut_traces_destroy(joined);
    /* of a line that is taken out the ends stay free */
    wcut_traces max = *t;
    max.count--;
    ck_assert_int_eq(wcut_traces_join(&max, 1e-6, &joined), WCUT_OK);
    ck_assert(joined->count == 1 && joined->loose == 2 && !joined->trace[0].closed);
    wcut_traces_destroy(joined);
    wcut_traces_destroy(t);
    /* cut through the top, in as many loops as areas that stay below it, and those that pass the top alone */
    ck_assert_int_eq(wcut_surface_intersect_box(s, &low, 1e-3, &t), WCUT_OK);
    ck_assert_int_eq(wcut_traces_join(t, 1e-6, &joined), WCUT_OK);
    const int lines = joined->count;
    ck_assert(lines >= 1 && lines < t->count);
    wcut_traces_destroy(joined);
    check_outline(t, &low, lines);

    wcut_traces *const mark = (wcut_traces *)&s, *kept = mark;
    ck_assert_int_eq(wcut_traces_join(NULL, 1, &kept), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_traces_join(t, 0, &kept), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_traces_join(t, NAN, &kept), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_traces_join(t, 1, NULL), WCUT_BAD_ARGUMENT);
    EACH_FAILED_ALLOCATION(wcut_traces_join(t, 1e-6, &kept), kept == mark);
    wcut_traces_destroy(kept);
    wcut_traces_destroy(t);
    wcut_surface_destroy(s);
}

TEST(what_cannot_be_intersected_is_refused_and_nothing_is_written) {
    wcut_surface *s = shape_octant();
    wcut_traces *const mark = (wcut_traces *)&s, *t = mark;
    const wcut_vec3 o = {0, 0, 0.5}, n = {0, 0, 1}, bad = {NAN, 0, 0};
    const wcut_box block = {{0, 0, 0}, {1, 1, 0.5}}, flat = {{0, 0, 0}, {1, 0, 1}},
                   open = {{0, 0, 0}, {1, 1, INFINITY}};
    ck_assert_int_eq(wcut_surface_intersect_plane(NULL, o, n, 1, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_intersect_plane(s, bad, n, 1, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_intersect_plane(s, o, bad, 1, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_intersect_plane(s, o, vec3(0, 0, 0), 1, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_intersect_plane(s, o, n, 0, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_intersect_plane(s, o, n, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_intersect_box(NULL, &block, 1, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_intersect_box(s, &flat, 1, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_intersect_box(s, &open, 1, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_intersect_box(s, &block, NAN, &t), WCUT_BAD_ARGUMENT);
    for (int which = 0; which < 2; which++) {
        EACH_FAILED_ALLOCATION(
            which ? wcut_surface_intersect_box(s, &block, 1e-2, &t) : wcut_surface_intersect_plane(s, o, n, 1e-2, &t),
            t == mark);
        wcut_traces_destroy(t);
        t = mark;
    }
    wcut_traces_destroy(NULL);
    wcut_surface_destroy(s);
}
