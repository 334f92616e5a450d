/* Status texts, and saying where something failed. */
#include "base/fail.h"

#include <stdarg.h>
#include <stdio.h>
#include <wirecut/version.h>

const char *wcut_status_text(wcut_status status) {
#define WCUT_STATUS_ENTRY(name, text) text,
    static const char *const text[] = {WCUT_STATUS_LIST(WCUT_STATUS_ENTRY)};
#undef WCUT_STATUS_ENTRY
    return (unsigned)status < WCUT_STATUS_COUNT ? text[status] : "unknown status";
}

const char *wcut_version_text(void) { return WCUT_VERSION; }

#undef wcut_fail
wcut_status wcut_fail(wcut_error *error, wcut_status status, const char *format, ...) {
    if (error) {
        error->status = status;
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(error->text, sizeof error->text, format, arguments);
        va_end(arguments);
    }
    return status;
}
