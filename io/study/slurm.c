/* The batch script of an array job of Slurm (sbatch): each task takes its share of a sweep's cases. */
#include <string.h>

#include "base/fail.h"
#include "io/study/sweep.h"

enum { TASKS_MAX = 100000, CPUS_MAX = WCUT_SWEEP_JOBS_MAX };

static const char plain_letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._:-";
static const char module_letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._:-/+,";

/* a word that stands in the script as it is */
static bool is_plain(const char *word, const char *letters) {
    return !word || (*word && *word != '-' && strspn(word, letters) == strlen(word));
}

/* a text as one word of the shell, whatever it holds */
static void put_shell_word(wcut_text *text, const char *word) {
    wcut_text_put(text, "'", 1);
    for (; *word; word++)
        if (*word == '\'')
            wcut_text_put_word(text, "'\\''");
        else
            wcut_text_put(text, word, 1);
    wcut_text_put(text, "'", 1);
}

/* sbatch reads % as a placeholder and takes the rest of a line as the value where it is quoted */
static void put_output_name(wcut_text *text, const char *folder) {
    wcut_text_put_word(text, "#SBATCH --output=\"");
    for (; *folder; folder++) {
        if (*folder == '"' || *folder == '\\') wcut_text_put(text, "\\", 1);
        if (*folder == '%') wcut_text_put(text, "%", 1);
        wcut_text_put(text, folder, 1);
    }
    wcut_text_put_word(text, "/slurm-%A_%a.log\"\n");
}

static void request(wcut_text *text, const char *words, const char *value) {
    if (value) wcut_text_print(text, "#SBATCH %s%.200s\n", words, value);
}

static void put_modules(wcut_text *text, const char *modules) {
    while (modules && *modules) {
        const size_t n = strcspn(modules, ",");
        if (n > 0) {
            wcut_text_put_word(text, "module load ");
            wcut_text_put(text, modules, n);
            wcut_text_put(text, "\n", 1);
        }
        modules += n + (modules[n] == ',');
    }
}

/* what the script is made from */
typedef struct batch {
    const wcut_sweep *sweep;
    const wcut_slurm *slurm;
} batch;

static bool put_script(wcut_text *text, const void *context) {
    const batch *b = context;
    const wcut_slurm *slurm = b->slurm;

    /* what Slurm is asked for; no more tasks than cases */
    const int cases = b->sweep->study->info.cases, tasks = slurm->tasks < cases ? slurm->tasks : cases;
    wcut_text_put_word(text, "#!/bin/sh\n#SBATCH --job-name=wirecut-sweep\n");
    wcut_text_print(text, "#SBATCH --array=0-%d\n#SBATCH --cpus-per-task=%d\n", tasks - 1, slurm->cpus);
    request(text, "--partition=", slurm->partition);
    request(text, "--time=", slurm->time);
    request(text, "--mem=", slurm->memory);
    put_output_name(text, b->sweep->folder);

    /* what a task does: its share of the cases that are not whole. Submitting again runs what was lost. */
    put_modules(text, slurm->modules);
    wcut_text_put_word(text, "exec ");
    put_shell_word(text, slurm->program);
    wcut_text_put_word(text, " sweep ");
    put_shell_word(text, b->sweep->folder);

    /* an array task finds its share by its number */
    wcut_text_print(text, " --task \"$SLURM_ARRAY_TASK_ID\" --tasks %d --jobs %d --quiet\n", tasks, slurm->cpus);
    return !text->failed;
}

wcut_status wcut_slurm_write(const wcut_sweep *sweep, const wcut_slurm *slurm, const char *path, wcut_error *error) {
    if (!sweep || !slurm || !path || !slurm->program || !*slurm->program)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    if (slurm->tasks < 1 || slurm->tasks > TASKS_MAX || slurm->cpus < 1 || slurm->cpus > CPUS_MAX)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "found %d tasks of %d processes, expected 1 to %d of 1 to %d",
                         slurm->tasks, slurm->cpus, TASKS_MAX, CPUS_MAX);
    if (!is_plain(slurm->partition, plain_letters) || !is_plain(slurm->time, plain_letters) ||
        !is_plain(slurm->memory, plain_letters) || !is_plain(slurm->modules, module_letters))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "found a partition, time, memory or module with other letters, expected letters, digits and "
                         "._:- alone");
    const batch b = {sweep, slurm};
    return wcut_text_write_file(path, put_script, &b, error);
}
