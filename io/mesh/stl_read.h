/* The corners of an STL file, binary or ASCII, three a triangle. */
#ifndef WCUT_IO_STL_READ_H
#define WCUT_IO_STL_READ_H

#include "io/file/source.h"

typedef struct wcut_stl_reader {
    wcut_source *source;
    bool is_binary;
    int64_t stated; /* triangles that a binary file holds; -1: ASCII states none */
    int64_t left;   /* of binary: corners not yet read */
    int state;      /* of ASCII: the line that is expected next */
} wcut_stl_reader;

/* find out which kind it is, read what is before the first triangle; false: refused, the source holds the failure */
bool wcut_stl_begin(wcut_source *source, wcut_stl_reader *reader);

/* the next corner, in the file's unit; false: the end, or refused */
bool wcut_stl_next(wcut_stl_reader *reader, double corner[3]);

#endif
