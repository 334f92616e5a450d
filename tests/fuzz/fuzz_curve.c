/* Any bytes as a file of curves; the first says in which format: refused in one printable line, or sound curves. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/cad/curve_set.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

static void check_refusal(const wcut_error *error, wcut_status status, const wcut_curve_set *set) {
    check(set == NULL && status == WCUT_BAD_FORMAT && error->status == status && error->text[0] != '\0');
    for (const char *p = error->text; *p; p++) check((unsigned char)*p >= 0x20 && *p != 0x7f);
}

static void check_curve(const wcut_curve *c) {
    wcut_curve *again = NULL;
    check(wcut_curve_create(c->degree, c->control_count, c->knots, c->control, c->weights, &again) == WCUT_OK);
    wcut_curve_destroy(again);
    for (int k = 0; k < c->control_count; k++)
        check(fabs(c->control[k].x) <= 1e15 && fabs(c->control[k].y) <= 1e15 && fabs(c->control[k].z) <= 1e15);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    wcut_curve_read_options options = wcut_curve_read_options_default();
    wcut_curve_set *set = NULL;
    wcut_error error = {WCUT_OK, ""};
    if (size < 1) return 0;
    options.format = (wcut_curve_format)(WCUT_CURVE_FORMAT_STEP + data[0] % 4);
    char *text = malloc(size);
    if (!text) return 0;
    memcpy(text, data + 1, size - 1);
    text[size - 1] = '\0';
    const wcut_status status = wcut_curve_set_read_memory(text, size - 1, "fuzz", &options, &set, &error);
    free(text);
    if (status != WCUT_OK) {
        check_refusal(&error, status, set);
        return 0;
    }
    check(set->count > 0);
    for (int k = 0; k < set->count; k++) {
        check_curve(set->curve[k]);
        for (const char *p = set->name[k]; *p; p++) check((unsigned char)*p >= 0x20 && *p != 0x7f);
    }
    wcut_curve_set_destroy(set);
    return 0;
}
