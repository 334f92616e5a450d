/* Decimal points in the calling thread, whatever the program's locale. */
#ifndef WCUT_BASE_LOCALE_H
#define WCUT_BASE_LOCALE_H

#include <locale.h>

/* let the calling thread use the "C" locale; gives the one to go back to */
locale_t wcut_locale_plain(void);

/* go back to the locale that wcut_locale_plain gave */
void wcut_locale_restore(locale_t before);

#endif
