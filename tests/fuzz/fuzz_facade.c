/* Any bytes as a facade, and as an element of one: never a crash, and what is read is whole. No file that it names is
   there but by chance: names lead into a folder that does not exist. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/facade/description.h"
#include "io/facade/element.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

static void check_element(const wcut_element *e) {
    check(e->job != NULL && e->options.density > 0 && e->options.chord_tolerance > 0 && e->options.thickness >= 0);
    for (int b = 0; b < 4; b++)
        for (int k = 0; e->border[b] && k < WCUT_FACADE_SAMPLES; k++) check(isfinite(e->border[b][k]));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    wcut_facade_description *description = NULL;
    wcut_element *element = NULL;
    wcut_error error = {WCUT_OK, ""};
    char *text = calloc(size + 1, 1);
    check(text != NULL);
    memcpy(text, data, size);

    /* as a facade; an absolute name would be opened, so none is tried */
    wcut_status status = WCUT_BAD_FORMAT;
    if (!memchr(data, '/', size) || strstr(text, "\"/") == NULL)
        status = wcut_facade_parse(text, size, "facade.json", "/nowhere/", &description, &error);
    check((status == WCUT_OK) == (description != NULL));
    wcut_facade_description_destroy(description);

    /* as an element */
    status = wcut_element_parse(text, size, "element.json", &element, &error);
    check((status == WCUT_OK) == (element != NULL) && (status == WCUT_OK || error.text[0] != '\0'));
    if (element) check_element(element);
    wcut_element_destroy(element);
    free(text);
    return 0;
}
