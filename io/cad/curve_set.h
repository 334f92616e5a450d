/* A set of curves that grows as a file is read, and how a reader of curves refuses. */
#ifndef WCUT_IO_CAD_CURVE_SET_H
#define WCUT_IO_CAD_CURVE_SET_H

#include <stdbool.h>
#include <stddef.h>
#include <wirecut/read.h>

typedef struct wcut_curve_reader {
    const char *label;
    const wcut_curve_read_options *options;
    wcut_curve_set *set;
    size_t room;     /* of set->curve and set->name */
    double accuracy; /* [mm] that the file states, 0: none; what is nearer is one place */
    wcut_error failure;
} wcut_curve_reader;

/* each of these: false means refused, the reader holds the failure */

/* "LABEL: ..." */
bool wcut_curves_refuse(wcut_curve_reader *reader, const char *format, ...) __attribute__((format(printf, 2, 3)));
bool wcut_curves_refuse_memory(wcut_curve_reader *reader);

/* a curve becomes the set's, or is destroyed; its name (length bytes) is copied, control characters left out */
bool wcut_curves_add(wcut_curve_reader *reader, wcut_curve *curve, const char *name, size_t length);

/* the accuracy that a file states, up to 0.1 mm */
void wcut_curves_use_accuracy(wcut_curve_reader *reader, double accuracy);

/* Curves in their order become one of the set's where each begins where the one before ends, within 1e-3 mm or the accuracy
   that the file states, else each for itself; all are taken, and the array too. */
bool wcut_curves_add_chain(wcut_curve_reader *reader, int count, wcut_curve **curve, const char *name, size_t length);

/* Of the set's curves from the first-th on, those that meet end to end, where no third one ends and without a corner
   of more than 60 deg, become one, in either direction; a ring stays in its pieces, and two curves stay two. false: refused */
bool wcut_curves_join_loose(wcut_curve_reader *reader, int first);

/* a curve that is not read, since it is of that kind */
void wcut_curves_leave_out(wcut_curve_reader *reader, const char *kind);

/* a curve of a file's numbers, checked; in millimetres. NULL: refused, with `place` in front of the cause */
wcut_curve *wcut_curves_make(wcut_curve_reader *reader, const char *place, int degree, int count, const double *knots,
                             const wcut_vec3 *control, const double *weights);

/* the part of a curve, which is taken, from one parameter to a later one; NULL: refused, or of no length and left out */
wcut_curve *wcut_curves_cut(wcut_curve_reader *reader, wcut_curve *curve, double from, double to);

/* degree 1 through count points at even parameters; points in the place of the one before are passed over */
wcut_curve *wcut_curves_polyline(wcut_curve_reader *reader, const char *place, int count, const wcut_vec3 *point);

/* the formats' readers: text of length bytes, with a zero behind them */
typedef bool wcut_curves_fill(wcut_curve_reader *reader, char *text, size_t length);
wcut_curves_fill wcut_curves_fill_step, wcut_curves_fill_iges, wcut_curves_fill_json, wcut_curves_fill_csv;

/* all of it from memory, text being changed; for the file reader, tests and fuzzers */
wcut_status wcut_curve_set_read_memory(char *text, size_t length, const char *label,
                                       const wcut_curve_read_options *options, wcut_curve_set **set, wcut_error *error);

#endif
