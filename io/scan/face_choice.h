/* Faces of a CAD file by what a user calls them. */
#ifndef WCUT_IO_SCAN_FACE_CHOICE_H
#define WCUT_IO_SCAN_FACE_CHOICE_H

#include <stddef.h>
#include <wirecut/read.h>

/* The faces that a text names: a name, a number from 1, several of them with commas, or "all"; NULL: the only one.
   face: room for set->count. 0: none of that name, a name twice, several where NULL. */
int wcut_face_choose(const wcut_trimmed_set *set, const char *choice, int *face);

/* numbers and names to choose from, as far as there is room */
void wcut_face_list(const wcut_trimmed_set *set, char *text, size_t size);

#endif
