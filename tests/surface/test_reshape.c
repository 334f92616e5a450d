/* labels: unit property
   Elevation, knot removal, joining and moving: the same points, or a bound on their distance that dense samples keep. */
#include <stdio.h>
#include <wirecut/curve_measure.h>
#include <wirecut/reshape.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

/* a curve of any degree with knots up to full multiplicity, clamped or not */
static wcut_curve *random_curve(wcut_random *random, int degree, bool rational, bool clamped) {
    enum { MAX = 24 };
    double knots[MAX + WCUT_DEGREE_MAX + 1], weight[MAX];
    wcut_vec3 control[MAX];
    const int count = degree + 2 + wcut_random_below(random, MAX - degree - 1);
    double u = 2;
    for (int k = 0; k < count + degree + 1; k++) {
        knots[k] = u;
        const bool end = clamped && (k < degree || k >= count);
        const bool again = k >= degree && k > 0 && wcut_random_below(random, 3) == 0 && degree > 1 &&
                           (k < degree || knots[k - degree + 1] < knots[k]);
        if (!end && (!again || k == degree || k == count - 1)) u += 0.1 + wcut_random_uniform(random);
    }
    for (int k = 0; k < count; k++) {
        control[k] = vec3(30 * k, 100 * wcut_random_uniform(random), 100 * wcut_random_uniform(random));
        weight[k] = 0.4 + wcut_random_uniform(random);
    }
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(degree, count, knots, control, rational ? weight : NULL, &c), WCUT_OK);
    return c;
}

/* the largest distance at equal parameters */
static double curves_apart(const wcut_curve *a, const wcut_curve *b) {
    double first, last, max = 0;
    wcut_curve_domain(a, &first, &last);
    for (int i = 0; i <= 2000; i++) {
        wcut_vec3 p, q;
        const double u = first + (last - first) * i / 2000;
        ck_assert_int_eq(wcut_curve_eval(a, u, 0, &p), WCUT_OK);
        ck_assert_int_eq(wcut_curve_eval(b, u, 0, &q), WCUT_OK);
        max = fmax(max, vec3_distance(p, q));
    }
    return max;
}

static double surfaces_apart(const wcut_surface *a, const wcut_surface *b) {
    double first[2], last[2], max = 0;
    wcut_surface_domain(a, first, last);
    for (int i = 0; i <= 150; i++)
        for (int j = 0; j <= 150; j++) {
            wcut_vec3 p, q;
            const double u = first[0] + (last[0] - first[0]) * i / 150, v = first[1] + (last[1] - first[1]) * j / 150;
            ck_assert_int_eq(wcut_surface_eval(a, u, v, 0, &p), WCUT_OK);
            ck_assert_int_eq(wcut_surface_eval(b, u, v, 0, &q), WCUT_OK);
            max = fmax(max, vec3_distance(p, q));
        }
    return max;
}

TEST(a_curve_of_a_higher_degree_is_the_same) {
    wcut_random random = wcut_random_seed(4);
    for (int trial = 0; trial < 300; trial++) {
        const int degree = 1 + trial % (WCUT_DEGREE_MAX - 1);
        wcut_curve *c = random_curve(&random, degree, trial % 2, trial % 3), *r = NULL;
        const int times = 1 + trial % (WCUT_DEGREE_MAX - degree);
        ck_assert_int_eq(wcut_curve_elevate(c, times, &r), WCUT_OK);
        ck_assert(r->degree == degree + times && (r->weights != NULL) == (trial % 2 != 0));
        ck_assert_double_le(curves_apart(c, r), 1e-9);
        wcut_curve_destroy(r);
        wcut_curve_destroy(c);
    }
}

TEST(a_surface_of_a_higher_degree_is_the_same) {
    wcut_surface *s = shape_torus(50, 20), *r = NULL, *t = NULL;
    ck_assert_int_eq(wcut_surface_elevate(s, WCUT_DIRECTION_U, 2, &r), WCUT_OK);
    ck_assert_int_eq(wcut_surface_elevate(r, WCUT_DIRECTION_V, 1, &t), WCUT_OK);
    ck_assert(t->degree_u == 4 && t->degree_v == 3);
    ck_assert_double_le(surfaces_apart(s, t), 1e-12);
    wcut_surface_destroy(t);
    wcut_surface_destroy(r);
    wcut_surface_destroy(s);
}

