/* Any bytes as a job: refused with one printable line, or a job whose text reads back to the same text. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/process/job.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

static void check_line(const wcut_error *error, wcut_status status) {
    check(error->status == status && error->text[0] != '\0');
    for (const char *p = error->text; *p; p++) check((unsigned char)*p >= 0x20 && *p != 0x7f);
}

/* what was read is written and read again without a loss */
static void check_round_trip(const wcut_job *job) {
    wcut_job *again = NULL;
    char *text = NULL, *text_again = NULL;
    size_t length = 0, length_again = 0;
    check(wcut_job_print(job, "fuzz", &text, &length, NULL) == WCUT_OK);
    check(wcut_job_parse(text, length, "fuzz", &again, NULL) == WCUT_OK);
    check(wcut_job_print(again, "fuzz", &text_again, &length_again, NULL) == WCUT_OK);
    check(length == length_again && memcmp(text, text_again, length) == 0);
    wcut_job_destroy(again);
    free(text);
    free(text_again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    wcut_job *job = NULL;
    wcut_error error = {WCUT_OK, ""};
    wcut_status status = wcut_job_parse((const char *)data, size, "fuzz", &job, &error);
    check((status == WCUT_OK) == (job != NULL));
    if (status != WCUT_OK)
        check_line(&error, status);
    else
        check_round_trip(job);
    wcut_job_destroy(job);
    return 0;
}
