/* Sets of results: all of the new one or all of the old one; what a dead process left is put right; vouchers verified. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <time.h>
#include <wirecut/results.h>

#include "base/alloc.h"
#include "io/file/atomic.h"
#include "io/file/folder.h"
#include "io/file/journal.h"
#include "io/given.h"
#include "test.h"

static wcut_error error;

static void put(wcut_results *set, const char *name, const char *text) {
    ck_assert_int_eq(wcut_file_write_whole(wcut_results_path(set, name), text, strlen(text), &error), WCUT_OK);
    ck_assert_int_eq(wcut_results_add(set, name, &error), WCUT_OK);
}

static wcut_results *begin(const char *folder) {
    static const char *const name[] = {"a", "b", "v.json"};
    wcut_results *set = NULL;
    error = (wcut_error){WCUT_OK, ""};
    ck_assert_msg(wcut_results_create(folder, 3, name, &set, &error) == WCUT_OK, "%s", error.text);
    return set;
}

/* a set {a, b} with contents of its own, under v.json */
static wcut_status commit_pair(const char *folder, const char *a, const char *b) {
    wcut_results *set = begin(folder);
    put(set, "a", a);
    if (b) put(set, "b", b);
    const wcut_status status = wcut_results_commit(set, "v.json", "{\"format\": \"x\"}\n", NULL, &error);
    wcut_results_destroy(set);
    return status;
}

static int broken(const char *folder) {
    wcut_verification *v = NULL;
    ck_assert_msg(wcut_results_verify(folder, &v, &error) == WCUT_OK, "%s", error.text);
    const int count = v->broken;
    wcut_verification_destroy(v);
    return count;
}

TEST(a_set_appears_under_its_voucher_and_nothing_is_left_beside_it) {
    char *whole = NULL;
    enter_folder();
    wcut_results *set = begin("x/y");
    put(set, "a", "abc");
    ck_assert_int_eq(count_entries("x/y"), 1);
    ck_assert_int_eq(wcut_results_commit(set, "v.json", "{\"k\": 1\n}\n", &whole, &error), WCUT_OK);
    wcut_results_destroy(set);
    ck_assert_str_eq(whole,
                     "{\"k\": 1,\n  \"files\": [\"a\", \"v.json\"],\n  \"sha256\": {\n    \"a\": "
                     "\"ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad\"\n  }\n}\n");
    file_holds("x/y/v.json", whole);
    file_holds("x/y/a", "abc");
    free(whole);
    ck_assert_int_eq(count_entries("x/y"), 2);
    ck_assert_int_eq(broken("x/y"), 0);
    ck_assert_int_eq(system("rm -r x"), 0);
    leave_folder();
}

TEST(until_the_commit_the_earlier_set_stays) {
    enter_folder();
    ck_assert_int_eq(commit_pair(".", "1", "2"), WCUT_OK);
    wcut_results *set = begin(".");
    put(set, "a", "3");
    file_holds("a", "1");
    wcut_results_destroy(set);
    file_holds("a", "1");
    ck_assert_int_eq(broken("."), 0);
    ck_assert_int_eq(count_entries("."), 3);
    wcut_results_destroy(NULL);
    leave_folder();
}

TEST(declared_names_that_were_not_written_go_and_others_stay) {
    enter_folder();
    ck_assert_int_eq(commit_pair(".", "1", "2"), WCUT_OK);
    write_file("c", "mine");
    ck_assert_int_eq(commit_pair(".", "3", NULL), WCUT_OK);
    ck_assert_int_eq(access("b", F_OK), -1);
    file_holds("a", "3");
    file_holds("c", "mine");
    leave_folder();
}

/* a set of one file, of a name that it chose itself */
static void commit_named(const char *folder, const char *name) {
    wcut_results *set = NULL;
    ck_assert_int_eq(wcut_results_create(folder, 0, NULL, &set, &error), WCUT_OK);
    put(set, name, name);
    ck_assert_msg(wcut_results_commit(set, "v.json", "{}", NULL, &error) == WCUT_OK, "%s", error.text);
    wcut_results_destroy(set);
}

