/* The input of a case of a sweep in the case's folder: the document with its values, and for a case of recordings the
   files that it names, as further links to the same files: no second copy of a recording on the disk. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/read_file.h"
#include "io/process/case.h"
#include "io/study/sweep.h"

enum { COPY_BYTES = 1 << 20 };

static wcut_status fail_input_memory(wcut_error *error) {
    return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
}

/* every folder of a path, from its byte `from` on */
static wcut_status make_input_folders(char *path, size_t from, wcut_error *error) {
    for (char *slash = strchr(path + from, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        const int failure = mkdir(path, 0777) == 0 || errno == EEXIST ? 0 : errno;
        if (failure) return wcut_fail_errno(error, WCUT_NOT_WRITTEN, failure, path, "no folder for a case's input");
        *slash = '/';
    }
    return WCUT_OK;
}

/* the bytes of one file into another, where the file system has no second name for it */
static wcut_status copy_input_file(const char *from, const char *to, wcut_error *error) {
    wcut_file *file = NULL;
    char *bytes = wcut_alloc(COPY_BYTES, 1);
    FILE *in = bytes ? fopen(from, "rbe") : NULL;
    if (!in) {
        const int failure = errno;
        wcut_free(bytes);
        return bytes ? wcut_fail_errno(error, WCUT_NOT_FOUND, failure, from, "not readable") : fail_input_memory(error);
    }

    /* piece by piece: a scan may be large */
    wcut_status status = wcut_file_create(to, &file, error);
    for (size_t n = 1; status == WCUT_OK && n > 0;) {
        n = fread(bytes, 1, COPY_BYTES, in);
        wcut_file_write(file, bytes, n);
    }
    if (status == WCUT_OK && ferror(in)) status = wcut_fail(error, WCUT_NOT_FOUND, "%s: not readable", from);
    if (status == WCUT_OK) status = wcut_file_commit(file, error);
    wcut_file_destroy(file);
    fclose(in);
    wcut_free(bytes);
    return status;
}

/* A file of the case under its own name in `folder`. One that is missing, or no ordinary file, is left to the verb, which
   says so in its own words. */
static wcut_status place_file(const char *from, const char *name, const char *folder, wcut_error *error) {
    struct stat s;
    if (stat(from, &s) != 0 || !S_ISREG(s.st_mode)) return WCUT_OK;
    const size_t size = strlen(folder) + strlen(name) + 2;
    char *to = wcut_alloc(size, 1);
    if (!to) return fail_input_memory(error);
    snprintf(to, size, "%s/%s", folder, name);

    /* a link of an earlier run may lead to what the file was before */
    wcut_status status = make_input_folders(to, strlen(folder) + 1, error);
    if (status == WCUT_OK && unlink(to) != 0 && errno != ENOENT)
        status = wcut_fail_errno(error, WCUT_NOT_WRITTEN, errno, to, "not replaced");
    if (status == WCUT_OK && linkat(AT_FDCWD, from, AT_FDCWD, to, AT_SYMLINK_FOLLOW) != 0)
        status = copy_input_file(from, to, error);
    wcut_free(to);
    return status;
}

/* the files that the document names, from beside the study's own input to beside this one */
static wcut_status place_files(const wcut_study *study, const char *text, const char *folder, wcut_error *error) {
    wcut_case *found = NULL;
    char *path = wcut_study_join(study, study->input[0]);
    if (!path) return fail_input_memory(error);

    /* a value that no case may have: the verb refuses it, and the case is recorded as failed */
    const wcut_status parsed = wcut_case_parse(text, strlen(text), path, &found, NULL);
    const size_t length = wcut_folder_length(path);
    wcut_free(path);
    if (parsed != WCUT_OK) return parsed == WCUT_NO_MEMORY ? fail_input_memory(error) : WCUT_OK;

    wcut_status status = WCUT_OK;
    for (int i = 0; status == WCUT_OK && wcut_case_file(found, i); i++)
        status = place_file(wcut_case_file(found, i), wcut_case_file(found, i) + length, folder, error);
    wcut_case_destroy(found);
    return status;
}

wcut_status wcut_sweep_input_write(const wcut_study *study, int k, const char *folder, wcut_error *error) {
    char *text = NULL;
    if (wcut_study_input_print(study, k, &text) != WCUT_OK) return fail_input_memory(error);

    /* a job stands alone; a case has a folder of its own, in which no name is that of a result */
    const size_t size = strlen(folder) + sizeof "/input/case.json";
    char *path = *text ? wcut_alloc(size, 1) : NULL;
    wcut_status status = *text && !path ? fail_input_memory(error) : WCUT_OK;
    if (path) {
        snprintf(path, size, "%s/%s", folder, study->recorded ? "input/case.json" : "input.json");
        if (study->recorded) status = make_input_folders(path, strlen(folder) + 1, error);
        if (status == WCUT_OK) status = wcut_file_write_whole(path, text, strlen(text), error);
        if (status == WCUT_OK && study->recorded) {
            path[strlen(path) - strlen("/case.json")] = '\0';
            status = place_files(study, text, path, error);
        }
    }
    wcut_free(path);
    free(text);
    return status;
}
