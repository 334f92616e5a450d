/* A file that appears whole or not at all: temporary name beside the target, fsync, rename, fsync of the folder. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "io/file/atomic.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/folder.h"

enum { ATTEMPTS_MAX = 10000, MOVE_SIZE = 1 << 20 };

struct wcut_file {
    char *label;      /* the path as the caller gave it, for messages */
    char *path;       /* with symbolic links followed */
    const char *name; /* within path, behind the last '/' */
    int folder, fd;   /* descriptors; fd holds a lock for as long as the temporary is alive */
    uint64_t end;     /* where the next append goes */
    int code;         /* errno of the first failure, 0: none */
    bool committed;
    char temporary[NAME_MAX + 1];
};

/* ---- the target ---- */

/* the path to replace: of a symbolic link what it points to */
static char *follow_link(const char *path) {
    struct stat s;
    if (lstat(path, &s) == 0 && S_ISLNK(s.st_mode)) return realpath(path, NULL);
    char *copy = wcut_alloc(strlen(path) + 1, 1);
    if (!copy) return errno = ENOMEM, NULL; /* lstat has left another */
    return memcpy(copy, path, strlen(path) + 1);
}

/* errno where the target may not be replaced, 0 where it may; mode: that of the file it replaces, -1 where there is
   none */
static int check_target(const char *path, int *mode) {
    struct stat s;
    *mode = -1;
    if (stat(path, &s) != 0) return errno == ENOENT ? 0 : errno;
    if (S_ISDIR(s.st_mode)) return EISDIR;
    if (!S_ISREG(s.st_mode)) return EINVAL; /* a device or a pipe cannot appear whole */
    *mode = (int)(s.st_mode & 0777);        /* who writes is another owner, maybe: no set-user-id for him */
    /* rename would replace a write-protected file too: its owner said no */
    return faccessat(AT_FDCWD, path, W_OK, AT_EACCESS) == 0 ? 0 : errno;
}

static int open_atomic_folder(const char *path, const char *name) {
    char *folder = wcut_alloc(strlen(path) + 3, 1);
    if (!folder) return errno = ENOMEM, -1;
    if (name == path)
        memcpy(folder, ".", 2);
    else
        memcpy(folder, path, (size_t)(name - path));
    int fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    int code = errno;
    free(folder);
    errno = code;
    return fd;
}

/* ---- temporaries ---- */

/* open and lock a temporary; a sweeper may come between the two, then the next name is tried */
static int open_temporary(wcut_file *file) {
    for (int k = 0; k < ATTEMPTS_MAX; k++) {
        wcut_folder_name(file->temporary, file->name, k);
        int fd = openat(file->folder, file->temporary, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd < 0 && errno == EEXIST) continue;
        if (fd < 0 || wcut_folder_hold(file->folder, file->temporary, fd)) return fd;
        unlinkat(file->folder, file->temporary, 0);
        close(fd);
    }
    errno = EEXIST;
    return -1;
}

/* ---- the file ---- */

/* errno, or 0 */
static int begin_atomic(wcut_file *file) {
    int mode;
    file->path = follow_link(file->label);
    if (!file->path) return errno ? errno : ENOMEM;
    const char *slash = strrchr(file->path, '/');
    file->name = slash ? slash + 1 : file->path;
    if (file->name[0] == '\0') return file->path[0] ? EISDIR : ENOENT;
    int code = check_target(file->path, &mode);
    if (code) return code;
    file->folder = open_atomic_folder(file->path, file->name);
    if (file->folder < 0) return errno;
    wcut_folder_sweep(file->folder);
    file->fd = open_temporary(file);
    if (file->fd < 0) return errno;
    return mode >= 0 && fchmod(file->fd, (mode_t)mode) != 0 ? errno : 0;
}

wcut_status wcut_file_create(const char *path, wcut_file **file, wcut_error *error) {
    if (!path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "the path of an output is NULL");

    /* the file's own copies, before anything is on disk */
    wcut_file *made = wcut_alloc(1, sizeof *made);
    char *label = wcut_alloc(strlen(path) + 1, 1);
    if (!made || !label) {
        free(made);
        free(label);
        return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    memcpy(label, path, strlen(path) + 1);
    made->label = label;
    made->folder = made->fd = -1;

    /* the temporary beside the target */
    errno = 0;
    int code = begin_atomic(made);
    if (code) {
        wcut_status status = wcut_fail_errno(error, code == ENOMEM ? WCUT_NO_MEMORY : WCUT_NOT_WRITTEN, code, path,
                                             code == EINVAL ? "not written, no regular file" : "not written");
        wcut_file_destroy(made);
        return status;
    }

    *file = made;

    return WCUT_OK;
}

void wcut_file_write_at(wcut_file *file, uint64_t offset, const void *data, size_t size) {
    const char *from = data;
    while (size > 0 && file->code == 0) {
        ssize_t n = pwrite(file->fd, from, size, (off_t)offset);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
            file->code = n < 0 ? errno : ENOSPC;
            return;
        }
        from += n;
        offset += (uint64_t)n;
        size -= (size_t)n;
    }
}

