/* The orientation that a camera writes into its pictures (Exif 2.3, tag 0x0112). */
#ifndef WCUT_IO_PHOTO_EXIF_H
#define WCUT_IO_PHOTO_EXIF_H

#include <stdbool.h>
#include <stddef.h>
#include <wirecut/overlay.h>

/* 1 .. 8 of a TIFF block of `size` bytes; 1 where it says none */
int wcut_exif_orientation(const unsigned char *tiff, size_t size);

/* orientation, and whether a colour profile is embedded, of a JPEG or PNG file in memory */
int wcut_jpeg_orientation(const unsigned char *data, size_t size, bool *profile);
int wcut_png_orientation(const unsigned char *data, size_t size, bool *profile);

/* turn a picture upright. WCUT_OK; WCUT_NO_MEMORY: it is as it was */
wcut_status wcut_picture_turn(wcut_picture *picture, int orientation);

#endif
