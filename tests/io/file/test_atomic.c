/* Files whole or not at all: faults of the disk, hostile targets, a kill in the middle, what dead processes left. */
#include <errno.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/given.h"
#include "test.h"

static wcut_error error;

static void not_written(const char *path, const char *line) {
    error = (wcut_error){WCUT_OK, ""};
    ck_assert_int_eq(wcut_file_write_whole(path, "new", 3, &error), WCUT_NOT_WRITTEN);
    ck_assert_int_eq(error.status, WCUT_NOT_WRITTEN);
    ck_assert_str_eq(error.text, line);
}

TEST(a_file_appears_with_its_bytes_and_nothing_beside_it) {
    enter_folder();
    ck_assert_int_eq(wcut_file_write_whole("a", "one", 3, &error), WCUT_OK);
    file_holds("a", "one");
    ck_assert_int_eq(wcut_file_write_whole("a", "another", 7, NULL), WCUT_OK);
    file_holds("a", "another");
    ck_assert_int_eq(wcut_file_write_whole("empty", "", 0, NULL), WCUT_OK);
    file_holds("empty", "");
    ck_assert_int_eq(count_entries("."), 2);
    leave_folder();
}

TEST(until_the_commit_the_target_is_as_it_was) {
    wcut_file *file = NULL;
    enter_folder();
    write_file("a", "old");
    ck_assert_int_eq(wcut_file_create("a", &file, &error), WCUT_OK);
    wcut_file_write(file, "new", 3);
    file_holds("a", "old");
    ck_assert_int_eq(count_entries("."), 2);
    wcut_file_destroy(file); /* not committed */
    file_holds("a", "old");
    ck_assert_int_eq(count_entries("."), 1);
    wcut_file_destroy(NULL);
    leave_folder();
}

TEST(writes_at_offsets_moves_and_truncation_do_what_they_say) {
    wcut_file *file = NULL;
    enter_folder();
    ck_assert_int_eq(wcut_file_create("a", &file, &error), WCUT_OK);
    wcut_file_write(file, "0123456789", 10);
    wcut_file_write_at(file, 2, "ab", 2);
    wcut_file_move(file, 1, 5, 4); /* 0 5678 5 6789 */
    wcut_file_seek(file, 7);
    wcut_file_write(file, "XYZ!", 4);
    wcut_file_truncate(file, 10);
    ck_assert_int_eq(wcut_file_commit(file, &error), WCUT_OK);
    wcut_file_destroy(file);
    file_holds("a", "0567856XYZ");
    leave_folder();
}

TEST(a_long_move_overlaps_safely) {
    enum { SIZE = 5 << 20, BY = 12345 };
    unsigned char *bytes = malloc(SIZE);
    for (int i = 0; i < SIZE; i++) bytes[i] = (unsigned char)(i * 2654435761U >> 13);
    wcut_file *file = NULL;
    enter_folder();
    ck_assert_int_eq(wcut_file_create("a", &file, &error), WCUT_OK);
    wcut_file_write(file, bytes, SIZE);
    wcut_file_move(file, 0, BY, SIZE - BY);
    wcut_file_truncate(file, SIZE - BY);
    ck_assert_int_eq(wcut_file_commit(file, &error), WCUT_OK);
    wcut_file_destroy(file);
    size_t length;
    char *back = read_back("a", &length);
    ck_assert(length == SIZE - BY && memcmp(back, bytes + BY, length) == 0);
    free(back);
    free(bytes);
    leave_folder();
}

