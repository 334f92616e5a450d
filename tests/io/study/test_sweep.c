/* Sweeps with a small program in the place of the command: what is run, run again, recorded and collected. */
#include <signal.h>
#include <wirecut/sweep.h>

#include "base/fail.h"
#include "io/given.h"
#include "test.h"

/* Its case's heat decides how it ends. Results are vouched for as the command does. */
static const char program[] =
    "#!/bin/sh\n"
    "folder=$4\n"
    "heat=$(sed 's/.*\"heat\":\\([0-9]*\\).*/\\1/' \"$2\")\n"
    "echo \"$heat\" >>ran\n"
    "case $heat in\n"
    "  1) echo 'wirecut: first' >&2; echo 'last words' >&2; exit 3 ;;\n"
    "  2) [ -e mended ] || kill -9 $$ ;;\n"
    "  3) [ -e mended ] || exit 1 ;;\n"
    "  4) end=6 ;;\n"
    "esac\n"
    "printf '{\"value\": %s, \"text\": \"a,b\", \"files\": [\"r.json\"], \"sha256\": {}}' \"$heat\" "
    ">\"$folder/r.json\"\n"
    "exit ${end-0}\n";

static void begin_sweep(void) {
    enter_folder();
    write_file("program", program);
    ck_assert_int_eq(chmod("program", 0755), 0);
    write_file("input.txt", "{\"heat\": 0, \"other\": 1}");
    write_file("study.json",
               "{\"format\": \"wirecut-study/1\", \"name\": \"s\", \"verb\": \"simulate\", \"input\": \"input.txt\", "
               "\"parameters\": {\"/heat\": [0, 1, 2, 3, 4, 5]}, \"figures\": {\"v\": \"/value\", \"t\": \"/text\"}, "
               "\"best\": {\"figure\": \"v\", \"goal\": \"highest\"}}");
}
FIXTURE(begin_sweep, leave_folder);

static wcut_sweep *open_sweep(void) {
    wcut_sweep *sweep = NULL;
    wcut_error error = {0};
    ck_assert_msg(wcut_sweep_create("study.json", "out", &sweep, &error) == WCUT_OK, "%s", error.text);
    return sweep;
}

static wcut_sweep_counts run_all(wcut_sweep *sweep, int jobs) {
    wcut_sweep_options options = wcut_sweep_options_default();
    wcut_sweep_counts counts;
    wcut_error error = {0};
    options.program = "./program";
    options.jobs = jobs;
    ck_assert_msg(wcut_sweep_run(sweep, &options, &counts, &error) == WCUT_OK, "%s", error.text);
    return counts;
}

