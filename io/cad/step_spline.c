/* B-spline curves and surfaces as STEP instances (ISO 10303-42): poles as they are, knots with multiplicities. */
#include <stdlib.h>

#include "io/cad/step_shape.h"

static size_t run_of(const double *knot, int at, int total) {
    int end = at + 1;
    while (end < total && knot[end] == knot[at]) end++;
    return (size_t)(end - at);
}

/* (4,1,1,4) */
static void put_multiplicities(wcut_part21 *p, const double *knot, int total) {
    const char *gap = "(";
    for (int k = 0, n = 1; k < total; n++) {
        const int run = (int)run_of(knot, k, total);
        wcut_text_print(p->text, "%s%d", gap, run);
        gap = n % 16 ? "," : ",\n";
        k += run;
    }
    wcut_text_put(p->text, ")", 1);
}

/* (0.,0.25,0.5,1.) */
static void put_knots(wcut_part21 *p, const double *knot, int total) {
    const char *gap = "(";
    for (int k = 0, n = 1; k < total; k += (int)run_of(knot, k, total), n++) {
        wcut_text_print(p->text, "%s", gap);
        wcut_p21_real(p, knot[k]);
        gap = n % 8 ? "," : ",\n";
    }
    wcut_text_put(p->text, ")", 1);
}

static wcut_id put_step_spline_points(wcut_part21 *p, const wcut_vec3 *point, int count) {
    const wcut_id first = p->last + 1;
    for (int k = 0; k < count; k++) wcut_p21_point(p, point[k]);
    return first;
}

/* ---- curves ---- */

wcut_id wcut_step_curve(wcut_part21 *p, const char *name, const wcut_curve *c) {
    /* the points stand before the curve that refers to them */
    const wcut_id first = put_step_spline_points(p, c->control, c->control_count);
    const int knots = c->control_count + c->degree + 1;
    const wcut_id id = wcut_p21_begin(p);

    /* a rational curve is a complex instance, a plain one a simple one */
    if (c->weights) {
        wcut_text_print(p->text, "(BOUNDED_CURVE()B_SPLINE_CURVE(%d,", c->degree);
    } else {
        wcut_text_print(p->text, "B_SPLINE_CURVE_WITH_KNOTS(");
        wcut_p21_string(p, name);
        wcut_text_print(p->text, ",%d,", c->degree);
    }

    /* control points, then knots with their multiplicities */
    wcut_p21_references(p, first, c->control_count, 1);
    wcut_text_print(p->text, ",.UNSPECIFIED.,.F.,.F.%s", c->weights ? ")\nB_SPLINE_CURVE_WITH_KNOTS(" : ",\n");
    put_multiplicities(p, c->knots, knots);
    wcut_text_print(p->text, ",");
    put_knots(p, c->knots, knots);
    wcut_text_print(p->text, ",.UNSPECIFIED.)");

    /* the weights end the complex instance */
    if (c->weights) {
        wcut_text_print(p->text, "\nCURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE(");
        wcut_p21_reals(p, c->weights, c->control_count, 1);
        wcut_text_print(p->text, ")REPRESENTATION_ITEM(");
        wcut_p21_string(p, name);
        wcut_text_print(p->text, "))");
    }

    wcut_text_print(p->text, ";\n");

    return id;
}

/* ---- surfaces: STEP's outer list runs along u, ours along v ---- */

static void put_net(wcut_part21 *p, const wcut_surface *s, wcut_id first) {
    for (int i = 0; i < s->count_u; i++) {
        wcut_text_print(p->text, i ? ",\n" : "(");
        wcut_p21_references(p, first + i, s->count_v, s->count_u);
    }
    wcut_text_print(p->text, ")");
}

static void put_step_spline_weights(wcut_part21 *p, const wcut_surface *s) {
    for (int i = 0; i < s->count_u; i++) {
        wcut_text_print(p->text, i ? ",\n" : "(");
        wcut_p21_reals(p, s->weights + i, s->count_v, s->count_u);
    }
    wcut_text_print(p->text, ")");
}

wcut_id wcut_step_surface(wcut_part21 *p, const char *name, const wcut_surface *s) {
    const int knots_u = s->count_u + s->degree_u + 1, knots_v = s->count_v + s->degree_v + 1;

    /* the points stand before the surface that refers to them */
    const wcut_id first = put_step_spline_points(p, s->control, s->count_u * s->count_v);
    const wcut_id id = wcut_p21_begin(p);

    /* a rational surface is a complex instance, a plain one a simple one */
    if (s->weights) {
        wcut_text_print(p->text, "(BOUNDED_SURFACE()B_SPLINE_SURFACE(%d,%d,", s->degree_u, s->degree_v);
    } else {
        wcut_text_print(p->text, "B_SPLINE_SURFACE_WITH_KNOTS(");
        wcut_p21_string(p, name);
        wcut_text_print(p->text, ",%d,%d,", s->degree_u, s->degree_v);
    }

    /* the control net, then knots with their multiplicities in both directions */
    put_net(p, s, first);
    wcut_text_print(p->text, ",\n.UNSPECIFIED.,.F.,.F.,.F.%s", s->weights ? ")\nB_SPLINE_SURFACE_WITH_KNOTS(" : ",\n");
    put_multiplicities(p, s->knots_u, knots_u);
    wcut_text_print(p->text, ",\n");
    put_multiplicities(p, s->knots_v, knots_v);
    wcut_text_print(p->text, ",\n");
    put_knots(p, s->knots_u, knots_u);
    wcut_text_print(p->text, ",\n");
    put_knots(p, s->knots_v, knots_v);
    wcut_text_print(p->text, ",.UNSPECIFIED.)");

    /* the weights end the complex instance */
    if (s->weights) {
        wcut_text_print(p->text, "\nGEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(");
        put_step_spline_weights(p, s);
        wcut_text_print(p->text, ")\nREPRESENTATION_ITEM(");
        wcut_p21_string(p, name);
        wcut_text_print(p->text, ")SURFACE())");
    }

    wcut_text_print(p->text, ";\n");

    return id;
}
