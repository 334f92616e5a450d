/* The clear text encoding of STEP (ISO 10303-21), read: instances by their number, records by their name. */
#ifndef WCUT_IO_CAD_PART21_READ_H
#define WCUT_IO_CAD_PART21_READ_H

#include "io/cad/curve_set.h"

typedef struct wcut_p21_instance {
    long id;
    const char *body; /* without blanks and comments; ends with a zero */
} wcut_p21_instance;

typedef struct wcut_p21_file {
    wcut_curve_reader *reader; /* what refuses */
    int count;
    wcut_p21_instance *instance; /* count, id ascending */
} wcut_p21_file;

/* Squeeze a text and find its instances; parentheses are balanced in all of them. false: refused. The text stays the
   caller's and is what the bodies point into; wcut_p21_close in any case. */
bool wcut_p21_open(wcut_curve_reader *reader, char *text, size_t length, wcut_p21_file *file);
void wcut_p21_close(wcut_p21_file *file);

/* the body of an instance; NULL where there is none */
const char *wcut_p21_find(const wcut_p21_file *file, long id);

/* the list of arguments, from its parenthesis on, of the record NAME in a body: the whole of a simple instance, a part
   of a complex one. NULL where there is none. */
const char *wcut_p21_record(const char *body, const char *name);

/* item k of a list (from its parenthesis on); NULL where it is shorter */
const char *wcut_p21_item(const char *list, int k);

/* the item behind one; NULL at the end of its list */
const char *wcut_p21_next(const char *item);

/* items in a list; 0 where it is none */
int wcut_p21_length(const char *list);

/* what an item is: its value, or false where it is something else */
bool wcut_p21_read_real(const char *item, double *value);
bool wcut_p21_read_integer(const char *item, int min, int max, int *value);
bool wcut_p21_read_reference(const char *item, long *id);
bool wcut_p21_is(const char *item, const char *word); /* .T. and the like, or the name of a record */

#endif
