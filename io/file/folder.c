/* A folder held open: its lock, the targets in it, and the temporaries that dead processes left there. */
#include "io/file/folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define MARK ".wirecut-"
#define SUFFIX ".part"
enum { STEM_MAX = 150, ATTEMPTS_MAX = 10000, PERMISSIONS = 0777 };

int wcut_folder_check(int folder, const char *name, int *mode) {
    struct stat s;
    *mode = -1;
    if (fstatat(folder, name, &s, AT_SYMLINK_NOFOLLOW) != 0) return errno == ENOENT ? 0 : errno;
    if (S_ISDIR(s.st_mode)) return EISDIR;
    if (S_ISLNK(s.st_mode)) return ELOOP;
    if (!S_ISREG(s.st_mode)) return EINVAL;
    *mode = (int)(s.st_mode & PERMISSIONS);

    /* rename would replace a write-protected file too: its owner said no */
    return faccessat(folder, name, W_OK, AT_EACCESS) == 0 ? 0 : errno;
}

/* ---- temporaries ---- */

void wcut_folder_name(char text[NAME_MAX + 1], const char *stem, int k) {
    const char *dot = *stem ? "." : "";
    snprintf(text, NAME_MAX + 1, "%s%.*s" MARK "%ld-%d" SUFFIX, dot, STEM_MAX, stem, (long)getpid(), k);
}

long wcut_folder_owner(const char *name) {
    const char *mark = NULL;
    for (const char *p = strstr(name, MARK); p; p = strstr(p + 1, MARK)) mark = p;
    if (name[0] != '.' || !mark) return 0;
    char *end;
    long owner = strtol(mark + strlen(MARK), &end, 10), attempt = -1;
    if (*end == '-' && end[1] >= '0' && end[1] <= '9') attempt = strtol(end + 1, &end, 10);
    return owner > 0 && owner <= INT_MAX && attempt >= 0 && strcmp(end, SUFFIX) == 0 ? owner : 0;
}

bool wcut_folder_hold(int folder, const char *name, int fd) {
    struct stat held, named;
    while (flock(fd, LOCK_EX) != 0 && errno == EINTR) continue;
    return fstat(fd, &held) == 0 && fstatat(folder, name, &named, AT_SYMLINK_NOFOLLOW) == 0 &&
           held.st_ino == named.st_ino && held.st_dev == named.st_dev;
}

/* whether nobody works on an open temporary any more; the lock that tells is kept until the descriptor is closed */
static bool is_abandoned(int fd, long owner) {
    if (flock(fd, LOCK_EX | LOCK_NB) == 0) return true;
    if (errno == EWOULDBLOCK) return false;
    return owner != (long)getpid() && kill((pid_t)owner, 0) != 0 && errno == ESRCH;
}

/* what cannot be removed stays: it harms nobody */
static void sweep_one(int folder, const char *name) {
    const long owner = wcut_folder_owner(name);
    if (owner == 0) return;
    const int fd = openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) return;
    struct stat s;
    if (fstat(fd, &s) == 0 && is_abandoned(fd, owner)) {
        if (S_ISDIR(s.st_mode))
            wcut_folder_remove_tree(folder, name, NULL);
        else
            unlinkat(folder, name, 0);
    }
    close(fd);
}

/* the entries of a folder, for closedir; NULL: errno */
static DIR *open_list(int folder) {
    const int fd = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *list = fd < 0 ? NULL : fdopendir(fd);
    if (!list && fd >= 0) close(fd);
    return list;
}

void wcut_folder_sweep(int folder) {
    DIR *list = open_list(folder);
    if (!list) return;
    for (struct dirent *entry = readdir(list); entry; entry = readdir(list)) sweep_one(folder, entry->d_name);
    closedir(list);
}

int wcut_folder_make_temporary(int folder, char name[NAME_MAX + 1], int *fd) {
    for (int k = 0; k < ATTEMPTS_MAX; k++) {
        wcut_folder_name(name, "", k);
        if (mkdirat(folder, name, PERMISSIONS) != 0) {
            if (errno == EEXIST) continue;
            return errno;
        }
        *fd = openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (*fd >= 0 && wcut_folder_hold(folder, name, *fd)) return 0;
        const int code = *fd < 0 ? errno : 0;
        if (*fd >= 0) close(*fd);
        *fd = -1;

        /* a sweeper may have come between the two: only then another name helps */
        unlinkat(folder, name, AT_REMOVEDIR);
        if (code != 0 && code != ENOENT) return code;
    }
    return EEXIST;
}

/* remove the files of a folder, and its folders down to a depth */
static int empty_folder(int folder, const char *first, int depth) {
    int code = 0;
    if (first && unlinkat(folder, first, 0) != 0 && errno != ENOENT) return errno;

    /* the rest, in the order of the folder */
    DIR *list = open_list(folder);
    if (!list) return errno;

    /* every entry but the folder itself and its parent */
    for (struct dirent *entry = readdir(list); entry; entry = readdir(list)) {
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0 || unlinkat(folder, name, 0) == 0) continue;

        /* no file: a folder, whose own entries go first */
        const int inner = depth > 1 ? openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC) : -1;
        if (inner >= 0) {
            const int inside = empty_folder(inner, NULL, depth - 1);
            code = code ? code : inside;
            close(inner);
        }
        if (unlinkat(folder, name, AT_REMOVEDIR) != 0 && code == 0) code = errno;
    }

    closedir(list);
    return code;
}

int wcut_folder_remove_tree(int folder, const char *name, const char *first) {
    const int fd = openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (fd < 0) return errno == ENOENT ? 0 : errno;
    const int code = empty_folder(fd, first, 2);
    close(fd);
    if (code) return code;
    return unlinkat(folder, name, AT_REMOVEDIR) == 0 || errno == ENOENT ? 0 : errno;
}

/* ---- the folder itself ---- */

int wcut_folder_lock(int folder, double seconds) {
    const struct timespec pause = {0, 10L * 1000 * 1000};
    struct timespec begun, now;
    clock_gettime(CLOCK_MONOTONIC, &begun);
    for (;;) {
        if (flock(folder, LOCK_EX | LOCK_NB) == 0) return 0;
        if (errno != EWOULDBLOCK && errno != EINTR) return ENOLCK;
        clock_gettime(CLOCK_MONOTONIC, &now);
        const double waited = (double)(now.tv_sec - begun.tv_sec) + 1e-9 * (double)(now.tv_nsec - begun.tv_nsec);
        if (waited >= seconds) return EWOULDBLOCK;
        nanosleep(&pause, NULL);
    }
}

int wcut_folder_sync(int folder) { return fsync(folder) == 0 || errno == EINVAL ? 0 : errno; }
