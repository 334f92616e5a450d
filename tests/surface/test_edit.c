/* labels: unit property
   Edited curves and surfaces are the same shape, point by point, and a failure leaves nothing behind. */
#include <wirecut/edit.h>

#include "base/alloc.h"
#include "surface/shapes.h"
#include "test.h"

/* a rational curve of degree p over knots that are not clamped, one of them double */
static wcut_curve *wild_curve(int p) {
    enum { COUNT = 11 };
    double knots[COUNT + WCUT_DEGREE_MAX + 1], weights[COUNT];
    wcut_vec3 control[COUNT];
    for (int k = 0; k < COUNT + p + 1; k++) knots[k] = k - p + 0.3 * sin(k);
    if (p > 1) knots[9] = knots[8];
    for (int k = 0; k < COUNT; k++) {
        control[k] = vec3(10 * k, 20 * sin(k), 5 * cos(3 * k));
        weights[k] = 1 + 0.5 * cos(k);
    }
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(p, COUNT, knots, control, weights, &c), WCUT_OK);
    return c;
}

/* b(u) = a(turn ? mirrored u : u) over b's domain, derivatives too */
static void same_curve(const wcut_curve *a, const wcut_curve *b, bool turn) {
    double first, last, from, to;
    wcut_curve_domain(b, &first, &last);
    wcut_curve_domain(a, &from, &to);
    for (int i = 0; i <= 60; i++) {
        const double u = first + (last - first) * i / 60;
        wcut_vec3 p[2], q[2];
        ck_assert_int_eq(wcut_curve_eval(a, turn ? from + to - u : u, 1, p), WCUT_OK);
        ck_assert_int_eq(wcut_curve_eval(b, u, 1, q), WCUT_OK);
        ck_assert_double_le(apart(p[0], q[0]), 1e-11);
        if (a->degree > 1 && i > 0 && i < 60) ck_assert_double_le(apart(p[1], vec3_scale(turn ? -1 : 1, q[1])), 1e-9);
    }
}

TEST(a_curve_with_more_knots_or_in_parts_or_backwards_is_the_same) {
    for (int p = 1; p <= WCUT_DEGREE_MAX; p++) {
        wcut_curve *c = wild_curve(p), *more = NULL, *low = NULL, *high = NULL;
        double first, last, at, end;
        wcut_curve_domain(c, &first, &last);
        for (int k = 0; k < 3; k++) {
            /* anywhere, at a knot, at the double knot */
            const double u = k == 0 ? first + 0.37 * (last - first) : c->knots[k == 1 ? p + 1 : 8];
            if (!(u > first && u < last)) continue;
            int times = p;
            for (int n = 0; n < c->control_count + p + 1; n++) times -= c->knots[n] == u;
            for (int n = 1; n <= times; n++) {
                ck_assert_int_eq(wcut_curve_insert_knot(c, u, n, &more), WCUT_OK);
                ck_assert_int_eq(more->control_count, c->control_count + n);
                same_curve(c, more, false);
                wcut_curve_destroy(more);
            }
            ck_assert_int_eq(wcut_curve_insert_knot(c, u, times + 1, &more), WCUT_BAD_ARGUMENT);
            ck_assert_int_eq(wcut_curve_split(c, u, &low, &high), WCUT_OK);
            wcut_curve_domain(low, &at, &end);
            ck_assert(at == first && end == u);
            wcut_curve_domain(high, &at, &end);
            ck_assert(at == u && end == last);
            same_curve(c, low, false);
            same_curve(c, high, false);
            wcut_curve_destroy(low);
            wcut_curve_destroy(high);
        }
        ck_assert_int_eq(wcut_curve_reverse(c, &more), WCUT_OK);
        same_curve(c, more, true);
        wcut_curve_destroy(more);
        wcut_curve_destroy(c);
    }
}