TEST(knots_put_in_are_all_found_again) {
    wcut_random random = wcut_random_seed(5);
    for (int trial = 0; trial < 100; trial++) {
        const int degree = 1 + trial % WCUT_DEGREE_MAX;
        wcut_curve *c = random_curve(&random, degree, trial % 2, true), *more = NULL, *r = NULL;
        double first, last, error = 999;
        wcut_curve_domain(c, &first, &last);
        for (int k = 0; k < 12; k++) {
            const double u = first + (last - first) * (0.01 + 0.98 * wcut_random_uniform(&random));
            wcut_curve *base = more ? more : c, *next = NULL;
            ck_assert_int_eq(wcut_curve_insert_knot(base, u, 1, &next), WCUT_OK);
            if (more) wcut_curve_destroy(more);
            more = next;
        }
        ck_assert_int_eq(wcut_curve_remove_knots(more, 1e-7, &r, &error), WCUT_OK);
        ck_assert_msg(r->control_count <= c->control_count, "degree %d: %d, not %d", degree, r->control_count,
                      c->control_count);
        ck_assert_double_le(error, 1e-7);
        ck_assert_double_le(curves_apart(c, r), error + 1e-10);
        wcut_curve_destroy(r);
        wcut_curve_destroy(more);
        wcut_curve_destroy(c);
    }
}

TEST(what_knot_removal_changes_stays_within_its_bound) {
    enum { COUNT = 400 };
    wcut_vec3 p[COUNT];
    for (int i = 0; i < COUNT; i++) {
        const double t = i / (COUNT - 1.0);
        p[i] = vec3(900 * t, 80 * sin(9 * t) + 15 * exp(-pow((t - 0.6) / 0.02, 2)), 30 * cos(4 * t));
    }
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_interpolate(COUNT, p, &c), WCUT_OK);
    int before = COUNT;
    for (double tolerance = 1e-6; tolerance < 1; tolerance *= 10) {
        wcut_curve *r = NULL;
        double error = 999;
        ck_assert_int_eq(wcut_curve_remove_knots(c, tolerance, &r, &error), WCUT_OK);
        const double apart_max = curves_apart(c, r);
        printf("tolerance %g mm: %d of %d control points, bound %.3g, sampled %.3g mm\n", tolerance, r->control_count,
               COUNT, error, apart_max);
        ck_assert(error <= tolerance && apart_max <= error && r->control_count <= before);
        before = r->control_count;
        ck_assert_double_le(apart(r->control[0], p[0]), 1e-12);
        ck_assert_double_le(apart(r->control[r->control_count - 1], p[COUNT - 1]), 1e-12);
        wcut_curve_destroy(r);
    }
    ck_assert_int_lt(before, 50);
    wcut_curve_destroy(c);
}

TEST(a_lofted_sheet_loses_most_of_its_knots) {
    enum { STATIONS = 60, NODES = 40 };
    static wcut_vec3 x[STATIONS * NODES];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) x[j * NODES + i] = sheet_point(i / (NODES - 1.0), j / (STATIONS - 1.0));
    wcut_surface *s = NULL, *r = NULL;
    double error = 999;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, x, 0, &s, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_surface_remove_knots(s, 0.02, &r, &error), WCUT_OK);
    const double max = surfaces_apart(s, r);
    printf("sheet: %d x %d of %d x %d control points, bound %.4f, sampled %.4f mm\n", r->count_v, r->count_u,
           s->count_v, s->count_u, error, max);
    ck_assert(error <= 0.02 && max <= error && 5 * r->count_u * r->count_v < s->count_u * s->count_v);
    wcut_surface_destroy(r);
    wcut_surface_destroy(s);
    s = shape_torus(50, 20); /* rational: its knots are all needed, or the bound says what they were worth */
    ck_assert_int_eq(wcut_surface_remove_knots(s, 1e-3, &r, &error), WCUT_OK);
    ck_assert(error <= 1e-3 && surfaces_apart(s, r) <= error + 1e-12);
    wcut_surface_destroy(r);
    wcut_surface_destroy(s);
}

TEST(what_was_split_is_joined_again) {
    wcut_random random = wcut_random_seed(6);
    for (int trial = 0; trial < 60; trial++) {
        wcut_curve *c = random_curve(&random, 1 + trial % WCUT_DEGREE_MAX, trial % 2, true), *part[3] = {NULL}, *rest;
        double first, last, gap = 999;
        wcut_curve_domain(c, &first, &last);
        ck_assert_int_eq(wcut_curve_split(c, first + 0.3 * (last - first), &part[0], &rest), WCUT_OK);
        ck_assert_int_eq(wcut_curve_split(rest, first + 0.71 * (last - first), &part[1], &part[2]), WCUT_OK);
        wcut_curve *r = NULL;
        ck_assert_int_eq(wcut_curve_join(3, (const wcut_curve *const *)part, 1e-9, &r, &gap), WCUT_OK);
        ck_assert_double_le(gap, 1e-9);
        double from, to;
        wcut_curve_domain(r, &from, &to);
        ck_assert(from == first && fabs(to - last) < 1e-9 * last);
        ck_assert_double_le(curves_apart(c, r), 1e-6);
        for (int k = 0; k < 3; k++) wcut_curve_destroy(part[k]);
        wcut_curve_destroy(rest);
        wcut_curve_destroy(r);
        wcut_curve_destroy(c);
    }
}

