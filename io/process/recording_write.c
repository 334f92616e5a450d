/* Recordings to CSV: the channels there are, in the units of files. */
#include <math.h>
#include <string.h>
#include <wirecut/recording_file.h>
#include <wirecut/rig.h>
#include <wirecut/rig_file.h>

#include "base/fail.h"
#include "io/file/number.h"
#include "io/file/text.h"

/* the sensors of such a rig resolve no more */
#define TIME_PER_S 1e4
#define PER_DEGREE 1e3
#define PER_UNIT 1e4

#define CHANNEL_ENTRY(name, stem, unit, required) {unit, required},
static const struct {
    const char *unit;
    int required;
} known[] = {WCUT_CHANNEL_LIST(CHANNEL_ENTRY)};
#undef CHANNEL_ENTRY

/* the number as it is printed */
static double rounded(wcut_channel channel, double value) {
    const char *unit = known[channel].unit;
    if (strcmp(unit, "deg") == 0) return round(value * 180 / acos(-1) * PER_DEGREE) / PER_DEGREE;
    if (strcmp(unit, "s") == 0) return round(value * TIME_PER_S) / TIME_PER_S;
    return round(value * PER_UNIT) / PER_UNIT;
}

static bool is_recording_there(const wcut_column *c, int i) { return !c->present || c->present[i]; }

static wcut_status check_recording(const wcut_recording *r, const char *note, wcut_error *error) {
    /* samples and note */
    if (r->samples < 1) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a recording: expected at least one sample");
    if (note && strpbrk(note, "\r\n"))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a recording's note: expected one line");

    /* required channels are there, values are finite */
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        const wcut_column *c = &r->channel[k];
        const char *name = wcut_channel_name((wcut_channel)k);
        if (known[k].required && !c->name)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "a recording: expected a channel %s", name);
        for (int i = 0; c->name && i < r->samples; i++)
            if (is_recording_there(c, i) && !isfinite(c->value[i]))
                return wcut_fail(error, WCUT_BAD_ARGUMENT, "sample %d: %s: expected a finite number", i, name);
    }

    /* times increase in the digits that are written */
    const wcut_column *time = &r->channel[WCUT_CHANNEL_TIME];
    for (int i = 0; i < r->samples; i++)
        if (!is_recording_there(time, i) ||
            (i > 0 && !(rounded(WCUT_CHANNEL_TIME, time->value[i]) > rounded(WCUT_CHANNEL_TIME, time->value[i - 1]))))
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "sample %d: expected a time at least 1e-4 s after the one before", i);

    return WCUT_OK;
}

static void put_recording_row(wcut_text *text, const wcut_recording *r, int i) {
    char *line = wcut_text_room(text);
    int length = 0;
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        if (!r->channel[k].name) continue;
        if (k > 0) line[length++] = ',';
        if (is_recording_there(&r->channel[k], i)) {
            const double value = rounded((wcut_channel)k, r->channel[k].value[i]);
            length += wcut_number_print(value == 0 ? 0 : value, line + length);
        }
    }
    line[length++] = '\n';
    text->count += (size_t)length;
}

/* a recording and the line above it, which may be NULL */
typedef struct noted {
    const wcut_recording *recording;
    const char *note;
} noted;

static bool put_recording(wcut_text *text, const void *context) {
    const noted *whole = context;
    const wcut_recording *r = whole->recording;
    if (whole->note) wcut_text_print(text, "# %s\n", whole->note);
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++)
        if (r->channel[k].name) wcut_text_print(text, "%s%s", k > 0 ? "," : "", wcut_channel_name((wcut_channel)k));
    wcut_text_print(text, "\n");
    for (int i = 0; i < r->samples; i++) put_recording_row(text, r, i);
    return true;
}

wcut_status wcut_recording_write(const wcut_recording *recording, const char *note, const char *path,
                                 wcut_error *error) {
    if (!recording || !path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "expected a recording and a file name");
    wcut_status status = check_recording(recording, note, error);
    if (status != WCUT_OK) return status;
    const noted whole = {recording, note};
    return wcut_text_write_file(path, put_recording, &whole, error);
}
