/* What recordings contradict before any physics: programmes that were not run, a heater that sags, stations, places and
   zeros that are off. Each is put into a true case of the library's own rig, and nothing else may be said.
   labels: unit */
#include "explain/redundancy.h"

#include <wirecut/case.h>
#include <wirecut/job_file.h>
#include <wirecut/recording_file.h>

#include "explain/machine.h"
#include "explain/verdict_text.h"
#include "test.h"

static machine_case m;

static void begin(void) { m = machine_create(MACHINE_CUTS, &(machine_secret){.seed = 11}); }

static void end(void) { machine_destroy(&m); }

FIXTURE_ONCE(begin, end);

static wcut_recording *recording(int cut) { return &m.run[cut]->recording; }

static double *column(int cut, wcut_channel channel) { return recording(cut)->channel[channel].value; }

static wcut_redundancy compare(void) {
    wcut_redundancy r;
    ck_assert_int_eq(wcut_redundancy_create(m.cuts, m.cut, NULL, &r, NULL), WCUT_OK);
    return r;
}

/* the one contradiction there is */
static const wcut_contradiction *only(const wcut_redundancy *r, wcut_contradiction_kind kind) {
    ck_assert_msg(r->count == 1, "found %d, the first \"%s\", the last \"%s\"", r->count,
                  r->count ? r->found[0].text : "", r->count ? r->found[r->count - 1].text : "");
    ck_assert_msg(r->found[0].kind == kind, "%s", r->found[0].text);
    return &r->found[0];
}

static void give_programme(int to, int from, bool dither, bool steps) {
    wcut_job *job = m.job[to];
    const wcut_job *other = m.job[from];
    wcut_free(job->dither);
    wcut_free(job->heat_step);
    job->dither = wcut_copy(other->dither, (size_t)other->dither_count, sizeof *job->dither);
    job->heat_step = wcut_copy(other->heat_step, (size_t)other->heat_step_count, sizeof *job->heat_step);
    job->dither_count = dither ? other->dither_count : 0;
    job->heat_step_count = steps ? other->heat_step_count : 0;
}

/* a column that the rig does not record; NULL takes one away */
static void set_column(int cut, wcut_channel channel, const char *name) {
    wcut_column *c = &recording(cut)->channel[channel];
    const size_t n = (size_t)recording(cut)->samples;
    wcut_free(c->name);
    c->name = name ? wcut_copy_text(name) : NULL;
    if (name && !c->value) c->value = wcut_alloc(n, sizeof(double));
}

/* volts and amperes that make `factor` of the set power, and a slow wave of it */
static void give_heater(int cut, double factor, double wave) {
    set_column(cut, WCUT_CHANNEL_HEATER_VOLTAGE, "heater_V");
    set_column(cut, WCUT_CHANNEL_HEATER_CURRENT, "heater_A");
    for (int i = 0; i < recording(cut)->samples; i++) {
        const double noise = 1 + 0.004 * sin(3.7 * i * i), time = column(cut, WCUT_CHANNEL_TIME)[i];
        const double heat = column(cut, WCUT_CHANNEL_HEAT)[i] * factor * (1 + wave * sin(2 * WCUT_PI * time / 4));
        column(cut, WCUT_CHANNEL_HEATER_CURRENT)[i] = 0.9;
        column(cut, WCUT_CHANNEL_HEATER_VOLTAGE)[i] = noise * heat * m.job[cut]->wire_length / 1000 / 0.9;
    }
}

TEST(a_true_case_contradicts_nothing_and_stays_as_it_is) {
    for (int cut = 0; cut < m.cuts; cut++) give_heater(cut, 1, 0);
    wcut_redundancy r = compare();
    ck_assert_msg(r.count == 0, "%s", r.count ? r.found[0].text : "");
    for (int cut = 0; cut < m.cuts; cut++) {
        ck_assert_ptr_eq(r.cut[cut].job, m.job[cut]);
        ck_assert_ptr_eq(r.cut[cut].recording, recording(cut));
    }
    wcut_redundancy_destroy(&r);
}

/* ---- excitation ---- */