TEST(curves_of_unlike_degree_and_weights_are_joined_and_wide_gaps_are_told) {
    const double line_knots[4] = {5, 5, 9, 9};
    wcut_vec3 line[2] = {{1, 0, 0}, {1, -4, 0}}, arc[3];
    for (int i = 0; i < 3; i++) arc[2 - i] = vec3(quarter_x[i], quarter_y[i], 0); /* from (0, 1) to (1, 0) */
    const double weight[3] = {2, 1, 1};
    wcut_curve *a = NULL, *b = NULL, *r = NULL;
    ck_assert_int_eq(wcut_curve_create(2, 3, quarter_knots, arc, weight, &a), WCUT_OK);
    ck_assert_int_eq(wcut_curve_create(1, 2, line_knots, line, NULL, &b), WCUT_OK);
    const wcut_curve *pair[2] = {a, b};
    double gap = 999, length = 999;
    ck_assert_int_eq(wcut_curve_join(2, pair, 1e-12, &r, &gap), WCUT_OK);
    ck_assert_int_eq(wcut_curve_length(r, 0, 1e9, &length), WCUT_OK);
    ck_assert_double_eq_tol(length, WCUT_PI / 2 + 4, 1e-10);
    wcut_vec3 before[2], after[2];
    ck_assert_int_eq(wcut_curve_eval(r, 1 - 1e-9, 1, before), WCUT_OK);
    ck_assert_int_eq(wcut_curve_eval(r, 1 + 1e-9, 1, after), WCUT_OK);
    ck_assert_double_le(apart(before[1], after[1]), 1e-7); /* tangent and equally fast */
    wcut_curve_destroy(r);
    b->control[0].x += 0.5;
    wcut_curve *const mark = (wcut_curve *)&gap;
    r = mark;
    ck_assert_int_eq(wcut_curve_join(2, pair, 0.4, &r, &gap), WCUT_DEGENERATE);
    ck_assert(r == mark && fabs(gap - 0.5) < 1e-12);
    wcut_curve_destroy(a);
    wcut_curve_destroy(b);
}

TEST(halves_of_a_surface_with_unlike_knots_are_joined) {
    for (int d = 0; d < 2; d++)
        for (int which = 0; which < 2; which++) {
            const wcut_direction along = d ? WCUT_DIRECTION_V : WCUT_DIRECTION_U,
                                 across = d ? WCUT_DIRECTION_U : WCUT_DIRECTION_V;
            wcut_surface *s = which ? shape_octant() : shape_torus(50, 20), *low, *high, *more, *max, *r = NULL;
            ck_assert_int_eq(wcut_surface_split(s, along, 0.4, &low, &high), WCUT_OK);
            ck_assert_int_eq(wcut_surface_insert_knot(high, across, 0.37, 1, &more), WCUT_OK);
            ck_assert_int_eq(wcut_surface_elevate(more, across, 1, &max), WCUT_OK);
            double gap = 999;
            ck_assert_int_eq(wcut_surface_join(low, max, along, 1e-9, &r, &gap), WCUT_OK);
            ck_assert_double_le(gap, 1e-9);
            ck_assert_double_le(surfaces_apart(s, r), 1e-9);
            wcut_surface_destroy(r);
            r = s;
            for (int k = 0; k < max->count_u * max->count_v; k++) max->control[k].z += 1;
            ck_assert_int_eq(wcut_surface_join(low, max, along, 0.5, &r, &gap), WCUT_DEGENERATE);
            ck_assert(r == s && fabs(gap - 1) < 1e-9);
            for (int k = 0; k < max->count_u * max->count_v; k++) max->control[k].z -= 1;
            for (int k = 0; k < max->count_u; k++) max->weights[k] *= 1 + 0.1 * k;
            if (d == 1) ck_assert_int_eq(wcut_surface_join(low, max, along, 1e9, &r, &gap), WCUT_DEGENERATE);
            wcut_surface *const all[] = {s, low, high, more, max};
            for (int k = 0; k < 5; k++) wcut_surface_destroy(all[k]);
        }
}

