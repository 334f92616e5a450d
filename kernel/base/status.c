/* Status texts and the version. */
#include <wirecut/status.h>
#include <wirecut/version.h>

const char *wcut_status_text(wcut_status status) {
#define WCUT_STATUS_ENTRY(name, text) text,
    static const char *const text[] = {WCUT_STATUS_LIST(WCUT_STATUS_ENTRY)};
#undef WCUT_STATUS_ENTRY
    return (unsigned)status < WCUT_STATUS_COUNT ? text[status] : "unknown status";
}

const char *wcut_version_text(void) { return WCUT_VERSION; }
