/* Photographs in: PNG by libpng, JPEG by libjpeg-turbo, told by their first bytes. */
#include <png.h>
#include <stdlib.h>
#include <string.h>
#include <turbojpeg.h>
#include <wirecut/overlay_file.h>

#include "base/fail.h"
#include "io/file/read_file.h"
#include "io/photo/exif.h"
#include "io/photo/picture_read.h"

#define BYTES_MAX ((size_t)1 << 30)

/* a file in memory, and where its refusals go */
typedef struct source {
    const char *label;
    const unsigned char *data;
    size_t size;
    wcut_error *error;
} source;

static wcut_status refuse(const source *s, wcut_status status, const char *what) {
    char quote[WCUT_QUOTE_SIZE];
    return wcut_fail(s->error, status, "%s: %s", wcut_quote(quote, s->label, WCUT_LABEL_MAX, 1), what);
}

/* room for a picture; a claim beyond the limit is refused before memory is taken */
static wcut_status picture_room(const source *s, long long width, long long height, int channels,
                                wcut_picture **picture) {
    char quote[WCUT_QUOTE_SIZE];
    if (width < 1 || height < 1 || width > 1000000 || height > 1000000 || width * height > WCUT_PICTURE_PIXELS)
        return wcut_fail(s->error, WCUT_BAD_FORMAT,
                         "%s: found a picture of %lld x %lld px, expected at most %d megapixels",
                         wcut_quote(quote, s->label, WCUT_LABEL_MAX, 1), width, height, WCUT_PICTURE_PIXELS / 1000000);
    const wcut_status status = wcut_picture_create((int)width, (int)height, channels, picture);
    return status == WCUT_OK ? status : refuse(s, status, wcut_status_text(status));
}

/* ---- PNG ---- */

static wcut_status read_png(const source *s, wcut_picture **picture, wcut_picture_source *from) {
    /* signature, then the header's chunk: width, height, depth */
    if (s->size < 33) return refuse(s, WCUT_BAD_FORMAT, "the PNG file ends in its header; expected a whole file");
    from->depth = s->data[24];
    png_image image = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_memory(&image, s->data, s->size)) {
        char what[128];
        snprintf(what, sizeof what, "PNG: %.60s; expected a sound file", image.message);
        return refuse(s, WCUT_BAD_FORMAT, what);
    }
    const int channels = image.format & PNG_FORMAT_FLAG_COLOR ? 3 : 1;
    wcut_picture *made = NULL;
    const wcut_status status = picture_room(s, image.width, image.height, channels, &made);
    if (status != WCUT_OK) {
        png_image_free(&image);
        return status;
    }

    /* whatever the file has becomes 8 bits of grey or colour; transparent places are black */
    const png_color black = {0, 0, 0};
    image.format = channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
    if (!png_image_finish_read(&image, &black, made->pixel, 0, NULL) || image.warning_or_error > 1) {
        char what[128];
        snprintf(what, sizeof what, "PNG: %.60s; expected a whole file", image.message);
        png_image_free(&image);
        wcut_picture_destroy(made);
        return refuse(s, WCUT_BAD_FORMAT, what);
    }
    png_image_free(&image);
    *picture = made;
    return WCUT_OK;
}

/* ---- JPEG ---- */

static wcut_status decode_jpeg(const source *s, tjhandle handle, wcut_picture **picture) {
    int width = 0, height = 0, sampling = 0, space = 0;
    char what[160];
    if (tjDecompressHeader3(handle, s->data, s->size, &width, &height, &sampling, &space) != 0) {
        snprintf(what, sizeof what, "JPEG: %.80s; expected a sound file", tjGetErrorStr2(handle));
        return refuse(s, WCUT_BAD_FORMAT, what);
    }
    if (space == TJCS_CMYK || space == TJCS_YCCK)
        return refuse(s, WCUT_BAD_FORMAT,
                      "found a JPEG file in printing colours (CMYK); expected grey or RGB: export it as RGB");
    const int channels = space == TJCS_GRAY ? 1 : 3;
    wcut_picture *made = NULL;
    const wcut_status status = picture_room(s, width, height, channels, &made);
    if (status != WCUT_OK) return status;

    /* a warning is a file that ends early or is damaged */
    if (tjDecompress2(handle, s->data, s->size, made->pixel, width, 0, height, channels == 1 ? TJPF_GRAY : TJPF_RGB,
                      TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS) != 0) {
        snprintf(what, sizeof what, "JPEG: %.80s; expected a whole file", tjGetErrorStr2(handle));
        wcut_picture_destroy(made);
        return refuse(s, WCUT_BAD_FORMAT, what);
    }
    *picture = made;
    return WCUT_OK;
}

