/* "wirecut-compensation/1": what corrected paths are worth. */
#include <stdbool.h>
#include <stdio.h>
#include <wirecut/compensation_file.h>
#include <wirecut/version.h>

#include "io/file/text.h"

static bool is_whole_compensation(const wcut_compensation_result *r) {
    return r && r->job && r->with && r->compensation && r->effects >= 0 && (r->effects == 0 || (r->effect && r->moved));
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

    /* the gain, also where the effects are off */
    int used = snprintf(text, (size_t)size,
                        "The face comes to %.3g mm rms of its target, %.3g mm before: %.0f %% is removed; ",
                        c->after_rms, c->before_rms, 100 * removed_share(c->before_rms, c->after_rms));
    const double smaller = 100 * removed_share(r->smaller_before, r->smaller_rms);
    const double larger = 100 * removed_share(r->larger_before, r->larger_rms);
    if (used < size && r->interval)
        used += snprintf(text + used, (size_t)(size - used),
                         "%.0f %% and %.0f %% at the ends of the effects' 95 %% intervals.", smaller, larger);
    else if (used < size)
        used += snprintf(
            text + used, (size_t)(size - used),
            "%.0f %% where the effects are %.0f %% smaller than assumed, %.0f %% where they are as much larger.",
            smaller, 100 * r->spread, larger);

    /* what is not worth it, and what to be careful of */
    for (int e = 0; e < r->effects && used < size; e++)
        if (r->moved[e] < r->worth)
            used += snprintf(text + used, (size_t)(size - used), " %s alone moves the face by %.2g mm: not worth it.",
                             wcut_effect_view(r->effect[e].kind)->name, r->moved[e]);
    if (c->branch >= 0 && used < size)
        snprintf(text + used, (size_t)(size - used),
                 " From station %d on the corrected wire bows to the other side: another solution of first contact.",
                 c->branch);
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
    wcut_text_print(&out, ",\n  \"ends\": \"%s\"", r->interval ? "ci95" : "spread");
    if (!r->interval) wcut_text_put_number(&out, ",\n  \"spread\": ", r->spread);
    wcut_text_put_number(&out, ",\n  \"smaller_mm\": {\"before_rms\": ", r->smaller_before);
    wcut_text_put_number(&out, ", \"after_rms\": ", r->smaller_rms);
    wcut_text_put_number(&out, "},\n  \"larger_mm\": {\"before_rms\": ", r->larger_before);
    wcut_text_put_number(&out, ", \"after_rms\": ", r->larger_rms);
    wcut_text_put_number(&out, "},\n  \"worth_mm\": ", r->worth);
    wcut_text_print(&out, ",\n  \"worth_it\": %s,\n  \"effects\": [", c->before_rms < r->worth ? "false" : "true");
    for (int e = 0; e < r->effects; e++) {
        wcut_text_print(&out, "%s{\"name\": ", e ? ", " : "");
        wcut_text_string(&out, wcut_effect_view(r->effect[e].kind)->name);
        wcut_text_put_number(&out, ", \"moves_mm\": ", r->moved[e]);
        wcut_text_print(&out, ", \"worth_it\": %s}", r->moved[e] < r->worth ? "false" : "true");
    }
    wcut_text_print(&out, "],\n  \"branch_station\": ");
    if (c->branch >= 0)
        wcut_text_print(&out, "%d", c->branch);
    else
        wcut_text_print(&out, "null");
    wcut_text_print(&out, ",\n  \"runs\": %d\n}\n", c->runs);
    return wcut_text_finish(&out, text, &length);
}
