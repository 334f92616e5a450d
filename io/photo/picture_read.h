/* A photograph in memory: what the file reader and the fuzzer share. */
#ifndef WCUT_IO_PHOTO_PICTURE_READ_H
#define WCUT_IO_PHOTO_PICTURE_READ_H

#include <stddef.h>
#include <wirecut/overlay_file.h>

/* wcut_picture_read of `size` bytes; label stands in front of every message */
wcut_status wcut_picture_parse(const void *bytes, size_t size, const char *label, wcut_picture **picture,
                               wcut_picture_source *from, wcut_error *error);

#endif
