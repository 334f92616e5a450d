/* LAS 1.0 to 1.4 (ASPRS LAS Specification 1.4 R15), point formats 0 to 10, as binary records. */
#include <stdlib.h>
#include <string.h>

#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/scan/cloud_source.h"

/* where things stand in the header, and its least size */
enum {
    VERSION_MAJOR = 24,
    VERSION_MINOR = 25,
    HEADER_SIZE = 94,
    POINT_DATA = 96,
    POINT_FORMAT = 104,
    RECORD_LENGTH = 105,
    LEGACY_COUNT = 107,
    SCALE = 131,
    OFFSET = 155,
    COUNT_1_4 = 247,
    MIN_HEADER = 227,
    MIN_HEADER_1_4 = 375,
    FORMATS = 11
};

static bool refuse_record(wcut_cloud_source *s, unsigned format, unsigned length, unsigned min) {
    return wcut_source_refuse(&s->in, "found records of %u bytes, expected at least %u for point format %u", length,
                              min, format);
}

/* the flag of a withheld point: in the classification byte of the old formats, in the flags of the new */
static void set_flag(wcut_record *r, unsigned format) {
    r->flag_offset = 15;
    r->flag_mask = format <= 5 ? 0x80 : 0x04;
}

static bool set_axes(wcut_cloud_source *s, const unsigned char *head, wcut_record *r) {
    for (size_t k = 0; k < 3; k++) {
        const double scale = wcut_scalar_load(head + SCALE + 8 * k, WCUT_SCALAR_F64, false);
        const double offset = wcut_scalar_load(head + OFFSET + 8 * k, WCUT_SCALAR_F64, false);
        if (!isfinite(scale) || scale == 0 || !isfinite(offset))
            return wcut_source_refuse(&s->in,
                                      "found scale %g and offset %g of %c, expected finite ones, the scale not 0",
                                      scale, offset, "xyz"[k]);
        r->field[k].scalar = WCUT_SCALAR_I32;
        r->field[k].offset = 4 * k;
        r->field[k].factor = scale;
        r->field[k].shift = offset;
    }
    r->fields = 3;
    return true;
}

static bool check_version(wcut_cloud_source *s, const unsigned char *head) {
    const unsigned major = head[VERSION_MAJOR], minor = head[VERSION_MINOR];
    if (memcmp(head, "LASF", 4) != 0) return wcut_source_refuse(&s->in, "found no LASF, expected a LAS file");
    if (major != 1 || minor > 4)
        return wcut_source_refuse(&s->in, "found LAS %u.%u, expected 1.0 to 1.4", major, minor);
    const unsigned size = wcut_load_16(head + HEADER_SIZE, false);
    const unsigned min = minor < 4 ? MIN_HEADER : MIN_HEADER_1_4;
    return size >= min || wcut_source_refuse(&s->in, "found a header of %u bytes, expected at least %u", size, min);
}

static bool read_las_header(wcut_cloud_source *s, const unsigned char *head, wcut_record *r, uint64_t *count) {
    static const unsigned char min[FORMATS] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    if (!check_version(s, head)) return false;
    const unsigned format = head[POINT_FORMAT], length = wcut_load_16(head + RECORD_LENGTH, false);
    if (format & 0xc0)
        return wcut_source_refuse(&s->in,
                                  "found compressed points (LAZ), which would need the library LASzip (not in Debian "
                                  "12), expected LAS: unpack it with laszip or las2las");
    if (format >= FORMATS) return wcut_source_refuse(&s->in, "found point format %u, expected 0 to 10", format);
    if (length < min[format]) return refuse_record(s, format, length, min[format]);
    r->size = length;
    set_flag(r, format);

    /* some programs that write 1.4 fill in the old count alone */
    const uint64_t legacy = wcut_load_32(head + LEGACY_COUNT, false);
    *count = head[VERSION_MINOR] < 4 ? legacy : wcut_load_64(head + COUNT_1_4, false);
    if (*count == 0) *count = legacy;
    return set_axes(s, head, r);
}

bool wcut_cloud_begin_las(wcut_cloud_source *s) {
    wcut_record *r = wcut_alloc(1, sizeof *r);
    if (!r) return wcut_source_refuse_memory(&s->in);
    s->state = r;
    s->fill = wcut_cloud_fill_records;
    const size_t unread = wcut_stream_fill(&s->in.stream, MIN_HEADER_1_4);
    const unsigned char *head = s->in.stream.data + s->in.stream.at;
    if (unread < MIN_HEADER || (head[VERSION_MINOR] >= 4 && unread < MIN_HEADER_1_4))
        return wcut_source_refuse_end(&s->in, "the header of a LAS file");
    uint64_t count = 0;
    if (!read_las_header(s, head, r, &count)) return false;
    const uint64_t data = wcut_load_32(head + POINT_DATA, false);
    if (data < wcut_load_16(head + HEADER_SIZE, false))
        return wcut_source_refuse(&s->in, "found the points at byte %llu, expected them after the header",
                                  (unsigned long long)data);
    if (!wcut_stream_skip(&s->in.stream, data))
        return wcut_source_refuse_end(&s->in, "the points that the header places there");
    return wcut_cloud_state(s, count > INT64_MAX ? INT64_MAX : (int64_t)count, r->size, "points");
}
