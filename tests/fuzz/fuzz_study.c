/* Any bytes as a study of a small input: never a crash; every case that it says it has can be made. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/study/study.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

static void check_case(const wcut_study *study, int k) {
    char *text = NULL, hash[WCUT_STUDY_HASH_SIZE];
    json_error_t cause;
    check(wcut_study_hash_eval(study, k, hash) == WCUT_OK && strlen(hash) == 64);
    check(wcut_study_call_print(study, k, "DIR", &text) == WCUT_OK);
    free(text);
    text = NULL;
    check(wcut_study_input_print(study, k, &text) == WCUT_OK);
    json_t *root = *text ? json_loads(text, 0, &cause) : json_null();
    check(root != NULL);
    json_decref(root);
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const char input[] = "{\"a\": 1, \"b\": [true, null, {\"c\": \"d\"}], \"e/f\": 1e-3}";
    wcut_study *study = NULL;
    wcut_error error = {WCUT_OK, ""};

    /* the text has a zero behind it, as a file that was read has */
    char *text = calloc(size + 1, 1);
    check(text != NULL);
    memcpy(text, data, size);
    const wcut_status status =
        wcut_study_parse(text, size, "study.json", "/nowhere/", input, strlen(input), &study, &error);
    check((status == WCUT_OK) == (study != NULL) && (status == WCUT_OK || error.text[0] != '\0'));
    if (study) {
        const int cases = wcut_study_view(study)->cases;
        check(cases >= 1 && cases <= WCUT_STUDY_CASES_MAX);
        check_case(study, 0);
        check_case(study, cases / 2);
        check_case(study, cases - 1);
    }
    wcut_study_destroy(study);
    free(text);
    return 0;
}
