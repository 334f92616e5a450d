/* Status texts, the version, and saying where something failed. */
#include <string.h>
#include <wirecut/status.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "test.h"

TEST(every_status_has_a_text_of_its_own) {
    for (int a = 0; a < WCUT_STATUS_COUNT; a++) {
        ck_assert_uint_gt(strlen(wcut_status_text(a)), 0);
        ck_assert_str_ne(wcut_status_text(a), "unknown status");
        for (int b = 0; b < a; b++) ck_assert_str_ne(wcut_status_text(a), wcut_status_text(b));
    }
    ck_assert_str_eq(wcut_status_text(WCUT_OK), "ok");
}

TEST(outside_the_enum_the_text_says_so) {
    volatile int below = -1, above = WCUT_STATUS_COUNT, far = 1 << 30;
    ck_assert_str_eq(wcut_status_text((wcut_status)below), "unknown status");
    ck_assert_str_eq(wcut_status_text((wcut_status)above), "unknown status");
    ck_assert_str_eq(wcut_status_text((wcut_status)far), "unknown status");
}

TEST(success_is_zero_so_that_a_status_reads_as_a_condition) { ck_assert_int_eq(WCUT_OK, 0); }

TEST(a_failure_gives_its_status_back_and_says_where) {
    wcut_error error = {.status = WCUT_OK, .text = "999"};
    ck_assert_int_eq(wcut_fail(&error, WCUT_BAD_FORMAT, "%s: line %d", "job.json", 7), WCUT_BAD_FORMAT);
    ck_assert_int_eq(error.status, WCUT_BAD_FORMAT);
    ck_assert_str_eq(error.text, "job.json: line 7");
}

TEST(nobody_has_to_listen) { ck_assert_int_eq(wcut_fail(NULL, WCUT_NO_MEMORY, "%d", 1), WCUT_NO_MEMORY); }

TEST(a_long_text_is_cut_inside_its_field) {
    char name[2000];
    memset(name, 'x', sizeof name - 1);
    name[sizeof name - 1] = 0;
    struct {
        wcut_error error;
        unsigned char beyond[16];
    } guarded;
    memset(&guarded, 0x99, sizeof guarded);
    wcut_fail(&guarded.error, WCUT_NOT_FOUND, "%s", name);
    ck_assert_uint_eq(strlen(guarded.error.text), sizeof guarded.error.text - 1);
    for (int i = 0; i < 16; i++) ck_assert_uint_eq(guarded.beyond[i], 0x99);
}

TEST(library_and_header_are_of_one_version) { ck_assert_str_eq(wcut_version_text(), WCUT_VERSION); }
