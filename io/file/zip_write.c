/* A ZIP archive (PKWARE 6.3) written as it comes: a member's sizes are put into its header when they are known. */
#include "io/file/zip_write.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"

enum { LOCAL_SIZE = 30, CENTRAL_SIZE = 46, END_SIZE = 22, LEVEL = 6, OWN_WINDOW = -15 };
enum { VERSION = 20, DEFLATED = 8, DATE = 0x21 /* 1 January 1980, the first there is: no date is in the file */ };

static unsigned char *put_16(unsigned char *to, unsigned value) {
    *to++ = (unsigned char)value;
    *to++ = (unsigned char)(value >> 8);
    return to;
}

static unsigned char *put_32(unsigned char *to, uint32_t value) {
    return put_16(put_16(to, value & 0xffff), value >> 16);
}

static unsigned char *put_16s(unsigned char *to, int count, const unsigned *value) {
    for (int k = 0; k < count; k++) to = put_16(to, value[k]);
    return to;
}

bool wcut_zip_create(wcut_zip *z, wcut_file *file) {
    *z = (wcut_zip){.file = file, .buffer = wcut_alloc(WCUT_ZIP_BUFFER, 1)};
    if (!z->buffer) return false;
    if (deflateInit2(&z->stream, LEVEL, Z_DEFLATED, OWN_WINDOW, 8, Z_DEFAULT_STRATEGY) == Z_OK) return true;
    free(z->buffer);
    z->buffer = NULL;
    return false;
}

static void write_on(wcut_zip *z, const void *data, size_t size) {
    wcut_file_write_at(z->file, z->end, data, size);
    z->end += size;
}

/* crc, sizes and the length of the name, as both headers of member k have them */
static unsigned char *put_sizes(unsigned char *to, const wcut_zip *z, int k) {
    to = put_32(to, z->member[k].crc);
    to = put_32(to, (uint32_t)z->member[k].packed);
    to = put_32(to, (uint32_t)z->member[k].plain);
    to = put_16(to, (unsigned)strlen(z->member[k].name));
    return put_16(to, 0);
}

static void write_local(wcut_zip *z, int k) {
    static const unsigned words[] = {VERSION, 0, DEFLATED, 0, DATE};
    unsigned char head[LOCAL_SIZE], *to = put_32(head, 0x04034b50);
    put_sizes(put_16s(to, 5, words), z, k);
    wcut_file_write_at(z->file, z->member[k].offset, head, sizeof head);
}

void wcut_zip_begin(wcut_zip *z, const char *name) {
    const int k = z->count++;
    z->member[k].name = name;
    z->member[k].offset = z->end;
    z->member[k].crc = (uint32_t)crc32(0, NULL, 0);
    write_local(z, k);
    z->end += LOCAL_SIZE;
    write_on(z, name, strlen(name));
    deflateReset(&z->stream);
}

static void deflate_some(wcut_zip *z, int flush) {
    do {
        z->stream.next_out = z->buffer;
        z->stream.avail_out = WCUT_ZIP_BUFFER;
        deflate(&z->stream, flush);
        const size_t got = WCUT_ZIP_BUFFER - z->stream.avail_out;
        write_on(z, z->buffer, got);
        z->member[z->count - 1].packed += got;
    } while (z->stream.avail_out == 0);
}

void wcut_zip_put(wcut_zip *z, const void *data, size_t size) {
    const unsigned char *from = data;
    while (size > 0) {
        const unsigned step = size < (1u << 30) ? (unsigned)size : 1u << 30;
        z->member[z->count - 1].plain += step;
        z->member[z->count - 1].crc = (uint32_t)crc32(z->member[z->count - 1].crc, from, step);
        z->stream.next_in = (unsigned char *)from;
        z->stream.avail_in = step;
        deflate_some(z, Z_NO_FLUSH);
        from += step;
        size -= step;
    }
}

void wcut_zip_end(wcut_zip *z) {
    z->stream.avail_in = 0;
    deflate_some(z, Z_FINISH);
    write_local(z, z->count - 1);
}

static void write_central(wcut_zip *z, int k) {
    static const unsigned words[] = {VERSION, VERSION, 0, DEFLATED, 0, DATE}, none[] = {0, 0, 0};
    unsigned char head[CENTRAL_SIZE], *to = put_32(head, 0x02014b50);
    to = put_sizes(put_16s(to, 6, words), z, k);
    to = put_32(put_16s(to, 3, none), 0);
    put_32(to, (uint32_t)z->member[k].offset);
    write_on(z, head, sizeof head);
    write_on(z, z->member[k].name, strlen(z->member[k].name));
}

bool wcut_zip_finish(wcut_zip *z) {
    const uint64_t directory = z->end;
    bool fits = directory < UINT32_MAX - ((uint64_t)1 << 16);
    for (int k = 0; k < z->count; k++) {
        fits = fits && z->member[k].plain < UINT32_MAX;
        write_central(z, k);
    }
    const unsigned words[] = {0, 0, (unsigned)z->count, (unsigned)z->count};
    unsigned char end[END_SIZE], *to = put_16s(put_32(end, 0x06054b50), 4, words);
    to = put_32(put_32(to, (uint32_t)(z->end - directory)), (uint32_t)directory);
    put_16(to, 0);
    write_on(z, end, sizeof end);
    return fits;
}

void wcut_zip_destroy(wcut_zip *z) {
    if (z->buffer) deflateEnd(&z->stream);
    free(z->buffer);
}
