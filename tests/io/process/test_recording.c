/* Recordings: units, channels, the clock, and what is tolerated. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/job.h>
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

static const wcut_recording_format *format; /* NULL: columns are named as the channels are */

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
    wcut_status status = wcut_recording_read(path, format, &recording, &error);
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

#define TOOL "time_s,force_x_N,force_y_N,force_z_N,x_mm,y_mm,z_mm\n"

/* read a text with columns and a period */
static wcut_status read_mapped(const char *text, const char *columns, double period) {
    wcut_recording_format made = {0};
    wcut_status status = wcut_recording_format_parse(columns, &made, &error);
    if (status != WCUT_OK) return status;
    made.period = period;
    format = &made;
    status = read_text(text);
    format = NULL;
    wcut_recording_format_clear(&made);
    return status;
}

TEST(a_recording_of_a_tool_has_forces_and_a_motion) {
    ck_assert_msg(read_text(TOOL "0,1,2,3,4,5,6\n0.1,1,2,nan,4,5,7\n") == WCUT_OK, "%s", error.text);
    ck_assert(wcut_recording_has_force(recording));
    ck_assert(recording->channel[WCUT_CHANNEL_FORCE_Z].missing == 1);
    ck_assert(recording->channel[WCUT_CHANNEL_TOOL_Z].value[1] == 7);
    ck_assert(recording->channel[WCUT_CHANNEL_STATION].name == NULL);
    refused("time_s,force_x_N,force_y_N,x_mm,y_mm,z_mm\n0,1,2,3,4,5\n", "missing force_z_N");
    refused("time_s,force_x_N,force_y_N,force_z_N,x_mm\n0,1,2,3,4\n", "missing speed_mm_s");
    refused("time_s,force_x_N,force_y_N,force_z_kN,x_mm,y_mm,z_mm\n0,1,2,3,4,5,6\n", "found force_z_kN: another unit");
    ck_assert_int_eq(read_text("time_s,force_x_N,force_y_N,force_z_N,speed_mm_s\n0,1,2,3,4\n"), WCUT_OK);
    ck_assert(recording->channel[WCUT_CHANNEL_SPEED].value[0] == 4);
    forget();
}

TEST(a_log_of_another_program_is_read_by_a_column_map) {
    const char *log = "stamp;Fx;Fy;px;x_mm\n1000;2,5;7;0,4;9\n1010;-1;;0,5;9\n";
    const char *map =
        "time_s=stamp*0.001-1,force_x_N=Fx*1000+0.5,force_y_N=Fy,force_z_N=Fy,x_mm=px*1000,y_mm=px,z_mm=px";
    ck_assert_msg(read_mapped(log, map, 0) == WCUT_OK, "%s", error.text);
    const wcut_column *c = recording->channel;
    ck_assert_double_eq_tol(c[WCUT_CHANNEL_TIME].value[1], 0.01, 1e-12);
    ck_assert(c[WCUT_CHANNEL_FORCE_X].value[0] == 2500.5 && c[WCUT_CHANNEL_FORCE_X].value[1] == -999.5);
    ck_assert(c[WCUT_CHANNEL_FORCE_Z].value[0] == 7 && c[WCUT_CHANNEL_FORCE_Z].missing == 1);
    ck_assert(c[WCUT_CHANNEL_TOOL_X].value[1] == 500 && c[WCUT_CHANNEL_TOOL_Y].value[1] == 0.5);
    ck_assert_int_eq(wcut_table_locate(recording->further, "file:x_mm"), recording->further->columns - 1);
    ck_assert_int_ge(wcut_table_locate(recording->further, "stamp"), 0);
    forget();
    ck_assert_int_eq(read_mapped(log, "time_s=clock", 0), WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "no column clock, which the format names for time_s"));
    EACH_FAILED_ALLOCATION(read_mapped(log, map, 0), !recording);
    forget();
}

TEST(a_log_without_a_clock_has_a_constant_period) {
    const char *log = "force_x_N force_y_N force_z_N x_mm y_mm z_mm\n1 2 3 4 5 6\n1 2 3 4 5 6\n1 2 3 4 5 6\n";
    ck_assert_msg(read_mapped(log, "", 0.25) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(recording->samples, 3); /* rows that are alike are samples all the same */
    ck_assert(recording->channel[WCUT_CHANNEL_TIME].value[2] == 0.5);
    refused(log, "missing time_s");
    ck_assert_int_eq(read_mapped(TOOL "0,1,2,3,4,5,6\n", "", 0.25), WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "found time_s and a constant period"));
    ck_assert_int_eq(read_mapped(log, "", -1), WCUT_BAD_ARGUMENT);
    forget();
}

