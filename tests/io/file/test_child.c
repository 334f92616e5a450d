/* A process of its own: what it writes arrives; what it must not do ends it alone. */
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>

#include "io/file/child.h"
#include "io/given.h"
#include "test.h"

static char *data;
static size_t length;

static wcut_child_end run(wcut_child_work *work, int seconds, size_t memory, size_t response) {
    const wcut_child_limits limits = {seconds, memory, response};
    data = (char *)&length;
    length = 999;
    const wcut_child_end end = wcut_child_run(work, &length, &limits, &data, &length);
    if (end.how != WCUT_CHILD_DONE) ck_assert(data == NULL && length == 0);
    return end;
}

static int write_much(int fd, void *context) {
    static const char block[1000] = "much";
    (void)context;
    for (int k = 0; k < 1000; k++)
        if (!wcut_child_write(fd, block, sizeof block)) return 9;
    return 7;
}

static int crash(int fd, void *context) {
    (void)fd, (void)context;
    raise(SIGSEGV);
    return 0;
}

static int loop(int fd, void *context) {
    (void)fd;
    for (volatile size_t *n = context;;) *n += 1;
    return 0;
}

static int take_memory(int fd, void *context) {
    (void)fd, (void)context;
    volatile char *block = malloc((size_t)1 << 30);
    if (!block) return 2;
    block[0] = 1;
    free((void *)block);
    return 1;
}

static int open_files(int fd, void *context) {
    (void)context;
    int opened = 0;
    for (int k = 3; k < 64; k++) opened += k != fd && fcntl(k, F_GETFD) >= 0;
    return opened + (open("/etc/passwd", O_RDONLY) >= 0) + (open("new", O_WRONLY | O_CREAT, 0666) >= 0);
}

TEST(what_it_writes_and_returns_arrives) {
    const wcut_child_end end = run(write_much, 20, (size_t)1 << 30, 1000000);
    ck_assert(end.how == WCUT_CHILD_DONE && end.code == 7 && length == 1000000);
    ck_assert(memcmp(data + 999000, "much", 5) == 0);
    free(data);
}

TEST(a_crash_a_loop_and_a_flood_end_it_alone) {
    wcut_child_end end = run(crash, 20, (size_t)1 << 30, 1000);
    ck_assert(end.how == WCUT_CHILD_CRASHED && end.code == SIGSEGV);
    ck_assert_int_eq(run(loop, 1, (size_t)1 << 30, 1000).how, WCUT_CHILD_SLOW);
    ck_assert_int_eq(run(write_much, 20, (size_t)1 << 30, 999999).how, WCUT_CHILD_TALKATIVE);
}

TEST(it_has_no_files_and_only_so_much_memory) {
    const int open_here = open("/dev/null", O_RDONLY);
    ck_assert_int_ge(open_here, 3);
    wcut_child_end end = run(open_files, 20, (size_t)1 << 30, 1000);
    ck_assert(end.how == WCUT_CHILD_DONE && end.code == 0);
    free(data);
#ifndef __SANITIZE_ADDRESS__ /* whose allocator has its terabytes of addresses before the limit comes */
    end = run(take_memory, 20, (size_t)1 << 28, 1000);
    ck_assert_msg(end.how != WCUT_CHILD_DONE || end.code == 2, "%d %d", end.how, end.code);
    free(data);
#endif
    end = run(take_memory, 20, (size_t)4 << 30, 1000);
    ck_assert_msg(end.how == WCUT_CHILD_DONE && end.code == 1, "%d %d", end.how, end.code);
    free(data);
    close(open_here);
}