TEST(what_the_earlier_voucher_lists_goes_with_it_unless_it_was_changed) {
    enter_folder();
    commit_named("names", "one");
    commit_named("names", "two");
    ck_assert(access("names/one", F_OK) != 0 && access("names/two", F_OK) == 0);

    /* a file that somebody changed is nobody's any more */
    ck_assert_int_eq(wcut_file_write_whole("names/two", "mine", 4, &error), WCUT_OK);
    commit_named("names", "three");
    ck_assert(access("names/two", F_OK) == 0 && access("names/three", F_OK) == 0);

    /* a name that leaves the folder, and a voucher that is none */
    static const char bad[] = "{\"files\": [], \"sha256\": {\"../names/three\": \"0\", \"three\": 7}}";
    ck_assert_int_eq(wcut_file_write_whole("names/v.json", bad, strlen(bad), &error), WCUT_OK);
    commit_named("names", "four");
    ck_assert(access("names/three", F_OK) == 0);
    ck_assert_int_eq(wcut_file_write_whole("names/v.json", "[1", 2, &error), WCUT_OK);
    commit_named("names", "five");
    ck_assert(access("names/four", F_OK) == 0 && access("names/five", F_OK) == 0);
    ck_assert_int_eq(system("rm -r names"), 0);
    leave_folder();
}

TEST(permissions_stay_but_set_user_id_goes) {
    struct stat s;
    enter_folder();
    ck_assert_int_eq(commit_pair(".", "1", "2"), WCUT_OK);
    ck_assert_int_eq(chmod("a", 06640), 0);
    ck_assert_int_eq(commit_pair(".", "3", "4"), WCUT_OK);
    ck_assert(stat("a", &s) == 0 && (s.st_mode & 07777) == 0640);
    ck_assert_int_eq(chmod("a", 04755), 0);
    ck_assert_int_eq(wcut_file_write_whole("a", "5", 1, &error), WCUT_OK);
    ck_assert(stat("a", &s) == 0 && (s.st_mode & 07777) == 0755);
    leave_folder();
}

TEST(a_target_that_may_not_be_replaced_is_refused_before_the_work_and_at_the_end) {
    const char *const name[] = {"a", "b"};
    wcut_results *set = NULL;
    enter_folder();
    ck_assert_int_eq(mkdir("b", 0777), 0);
    ck_assert_int_eq(wcut_results_create(".", 2, name, &set, &error), WCUT_NOT_WRITTEN);
    ck_assert_str_eq(error.text, "./b: not written: Is a directory");
    ck_assert_int_eq(rmdir("b"), 0);
    ck_assert_int_eq(symlink("a", "b"), 0);
    ck_assert_int_eq(wcut_results_create(".", 2, name, &set, &error), WCUT_NOT_WRITTEN);
    ck_assert_ptr_nonnull(strstr(error.text, "./b: not written: Too many levels of symbolic links"));
    ck_assert_int_eq(unlink("b"), 0);

    /* it came between the two */
    ck_assert_int_eq(commit_pair(".", "1", "2"), WCUT_OK);
    set = begin(".");
    put(set, "a", "3");
    put(set, "c", "4");
    ck_assert_int_eq(mkfifo("c", 0666), 0);
    ck_assert_int_eq(wcut_results_commit(set, "v.json", "{}", NULL, &error), WCUT_NOT_WRITTEN);
    ck_assert_str_eq(error.text, "./c: not written, no regular file: Invalid argument");
    wcut_results_destroy(set);
    file_holds("a", "1");
    ck_assert_int_eq(broken("."), 0);
    leave_folder();
}

