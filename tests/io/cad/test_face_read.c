/* Faces in: surfaces of STEP and IGES files bit for bit, trimmed by their edges; what is left out and refused. */
#include <math.h>
#include <wirecut/exchange.h>
#include <wirecut/read.h>

#include "base/alloc.h"
#include "exchange/given_parts.h"
#include "io/cad/face_set.h"
#include "io/cad/iges_given.h"
#include "io/given.h"
#include "test.h"

static wcut_trimmed_set *set;
static wcut_error error;

static wcut_status read_text(const char *text) {
    const size_t length = strlen(text);
    char *copy = calloc(length + 1, 1);
    memcpy(copy, text, length);
    wcut_trimmed_set_destroy(set);
    set = NULL;
    error.text[0] = '\0';
    const wcut_status status = wcut_trimmed_set_read_memory(copy, length, "a.step", &set, &error);
    free(copy);
    return status;
}

static void refuses(const char *text, const char *words) {
    ck_assert_int_eq(read_text(text), WCUT_BAD_FORMAT);
    ck_assert_ptr_null(set);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
}

static void reads(const char *text, int count) {
    ck_assert_msg(read_text(text) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(set->count, count);
}

static void is_same(const wcut_surface *a, const wcut_surface *b) {
    ck_assert(a->degree_u == b->degree_u && a->degree_v == b->degree_v && a->count_u == b->count_u &&
              a->count_v == b->count_v);
    for (int k = 0; k < a->count_u * a->count_v; k++)
        ck_assert(a->control[k].x == b->control[k].x && a->control[k].y == b->control[k].y &&
                  a->control[k].z == b->control[k].z);
    for (int k = 0; k < a->count_u + a->degree_u + 1; k++) ck_assert(a->knots_u[k] == b->knots_u[k]);
    for (int k = 0; k < a->count_v + a->degree_v + 1; k++) ck_assert(a->knots_v[k] == b->knots_v[k]);
}

/* ---- ours ---- */

TEST(our_own_surfaces_come_back_bit_for_bit) {
    wcut_surface *patch = given_patch();
    const wcut_shape shape = {.name = "patch", .surface = patch};
    static const char *const name[] = {"a.step", "b.step", "a.igs"};
    enter_folder();
    ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP214, name[0], NULL), WCUT_OK);
    ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP242, name[1], NULL), WCUT_OK);
    ck_assert_int_eq(wcut_iges_write(1, &shape, name[2], NULL), WCUT_OK);
    for (int k = 0; k < 3; k++) {
        wcut_trimmed_set *found = NULL;
        ck_assert_msg(wcut_trimmed_set_read(name[k], &found, &error) == WCUT_OK, "%s", error.text);
        ck_assert(found->count == 1 && found->left_out == 0);
        ck_assert_int_eq(found->format, k < 2 ? WCUT_CURVE_FORMAT_STEP : WCUT_CURVE_FORMAT_IGES);
        is_same(found->face[0]->surface, patch);
        wcut_trimmed_set_destroy(found);
    }
    leave_folder();
    wcut_surface_destroy(patch);
}

/* the flux of x/3 through the triangles of all faces: the volume of a solid whose normals point outwards */
static double volume_of(const wcut_trimmed_set *of) {
    double volume = 0;
    for (int k = 0; k < of->count; k++) {
        wcut_mesh *m = NULL;
        ck_assert_int_eq(wcut_trimmed_mesh(of->face[k], 0.01, &m), WCUT_OK);
        for (int t = 0; t < m->triangle_count; t++) {
            const int *c = &m->triangle[3 * t];
            const wcut_vec3 a = m->vertex[c[0]], b = m->vertex[c[1]], d = m->vertex[c[2]];
            volume +=
                (a.x * (b.y * d.z - b.z * d.y) + a.y * (b.z * d.x - b.x * d.z) + a.z * (b.x * d.y - b.y * d.x)) / 6;
        }
        wcut_mesh_destroy(m);
    }
    return volume;
}

