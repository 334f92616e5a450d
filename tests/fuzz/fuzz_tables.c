/* Any bytes as a recording, as test cuts, as points of a photograph: refused in one printable line, or sound numbers. */
#include <math.h>
#include <wirecut/calibration_file.h>
#include <wirecut/overlay_file.h>
#include <wirecut/recording_file.h>

#include "file_fuzz.h"

static void fuzz_recording(const char *path) {
    wcut_recording *r = NULL;
    wcut_error error = {WCUT_OK, ""};
    const wcut_status status = wcut_recording_read(path, NULL, &r, &error);
    check_refusal(status, r != NULL, &error);
    for (int k = 0; r && k < WCUT_CHANNEL_COUNT; k++)
        for (int i = 0; r->channel[k].value && i < r->samples; i++) check(isfinite(r->channel[k].value[i]));
    for (int i = 1; r && i < r->samples; i++)
        check(r->channel[WCUT_CHANNEL_TIME].value[i] > r->channel[WCUT_CHANNEL_TIME].value[i - 1]);
    wcut_recording_destroy(r);
}

static void fuzz_test_cuts(const char *path) {
    wcut_test_cut *cut = NULL;
    int count = 0;
    wcut_error error = {WCUT_OK, ""};
    const wcut_status status = wcut_calibration_table_read(path, NULL, &count, &cut, &error);
    check_refusal(status, cut != NULL, &error);
    check(!cut || count >= 0);
    wcut_test_cut_destroy(cut);
}

static void fuzz_photo_points(const char *path) {
    wcut_photo_point *point = NULL;
    int count = 0;
    wcut_error error = {WCUT_OK, ""};
    const wcut_status status = wcut_photo_points_read(path, &count, &point, &error);
    check_refusal(status, point != NULL, &error);
    check(!point || (count >= 4 && count <= 500));
    free(point);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size, "csv");
    if (!path) return 0;
    fuzz_recording(path);
    fuzz_test_cuts(path);
    fuzz_photo_points(path);
    remove(path);
    return 0;
}
