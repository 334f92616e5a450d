/* The main of every test program: runs the tests that registered themselves, those of the files named or all of them. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */

#include "test.h"

#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

enum { FILES_MAX = 100, NAME_MAX_LENGTH = 80, SKIPPED = 77 };

static test_entry *first_test, *last_test;
static test_fixture *first_fixture;

/* shared with the process of each test */
static int *skipped;

/* the tests of one source file */
typedef struct {
    const char *file;
    char name[NAME_MAX_LENGTH];
    Suite *suite;
    TCase *tcase;
} file_tests;

void test_register(test_entry *entry) {
    if (last_test)
        last_test->next = entry;
    else
        first_test = entry;
    last_test = entry;
}

void test_register_fixture(test_fixture *fixture) {
    fixture->next = first_fixture;
    first_fixture = fixture;
}

void test_skip(const char *file, const char *reason) {
    const char *base = strrchr(file, '/');
    printf("skipped: %s: %s\n", base ? base + 1 : file, reason);
    fflush(stdout);
    ++*skipped;
}

/* .../room/test_what.c -> test_what */
static void name_of(const char *file, char *name) {
    const char *base = strrchr(file, '/');
    snprintf(name, NAME_MAX_LENGTH, "%s", base ? base + 1 : file);
    name[strcspn(name, ".")] = '\0';
}

static void add_fixtures(const file_tests *f) {
    for (const test_fixture *x = first_fixture; x; x = x->next) {
        if (strcmp(x->file, f->file) != 0) continue;
        if (x->once)
            tcase_add_unchecked_fixture(f->tcase, x->before, x->after);
        else
            tcase_add_checked_fixture(f->tcase, x->before, x->after);
    }
}

/* the entry of a file, made at its first test */
static file_tests *find(file_tests *files, int *count, const char *file) {
    for (int k = 0; k < *count; k++)
        if (strcmp(files[k].file, file) == 0) return &files[k];
    if (*count == FILES_MAX) {
        fprintf(stderr, "more than %d test files in one program\n", FILES_MAX);
        exit(2);
    }
    file_tests *f = &files[(*count)++];
    f->file = file;
    name_of(file, f->name);
    f->suite = suite_create(f->name);
    f->tcase = tcase_create(f->name);
    suite_add_tcase(f->suite, f->tcase);
    add_fixtures(f);
    return f;
}

int main(int argc, char **argv) {
    static file_tests files[FILES_MAX];
    int count = 0, chosen = 0;

    /* shared memory: a test runs in a forked process */
    skipped = mmap(NULL, sizeof *skipped, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (skipped == MAP_FAILED) return 2;

    /* choose by file and by a part of the name */
    SRunner *runner = srunner_create(NULL);
    for (const test_entry *t = first_test; t; t = t->next) {
        char name[NAME_MAX_LENGTH];
        name_of(t->test->file, name);
        if (argc > 1 && strcmp(argv[1], name) != 0) continue;
        if (argc > 2 && !strstr(t->test->name, argv[2])) continue;
        const int before = count;
        file_tests *f = find(files, &count, t->test->file);
        if (count > before) srunner_add_suite(runner, f->suite);
        tcase_add_loop_test(f->tcase, t->test, 0, t->cases);
        chosen++;
    }
    if (chosen == 0) {
        fprintf(stderr, "%s: no such test\n", argc > 1 ? argv[1] : argv[0]);
        return 2;
    }

    /* a failure has the last word, then what was skipped */
    srunner_run_all(runner, CK_ENV);
    const int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    if (failed) return EXIT_FAILURE;
    return *skipped ? SKIPPED : EXIT_SUCCESS;
}
