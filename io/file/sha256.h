/* SHA-256 (FIPS 180-4). */
#ifndef WCUT_IO_FILE_SHA256_H
#define WCUT_IO_FILE_SHA256_H

#include <stddef.h>
#include <stdint.h>

enum { WCUT_SHA256_SIZE = 32 };

/* a hash that is being computed */
typedef struct wcut_sha256 {
    uint32_t state[8];
    uint64_t length; /* [byte] so far */
    uint8_t block[64];
} wcut_sha256;

void wcut_sha256_begin(wcut_sha256 *hash);
void wcut_sha256_add(wcut_sha256 *hash, const void *data, size_t size);

/* the digest of what was added; the hash is used up */
void wcut_sha256_end(wcut_sha256 *hash, uint8_t digest[WCUT_SHA256_SIZE]);

#endif