TEST(targets_that_cannot_appear_whole_are_refused_with_the_cause) {
    enter_folder();
    ck_assert_int_eq(mkdir("folder", 0777), 0);
    ck_assert_int_eq(symlink("nowhere", "dangling"), 0);
    write_file("plain", "old");
    not_written("folder", "folder: not written: Is a directory");
    not_written("folder/", "folder/: not written: Is a directory");
    not_written(".", ".: not written: Is a directory");
    not_written("", ": not written: No such file or directory");
    not_written("none/a", "none/a: not written: No such file or directory");
    not_written("plain/a", "plain/a: not written: Not a directory");
    not_written("dangling", "dangling: not written: No such file or directory");
    not_written("/dev/full", "/dev/full: not written, no regular file: Invalid argument");
    ck_assert_int_eq(mkfifo("pipe", 0666), 0);
    not_written("pipe", "pipe: not written, no regular file: Invalid argument");
    ck_assert_int_eq(wcut_file_write_whole(NULL, "", 0, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(count_entries("."), 4);
    ck_assert_int_eq(count_entries("folder"), 0);
    leave_folder();
}

/* as somebody whom permissions bind: root is not bound */
static void become_nobody(void) {
    if (geteuid() == 0) ck_assert_int_eq(setuid(65534), 0);
}

TEST(a_folder_or_a_file_that_is_write_protected_stays_as_it_is) {
    enter_folder();
    write_file("protected", "old");
    ck_assert_int_eq(mkdir("folder", 0555), 0);
    ck_assert_int_eq(chmod("protected", 0444), 0);
    pid_t child = fork();
    if (child == 0) {
        become_nobody();
        not_written("protected", "protected: not written: Permission denied");
        not_written("folder/a", "folder/a: not written: Permission denied");
        _exit(0);
    }
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert_int_eq(status, 0);
    file_holds("protected", "old");
    ck_assert_int_eq(count_entries("."), 2);
    leave_folder();
}

TEST(a_replaced_file_keeps_its_permissions_and_a_new_one_follows_the_mask) {
    struct stat s;
    enter_folder();
    umask(027);
    write_file("old", "old");
    ck_assert_int_eq(chmod("old", 0604), 0);
    ck_assert_int_eq(wcut_file_write_whole("old", "x", 1, &error), WCUT_OK);
    ck_assert_int_eq(wcut_file_write_whole("new", "x", 1, &error), WCUT_OK);
    ck_assert(stat("old", &s) == 0 && (s.st_mode & 07777) == 0604);
    ck_assert(stat("new", &s) == 0 && (s.st_mode & 07777) == 0640);
    leave_folder();
}

TEST(a_link_stays_and_its_target_is_replaced) {
    struct stat s;
    enter_folder();
    ck_assert_int_eq(mkdir("real", 0777), 0);
    write_file("real/a", "old");
    ck_assert_int_eq(symlink("real/a", "link"), 0);
    ck_assert_int_eq(wcut_file_write_whole("link", "new", 3, &error), WCUT_OK);
    ck_assert(lstat("link", &s) == 0 && S_ISLNK(s.st_mode));
    file_holds("real/a", "new");
    ck_assert_int_eq(unlink("real/a"), 0);
    leave_folder();
}

TEST(hostile_and_long_names_are_names_like_others) {
    char longest[256];
    memset(longest, 'n', 255);
    longest[255] = '\0';
    const char *const name[] = {"a b", "%s%n", "-rf", "a\nb", "\xff\xfe", ".wirecut-1-0.part", "\xc3\xa4", longest};
    enter_folder();
    for (size_t k = 0; k < sizeof name / sizeof *name; k++) {
        ck_assert_int_eq(wcut_file_write_whole(name[k], "x", 1, &error), WCUT_OK);
        file_holds(name[k], "x");
        ck_assert_int_eq(unlink(name[k]), 0);
    }
    ck_assert_int_eq(count_entries("."), 0);
    leave_folder();
}

/* a process that has gone: its number is free for now */
static long dead_process(void) {
    pid_t child = fork();
    if (child == 0) _exit(0);
    ck_assert_int_eq(waitpid(child, NULL, 0), child);
    return (long)child;
}

TEST(what_nobody_holds_is_swept_and_nothing_else) {
    char stale[64], ours[64], living[64];
    snprintf(stale, sizeof stale, ".b.obj.wirecut-%ld-3.part", dead_process());
    snprintf(ours, sizeof ours, ".c.wirecut-%ld-0.part", (long)getpid());      /* of an earlier process of our number */
    snprintf(living, sizeof living, ".d.wirecut-%ld-0.part", (long)getppid()); /* its number says nothing */
    const char *const kept[] = {"b.wirecut-1-0.part", ".b.wirecut-99999999-0", ".b.wirecut-x-0.part",
                                ".b.wirecut-99999999-.part"};
    enter_folder();
    write_file(stale, "x");
    write_file(ours, "x");
    write_file(living, "x");
    for (size_t k = 0; k < sizeof kept / sizeof *kept; k++) write_file(kept[k], "x");
    ck_assert_int_eq(wcut_file_write_whole("a", "x", 1, &error), WCUT_OK);
    ck_assert_int_eq(access(stale, F_OK), -1);
    ck_assert_int_eq(access(ours, F_OK), -1);
    ck_assert_int_eq(access(living, F_OK), -1);
    for (size_t k = 0; k < sizeof kept / sizeof *kept; k++) ck_assert_int_eq(access(kept[k], F_OK), 0);
    leave_folder();
}

TEST(two_writers_of_one_target_do_not_disturb_each_other) {
    wcut_file *first = NULL, *second = NULL;
    enter_folder();
    ck_assert_int_eq(wcut_file_create("a", &first, &error), WCUT_OK);
    wcut_file_write(first, "first", 5);
    ck_assert_int_eq(wcut_file_create("a", &second, &error), WCUT_OK); /* sweeps, but not what is locked */
    wcut_file_write(second, "second", 6);
    ck_assert_int_eq(wcut_file_commit(second, &error), WCUT_OK);
    file_holds("a", "second");
    ck_assert_int_eq(wcut_file_commit(first, &error), WCUT_OK);
    file_holds("a", "first");
    wcut_file_destroy(first);
    wcut_file_destroy(second);
    ck_assert_int_eq(count_entries("."), 1);
    leave_folder();
}

static void wait_for(long nanoseconds) {
    struct timespec time = {0, nanoseconds};
    nanosleep(&time, NULL);
}

/* write a file again and again, every byte of it the same letter, until killed */
static void write_for_ever(void) {
    enum { SIZE = 3 << 20 };
    char *bytes = malloc(SIZE);
    for (int k = 0;; k++) {
        memset(bytes, 'a' + k % 26, SIZE);
        if (wcut_file_write_whole("a", bytes, SIZE, NULL) != WCUT_OK) _exit(1);
    }
}

static void is_whole(const char *path) {
    size_t length;
    char *text = read_back(path, &length);
    ck_assert_uint_eq(length, 3 << 20);
    for (size_t i = 1; i < length; i++)
        if (text[i] != text[0]) ck_abort_msg("torn at byte %zu", i);
    free(text);
}

TEST(a_kill_at_any_time_leaves_a_whole_file) {
    enter_folder();
    for (int k = 0; k < 30; k++) {
        pid_t child = fork();
        if (child == 0) write_for_ever();
        while (access("a", F_OK) != 0) wait_for(500000);
        wait_for(1000000 + 777000 * k);
        int status;
        ck_assert_int_eq(kill(child, SIGKILL), 0);
        ck_assert_int_eq(waitpid(child, &status, 0), child);
        ck_assert_msg(WIFSIGNALED(status), "the writer failed by itself");
        is_whole("a");
    }
    ck_assert_int_eq(wcut_file_write_whole("b", "x", 1, &error), WCUT_OK); /* sweeps what the last one left */
    ck_assert_int_eq(count_entries("."), 2);
    leave_folder();
}

TEST(a_file_beyond_the_size_limit_is_not_written) {
    char *bytes = calloc(100000, 1);
    enter_folder();
    write_file("a", "old");
    signal(SIGXFSZ, SIG_IGN); /* as the command does: the limit is an error then, not a death */
    struct rlimit limit = {50000, 50000};
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    ck_assert_int_eq(wcut_file_write_whole("a", bytes, 100000, &error), WCUT_NOT_WRITTEN);
    ck_assert_str_eq(error.text, "a: not written: File too large");
    file_holds("a", "old");
    ck_assert_int_eq(count_entries("."), 1);
    free(bytes);
    leave_folder();
}

TEST(running_out_of_memory_or_descriptors_is_reported) {
    enter_folder();
    EACH_FAILED_ALLOCATION(wcut_file_write_whole("a", "x", 1, &error), count_entries(".") == 0);
    ck_assert_int_eq(count_entries("."), 1);
    struct rlimit limit = {3, 64};
    ck_assert_int_eq(setrlimit(RLIMIT_NOFILE, &limit), 0);
    not_written("a", "a: not written: Too many open files");
    limit.rlim_cur = 64;
    ck_assert_int_eq(setrlimit(RLIMIT_NOFILE, &limit), 0);
    leave_folder();
}
