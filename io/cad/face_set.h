/* A set of faces that grows as a file is read. */
#ifndef WCUT_IO_CAD_FACE_SET_H
#define WCUT_IO_CAD_FACE_SET_H

#include "io/cad/curve_set.h"

enum { WCUT_FACES_MAX = 10000, WCUT_FACE_CURVES_MAX = 10000 };

/* the loops of a face as they are read */
typedef struct wcut_face_loops {
    int loops, curves, room_loops, room_curves;
    int *count; /* loops: curves of each */
    wcut_curve **curve;
} wcut_face_loops;

typedef struct wcut_face_reader {
    wcut_curve_reader *curves; /* refuses, leaves out; its set stays empty */
    wcut_trimmed_set *set;
    int room;
} wcut_face_reader;

/* a further loop, and a curve at the end of the last one, which is taken; false: refused */
bool wcut_face_loops_begin(wcut_face_reader *reader, wcut_face_loops *loops);
bool wcut_face_loops_add(wcut_face_reader *reader, wcut_face_loops *loops, wcut_curve *curve);
void wcut_face_loops_clear(wcut_face_loops *loops);

/* A surface (taken) with its loops becomes a face of the set, or is left out with the reason why. false: refused */
bool wcut_faces_add(wcut_face_reader *reader, wcut_surface *surface, const wcut_face_loops *loops, const char *name,
                    size_t length);

/* the formats' readers */
bool wcut_faces_fill_step(wcut_face_reader *reader, char *text, size_t length);
bool wcut_faces_fill_iges(wcut_face_reader *reader, char *text, size_t length);

/* all of it from memory, text being changed; for the file reader, tests and fuzzers */
wcut_status wcut_trimmed_set_read_memory(char *text, size_t length, const char *label, wcut_trimmed_set **set,
                                         wcut_error *error);

#endif
