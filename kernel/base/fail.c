/* Say where something failed, in one printable line. */
#include "base/fail.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/locale.h"

#undef wcut_fail
#undef wcut_fail_errno

wcut_status wcut_fail(wcut_error *error, wcut_status status, const char *format, ...) {
    if (error) {
        error->status = status;

        /* a comma locale must not change the numbers of a message */
        va_list arguments;
        va_start(arguments, format);
        locale_t before = wcut_locale_plain();
        vsnprintf(error->text, sizeof error->text, format, arguments);
        wcut_locale_restore(before);
        va_end(arguments);
    }
    return status;
}

wcut_status wcut_fail_errno(wcut_error *error, wcut_status status, int code, const char *path, const char *what) {
    char cause[128] = "", name[WCUT_QUOTE_SIZE];
    if (strerror_r(code, cause, sizeof cause) != 0) snprintf(cause, sizeof cause, "error %d", code);
    if (code == ENOMEM) status = WCUT_NO_MEMORY;
    return wcut_fail(error, status, "%s: %s: %s", wcut_quote(name, path, WCUT_LABEL_MAX, 1), what, cause);
}

/* how the byte at text[0] is shown: itself, or \xNN for control characters, C1 controls in UTF-8 among them */
static int show_byte(char to[5], const char *text, const char *begin) {
    unsigned char c = (unsigned char)text[0], before = text > begin ? (unsigned char)text[-1] : 0;
    if (c < 0x20 || c == 0x7f || (before == 0xc2 && c < 0xa0)) return snprintf(to, 5, "\\x%02x", c);
    to[0] = (char)c;
    return 1;
}

const char *wcut_quote(char to[WCUT_QUOTE_SIZE], const char *text, int max, int tail) {
    size_t length = strlen(text), keep = length < (size_t)max ? length : (size_t)max;
    const char *from = tail ? text + (length - keep) : text;
    const char *end = from + keep;
    /* never begin or end within a UTF-8 sequence */
    if (tail && keep < length)
        while (from < end && ((unsigned char)*from & 0xc0) == 0x80) from++;
    if (!tail && keep < length)
        while (end > from && ((unsigned char)*end & 0xc0) == 0x80) end--;

    /* every byte shown as a printable one, an ellipsis where text was cut off */
    size_t used = 0;
    if (tail && keep < length) used = (size_t)snprintf(to, WCUT_QUOTE_SIZE, "...");
    for (; from < end && used + 8 < WCUT_QUOTE_SIZE; from++) {
        char shown[5];
        int n = show_byte(shown, from, text);
        memcpy(to + used, shown, (size_t)n);
        used += (size_t)n;
    }

    to[used] = '\0';
    if (from < end || (!tail && keep < length)) memcpy(to + used, "...", 4);

    return to;
}
