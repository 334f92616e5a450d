/* SHA-256 (FIPS 180-4, sections 4.1.2, 5.3.3 and 6.2), and the hash of a file. */
#include "io/file/sha256.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <wirecut/report.h>

#include "base/fail.h"

/* the first 32 bits of the fractional parts of the cube roots of the first 64 primes */
static const uint32_t round_constant[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

static uint32_t rotate(uint32_t x, int n) { return x >> n | x << (32 - n); }

/* 6.2.2: one block of 64 bytes */
static void compress(uint32_t state[8], const uint8_t *block) {
    uint32_t w[64], s[8];

    /* the message schedule */
    for (int t = 0; t < 16; t++, block += 4)
        w[t] = (uint32_t)block[0] << 24 | (uint32_t)block[1] << 16 | (uint32_t)block[2] << 8 | block[3];
    for (int t = 16; t < 64; t++) {
        uint32_t low = rotate(w[t - 15], 7) ^ rotate(w[t - 15], 18) ^ w[t - 15] >> 3;
        uint32_t high = rotate(w[t - 2], 17) ^ rotate(w[t - 2], 19) ^ w[t - 2] >> 10;
        w[t] = high + w[t - 7] + low + w[t - 16];
    }

    /* 64 rounds */
    memcpy(s, state, sizeof s);
    for (int t = 0; t < 64; t++) {
        uint32_t e = rotate(s[4], 6) ^ rotate(s[4], 11) ^ rotate(s[4], 25);
        uint32_t t1 = s[7] + e + ((s[4] & s[5]) ^ (~s[4] & s[6])) + round_constant[t] + w[t];
        uint32_t a = rotate(s[0], 2) ^ rotate(s[0], 13) ^ rotate(s[0], 22);
        uint32_t t2 = a + ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
        memmove(s + 1, s, 7 * sizeof *s);
        s[4] += t1;
        s[0] = t1 + t2;
    }

    /* the intermediate hash */
    for (int i = 0; i < 8; i++) state[i] += s[i];
}

void wcut_sha256_begin(wcut_sha256 *hash) {
    *hash = (wcut_sha256){
        .state = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19}};
}

void wcut_sha256_add(wcut_sha256 *hash, const void *data, size_t size) {
    const uint8_t *byte = data;
    while (size > 0) {
        size_t used = (size_t)(hash->length % 64), take = 64 - used < size ? 64 - used : size;
        if (take == 64) {
            compress(hash->state, byte);
        } else {
            memcpy(hash->block + used, byte, take);
            if (used + take == 64) compress(hash->state, hash->block);
        }
        hash->length += take;
        byte += take;
        size -= take;
    }
}

void wcut_sha256_end(wcut_sha256 *hash, uint8_t digest[WCUT_SHA256_SIZE]) {
    /* 5.1.1: a one bit, zeros, and the length in bits as the last 64 bits of a block */
    const uint64_t bits = hash->length * 8;
    static const uint8_t padding[64] = {0x80};
    uint8_t tail[8];
    for (int i = 0; i < 8; i++) tail[i] = (uint8_t)(bits >> (56 - 8 * i));
    size_t used = (size_t)(hash->length % 64);
    wcut_sha256_add(hash, padding, used < 56 ? 56 - used : 120 - used);
    wcut_sha256_add(hash, tail, sizeof tail);
    for (int i = 0; i < WCUT_SHA256_SIZE; i++) digest[i] = (uint8_t)(hash->state[i / 4] >> (24 - 8 * (i % 4)));
}

wcut_status wcut_file_hash(const char *path, char *text, wcut_error *error) {
    if (!path || !text) return wcut_fail(error, WCUT_BAD_ARGUMENT, "hash: a path and a place for the text are needed");
    struct stat s;
    char name[WCUT_QUOTE_SIZE];
    /* looked at before it is opened: a pipe would wait for a writer, and give another hash than at the first reading */
    if (stat(path, &s) != 0) return wcut_fail_errno(error, WCUT_NOT_FOUND, errno, path, "cannot be read");
    if (!S_ISREG(s.st_mode))
        return wcut_fail(error, WCUT_NOT_FOUND, "%s: not a regular file", wcut_quote(name, path, WCUT_LABEL_MAX, 1));
    FILE *file = fopen(path, "rb");
    if (!file) return wcut_fail_errno(error, WCUT_NOT_FOUND, errno, path, "cannot be read");

    /* the file in pieces */
    wcut_sha256 hash;
    wcut_sha256_begin(&hash);
    uint8_t buffer[65536], digest[WCUT_SHA256_SIZE];
    size_t count;
    while ((count = fread(buffer, 1, sizeof buffer, file)) > 0) wcut_sha256_add(&hash, buffer, count);
    const int code = ferror(file) ? errno : 0;
    fclose(file);
    if (code) return wcut_fail_errno(error, WCUT_NOT_FOUND, code, path, "cannot be read");

    /* as hexadecimal digits */
    wcut_sha256_end(&hash, digest);
    for (int i = 0; i < WCUT_SHA256_SIZE; i++) snprintf(text + 2 * (size_t)i, 3, "%02x", digest[i]);

    return WCUT_OK;
}

wcut_status wcut_source_hash(const char *path, char *text, wcut_error *error) {
    struct stat s;
    if (!text) return wcut_fail(error, WCUT_BAD_ARGUMENT, "hash: a place for the text is needed");
    if (path && (stat(path, &s) != 0 || S_ISREG(s.st_mode))) return wcut_file_hash(path, text, error);
    text[0] = '\0';
    return WCUT_OK;
}
