/* IGES files: lines, sections, values and directory entries, for the readers of their entities. */
#ifndef WCUT_IO_CAD_CURVE_IGES_H
#define WCUT_IO_CAD_CURVE_IGES_H

#include "io/cad/curve_set.h"

enum { WCUT_IGES_FIELD = 8 };

/* what an entry is to others: a piece of a composite curve; a member of a subfigure, which its instances show; of a
   group; of a hidden group */
enum { WCUT_IGES_PIECE = 1, WCUT_IGES_MEMBER = 2, WCUT_IGES_GROUPED = 4, WCUT_IGES_HIDDEN = 8 };

/* the lines of a file and where its sections begin */
typedef struct wcut_iges {
    wcut_curve_reader *reader;
    int lines;
    const char **line;                /* each of at least 80 characters */
    int global, directory, data, end; /* lines */
    char separator, terminator;
    double scale; /* [mm] */
    /* of each entry, of two lines: how others use it, WCUT_IGES_PIECE and the like */
    unsigned char *mark;
} wcut_iges;

/* values one after the other, across the lines of a section */
typedef struct wcut_iges_cursor {
    const wcut_iges *f;
    int line, end; /* the next line, and the one not to be read */
    int at, width;
    bool ended; /* a terminator was passed */
} wcut_iges_cursor;

/* a directory entry, and its first line */
typedef struct wcut_iges_entry {
    int at, type, data, transformation, form, lines;
    char status[WCUT_IGES_FIELD + 1];
} wcut_iges_entry;

/* Find the lines and sections of a text, which stays the caller's and is pointed into; wcut_iges_end in any case. false:
   refused */
bool wcut_iges_begin(wcut_curve_reader *reader, char *text, size_t length, wcut_iges *f);
void wcut_iges_end(wcut_iges *f);

/* the entry at a line of the directory; false: refused */
bool wcut_iges_find(wcut_iges *f, int at, wcut_iges_entry *entry);

/* at the first value of an entry, behind its type; false: it is none, refused */
bool wcut_iges_open(wcut_iges *f, const wcut_iges_entry *entry, wcut_iges_cursor *c);

/* the next value; false: it is none, or not in the range */
bool wcut_iges_real(wcut_iges_cursor *c, double *value);
bool wcut_iges_int(wcut_iges_cursor *c, int min, int max, int *value);
bool wcut_iges_reals(wcut_iges_cursor *c, int count, double *value);
void wcut_iges_pass(wcut_iges_cursor *c);

#endif
