/* "wirecut-summary/1": a cut in a few figures. */
#include <math.h>
#include <stdlib.h>
#include <wirecut/feasibility.h>
#include <wirecut/summary.h>
#include <wirecut/version.h>
#include <wirecut/write.h>

#include <wirecut/angle.h>
#include "base/fail.h"
#include "io/file/text.h"
#include "io/process/history_check.h"

/* {"min": .., "max": ..}, the range times a factor */
static void put_summary_range(wcut_text *text, const char *before, wcut_range range, double factor) {
    wcut_text_print(text, "%s", before);
    wcut_text_put_number(text, "{\"min\": ", factor * range.min);
    wcut_text_put_number(text, ", \"max\": ", factor * range.max);
    wcut_text_print(text, "}");
}

static void put_counts(wcut_text *text, const wcut_summary *s) {
    wcut_text_print(text, ",\n  \"speed_set_by\": ");
    for (int k = 0; k <= WCUT_CONDITION_TIME; k++)
        wcut_text_print(text, "%s\"%s\": %d", k ? ", " : "{", wcut_condition_name((wcut_condition)k), s->conditions[k]);
    wcut_text_print(text, "},\n  \"phases\": ");
    for (int k = 0; k <= WCUT_PHASE_LEFT; k++)
        wcut_text_print(text, "%s\"%s\": %d", k ? ", " : "{", wcut_phase_name((wcut_phase)k), s->phases[k]);
    wcut_text_print(text, "}");
}

/* the names of a job's effects that act in the step, or of those that do not; neutral ones are none */
static void put_effects(wcut_text *text, const char *key, const wcut_job *job, bool in_step) {
    int listed = 0;
    for (int k = 0; k < job->effect_count; k++) {
        const wcut_effect_info *info = wcut_effect_view(job->effect[k].kind);
        if ((info->place == WCUT_EFFECT_PLACE_STEP) != in_step || wcut_effect_is_neutral(&job->effect[k])) continue;
        if (listed++ == 0)
            wcut_text_print(text, ",\n  \"%s\": [\"%s\"", key, info->name);
        else
            wcut_text_print(text, ", \"%s\"", info->name);
    }
    if (listed) wcut_text_print(text, "]");
}

static void put_summary_head(wcut_text *text, const wcut_setup *setup, const wcut_history *h) {
    const wcut_job *job = wcut_setup_job(setup);
    bool implicit = wcut_setup_options(setup)->integrator == WCUT_INTEGRATOR_IMPLICIT;
    wcut_text_print(text, "{\n  \"format\": \"wirecut-summary/1\",\n  \"version\": \"%s\",\n  \"job\": ", WCUT_VERSION);
    wcut_text_string(text, job->name);
    wcut_text_print(text, ",\n  \"mode\": \"%s\",\n  \"integrator\": \"%s\"",
                    job->mode == WCUT_MODE_PATH ? "path" : "design", implicit ? "implicit" : "heun");
    wcut_text_print(text, ",\n  \"stations\": %d,\n  \"planned_stations\": %d,\n  \"complete\": %s,\n  \"nodes\": %d",
                    h->stations, h->planned, h->stations == h->planned ? "true" : "false", h->nodes);
    put_effects(text, "effects", job, true);
    put_effects(text, "effects_not_shown", job, false);
    if (h->ended.status != WCUT_OK) {
        wcut_text_print(text, ",\n  \"ended\": ");
        wcut_text_string(text, h->ended.text);
    }
}

static void put_summary_figures(wcut_text *text, const wcut_summary *s) {
    wcut_text_put_number(text, ",\n  \"duration_s\": ", s->duration);
    wcut_text_put_number(text, ",\n  \"speed_mm_s\": {\"min\": ", s->speed.min);
    wcut_text_put_number(text, ", \"median\": ", s->speed_median);
    wcut_text_put_number(text, ", \"max\": ", s->speed.max);
    wcut_text_print(text, "}");
    put_summary_range(text, ",\n  \"alpha_deg\": ", s->alpha, WCUT_DEG_PER_RAD);
    put_summary_range(text, ",\n  \"beta_deg\": ", s->beta, WCUT_DEG_PER_RAD);
    put_summary_range(text, ",\n  \"tension_N\": ", s->tension, 1);
    wcut_text_put_number(text, ",\n  \"force_N_per_mm\": {\"max\": ", s->force_line_max);
    wcut_text_put_number(text, "},\n  \"residual\": {\"max\": ", s->residual_max);
    wcut_text_put_number(text, "},\n  \"iterations\": {\"mean\": ", s->iterations_mean);
    wcut_text_put_number(text, ", \"max\": ", s->iterations_max);
    wcut_text_put_number(text, "},\n  \"substeps\": {\"mean\": ", s->substeps_mean);
    wcut_text_put_number(text, ", \"max\": ", s->substeps_max);
    wcut_text_print(text, "}");
    put_counts(text, s);
}

/* the verdict by the default limits, from the mounts' ways */
static bool put_feasibility(wcut_text *text, const wcut_setup *setup, const wcut_history *h) {
    wcut_feasibility v;
    double length;
    wcut_vec3 *way = calloc(2 * (size_t)h->stations, sizeof *way);
    if (!way) return false;
    wcut_status status = wcut_history_path(setup, h, way, way + h->stations, &length, NULL);
    if (status == WCUT_OK)
        status = wcut_feasibility_eval(wcut_setup_job(setup), h, way, way + h->stations, NULL, &v, NULL);
    free(way);
    if (status != WCUT_OK) return true; /* no limits for such a wire: nothing is said */
    wcut_text_print(text, ",\n  \"feasibility\": {\"verdict\": \"%s\", \"reason\": ", wcut_feasibility_name(v.verdict));
    wcut_text_string(text, v.reason);
    if (v.station >= 0) wcut_text_print(text, ", \"station\": %d", v.station);
    if (isfinite(v.radius_min)) wcut_text_put_number(text, ", \"radius_min_mm\": ", v.radius_min);
    wcut_text_print(text, "}");
    return true;
}

static bool has_summary(const wcut_setup *setup, const wcut_history *h) {
    if (!setup || !wcut_history_is_usable(h) || !h->force_line) return false;
    for (size_t i = 0; i < (size_t)h->stations * (size_t)h->nodes; i++)
        if (!isfinite(h->force_line[i])) return false;
    return true;
}

static wcut_status print_summary(const wcut_setup *setup, const wcut_history *h, char **text, size_t *length) {
    if (!has_summary(setup, h)) return WCUT_BAD_ARGUMENT;
    wcut_summary summary;
    wcut_text out;
    if (wcut_summary_eval(h, &summary) != WCUT_OK || !wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    put_summary_head(&out, setup, h);
    put_summary_figures(&out, &summary);
    if (!put_feasibility(&out, setup, h)) {
        wcut_text_destroy(&out);
        return WCUT_NO_MEMORY;
    }
    wcut_text_print(&out, "\n}\n");
    return wcut_text_finish(&out, text, length);
}

wcut_status wcut_summary_print(const wcut_setup *setup, const wcut_history *history, char **text) {
    size_t length;
    return text ? print_summary(setup, history, text, &length) : WCUT_BAD_ARGUMENT;
}

wcut_status wcut_summary_write(const wcut_setup *setup, const wcut_history *history, const char *path,
                               wcut_error *error) {
    char *text = NULL;
    size_t length = 0;
    wcut_status status = path ? print_summary(setup, history, &text, &length) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_fail(error, status, "a summary: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, length, error);
    free(text);
    return status;
}
