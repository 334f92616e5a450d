/* Curves in: our own STEP and IGES bit for bit, what other programs write of the rest, and what is refused or told. */
#include <locale.h>
#include <wirecut/curve.h>
#include <wirecut/exchange.h>
#include <wirecut/job.h>
#include <wirecut/job_file.h>
#include <wirecut/read.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "exchange/given_parts.h"
#include "io/cad/curve_set.h"
#include "io/cad/iges_given.h"
#include "io/given.h"
#include "test.h"

static wcut_curve_set *set;
static wcut_error error;
static wcut_curve_read_options options;

static wcut_status read_text(const char *label, const char *text, size_t length) {
    char *copy = calloc(length + 1, 1);
    memcpy(copy, text, length);
    if (options.max_curves == 0) options = wcut_curve_read_options_default();
    wcut_curve_set_destroy(set);
    set = NULL;
    error.text[0] = '\0';
    const wcut_status status = wcut_curve_set_read_memory(copy, length, label, &options, &set, &error);
    free(copy);
    return status;
}

static void reads(const char *label, const char *text, int count) {
    ck_assert_msg(read_text(label, text, strlen(text)) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(set->count, count);
}

static void refuses(const char *label, const char *text, const char *words) {
    ck_assert_int_eq(read_text(label, text, strlen(text)), WCUT_BAD_FORMAT);
    ck_assert_ptr_null(set);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
}

static wcut_vec3 at(int k, double share) {
    double first, last;
    wcut_vec3 p = {999, 999, 999};
    wcut_curve_domain(set->curve[k], &first, &last);
    ck_assert_int_eq(wcut_curve_eval(set->curve[k], first + share * (last - first), 0, &p), WCUT_OK);
    return p;
}

static void is_at(wcut_vec3 p, double x, double y, double z) {
    ck_assert_msg(fabs(p.x - x) + fabs(p.y - y) + fabs(p.z - z) < 1e-9, "%.12g %.12g %.12g", p.x, p.y, p.z);
}

static void is_same(const wcut_curve *a, const wcut_curve *b) {
    ck_assert(a->degree == b->degree && a->control_count == b->control_count);
    const size_t n = (size_t)a->control_count;
    ck_assert(memcmp(a->knots, b->knots, (n + (size_t)a->degree + 1) * sizeof *a->knots) == 0);
    for (size_t k = 0; k < n; k++)
        ck_assert(a->control[k].x == b->control[k].x && a->control[k].y == b->control[k].y &&
                  a->control[k].z == b->control[k].z);
    ck_assert((a->weights == NULL) == (b->weights == NULL));
    if (a->weights) ck_assert(memcmp(a->weights, b->weights, n * sizeof *a->weights) == 0);
}

/* ---- what we write ---- */

TEST(our_own_step_and_iges_come_back_bit_for_bit_whatever_the_locale) {
    wcut_curve *curve = given_curve(), *arc = given_arc();
    const wcut_shape shape[] = {{.name = "path a", .curve = curve}, {.name = "arc 'b'", .curve = arc}};
    enter_folder();
    ck_assert_ptr_nonnull(setlocale(LC_ALL, "de_DE.UTF-8"));
    ck_assert_int_eq(wcut_step_write(2, shape, WCUT_STEP_SCHEMA_AP214, "a.step", NULL), WCUT_OK);
    ck_assert_int_eq(wcut_step_write(2, shape, WCUT_STEP_SCHEMA_AP242, "b.stp", NULL), WCUT_OK);
    ck_assert_int_eq(wcut_iges_write(2, shape, "a.igs", NULL), WCUT_OK);
    static const char *const name[] = {"a.step", "b.stp", "a.igs"};
    for (int f = 0; f < 3; f++) {
        ck_assert_msg(wcut_curve_set_read(name[f], NULL, &set, &error) == WCUT_OK, "%s", error.text);
        ck_assert(set->count == 2 && set->left_out == 0 && set->why[0] == '\0');
        ck_assert_int_eq(set->format, f < 2 ? WCUT_CURVE_FORMAT_STEP : WCUT_CURVE_FORMAT_IGES);
        is_same(set->curve[0], curve);
        is_same(set->curve[1], arc);
        ck_assert_str_eq(set->name[0], f < 2 ? "path a" : "");
        wcut_curve_set_destroy(set);
        set = NULL;
    }
    setlocale(LC_ALL, "C");
    leave_folder();
    wcut_curve_destroy(arc);
    wcut_curve_destroy(curve);
}

TEST(a_solid_gives_its_edges) {
    given_solid solid;
    given_solid_create(&solid, 0);
    const wcut_shape shape = {.name = "lower", .solid = &solid.brep};
    enter_folder();
    ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP214, "a.step", NULL), WCUT_OK);
    ck_assert_msg(wcut_curve_set_read("a.step", NULL, &set, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(set->count, 12);
    for (int k = 0; k < 4; k++) is_same(set->curve[k], solid.edge[k].curve);
    is_at(at(4, 1), 0, 0, 0);
    wcut_curve_set_destroy(set);
    set = NULL;
    leave_folder();
    given_solid_destroy(&solid);
}

/* ---- what others write: instances #20 and on, the elements of the geometric set first ---- */

#define STEP(unit, elements, data)                                                                      \
    "ISO-10303-21; /* a comment; */ HEADER; FILE_NAME('a;b','it''s(',$); ENDSEC;\nDATA;\n" unit         \
    "#6=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"                                        \
    "#9=( GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT((#5,#6)) "                   \
    "REPRESENTATION_CONTEXT('','') );\n"                                                                \
    "#10=CARTESIAN_POINT('',(0.,0.,0.));#11=CARTESIAN_POINT('',(3.,0.,1.));\n"                          \
    "#12=CARTESIAN_POINT('',(3.,4.,1.E0));#13=DIRECTION('',(0.,0.,2.));#14=DIRECTION('',(1.,0.,0.));\n" \
    "#15=AXIS2_PLACEMENT_3D('',#11,#13,#14);\n"                                                         \
    "#19=GEOMETRIC_CURVE_SET('',(" elements "));\n" data "ENDSEC;\nEND-ISO-10303-21;\n"
#define MM "#5=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));"

TEST(lines_polylines_arcs_and_composites_become_splines) {
    reads(
        "a.step",
        STEP(MM, "#20,#21,#22,#10",
             "#20=POLYLINE('zig',(#10,#11,#12,#12));\n"
             "#21=TRIMMED_CURVE('',#30,(#10,PARAMETER_VALUE(0.)),(#11,PARAMETER_VALUE(9.)),.T.,.CARTESIAN.);\n"
             "#30=LINE('',#10,#31);#31=VECTOR('',#14,2.);\n"
             "#22=TRIMMED_CURVE('',#40,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.5707963267948966)),.T.,.PARAMETER.);\n"
             "#40=CIRCLE('',#15,2.);\n"),
        3);
    ck_assert(set->curve[0]->degree == 1 && set->curve[0]->control_count == 3);
    ck_assert_str_eq(set->name[0], "zig");
    is_at(at(0, 0.5), 3, 0, 1);
    is_at(at(1, 1), 3, 0, 1);
    is_at(at(2, 0), 5, 0, 1);
    is_at(at(2, 0.5), 3 + sqrt(2), sqrt(2), 1);
    is_at(at(2, 1), 3, 2, 1);
    reads("a.step",
          STEP(MM, "#20,#21,#22",
               "#20=ELLIPSE('',#15,2.,1.);\n"
               "#21=COMPOSITE_CURVE('',(#30,#31),.U.);\n"
               "#30=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#40);#31=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,#40);\n"
               "#40=POLYLINE('',(#10,#12));\n"
               "#22=TRIMMED_CURVE('',#20,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(-3.1415926535897931)),.F.,.PARAMETER.);"
               "\n"),
          3);
    is_at(at(0, 0.25), 3, 1, 1);
    is_at(at(0, 1), 5, 0, 1);
    is_at(at(1, 0.5), 3, 4, 1);
    is_at(at(1, 1), 0, 0, 0);
    is_at(at(2, 0.5), 3, -1, 1);
    is_at(at(2, 1), 1, 0, 1);
}

TEST(a_composite_whose_segments_meet_is_one_curve_and_else_its_segments) {
    /* from (1, 0, 1) by half a circle to (5, 0, 1), on by a line to (3, 4, 1) */
    static const char arc[] =
        "#20=COMPOSITE_CURVE('edge',(#30,#31),.U.);\n"
        "#30=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#40);\n"
        "#31=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,#41);\n"
        "#40=TRIMMED_CURVE('',#42,(PARAMETER_VALUE(3.1415926535897931)),(PARAMETER_VALUE("
        "6.2831853071795862)),.T.,.PARAMETER.);#42=CIRCLE('',#15,2.);\n"
        "#41=POLYLINE('',(#12,#43));#43=CARTESIAN_POINT('',(%s,0.,1.));\n";
    char text[4000], data[1000];
    for (int apart = 0; apart < 2; apart++) {
        snprintf(data, sizeof data, arc, apart ? "5.1" : "5.");
        snprintf(text, sizeof text, STEP(MM, "#20", "%s"), data);
        reads("a.step", text, apart ? 2 : 1);
        ck_assert_str_eq(set->name[0], "edge");
        is_at(at(0, 0), 1, 0, 1);
        is_at(at(apart, 1), 3, 4, 1);
        if (apart) is_at(at(0, 1), 5, 0, 1);
        ck_assert_int_eq(set->curve[0]->degree, 2);
    }
}

TEST(a_spline_trimmed_by_points_is_cut_where_they_lie_on_it) {
    reads("a.step",
          STEP(MM, "#20,#21,#22",
               "#20=TRIMMED_CURVE('',#30,(#31),(#32),.T.,.CARTESIAN.);\n"
               "#21=TRIMMED_CURVE('',#30,(#32),(#31),.F.,.CARTESIAN.);\n"
               "#22=TRIMMED_CURVE('',#30,(#31),(#33),.T.,.CARTESIAN.);\n"
               "#31=CARTESIAN_POINT('',(0.75,0.,0.25));#32=CARTESIAN_POINT('',(2.25,0.,0.75));\n"
               "#33=CARTESIAN_POINT('',(2.25,1.,0.75));\n"
               "#30=B_SPLINE_CURVE_WITH_KNOTS('',1,(#10,#11),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,4.),.UNSPECIFIED.);\n"),
          2);
    is_at(at(0, 0), 0.75, 0, 0.25);
    is_at(at(0, 1), 2.25, 0, 0.75);
    is_at(at(1, 0), 2.25, 0, 0.75);
    is_at(at(1, 1), 0.75, 0, 0.25);
    ck_assert_str_eq(set->why, "a spline whose ends are not on it");
}

TEST(a_trimmed_spline_is_cut_at_its_parameters) {
    reads("a.step",
          STEP(MM, "#20,#21",
               "#20=TRIMMED_CURVE('',#30,(PARAMETER_VALUE(1.)),(PARAMETER_VALUE(3.)),.T.,.PARAMETER.);\n"
               "#21=TRIMMED_CURVE('',#30,(PARAMETER_VALUE(4.)),(PARAMETER_VALUE(2.)),.F.,.PARAMETER.);\n"
               "#30=B_SPLINE_CURVE_WITH_KNOTS('',1,(#10,#11),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,4.),.UNSPECIFIED.);\n"),
          2);
    is_at(at(0, 0), 0.75, 0, 0.25);
    is_at(at(0, 1), 2.25, 0, 0.75);
    is_at(at(1, 0), 3, 0, 1);
    is_at(at(1, 1), 1.5, 0, 0.5);
}

TEST(the_files_own_unit_is_obeyed) {
    reads("a.step",
          STEP("#5=(CONVERSION_BASED_UNIT('INCH',#4)LENGTH_UNIT()NAMED_UNIT(#3));"
               "#4=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#2);#2=(LENGTH_UNIT()NAMED_UNIT(*)"
               "SI_UNIT(.MILLI.,.METRE.));#3=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);",
               "#20", "#20=POLYLINE('',(#10,#12));\n"),
          1);
    is_at(at(0, 1), 76.2, 101.6, 25.4);
    reads("a.step", STEP("#5=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));", "#20", "#20=CIRCLE('',#15,2.);\n"), 1);
    is_at(at(0, 0), 5000, 0, 1000);
}

TEST(what_is_left_out_is_told_and_the_rest_is_read) {
    reads("a.step",
          STEP(MM, "#20,#21,#22,#23",
               "#20=POLYLINE('',(#10,#11));#21=PARABOLA('',#15,1.);#22=HYPERBOLA('',#15,1.,1.);#23=PARABOLA('',#15,2.);"
               "\n"),
          1);
    ck_assert_int_eq(set->left_out, 3);
    ck_assert_str_eq(set->why, "PARABOLA, HYPERBOLA");
    refuses("a.step", STEP(MM, "#21", "#21=PARABOLA('',#15,1.);\n"),
            "found no curve that is read, 1 left out: PARABOLA");
}

TEST(a_broken_step_file_is_refused_with_its_words) {
    refuses("a.step", "", "found nothing, expected ISO-10303-21;");
    refuses("a.step", "solid a\n", "expected ISO-10303-21;");
    refuses("a.step", "ISO-10303-21;DATA;", "found the end of the file, expected END-ISO-10303-21;");
    refuses("a.step", "ISO-10303-21;DATA;#1=A(;", "expected parentheses in pairs");
    refuses("a.step", "ISO-10303-21;DATA;#1=A('", "found a string or comment without an end");
    refuses("a.step", "ISO-10303-21;DATA;#1=A();#1=B();END-ISO-10303-21;", "found #1 twice");
    refuses("a.step", "ISO-10303-21;DATA;#x=A();END-ISO-10303-21;", "expected #, a number and =");
    refuses("a.step", "ISO-10303-21;DATA;#1=A();END-ISO-10303-21;", "found no unit of length");
    refuses("a.step", STEP(MM, "#20", "#20=POLYLINE('',(#10,#99));\n"), "#99: expected a CARTESIAN_POINT");
    refuses("a.step", STEP(MM, "#20", "#20=POLYLINE('',(#10,#21));#21=CARTESIAN_POINT('',(0.,1.));\n"),
            "#21: expected a CARTESIAN_POINT with three numbers up to 1e12 mm");
    refuses("a.step", STEP(MM, "#20", "#20=POLYLINE('',(#10,#21));#21=CARTESIAN_POINT('',(0.,1.,1.E13));\n"),
            "#21: expected a CARTESIAN_POINT with three numbers up to 1e12 mm");
    refuses("a.step", STEP(MM, "#20", "#20=POLYLINE('',(#10,#10));\n"), "#20: found 2 points in one place");
    refuses("a.step", STEP(MM, "#20", "#20=CIRCLE('',#15,-1.);\n"), "#20: found no radius");
    refuses("a.step", STEP(MM, "#20", "#20=B_SPLINE_CURVE_WITH_KNOTS('',1,(#10,#11),.U.,.F.,.F.,(2,3),(0.,4.),.U.);\n"),
            "#20: found knots and multiplicities that do not add up");
    refuses("a.step", STEP(MM, "#20", "#20=B_SPLINE_CURVE_WITH_KNOTS('',1,(#10,#11),.U.,.F.,.F.,(2,2),(4.,0.),.U.);\n"),
            "#20: found knots or weights that make no curve of degree 1 with 2 control points");
    refuses("a.step", STEP(MM, "#20", "#20=SURFACE_CURVE('',#20,(),.CURVE_3D.);\n"), "found curves nested too deep");
}

/* #50 holds the set; #60 at its origin and #61, 10 up and a quarter turn about z */
#define PARTS                                                                          \
    "#20=POLYLINE('e',(#10,#11));\n#50=SHAPE_REPRESENTATION('',(#60,#19),#9);\n"       \
    "#60=AXIS2_PLACEMENT_3D('',#10,#13,#14);#61=AXIS2_PLACEMENT_3D('',#62,#13,#63);\n" \
    "#62=CARTESIAN_POINT('',(0.,0.,10.));#63=DIRECTION('',(0.,1.,0.));\n"

TEST(the_parts_of_an_assembly_stand_where_it_sets_them) {
    /* once where it is, once moved; a relation that moves nothing in between */
    static const char *const relation =
        STEP(MM, "#20",
             PARTS
             "#51=SHAPE_REPRESENTATION('',(#60,#61),#9);#52=SHAPE_REPRESENTATION('',(#60),#9);\n"
             "#70=(REPRESENTATION_RELATIONSHIP('','',#52,#51)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#71)"
             "SHAPE_REPRESENTATION_RELATIONSHIP());#71=ITEM_DEFINED_TRANSFORMATION('','',#60,#60);\n"
             "#72=(REPRESENTATION_RELATIONSHIP('','',#52,#51)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#73)"
             "SHAPE_REPRESENTATION_RELATIONSHIP());#73=ITEM_DEFINED_TRANSFORMATION('','',#60,#61);\n"
             "#74=SHAPE_REPRESENTATION_RELATIONSHIP('','',#52,#50);\n");
    static const char *const mapped =
        STEP(MM, "#20",
             PARTS
             "#51=SHAPE_REPRESENTATION('',(#80,#81),#9);#80=MAPPED_ITEM('',#82,#60);#81=MAPPED_ITEM('',#82,#61);\n"
             "#82=REPRESENTATION_MAP(#60,#50);\n");
    for (int k = 0; k < 2; k++) {
        reads("a.step", k ? mapped : relation, 2);
        int up = at(0, 0).z > 5 ? 0 : 1;
        is_at(at(1 - up, 0), 0, 0, 0);
        is_at(at(1 - up, 1), 3, 0, 1);
        is_at(at(up, 0), 0, 0, 10);
        is_at(at(up, 1), 0, 3, 11);
        ck_assert_str_eq(set->name[1], set->name[0]);
    }

    /* identity placements are no motion: the same numbers to the bit */
    reads("a.step",
          STEP(MM, "#20",
               PARTS "#51=SHAPE_REPRESENTATION('',(#60),#9);#71=ITEM_DEFINED_TRANSFORMATION('','',#60,#60);\n"
                     "#70=(REPRESENTATION_RELATIONSHIP('','',#50,#51)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION("
                     "#71)SHAPE_REPRESENTATION_RELATIONSHIP());\n"),
          1);
    ck_assert(at(0, 1).x == 3 && at(0, 1).z == 1);

    /* a part that holds itself, and one that is scaled */
    refuses("a.step",
            STEP(MM, "#20",
                 PARTS "#51=SHAPE_REPRESENTATION('',(#80),#9);#80=MAPPED_ITEM('',#82,#14);\n"
                       "#82=REPRESENTATION_MAP(#60,#50);\n"),
            "#80: found a mapped item that is scaled");
    reads("a.step",
          STEP(MM, "#20",
               PARTS "#70=(REPRESENTATION_RELATIONSHIP('','',#50,#50)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION("
                     "#71)SHAPE_REPRESENTATION_RELATIONSHIP());#71=ITEM_DEFINED_TRANSFORMATION('','',#60,#61);\n"),
          1);
}

TEST(units_are_those_of_the_context_that_a_shape_is_in) {
    /* #9 is in mm; colours are in inches, and so is the second part */
    reads("a.step",
          STEP(MM, "#20",
               PARTS "#90=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));"
                     "#1=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#90))"
                     "REPRESENTATION_CONTEXT('',''));#91=DRAUGHTING_MODEL('',(),#1);\n"
                     "#92=SHAPE_REPRESENTATION('',(#93),#1);#93=GEOMETRIC_CURVE_SET('',(#94));"
                     "#94=POLYLINE('',(#11,#12));\n"),
          2);
    is_at(at(0, 1), 3, 0, 1);
    is_at(at(1, 0), 30, 0, 10);
}

TEST(splines_with_implied_knots_are_read) {
    reads("a.step",
          STEP(MM, "#20,#21,#22,#23",
               "#20=BEZIER_CURVE('',2,(#10,#11,#12),.U.,.F.,.F.);\n"
               "#21=QUASI_UNIFORM_CURVE('',1,(#10,#11,#12),.U.,.F.,.F.);\n"
               "#22=(BEZIER_CURVE()BOUNDED_CURVE()B_SPLINE_CURVE(2,(#10,#11,#12),.U.,.F.,.F.)CURVE()"
               "GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,2.,1.))REPRESENTATION_ITEM(''));\n"
               "#23=UNIFORM_CURVE('',2,(#10,#11,#12),.U.,.F.,.F.);\n"),
          4);
    is_at(at(0, 0.5), 2.25, 1, 0.75);
    is_at(at(1, 0.5), 3, 0, 1);
    is_at(at(2, 0.5), 3.75 / 1.5, 1 / 1.5, 1.25 / 1.5);
    is_at(at(3, 0), 1.5, 0, 0.5); /* the middle of its first two poles */
    is_at(at(3, 1), 3, 2, 1);
    refuses("a.step", STEP(MM, "#20", "#20=BEZIER_CURVE('',3,(#10,#11,#12),.U.,.F.,.F.);\n"),
            "#20: found a number of poles that its degree does not allow");
}

TEST(pieces_that_meet_become_one_curve_within_the_accuracy_that_is_stated) {
    /* along x: 0 .. 3 and 9 .. 3.01, the second the other way round; a third curve elsewhere, a corner that stays one */
    static const char *const text =
        STEP(MM, "#20,#21,#22,#24",
             "#20=POLYLINE('',(#10,#30));#21=POLYLINE('',(#31,#32));#22=POLYLINE('',(#33,#34));\n"
             "#24=POLYLINE('',(#34,#35));\n"
             "#30=CARTESIAN_POINT('',(3.,0.,0.));#31=CARTESIAN_POINT('',(9.,0.,0.));"
             "#32=CARTESIAN_POINT('',(3.01,0.,0.));#33=CARTESIAN_POINT('',(0.,50.,0.));"
             "#34=CARTESIAN_POINT('',(9.,50.,0.));#35=CARTESIAN_POINT('',(9.,90.,0.));\n"
             "#7=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.01),#5,'distance_accuracy_value','');\n"
             "#8=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#7))"
             "GLOBAL_UNIT_ASSIGNED_CONTEXT((#5,#6))REPRESENTATION_CONTEXT('',''));\n"
             "#50=SHAPE_REPRESENTATION('',(#19),#8);\n");
    char copy[4000];
    reads("a.step", text, 3);
    is_at(at(0, 0), 0, 0, 0);
    is_at(at(0, 1), 9, 0, 0);

    /* further apart than the file's accuracy they are two */
    snprintf(copy, sizeof copy, "%s", text);
    memcpy(strstr(copy, "MEASURE(0.01)"), "MEASURE(.001)", 13);
    reads("a.step", copy, 4);

    /* composites in composites, turned, and a trimmed piece of a trimmed piece */
    reads("a.step",
          STEP(MM, "#20,#21",
               "#20=COMPOSITE_CURVE('',(#30,#31),.U.);#30=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.F.,#32);"
               "#31=COMPOSITE_CURVE_SEGMENT(.DISCONTINUOUS.,.T.,#33);#32=COMPOSITE_CURVE('',(#34,#35),.U.);"
               "#34=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#36);#35=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#37);"
               "#36=POLYLINE('',(#12,#11));#37=POLYLINE('',(#11,#10));#33=POLYLINE('',(#12,#38));"
               "#38=CARTESIAN_POINT('',(3.,9.,1.));\n"
               "#21=TRIMMED_CURVE('',#40,(PARAMETER_VALUE(.5)),(PARAMETER_VALUE(1.5)),.T.,.PARAMETER.);"
               "#40=TRIMMED_CURVE('',#41,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(2.)),.T.,.PARAMETER.);"
               "#41=B_SPLINE_CURVE_WITH_KNOTS('',1,(#10,#11,#12),.U.,.F.,.F.,(2,1,2),(0.,1.,2.),.U.);\n"),
          2);
    is_at(at(0, 0), 0, 0, 0);
    is_at(at(0, 1), 3, 9, 1);
    is_at(at(1, 0), 1.5, 0, 0.5);
    is_at(at(1, 1), 3, 2, 1);
}

TEST(json_and_csv_hold_curves_in_millimetres) {
    reads("a.json", "{\"points_mm\": [[0,0,0],[1,0,0],[2,1,0],[3,1,0]]}", 1);
    is_at(at(0, 1), 3, 1, 0);
    reads("a.json",
          "{\"curves\": [{\"points_mm\": [[0,0,0],[1,0,0]]}, {\"degree\": 1, \"knots\": [0,0,1,1], "
          "\"control_points_mm\": [[0,0,0],[0,2,0]]}]}",
          2);
    is_at(at(1, 0.5), 0, 1, 0);
    refuses("a.json", "{\"curves\": [{\"points_mm\": [[0,0,0],[0,0,0]]}]}", "$.curves[0]");
    refuses("a.json", "{\"curves\": []}", "found no curve, expected at least one");
    reads("a.csv", "x_mm,y_mm,z_mm,curve\n0,0,0,1\n1,0,0,1\n2,0,0,1\n0,5,0,2\n0,6,0,2\n", 2);
    is_at(at(0, 1), 2, 0, 0);
    is_at(at(1, 0), 0, 5, 0);
    options.interpolate = 0;
    reads("a.csv", "x_mm,y_mm,z_mm\n0,0,0\n1,0,0\n1,3,0\n", 1);
    ck_assert_int_eq(set->curve[0]->degree, 1);
    is_at(at(0, 0.5), 1, 0, 0);
    options.interpolate = 1;
    refuses("a.csv", "x_mm,y_mm\n0,0\n1,0\n", "found 2 values without a header");
    refuses("a.csv", "x_mm,y_mm,z_mm\n0,0,0\n1,,0\n", "line 3: found no y, expected a number");
    refuses("a.csv", "x_mm,y_mm,z_mm\n0,0,0\n0,0,0\n",
            "line 2: found 2 points, expected two or more, neighbours apart");
    refuses("a.bin", "hello", "found no curves in a known format, expected STEP, IGES, JSON or a table");
}

/* ---- IGES ---- */

/* lines of 80 columns from "text|section" */
static void put_lines(char *to, const char *const *text, const char *sections) {
    int number = 0;
    char before = 0;
    for (int k = 0; text[k]; k++) {
        number = sections[k] == before ? number + 1 : 1;
        before = sections[k];
        to += sprintf(to, "%-72.72s%c%7d\r\n", text[k], sections[k], number);
    }
}

TEST(iges_lines_points_and_splines_are_read_in_their_unit) {
    char text[4000];
    static const char *const lines[] = {"start",
                                        "1H,,1H;,5Ha,b;c,4Hfile,1Hs,1Hp,32,38,6,308,15,,1.,1,4HINCH,1,0.01,",
                                        "15H20000101.000000,1.D-6,0.,,,11,0,;",
                                        "     110       1       0       0       0       0       0       000000000",
                                        "     110       0       0       1       0",
                                        "     106       2       0       0       0       0       0       000000000",
                                        "     106       0       0       1      12",
                                        "     100       3       0       0       0       0       0       000000000",
                                        "     100       0       0       1       0",
                                        "     110       4       0       0       0       0       0       000010000",
                                        "     110       0       0       1       0",
                                        "110,0.,0.,0.,1.,2D0,3.;",
                                        "106,2,3,0.,0.,0.,1.,0.,0.,1.,1.,0.;",
                                        "100,0.,0.,0.,1.,0.,0.,1.;",
                                        "110,0.,0.,0.,1.,0.,0.;",
                                        "S      1G      2D      8P      4",
                                        NULL};
    put_lines(text, lines, "SGGDDDDDDDDPPPPT");
    reads("a.igs", text, 3);
    is_at(at(0, 1), 25.4, 50.8, 76.2);
    is_at(at(1, 1), 25.4, 25.4, 0);
    is_at(at(2, 0), 25.4, 0, 0);
    is_at(at(2, 1), 0, 25.4, 0);
    is_at(at(2, 0.5), 25.4 * sqrt(0.5), 25.4 * sqrt(0.5), 0);
    ck_assert_int_eq(set->left_out, 1);
    ck_assert_str_eq(set->why, "a piece of another entity");
    *strstr(text, "110,0.") = '3';
    refuses("a.igs", text, "line 4: found too few values, or values of another kind, for this entity");
    put_lines(text, lines, "SGGDDDDDDDDPPPPP");
    refuses("a.igs", text, "found a section out of order, expected S, G, D, P, T");
    refuses("a.igs", "short\n", "line 1: found 5 columns, expected 80 of text");
}

TEST(iges_arcs_composites_and_transformations_are_read) {
    char text[6000];
    /* entries 1 and 3: an arc and a line, pieces of 5; 7: an ellipse moved by 9, which 11 moves on; 13: a hyperbola */
    static const char *const lines[] = {"start",
                                        "1H,,1H;,5Ha,b;c,4Hfile,1Hs,1Hp,32,38,6,308,15,,1.,2,2HMM,1,0.01,",
                                        "15H20000101.000000,1.D-6,0.,,,11,0,;",
                                        "     100       1       0       0       0       0       0       000010000",
                                        "     100       0       0       1       0",
                                        "     110       2       0       0       0       0       0       000010000",
                                        "     110       0       0       1       0",
                                        "     102       3       0       0       0       0       0       000000000",
                                        "     102       0       0       1       0",
                                        "     104       4       0       0       0       0       9       000000000",
                                        "     104       0       0       1       1",
                                        "     124       5       0       0       0       0      11       000000000",
                                        "     124       0       0       1       0",
                                        "     124       6       0       0       0       0       0       000000000",
                                        "     124       0       0       1       0",
                                        "     104       7       0       0       0       0       0       000000000",
                                        "     104       0       0       1       2",
                                        "100,7.,10.,0.,12.,0.,8.,0.;",
                                        "110,8.,0.,7.,8.,-5.,7.;",
                                        "102,2,1,3;",
                                        "104,0.25,0.,1.,0.,0.,-1.,3.,2.,0.,2.,0.;",
                                        "124,0.,-1.,0.,5.,1.,0.,0.,6.,0.,0.,1.,7.;",
                                        "124,1.,0.,0.,100.,0.,1.,0.,0.,0.,0.,1.,0.;",
                                        "104,1.,0.,-1.,0.,0.,-1.,3.,2.,0.,2.,0.;",
                                        "S      1G      2D     14P      7",
                                        NULL};
    put_lines(text, lines, "SGGDDDDDDDDDDDDDDPPPPPPPT");
    reads("a.igs", text, 2);
    is_at(at(0, 0), 12, 0, 7);
    is_at(at(0, 1), 8, -5, 7);
    ck_assert_int_eq(set->curve[0]->degree, 2);
    /* the ellipse's half axes are 2 along x and 1 along y; a quarter turn and (5, 6, 7), then 100 along x */
    is_at(at(1, 0), 105, 8, 10);
    is_at(at(1, 0.25), 104, 6, 10);
    is_at(at(1, 1), 105, 8, 10);
    ck_assert_int_eq(set->left_out, 1); /* pieces of a composite that is read are not */
    ck_assert_str_eq(set->why, "type 104 form 2");
    char *at_piece = strstr(text, "102,2,1,3;");
    memcpy(at_piece, "102,2,1,4;", 10); /* entries have odd numbers */
    refuses("a.igs", text, "line 8: found no directory entry 4");
    memcpy(at_piece, "102,2,1,7;", 10); /* the ellipse follows on nowhere: pieces */
    reads("a.igs", text, 3);
    is_at(at(0, 1), 8, 0, 7);
    memcpy(at_piece, "102,2,1,;;", 10);
    refuses("a.igs", text, "line 8: found too few values, or values of another kind, for this entity");
    memcpy(at_piece, "102,2,1,3;", 10);
    memcpy(strstr(text, "100,7."), "100,x.", 6);
    refuses("a.igs", text, "line 4: found too few values, or values of another kind, for this entity");
    put_lines(text, lines, "SGGDDDDDDDDDDDDDDPPPPPPPT");
    memcpy(strstr(text, "     0      11 ") + 12, " 9", 2); /* a transformation that moves itself */
    refuses("a.igs", text, "found no transformation, expected one of type 124");
    put_lines(text, lines, "SGGDDDDDDDDDDDDDDPPPPPPPT");
    memcpy(strstr(text, "124,1.,0.,0.,100."), "124,1.,0.,0.,9e20", 17);
    refuses("a.igs", text, "moved beyond 1e12 mm");
}

TEST(an_iges_spline_is_the_part_that_its_range_states) {
    char text[4000];
    iges_entity e = {126, 0, "00000000", NULL};
    e.data = "126,1,1,0,0,1,0,0.,0.,2.,2.,1.,1.,0.,0.,0.,8.,0.,0.,.5,1.5;";
    put_iges(text, "2,2HMM", "1Hx", 1, &e);
    reads("a.igs", text, 1);
    is_at(at(0, 0), 2, 0, 0);
    is_at(at(0, 1), 6, 0, 0);
    e.data = "126,1,1,0,0,1,0,0.,0.,2.,2.,1.,1.,0.,0.,0.,8.,0.,0.,0.,3.;";
    put_iges(text, "2,2HMM", "1Hx", 1, &e);
    refuses("a.igs", text, "found a curve from 0 to 3, expected a part of its knots' range 0 to 2");
    e.data = "126,1,1,0,0,1,0,0.,0.,2.,2.,1.,1.,0.,0.,0.,8.,0.,0.,1.,1.;";
    put_iges(text, "2,2HMM", "1Hx", 1, &e);
    refuses("a.igs", text, "found a curve from 1 to 1");
}

TEST(an_iges_unit_may_be_a_name_and_an_author_any_letters) {
    static const struct {
        const char *unit;
        double millimetres;
    } known[] = {{"3,2HMM", 1},     {"3,4HINCH", 25.4},  {"3,2HIN", 25.4},   {"3,2HCM", 10}, {"3,1HM", 1000},
                 {"3,2HFT", 304.8}, {"3,3HMIL", 0.0254}, {"3,2HUM", 1e-3},   {",2HMM", 1},   {"1,2HIN", 25.4},
                 {",", 25.4},       {"3,2HKM", 1e6},     {"3,2HMI", 1609344}};
    const iges_entity line = {110, 0, "00000000", "110,0.,0.,0.,1.,0.,0.;"};
    char text[4000];
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        put_iges(text, known[k].unit, k % 2 ? "6HM\xc3\xbcller" : "1Hx", 1, &line);
        snprintf(text + strlen(text), sizeof text - strlen(text), "   \n");
        reads("a.igs", text, 1);
        ck_assert_double_eq_tol(at(0, 1).x, known[k].millimetres, 1e-12 * known[k].millimetres);
    }
    put_iges(text, "3,4HROOD", "1Hx", 1, &line);
    refuses("a.igs", text, "found the unit \"ROOD\"");
}

