/* wirecut sweep --slurm: the batch script goes into the sweep's folder and to sbatch. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wirecut/wirecut.h>

#include "results.h"
#include "sweep.h"
#include "terminal.h"

enum { NOT_FOUND = 127 };

/* sbatch SCRIPT; what it says goes to standard output */
static int submit(const char *script) {
    const pid_t child = fork();
    if (child == 0) {
        execlp("sbatch", "sbatch", script, (char *)NULL);
        _exit(NOT_FOUND);
    }
    int state = 0;
    if (child < 0) return app_fail(APP_FAILED, "sbatch: %s", strerror(errno));
    while (waitpid(child, &state, 0) < 0 && errno == EINTR) continue;
    if (WIFEXITED(state) && WEXITSTATUS(state) == 0) return APP_DONE;
    if (WIFEXITED(state) && WEXITSTATUS(state) == NOT_FOUND)
        return app_fail(APP_FAILED, "sbatch cannot be started, expected Slurm on the search path; the script is %s",
                        script);
    return app_fail(APP_FAILED, "sbatch did not take %s", script);
}

int app_sweep_slurm(const app_call *call, const wcut_sweep *sweep) {
    static const char *const name[] = {"sweep.sbatch", "slurm.json", NULL};
    char program[PATH_MAX], path[PATH_MAX + 16];
    wcut_error error = {0};
    app_results results = {0};
    int code = app_sweep_program(program);
    if (code != APP_DONE) return code;

    /* the script from the options */
    const wcut_slurm slurm = {.program = program,
                              .tasks = app_int(call, "tasks"),
                              .cpus = app_int(call, "jobs"),
                              .partition = app_text(call, "partition"),
                              .time = app_text(call, "time"),
                              .memory = app_text(call, "memory"),
                              .modules = app_text(call, "modules")};

    /* into the folder, and to Slurm */
    code = app_results_begin(&results, app_text(call, "output"), name);
    if (code == APP_DONE) {
        const wcut_status status = wcut_slurm_write(sweep, &slurm, app_results_path(&results, name[0]), &error);
        code = app_results_add(&results, name[0], status, &error);
    }
    if (code == APP_DONE)
        code = app_results_commit_words(&results, name[1], "{\n  \"format\": \"wirecut-slurm/1\"\n}\n");

    /* sbatch gets the path of the script, unless only the script was asked for */
    snprintf(path, sizeof path, "%s/%s", app_text(call, "output"), name[0]);
    if (code == APP_DONE && !app_given(call, "slurm-script")) code = submit(path);

    /* the folder and its files */
    if (code == APP_DONE && !app_given(call, "quiet")) app_say("in %s: %s", results.folder, app_results_list(&results));
    app_results_end(&results);
    return code;
}