TEST(the_faces_of_a_solid_are_trimmed_by_their_edges_and_face_outwards) {
    enter_folder();
    for (int upper = 0; upper < 2; upper++) {
        given_solid solid;
        given_solid_create(&solid, upper);
        const wcut_shape shape = {.name = "half", .solid = &solid.brep};
        wcut_trimmed_set *found = NULL;
        ck_assert_int_eq(wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP214, "a.step", NULL), WCUT_OK);
        ck_assert_msg(wcut_trimmed_set_read("a.step", &found, &error) == WCUT_OK, "%s", error.text);
        ck_assert_msg(found->count == 6 && found->left_out == 0, "%d, %s", found->count, found->why);
        ck_assert_msg(fabs(volume_of(found) / solid.volume - 1) < 0.01, "%g, %g", volume_of(found), solid.volume);
        wcut_trimmed_set_destroy(found);
        given_solid_destroy(&solid);
    }
    leave_folder();
}

/* ---- others': a square of 10 with a round hole of radius 2 ---- */

#define HEAD(prefix)                                                                \
    "ISO-10303-21;HEADER;ENDSEC;DATA;#5=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(" prefix \
    ",.METRE.));"                                                                   \
    "#6=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));"                      \
    "#9=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#5,#6))REPRESENTATION_CONTEXT('',''));"
#define TAIL "ENDSEC;END-ISO-10303-21;"
#define SQUARE                                                                                                     \
    "#10=CARTESIAN_POINT('',(0.,0.,0.));#11=CARTESIAN_POINT('',(10.,0.,0.));"                                      \
    "#12=CARTESIAN_POINT('',(10.,10.,0.));#13=CARTESIAN_POINT('',(0.,10.,0.));"                                    \
    "#20=VERTEX_POINT('',#10);#21=VERTEX_POINT('',#11);#22=VERTEX_POINT('',#12);#23=VERTEX_POINT('',#13);"         \
    "#30=POLYLINE('',(#10,#11));#31=POLYLINE('',(#11,#12));#32=POLYLINE('',(#13,#12));#33=POLYLINE('',(#13,#10));" \
    "#40=EDGE_CURVE('',#20,#21,#30,.T.);#41=EDGE_CURVE('',#21,#22,#31,.T.);"                                       \
    "#42=EDGE_CURVE('',#23,#22,#32,.T.);#43=EDGE_CURVE('',#23,#20,#33,.T.);"                                       \
    "#50=ORIENTED_EDGE('',*,*,#40,.T.);#51=ORIENTED_EDGE('',*,*,#41,.T.);"                                         \
    "#52=ORIENTED_EDGE('',*,*,#42,.F.);#53=ORIENTED_EDGE('',*,*,#43,.T.);"                                         \
    "#60=EDGE_LOOP('',(#50,#51,#52,#53));#61=FACE_OUTER_BOUND('',#60,.T.);"                                        \
    "#14=CARTESIAN_POINT('',(5.,5.,0.));#15=CARTESIAN_POINT('',(7.,5.,0.));#24=VERTEX_POINT('',#15);"              \
    "#16=DIRECTION('',(0.,0.,1.));#17=DIRECTION('',(1.,0.,0.));#18=AXIS2_PLACEMENT_3D('',#14,#16,#17);"            \
    "#34=CIRCLE('',#18,2.);#44=EDGE_CURVE('',#24,#24,#34,.T.);#54=ORIENTED_EDGE('',*,*,#44,.F.);"                  \
    "#62=EDGE_LOOP('',(#54));#63=FACE_BOUND('',#62,.T.);#70=PLANE('',#18);"
#define SHELL "#81=OPEN_SHELL('',(#80));#82=SHELL_BASED_SURFACE_MODEL('',(#81));"
#define HOLDER "#83=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#82),#9);"

static double area_of_first(void) {
    wcut_mesh *m = NULL;
    double area = 0;
    ck_assert_int_eq(wcut_trimmed_mesh(set->face[0], 0.01, &m), WCUT_OK);
    for (int t = 0; t < m->triangle_count; t++) {
        const int *c = &m->triangle[3 * t];
        const wcut_vec3 a = m->vertex[c[0]], b = m->vertex[c[1]], d = m->vertex[c[2]];
        area += ((b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x)) / 2;
    }
    wcut_mesh_destroy(m);
    return area;
}