TEST(a_programme_that_was_not_run_is_found_and_left_out) {
    give_programme(0, 1, true, true);
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_EXCITATION);
    ck_assert_int_eq(c->cuts, 1);
    ck_assert_int_eq(c->cut[0], 0);
    ck_assert_msg(!c->fault && c->repaired && fabs(c->found) < 0.1, "%s", c->text);
    ck_assert_int_eq(r.cut[0].job->dither_count, 0);
    ck_assert_int_eq(r.cut[0].job->heat_step_count, 0);
    ck_assert_ptr_eq(r.cut[1].job, m.job[1]);
    ck_assert_int_gt(m.job[0]->dither_count, 0); /* the caller's stays */
    wcut_redundancy_destroy(&r);
}

TEST(either_half_of_a_programme_is_found_by_itself) {
    for (int half = 0; half < 2; half++) {
        give_programme(0, 1, half == 0, half == 1);
        wcut_redundancy r = compare();
        const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_EXCITATION);
        ck_assert_str_eq(c->column, half == 0 ? "speed_command_mm_s" : "heat_W_per_m");
        wcut_redundancy_destroy(&r);
    }
}

TEST(without_the_commanded_speed_the_speed_itself_shows_it) {
    give_programme(0, 1, true, true);
    set_column(0, WCUT_CHANNEL_SPEED_COMMAND, NULL);
    set_column(0, WCUT_CHANNEL_HEAT, NULL); /* the steps go with the dither */
    wcut_redundancy r = compare();
    ck_assert_str_eq(only(&r, WCUT_CONTRADICTION_EXCITATION)->column, "speed_a_mm_s");
    ck_assert_int_eq(r.cut[0].job->heat_step_count, 0);
    wcut_redundancy_destroy(&r);
}

TEST(a_programme_of_other_periods_and_steps_is_not_followed) {
    wcut_job *first = m.job[1];
    for (int k = 0; k < first->dither_count; k++) first->dither[k].period *= 0.7;
    for (int k = 0; k < first->heat_step_count; k++) first->heat_step[k].factor = 2 - first->heat_step[k].factor;
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_EXCITATION);
    ck_assert_int_eq(c->cuts, 1);
    ck_assert_int_eq(c->cut[0], 1);
    ck_assert_ptr_ne(r.cut[1].job, first);
    wcut_redundancy_destroy(&r);
}

/* ---- heater ---- */

TEST(a_heater_that_sags_is_found_and_its_power_is_used) {
    for (int cut = 0; cut < m.cuts; cut++) give_heater(cut, 0.97, 0);
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_HEATER);
    ck_assert_msg(c->fault && c->repaired && fabs(c->found - 0.97) < 0.002, "%s", c->text);
    ck_assert_int_eq(c->cuts, m.cuts);
    const wcut_column *heat = &r.cut[0].recording->channel[WCUT_CHANNEL_HEAT];
    for (int i = 0; i < recording(0)->samples; i++)
        ck_assert_double_eq_tol(heat->value[i], 0.97 * column(0, WCUT_CHANNEL_HEAT)[i], 0.6);
    wcut_redundancy_destroy(&r);
}

TEST(a_heater_that_swings_is_found) {
    give_heater(1, 1, 0.02);
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_HEATER);
    ck_assert_int_eq(c->cuts, 1);
    ck_assert_msg(strstr(c->text, "varies by 1.") != NULL, "%s", c->text);
    wcut_redundancy_destroy(&r);
}

TEST(volts_in_another_unit_are_a_wrong_column_and_not_used) {
    for (int cut = 0; cut < m.cuts; cut++) give_heater(cut, 1000, 0);
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_HEATER);
    ck_assert(!c->repaired);
    ck_assert_ptr_eq(r.cut[0].recording, recording(0));
    wcut_redundancy_destroy(&r);
}

TEST(without_a_set_power_the_measured_one_is_held_against_the_job) {
    give_heater(0, 1.04, 0);
    set_column(0, WCUT_CHANNEL_HEAT, NULL);
    wcut_redundancy r = compare();
    ck_assert(strstr(only(&r, WCUT_CONTRADICTION_HEATER)->text, "the job's heat") != NULL);
    const wcut_column *heat = &r.cut[0].recording->channel[WCUT_CHANNEL_HEAT];
    ck_assert_ptr_nonnull(heat->name);
    ck_assert_double_eq_tol(heat->value[100], 1.04 * m.job[0]->heat, 0.6);
    wcut_redundancy_destroy(&r);
}

