/* What the tests of the cloud readers start from: bytes that grow, small writers of every format, reading in pieces. */
#ifndef WCUT_TESTS_IO_CLOUD_GIVEN_H
#define WCUT_TESTS_IO_CLOUD_GIVEN_H

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <wirecut/cloud.h>
#include <wirecut/cloud_file.h>

#include "io/scan/cloud_source.h"
#include "test.h"

/* ---- bytes ---- */

enum { BYTES_MAX = 1 << 20 };
static unsigned char bytes[BYTES_MAX];
static size_t size;

static inline void put(const void *data, size_t n) {
    ck_assert(size + n <= BYTES_MAX);
    memcpy(bytes + size, data, n);
    size += n;
}

__attribute__((format(printf, 1, 2))) static inline void put_text(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int n = vsnprintf((char *)bytes + size, BYTES_MAX - size, format, arguments);
    va_end(arguments);
    ck_assert(n >= 0 && size + (size_t)n < BYTES_MAX);
    size += (size_t)n;
}

/* the low n bytes of a number, in either byte order */
static inline void put_bits(uint64_t value, int n, bool big_endian) {
    for (int k = 0; k < n; k++) {
        const unsigned char b = (unsigned char)(value >> 8 * (big_endian ? n - 1 - k : k));
        put(&b, 1);
    }
}

static inline void put_float(double value, bool big_endian) {
    const float f = (float)value;
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    put_bits(bits, 4, big_endian);
}

static inline void put_double(double value, bool big_endian) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_bits(bits, 8, big_endian);
}

/* a number of a PLY type by its name */
static inline void put_scalar(const char *type, double value, bool big_endian) {
    if (strcmp(type, "float") == 0 || strcmp(type, "float32") == 0)
        put_float(value, big_endian);
    else if (strcmp(type, "double") == 0 || strcmp(type, "float64") == 0)
        put_double(value, big_endian);
    else
        put_bits((uint64_t)(int64_t)value,
                 strstr(type, "16") || strstr(type, "short") ? 2
                 : strstr(type, "8") || strstr(type, "char") ? 1
                                                             : 4,
                 big_endian);
}

/* a LAS header of a version, its points to follow */
static inline void put_las_header(int minor, int format, int length, uint64_t count, double scale, double shift) {
    const size_t head = minor < 4 ? 227 : 375, begin = size;
    const uint64_t data = head + 54; /* some variable length records in between */
    unsigned char zero[512] = "";
    put("LASF", 4);
    put(zero, head - 4 + 54);
    unsigned char *h = bytes + begin;
    const size_t end = size;
    h[24] = 1, h[25] = (unsigned char)minor, h[104] = (unsigned char)format;
    size = begin + 94, put_bits(head, 2, false), put_bits(data, 4, false);
    size = begin + 105, put_bits((uint64_t)length, 2, false), put_bits(minor < 4 ? count : 0, 4, false);
    size = begin + 131;
    for (int k = 0; k < 3; k++) put_double(scale, false);
    for (int k = 0; k < 3; k++) put_double(shift * (k + 1), false);
    if (minor >= 4) size = begin + 247, put_bits(count, 8, false);
    size = end;
}

/* ---- reading them ---- */

enum { POINTS_MAX = 4000 };
static wcut_vec3 got[POINTS_MAX], got_normal[POINTS_MAX];
static int got_count;
static wcut_cloud_info got_info;
static wcut_error error;
static wcut_cloud_options options;

/* read the bytes through a window, in pieces; into got, got_normal, got_count, got_info */
static inline wcut_status read_through(size_t window, int piece) {
    wcut_cloud_source *source = NULL;
    memset(&error, 0, sizeof error);
    got_count = 0;
    for (int k = 0; k < POINTS_MAX; k++) got[k] = got_normal[k] = (wcut_vec3){999, 999, 999};
    wcut_status status = wcut_cloud_source_create_memory(bytes, size, window, "scan", &options, &source, &error);
    if (status != WCUT_OK) {
        ck_assert_ptr_null(source);
        ck_assert(error.status == status && error.text[0]);
        return status;
    }
    for (int count = 1; count > 0;) {
        const int room = POINTS_MAX - got_count < piece ? POINTS_MAX - got_count : piece;
        count = -1;
        status = wcut_cloud_source_next(source, room, got + got_count, got_normal + got_count, &count, &error);
        if (status != WCUT_OK) ck_assert_int_eq(count, -1);
        if (status != WCUT_OK) break;
        ck_assert(count >= 0 && count <= room);
        got_count += count;
    }
    if (status != WCUT_OK) { /* a failure stays */
        wcut_error again = {WCUT_OK, ""};
        int count = 999;
        ck_assert_int_eq(wcut_cloud_source_next(source, 1, got, NULL, &count, &again), status);
        ck_assert(count == 999 && strcmp(again.text, error.text) == 0 && again.status == status);
    }
    got_info = *wcut_cloud_source_info(source);
    ck_assert_int_eq(got_info.read, got_count);
    wcut_cloud_source_destroy(source);
    return status;
}

/* the bytes are good, whatever the window and the pieces, and hold so many points */
static inline void reads(int count) {
    const size_t windows[] = {2048, 5000, 1 << 18};
    const int pieces[] = {1, 7, POINTS_MAX};
    for (int k = 0; k < 9; k++) {
        const wcut_status status = read_through(windows[k / 3], pieces[k % 3]);
        ck_assert_msg(status == WCUT_OK, "%s", error.text);
        ck_assert_int_eq(got_count, count);
    }
}

/* the bytes are refused with these words, after so many points */
static inline void refused(int count, const char *words) {
    const int pieces[] = {1, 7, POINTS_MAX};
    for (int k = 0; k < 3; k++) {
        const wcut_status status = read_through(4096, pieces[k]);
        ck_assert_msg(status == WCUT_BAD_FORMAT, "status %d, expected: %s", (int)status, words);
        ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
        ck_assert_int_eq(got_count, count);
    }
}

static inline void begin(void) {
    size = 0;
    options = wcut_cloud_options_default();
}

/* text as a whole file */
static inline void given(const char *text) {
    begin();
    put(text, strlen(text));
}

#endif
