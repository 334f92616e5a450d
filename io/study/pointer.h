/* JSON pointers (RFC 6901): the value that one names, and the one that a misspelt pointer was meant to be. */
#ifndef WCUT_IO_STUDY_POINTER_H
#define WCUT_IO_STUDY_POINTER_H

#include <jansson.h>
#include <stdbool.h>

/* [byte] of a pointer with its zero byte */
enum { WCUT_POINTER_SIZE = 256 };

/* whether a text is a pointer: "" or /name/name..., ~ followed by 0 or 1 */
bool wcut_pointer_is_valid(const char *text);

/* the value in a document; NULL: there is none */
json_t *wcut_pointer_locate(json_t *root, const char *pointer);

/* put a value (its reference is taken over) where a pointer names one already; false: it names none, or no memory */
bool wcut_pointer_replace(json_t *root, const char *pointer, json_t *value);

/* The pointer nearest to one that names nothing: that of the same last name, else of the fewest edits. false: the
   document has none. */
bool wcut_pointer_nearest(const json_t *root, const char *pointer, char nearest[WCUT_POINTER_SIZE]);

/* whether one is the other, or leads to a place inside it */
bool wcut_pointer_overlaps(const char *a, const char *b);

#endif