/* b(u, v) = a(map(u, v)): 0 as it is, 1 u backwards, 2 v backwards, 3 u and v exchanged */
static void same_surface(const wcut_surface *a, const wcut_surface *b, int map) {
    double first[2], last[2];
    wcut_surface_domain(b, first, last);
    for (int i = 0; i <= 23; i++)
        for (int j = 0; j <= 23; j++) {
            const double u = first[0] + (last[0] - first[0]) * i / 23, v = first[1] + (last[1] - first[1]) * j / 23;
            const double from_u = map == 3 ? v : map == 1 ? 1 - u : u, from_v = map == 3 ? u : map == 2 ? 1 - v : v;
            wcut_vec3 p, q;
            ck_assert_int_eq(wcut_surface_eval(a, from_u, from_v, 0, &p), WCUT_OK);
            ck_assert_int_eq(wcut_surface_eval(b, u, v, 0, &q), WCUT_OK);
            ck_assert_double_le(apart(p, q), 1e-12 * 100);
        }
}

/* a polynomial surface of unlike degrees */
static wcut_surface *wave(void) {
    const double knots_u[8] = {0, 0, 0, 0.3, 0.6, 1, 1, 1}, knots_v[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    wcut_vec3 control[20];
    for (int k = 0; k < 20; k++) control[k] = vec3(10 * (k % 5), 20 * (k / 5.0), 7 * sin(k * k));
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_create(2, 3, 5, 4, knots_u, knots_v, control, NULL, &s), WCUT_OK);
    return s;
}

TEST(a_surface_with_more_knots_or_in_parts_or_turned_is_the_same) {
    for (int which = 0; which < 2; which++) {
        wcut_surface *s = which ? wave() : shape_torus(50, 20), *r = NULL, *low = NULL, *high = NULL;
        for (int d = 0; d < 2; d++) {
            const wcut_direction direction = d ? WCUT_DIRECTION_V : WCUT_DIRECTION_U;
            ck_assert_int_eq(wcut_surface_insert_knot(s, direction, 0.42, 2, &r), WCUT_OK);
            ck_assert_int_eq((d ? r->count_v : r->count_u), (d ? s->count_v : s->count_u) + 2);
            same_surface(s, r, 0);
            wcut_surface_destroy(r);
            ck_assert_int_eq(wcut_surface_split(s, direction, 0.25, &low, &high), WCUT_OK);
            double first[2], last[2];
            wcut_surface_domain(low, first, last);
            ck_assert(first[d] == 0 && last[d] == 0.25 && last[1 - d] == 1);
            wcut_surface_domain(high, first, last);
            ck_assert(first[d] == 0.25 && last[d] == 1 && first[1 - d] == 0);
            same_surface(s, low, 0);
            same_surface(s, high, 0);
            wcut_surface_destroy(low);
            wcut_surface_destroy(high);
            ck_assert_int_eq(wcut_surface_reverse(s, direction, &r), WCUT_OK);
            same_surface(s, r, d + 1);
            wcut_surface_destroy(r);
        }
        ck_assert_int_eq(wcut_surface_transpose(s, &r), WCUT_OK);
        same_surface(s, r, 3);
        wcut_surface_destroy(r);
        wcut_surface_destroy(s);
    }
}

TEST(an_iso_curve_lies_on_its_surface) {
    for (int which = 0; which < 2; which++) {
        wcut_surface *s = which ? wave() : shape_torus(50, 20);
        for (int k = 0; k <= 10; k++)
            for (int d = 0; d < 2; d++) {
                wcut_curve *c = NULL;
                const double at = k / 10.0;
                ck_assert_int_eq(wcut_surface_iso_curve(s, d ? WCUT_DIRECTION_V : WCUT_DIRECTION_U, at, &c), WCUT_OK);
                for (int i = 0; i <= 30; i++) {
                    const double t = i / 30.0;
                    wcut_vec3 p, q;
                    ck_assert_int_eq(wcut_curve_eval(c, t, 0, &p), WCUT_OK);
                    ck_assert_int_eq(wcut_surface_eval(s, d ? at : t, d ? t : at, 0, &q), WCUT_OK);
                    ck_assert_double_le(apart(p, q), 1e-12 * 100);
                }
                wcut_curve_destroy(c);
            }
        wcut_surface_destroy(s);
    }
}

