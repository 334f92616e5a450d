/* "wirecut-control/1": a closed loop in a few figures, with feedback and with the plan alone. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/rig.h>
#include <wirecut/rig_file.h>
#include <wirecut/version.h>

#include <wirecut/angle.h>
#include "base/fail.h"
#include "io/file/text.h"

static void put(wcut_text *text, const char *before, double value) {
    wcut_text_print(text, "%s", before);
    wcut_text_number(text, value);
}

static void put_settings(wcut_text *text, const wcut_control_settings *s) {
    put(text, ",\n  \"settings\": {\"gain\": ", s->gain);
    put(text, ", \"rate_per_s\": ", s->rate);
    put(text, ", \"filter_s\": ", s->filter);
    put(text, ", \"authority\": ", s->authority);
    put(text, ", \"caution\": ", s->caution);
    put(text, ", \"margin_mm\": ", s->margin);
    put(text, ",\n    \"exponent_speed_mm_s\": ", s->exponent_speed);
    put(text, ", \"acceleration_mm_s2\": ", s->acceleration);
    put(text, ", \"speed_min_mm_s\": ", s->speed_min);
    put(text, ", \"speed_max_mm_s\": ", s->speed_max);
    put(text, ",\n    \"tension_stop_N\": ", s->tension_stop);
    put(text, ", \"tension_absurd_N\": ", s->tension_absurd);
    put(text, ", \"fault_time_s\": ", s->fault_time);
    wcut_text_print(text, "}");
}

static void put_rig(wcut_text *text, const wcut_rig_options *o, double degree) {
    put(text, ",\n  \"disturbance\": {\"law_a\": ", o->law_a);
    put(text, ", \"law_b\": ", o->law_b);
    put(text, ", \"density\": ", o->density);
    put(text, ", \"density_from_mm\": ", o->density_from);
    put(text, ", \"delay_s\": ", o->delay);
    put(text, ", \"lag_s\": ", o->lag);
    put(text, ",\n    \"noise_tension_N\": ", o->noise_tension);
    put(text, ", \"noise_angle_deg\": ", o->noise_angle / degree);
    put(text, ", \"noise_speed_mm_s\": ", o->noise_speed);
    put(text, ", \"noise_position_mm\": ", o->noise_position);
    wcut_text_print(text, ", \"seed\": %llu", (unsigned long long)o->seed);
    put(text, ", \"period_s\": ", o->period);
    wcut_text_print(text, ", \"excitation\": %s}", o->excitation ? "true" : "false");
}

static void put_figures(wcut_text *text, const char *name, bool there, const wcut_rig_figures *f, double target) {
    wcut_text_print(text, ",\n    \"%s\": ", name);
    if (!there) {
        wcut_text_print(text, "null");
        return;
    }
    put(text, "{\"from_s\": ", f->from);
    put(text, ", \"to_s\": ", f->to);
    put(text, ", \"tension_mean_N\": ", target * (1 + f->mean));
    put(text, ", \"error_mean\": ", f->mean);
    put(text, ", \"error_rms\": ", f->rms);
    put(text, ", \"error_max\": ", f->max);
    put(text, ", \"settled_s\": ", f->settled);
    wcut_text_print(text, "}");
}

static void put_run(wcut_text *text, const char *name, const wcut_rig_run *run) {
    wcut_text_print(text, ",\n  \"%s\": {\"complete\": %s, \"ended\": ", name, run->complete ? "true" : "false");
    wcut_text_string(text, wcut_control_state_name(run->ended));
    wcut_text_print(text, ", \"samples\": %d", run->recording.samples);
    put(text, ", \"duration_s\": ", run->duration);
    put(text, ", \"overshoot\": ", run->overshoot);
    put_figures(text, "steady", run->has_steady, &run->steady, run->target);
    put_figures(text, "beyond_density_step", run->has_density, &run->density, run->target);
    wcut_text_print(text, "}");
}

static wcut_status print_summary(const wcut_rig_summary *s, char **text, size_t *length) {
    if (!s || !s->job || !s->control || !s->options || !s->feedback || !s->plan) return WCUT_BAD_ARGUMENT;
    wcut_text out;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    wcut_text_print(&out, "{\n  \"format\": \"wirecut-control/1\",\n  \"version\": \"%s\",\n  \"job\": ", WCUT_VERSION);
    wcut_text_string(&out, s->job->name);
    put(&out, ",\n  \"target_N\": ", s->control->tension);
    wcut_text_print(&out, ",\n  \"recorded\": \"%s\"", s->plan_recorded ? "plan_alone" : "feedback");
    put_settings(&out, s->control);
    put_rig(&out, s->options, WCUT_RAD_PER_DEG);
    put_run(&out, "feedback", s->feedback);
    put_run(&out, "plan_alone", s->plan);
    wcut_text_print(&out, "\n}\n");
    return wcut_text_finish(&out, text, length);
}

wcut_status wcut_rig_summary_print(const wcut_rig_summary *summary, char **text) {
    size_t length;
    return text ? print_summary(summary, text, &length) : WCUT_BAD_ARGUMENT;
}

wcut_status wcut_rig_summary_write(const wcut_rig_summary *summary, const char *path, wcut_error *error) {
    char *text = NULL;
    size_t length = 0;
    wcut_status status = path ? print_summary(summary, &text, &length) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_fail(error, status, "a control summary: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, length, error);
    free(text);
    return status;
}
