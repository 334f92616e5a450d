/* A whole file into memory, up to a limit; pipes too, so the size is found by reading. */
#include "io/file/read_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/fail.h"

enum { FIRST_SIZE = 1 << 16 };

static size_t first_size(int fd, size_t max) {
    struct stat s;
    size_t size = FIRST_SIZE;
    if (fstat(fd, &s) == 0 && S_ISREG(s.st_mode) && s.st_size > 0) size = (size_t)s.st_size + 2;
    return size < max + 2 ? size : max + 2;
}

static wcut_status refuse_size(wcut_error *error, const char *path, size_t max) {
    char name[WCUT_QUOTE_SIZE];
    return wcut_fail(error, WCUT_BAD_FORMAT, "%s: found more than %zu MB, expected at most that",
                     wcut_quote(name, path, WCUT_LABEL_MAX, 1), max >> 20);
}

static wcut_status refuse_file_memory(wcut_error *error, const char *path) {
    char name[WCUT_QUOTE_SIZE];
    return wcut_fail(error, WCUT_NO_MEMORY, "%s: %s", wcut_quote(name, path, WCUT_LABEL_MAX, 1),
                     wcut_status_text(WCUT_NO_MEMORY));
}

/* a device has no end: it would fill the memory up to the limit, or wait for somebody to type */
wcut_status wcut_file_check_kind(int fd, const char *path, wcut_error *error) {
    struct stat s;
    char name[WCUT_QUOTE_SIZE];
    if (fstat(fd, &s) != 0) return wcut_fail_errno(error, WCUT_NOT_FOUND, errno, path, "cannot be read");
    if (S_ISREG(s.st_mode) || S_ISFIFO(s.st_mode) || S_ISSOCK(s.st_mode)) return WCUT_OK;
    if (S_ISDIR(s.st_mode)) return wcut_fail_errno(error, WCUT_NOT_FOUND, EISDIR, path, "cannot be read");
    return wcut_fail(error, WCUT_BAD_FORMAT, "%s: found a device, expected a file or a pipe",
                     wcut_quote(name, path, WCUT_LABEL_MAX, 1));
}

/* read to the end; *text is the caller's to free in any case */
static wcut_status read_file_all(int fd, const char *path, size_t max, char **text, size_t *length, wcut_error *error) {
    /* the size that the file states, though a pipe states none */
    size_t capacity = first_size(fd, max), used = 0;
    *text = wcut_alloc(capacity, 1);
    if (!*text) return refuse_file_memory(error, path);

    /* until the end of the file, with twice the room where it is full */
    for (;;) {
        ssize_t n = read(fd, *text + used, capacity - used - 1);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return wcut_fail_errno(error, WCUT_NOT_FOUND, errno, path, "cannot be read");
        if (n == 0) break;
        used += (size_t)n;
        if (used > max) return refuse_size(error, path, max);
        if (used + 1 < capacity) continue;
        capacity = capacity <= max / 2 ? 2 * capacity : max + 2;
        char *grown = wcut_grow(*text, capacity);
        if (!grown) return refuse_file_memory(error, path);
        *text = grown;
    }

    (*text)[used] = '\0';
    *length = used;

    return WCUT_OK;
}

wcut_status wcut_file_read(const char *path, size_t max, char **text, size_t *length, wcut_error *error) {
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (fd < 0) return wcut_fail_errno(error, WCUT_NOT_FOUND, errno, path, "cannot be read");
    char *found = NULL;
    size_t count = 0;
    wcut_status status = wcut_file_check_kind(fd, path, error);
    if (status == WCUT_OK) status = read_file_all(fd, path, max, &found, &count, error);
    close(fd); /* nothing was written: a failed close loses nothing */
    if (status != WCUT_OK) {
        free(found);
        return status;
    }
    *text = found;
    *length = count;
    return WCUT_OK;
}

size_t wcut_folder_length(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

char *wcut_path_join(const char *folder, size_t length, const char *name) {
    char *path = wcut_alloc(length + strlen(name) + 1, 1);
    if (!path) return NULL;
    memcpy(path, folder, length);
    memcpy(path + length, name, strlen(name) + 1);
    return path;
}
