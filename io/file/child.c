/* Work in a process of its own, with limits, so that what it crashes on or loops over is its end alone. */
#include "io/file/child.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/fail.h"

/* ---- in the child ---- */

bool wcut_child_write(int fd, const void *data, size_t size) {
    const char *from = data;
    while (size > 0) {
        const ssize_t n = write(fd, from, size);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        from += n;
        size -= (size_t)n;
    }
    return true;
}

/* the caller's signal handlers and masks are not for this process */
static void forget_signals(void) {
    sigset_t none;
    for (int k = 1; k < 32; k++) signal(k, SIG_DFL); /* refused for SIGKILL and SIGSTOP */
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
}

/* nothing open but fd; 0 to 2 lead nowhere */
static bool close_others(int fd) {
    const int nowhere = open("/dev/null", O_RDWR);
    if (nowhere < 0) return false;
    for (int k = 0; k < 3; k++)
        if (k != fd && dup2(nowhere, k) < 0) return false;
    DIR *list = opendir("/proc/self/fd");
    if (!list) return false;
    for (struct dirent *entry = readdir(list); entry; entry = readdir(list)) {
        const int open_one = atoi(entry->d_name); /* "." and ".." are 0 */
        if (open_one > 2 && open_one != fd && open_one != dirfd(list)) close(open_one);
    }
    closedir(list);
    return true;
}

/* [byte] of address space in use; 0 where that is not known */
static size_t used_memory(void) {
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file) return 0;
    if (fscanf(file, "%lu", &pages) != 1) pages = 0;
    fclose(file);
    return pages * (size_t)sysconf(_SC_PAGESIZE);
}

/* the host's own limit stays where it is lower */
static bool limit_resource(int resource, size_t max) {
    struct rlimit r;
    if (getrlimit(resource, &r) != 0) return false;
    if (r.rlim_max > max) r.rlim_max = max;
    r.rlim_cur = r.rlim_max;
    return setrlimit(resource, &r) == 0;
}

static bool confine(int fd, const wcut_child_limits *limits) {
    const size_t memory = used_memory();
    forget_signals();
    if (memory == 0 || memory > SIZE_MAX / 2 || !close_others(fd)) return false;
    return limit_resource(RLIMIT_AS, memory + limits->memory) &&
           limit_resource(RLIMIT_CPU, (size_t)limits->seconds + 1) && limit_resource(RLIMIT_FSIZE, 0) &&
           limit_resource(RLIMIT_CORE, 0) && limit_resource(RLIMIT_NPROC, 0) && limit_resource(RLIMIT_NOFILE, 0);
}

/* ---- in the parent ---- */

enum { CANNOT_CONFINE = 120, FIRST_ROOM = 1 << 16 };

/* [ms] from a start, never less than 0 */
static long elapsed(const struct timespec *start) {
    struct timespec now = *start;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (now.tv_sec - start->tv_sec) * 1000 + (now.tv_nsec - start->tv_nsec) / 1000000;
}

/* wait for something to read; false: the time is over */
static bool await(int fd, const struct timespec *start, int seconds) {
    for (;;) {
        const long left = 1000L * seconds - elapsed(start);
        if (left <= 0) return false;
        struct pollfd one = {.fd = fd, .events = POLLIN};
        if (poll(&one, 1, (int)left) > 0) return true;
    }
}

/* everything up to the end of the pipe, grown into *data */
static wcut_child_end collect_child(int fd, const wcut_child_limits *limits, char **data, size_t *length) {
    size_t room = 0;
    struct timespec start = {0};
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (;;) {
        if (*length == room) {
            room = room ? 2 * room : FIRST_ROOM;
            char *grown = wcut_grow(*data, room);
            if (!grown) return (wcut_child_end){WCUT_CHILD_NO_MEMORY, 0};
            *data = grown;
        }
        if (!await(fd, &start, limits->seconds)) return (wcut_child_end){WCUT_CHILD_SLOW, 0};
        const ssize_t n = read(fd, *data + *length, room - *length);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return (wcut_child_end){WCUT_CHILD_DONE, 0};
        *length += (size_t)n;
        if (*length > limits->response) return (wcut_child_end){WCUT_CHILD_TALKATIVE, 0};
    }
}

/* the child has closed its pipe, or is to end now */
static wcut_child_end reap_child(pid_t child, wcut_child_end end) {
    int state = 0;
    if (end.how != WCUT_CHILD_DONE) kill(child, SIGKILL);
    while (waitpid(child, &state, 0) < 0) {
        if (errno == EINTR) continue;
        return end; /* ECHILD: the host lets its children go unasked; what was written says whether it was done */
    }
    if (end.how != WCUT_CHILD_DONE) return end;
    if (WIFSIGNALED(state) && WTERMSIG(state) == SIGXCPU) return (wcut_child_end){WCUT_CHILD_SLOW, 0};
    if (WIFSIGNALED(state)) return (wcut_child_end){WCUT_CHILD_CRASHED, WTERMSIG(state)};
    if (WEXITSTATUS(state) == CANNOT_CONFINE) return (wcut_child_end){WCUT_CHILD_NOT_STARTED, EPERM};
    return (wcut_child_end){WCUT_CHILD_DONE, WEXITSTATUS(state)};
}

wcut_child_end wcut_child_run(wcut_child_work *work, void *context, const wcut_child_limits *limits, char **data,
                              size_t *length) {
    int ends[2];
    *data = NULL;
    *length = 0;

    /* the child works behind its limits and writes into the pipe */
    if (pipe(ends) != 0) return (wcut_child_end){WCUT_CHILD_NOT_STARTED, errno};
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        if (!confine(ends[1], limits)) _exit(CANNOT_CONFINE);
        _exit(work(ends[1], context));
    }

    /* the parent reads until the end, the limit or the deadline */
    const int code = errno;
    wcut_child_end end = {WCUT_CHILD_NOT_STARTED, code};
    close(ends[1]);
    if (child > 0) end = reap_child(child, collect_child(ends[0], limits, data, length));
    close(ends[0]);

    /* what a failed child wrote is not handed out */
    if (end.how != WCUT_CHILD_DONE) {
        free(*data);
        *data = NULL;
        *length = 0;
    }

    return end;
}
