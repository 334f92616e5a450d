/* Memory: zeroed, counted, refused where the product overflows, and failing where a test asks for it. */
#include <pthread.h>
#include <stdint.h>
#include <string.h>

#include "base/alloc.h"
#include "test.h"

TEST(memory_is_zeroed) {
    unsigned char *bytes = wcut_alloc(1000, 8);
    ck_assert_ptr_nonnull(bytes);
    for (int i = 0; i < 8000; i++) ck_assert_uint_eq(bytes[i], 0);
    wcut_free(bytes);
}

TEST(nothing_asked_for_is_still_a_pointer_to_free) {
    void *none = wcut_alloc(0, 8), *empty = wcut_alloc(8, 0);
    ck_assert_ptr_nonnull(none);
    ck_assert_ptr_nonnull(empty);
    wcut_free(none);
    wcut_free(empty);
    wcut_free(NULL);
}

TEST(a_product_that_overflows_is_refused) {
    ck_assert_ptr_null(wcut_alloc(SIZE_MAX, 2));
    ck_assert_ptr_null(wcut_alloc(2, SIZE_MAX));
    ck_assert_ptr_null(wcut_alloc(SIZE_MAX / 8 + 2, 8)); /* wraps to 8 bytes */
    ck_assert_ptr_null(wcut_copy("", SIZE_MAX / 8 + 2, 8));
}

TEST(a_negative_count_is_refused) {
    volatile int count = -1; /* hidden from the compiler, which would warn */
    ck_assert_ptr_null(wcut_alloc((size_t)count, 8));
    ck_assert_ptr_null(wcut_alloc((size_t)count, 1));
}

TEST(a_copy_equals_its_source_and_is_another) {
    const double from[3] = {1, -2, 3e300};
    double *to = wcut_copy(from, 3, sizeof *from);
    ck_assert_ptr_nonnull(to);
    ck_assert_mem_eq(to, from, sizeof from);
    to[1] = 999;
    ck_assert_double_eq(from[1], -2);
    wcut_free(to);
}

TEST(a_copied_text_ends_with_its_zero) {
    char *text = wcut_copy_text("foam"), *empty = wcut_copy_text("");
    ck_assert_str_eq(text, "foam");
    ck_assert_str_eq(empty, "");
    wcut_free(text);
    wcut_free(empty);
}

TEST(the_asked_allocation_fails_and_only_that) {
    for (int k = 1; k <= 4; k++) {
        wcut_alloc_fail_at(k);
        for (int i = 1; i <= 6; i++) {
            void *memory = wcut_alloc(1, 1);
            ck_assert_msg((memory == NULL) == (i == k), "fail at %d: allocation %d", k, i);
            wcut_free(memory);
        }
    }
}

TEST(a_copy_counts_as_one_allocation) {
    wcut_alloc_fail_at(2);
    char *first = wcut_copy_text("a");
    ck_assert_ptr_nonnull(first);
    ck_assert_ptr_null(wcut_copy_text("b"));
    wcut_free(first);
}

TEST(zero_ends_the_countdown) {
    wcut_alloc_fail_at(1);
    wcut_alloc_fail_at(0);
    void *memory = wcut_alloc(1, 1);
    ck_assert_ptr_nonnull(memory);
    wcut_free(memory);
}

static void *allocate_once(void *unused) {
    (void)unused;
    return wcut_alloc(1, 1);
}

TEST(another_thread_is_not_touched) {
    wcut_alloc_fail_at(1);
    pthread_t thread;
    void *theirs = NULL;
    ck_assert_int_eq(pthread_create(&thread, NULL, allocate_once, NULL), 0);
    ck_assert_int_eq(pthread_join(thread, &theirs), 0);
    ck_assert_ptr_nonnull(theirs);
    ck_assert_ptr_null(wcut_alloc(1, 1));
    wcut_free(theirs);
}
