/* Any bytes as a CAD file of faces: refused in one printable line, or sound faces. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/cad/face_set.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

static void check_face(const wcut_trimmed *t) {
    const wcut_surface *s = t->surface;
    wcut_surface *again = NULL;
    check(wcut_surface_create(s->degree_u, s->degree_v, s->count_u, s->count_v, s->knots_u, s->knots_v, s->control,
                              s->weights, &again) == WCUT_OK);
    wcut_surface_destroy(again);
    for (int k = 0; t->loops > 0 && k < t->first[t->loops]; k++)
        check(isfinite(t->uv[2 * k]) && isfinite(t->uv[2 * k + 1]) && isfinite(t->point[k].x));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    wcut_trimmed_set *set = NULL;
    wcut_error error = {WCUT_OK, ""};
    char *text = malloc(size + 1);
    if (!text) return 0;
    if (size > 0) memcpy(text, data, size);
    text[size] = '\0';
    const wcut_status status = wcut_trimmed_set_read_memory(text, size, "fuzz", &set, &error);
    free(text);
    if (status != WCUT_OK) {
        check(set == NULL && (status == WCUT_BAD_FORMAT || status == WCUT_NO_MEMORY) && error.text[0] != '\0');
        for (const char *p = error.text; *p; p++) check((unsigned char)*p >= 0x20 && *p != 0x7f);
        return 0;
    }
    check(set->count > 0);
    for (int k = 0; k < set->count; k++) check_face(set->face[k]);
    wcut_trimmed_set_destroy(set);
    return 0;
}