static wcut_status read_jpeg(const source *s, wcut_picture **picture, wcut_picture_source *from) {
    tjhandle handle = tjInitDecompress();
    if (!handle) return refuse(s, WCUT_NO_MEMORY, wcut_status_text(WCUT_NO_MEMORY));
    from->depth = 8;
    const wcut_status status = decode_jpeg(s, handle, picture);
    tjDestroy(handle);
    return status;
}

/* ---- both ---- */

/* the format's name by its first bytes, and what helps; NULL: none that is known */
static const char *foreign_format(const unsigned char *d, size_t n) {
    if (n >= 12 && memcmp(d + 4, "ftyp", 4) == 0)
        return "found HEIC, AVIF or a film; expected PNG or JPEG: export the picture as JPEG";
    if (n >= 12 && memcmp(d, "RIFF", 4) == 0 && memcmp(d + 8, "WEBP", 4) == 0)
        return "found WEBP; expected PNG or JPEG: export the picture as PNG";
    if (n >= 4 && (memcmp(d, "II*\0", 4) == 0 || memcmp(d, "MM\0*", 4) == 0))
        return "found TIFF or a camera's raw format; expected PNG or JPEG: develop or export the picture";
    if (n >= 4 && memcmp(d, "II", 2) == 0)
        return "found a camera's raw format; expected PNG or JPEG: develop the picture";
    if (n >= 4 && memcmp(d, "GIF8", 4) == 0) return "found GIF; expected PNG or JPEG";
    if (n >= 2 && memcmp(d, "BM", 2) == 0) return "found BMP; expected PNG or JPEG";
    return NULL;
}

wcut_status wcut_picture_parse(const void *bytes, size_t size, const char *label, wcut_picture **picture,
                               wcut_picture_source *from, wcut_error *error) {
    const source s = {label, bytes, size, error};
    const unsigned char *d = bytes;
    wcut_picture *made = NULL;
    wcut_picture_source found = {.orientation = 1};
    wcut_status status;
    /* the first bytes tell the format */
    if (size >= 8 && memcmp(d, "\x89PNG\r\n\x1a\n", 8) == 0) {
        found.orientation = wcut_png_orientation(d, size, &found.profile);
        status = read_png(&s, &made, &found);
    } else if (size >= 3 && memcmp(d, "\xff\xd8\xff", 3) == 0) {
        found.orientation = wcut_jpeg_orientation(d, size, &found.profile);
        status = read_jpeg(&s, &made, &found);
    } else {
        const char *what = foreign_format(d, size);
        return refuse(&s, WCUT_BAD_FORMAT, what ? what : "found no picture; expected PNG or JPEG");
    }
    if (status != WCUT_OK) return status;

    /* upright, as EXIF says */
    status = wcut_picture_turn(made, found.orientation);
    if (status != WCUT_OK) {
        wcut_picture_destroy(made);
        return refuse(&s, status, wcut_status_text(status));
    }
    *picture = made;
    if (from) *from = found;
    return WCUT_OK;
}

wcut_status wcut_picture_read(const char *path, wcut_picture **picture, wcut_picture_source *from, wcut_error *error) {
    char *data = NULL;
    size_t size = 0;
    if (!path || !picture)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "picture: %s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_status status = wcut_file_read(path, BYTES_MAX, &data, &size, error);
    if (status != WCUT_OK) return status;
    status = wcut_picture_parse(data, size, path, picture, from, error);
    free(data);
    return status;
}
