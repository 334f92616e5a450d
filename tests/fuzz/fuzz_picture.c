/* Any bytes as a photograph: refused in one printable line, or a picture within the limits. */
#include <stdint.h>
#include <stdlib.h>

#include "io/photo/picture_read.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    wcut_picture *picture = NULL;
    wcut_picture_source source = {0};
    wcut_error error = {WCUT_OK, ""};
    const wcut_status status = wcut_picture_parse(data, size, "picture", &picture, &source, &error);
    check((status == WCUT_OK) == (picture != NULL));
    if (picture) {
        check(picture->width >= 1 && picture->height >= 1);
        check((long long)picture->width * picture->height <= WCUT_PICTURE_PIXELS);
        check(picture->channels == 1 || picture->channels == 3);
        check(source.orientation >= 1 && source.orientation <= 8);

        /* every pixel is there */
        volatile unsigned char last = 0;
        for (size_t k = 0; k < (size_t)picture->width * picture->height * picture->channels; k++)
            last = picture->pixel[k];
        check(last <= 255);
    } else {
        check((status == WCUT_BAD_FORMAT || status == WCUT_NO_MEMORY) && error.text[0] != '\0');
    }
    for (const char *p = error.text; *p; p++) check((unsigned char)*p >= 0x20 && *p != 0x7f);
    wcut_picture_destroy(picture);
    return 0;
}