TEST(a_plane_is_trimmed_by_its_loops_in_the_files_unit) {
    const double area = 100 - 4 * 3.141592653589793;
    reads(HEAD(".MILLI.") SQUARE "#80=ADVANCED_FACE('top',(#61,#63),#70,.T.);" SHELL HOLDER TAIL, 1);
    ck_assert_str_eq(set->name[0], "top");
    ck_assert_double_eq_tol(area_of_first(), area, 1);
    reads(HEAD(".CENTI.") SQUARE "#80=ADVANCED_FACE('',(#61,#63),#70,.T.);" SHELL HOLDER TAIL, 1);
    ck_assert_double_eq_tol(area_of_first(), 100 * area, 100);

    /* the other side; without a shell that holds it; without the hole */
    reads(HEAD(".MILLI.") SQUARE "#80=ADVANCED_FACE('',(#61,#63),#70,.F.);" SHELL HOLDER TAIL, 1);
    ck_assert_double_eq_tol(area_of_first(), -area, 1);
    reads(HEAD(".MILLI.") SQUARE "#80=FACE_SURFACE('',(#61),#70,.T.);" TAIL, 1);
    ck_assert_double_eq_tol(area_of_first(), 100, 1);

    /* an assembly that sets it 10 up */
    reads(HEAD(".MILLI.") SQUARE
          "#80=ADVANCED_FACE('',(#61,#63),#70,.T.);" SHELL HOLDER
          "#90=CARTESIAN_POINT('',(0.,0.,10.));#91=AXIS2_PLACEMENT_3D('',#10,#16,#17);"
          "#92=AXIS2_PLACEMENT_3D('',#90,#16,#17);#93=SHAPE_REPRESENTATION('',(#91,#92),#9);"
          "#94=SHAPE_REPRESENTATION('',(#91),#9);#95=(REPRESENTATION_RELATIONSHIP('','',#94,#93)"
          "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#96)SHAPE_REPRESENTATION_RELATIONSHIP());"
          "#96=ITEM_DEFINED_TRANSFORMATION('','',#91,#92);#97=SHAPE_REPRESENTATION_RELATIONSHIP('','',#94,#83);" TAIL,
          1);
    ck_assert_double_eq_tol(area_of_first(), area, 1);
    ck_assert_double_eq_tol(set->face[0]->point[0].z, 10, 1e-12);
}

TEST(what_is_no_face_is_left_out_by_its_name_or_refused) {
    refuses(HEAD(".MILLI.") SQUARE "#71=CYLINDRICAL_SURFACE('',#18,2.);#80=ADVANCED_FACE('',(#61),#71,.T.);" TAIL,
            "found no face that is read, 1 left out: CYLINDRICAL_SURFACE");
    refuses(HEAD(".MILLI.") SQUARE
            "#71=AXIS2_PLACEMENT_3D('',#19,#16,#17);#19=CARTESIAN_POINT('',(0.,0.,3.));#72=PLANE('',#71);"
            "#80=ADVANCED_FACE('',(#61),#72,.T.);" TAIL,
            "1 left out: a curve of a loop is 3 mm off the surface");
    refuses(HEAD(".MILLI.") SQUARE
            "#64=EDGE_LOOP('',(#50,#51));#65=FACE_BOUND('',#64,.T.);"
            "#80=ADVANCED_FACE('',(#65),#70,.T.);" TAIL,
            "1 left out: two curves of a loop are 14.1 mm apart");
    refuses(HEAD(".MILLI.") SQUARE
            "#64=VERTEX_LOOP('',#20);#65=FACE_BOUND('',#64,.T.);"
            "#80=ADVANCED_FACE('',(#65),#70,.T.);" TAIL,
            "a face bounded by other than edges");
    refuses(HEAD(".MILLI.") SQUARE "#80=ADVANCED_FACE('',(#99),#70,.T.);" TAIL, "#99: found no loop");
    refuses(HEAD(".MILLI.") SQUARE "#80=ADVANCED_FACE('',(#61),#99,.T.);" TAIL, "#99: found no such instance");
    refuses(HEAD(".MILLI.") SQUARE TAIL, "found no face, expected a surface");
    refuses("solid x\nfacet\n", "found a mesh (STL), expected a surface in STEP or IGES");
    refuses("hello", "found no STEP and no IGES file");
    refuses(HEAD(".MILLI.") SQUARE
            "#71=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#10,#13),(#11)),.U.,.F.,.F.,.F.,(2,2),(2,2),"
            "(0.,1.),(0.,1.),.U.);" TAIL,
            "#71: found rows of unlike lengths");
    refuses(HEAD(".MILLI.") SQUARE
            "#71=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#10,#13),(#11,#12)),.U.,.F.,.F.,.F.,(2,2),"
            "(2,2),(1.,0.),(0.,1.),.U.);" TAIL,
            "#71: found knots or weights that make no surface");
    reads(HEAD(".MILLI.") SQUARE
          "#71=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#10,#13),(#11,#12)),.U.,.F.,.F.,.F.,(2,2),(2,2),"
          "(0.,1.),(0.,1.),.U.);" TAIL,
          1);
    ck_assert_double_eq_tol(area_of_first(), 100, 1e-9);
    reads(
        HEAD(".MILLI.") SQUARE
        "#71=(BOUNDED_SURFACE()B_SPLINE_SURFACE(1,1,((#10,#13),(#11,#12)),.U.,.F.,.F.,.F.)B_SPLINE_SURFACE_WITH_KNOTS("
        "(2,2),(2,2),(0.,1.),(0.,1.),.U.)GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE(((1.,2.),(3.,4.)))"
        "REPRESENTATION_ITEM('')SURFACE());" TAIL,
        1);
    ck_assert(set->face[0]->surface->weights[1] == 3 && set->face[0]->surface->weights[2] == 2);
}

