/* Any bytes as a cloud of one format: refused with one printable line, or points that are finite and counted. */
#ifndef WCUT_TESTS_FUZZ_CLOUD_FUZZ_H
#define WCUT_TESTS_FUZZ_CLOUD_FUZZ_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include <wirecut/cloud_file.h>
#include "io/scan/cloud_source.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static inline void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

static inline void check_line(const wcut_error *error, wcut_status status) {
    check(error->status == status && error->text[0] != '\0' && status == WCUT_BAD_FORMAT);
    for (const char *p = error->text; *p; p++) check((unsigned char)*p >= 0x20 && *p != 0x7f);
}

static inline void check_point(const wcut_cloud_info *info, wcut_vec3 p, wcut_vec3 n) {
    check(fabs(p.x) <= 1e12 && fabs(p.y) <= 1e12 && fabs(p.z) <= 1e12);
    check(p.x >= info->low.x && p.x <= info->high.x && p.y >= info->low.y && p.y <= info->high.y);
    check(p.z >= info->low.z && p.z <= info->high.z);
    const double length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    check(!info->has_normals || length == 0 || fabs(length - 1) < 1e-9);
}

/* through a small window, so that every refill is met */
static inline void fuzz_cloud(const uint8_t *data, size_t size, wcut_cloud_format format) {
    enum { WINDOW = 1024, PIECE = 5 };
    wcut_cloud_options options = wcut_cloud_options_default();
    wcut_cloud_source *source = NULL;
    wcut_error error = {WCUT_OK, ""};
    options.format = format;
    wcut_status status = wcut_cloud_source_create_memory(data, size, WINDOW, "fuzz", &options, &source, &error);
    check((status == WCUT_OK) == (source != NULL));
    if (status != WCUT_OK) check_line(&error, status);
    long total = 0;
    for (int count = 1; status == WCUT_OK && count > 0;) {
        wcut_vec3 point[PIECE], normal[PIECE] = {{0, 0, 0}};
        status = wcut_cloud_source_next(source, PIECE, point, normal, &count, &error);
        if (status != WCUT_OK) {
            check_line(&error, status);
            break;
        }
        check(count >= 0 && count <= PIECE);
        total += count;
        for (int k = 0; k < count; k++) check_point(wcut_cloud_source_info(source), point[k], normal[k]);
    }
    if (source) {
        const wcut_cloud_info *info = wcut_cloud_source_info(source);
        check(info->read == total && info->not_finite >= 0 && info->withheld >= 0);
        check(status != WCUT_OK || info->stated < 0 || info->read + info->not_finite + info->withheld == info->stated);
    }
    wcut_cloud_source_destroy(source);
}

#endif