TEST(what_cannot_be_edited_is_refused_and_nothing_is_written) {
    wcut_curve *c = wild_curve(3), *const mark = c, *r = mark, *high = mark;
    wcut_surface *s = wave(), *const sheet = s, *t = sheet, *above = sheet;
    const double out[4] = {-9, 0, 1, NAN};
    double first, last;
    wcut_curve_domain(c, &first, &last);
    ck_assert_int_eq(wcut_curve_insert_knot(c, first, 1, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_insert_knot(c, NAN, 1, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_insert_knot(c, first + 1, 0, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_insert_knot(NULL, 1, 1, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_insert_knot(c, first + 1, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_split(c, last, &r, &high), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_split(c, first + 1, &r, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_reverse(NULL, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_reverse(c, NULL), WCUT_BAD_ARGUMENT);
    for (int k = 0; k < 4; k++) {
        ck_assert_int_eq(wcut_surface_insert_knot(s, WCUT_DIRECTION_U, out[k], 1, &t), WCUT_BAD_ARGUMENT);
        ck_assert_int_eq(wcut_surface_split(s, WCUT_DIRECTION_V, out[k], &t, &above), WCUT_BAD_ARGUMENT);
    }
    ck_assert_int_eq(wcut_surface_insert_knot(s, (wcut_direction)2, 0.5, 1, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_split(s, (wcut_direction)2, 0.5, &t, &above), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_split(NULL, WCUT_DIRECTION_U, 0.5, &t, &above), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_reverse(s, (wcut_direction)2, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_transpose(NULL, &t), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_iso_curve(s, WCUT_DIRECTION_U, 1.5, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_iso_curve(s, WCUT_DIRECTION_U, NAN, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_iso_curve(s, (wcut_direction)2, 0.5, &r), WCUT_BAD_ARGUMENT);
    ck_assert(r == mark && high == mark && t == sheet && above == sheet);
    wcut_curve_destroy(c);
    wcut_surface_destroy(s);
}

/* one of eight edits; what they made is freed */
static wcut_status edit(int which, const wcut_curve *c, const wcut_surface *s, wcut_curve *mark, wcut_surface *sheet) {
    wcut_curve *r = mark, *high = mark;
    wcut_surface *t = sheet, *above = sheet;
    wcut_status status = WCUT_INTERNAL;
    if (which == 0) status = wcut_curve_insert_knot(c, 3.14, 2, &r);
    if (which == 1) status = wcut_curve_split(c, 3.14, &r, &high);
    if (which == 2) status = wcut_curve_reverse(c, &r);
    if (which == 3) status = wcut_surface_insert_knot(s, WCUT_DIRECTION_U, 0.4, 1, &t);
    if (which == 4) status = wcut_surface_split(s, WCUT_DIRECTION_V, 0.4, &t, &above);
    if (which == 5) status = wcut_surface_reverse(s, WCUT_DIRECTION_V, &t);
    if (which == 6) status = wcut_surface_transpose(s, &t);
    if (which == 7) status = wcut_surface_iso_curve(s, WCUT_DIRECTION_V, 0.4, &r);
    if (status != WCUT_OK) ck_assert(r == mark && high == mark && t == sheet && above == sheet);
    if (r != mark) wcut_curve_destroy(r);
    if (high != mark) wcut_curve_destroy(high);
    if (t != sheet) wcut_surface_destroy(t);
    if (above != sheet) wcut_surface_destroy(above);
    return status;
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    wcut_curve *c = wild_curve(3);
    wcut_surface *s = shape_torus(50, 20);
    for (int which = 0; which < 8; which++) EACH_FAILED_ALLOCATION(edit(which, c, s, c, s), true);
    wcut_curve_destroy(c);
    wcut_surface_destroy(s);
}
