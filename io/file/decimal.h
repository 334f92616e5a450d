/* Decimal text to the nearest double, whatever the locale. */
#ifndef WCUT_IO_FILE_DECIMAL_H
#define WCUT_IO_FILE_DECIMAL_H

/* read [+-] digits [. digits] [e [+-] digits] at text, which a zero ends; gives the first character behind it, or text
   itself where there is no number. Beyond the range of a double value is +-HUGE_VAL. */
const char *wcut_decimal_read(const char *text, double *value);

#endif
