/* --formats: which of a verb's files are written. */
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "terminal.h"

static bool is_in_list(const char *list, const char *word) {
    const size_t length = strlen(word);
    for (const char *at = list;; at++) {
        const size_t part = strcspn(at, ",");
        if (part == length && strncmp(at, word, length) == 0) return true;
        at += part;
        if (!*at) return false;
    }
}

bool app_wants_format(const app_call *call, const char *format) {
    return !app_given(call, "formats") || is_in_list(app_text(call, "formats"), format);
}

int app_check_formats(const app_call *call, const char *known) {
    if (!app_given(call, "formats")) return APP_DONE;
    char word[32];
    for (const char *at = app_text(call, "formats");; at++) {
        const size_t part = strcspn(at, ",");
        snprintf(word, sizeof word, "%.*s", part < sizeof word ? (int)part : (int)sizeof word - 1, at);
        if (!is_in_list(known, word))
            return app_fail(APP_USAGE, "--formats: found \"%s\", expected some of %s", word, known);
        at += part;
        if (!*at) return APP_DONE;
    }
}
