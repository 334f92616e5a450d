/* The curves of files that were once read wrong, each with its true length; they lie in ../shared/found. */
#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include <wirecut/curve_measure.h>
#include <wirecut/read.h>

#include "test.h"

enum { CURVES_MAX = 2 };

/* lengths [mm], and the height of each curve's middle where the file moves it; NAN: not looked at */
typedef struct found_file {
    const char *path;
    int count;
    double length[CURVES_MAX], middle_z[CURVES_MAX];
    double tolerance; /* [mm] of the lengths */
} found_file;

/* user/g1.csv .. g4.csv and edges_fc_gui.step are splines through the same points, which scipy finds 923.4153 and 911.6077
   long; programs end their splines differently, by less than 0.5 mm of length */
static const found_file files[] = {
    {"geo/iges-spline-range-ignored/whole.igs", 2, {903.8361235, 900.2962086}, {NAN, NAN}, 1e-6},
    {"geo/iges-spline-range-ignored/range.igs", 2, {903.8361235, 900.2962086}, {NAN, NAN}, 1e-6},
    {"geo/iges-spline-range-ignored/rational.igs", 1, {457.5486015}, {NAN}, 1e-6},
    {"geo/iges-spline-range-ignored/degree1.igs", 1, {738.6643351}, {NAN}, 1e-6}, /* 1.5 hypot(450, 200) */
    {"geo/iges-spline-range-ignored/composite.igs", 1, {900}, {100}, 1e-6},
    {"geo/iges-unit-by-name/mm.igs", 2, {900, 900}, {140, 140}, 1e-6},
    {"geo/iges-unit-by-name/cm.igs", 2, {9000, 9000}, {1400, 1400}, 1e-6},
    {"geo/iges-unit-by-name/in.igs", 2, {22860, 22860}, {3556, 3556}, 1e-6},
    {"geo/iges-unit-by-name/inch.igs", 2, {22860, 22860}, {3556, 3556}, 1e-6},
    {"geo/iges-utf8-name/name.igs", 2, {900, 900}, {140, 140}, 1e-6},
    {"geo/iges-utf8-name/blanks.igs", 2, {900, 900}, {140, 140}, 1e-6},
    {"geo/step-assembly-that-moves-nothing/unmoved.step", 2, {912.5354686, 907.3892136}, {NAN, 190}, 1e-6},
    {"geo/step-assembly-that-moves-nothing/moved.step", 2, {912.5354686, 907.3892136}, {NAN, 200}, 1e-6},
    {"geo/step-edges-in-pieces/pieces.step", 2, {900, 900}, {140, 140}, 1e-6},
    {"geo/step-edges-in-pieces/gap.step", 2, {900, 900}, {140, 140}, 1e-6},
    /* the Bezier curve's length: numpy, to 1e-8 mm */
    {"geo/step-edges-in-pieces/bezier.step", 2, {902.3948900, 900}, {NAN, 140}, 1e-6},
    {"geo/step-edges-in-pieces/trimmed.step", 2, {NAN, 900}, {NAN, 140}, 1e-6},
    {"geo/step-edges-in-pieces/nested.step", 2, {900, 900}, {140, 140}, 1e-6},
    {"user/edges_fc_gui.step", 2, {923.4153, 911.6077}, {NAN, NAN}, 0.5},
    {"user/g1.csv", 2, {923.4153, 911.6077}, {NAN, NAN}, 0.5},
    {"user/g2.csv", 2, {923.4153, 911.6077}, {NAN, NAN}, 0.5},
    {"user/g3.csv", 2, {923.4153, 911.6077}, {NAN, NAN}, 0.5},
    {"user/g4.csv", 2, {923.4153, 911.6077}, {NAN, NAN}, 0.5},
    {"user/g5.json", 2, {900, 900}, {150, 150}, 1e-6},
    {"user/g6.json", 2, {900, 900}, {150, 150}, 1e-6},
    {"user/g7.json", 2, {900, 900}, {150, 150}, 1e-6},
};

static void is_curve(const found_file *f, const wcut_curve *curve, int k) {
    double first, last, length = 999;
    wcut_vec3 middle;
    wcut_curve_domain(curve, &first, &last);
    ck_assert_int_eq(wcut_curve_length(curve, first, last, &length), WCUT_OK);
    ck_assert_msg(isnan(f->length[k]) || fabs(length - f->length[k]) < f->tolerance,
                  "%s: curve %d: found %.7f mm, expected %.7f", f->path, k, length, f->length[k]);
    ck_assert_int_eq(wcut_curve_eval(curve, (first + last) / 2, 0, &middle), WCUT_OK);
    ck_assert_msg(isnan(f->middle_z[k]) || fabs(middle.z - f->middle_z[k]) < 1e-6,
                  "%s: curve %d: its middle is at z = %.7f, expected %.7f", f->path, k, middle.z, f->middle_z[k]);
}

TEST(files_once_read_wrong_give_their_curves) {
    static const char folder[] = WCUT_SOURCE_DIR "/../shared/found";
    if (access(folder, R_OK) != 0) SKIP("no ../shared/found here");
    for (size_t n = 0; n < sizeof files / sizeof *files; n++) {
        const found_file *f = &files[n];
        char path[1000];
        wcut_curve_set *set = NULL;
        wcut_error error = {WCUT_OK, ""};
        snprintf(path, sizeof path, "%s/%s", folder, f->path);
        ck_assert_msg(wcut_curve_set_read(path, NULL, &set, &error) == WCUT_OK, "%s", error.text);
        ck_assert_msg(set->count == f->count && set->left_out == 0, "%s: found %d curves, %d left out: %s", f->path,
                      set->count, set->left_out, set->why);
        for (int k = 0; k < f->count; k++) is_curve(f, set->curve[k], k);
        wcut_curve_set_destroy(set);
    }
}
