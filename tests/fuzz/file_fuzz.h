/* Any bytes as a file of its own, for readers that take a path. */
#ifndef WCUT_TESTS_FUZZ_FILE_FUZZ_H
#define WCUT_TESTS_FUZZ_FILE_FUZZ_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include <wirecut/status.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static inline void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

/* the path of a file with these bytes, to remove(); NULL: not written */
static inline const char *fuzz_file(const uint8_t *data, size_t size, const char *ending) {
    static char path[80];
    snprintf(path, sizeof path, "/tmp/wirecut-fuzz-%d.%s", (int)getpid(), ending);
    FILE *file = fopen(path, "wb");
    if (!file) return NULL;
    const bool whole = fwrite(data, 1, size, file) == size;
    if (fclose(file) == 0 && whole) return path;
    remove(path);
    return NULL;
}

/* a refusal of what the bytes are: a status that fits and one printable line; made: whether something was handed out */
static inline void check_refusal(wcut_status status, bool made, const wcut_error *error) {
    check((status == WCUT_OK) == made);
    if (made) return;
    check((status == WCUT_BAD_FORMAT || status == WCUT_BAD_ARGUMENT || status == WCUT_DEGENERATE) && error->text[0]);
    for (const char *p = error->text; *p; p++) check((unsigned char)*p >= 0x20 && *p != 0x7f);
}

#endif