TEST(iges_instances_are_set_in_place_and_what_is_hidden_is_left_out) {
    static const iges_entity entity[] = {
        {110, 0, "01000000", "110,0.,0.,0.,1.,0.,0.;"},    /* 1: hidden */
        {110, 0, "00020200", "110,0.,0.,0.,1.,0.,0.;"},    /* 3: a member of 7 */
        {100, 0, "00020200", "100,0.,0.,0.,1.,0.,0.,1.;"}, /* 5: another one */
        {308, 0, "00000200", "308,0,4Hpart,2,3,5;"},
        {408, 0, "00000000", "408,7,10.,20.,30.,2.;"},
        {408, 0, "01000000", "408,7,0.,0.,0.,1.;"}, /* 11: a hidden instance */
        {402, 7, "01000000", "402,1,15;"},
        {110, 0, "00020000", "110,5.,0.,0.,6.,0.,0.;"}, /* 15: of a hidden group */
        {402, 7, "00000000", "402,1,19;"},
        {110, 0, "00010000", "110,7.,0.,0.,8.,0.,0.;"}, /* 19: of a group that is shown */
    };
    char text[6000];
    put_iges(text, "2,2HMM", "1Hx", sizeof entity / sizeof *entity, entity);
    reads("a.igs", text, 3);
    is_at(at(0, 0), 10, 20, 30);
    is_at(at(0, 1), 12, 20, 30);
    is_at(at(1, 1), 10, 22, 30);
    is_at(at(2, 0), 7, 0, 0);
    ck_assert_int_eq(set->left_out, 3);
    ck_assert_str_eq(set->why, "a hidden entity");

    /* a subfigure that shows itself */
    static const iges_entity endless[] = {{308, 0, "00000200", "308,0,4Hpart,1,3;"},
                                          {408, 0, "00020200", "408,1,0.,0.,0.,1.;"},
                                          {408, 0, "00000000", "408,1,0.,0.,0.,1.;"}};
    put_iges(text, "2,2HMM", "1Hx", 3, endless);
    refuses("a.igs", text, "found instances nested too deep");
}