/* ---- motion ---- */

static void scale_column(wcut_channel first, wcut_channel last, double by) {
    for (int cut = 0; cut < m.cuts; cut++)
        for (int k = first; k <= (int)last; k++)
            for (int i = 0; i < recording(cut)->samples; i++) column(cut, (wcut_channel)k)[i] *= by;
}

TEST(stations_that_run_ahead_of_speeds_and_places_are_set_right) {
    scale_column(WCUT_CHANNEL_STATION, WCUT_CHANNEL_STATION, 1.004);
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_STATION);
    ck_assert_msg(c->fault && fabs(c->found - 1.004) < 5e-4, "%s", c->text);
    const int end = recording(0)->samples - 1;
    ck_assert_double_eq_tol(r.cut[0].recording->channel[WCUT_CHANNEL_STATION].value[end],
                            column(0, WCUT_CHANNEL_STATION)[end] / 1.004, 0.05);
    wcut_redundancy_destroy(&r);
}

TEST(without_measured_places_two_speeds_outvote_the_stations) {
    scale_column(WCUT_CHANNEL_STATION, WCUT_CHANNEL_STATION, 0.99);
    for (int cut = 0; cut < m.cuts; cut++)
        for (int k = WCUT_CHANNEL_A_X; k <= WCUT_CHANNEL_B_Z; k++) set_column(cut, (wcut_channel)k, NULL);
    wcut_redundancy r = compare();
    ck_assert_double_eq_tol(only(&r, WCUT_CONTRADICTION_STATION)->found, 0.99, 1.5e-3);
    wcut_redundancy_destroy(&r);
}

TEST(speeds_that_contradict_stations_and_places_are_named_and_nothing_is_changed) {
    scale_column(WCUT_CHANNEL_SPEED_A, WCUT_CHANNEL_SPEED_B, 1.01);
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_SPEED);
    ck_assert_msg(!c->repaired && fabs(c->found - 1.01) < 1.5e-3, "%s", c->text);
    ck_assert_ptr_eq(r.cut[0].recording, recording(0));
    wcut_redundancy_destroy(&r);
}

TEST(a_mount_beside_its_path_is_named_with_its_cut) {
    for (int i = 0; i < recording(1)->samples; i++) column(1, WCUT_CHANNEL_B_Z)[i] += 2;
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_PLACES);
    ck_assert_int_eq(c->cuts, 1);
    ck_assert_int_eq(c->cut[0], 1);
    ck_assert_str_eq(c->column, "b_x_mm .. b_z_mm");
    ck_assert_msg(fabs(c->found - 2) < 0.1 && strstr(c->text, "z +2.0"), "%s", c->text);
    wcut_redundancy_destroy(&r);
}

/* ---- zeros ---- */

static void add_zero(int cut, wcut_channel channel, double zero) {
    for (int i = 0; i < recording(cut)->samples; i++) column(cut, channel)[i] += zero;
}

TEST(a_sensor_that_reads_in_the_air_has_its_zero_subtracted) {
    for (int cut = 0; cut < m.cuts; cut++) add_zero(cut, WCUT_CHANNEL_TENSION_B, -0.2);
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_TENSION_ZERO);
    ck_assert_str_eq(c->column, "tension_b_N");
    ck_assert_msg(c->common && fabs(c->found + 0.2) < 2.5 * c->error && c->error < 0.02, "%s", c->text);
    ck_assert_double_eq_tol(r.cut[2].recording->channel[WCUT_CHANNEL_TENSION_B].value[50],
                            column(2, WCUT_CHANNEL_TENSION_B)[50] - c->found, 1e-12);
    wcut_redundancy_destroy(&r);
}