void wcut_file_write(wcut_file *file, const void *data, size_t size) {
    wcut_file_write_at(file, file->end, data, size);
    file->end += size;
}

void wcut_file_seek(wcut_file *file, uint64_t offset) { file->end = offset; }

void wcut_file_move(wcut_file *file, uint64_t to, uint64_t from, uint64_t size) {
    if (to == from || size == 0 || file->code) return;
    char *block = wcut_alloc(MOVE_SIZE, 1);
    if (!block) file->code = ENOMEM;
    while (size > 0 && file->code == 0) {
        ssize_t n = pread(file->fd, block, size < MOVE_SIZE ? (size_t)size : MOVE_SIZE, (off_t)from);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
            file->code = n < 0 ? errno : EIO;
            break;
        }
        wcut_file_write_at(file, to, block, (size_t)n);
        to += (uint64_t)n;
        from += (uint64_t)n;
        size -= (uint64_t)n;
    }
    free(block);
}

void wcut_file_truncate(wcut_file *file, uint64_t size) {
    while (file->code == 0 && ftruncate(file->fd, (off_t)size) != 0)
        if (errno != EINTR) file->code = errno;
}

wcut_status wcut_file_check(const wcut_file *file, wcut_error *error) {
    if (file->code == 0) return WCUT_OK;
    return wcut_fail_errno(error, file->code == ENOMEM ? WCUT_NO_MEMORY : WCUT_NOT_WRITTEN, file->code, file->label,
                           "not written");
}

/* a second name for the earlier file, so that it can come back; false: there is none, or no second name */
static bool keep_earlier(const wcut_file *file, char name[NAME_MAX + 1]) {
    for (int k = 0; k < ATTEMPTS_MAX; k++) {
        wcut_folder_name(name, file->name, k);
        if (linkat(file->folder, file->name, file->folder, name, 0) == 0) return true;
        if (errno != EEXIST) return false;
    }
    return false;
}

/* what a rename did, undone: the folder's entry is not certain to last. false: the earlier file could not be kept. */
static bool undo(const wcut_file *file, const char *earlier, bool had, bool kept) {
    if (kept) return renameat(file->folder, earlier, file->folder, file->name) == 0;
    return !had && unlinkat(file->folder, file->name, 0) == 0;
}

wcut_status wcut_file_commit(wcut_file *file, wcut_error *error) {
    char earlier[NAME_MAX + 1];
    struct stat s;
    if (file->code == 0 && fsync(file->fd) != 0) file->code = errno;
    if (file->code) return wcut_file_check(file, error);

    /* the name changes hands in one step */
    const bool had = fstatat(file->folder, file->name, &s, AT_SYMLINK_NOFOLLOW) == 0;
    const bool kept = had && keep_earlier(file, earlier);
    file->committed = renameat(file->folder, file->temporary, file->folder, file->name) == 0;
    file->code = file->committed ? wcut_folder_sync(file->folder) : errno;
    const bool back = file->code == 0 || !file->committed || undo(file, earlier, had, kept);
    if (kept) unlinkat(file->folder, earlier, 0); /* gone after undo */
    if (back) return wcut_file_check(file, error);
    return wcut_fail_errno(error, WCUT_NOT_WRITTEN, file->code, file->label,
                           "replaced, but not certain to outlive a power failure");
}

void wcut_file_destroy(wcut_file *file) {
    if (!file) return;
    if (file->fd >= 0) {
        if (!file->committed) unlinkat(file->folder, file->temporary, 0);
        close(file->fd); /* after fsync: nothing left that could be lost */
    }
    if (file->folder >= 0) close(file->folder);
    free(file->path);
    free(file->label);
    free(file);
}

wcut_status wcut_file_write_whole(const char *path, const void *data, size_t size, wcut_error *error) {
    wcut_file *file = NULL;
    wcut_status status = wcut_file_create(path, &file, error);
    if (status != WCUT_OK) return status;
    wcut_file_write(file, data, size);
    status = wcut_file_commit(file, error);
    wcut_file_destroy(file);
    return status;
}
