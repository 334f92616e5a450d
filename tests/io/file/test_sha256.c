/* SHA-256 against the published examples (FIPS 180-4, NIST CSRC "SHA256.pdf" and long messages), and of files. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/report.h>

#include "io/file/sha256.h"
#include "test.h"

/* hash size bytes in pieces */
static const char *hash_in_pieces(const void *data, size_t size, size_t piece) {
    static char text[WCUT_SHA256_TEXT];
    uint8_t digest[WCUT_SHA256_SIZE];
    wcut_sha256 hash;
    wcut_sha256_begin(&hash);
    for (size_t at = 0; at < size; at += piece)
        wcut_sha256_add(&hash, (const char *)data + at, size - at < piece ? size - at : piece);
    wcut_sha256_end(&hash, digest);
    for (int i = 0; i < WCUT_SHA256_SIZE; i++) snprintf(text + 2 * i, 3, "%02x", digest[i]);
    return text;
}

TEST(the_published_examples_come_out) {
    static const struct {
        const char *message, *digest;
    } example[] = {
        {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
         "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
        {"abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopq"
         "rstu",
         "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1"},
    };
    for (size_t i = 0; i < sizeof example / sizeof *example; i++)
        for (size_t piece = 1; piece < 130; piece += 21)
            ck_assert_str_eq(hash_in_pieces(example[i].message, strlen(example[i].message), piece), example[i].digest);
}

TEST(a_million_letters_come_out_in_pieces_of_any_size) {
    enum { MILLION = 1000000 };
    char *letters = malloc(MILLION);
    ck_assert_ptr_nonnull(letters);
    memset(letters, 'a', MILLION);
    const size_t piece[] = {1, 63, 64, 65, 4096, MILLION};
    for (size_t i = 0; i < sizeof piece / sizeof *piece; i++)
        ck_assert_str_eq(hash_in_pieces(letters, MILLION, piece[i]),
                         "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    free(letters);
}

TEST(a_file_is_hashed_to_its_end) {
    char path[] = "/tmp/wirecut-hash-XXXXXX", text[WCUT_SHA256_TEXT];
    const int file = mkstemp(path);
    ck_assert_int_ge(file, 0);
    ck_assert_int_eq(write(file, "abc", 3), 3);
    close(file);
    ck_assert_int_eq(wcut_file_hash(path, text, NULL), WCUT_OK);
    remove(path);
    ck_assert_str_eq(text, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(a_file_that_cannot_be_read_is_an_error_with_its_name) {
    char text[WCUT_SHA256_TEXT] = "999";
    wcut_error error = {WCUT_OK, ""};
    ck_assert_int_eq(wcut_file_hash("/nowhere/job.json", text, &error), WCUT_NOT_FOUND);
    ck_assert_ptr_nonnull(strstr(error.text, "/nowhere/job.json"));
    ck_assert_int_eq(wcut_file_hash("/tmp", text, &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_file_hash(NULL, text, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_file_hash("/tmp", NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_str_eq(text, "999");
}