TEST(what_is_no_set_is_refused) {
    static const char *const bad[] = {"", ".hidden", "a/b", "..", "line\nfeed", "\xff"};
    enter_folder();
    wcut_results *set = begin(".");
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        ck_assert_ptr_null(wcut_results_path(set, bad[k]));
        ck_assert_int_eq(wcut_results_add(set, bad[k], &error), WCUT_BAD_ARGUMENT);
    }
    ck_assert_int_eq(wcut_results_add(set, "none", &error), WCUT_NOT_FOUND);
    put(set, "a", "1");
    ck_assert_int_eq(wcut_results_add(set, "a", &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_results_commit(set, "v.txt", "{}", NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_results_commit(set, "a", "{}", NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_results_commit(set, "v.json", "[]", NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_results_commit(NULL, "v.json", "{}", NULL, &error), WCUT_BAD_ARGUMENT);
    wcut_results_destroy(set);
    ck_assert_int_eq(wcut_results_create(NULL, 0, NULL, &set, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_results_create(".", 1, NULL, &set, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_results_create(".", WCUT_RESULTS_MAX + 1, bad, &set, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_results_create("", 0, NULL, &set, &error), WCUT_NOT_WRITTEN);
    ck_assert_int_eq(wcut_results_create("/dev/null/x", 0, NULL, &set, &error), WCUT_NOT_WRITTEN);
    ck_assert_int_eq(count_entries("."), 0);
    leave_folder();
}

TEST(an_error_names_the_folder_not_the_hidden_one) {
    enter_folder();
    wcut_results *set = begin("out");
    snprintf(error.text, sizeof error.text, "%s: not written", wcut_results_path(set, "a.stl"));
    wcut_results_reword(set, &error);
    ck_assert_str_eq(error.text, "out/a.stl: not written");
    wcut_results_reword(NULL, &error);
    wcut_results_reword(set, NULL);
    wcut_results_destroy(set);
    leave_folder();
}

TEST(verify_tells_changed_from_missing) {
    wcut_verification *v = NULL;
    enter_folder();
    ck_assert_int_eq(wcut_results_verify("none", &v, &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_results_verify(".", &v, &error), WCUT_NOT_FOUND);
    ck_assert_str_eq(error.text, ".: found no voucher, expected a JSON file with \"files\" and \"sha256\"");
    ck_assert_int_eq(wcut_results_verify(NULL, &v, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(commit_pair(".", "1", "2"), WCUT_OK);
    write_file("other.json", "{\"files\": 1}");
    write_file("a", "x");
    ck_assert_int_eq(unlink("b"), 0);
    ck_assert_int_eq(wcut_results_verify(".", &v, &error), WCUT_OK);
    ck_assert(v->vouchers == 1 && v->count == 2 && v->broken == 2);
    ck_assert_str_eq(v->file[0].name, "a");
    ck_assert_int_eq(v->file[0].state, WCUT_RESULT_STATE_CHANGED);
    ck_assert_int_eq(v->file[1].state, WCUT_RESULT_STATE_MISSING);
    ck_assert_str_eq(v->file[1].voucher, "v.json");
    wcut_verification_destroy(v);
    wcut_verification_destroy(NULL);

    /* a voucher of somebody who wants to know what is in other folders */
    write_file("v.json", "{\"files\": [], \"sha256\": {\"../x\": \"00\", \"a\": 3}}");
    ck_assert_int_eq(broken("."), 2);
    leave_folder();
}

TEST(what_dead_processes_left_is_swept_whatever_their_number) {
    enter_folder();
    ck_assert_int_eq(mkdir(".wirecut-1-0.part", 0777), 0); /* process 1 lives, and is another one */
    ck_assert_int_eq(mkdir(".wirecut-1-0.part/.old", 0777), 0);
    write_file(".wirecut-1-0.part/a", "1");
    write_file(".wirecut-1-0.part/.old/a", "0");
    write_file(".a.wirecut-1-0.part", "1");
    write_file(".a.wirecut-99999999-0.part", "1");
    write_file(".a.wirecut-1-0.partly", "mine");
    const int held = open(".a.wirecut-1-0.part", O_RDONLY);
    ck_assert(held >= 0 && flock(held, LOCK_EX) == 0);
    ck_assert_int_eq(wcut_file_write_whole("b", "1", 1, &error), WCUT_OK);
    ck_assert_int_eq(count_entries("."), 3); /* b, mine, and the one that is held */
    close(held);
    ck_assert_int_eq(wcut_file_write_whole("b", "1", 1, &error), WCUT_OK);
    ck_assert_int_eq(count_entries("."), 2);
    leave_folder();
}

/* ---- a journal whose process died, in each of its states ---- */

static int folder_of(const char *path) {
    const int fd = open(path, O_RDONLY | O_DIRECTORY);
    ck_assert_int_ge(fd, 0);
    return fd;
}

/* the old set {a 1, b 2}, and a journal of {a 3, c 4} without b */
static void leave_journal(const char *name) {
    enter_folder();
    ck_assert_int_eq(commit_pair(".", "1", "2"), WCUT_OK);
    ck_assert_int_eq(mkdir(name, 0777), 0);
    char path[100], text[100];
    const char *const file[] = {"a", "c", "v.json"}, *const value[] = {"3", "4", "{\"files\": [], \"sha256\": {}}"};
    for (int k = 0; k < 3; k++) {
        snprintf(path, sizeof path, "%s/%s", name, file[k]);
        write_file(path, value[k]);
    }
    snprintf(path, sizeof path, "%s/.manifest", name);
    snprintf(text, sizeof text, "wirecut-journal/1 %d\n- b\n= a\n+ c\n= v.json\n", 99999999);
    write_file(path, text);
    snprintf(path, sizeof path, "%s/.old", name);
    ck_assert_int_eq(mkdir(path, 0777), 0);
    const char *const old[] = {"a", "b", "v.json"};
    for (int k = 0; k < 3; k++) {
        snprintf(path, sizeof path, "%s/.old/%s", name, old[k]);
        ck_assert_int_eq(link(old[k], path), 0);
    }
}

TEST(a_set_that_was_on_its_way_out_is_finished_at_every_step) {
    for (int step = 0; step < 5; step++) {
        leave_journal(".wirecut-commit");
        if (step > 0) unlink("v.json");
        if (step > 1) unlink("b");
        if (step > 2) rename(".wirecut-commit/a", "a");
        if (step > 3) rename(".wirecut-commit/c", "c");
        ck_assert_int_eq(broken("."), 0);
        file_holds("a", "3");
        file_holds("c", "4");
        ck_assert_int_eq(count_entries("."), 3);
        leave_folder();
    }
}

TEST(a_set_that_was_on_its_way_back_goes_back_at_every_step) {
    for (int step = 0; step < 4; step++) {
        leave_journal(".wirecut-undo");
        unlink("v.json");
        unlink("b");
        rename(".wirecut-undo/a", "a");
        rename(".wirecut-undo/c", "c");
        if (step > 0) rename(".wirecut-undo/.old/b", "b");
        if (step > 1) rename(".wirecut-undo/.old/a", "a");
        if (step > 2) unlink("c");
        ck_assert_int_eq(broken("."), 0);
        file_holds("a", "1");
        file_holds("b", "2");
        ck_assert_int_eq(count_entries("."), 3);
        leave_folder();
    }
}

TEST(a_move_that_fails_brings_the_earlier_set_back) {
    leave_journal(".wirecut-commit");
    ck_assert_int_eq(unlink(".wirecut-commit/c"), 0);
    ck_assert_int_eq(mkdir("c", 0777), 0); /* where c should go */
    write_file("c/in", "x");
    write_file(".wirecut-commit/c", "4");
    ck_assert_int_eq(broken("."), 0);
    file_holds("a", "1");
    file_holds("b", "2");
    ck_assert_int_eq(system("rm -r c"), 0);
    ck_assert_int_eq(count_entries("."), 3);
    leave_folder();
}

TEST(a_journal_that_cannot_be_read_is_left_alone_and_said) {
    wcut_results *set = NULL;
    enter_folder();
    ck_assert_int_eq(mkdir(".wirecut-commit", 0777), 0);
    write_file(".wirecut-commit/.manifest", "wirecut-journal/1 7\n= ../../etc/passwd\n");
    ck_assert_int_eq(wcut_results_create(".", 0, NULL, &set, &error), WCUT_NOT_WRITTEN);
    ck_assert_ptr_nonnull(strstr(error.text, "cannot be read"));
    ck_assert_int_eq(count_entries(".wirecut-commit"), 1);

    /* without a manifest it is what is left of one that was finished */
    ck_assert_int_eq(unlink(".wirecut-commit/.manifest"), 0);
    set = begin(".");
    wcut_results_destroy(set);
    ck_assert_int_eq(count_entries("."), 0);
    leave_folder();
}

TEST(a_folder_that_another_process_holds_is_waited_for) {
    enter_folder();
    const int folder = folder_of(".");
    ck_assert_int_eq(wcut_folder_lock(folder, 0), 0);
    const int other = folder_of(".");
    ck_assert_int_eq(wcut_folder_lock(other, 0.05), EWOULDBLOCK);
    const pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) _exit(commit_pair(given_folder, "1", "2") == WCUT_OK ? 0 : 1);
    nanosleep(&(struct timespec){0, 100 * 1000 * 1000}, NULL);
    ck_assert_int_eq(access("v.json", F_OK), -1);
    ck_assert_int_eq(flock(folder, LOCK_UN), 0);
    int status;
    ck_assert(waitpid(child, &status, 0) == child && status == 0);
    ck_assert_int_eq(broken("."), 0);
    close(folder);
    close(other);
    leave_folder();
}

TEST(the_holder_is_named) {
    enter_folder();
    const int folder = folder_of(".");
    wcut_results *set = begin(".");
    ck_assert_int_eq(wcut_journal_owner(folder, NULL), getpid());
    wcut_results_destroy(set);
    ck_assert_int_eq(wcut_journal_owner(folder, NULL), 0);
    close(folder);
    leave_folder();
}

TEST(without_memory_the_earlier_set_stays) {
    const char *const name[] = {"a", "b"};
    enter_folder();
    ck_assert_int_eq(commit_pair(".", "1", "2"), WCUT_OK);
    for (long k = 1, done = 0; !done; k++) {
        wcut_results *set = NULL;
        wcut_verification *v = NULL;
        wcut_alloc_fail_at(k);
        wcut_status status = wcut_results_create(".", 2, name, &set, &error);
        const char *path = status == WCUT_OK ? wcut_results_path(set, "a") : NULL;
        if (path) status = wcut_file_write_whole(path, "3", 1, &error);
        if (path && status == WCUT_OK) status = wcut_results_add(set, "a", &error);
        if (path && status == WCUT_OK) status = wcut_results_commit(set, "v.json", "{\"k\": 1}", NULL, &error);
        wcut_alloc_fail_at(0);
        wcut_results_destroy(set);
        done = path != NULL && status == WCUT_OK;
        file_holds("a", done ? "3" : "1");
        ck_assert_int_eq(broken("."), 0);
        ck_assert_int_eq(count_entries("."), done ? access("b", F_OK) == 0 ? 3 : 2 : 3);
        ck_assert(done || !path || status == WCUT_NO_MEMORY);
        wcut_alloc_fail_at(k);
        status = wcut_results_verify(".", &v, &error);
        wcut_alloc_fail_at(0);
        ck_assert(status == WCUT_OK || status == WCUT_NO_MEMORY);
        if (status == WCUT_OK) wcut_verification_destroy(v);
    }
    leave_folder();
}
