/* Points as binary records: scalars of any type and byte order at their places. */
#include "io/file/record.h"

#include <string.h>

size_t wcut_scalar_size(wcut_scalar scalar) {
    static const unsigned char size[] = {0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return size[scalar];
}

static inline double as_float(uint32_t bits) {
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline double as_double(uint64_t bits) {
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* in a byte order known at compile time */
static inline double load_record(const unsigned char *at, wcut_scalar scalar, const bool big_endian) {
    /* integers of 64 bits are rounded to the nearest double */
    switch (scalar) {
        case WCUT_SCALAR_F32:
            return as_float(wcut_load_32(at, big_endian));
        case WCUT_SCALAR_F64:
            return as_double(wcut_load_64(at, big_endian));
        case WCUT_SCALAR_I8:
            /* one byte has no order */
            return (int8_t)at[0];
        case WCUT_SCALAR_U8:
            return at[0];
        case WCUT_SCALAR_I16:
            return (int16_t)wcut_load_16(at, big_endian);
        case WCUT_SCALAR_U16:
            return wcut_load_16(at, big_endian);
        case WCUT_SCALAR_I32:
            return (int32_t)wcut_load_32(at, big_endian);
        case WCUT_SCALAR_U32:
            return wcut_load_32(at, big_endian);
        case WCUT_SCALAR_I64:
            return (double)(int64_t)wcut_load_64(at, big_endian);
        case WCUT_SCALAR_U64:
            return (double)wcut_load_64(at, big_endian);
        default:
            return 0;
    }
}

double wcut_scalar_load(const unsigned char *at, wcut_scalar scalar, bool big_endian) {
    return big_endian ? load_record(at, scalar, true) : load_record(at, scalar, false);
}

bool wcut_record_read(const wcut_record *r, const unsigned char *at, double value[WCUT_FIELDS]) {
    for (int k = 0; k < r->fields; k++) {
        const unsigned char *from = at + r->field[k].offset;
        const double raw =
            r->big_endian ? load_record(from, r->field[k].scalar, true) : load_record(from, r->field[k].scalar, false);
        value[k] = raw * r->field[k].factor + r->field[k].shift;
    }
    return !(r->flag_mask && (at[r->flag_offset] & r->flag_mask));
}