TEST(both_zeros_at_once_are_two_contradictions) {
    for (int cut = 0; cut < m.cuts; cut++)
        add_zero(cut, WCUT_CHANNEL_TENSION_A, 0.4), add_zero(cut, WCUT_CHANNEL_TENSION_B, 0.4);
    wcut_redundancy r = compare();
    ck_assert_int_eq(r.count, 2);
    ck_assert_str_ne(r.found[0].column, r.found[1].column);
    wcut_redundancy_destroy(&r);
}

TEST(a_zero_of_one_cut_is_of_that_cut_and_a_small_one_is_repeatability) {
    add_zero(1, WCUT_CHANNEL_TENSION_A, 0.3);
    wcut_redundancy r = compare();
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_TENSION_ZERO);
    ck_assert(!c->common);
    ck_assert_int_eq(c->cut[0], 1);
    ck_assert_ptr_eq(r.cut[0].recording, recording(0));
    wcut_redundancy_destroy(&r);

    add_zero(1, WCUT_CHANNEL_TENSION_A, -0.27);
    r = compare();
    ck_assert_int_eq(r.count, 0);
    wcut_redundancy_destroy(&r);
}

/* a record at rest is taken in place of the air; one that reads nothing leaves a zero of the air alone */
TEST(a_record_at_rest_has_the_zeros) {
    enum { REST = 200 };
    static double time[REST], tension_a[REST], tension_b[REST];
    wcut_recording still = {.samples = REST};
    static char name[] = "of the record";
    still.channel[WCUT_CHANNEL_TIME] = (wcut_column){.name = name, .value = time};
    still.channel[WCUT_CHANNEL_TENSION_A] = (wcut_column){.name = name, .value = tension_a};
    still.channel[WCUT_CHANNEL_TENSION_B] = (wcut_column){.name = name, .value = tension_b};
    for (int i = 0; i < REST; i++) {
        time[i] = 0.05 * i, tension_a[i] = 0.02 * sin(7.1 * i), tension_b[i] = 0.12 + 0.02 * sin(5.3 * i);
        for (int cut = 0; cut < m.cuts && i == 0; cut++) add_zero(cut, WCUT_CHANNEL_TENSION_B, 0.12);
    }
    wcut_redundancy r;
    ck_assert_int_eq(wcut_redundancy_create(m.cuts, m.cut, &still, &r, NULL), WCUT_OK);
    const wcut_contradiction *c = only(&r, WCUT_CONTRADICTION_TENSION_ZERO);
    ck_assert_str_eq(c->column, "tension_b_N");
    ck_assert_msg(fabs(c->found - 0.12) < 0.005 && c->common && strstr(c->text, "at rest"), "%s", c->text);
    wcut_redundancy_destroy(&r);
}

/* ---- all of them, and what is not there ---- */

TEST(two_faults_at_once_are_both_found) {
    for (int cut = 0; cut < m.cuts; cut++) add_zero(cut, WCUT_CHANNEL_TENSION_A, 0.3);
    scale_column(WCUT_CHANNEL_STATION, WCUT_CHANNEL_STATION, 1.005);
    give_programme(0, 1, true, true);
    wcut_redundancy r = compare();
    ck_assert_int_eq(r.count, 3);
    ck_assert_int_eq(r.found[0].kind, WCUT_CONTRADICTION_EXCITATION);
    ck_assert_int_eq(r.found[1].kind, WCUT_CONTRADICTION_STATION);
    ck_assert_int_eq(r.found[2].kind, WCUT_CONTRADICTION_TENSION_ZERO);
    wcut_redundancy_destroy(&r);
}

TEST(missing_jobs_and_samples_are_passed_over) {
    wcut_diagnosis_cut few[3] = {m.cut[0], {.job = m.job[1]}, {.recording = recording(2)}};
    wcut_redundancy r;
    ck_assert_int_eq(wcut_redundancy_create(3, few, NULL, &r, NULL), WCUT_OK);
    ck_assert_int_eq(r.count, 0);
    ck_assert_ptr_null(r.cut[1].recording);
    wcut_redundancy_destroy(&r);
}