static char *csv_of(const wcut_sweep *sweep) {
    char *text = NULL;
    size_t length;
    wcut_error error = {0};
    ck_assert_msg(wcut_sweep_write_csv(sweep, "table.csv", &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(wcut_file_read("table.csv", 1 << 20, &text, &length, NULL), WCUT_OK);
    return text;
}

TEST(a_case_that_fails_or_crashes_stops_no_other_and_those_are_run_again) {
    wcut_sweep *sweep = open_sweep();
    wcut_sweep_counts counts = run_all(sweep, 3);
    ck_assert_int_eq(counts.ran, 6);
    ck_assert_int_eq(counts.state[WCUT_SWEEP_STATE_DONE], 2);
    ck_assert_int_eq(counts.state[WCUT_SWEEP_STATE_REFUSED], 1);
    ck_assert_int_eq(counts.state[WCUT_SWEEP_STATE_CRASHED], 1);
    ck_assert_int_eq(counts.state[WCUT_SWEEP_STATE_FAILED], 1);
    ck_assert_int_eq(counts.state[WCUT_SWEEP_STATE_NOT_CONVERGED], 1);

    /* once mended the two are run, and then none */
    write_file("mended", "");
    counts = run_all(sweep, 2);
    ck_assert_int_eq(counts.ran, 2);
    ck_assert_int_eq(counts.state[WCUT_SWEEP_STATE_DONE], 4);
    ck_assert_int_eq(run_all(sweep, 2).ran, 0);
    wcut_sweep_destroy(sweep);
}

TEST(the_table_is_the_same_whatever_the_processes_and_the_order) {
    write_file("mended", "");
    wcut_sweep *sweep = open_sweep();
    run_all(sweep, 5);
    char *one = csv_of(sweep);
    wcut_sweep_destroy(sweep);
    ck_assert_int_eq(system("rm -r out"), 0);
    sweep = open_sweep();

    /* the second share first */
    wcut_sweep_options options = wcut_sweep_options_default();
    options.program = "./program";
    options.shares = 2;
    for (options.share = 1; options.share >= 0; options.share--)
        ck_assert_int_eq(wcut_sweep_run(sweep, &options, NULL, NULL), WCUT_OK);
    char *other = csv_of(sweep);
    ck_assert_str_eq(one, other);
    ck_assert_ptr_nonnull(strstr(one, ",4,4,\"a,b\",not_converged\n"));
    ck_assert_ptr_nonnull(strstr(one, ",1,,,refused\n"));
    free(one);
    free(other);

    /* the summary: the best of those that are done */
    char *text = NULL;
    ck_assert_int_eq(wcut_sweep_print(sweep, &text, NULL), WCUT_OK);
    ck_assert_ptr_nonnull(
        strstr(text, "\"best\": {\"figure\": \"v\", \"goal\": \"highest\", \"cases\": [\n    {\"case\": 5,"));
    free(text);
    wcut_sweep_destroy(sweep);
}

TEST(a_result_that_was_changed_is_run_again) {
    write_file("mended", "");
    wcut_sweep *sweep = open_sweep();
    run_all(sweep, 2);
    ck_assert_int_eq(system("for f in out/cases/*/*/r.json; do grep -l 'value\": 5' $f; done | head -1 >which && "
                            "printf ' ' >>$(cat which)"),
                     0);
    ck_assert_int_eq(run_all(sweep, 2).ran, 1);
    ck_assert_int_eq(system("rm -r $(ls -d out/cases/* | head -1)"), 0);
    ck_assert_int_eq(run_all(sweep, 2).ran, 1);
    wcut_sweep_destroy(sweep);
}

TEST(a_second_sweep_in_the_folder_is_refused_and_a_task_beside_another_is_not) {
    wcut_sweep *sweep = open_sweep(), *second = NULL, *task = NULL;
    wcut_error error = {0};
    char process[32];
    ck_assert_int_eq(wcut_sweep_create("study.json", "out", &second, &error), WCUT_NOT_WRITTEN);
    snprintf(process, sizeof process, "process %ld", (long)getpid());
    ck_assert_msg(strstr(error.text, process) != NULL, "%s", error.text);
    ck_assert_ptr_null(second);

    /* nor does a task run beside it; two tasks do */
    wcut_sweep_options options = wcut_sweep_options_default();
    options.program = "./program";
    ck_assert_int_eq(wcut_sweep_read("out", &task, &error), WCUT_OK);
    ck_assert_int_eq(wcut_sweep_run(task, &options, NULL, &error), WCUT_NOT_WRITTEN);
    wcut_sweep_destroy(sweep);
    ck_assert_int_eq(wcut_sweep_read("out", &second, &error), WCUT_OK);
    ck_assert_int_eq(wcut_sweep_run(task, &options, NULL, &error), WCUT_OK);
    ck_assert_int_eq(wcut_sweep_run(second, &options, NULL, &error), WCUT_OK);
    ck_assert_int_eq(wcut_sweep_create("study.json", "out", &sweep, &error), WCUT_NOT_WRITTEN);
    wcut_sweep_destroy(task);
    wcut_sweep_destroy(second);
}

TEST(a_figure_that_no_result_has_is_refused_with_the_nearest) {
    char *text = NULL;
    size_t length;
    ck_assert_int_eq(wcut_file_read("study.json", 1 << 20, &text, &length, NULL), WCUT_OK);
    char *changed = given_changed(text, "/value", "/valu");
    write_file("study.json", changed);
    wcut_sweep *sweep = open_sweep();
    wcut_error error = {0};
    ck_assert_int_eq(wcut_sweep_figures_query(sweep, &error), WCUT_OK);
    run_all(sweep, 2);
    ck_assert_int_eq(wcut_sweep_figures_query(sweep, &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_sweep_write_csv(sweep, "table.csv", &error), WCUT_NOT_FOUND);
    ck_assert_msg(strstr(error.text, "the nearest is /value") != NULL, "%s", error.text);
    ck_assert_int_ne(access("table.csv", F_OK), 0);
    wcut_sweep_destroy(sweep);
    free(changed);
    free(text);
}

static int stop_at_two(int looked, int cases, void *context) {
    (void)cases;
    (void)context;
    return looked >= 2;
}

TEST(an_interrupted_run_leaves_no_process_and_goes_on_later) {
    write_file("mended", "");
    wcut_sweep *sweep = open_sweep();
    wcut_sweep_options options = wcut_sweep_options_default();
    wcut_sweep_counts counts;
    wcut_error error = {0};
    options.program = "./program";
    options.progress = stop_at_two;
    ck_assert_int_eq(wcut_sweep_run(sweep, &options, &counts, &error), WCUT_INTERRUPTED);
    ck_assert(counts.ran >= 2 && counts.ran < 6);
    ck_assert_int_eq(run_all(sweep, 2).ran, 6 - counts.state[WCUT_SWEEP_STATE_DONE] -
                                                counts.state[WCUT_SWEEP_STATE_REFUSED] -
                                                counts.state[WCUT_SWEEP_STATE_NOT_CONVERGED]);
    ck_assert_int_eq(wcut_sweep_query(sweep, &counts, NULL), WCUT_OK);
    ck_assert_int_eq(counts.state[WCUT_SWEEP_STATE_MISSING], 0);
    wcut_sweep_destroy(sweep);
}

TEST(a_program_that_cannot_be_started_is_an_error) {
    wcut_sweep *sweep = open_sweep();
    wcut_sweep_options options = wcut_sweep_options_default();
    wcut_error error = {0};
    options.program = "./none";
    ck_assert_int_eq(wcut_sweep_run(sweep, &options, NULL, &error), WCUT_NOT_FOUND);
    ck_assert_ptr_nonnull(strstr(error.text, "./none"));
    wcut_sweep_destroy(sweep);
}

TEST(equal_cases_of_a_study_are_run_once) {
    char *text = NULL;
    size_t length;
    ck_assert_int_eq(wcut_file_read("study.json", 1 << 20, &text, &length, NULL), WCUT_OK);
    char *changed = given_changed(text, "[0, 1, 2, 3, 4, 5]", "[7, 7, 7, 7]");
    write_file("study.json", changed);
    wcut_sweep *sweep = open_sweep();
    run_all(sweep, 3);
    free(text);
    ck_assert_int_eq(wcut_file_read("ran", 1 << 20, &text, &length, NULL), WCUT_OK);
    ck_assert_str_eq(text, "7\n");
    char *table = csv_of(sweep);
    for (int k = 0; k < 4; k++) {
        char row[100], hash[WCUT_STUDY_HASH_SIZE];
        ck_assert_int_eq(wcut_study_hash_eval(wcut_sweep_view(sweep), k, hash), WCUT_OK);
        snprintf(row, sizeof row, "\n%d,%s,7,7,\"a,b\",done\n", k, hash);
        ck_assert_ptr_nonnull(strstr(table, row));
    }
    free(table);
    wcut_sweep_destroy(sweep);
    free(changed);
    free(text);
}

TEST(a_batch_script_keeps_any_folder_one_word_and_refuses_other_letters) {
    ck_assert_int_eq(mkdir("a 'b' %j", 0777), 0);
    wcut_sweep *sweep = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_sweep_create("study.json", "a 'b' %j/out", &sweep, &error), WCUT_OK);
    wcut_slurm slurm = {.program = "/bin/echo",
                        .tasks = 99,
                        .cpus = 2,
                        .partition = "long",
                        .time = "1:00:00",
                        .memory = "2G",
                        .modules = "gcc/12,x"};
    ck_assert_int_eq(wcut_slurm_write(sweep, &slurm, "script", &error), WCUT_OK);
    char *text = NULL;
    size_t length;
    ck_assert_int_eq(wcut_file_read("script", 1 << 16, &text, &length, NULL), WCUT_OK);
    ck_assert_ptr_nonnull(strstr(text, "#SBATCH --array=0-5\n#SBATCH --cpus-per-task=2\n"));
    ck_assert_ptr_nonnull(strstr(text, "#SBATCH --partition=long\n#SBATCH --time=1:00:00\n#SBATCH --mem=2G\n"));
    ck_assert_ptr_nonnull(strstr(text, "a 'b' %%j/out/slurm-%A_%a.log\"\n"));
    ck_assert_ptr_nonnull(strstr(text, "module load gcc/12\nmodule load x\nexec '/bin/echo' sweep '/"));
    free(text);

    /* a shell reads the folder back as it is */
    ck_assert_int_eq(system("SLURM_ARRAY_TASK_ID=3 sh -c 'module() { :; }; . ./script' >said 2>&1"), 0);
    ck_assert_int_eq(wcut_file_read("said", 1 << 16, &text, &length, NULL), WCUT_OK);
    ck_assert_msg(strstr(text, "a 'b' %j/out --task 3 --tasks 6 --jobs 2 --quiet\n") != NULL, "%s", text);
    free(text);
    slurm.partition = "x\nrm";
    ck_assert_int_eq(wcut_slurm_write(sweep, &slurm, "script", &error), WCUT_BAD_ARGUMENT);
    wcut_sweep_destroy(sweep);
}

TEST(a_changed_plan_is_refused) {
    wcut_sweep *sweep = open_sweep();
    wcut_error error = {0};
    wcut_sweep_destroy(sweep);
    sweep = NULL;
    write_file("out/study.json", "{}");
    ck_assert_int_eq(wcut_sweep_read("out", &sweep, &error), WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "study.json: changed since"));
    ck_assert_int_eq(wcut_sweep_read(".", &sweep, &error), WCUT_NOT_FOUND);
}
