/* How near a misspelt word is to a known one. */
#ifndef WCUT_IO_FILE_NEAREST_H
#define WCUT_IO_FILE_NEAREST_H

/* [byte] of the longest word that is compared */
enum { WCUT_NEAREST_MAX = 96 };

/* edits between two words: insertion, deletion, replacement, swap of neighbours (Damerau 1964, restricted).
   WCUT_NEAREST_MAX where one is longer than that. */
int wcut_edit_distance(const char *a, const char *b);

#endif
