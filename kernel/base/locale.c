/* Decimal points in the calling thread, whatever the program's locale. */
#include "base/locale.h"

locale_t wcut_locale_plain(void) {
    /* glibc and musl answer "C" with a constant object: nothing to free, nothing that can fail */
    return uselocale(newlocale(LC_ALL_MASK, "C", (locale_t)0));
}

void wcut_locale_restore(locale_t before) { uselocale(before); }
