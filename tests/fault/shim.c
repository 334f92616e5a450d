/* Faults on purpose, preloaded into the command: the n-th system call, or the n-th allocation, fails or is the last.

     FAULT_AT      n, from 1; 0 or none: calls are counted only
     FAULT_WHAT    call | memory
     FAULT_HOW     kill | a number, the errno
     FAULT_COUNT   a file that gets the number of calls at the end

   What counts are the calls through which the command and its libraries reach files: it is they that can lose one. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

static atomic_long count;
static long at;
static bool memory, kills;
static int code;
static pid_t self;
static const char *count_path;

__attribute__((constructor)) static void begin(void) {
    const char *text = getenv("FAULT_AT"), *what = getenv("FAULT_WHAT"), *how = getenv("FAULT_HOW");
    count_path = getenv("FAULT_COUNT");
    kills = how && strcmp(how, "kill") == 0;
    code = how && !kills ? atoi(how) : EIO;
    memory = what && strcmp(what, "memory") == 0;
    at = text ? atol(text) : 0;
    self = getpid();
}

__attribute__((destructor)) static void end(void) {
    if (!count_path || self != getpid()) return;
    char text[32];
    const int n = snprintf(text, sizeof text, "%ld\n", atomic_load(&count));
    const int fd = (int)syscall(SYS_openat, AT_FDCWD, count_path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (fd < 0) return;
    if (syscall(SYS_write, fd, text, n) != n) _exit(99);
    syscall(SYS_close, fd);
}

/* whether this call fails; children of the command count nothing */
static bool strikes(bool allocation) {
    if (allocation != memory || self == 0 || self != (pid_t)syscall(SYS_getpid)) return false;
    if (atomic_fetch_add(&count, 1) + 1 != at) return false;
    if (kills) kill(self, SIGKILL);
    errno = allocation ? ENOMEM : code;
    return true;
}

/* NAME as the C library has it, unless this call fails */
#define CALL(type, name, parameters, arguments)               \
    type name parameters {                                    \
        static type(*real) parameters;                        \
        if (!real) *(void **)&real = dlsym(RTLD_NEXT, #name); \
        return strikes(false) ? (type)-1 : real arguments;    \
    }

CALL(ssize_t, write, (int fd, const void *data, size_t size), (fd, data, size))
CALL(ssize_t, pwrite, (int fd, const void *data, size_t size, off_t offset), (fd, data, size, offset))
CALL(ssize_t, read, (int fd, void *data, size_t size), (fd, data, size))
CALL(ssize_t, pread, (int fd, void *data, size_t size, off_t offset), (fd, data, size, offset))
CALL(int, fsync, (int fd), (fd))
CALL(int, ftruncate, (int fd, off_t size), (fd, size))
CALL(int, fchmod, (int fd, mode_t mode), (fd, mode))
CALL(int, fchmodat, (int folder, const char *path, mode_t mode, int flags), (folder, path, mode, flags))
CALL(int, rename, (const char *from, const char *to), (from, to))
CALL(int, renameat, (int a, const char *from, int b, const char *to), (a, from, b, to))
CALL(int, linkat, (int a, const char *from, int b, const char *to, int flags), (a, from, b, to, flags))
CALL(int, unlink, (const char *path), (path))
CALL(int, unlinkat, (int folder, const char *path, int flags), (folder, path, flags))
CALL(int, mkdir, (const char *path, mode_t mode), (path, mode))
CALL(int, mkdirat, (int folder, const char *path, mode_t mode), (folder, path, mode))
CALL(int, flock, (int fd, int operation), (fd, operation))
CALL(int, fstat, (int fd, struct stat *s), (fd, s))
CALL(int, fstatat, (int folder, const char *path, struct stat *s, int flags), (folder, path, s, flags))
CALL(int, stat, (const char *path, struct stat *s), (path, s))
CALL(int, faccessat, (int folder, const char *path, int mode, int flags), (folder, path, mode, flags))

static mode_t mode_of(int flags, va_list arguments) {
    return flags & (O_CREAT | O_TMPFILE) ? va_arg(arguments, mode_t) : 0;
}

int open(const char *path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return strikes(false) ? -1 : (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char *path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return strikes(false) ? -1 : (int)syscall(SYS_openat, folder, path, flags, mode);
}

/* it is closed all the same, as Linux does */
int close(int fd) {
    const bool fails = strikes(false);
    const int cause = errno;
    const int result = (int)syscall(SYS_close, fd);
    if (fails) errno = cause;
    return fails ? -1 : result;
}

/* ---- memory: glibc's own names, since dlsym allocates ---- */

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *memory, size_t size);

void *malloc(size_t size) { return strikes(true) ? NULL : __libc_malloc(size); }
void *calloc(size_t n, size_t size) { return strikes(true) ? NULL : __libc_calloc(n, size); }
void *realloc(void *from, size_t size) { return strikes(true) ? NULL : __libc_realloc(from, size); }
