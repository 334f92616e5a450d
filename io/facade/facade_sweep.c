/* The elements of a facade as the cases of a sweep: the distinct ones, each with its own input. */
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/facade/element.h"
#include "io/study/sweep.h"

static bool are_options_fine(const wcut_element_options *o) {
    return o && o->thickness >= 0 && o->thickness * 0 == 0 && o->density > 0 && o->density * 0 == 0 &&
           o->chord_tolerance > 0 && o->chord_tolerance * 0 == 0;
}

/* a study whose one parameter is the whole input */
static wcut_status print_study(const char *name, const char *formats, const wcut_distinct *d, char **text,
                               size_t *length) {
    wcut_text out;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    wcut_text_put_string(&out, "{\"format\": \"wirecut-study/1\",\n\"name\": ", name);
    wcut_text_put_word(&out, ",\n\"verb\": \"facade\",\n\"input\": \"element.json\",\n\"combine\": \"zip\",\n");
    wcut_text_put_word(&out, "\"options\": {\"element\": true");
    if (formats) wcut_text_put_string(&out, ", \"formats\": ", formats);
    wcut_text_put_word(&out, "},\n\"figures\": {\"duration_s\": \"/summary/duration_s\"},\n\"parameters\": {\"\": [\n");

    /* each element's text as it is */
    for (int k = 0; k < d->count; k++) {
        if (k) wcut_text_put_word(&out, ",\n");
        wcut_text_put_word(&out, d->text[k]);
    }
    wcut_text_put_word(&out, "]}}\n");
    return wcut_text_finish(&out, text, length);
}

wcut_status wcut_facade_sweep_create(const wcut_facade_description *description, const wcut_element_options *options,
                                     const char *folder, wcut_sweep **sweep, wcut_error *error) {
    if (!description || !folder || !sweep || strchr(folder, '\n') || !are_options_fine(options))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));

    /* the study of the distinct elements */
    wcut_distinct d = {0};
    wcut_study *study = NULL;
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_distinct_create(description->facade, options, &d, error);
    if (status == WCUT_OK && print_study(description->name, options->formats, &d, &text, &length) != WCUT_OK)
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));

    /* no name in it is relative to a folder: the inputs are whole */
    if (status == WCUT_OK)
        status =
            wcut_study_parse(text, length, "the facade's elements", "/", d.text[0], strlen(d.text[0]), &study, error);
    if (status == WCUT_OK) status = wcut_sweep_plan(study, folder, sweep, error);
    free(text);
    wcut_distinct_clear(&d);
    return status;
}
