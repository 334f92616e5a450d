/* PNG out (ISO/IEC 15948): rows, each as the difference to its left neighbours, deflated. */
#include <string.h>
#include <wirecut/overlay_file.h>
#include <zlib.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "io/file/atomic.h"

enum { CHUNK = 1 << 16, LEVEL = 2, SUB = 1 };

static void put_u32(unsigned char *to, unsigned long value) {
    for (int k = 0; k < 4; k++) to[k] = (unsigned char)(value >> (24 - 8 * k));
}

/* length, kind, body, checksum of kind and body */
static void write_chunk(wcut_file *file, const char *kind, const unsigned char *body, size_t size) {
    unsigned char head[8], tail[4];
    put_u32(head, size);
    memcpy(head + 4, kind, 4);
    uLong sum = crc32(0, head + 4, 4);
    if (size > 0) sum = crc32(sum, body, (uInt)size);
    put_u32(tail, sum);
    wcut_file_write(file, head, sizeof head);
    if (size > 0) wcut_file_write(file, body, size);
    wcut_file_write(file, tail, sizeof tail);
}

static void write_head(wcut_file *file, const wcut_picture *p, double resolution) {
    static const unsigned char signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    wcut_file_write(file, signature, sizeof signature);

    /* size, 8 bits a channel, grey, colour or colour with opacity */
    unsigned char head[13] = {0};
    put_u32(head, (unsigned long)p->width);
    put_u32(head + 4, (unsigned long)p->height);
    head[8] = 8;
    head[9] = p->channels == 1 ? 0 : p->channels == 3 ? 2 : 6;
    write_chunk(file, "IHDR", head, sizeof head);

    /* pixels a metre */
    if (resolution > 0) {
        unsigned char scale[9] = {0};
        const double density = clamp(1000 / resolution + 0.5, 1, 2147483647.0);
        put_u32(scale, (unsigned long)density);
        put_u32(scale + 4, (unsigned long)density);
        scale[8] = 1;
        write_chunk(file, "pHYs", scale, sizeof scale);
    }
}

/* what is in front of the deflater, as chunks; flush: Z_NO_FLUSH or Z_FINISH */
static int deflate_into(wcut_file *file, z_stream *z, unsigned char *out, int flush) {
    int code;
    do {
        code = deflate(z, flush);
        if (z->avail_out == 0 || (code == Z_STREAM_END && z->avail_out < CHUNK)) {
            write_chunk(file, "IDAT", out, CHUNK - z->avail_out);
            z->next_out = out;
            z->avail_out = CHUNK;
        }
    } while (code == Z_OK && (z->avail_in > 0 || flush == Z_FINISH));
    return code;
}

/* the rows; false: no memory */
static bool write_rows(wcut_file *file, const wcut_picture *p) {
    /* one row at a time, through deflate */
    const size_t n = (size_t)p->channels, size = (size_t)p->width * n;
    unsigned char *row = wcut_alloc(size + 1, 1), *out = wcut_alloc(CHUNK, 1);
    z_stream z = {.next_out = out, .avail_out = CHUNK};
    bool sound = row && out && deflateInit(&z, LEVEL) == Z_OK;
    for (int r = 0; sound && r < p->height; r++) {
        const unsigned char *from = p->pixel + (size_t)r * size;

        /* the filter SUB: differences to the pixel on the left compress better */
        row[0] = SUB;
        memcpy(row + 1, from, n);
        for (size_t k = n; k < size; k++) row[1 + k] = (unsigned char)(from[k] - from[k - n]);

        /* the last row ends the stream */
        z.next_in = row;
        z.avail_in = (uInt)(size + 1);
        const int code = deflate_into(file, &z, out, r == p->height - 1 ? Z_FINISH : Z_NO_FLUSH);
        sound = code == Z_OK || code == Z_STREAM_END || code == Z_BUF_ERROR;
    }
    if (row && out) deflateEnd(&z);
    wcut_free(row);
    wcut_free(out);
    return sound;
}

wcut_status wcut_picture_write(const wcut_picture *p, double resolution, const char *path, wcut_error *error) {
    if (!p || !p->pixel || !path || !isfinite(resolution) || resolution < 0 || p->width < 1 || p->height < 1 ||
        p->width > 1000000 || p->height > 1000000 || (p->channels != 1 && p->channels != 3 && p->channels != 4))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "picture: expected 1, 3 or 4 channels of 1 to 1000000 px a side");
    wcut_file *file = NULL;
    wcut_status status = wcut_file_create(path, &file, error);
    if (status != WCUT_OK) return status;
    write_head(file, p, resolution);
    if (write_rows(file, p)) {
        write_chunk(file, "IEND", NULL, 0);
        status = wcut_file_commit(file, error);
    } else {
        status = wcut_fail(error, WCUT_NO_MEMORY, "picture: %s", wcut_status_text(WCUT_NO_MEMORY));
    }
    wcut_file_destroy(file);
    return status;
}