TEST(column_maps_are_checked_part_by_part) {
    static const char *const bad[][2] = {{"time_s", "expected CHANNEL=COLUMN"},
                                         {"clock=t", "found clock, expected the name of a channel"},
                                         {"time_s=", "a column's name behind ="},
                                         {"time_s=t*x", "*FACTOR, not 0"},
                                         {"time_s=t*0", "*FACTOR, not 0"},
                                         {"time_s=t*2*3", "*FACTOR, not 0"},
                                         {"time_s=t*2+", "*FACTOR, not 0"},
                                         {"time_s=t*1e999", "*FACTOR, not 0"},
                                         {"time_s=t,time_s=u", "every channel once"},
                                         {"time_s=t,", "behind the last comma"},
                                         {",time_s=t", "CHANNEL=COLUMN"}};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        wcut_recording_format made = {.period = 999};
        ck_assert_int_eq(wcut_recording_format_parse(bad[k][0], &made, &error), WCUT_BAD_FORMAT);
        ck_assert_msg(strstr(error.text, bad[k][1]) != NULL, "%s: %s", bad[k][0], error.text);
        ck_assert(made.period == 999 && made.maps == 0);
    }
}

TEST(mounts_positions_stand_for_stations) {
    const char *head =
        "time_s,speed_a_mm_s,speed_b_mm_s,tension_a_N,tension_b_N,alpha_a_deg,beta_a_deg,alpha_b_deg,"
        "beta_b_deg,a_x_mm,a_y_mm,a_z_mm,b_x_mm,b_y_mm,b_z_mm\n";
    char text[2000];
    snprintf(
        text, sizeof text,
        "%s0,1,1,2,2,0,0,0,0,-10,0,5,110,0,5\n1,1,1,2,2,0,0,0,0,-10,15,5,110,14,5\n2,1,1,2,2,0,0,0,0,nan,1,1,1,1,1\n"
        "3,1,1,2,2,0,0,0,0,-10,30,6,110,30,4\n",
        head);
    ck_assert_msg(read_text(text) == WCUT_OK, "%s", error.text);
    ck_assert(recording->channel[WCUT_CHANNEL_STATION].name == NULL);

    /* a straight path of four stations, 10 mm apart */
    wcut_job *job = NULL;
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    wcut_vec3 a[4], b[4];
    for (int j = 0; j < 4; j++) a[j] = (wcut_vec3){-10, 10 * j, 5}, b[j] = (wcut_vec3){110, 10 * j, 5};
    job->mode = WCUT_MODE_PATH, job->stations = 4, job->mount_a = a, job->mount_b = b;
    ck_assert_msg(wcut_recording_place(job, recording, &error) == WCUT_OK, "%s", error.text);
    const wcut_column *s = &recording->channel[WCUT_CHANNEL_STATION];
    ck_assert_str_eq(s->name, "station");
    ck_assert_double_eq_tol(s->value[0], 0, 1e-12);
    ck_assert_double_eq_tol(s->value[1], 1.45, 1e-12); /* between both mounts */
    ck_assert(s->present[2] == 0 && s->missing == 1);
    ck_assert_double_eq_tol(s->value[3], 3, 1e-12);

    /* without memory it is as it was */
    wcut_free(s->name), wcut_free(s->value), wcut_free(s->present);
    recording->channel[WCUT_CHANNEL_STATION] = (wcut_column){0};
    EACH_FAILED_ALLOCATION(wcut_recording_place(job, recording, &error), !s->name && !s->value);
    ck_assert(s->name && s->missing == 1);

    /* a recording that has them keeps them */
    s->value[0] = 7;
    ck_assert_int_eq(wcut_recording_place(job, recording, &error), WCUT_OK);
    ck_assert(s->value[0] == 7);
    job->mount_a = job->mount_b = NULL;
    wcut_job_destroy(job);
    forget();
}

TEST(bad_arguments_missing_files_and_memory_leave_the_output_alone) {
    wcut_recording *found = (wcut_recording *)&error;
    ck_assert_int_eq(wcut_recording_read(NULL, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_recording_read("a.csv", NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_recording_read("no/such.csv", NULL, &found, &error), WCUT_NOT_FOUND);
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
    ck_assert_int_eq(wcut_recording_read(path, NULL, &recording, &error), WCUT_OK);
    ck_assert_int_gt(recording->samples, 100);
    ck_assert(recording->channel[WCUT_CHANNEL_SPEED_COMMAND].name != NULL);
    forget();
}