/* ---- misuse, memory ---- */

TEST(arguments_outside_their_range_and_missing_files_are_refused) {
    wcut_curve_read_options o = wcut_curve_read_options_default();
    ck_assert_int_eq(wcut_curve_set_read(NULL, NULL, &set, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_set_read("a.step", NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    o.max_curves = 0;
    ck_assert_int_eq(wcut_curve_set_read("a.step", &o, &set, NULL), WCUT_BAD_ARGUMENT);
    o = wcut_curve_read_options_default();
    o.interpolate = 2;
    ck_assert_int_eq(wcut_curve_set_read("a.step", &o, &set, NULL), WCUT_BAD_ARGUMENT);
    o.interpolate = 1;
    o.format = WCUT_CURVE_FORMAT_COUNT;
    ck_assert_int_eq(wcut_curve_set_read("a.step", &o, &set, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_set_read("/nowhere/a.step", NULL, &set, &error), WCUT_NOT_FOUND);
    options = wcut_curve_read_options_default();
    options.max_curves = 1;
    refuses("a.csv", "x_mm,y_mm,z_mm,curve\n0,0,0,1\n1,0,0,1\n0,5,0,2\n0,6,0,2\n", "found more than 1 curves");
    options.max_curves = 10000;
}

TEST(edges_of_a_file_become_those_of_a_design) {
    wcut_job *job = NULL;
    wcut_vec3 p[2] = {{0, 0, 150}, {0, 900, 150}};
    enter_folder();
    write_file("edges.csv", "x_mm,y_mm,z_mm,curve\n400,900,5,0\n400,0,6,0\n0,0,7,1\n0,900,8,1\n");
    write_file("one.csv", "x_mm,y_mm,z_mm\n400,900,5\n400,0,6\n");
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->mode = WCUT_MODE_PATH;
    ck_assert_int_eq(wcut_job_read_edges(job, "edges.csv", &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_job_read_edges(NULL, "edges.csv", &error), WCUT_BAD_ARGUMENT);
    job->mode = WCUT_MODE_DESIGN;
    ck_assert_int_eq(wcut_curve_interpolate(2, p, &job->edge_a), WCUT_OK);
    const wcut_curve *own = job->edge_a;
    ck_assert_int_eq(wcut_job_read_edges(job, NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_job_read_edges(job, "nowhere.csv", &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_job_read_edges(job, "one.csv", &error), WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "expected two edges"));
    ck_assert(job->edge_a == own && job->edge_b == NULL);
    ck_assert_int_eq(wcut_job_read_edges(job, "edges.csv", &error), WCUT_OK);
    ck_assert_int_eq(wcut_curve_eval(job->edge_a, 0, 0, &p[0]), WCUT_OK);
    ck_assert(p[0].x == 0 && p[0].y == 0 && p[0].z == 7);
    ck_assert_int_eq(wcut_curve_eval(job->edge_b, 0, 0, &p[0]), WCUT_OK);
    ck_assert(p[0].x == 400 && p[0].y == 0 && p[0].z == 6);
    wcut_job_destroy(job);
    leave_folder();
}

TEST(without_memory_nothing_is_given_and_nothing_lost) {
    static const char text[] = STEP(MM, "#20,#21", "#20=POLYLINE('',(#10,#11));#21=CIRCLE('',#15,1.);\n");
    EACH_FAILED_ALLOCATION(read_text("a.step", text, strlen(text)), !set);
    ck_assert_ptr_nonnull(set);
}
