/* Photographs in and out: PNG and JPEG, turned upright, refused by name. */
#include <png.h>
#include <stdlib.h>
#include <turbojpeg.h>
#include <wirecut/overlay_file.h>

#include "io/given.h"
#include "io/photo/picture_read.h"

FIXTURE(enter_folder, leave_folder);

/* a picture whose pixels are all different nearby */
static wcut_picture *pattern(int width, int height, int channels) {
    wcut_picture *p = NULL;
    ck_assert_int_eq(wcut_picture_create(width, height, channels, &p), WCUT_OK);
    for (int k = 0; k < width * height * channels; k++) p->pixel[k] = (unsigned char)(k * 7 + k / width);
    return p;
}

static wcut_picture *read_sound(const char *path, wcut_picture_source *source) {
    wcut_picture *p = NULL;
    wcut_error error = {0};
    ck_assert_msg(wcut_picture_read(path, &p, source, &error) == WCUT_OK, "%s", error.text);
    return p;
}

static void refused(const char *path, const char *word) {
    wcut_picture *p = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_picture_read(path, &p, NULL, &error), WCUT_BAD_FORMAT);
    ck_assert_msg(strstr(error.text, word) != NULL, "\"%s\" without \"%s\"", error.text, word);
    ck_assert_ptr_null(p);
}

static void write_bytes(const char *path, const void *data, size_t size) {
    FILE *file = fopen(path, "wb");
    ck_assert_ptr_nonnull(file);
    ck_assert_uint_eq(fwrite(data, 1, size, file), size);
    fclose(file);
}

TEST(what_is_written_as_png_is_read_back) {
    const int channels[] = {1, 3};
    for (int k = 0; k < 2; k++) {
        wcut_picture *p = pattern(67, 41, channels[k]);
        wcut_picture_source source = {0};
        ck_assert_int_eq(wcut_picture_write(p, 0.25, "p.png", NULL), WCUT_OK);
        wcut_picture *back = read_sound("p.png", &source);
        ck_assert_int_eq(back->width, 67);
        ck_assert_int_eq(back->height, 41);
        ck_assert_int_eq(back->channels, channels[k]);
        ck_assert_int_eq(memcmp(back->pixel, p->pixel, (size_t)67 * 41 * channels[k]), 0);
        ck_assert_int_eq(source.orientation, 1);
        ck_assert_int_eq(source.depth, 8);
        wcut_picture_destroy(back);
        wcut_picture_destroy(p);
    }
}

TEST(a_picture_of_many_chunks_is_whole_for_libpng) {
    /* noise does not deflate: several chunks; opacity */
    wcut_picture *p = NULL;
    ck_assert_int_eq(wcut_picture_create(300, 300, 4, &p), WCUT_OK);
    unsigned seed = 1;
    for (int k = 0; k < 300 * 300 * 4; k++) p->pixel[k] = (unsigned char)((seed = seed * 1664525u + 1013904223u) >> 24);
    ck_assert_int_eq(wcut_picture_write(p, 0, "p.png", NULL), WCUT_OK);
    png_image image = {.version = PNG_IMAGE_VERSION};
    ck_assert_int_ne(png_image_begin_read_from_file(&image, "p.png"), 0);
    ck_assert_uint_eq(image.format, PNG_FORMAT_RGBA);
    unsigned char *back = calloc(300 * 300, 4);
    ck_assert_int_ne(png_image_finish_read(&image, NULL, back, 0, NULL), 0);
    ck_assert_int_eq(memcmp(back, p->pixel, 300 * 300 * 4), 0);
    free(back);
    wcut_picture_destroy(p);
}

/* a JPEG file with an EXIF orientation in front of its other segments */
static size_t jpeg_of(const wcut_picture *p, int orientation, unsigned char **data) {
    unsigned char *plain = NULL;
    unsigned long size = 0;
    tjhandle handle = tjInitCompress();
    ck_assert_int_eq(
        tjCompress2(handle, p->pixel, p->width, 0, p->height, TJPF_GRAY, &plain, &size, TJSAMP_GRAY, 95, 0), 0);
    tjDestroy(handle);
    const unsigned char exif[] = {0xff,
                                  0xe1,
                                  0,
                                  34,
                                  'E',
                                  'x',
                                  'i',
                                  'f',
                                  0,
                                  0,
                                  'I',
                                  'I',
                                  '*',
                                  0,
                                  8,
                                  0,
                                  0,
                                  0,
                                  1,
                                  0,
                                  0x12,
                                  1,
                                  3,
                                  0,
                                  1,
                                  0,
                                  0,
                                  0,
                                  (unsigned char)orientation,
                                  0,
                                  0,
                                  0,
                                  0,
                                  0,
                                  0,
                                  0};
    *data = calloc(size + sizeof exif, 1);
    memcpy(*data, plain, 2);
    memcpy(*data + 2, exif, sizeof exif);
    memcpy(*data + 2 + sizeof exif, plain + 2, size - 2);
    tjFree(plain);
    return size + sizeof exif;
}

