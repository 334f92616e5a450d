/* The page in a real browser: chromium, driven by browser.mjs; skipped without chromium or node.
   labels: unit plain */
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "report/pages.h"
#include "test.h"

static pages_data data;

static wcut_status write_pages(const char *folder, wcut_error *error) {
    char path[4096];
    pages_fill(&data);
    if (!pages_fill_cloud(&data)) return WCUT_NO_MEMORY;
    snprintf(path, sizeof path, "%s/cut.html", folder);
    wcut_status status = pages_write_cut(&data, path, error);
    snprintf(path, sizeof path, "%s/cloud.html", folder);
    if (!status) status = pages_write_cloud(&data, path, error);
    pages_free(&data);
    snprintf(path, sizeof path, "%s/cases.html", folder);
    if (!status) status = pages_write_cases(path, error);
    return status;
}

/* give a command's exit code, -1 where it could not run */
static int run(const char *const argument[]) {
    const pid_t child = fork();
    if (child == 0) {
        execvp(argument[0], (char *const *)argument);
        _exit(127);
    }
    int code = -1;
    return child > 0 && waitpid(child, &code, 0) == child && WIFEXITED(code) ? WEXITSTATUS(code) : -1;
}

TEST(a_browser_shows_it_reads_it_back_and_runs_nothing_foreign) {
    char folder[] = "/tmp/wirecut-page-XXXXXX", path[64];
    wcut_error error = {WCUT_OK, ""};
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_msg(write_pages(folder, &error) == WCUT_OK, "%s", error.text);
    const char *const browse[] = {"node", WCUT_SOURCE_DIR "/tests/report/browser.mjs", folder, NULL};
    const int code = run(browse);
    for (const char *const *name = (const char *const[]){"cut.html", "cloud.html", "cases.html", NULL}; *name; name++) {
        snprintf(path, sizeof path, "%s/%s", folder, *name);
        remove(path);
    }
    rmdir(folder);
    if (code == 77 || code == 127) SKIP("the page was not opened: there is no chromium or no node");
    ck_assert_int_eq(code, 0);
}
