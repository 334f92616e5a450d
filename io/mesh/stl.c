/* Binary STL: a header and facets of 50 bytes; from a mesh, or triangle by triangle. */
#include "io/mesh/stl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/exchange.h>
#include <wirecut/version.h>

#include "base/alloc.h"
#include "base/fail.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "binary files are written as they lie in memory");

enum { HEADER = WCUT_STL_COUNT_AT, FACET = 50 };

void wcut_stl_put_header(wcut_text *text, uint32_t count) {
    /* not "solid", which would begin an ASCII file */
    static const char header[HEADER] = "wirecut " WCUT_VERSION ", binary STL, units: mm";
    wcut_text_put(text, header, HEADER);
    wcut_text_put(text, &count, sizeof count);
}

/* A facet and its unit normal, counter-clockwise; zero for a triangle without area. The normal is that of the rounded
   corners: of a needle the given ones may have quite another, and a checker would call it wrong. */
static inline void put_facet(char *to, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c) {
    const float corner[9] = {(float)a.x, (float)a.y, (float)a.z, (float)b.x, (float)b.y,
                             (float)b.z, (float)c.x, (float)c.y, (float)c.z};
    const double ax = corner[0], ay = corner[1], az = corner[2];
    const double ux = corner[3] - ax, uy = corner[4] - ay, uz = corner[5] - az;
    const double vx = corner[6] - ax, vy = corner[7] - ay, vz = corner[8] - az;
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double size = sqrt(nx * nx + ny * ny + nz * nz), scale = size > 0 ? 1 / size : 0;
    const float normal[3] = {(float)(nx * scale), (float)(ny * scale), (float)(nz * scale)};
    memcpy(to, normal, sizeof normal);
    memcpy(to + sizeof normal, corner, sizeof corner);
    memset(to + sizeof normal + sizeof corner, 0, FACET - sizeof normal - sizeof corner);
}

void wcut_stl_put_facets(wcut_text *text, size_t count, const wcut_vec3 *vertex, const int *triangle) {
    while (count > 0) {
        const size_t n = count < WCUT_TEXT_ROOM / FACET ? count : WCUT_TEXT_ROOM / FACET;
        char *room = wcut_text_room(text);
        for (size_t t = 0; t < n; t++, triangle += 3)
            put_facet(room + FACET * t, vertex[triangle[0]], vertex[triangle[1]], vertex[triangle[2]]);
        text->count += FACET * n;
        count -= n;
    }
}

/* the same of corners that stand one after the other */
static void put_corners(wcut_text *text, size_t count, const wcut_vec3 *corner) {
    while (count > 0) {
        const size_t n = count < WCUT_TEXT_ROOM / FACET ? count : WCUT_TEXT_ROOM / FACET;
        char *room = wcut_text_room(text);
        for (size_t t = 0; t < n; t++, corner += 3) put_facet(room + FACET * t, corner[0], corner[1], corner[2]);
        text->count += FACET * n;
        count -= n;
    }
}

/* ---- triangle by triangle ---- */

struct wcut_stl_stream {
    wcut_file *file;
    wcut_text text;
    uint32_t count;
};

wcut_status wcut_stl_stream_create(const char *path, wcut_stl_stream **stream, wcut_error *error) {
    if (!path || !stream) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_stl_stream *made = wcut_alloc(1, sizeof *made);
    wcut_status status = made ? wcut_file_create(path, &made->file, error) : WCUT_NO_MEMORY;
    if (status == WCUT_OK && !wcut_text_create(&made->text, made->file)) status = WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        wcut_stl_put_header(&made->text, 0);
        *stream = made;
        return WCUT_OK;
    }
    if (status == WCUT_NO_MEMORY) wcut_fail(error, status, "%s", wcut_status_text(status));
    wcut_stl_stream_destroy(made);
    return status;
}

static const double INCREDIBLE = 1e30; /* [mm] far below what a float holds */

/* Corners of whole triangles. A sum that is small has no large term, nor a nan; only where it is not are they looked at
   one by one. */
static bool are_sound(size_t count, const wcut_vec3 *p) {
    double a = 0, b = 0, c = 0;
    for (size_t k = 0; k + 3 <= count; k += 3) { /* three sums, for each waits for its last addition */
        a += fabs(p[k].x) + fabs(p[k].y) + fabs(p[k].z);
        b += fabs(p[k + 1].x) + fabs(p[k + 1].y) + fabs(p[k + 1].z);
        c += fabs(p[k + 2].x) + fabs(p[k + 2].y) + fabs(p[k + 2].z);
    }
    if (a + b + c <= INCREDIBLE) return true;
    for (size_t k = 0; k < count; k++) /* false for nan, too */
        if (!(fabs(p[k].x) <= INCREDIBLE && fabs(p[k].y) <= INCREDIBLE && fabs(p[k].z) <= INCREDIBLE)) return false;
    return true;
}

wcut_status wcut_stl_stream_append(wcut_stl_stream *s, int count, const wcut_vec3 *corner, wcut_error *error) {
    if (!s || count < 0 || (count > 0 && !corner) || (uint32_t)count > UINT32_MAX - s->count)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    if (!are_sound(3 * (size_t)count, corner))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "found nan, inf or more than 1e30, expected finite corners");
    put_corners(&s->text, (size_t)count, corner);
    s->count += (uint32_t)count;
    return wcut_file_check(s->file, error);
}

wcut_status wcut_stl_stream_commit(wcut_stl_stream *s, wcut_error *error) {
    if (!s || s->count == 0) return wcut_fail(error, WCUT_BAD_ARGUMENT, "found no triangle to write");
    wcut_text_flush(&s->text);
    wcut_file_write_at(s->file, WCUT_STL_COUNT_AT, &s->count, sizeof s->count);
    return wcut_file_commit(s->file, error);
}

void wcut_stl_stream_destroy(wcut_stl_stream *s) {
    if (!s) return;
    wcut_text_destroy(&s->text);
    wcut_file_destroy(s->file);
    free(s);
}
