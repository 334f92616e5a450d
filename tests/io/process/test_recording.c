/* Recordings: units, channels, the clock, and what is tolerated. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/recording.h>
#include <wirecut/recording_file.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "test.h"

#define HEADER \
    "time_s,station,speed_a_mm_s,speed_b_mm_s,tension_a_N,tension_b_N,alpha_a_deg,beta_a_deg,alpha_b_deg,beta_b_deg"
#define ROW ",0.5,10,11,1.9,2.1,45,-90,180,0"

static wcut_recording *recording;
static wcut_error error;

/* write the text to a file of our own and read it as a recording */
static wcut_status read_text(const char *text) {
    char path[64];
    snprintf(path, sizeof path, "test_recording.%ld.csv", (long)getpid());
    FILE *file = fopen(path, "wb");
    ck_assert_ptr_nonnull(file);
    fputs(text, file);
    fclose(file);
    wcut_recording_destroy(recording);
    recording = NULL;
    wcut_status status = wcut_recording_read(path, &recording, &error);
    remove(path);
    return status;
}

static void refused(const char *text, const char *words) {
    ck_assert_int_eq(read_text(text), WCUT_BAD_FORMAT);
    ck_assert_ptr_null(recording);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
}

static void forget(void) {
    wcut_recording_destroy(recording);
    recording = NULL;
}

TEST(channels_are_in_the_units_of_the_api_and_the_rest_is_kept_by_name) {
    ck_assert_int_eq(read_text("note," HEADER ",foam_degC\nfirst,0" ROW ",21.5\nsecond,0.05" ROW ",21.6\n"), WCUT_OK);
    ck_assert_int_eq(recording->samples, 2);
    const wcut_column *c = recording->channel;
    ck_assert_double_eq_tol(c[WCUT_CHANNEL_ALPHA_A].value[1], acos(-1) / 4, 1e-15);
    ck_assert_double_eq_tol(c[WCUT_CHANNEL_BETA_A].value[0], -acos(-1) / 2, 1e-15);
    ck_assert(c[WCUT_CHANNEL_SPEED_B].value[0] == 11 && c[WCUT_CHANNEL_TENSION_A].value[1] == 1.9);
    ck_assert(c[WCUT_CHANNEL_HEAT].name == NULL && c[WCUT_CHANNEL_HEAT].value == NULL);
    ck_assert_int_eq(recording->further->columns, 2);
    ck_assert_int_eq(recording->further->column[0].text, 2);
    ck_assert_str_eq(recording->further->column[1].name, "foam_degC");
    ck_assert(recording->further->column[1].value[1] == 21.6);
    ck_assert_int_eq(recording->further->line[1], 3);
    forget();
}

TEST(optional_channels_are_read_where_they_are_there) {
    ck_assert_int_eq(read_text(HEADER ",heater_V,heater_A,b_z_mm\n0" ROW ",24,1.5,150\n"), WCUT_OK);
    ck_assert(recording->channel[WCUT_CHANNEL_HEATER_VOLTAGE].value[0] == 24);
    ck_assert(recording->channel[WCUT_CHANNEL_HEATER_CURRENT].value[0] == 1.5);
    ck_assert(recording->channel[WCUT_CHANNEL_B_Z].value[0] == 150);
    ck_assert_int_eq(recording->further->columns, 0);
    forget();
}

TEST(a_channel_without_any_sample_is_tolerated_and_visible) {
    ck_assert_int_eq(read_text(HEADER "\n0,1,nan,2,3,4,5,6,7,8\n1,2,,2,3,4,5,6,7,nan\n"), WCUT_OK);
    ck_assert_int_eq(recording->channel[WCUT_CHANNEL_SPEED_A].missing, 2);
    ck_assert_int_eq(recording->channel[WCUT_CHANNEL_BETA_B].missing, 1);
    ck_assert(recording->channel[WCUT_CHANNEL_BETA_B].present[0] == 1);
    forget();
}

TEST(one_row_is_a_recording_and_none_is_not) {
    ck_assert_int_eq(read_text(HEADER "\n0" ROW "\n"), WCUT_OK);
    ck_assert_int_eq(recording->samples, 1);
    forget();
    refused(HEADER "\n", "found a header and no samples");
    refused("", "found no header");
}

TEST(a_station_outside_the_path_is_the_readers_no_matter) {
    ck_assert_int_eq(read_text(HEADER "\n0,-7,10,11,1.9,2.1,45,-90,180,0\n"), WCUT_OK);
    ck_assert(recording->channel[WCUT_CHANNEL_STATION].value[0] == -7);
    forget();
}