TEST(an_affine_map_moves_every_point) {
    const wcut_affine map = {{0.8, -0.6, 0}, {0.6, 0.8, 0.3}, {0, 0.1, -2}, {5, -7, 11}};
    wcut_surface *s = shape_torus(50, 20), *r = NULL;
    ck_assert_int_eq(wcut_surface_transform(s, &map, &r), WCUT_OK);
    wcut_random random = wcut_random_seed(7);
    for (int k = 0; k < 200; k++) {
        const double u = wcut_random_uniform(&random), v = wcut_random_uniform(&random);
        wcut_vec3 p, q;
        ck_assert_int_eq(wcut_surface_eval(s, u, v, 0, &p), WCUT_OK);
        ck_assert_int_eq(wcut_surface_eval(r, u, v, 0, &q), WCUT_OK);
        const wcut_vec3 want = vec3_add(vec3(vec3_dot(map.x, p), vec3_dot(map.y, p), vec3_dot(map.z, p)), map.shift);
        ck_assert_double_le(apart(q, want), 1e-12);
    }
    wcut_surface_destroy(r);
    wcut_surface_destroy(s);
}

TEST(what_cannot_be_reshaped_is_refused_and_nothing_is_written) {
    wcut_random random = wcut_random_seed(8);
    wcut_curve *c = random_curve(&random, 6, false, true), *const mark = (wcut_curve *)&random, *r = mark;
    wcut_surface *s = shape_octant(), *const place = (wcut_surface *)&random, *t = place;
    const wcut_curve *none[2] = {c, NULL};
    double error = 999, gap = 999;
    const wcut_affine huge = {{1e308, 1e308, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}},
                      bad = {{NAN, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    ck_assert_int_eq(wcut_curve_elevate(NULL, 1, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_elevate(c, 0, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_elevate(c, 2, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_elevate(c, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_remove_knots(c, 0, &r, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_remove_knots(NULL, 1, &r, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_join(0, none, 1, &r, &gap), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_join(2, none, 1, &r, &gap), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_join(1, none, -1, &r, &gap), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_transform(c, NULL, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_transform(c, &bad, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_transform(c, &huge, &r), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_surface_elevate(s, (wcut_direction)7, 1, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_elevate(s, WCUT_DIRECTION_U, 6, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_remove_knots(s, NAN, &t, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_join(s, NULL, WCUT_DIRECTION_U, 1, &t, &gap), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_join(s, s, (wcut_direction)7, 1, &t, &gap), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_join(s, s, WCUT_DIRECTION_U, NAN, &t, &gap), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_transform(s, &bad, &t), WCUT_BAD_ARGUMENT);
    for (int k = 0; k < 9; k++) s->control[k].x = 2;
    ck_assert_int_eq(wcut_surface_transform(s, &huge, &t), WCUT_DEGENERATE);
    ck_assert(r == mark && t == place && error == 999 && gap == 999);
    wcut_curve_destroy(c);
    wcut_surface_destroy(s);
}

static wcut_status reshape(int which, const wcut_surface *s, const wcut_curve *c, wcut_surface **t, wcut_curve **r,
                           double *value) {
    const wcut_affine same = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    const wcut_curve *one[1] = {c};
    switch (which) {
        case 0:
            return wcut_curve_elevate(c, 2, r);
        case 1:
            return wcut_curve_remove_knots(c, 1, r, value);
        case 2:
            return wcut_curve_join(1, one, 0, r, value);
        case 3:
            return wcut_curve_transform(c, &same, r);
        case 4:
            return wcut_surface_elevate(s, WCUT_DIRECTION_V, 1, t);
        case 5:
            return wcut_surface_remove_knots(s, 1, t, value);
        case 6:
            return wcut_surface_join(s, s, WCUT_DIRECTION_U, 1e9, t, value);
        default:
            return wcut_surface_transform(s, &same, t);
    }
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    wcut_random random = wcut_random_seed(9);
    wcut_curve *c = random_curve(&random, 3, true, false);
    wcut_surface *s = shape_cylinder(20, 50);
    for (int which = 0; which < 8; which++) {
        wcut_curve *const mark = (wcut_curve *)&random, *r = mark;
        wcut_surface *const place = (wcut_surface *)&random, *t = place;
        double value = 999;
        EACH_FAILED_ALLOCATION(reshape(which, s, c, &t, &r, &value), r == mark && t == place);
        if (r != mark) wcut_curve_destroy(r);
        if (t != place) wcut_surface_destroy(t);
    }
    wcut_curve_destroy(c);
    wcut_surface_destroy(s);
}
