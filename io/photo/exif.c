/* Exif 2.3: orientation of a picture, found in the segments of a JPEG or the chunks of a PNG file. */
#include "io/photo/exif.h"

#include <string.h>

#include "base/alloc.h"

static unsigned word16(const unsigned char *at, bool big) {
    return big ? (unsigned)at[0] << 8 | at[1] : (unsigned)at[1] << 8 | at[0];
}

static unsigned word32(const unsigned char *at, bool big) {
    return big ? word16(at, true) << 16 | word16(at + 2, true) : word16(at + 2, false) << 16 | word16(at, false);
}

int wcut_exif_orientation(const unsigned char *tiff, size_t size) {
    enum { TAG = 0x0112, SHORT = 3, ENTRY = 12 };
    if (size < 14 || (memcmp(tiff, "II*\0", 4) != 0 && memcmp(tiff, "MM\0*", 4) != 0)) return 1;
    const bool big = tiff[0] == 'M';

    /* entries of the first directory: tag, type, count, value */
    const size_t at = word32(tiff + 4, big);
    if (at > size - 2) return 1;
    const unsigned entries = word16(tiff + at, big);
    for (unsigned k = 0; k < entries && at + 2 + (size_t)(k + 1) * ENTRY <= size; k++) {
        const unsigned char *entry = tiff + at + 2 + (size_t)k * ENTRY;
        if (word16(entry, big) != TAG || word16(entry + 2, big) != SHORT) continue;
        const unsigned value = word16(entry + 8, big);
        return value >= 1 && value <= 8 ? (int)value : 1;
    }
    return 1;
}

int wcut_jpeg_orientation(const unsigned char *data, size_t size, bool *profile) {
    enum { APP1 = 0xe1, APP2 = 0xe2, SCAN = 0xda };
    int orientation = 1;

    /* segments: 0xff, kind, length of two bytes that counts itself */
    for (size_t at = 2; at + 4 <= size && data[at] == 0xff && data[at + 1] != SCAN;) {
        const size_t length = word16(data + at + 2, true);
        const unsigned char *body = data + at + 4;
        if (length < 2 || at + 2 + length > size) break;
        if (data[at + 1] == APP1 && length > 8 && memcmp(body, "Exif\0\0", 6) == 0)
            orientation = wcut_exif_orientation(body + 6, length - 8);
        if (data[at + 1] == APP2 && length > 13 && memcmp(body, "ICC_PROFILE", 12) == 0) *profile = true;
        at += 2 + length;
    }
    return orientation;
}

int wcut_png_orientation(const unsigned char *data, size_t size, bool *profile) {
    int orientation = 1;

    /* chunks: length, kind, body, checksum */
    for (size_t at = 8; at + 12 <= size;) {
        const size_t length = word32(data + at, true);
        if (length > size - at - 12) break;
        if (memcmp(data + at + 4, "eXIf", 4) == 0) orientation = wcut_exif_orientation(data + at + 8, length);
        if (memcmp(data + at + 4, "iCCP", 4) == 0) *profile = true;
        at += 12 + length;
    }
    return orientation;
}

/* where a pixel of the stored picture stands in the upright one */
static void turned(int orientation, int width, int height, int column, int row, int *to_column, int *to_row) {
    const int right = width - 1 - column, below = height - 1 - row;
    const int c[] = {0, column, right, right, column, row, below, below, row};
    const int r[] = {0, row, row, below, below, column, column, right, right};
    *to_column = c[orientation];
    *to_row = r[orientation];
}

wcut_status wcut_picture_turn(wcut_picture *p, int orientation) {
    if (orientation <= 1) return WCUT_OK;
    const bool crosswise = orientation >= 5;
    const size_t n = (size_t)p->channels;
    unsigned char *pixel = wcut_alloc((size_t)p->width * p->height, n);
    if (!pixel) return WCUT_NO_MEMORY;
    const int width = crosswise ? p->height : p->width;
    for (int row = 0; row < p->height; row++)
        for (int column = 0; column < p->width; column++) {
            int c, r;
            turned(orientation, p->width, p->height, column, row, &c, &r);
            memcpy(pixel + ((size_t)r * width + c) * n, p->pixel + ((size_t)row * p->width + column) * n, n);
        }
    wcut_free(p->pixel);
    p->pixel = pixel;
    p->height = crosswise ? p->width : p->height;
    p->width = width;
    return WCUT_OK;
}
