/* Numbers as text: the shortest that reads back the same, whatever the locale. */
#ifndef WCUT_IO_FILE_NUMBER_H
#define WCUT_IO_FILE_NUMBER_H

#include <stdint.h>

enum { WCUT_NUMBER_SIZE = 32 };

/* print a double, without a terminating zero; gives the length. Not finite: "nan", "inf", "-inf". */
int wcut_number_print(double value, char text[WCUT_NUMBER_SIZE]);

/* the same of a whole number */
int wcut_integer_print(uint64_t value, char text[WCUT_NUMBER_SIZE]);

#endif
