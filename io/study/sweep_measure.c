/* What a sweep takes: its first case is run, and the others are taken to be like it. */
#include <dirent.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/study/sweep.h"

enum { BLOCK = 512 }; /* [byte] that st_blocks counts (POSIX) */

/* [byte] on disk of a folder with its files */
static double size_of(const char *folder) {
    struct stat s;
    double bytes = 0;
    DIR *list = opendir(folder);
    if (!list) return 0;
    for (struct dirent *entry = readdir(list); entry; entry = readdir(list))
        if (strcmp(entry->d_name, "..") != 0 && fstatat(dirfd(list), entry->d_name, &s, AT_SYMLINK_NOFOLLOW) == 0)
            bytes += (double)s.st_blocks * BLOCK;
    closedir(list);
    return bytes;
}

wcut_status wcut_sweep_measure(wcut_sweep *sweep, const wcut_sweep_options *options, double *seconds, double *total,
                               double *bytes, wcut_error *error) {
    if (!sweep || !options || !seconds || !total || !bytes)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));

    /* the first case alone: a share of one */
    const int cases = sweep->study->info.cases;
    wcut_sweep_options first = *options;
    first.share = 0;
    first.shares = cases;
    wcut_status status = wcut_sweep_run(sweep, &first, NULL, error);
    if (status != WCUT_OK) return status;

    /* what it took */
    char hash[WCUT_STUDY_HASH_SIZE];
    wcut_sweep_record record;
    char *folder = wcut_study_hash_eval(sweep->study, 0, hash) == WCUT_OK ? wcut_sweep_folder(sweep, hash) : NULL;
    if (!folder) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    wcut_sweep_record_read(folder, &record);
    if (!record.result[0])
        status = wcut_fail(error, WCUT_DEGENERATE, "the first case has no result (%s): %.300s",
                           wcut_sweep_state_name(record.state), record.words);
    const double size = size_of(folder);
    wcut_free(folder);
    if (status != WCUT_OK) return status;

    const int together = options->jobs < cases ? options->jobs : cases;
    *seconds = record.seconds;
    *total = record.seconds * cases / together;
    *bytes = size * cases;
    return WCUT_OK;
}
