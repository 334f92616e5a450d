/* Recordings written and read back: channels, units, missing samples, what is refused. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/recording_file.h>
#include <wirecut/rig.h>
#include <wirecut/rig_file.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "test.h"

enum { SAMPLES = 50 };

static double value[WCUT_CHANNEL_COUNT][SAMPLES];
static unsigned char present[SAMPLES];
static wcut_recording made;
static wcut_recording *read_back;
static wcut_error error;
static char path[64];

static void prepare(void) {
    snprintf(path, sizeof path, "test_recording_write.%ld.csv", (long)getpid());
    made = (wcut_recording){.samples = SAMPLES};
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        made.channel[k].name = (char *)wcut_channel_name((wcut_channel)k);
        made.channel[k].value = value[k];
        for (int i = 0; i < SAMPLES; i++) value[k][i] = k == WCUT_CHANNEL_TIME ? 0.05 * i : sin(k + 3.7 * i);
    }
    memset(present, 1, sizeof present);
    read_back = NULL;
}

static void forget(void) {
    wcut_recording_destroy(read_back);
    remove(path);
}

TEST(what_is_written_is_read_back_to_the_printed_precision) {
    present[7] = 0;
    made.channel[WCUT_CHANNEL_BETA_A].present = present;
    made.channel[WCUT_CHANNEL_HEATER_VOLTAGE].name = NULL;
    ck_assert_int_eq(wcut_recording_write(&made, "a note, with commas", path, &error), WCUT_OK);
    ck_assert_int_eq(wcut_recording_read(path, NULL, &read_back, &error), WCUT_OK);
    ck_assert_int_eq(read_back->samples, SAMPLES);
    ck_assert_int_eq(read_back->further->columns, 0);
    ck_assert_ptr_null(read_back->channel[WCUT_CHANNEL_HEATER_VOLTAGE].name);
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        if (k == WCUT_CHANNEL_HEATER_VOLTAGE) continue;
        const bool angle = k >= WCUT_CHANNEL_ALPHA_A && k <= WCUT_CHANNEL_BETA_B;
        for (int i = 0; i < SAMPLES; i++) {
            if (k == WCUT_CHANNEL_BETA_A && i == 7) continue;
            ck_assert_double_eq_tol(read_back->channel[k].value[i], value[k][i],
                                    angle ? 0.51e-3 * acos(-1) / 180 : 0.51e-4);
        }
    }
    ck_assert_int_eq(read_back->channel[WCUT_CHANNEL_BETA_A].missing, 1);
    ck_assert_int_eq(read_back->channel[WCUT_CHANNEL_BETA_A].present[7], 0);
}

TEST(what_is_no_recording_is_refused_and_no_file_appears) {
    ck_assert_int_eq(wcut_recording_write(NULL, NULL, path, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_recording_write(&made, NULL, NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_recording_write(&made, "two\nlines", path, &error), WCUT_BAD_ARGUMENT);
    made.samples = 0;
    ck_assert_int_eq(wcut_recording_write(&made, NULL, path, &error), WCUT_BAD_ARGUMENT);
    made.samples = SAMPLES;
    made.channel[WCUT_CHANNEL_ALPHA_B].name = NULL;
    ck_assert_int_eq(wcut_recording_write(&made, NULL, path, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "alpha_b_deg"));
    made.channel[WCUT_CHANNEL_ALPHA_B].name = (char *)"alpha_b_deg";
    value[WCUT_CHANNEL_SPEED_A][3] = NAN;
    ck_assert_int_eq(wcut_recording_write(&made, NULL, path, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "sample 3: speed_a_mm_s"));
    value[WCUT_CHANNEL_SPEED_A][3] = 0;
    value[WCUT_CHANNEL_TIME][9] = value[WCUT_CHANNEL_TIME][8] + 1e-5; /* the same as printed */
    ck_assert_int_eq(wcut_recording_write(&made, NULL, path, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "sample 9"));
    ck_assert_int_ne(access(path, F_OK), 0);
}

TEST(a_folder_that_is_missing_and_missing_memory_are_told_apart) {
    ck_assert_int_eq(wcut_recording_write(&made, NULL, "nowhere/at/all.csv", &error), WCUT_NOT_WRITTEN);
    EACH_FAILED_ALLOCATION(wcut_recording_write(&made, NULL, path, &error), access(path, F_OK) != 0);
    remove(path);
}

FIXTURE(prepare, forget);
