/* Hostile calls of studies and sweeps. */
#include "hostile/hostile.h"
#include "io/given.h"

#define ERR OPT(NULL)

static wcut_study *study;
static wcut_sweep *sweep;

static void begin_study(void) {
    wcut_error error = {0};
    enter_folder();
    write_file("input.txt", "{\"heat\": 0}");
    write_file("study.json",
               "{\"format\": \"wirecut-study/1\", \"name\": \"s\", \"verb\": \"simulate\", \"input\": \"input.txt\", "
               "\"parameters\": {\"/heat\": [1, 2]}, \"figures\": {\"v\": \"/value\"}}");
    ck_assert_msg(wcut_study_read("study.json", &study, &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_sweep_create("study.json", "out", &sweep, &error) == WCUT_OK, "%s", error.text);
}

static void end_study(void) {
    wcut_study_destroy(study);
    wcut_sweep_destroy(sweep);
    leave_folder();
}
FIXTURE(begin_study, end_study);

/* every case ends with 1 */
static const wcut_sweep_options *options(void) {
    static wcut_sweep_options o;
    o = wcut_sweep_options_default();
    o.program = "/bin/false";
    return &o;
}

static const wcut_slurm *slurm(void) {
    static const wcut_slurm s = {.program = "/bin/false", .tasks = 1, .cpus = 1};
    return &s;
}

HOSTILE_MADE(wcut_study_read, wcut_study, wcut_study_destroy, PTR("study.json"), PTR(&made), ERR)
HOSTILE_VALUE(wcut_study_destroy, NULL)
HOSTILE_VALUE(wcut_study_view, OPT(study))
HOSTILE_TEXT(wcut_study_value_print, PTR(study), INT(1), INT(0), PTR(&made))
HOSTILE_TEXT(wcut_study_input_print, PTR(study), INT(1), PTR(&made))
HOSTILE(wcut_study_hash_eval) {
    char text[WCUT_STUDY_HASH_SIZE] = "999";
    EACH_HOSTILE_ARGUMENT(wcut_study_hash_eval, wcut_study_hash_eval(PTR(study), INT(1), PTR(&text[0])),
                          strcmp(text, "999") == 0, strcpy(text, "999"));
}
HOSTILE_TEXT(wcut_study_call_print, PTR(study), INT(1), PTR("folder"), PTR(&made))

HOSTILE_VALUE(wcut_sweep_state_name, ANY_ENUM(WCUT_SWEEP_STATE_DONE))
HOSTILE_VALUE(wcut_sweep_options_default)
HOSTILE_MADE(wcut_sweep_create, wcut_sweep, wcut_sweep_destroy, PTR("study.json"), PTR("other"), PTR(&made), ERR)
HOSTILE_MADE(wcut_sweep_read, wcut_sweep, wcut_sweep_destroy, PTR("out"), PTR(&made), ERR)
HOSTILE_VALUE(wcut_sweep_destroy, NULL)
HOSTILE_VALUE(wcut_sweep_view, OPT(sweep))
HOSTILE(wcut_sweep_run) {
    wcut_sweep_counts counts;
    hostile_fill(&counts, sizeof counts);
    EACH_HOSTILE_ARGUMENT(wcut_sweep_run, wcut_sweep_run(PTR(sweep), PTR(options()), OPT(&counts), ERR),
                          hostile_is_filled(&counts, sizeof counts), hostile_fill(&counts, sizeof counts));

    /* a count out of its range is refused, too */
    wcut_sweep_options o = *options();
    for (int k = 0; k < 6; k++) {
        o = *options();
        if (k == 0) o.jobs = 0;
        if (k == 1) o.jobs = WCUT_SWEEP_JOBS_MAX + 1;
        if (k == 2) o.shares = 0;
        if (k == 3) o.share = 1;
        if (k == 4) o.share = -1;
        if (k == 5) o.program = NULL;
        ck_assert_int_eq(wcut_sweep_run(sweep, &o, NULL, NULL), WCUT_BAD_ARGUMENT);
    }
}
HOSTILE(wcut_sweep_query) {
    wcut_sweep_counts counts;
    hostile_fill(&counts, sizeof counts);
    EACH_HOSTILE_ARGUMENT(wcut_sweep_query, wcut_sweep_query(PTR(sweep), PTR(&counts), ERR),
                          hostile_is_filled(&counts, sizeof counts), hostile_fill(&counts, sizeof counts));
}
HOSTILE(wcut_sweep_measure) {
    double second, total, bytes = 999;
    ck_assert_int_eq(wcut_sweep_measure(NULL, options(), &second, &total, &bytes, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_sweep_measure(sweep, NULL, &second, &total, &bytes, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_sweep_measure(sweep, options(), NULL, &total, &bytes, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_sweep_measure(sweep, options(), &second, NULL, &bytes, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_sweep_measure(sweep, options(), &second, &total, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_sweep_measure(sweep, options(), &second, &total, &bytes, NULL), WCUT_DEGENERATE);
    ck_assert_double_eq(bytes, 999);
}
HOSTILE_STATUS(wcut_sweep_figures_query, PTR(sweep), ERR)
HOSTILE_FILE(wcut_sweep_write_csv, PTR(sweep), PTR(OUT_FILE), ERR)
HOSTILE_TEXT(wcut_sweep_print, PTR(sweep), PTR(&made), ERR)
HOSTILE_FILE(wcut_slurm_write, PTR(sweep), PTR(slurm()), PTR(OUT_FILE), ERR)
HOSTILE_FILE(wcut_report_sweep_write, PTR(sweep), PTR(OUT_FILE), ERR)