/* ---- IGES ---- */

#define PATCH "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,10.,0.,0.,0.,10.,0.,10.,10.,0.,"

TEST(an_iges_surface_is_the_part_that_its_range_states_trimmed_by_its_curves) {
    char text[8000];
    iges_entity whole = {128, 0, "00000000", PATCH "0.,1.,0.,1.;"};
    put_iges(text, "2,2HMM", "1Hx", 1, &whole);
    reads(text, 1);
    ck_assert_double_eq_tol(area_of_first(), 100, 1e-9);
    whole.data = PATCH "0.25,1.,0.,0.5;";
    put_iges(text, "1,2HIN", "1Hx", 1, &whole);
    reads(text, 1);
    ck_assert_double_eq_tol(area_of_first(), 25.4 * 25.4 * 37.5, 1e-6);
    whole.data = PATCH "0.,3.,0.,0.5;";
    put_iges(text, "2,2HMM", "1Hx", 1, &whole);
    refuses(text, "found a surface from 0 to 3, expected a part of 0 to 1");

    /* a triangle of it: three lines as a composite curve */
    static const iges_entity trimmed[] = {
        {128, 0, "00010000", PATCH "0.,1.,0.,1.;"},     {110, 0, "00010000", "110,1.,1.,0.,9.,1.,0.;"},
        {110, 0, "00010000", "110,9.,1.,0.,1.,9.,0.;"}, {110, 0, "00010000", "110,1.,9.,0.,1.,1.,0.;"},
        {102, 0, "00010000", "102,3,3,5,7;"},           {142, 0, "00010000", "142,0,1,0,9,2;"},
        {144, 0, "00000000", "144,1,1,0,11;"},          {114, 0, "00000000", "114,1,1,1,1;"},
    };
    put_iges(text, "2,2HMM", "1Hx", 8, trimmed);
    reads(text, 1);
    ck_assert_double_eq_tol(area_of_first(), 32, 0.5);
    ck_assert_str_eq(set->why, "an entity of type 114");
    ck_assert_int_eq(set->left_out, 1);
}

TEST(arguments_missing_files_and_memory) {
    ck_assert_int_eq(wcut_trimmed_set_read(NULL, &set, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_trimmed_set_read("a.step", NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_trimmed_set_read("/nowhere/a.step", &set, &error), WCUT_NOT_FOUND);
    static const char text[] = HEAD(".MILLI.") SQUARE "#80=ADVANCED_FACE('',(#61,#63),#70,.F.);" SHELL HOLDER TAIL;
    EACH_FAILED_ALLOCATION(read_text(text), !set);
    ck_assert_ptr_nonnull(set);
}
