/* A folder for the time of a call. */
#include "scratch.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"
#include "terminal.h"

int app_scratch_make(char path[PATH_MAX]) {
    const char *where = getenv("TMPDIR");
    snprintf(path, PATH_MAX, "%s/wirecut-XXXXXX", where && *where ? where : "/tmp");
    return mkdtemp(path) ? APP_DONE : app_fail(APP_NOT_WRITTEN, "%s: %s", path, strerror(errno));
}

/* what is inside an open folder, and in its folders; links are not followed */
static void empty(int folder) {
    struct stat s;
    DIR *list = fdopendir(folder);
    if (!list) {
        close(folder);
        return;
    }
    for (struct dirent *entry = readdir(list); entry; entry = readdir(list)) {
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0) continue;
        const int is_folder = fstatat(folder, name, &s, AT_SYMLINK_NOFOLLOW) == 0 && S_ISDIR(s.st_mode);
        if (is_folder) {
            const int inside = openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
            if (inside >= 0) empty(inside);
        }
        unlinkat(folder, name, is_folder ? AT_REMOVEDIR : 0);
    }
    closedir(list);
}

void app_scratch_remove(const char *path) {
    const int folder = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder >= 0) empty(folder);
    rmdir(path);
}
