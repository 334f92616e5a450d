/* Points as binary records: scalars of any type and byte order at their places. */
#ifndef WCUT_IO_SCAN_CLOUD_RECORD_H
#define WCUT_IO_SCAN_CLOUD_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "io/file/source.h"

typedef enum wcut_scalar {
    WCUT_SCALAR_NONE,
    WCUT_SCALAR_I8,
    WCUT_SCALAR_U8,
    WCUT_SCALAR_I16,
    WCUT_SCALAR_U16,
    WCUT_SCALAR_I32,
    WCUT_SCALAR_U32,
    WCUT_SCALAR_I64,
    WCUT_SCALAR_U64,
    WCUT_SCALAR_F32,
    WCUT_SCALAR_F64
} wcut_scalar;

/* bytes of a scalar; 0 for none */
size_t wcut_scalar_size(wcut_scalar scalar);

/* unsigned integers in either byte order, spelt out so that compilers make them one load (and a swap) */
static inline uint16_t wcut_load_16(const unsigned char *at, bool big_endian) {
    return (uint16_t)(big_endian ? at[1] | at[0] << 8 : at[0] | at[1] << 8);
}
static inline uint32_t wcut_load_32(const unsigned char *at, bool big_endian) {
    return big_endian ? (uint32_t)at[3] | (uint32_t)at[2] << 8 | (uint32_t)at[1] << 16 | (uint32_t)at[0] << 24
                      : (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}
static inline uint64_t wcut_load_64(const unsigned char *at, bool big_endian) {
    const uint64_t first = wcut_load_32(at, big_endian), second = wcut_load_32(at + 4, big_endian);
    return big_endian ? first << 32 | second : second << 32 | first;
}

/* the number at `at` */
double wcut_scalar_load(const unsigned char *at, wcut_scalar scalar, bool big_endian);

/* where x y z nx ny nz stand in a record: number = scalar * factor + shift */
typedef struct wcut_record {
    size_t size; /* [byte] of the whole record, at least 1 */
    bool big_endian;
    int fields; /* 3 or 6 */
    struct {
        wcut_scalar scalar;
        size_t offset;
        double factor, shift;
    } field[WCUT_FIELDS];
    size_t flag_offset; /* the record is withheld where this byte has a bit of the mask */
    unsigned char flag_mask;
} wcut_record;

/* the fields of the record at `at`, of r->size bytes; false: it is withheld */
bool wcut_record_read(const wcut_record *record, const unsigned char *at, double value[WCUT_FIELDS]);

#endif
