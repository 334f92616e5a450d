/* Threads that cannot be had: as many as there can be do the work, and the process goes on. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wirecut/wirecut.h>

#include "base/threads.h"
#include "test.h"

TEST(any_number_may_be_asked_for) {
    ck_assert_int_eq(wcut_threads(1), 1);
    ck_assert_int_eq(wcut_threads(INT_MIN), 1);
    ck_assert_int_eq(wcut_threads(2), 2);
    const int max = wcut_threads(INT_MAX);
    ck_assert(max >= 1 && max <= WCUT_THREADS_MAX);
    ck_assert_int_eq(wcut_threads(1), 1);
}

#ifndef __SANITIZE_ADDRESS__ /* its shadow needs the address space that is taken away here */
/* [byte] the address space in use */
static rlim_t used(void) {
    long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    ck_assert(file && fscanf(file, "%ld", &pages) == 1 && fclose(file) == 0);
    return (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE);
}

TEST(without_room_for_stacks_one_thread_does_the_work) {
    const wcut_vec3 p[8] = {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}, {3, 1, 1}, {4, 0, 0}, {5, 1, 2}, {6, 2, 0}, {7, 1, 1}};
    wcut_curve *curve = NULL;
    wcut_curve_foot foot[8];
    ck_assert_int_eq(wcut_curve_interpolate(8, p, &curve), WCUT_OK);
    fflush(NULL);
    const pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        const struct rlimit limit = {used() + (4 << 20), RLIM_INFINITY};
        if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(2);
        const int had = wcut_threads(64);
        _exit(had < 1 || had == 64 ? 3 : wcut_curve_locate(curve, 8, p, 64, foot) == WCUT_OK ? 0 : 4);
    }
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert_msg(WIFEXITED(status) && WEXITSTATUS(status) == 0, "the child ended with %d", status);
    wcut_curve_destroy(curve);
}
#endif
