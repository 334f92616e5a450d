/* A file that appears whole or not at all: temporary name beside the target, fsync, rename, fsync of the folder. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "io/file/atomic.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/fail.h"

#define MARK ".wirecut-"
#define SUFFIX ".part"
enum { NAME_KEPT = 150, ATTEMPTS = 10000, MOVE_SIZE = 1 << 20 };

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
    *mode = (int)(s.st_mode & 07777);
    /* rename would replace a write-protected file too: its owner said no */
    return faccessat(AT_FDCWD, path, W_OK, AT_EACCESS) == 0 ? 0 : errno;
}

static int open_folder(const char *path, const char *name) {
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

/* the process in a temporary's name; 0 where the name is none */
static long owner_of(const char *name) {
    const char *mark = NULL;
    for (const char *p = strstr(name, MARK); p; p = strstr(p + 1, MARK)) mark = p;
    if (name[0] != '.' || !mark) return 0;
    char *end;
    long owner = strtol(mark + strlen(MARK), &end, 10), attempt = -1;
    if (*end == '-' && end[1] >= '0' && end[1] <= '9') attempt = strtol(end + 1, &end, 10);
    return owner > 0 && owner <= INT_MAX && attempt >= 0 && strcmp(end, SUFFIX) == 0 ? owner : 0;
}

/* A temporary is stale where its process is dead and nobody holds its lock: the lock also protects those of processes
   that have another name for themselves (containers), or share ours. What cannot be removed stays: it harms nobody. */
static void sweep_one(int folder, const char *name) {
    long owner = owner_of(name);
    if (owner == 0) return;
    if (owner != (long)getpid() && (kill((pid_t)owner, 0) == 0 || errno != ESRCH)) return;
    int fd = openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) return;
    if (flock(fd, LOCK_EX | LOCK_NB) == 0) unlinkat(folder, name, 0);
    close(fd);
}

static void sweep(int folder) {
    int fd = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *list = fd < 0 ? NULL : fdopendir(fd);
    if (!list) {
        if (fd >= 0) close(fd);
        return;
    }
    for (struct dirent *entry = readdir(list); entry; entry = readdir(list)) sweep_one(folder, entry->d_name);
    closedir(list);
}

/* open and lock a temporary; a sweeper may come between the two, then its link is gone and the next name is tried */
static int open_temporary(wcut_file *file) {
    for (int k = 0; k < ATTEMPTS; k++) {
        snprintf(file->temporary, sizeof file->temporary, ".%.*s" MARK "%ld-%d" SUFFIX, NAME_KEPT, file->name,
                 (long)getpid(), k);
        int fd = openat(file->folder, file->temporary, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd < 0 && errno == EEXIST) continue;
        if (fd < 0) return -1;
        struct stat s;
        flock(fd, LOCK_EX); /* a file system without locks has no sweeper that gets one either */
        if (fstat(fd, &s) == 0 && s.st_nlink > 0) return fd;
        close(fd);
    }
    errno = EEXIST;
    return -1;
}

/* ---- the file ---- */

/* errno, or 0 */
static int begin(wcut_file *file) {
    int mode;
    file->path = follow_link(file->label);
    if (!file->path) return errno ? errno : ENOMEM;
    const char *slash = strrchr(file->path, '/');
    file->name = slash ? slash + 1 : file->path;
    if (file->name[0] == '\0') return file->path[0] ? EISDIR : ENOENT;
    int code = check_target(file->path, &mode);
    if (code) return code;
    file->folder = open_folder(file->path, file->name);
    if (file->folder < 0) return errno;
    sweep(file->folder);
    file->fd = open_temporary(file);
    if (file->fd < 0) return errno;
    return mode >= 0 && fchmod(file->fd, (mode_t)mode) != 0 ? errno : 0;
}

wcut_status wcut_file_create(const char *path, wcut_file **file, wcut_error *error) {
    if (!path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "the path of an output is NULL");
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
    errno = 0;
    int code = begin(made);
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

wcut_status wcut_file_commit(wcut_file *file, wcut_error *error) {
    if (file->code == 0 && fsync(file->fd) != 0) file->code = errno;
    if (file->code == 0) {
        if (renameat(file->folder, file->temporary, file->folder, file->name) == 0)
            file->committed = true;
        else
            file->code = errno;
    }
    /* some file systems cannot fsync a folder (EINVAL): they order the rename themselves */
    if (file->code == 0 && fsync(file->folder) != 0 && errno != EINVAL) file->code = errno;
    return wcut_file_check(file, error);
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