TEST(a_verdict_of_no_difference_follows_the_contradictions_and_does_not_deny_them) {
    static wcut_diagnosis d;
    d = (wcut_diagnosis){.kind = WCUT_VERDICT_NONE};
    give_programme(0, 1, true, true);
    wcut_redundancy r = compare();
    ck_assert_int_eq(r.count, 1);
    wcut_diagnosis_sentence(&d);
    ck_assert_msg(strncmp(d.sentence, "No difference beyond noise", 26) == 0, "%s", d.sentence);
    ck_assert(wcut_contradictions_report(&r, false, &d));
    ck_assert_msg(strncmp(d.sentence, r.found[0].text, strlen(r.found[0].text)) == 0, "%s", d.sentence);
    ck_assert_msg(strstr(d.sentence, " Otherwise no difference beyond noise") != NULL, "%s", d.sentence);
    wcut_free(d.contradiction);
    wcut_redundancy_destroy(&r);
}

TEST(no_memory_leaves_nothing_behind) {
    for (int cut = 0; cut < m.cuts; cut++) add_zero(cut, WCUT_CHANNEL_TENSION_A, 0.3), give_heater(cut, 0.9, 0);
    wcut_redundancy r = {0};
    EACH_FAILED_ALLOCATION(wcut_redundancy_create(m.cuts, m.cut, NULL, &r, NULL), r.cut == NULL);
    ck_assert_int_eq(r.count, 2);
    wcut_redundancy_destroy(&r);
}

TEST(kinds_have_names_in_files) {
    ck_assert_str_eq(wcut_contradiction_name(WCUT_CONTRADICTION_STATION), "station_scale");
    ck_assert_str_eq(wcut_contradiction_name(WCUT_CONTRADICTION_COUNT), "");
}

/* ---- labelled cases ---- */

/* contradictions of a labelled case; -1: it is not there */
static int contradictions_of(const char *set, char letter, int number, wcut_contradiction *first) {
    char path[400];
    wcut_case *found = NULL;
    snprintf(path, sizeof path, WCUT_SOURCE_DIR "/../shared/cases/%s/%c%02d/case.json", set, letter, number);
    if (wcut_case_read(path, &found, NULL) != WCUT_OK) return -1;
    wcut_diagnosis_cut *cut = wcut_alloc((size_t)found->cuts, sizeof *cut);
    for (int k = 0; k < found->cuts; k++) {
        wcut_job *job = NULL;
        wcut_recording *r = NULL;
        ck_assert_int_eq(wcut_job_read(found->cut[k].job, &job, NULL), WCUT_OK);
        ck_assert_int_eq(wcut_recording_read(found->cut[k].recording, NULL, &r, NULL), WCUT_OK);
        cut[k] = (wcut_diagnosis_cut){.job = job, .recording = r};
    }
    wcut_redundancy all;
    ck_assert_int_eq(wcut_redundancy_create(found->cuts, cut, NULL, &all, NULL), WCUT_OK);
    const int count = all.count;
    if (count > 0) *first = all.found[0];
    wcut_redundancy_destroy(&all);
    for (int k = 0; k < found->cuts; k++) {
        wcut_job_destroy((wcut_job *)cut[k].job);
        wcut_recording_destroy((wcut_recording *)cut[k].recording);
    }
    wcut_free(cut);
    wcut_case_destroy(found);
    return count;
}

/* of 134 cases of two laboratories one has a contradiction, the station scale of 1.0037 that is concealed in it */
TEST(labelled_cases_contradict_nothing_but_where_a_station_scale_is_concealed) {
    static const struct {
        const char *set;
        char letter;
        int count;
    } sets[] = {{"dev", 'c', 48}, {"dev2", 'd', 48}, {"rig", 'r', 38}};
    wcut_contradiction first = {0};
    if (contradictions_of("dev", 'c', 1, &first) < 0) SKIP("no ../shared/cases here");
    for (size_t s = 0; s < sizeof sets / sizeof *sets; s++)
        for (int k = 1; k <= sets[s].count; k++) {
            const int count = contradictions_of(sets[s].set, sets[s].letter, k, &first);
            const bool concealed = sets[s].letter == 'r' && k == 34;
            ck_assert_msg(count == concealed, "%s %d: %d, %s", sets[s].set, k, count, count > 0 ? first.text : "");
            if (concealed) ck_assert_msg(fabs(first.found - 1.0037313) < 3 * first.error, "%s", first.text);
        }
}