TEST(a_jpeg_is_turned_as_its_camera_says) {
    /* dark left upper corner; where it goes for each orientation: column 0 or 1, row 0 or 1 */
    static const int column[] = {0, 0, 1, 1, 0, 0, 1, 1, 0}, row[] = {0, 0, 0, 1, 1, 0, 0, 1, 1};
    for (int orientation = 1; orientation <= 8; orientation++) {
        wcut_picture *p = NULL;
        ck_assert_int_eq(wcut_picture_create(64, 32, 1, &p), WCUT_OK);
        for (int j = 0; j < 32; j++)
            for (int i = 0; i < 64; i++) p->pixel[j * 64 + i] = i < 16 && j < 16 ? 20 : 230;
        unsigned char *data = NULL;
        const size_t size = jpeg_of(p, orientation, &data);
        write_bytes("p.jpg", data, size);
        wcut_picture_source source = {0};
        wcut_picture *back = read_sound("p.jpg", &source);
        ck_assert_int_eq(source.orientation, orientation);
        ck_assert_int_eq(back->width, orientation >= 5 ? 32 : 64);
        for (int k = 0; k < 4; k++) {
            const int u = k % 2 ? back->width - 4 : 4, v = k / 2 ? back->height - 4 : 4;
            const bool dark = back->pixel[v * back->width + u] < 100;
            ck_assert_msg(dark == (k % 2 == column[orientation] && k / 2 == row[orientation]),
                          "orientation %d, corner %d", orientation, k);
        }
        wcut_picture_destroy(back);
        free(data);
        wcut_picture_destroy(p);
    }
}

TEST(sixteen_bits_become_eight) {
    unsigned short wide[8 * 8];
    for (int k = 0; k < 64; k++) wide[k] = (unsigned short)(k * 1000);
    png_image image = {.version = PNG_IMAGE_VERSION, .width = 8, .height = 8, .format = PNG_FORMAT_LINEAR_Y};
    ck_assert_int_ne(png_image_write_to_file(&image, "wide.png", 0, wide, 0, NULL), 0);
    wcut_picture_source source = {0};
    wcut_picture *back = read_sound("wide.png", &source);
    ck_assert_int_eq(source.depth, 16);
    for (int k = 1; k < 64; k++) ck_assert_int_ge(back->pixel[k], back->pixel[k - 1]);
    ck_assert_int_gt(back->pixel[63], 200);
    wcut_picture_destroy(back);
}

TEST(every_truncation_of_a_file_is_refused) {
    wcut_picture *p = pattern(40, 30, 1), *made = NULL;
    unsigned char *jpeg = NULL;
    const size_t size = jpeg_of(p, 1, &jpeg);
    for (size_t n = 0; n + 2 < size; n += 3) {
        wcut_error error = {0};
        ck_assert_msg(wcut_picture_parse(jpeg, n, "p.jpg", &made, NULL, &error) == WCUT_BAD_FORMAT, "JPEG of %zu bytes",
                      n);
        ck_assert_int_ne(error.text[0], 0);
    }
    ck_assert_int_eq(wcut_picture_write(p, 0, "p.png", NULL), WCUT_OK);
    char *png = NULL;
    size_t length = 0;
    ck_assert_int_eq(wcut_file_read("p.png", 1 << 20, &png, &length, NULL), WCUT_OK);

    /* without its last chunk, which has no pixels, a PNG file is whole */
    for (size_t n = 0; n + 16 < length; n++)
        ck_assert_msg(wcut_picture_parse(png, n, "p.png", &made, NULL, NULL) == WCUT_BAD_FORMAT, "PNG of %zu bytes", n);
    ck_assert_ptr_null(made);
    free(png);
    free(jpeg);
    wcut_picture_destroy(p);
}

