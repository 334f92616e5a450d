/* How a test is written:

       TEST(a_sentence_that_the_body_proves) { ck_assert(...); }

   It registers itself: no list, no main. A file tests/<room>/test_<what>.c is one test of ctest, with that name; the
   files of a room are one program, tests_<room>:

       build/dev/tests/tests_wire [test_equilibrium [PART_OF_A_SENTENCE]]

   Each TEST runs in a process of its own, so statics are fresh. What it cannot test here it says by SKIP. */
#ifndef WCUT_TESTS_TEST_H
#define WCUT_TESTS_TEST_H

#include <check.h>
#include <stdbool.h>
#include <stdlib.h>
#include <wirecut/status.h>

#include "base/alloc.h"

/* one test; `next` is the program's list */
typedef struct test_entry {
    const TTest *test;
    int cases;
    struct test_entry *next;
} test_entry;

/* what runs before and after the tests of one file: each of them, or all of them together */
typedef struct test_fixture {
    const char *file;
    bool once;
    void (*before)(void), (*after)(void);
    struct test_fixture *next;
} test_fixture;

void test_register(test_entry *entry);
void test_register_fixture(test_fixture *fixture);

/* say that this test found nothing to test; the program ends with 77 unless another test fails */
void test_skip(const char *file, const char *reason);

/* the body runs for _i = 0 .. count - 1 */
#define TEST_EACH(name, count)                                                                       \
    static void name##_body(int _i);                                                                 \
    static const TTest name##_test = {#name, name##_body, __FILE__, __LINE__};                       \
    static test_entry name##_entry = {&name##_test, count, NULL};                                    \
    __attribute__((constructor)) static void name##_register(void) { test_register(&name##_entry); } \
    static void name##_body(int _i __attribute__((unused)))

#define TEST(name) TEST_EACH(name, 1)

#define TEST_FIXTURE_OF(kind, once, before, after)                                                           \
    static test_fixture kind##_entry;                                                                        \
    __attribute__((constructor)) static void kind##_register(void) { test_register_fixture(&kind##_entry); } \
    static test_fixture kind##_entry = {__FILE__, once, before, after, NULL}

/* FIXTURE(prepare, forget); around each test of this file. FIXTURE_ONCE(begin, end); around all of them. */
#define FIXTURE(before, after) TEST_FIXTURE_OF(fixture, false, before, after)
#define FIXTURE_ONCE(before, after) TEST_FIXTURE_OF(fixture_once, true, before, after)

/* SKIP("no ../shared here"); leaves the test */
#define SKIP(reason)                   \
    do {                               \
        test_skip(__FILE__, (reason)); \
        return;                        \
    } while (0)

/* `call` gives a wcut_status. It runs with its first allocation failing, then its second, ... until it succeeds, and
   must fail at least once. After each failure the status is WCUT_NO_MEMORY and the condition `after` holds: the outputs
   are as they were. What the successful call made is there afterwards. */
#define EACH_FAILED_ALLOCATION(call, after) EACH_FAILED_ALLOCATION_BY(1, call, after)

/* the same with each `step`-th allocation, for a call that takes long and allocates often */
#define EACH_FAILED_ALLOCATION_BY(step, call, after)                                                                \
    do {                                                                                                            \
        wcut_status status_ = WCUT_NO_MEMORY;                                                                       \
        for (long k_ = 1; status_ != WCUT_OK; k_ += (step)) {                                                       \
            wcut_alloc_fail_at(k_);                                                                                 \
            status_ = (call);                                                                                       \
            wcut_alloc_fail_at(0);                                                                                  \
            ck_assert_msg(status_ == WCUT_NO_MEMORY || (status_ == WCUT_OK && k_ > 1), "allocation %ld failed: %s", \
                          k_, wcut_status_text(status_));                                                           \
            ck_assert_msg(status_ == WCUT_OK || (after), "allocation %ld failed: not %s", k_, #after);              \
        }                                                                                                           \
    } while (0)

/* the first `count` allocations alone, for a call that is never let through to its end */
#define FIRST_FAILED_ALLOCATIONS(count, call, after)                                                              \
    do {                                                                                                          \
        for (long k_ = 1; k_ <= (count); k_++) {                                                                  \
            wcut_alloc_fail_at(k_);                                                                               \
            const wcut_status status_ = (call);                                                                   \
            wcut_alloc_fail_at(0);                                                                                \
            ck_assert_msg(status_ == WCUT_NO_MEMORY, "allocation %ld failed: %s", k_, wcut_status_text(status_)); \
            ck_assert_msg((after), "allocation %ld failed: not %s", k_, #after);                                  \
        }                                                                                                         \
    } while (0)

#endif
