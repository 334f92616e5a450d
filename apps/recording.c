/* How a verb reads recordings of other programs. */
#include "recording.h"

#include "terminal.h"

int app_recording_format(const app_call *call, wcut_recording_format *format) {
    wcut_error error = {0};

    /* columns replace columns, the period the period */
    if (app_given(call, "columns")) {
        wcut_recording_format given = {0};
        const wcut_status status = wcut_recording_format_parse(app_text(call, "columns"), &given, &error);
        if (status != WCUT_OK) return app_fail(APP_USAGE, "--%s", error.text);
        given.period = format->period;
        wcut_recording_format_clear(format);
        *format = given;
    }
    if (app_given(call, "period")) format->period = app_real(call, "period");

    return APP_DONE;
}
