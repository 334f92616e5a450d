/* "wirecut-compensation/1": what corrected paths are worth. */
#include <stdbool.h>
#include <stdio.h>
#include <wirecut/compensation_file.h>
#include <wirecut/version.h>

#include "io/file/text.h"

static bool is_whole_compensation(const wcut_compensation_result *r) {
    return r && r->job && r->with && r->compensation;
}

/* [1] of the deviation that is taken away */
static double removed_share(double before, double after) { return before > 0 ? 1 - after / before : 0; }

wcut_status wcut_compensation_say(const wcut_compensation_result *r, int size, char *text) {
    if (!is_whole_compensation(r) || size < 1 || !text) return WCUT_BAD_ARGUMENT;
    const wcut_compensation *c = r->compensation;
    if (c->before_rms < r->worth) {
        snprintf(text, (size_t)size,
                 "The machine moves the face by %.3g mm rms, less than %.3g mm: a correction is not worth it.",
                 c->before_rms, r->worth);
        return WCUT_OK;
    }
    snprintf(text, (size_t)size,
             "The face comes to %.3g mm rms of its target, %.3g mm before: %.0f %% is removed; %.0f %% where the "
             "effects are "
             "%.0f %% smaller than assumed, %.0f %% where they are as much larger.",
             c->after_rms, c->before_rms, 100 * removed_share(c->before_rms, c->after_rms),
             100 * removed_share(r->smaller_before, r->smaller_rms), 100 * r->spread,
             100 * removed_share(r->larger_before, r->larger_rms));
    return WCUT_OK;
}

wcut_status wcut_compensation_print(const wcut_compensation_result *r, char **text) {
    if (!is_whole_compensation(r) || !text) return WCUT_BAD_ARGUMENT;
    const wcut_compensation *c = r->compensation;
    wcut_text out;
    size_t length;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;

    /* what was asked for */
    wcut_text_print(&out,
                    "{\n  \"format\": \"wirecut-compensation/1\",\n  \"version\": \"%s\",\n  \"job\": ", WCUT_VERSION);
    wcut_text_string(&out, r->job);
    wcut_text_print(&out, ",\n  \"with\": ");
    wcut_text_string(&out, r->with);
    wcut_text_print(&out, ",\n  \"target\": ");
    if (r->target)
        wcut_text_string(&out, r->target);
    else
        wcut_text_print(&out, "null");

    /* what it is worth, also where the effects are off */
    wcut_text_put_number(&out, ",\n  \"before_mm\": {\"rms\": ", c->before_rms);
    wcut_text_put_number(&out, ", \"max\": ", c->before_max);
    wcut_text_put_number(&out, "},\n  \"after_mm\": {\"rms\": ", c->after_rms);
    wcut_text_put_number(&out, ", \"max\": ", c->after_max);
    wcut_text_put_number(&out, "},\n  \"removed\": ", removed_share(c->before_rms, c->after_rms));
    wcut_text_put_number(&out, ",\n  \"spread\": ", r->spread);
    wcut_text_put_number(&out, ",\n  \"smaller_mm\": {\"before_rms\": ", r->smaller_before);
    wcut_text_put_number(&out, ", \"after_rms\": ", r->smaller_rms);
    wcut_text_put_number(&out, "},\n  \"larger_mm\": {\"before_rms\": ", r->larger_before);
    wcut_text_put_number(&out, ", \"after_rms\": ", r->larger_rms);
    wcut_text_put_number(&out, "},\n  \"worth_mm\": ", r->worth);
    wcut_text_print(&out, ",\n  \"worth_it\": %s,\n  \"runs\": %d\n}\n", c->before_rms < r->worth ? "false" : "true",
                    c->runs);
    return wcut_text_finish(&out, text, &length);
}
