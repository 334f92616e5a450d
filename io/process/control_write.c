/* "wirecut-control/1": a closed loop in a few figures, with feedback and with the plan alone. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/rig.h>
#include <wirecut/rig_file.h>
#include <wirecut/version.h>

#include <wirecut/angle.h>
#include "base/fail.h"
#include "io/file/text.h"

static void put_settings(wcut_text *text, const wcut_control_settings *s) {
    wcut_text_put_number(text, ",\n  \"settings\": {\"gain\": ", s->gain);
    wcut_text_put_number(text, ", \"rate_per_s\": ", s->rate);
    wcut_text_put_number(text, ", \"filter_s\": ", s->filter);
    wcut_text_put_number(text, ", \"authority\": ", s->authority);
    wcut_text_put_number(text, ", \"caution\": ", s->caution);
    wcut_text_put_number(text, ", \"margin_mm\": ", s->margin);
    wcut_text_put_number(text, ",\n    \"exponent_speed_mm_s\": ", s->exponent_speed);
    wcut_text_put_number(text, ", \"acceleration_mm_s2\": ", s->acceleration);
    wcut_text_put_number(text, ", \"speed_min_mm_s\": ", s->speed_min);
    wcut_text_put_number(text, ", \"speed_max_mm_s\": ", s->speed_max);
    wcut_text_put_number(text, ",\n    \"tension_stop_N\": ", s->tension_stop);
    wcut_text_put_number(text, ", \"tension_absurd_N\": ", s->tension_absurd);
    wcut_text_put_number(text, ", \"fault_time_s\": ", s->fault_time);
    wcut_text_print(text, "}");
}

static void put_control_rig(wcut_text *text, const wcut_rig_options *o, double degree) {
    wcut_text_put_number(text, ",\n  \"disturbance\": {\"law_a\": ", o->law_a);
    wcut_text_put_number(text, ", \"law_b\": ", o->law_b);
    wcut_text_put_number(text, ", \"density\": ", o->density);
    wcut_text_put_number(text, ", \"density_from_mm\": ", o->density_from);
    wcut_text_put_number(text, ", \"delay_s\": ", o->delay);
    wcut_text_put_number(text, ", \"lag_s\": ", o->lag);
    wcut_text_put_number(text, ",\n    \"noise_tension_N\": ", o->noise_tension);
    wcut_text_put_number(text, ", \"noise_angle_deg\": ", o->noise_angle / degree);
    wcut_text_put_number(text, ", \"noise_speed_mm_s\": ", o->noise_speed);
    wcut_text_put_number(text, ", \"noise_position_mm\": ", o->noise_position);
    wcut_text_print(text, ", \"seed\": %llu", (unsigned long long)o->seed);
    wcut_text_put_number(text, ", \"period_s\": ", o->period);
    wcut_text_print(text, ", \"excitation\": %s}", o->excitation ? "true" : "false");
}

static void put_control_figures(wcut_text *text, const char *name, bool there, const wcut_rig_figures *f,
                                double target) {
    wcut_text_print(text, ",\n    \"%s\": ", name);
    if (!there) {
        wcut_text_print(text, "null");
        return;
    }
    wcut_text_put_number(text, "{\"from_s\": ", f->from);
    wcut_text_put_number(text, ", \"to_s\": ", f->to);
    wcut_text_put_number(text, ", \"tension_mean_N\": ", target * (1 + f->mean));
    wcut_text_put_number(text, ", \"error_mean\": ", f->mean);
    wcut_text_put_number(text, ", \"error_rms\": ", f->rms);
    wcut_text_put_number(text, ", \"error_max\": ", f->max);
    wcut_text_put_number(text, ", \"settled_s\": ", f->settled);
    wcut_text_print(text, "}");
}

static void put_run(wcut_text *text, const char *name, const wcut_rig_run *run) {
    wcut_text_print(text, ",\n  \"%s\": {\"complete\": %s, \"ended\": ", name, run->complete ? "true" : "false");
    wcut_text_string(text, wcut_control_state_name(run->ended));
    wcut_text_print(text, ", \"samples\": %d", run->recording.samples);
    wcut_text_put_number(text, ", \"duration_s\": ", run->duration);
    wcut_text_put_number(text, ", \"overshoot\": ", run->overshoot);
    put_control_figures(text, "steady", run->has_steady, &run->steady, run->target);
    put_control_figures(text, "beyond_density_step", run->has_density, &run->density, run->target);
    wcut_text_print(text, "}");
}

static wcut_status print_control_summary(const wcut_rig_summary *s, char **text, size_t *length) {
    if (!s || !s->job || !s->control || !s->options || !s->feedback || !s->plan) return WCUT_BAD_ARGUMENT;
    wcut_text out;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    wcut_text_print(&out, "{\n  \"format\": \"wirecut-control/1\",\n  \"version\": \"%s\",\n  \"job\": ", WCUT_VERSION);
    wcut_text_string(&out, s->job->name);
    wcut_text_put_number(&out, ",\n  \"target_N\": ", s->control->tension);
    wcut_text_print(&out, ",\n  \"recorded\": \"%s\"", s->plan_recorded ? "plan_alone" : "feedback");
    put_settings(&out, s->control);
    put_control_rig(&out, s->options, WCUT_RAD_PER_DEG);
    put_run(&out, "feedback", s->feedback);
    put_run(&out, "plan_alone", s->plan);
    wcut_text_print(&out, "\n}\n");
    return wcut_text_finish(&out, text, length);
}

wcut_status wcut_rig_summary_print(const wcut_rig_summary *summary, char **text) {
    size_t length;
    return text ? print_control_summary(summary, text, &length) : WCUT_BAD_ARGUMENT;
}

wcut_status wcut_rig_summary_write(const wcut_rig_summary *summary, const char *path, wcut_error *error) {
    char *text = NULL;
    size_t length = 0;
    wcut_status status = path ? print_control_summary(summary, &text, &length) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_fail(error, status, "a control summary: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, length, error);
    free(text);
    return status;
}
