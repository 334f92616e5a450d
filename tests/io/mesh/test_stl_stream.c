/* STL triangle by triangle: the bytes of the whole mesh's writer, whole or not at all. */
#include <wirecut/exchange.h>
#include <wirecut/write.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/given.h"
#include "test.h"

static wcut_stl_stream *stream;
static wcut_error error;

TEST(pieces_give_the_bytes_of_the_whole) {
    wcut_mesh given = given_mesh(200, 90);
    enter_folder();
    ck_assert_int_eq(wcut_mesh_write_stl(&given, "whole.stl", NULL), WCUT_OK);
    ck_assert_int_eq(wcut_stl_stream_create("pieces.stl", &stream, &error), WCUT_OK);
    for (int t = 0, step = 1; t < given.triangle_count; t += step, step = step % 50 + 1) {
        wcut_vec3 corner[150];
        if (step > given.triangle_count - t) step = given.triangle_count - t;
        for (int k = 0; k < 3 * step; k++) corner[k] = given.vertex[given.triangle[3 * t + k]];
        ck_assert_int_eq(wcut_stl_stream_append(stream, step, corner, &error), WCUT_OK);
    }
    ck_assert_int_ne(access("pieces.stl", F_OK), 0);
    ck_assert_int_eq(wcut_stl_stream_commit(stream, &error), WCUT_OK);
    wcut_stl_stream_destroy(stream);
    size_t length[2];
    char *whole = read_back("whole.stl", &length[0]), *pieces = read_back("pieces.stl", &length[1]);
    ck_assert(length[0] == length[1] && memcmp(whole, pieces, length[0]) == 0);
    free(whole);
    free(pieces);
    leave_folder();
    forget_mesh(&given);
}

TEST(misuse_is_refused_and_nothing_is_left) {
    wcut_vec3 corner[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, NAN}};
    enter_folder();
    stream = NULL;
    ck_assert_int_eq(wcut_stl_stream_create(NULL, &stream, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_stl_stream_create("a.stl", NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_stl_stream_create("none/a.stl", &stream, NULL), WCUT_NOT_WRITTEN);
    ck_assert_ptr_null(stream);
    ck_assert_int_eq(wcut_stl_stream_create("a.stl", &stream, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_stl_stream_append(NULL, 1, corner, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_stl_stream_append(stream, -1, corner, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_stl_stream_append(stream, 1, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_stl_stream_append(stream, 1, corner, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_stl_stream_append(stream, 0, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_stl_stream_commit(stream, NULL), WCUT_BAD_ARGUMENT);
    wcut_stl_stream_destroy(stream);
    wcut_stl_stream_destroy(NULL);
    FIRST_FAILED_ALLOCATIONS(2, wcut_stl_stream_create("a.stl", &stream, NULL), true);
    ck_assert_int_eq(count_entries("."), 0);
    leave_folder();
}