TEST(a_claim_of_too_many_pixels_takes_no_memory) {
    /* the header of a PNG file with 2^31 - 1 rows; libpng wants its checksum */
    unsigned char head[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R', 0,
                            1,    0,   0,   0,   0,    0xff, 0xff, 8,    0, 0, 0, 0,  0,   0,   0,   0};
    unsigned long sum = 0xffffffff;
    for (int k = 12; k < 29; k++) {
        sum ^= head[k];
        for (int b = 0; b < 8; b++) sum = sum & 1 ? sum >> 1 ^ 0xedb88320 : sum >> 1;
    }
    sum ^= 0xffffffff;
    for (int k = 0; k < 4; k++) head[29 + k] = (unsigned char)(sum >> (24 - 8 * k));
    unsigned char file[sizeof head + 12] = {0};
    memcpy(file, head, sizeof head);
    memcpy(file + sizeof head + 4, "IDAT", 4);
    write_bytes("big.png", file, sizeof file);
    refused("big.png", "megapixels");
}

TEST(other_formats_are_refused_by_name) {
    write_bytes("p.heic",
                "\0\0\0\x18"
                "ftypheic\0\0\0\0",
                16);
    refused("p.heic", "HEIC");
    write_bytes("p.webp", "RIFF\x10\0\0\0WEBPVP8 ", 16);
    refused("p.webp", "WEBP");
    write_bytes("p.tif", "II*\0\x08\0\0\0", 8);
    refused("p.tif", "raw");
    write_bytes("p.gif", "GIF89a", 6);
    refused("p.gif", "GIF");
    write_bytes("p.txt", "hello", 5);
    refused("p.txt", "PNG or JPEG");
    write_bytes("empty", "", 0);
    refused("empty", "PNG or JPEG");
    wcut_picture *p = NULL;
    ck_assert_int_eq(wcut_picture_read("none.png", &p, NULL, NULL), WCUT_NOT_FOUND);
}

TEST(points_of_a_picture_are_read_and_refused_with_their_line) {
    int count = 999;
    wcut_photo_point *point = NULL;
    wcut_error error = {0};
    write_file("p.csv", "u_px,v_px,x_mm,y_mm,z_mm\n1,2,3,4,5\n6,7,8,9,10\n11,12,13,14,15\n16,17.5,18,19,20\n");
    ck_assert_int_eq(wcut_photo_points_read("p.csv", &count, &point, &error), WCUT_OK);
    ck_assert_int_eq(count, 4);
    ck_assert_double_eq(point[3].v, 17.5);
    ck_assert_double_eq(point[3].place.z, 20);
    free(point);
    point = NULL;
    write_file("p.csv", "u_px,v_px,x_mm,y_mm,z_mm\n1,2,3,4,5\n6,7,,9,10\n11,12,13,14,15\n16,17.5,18,19,20\n");
    ck_assert_int_eq(wcut_photo_points_read("p.csv", &count, &point, &error), WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "line 3"));
    ck_assert_ptr_nonnull(strstr(error.text, "x_mm"));
    write_file("p.csv", "u_px,v_px,x_mm,y_mm,z_mm\n1,2,3,4,5\n");
    ck_assert_int_eq(wcut_photo_points_read("p.csv", &count, &point, &error), WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "found 1"));
    ck_assert_ptr_null(point);
}

TEST(a_failed_allocation_reads_nothing) {
    wcut_picture *p = pattern(20, 10, 3), *back = NULL;
    ck_assert_int_eq(wcut_picture_write(p, 0, "p.png", NULL), WCUT_OK);
    EACH_FAILED_ALLOCATION(wcut_picture_read("p.png", &back, NULL, NULL), back == NULL);
    wcut_picture_destroy(back);
    remove("p.png");
    EACH_FAILED_ALLOCATION(wcut_picture_write(p, 0, "q.png", NULL), access("q.png", F_OK) != 0);
    wcut_picture_destroy(p);
    int count;
    wcut_photo_point *point = NULL;
    write_file("p.csv", "u_px,v_px,x_mm,y_mm,z_mm\n1,2,3,4,5\n6,7,8,9,10\n11,12,13,14,15\n16,17.5,18,19,20\n");
    EACH_FAILED_ALLOCATION(wcut_photo_points_read("p.csv", &count, &point, NULL), point == NULL);
    free(point);
}