TEST(a_row_that_repeats_the_one_before_it_is_left_out) {
    ck_assert_int_eq(read_text(HEADER "\n0" ROW "\n0" ROW "\n1,2,,2,3,4,5,6,7,8\n1,2,,2,3,4,5,6,7,8\n2" ROW "\n"),
                     WCUT_OK);
    ck_assert_int_eq(recording->samples, 3);
    ck_assert(recording->channel[WCUT_CHANNEL_TIME].value[2] == 2);
    ck_assert_int_eq(recording->channel[WCUT_CHANNEL_SPEED_A].missing, 1);
    ck_assert_int_eq(recording->further->line[2], 6);
    forget();
}

TEST(time_that_stands_still_or_runs_backwards_is_refused_with_its_line) {
    refused(HEADER "\n0" ROW "\n# pause\n1" ROW "\n1,2,10,11,1.9,2.1,45,-90,180,0\n",
            "line 5: time_s: found 1 after 1, expected a later time");
    refused(HEADER "\n0" ROW "\n-0.5" ROW "\n", "line 3: time_s: found -0.5 after 0");
    refused(HEADER "\n0" ROW "\n" ROW "\n", "line 3: time_s: found a missing sample");
}

TEST(missing_columns_and_wrong_units_are_named) {
    refused("time_s,station\n0,1\n",
            "header: missing speed_a_mm_s, speed_b_mm_s, tension_a_N, tension_b_N, alpha_a_deg");
    refused(
        "time_s,station,speed_a_m_s,speed_b_mm_s,tension_a_N,tension_b_N,alpha_a_rad,beta_a_deg,alpha_b_deg,beta_b_"
        "deg\n",
        "missing speed_a_mm_s (found speed_a_m_s: another unit or spelling), alpha_a_deg (found alpha_a_rad");
    refused(
        "Time_s" /* capital */
        ",station,speed_a_mm_s,speed_b_mm_s,tension_a_N,tension_b_N,alpha_a_deg,beta_a_deg,"
        "alpha_b_deg,beta_b_deg\n",
        "missing time_s (found Time_s");
    refused(HEADER ",heat_W_per_mm\n0" ROW ",1\n", "missing heat_W_per_m (found heat_W_per_mm");
    /* a name that merely begins alike is a further column */
    ck_assert_int_eq(read_text(HEADER ",speed_a_filtered,heat_index\n0" ROW ",1,2\n"), WCUT_OK);
    forget();
}

TEST(bad_numbers_in_a_channel_are_refused_with_line_and_column) {
    refused(HEADER "\n0,x,10,11,1.9,2.1,45,-90,180,0\n", "line 2, column 3 (station): found x");
}

TEST(channel_names_are_those_of_the_format) {
    ck_assert_str_eq(wcut_channel_name(WCUT_CHANNEL_TIME), "time_s");
    ck_assert_str_eq(wcut_channel_name(WCUT_CHANNEL_STATION), "station");
    ck_assert_str_eq(wcut_channel_name(WCUT_CHANNEL_HEAT), "heat_W_per_m");
    ck_assert_str_eq(wcut_channel_name(WCUT_CHANNEL_COUNT), "");
}

TEST(bad_arguments_missing_files_and_memory_leave_the_output_alone) {
    wcut_recording *found = (wcut_recording *)&error;
    ck_assert_int_eq(wcut_recording_read(NULL, &found, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_recording_read("a.csv", NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_recording_read("no/such.csv", &found, &error), WCUT_NOT_FOUND);
    EACH_FAILED_ALLOCATION(read_text(HEADER "\n0" ROW "\n1" ROW "\n"), !recording);
    ck_assert(found == (wcut_recording *)&error);
    wcut_recording_destroy(NULL);
    forget();
}

TEST(the_recordings_of_the_cases_are_read) {
    const char *path = WCUT_SOURCE_DIR "/../shared/cases/dev/c01/cut-01/recording.csv";
    if (access(path, R_OK) != 0) {
        puts("../shared/cases is not here: left out");
        return;
    }
    ck_assert_int_eq(wcut_recording_read(path, &recording, &error), WCUT_OK);
    ck_assert_int_gt(recording->samples, 100);
    ck_assert(recording->channel[WCUT_CHANNEL_SPEED_COMMAND].name != NULL);
    forget();
}
