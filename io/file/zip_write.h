/* A ZIP archive (PKWARE 6.3) written as it comes, its members deflated. */
#ifndef WCUT_IO_FILE_ZIP_WRITE_H
#define WCUT_IO_FILE_ZIP_WRITE_H

#include <stdbool.h>
#include <zlib.h>

#include "io/file/atomic.h"

enum { WCUT_ZIP_MEMBERS = 8, WCUT_ZIP_BUFFER = 1 << 16 };

typedef struct wcut_zip {
    wcut_file *file;
    int count; /* members begun */
    struct {
        const char *name;
        uint64_t offset, packed, plain; /* [byte] */
        uint32_t crc;
    } member[WCUT_ZIP_MEMBERS];
    uint64_t end; /* of what is written so far */
    z_stream stream;
    unsigned char *buffer;
} wcut_zip;

/* false: no memory; to wcut_zip_destroy in any case */
bool wcut_zip_create(wcut_zip *zip, wcut_file *file);

/* a member with an ASCII name (borrowed to the end of the archive), its bytes, and its end */
void wcut_zip_begin(wcut_zip *zip, const char *name);
void wcut_zip_put(wcut_zip *zip, const void *data, size_t size);
void wcut_zip_end(wcut_zip *zip);

/* the directory that ends an archive; false: a member or the archive is longer than 4 GiB, which this form cannot say */
bool wcut_zip_finish(wcut_zip *zip);

void wcut_zip_destroy(wcut_zip *zip);

#endif
