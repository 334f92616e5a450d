/* A file or a pipe read through a window of fixed size. */
#ifndef WCUT_IO_SCAN_CLOUD_STREAM_H
#define WCUT_IO_SCAN_CLOUD_STREAM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <wirecut/status.h>

enum { WCUT_STREAM_WINDOW = 1 << 18 };

typedef struct wcut_stream {
    int fd;                      /* -1: `memory` */
    const unsigned char *memory; /* tests' bytes, of `size` */
    unsigned char *data;         /* the window: [at, end) is unread, data[end] is 0 */
    size_t at, end, capacity;    /* the buffer has one byte more than its capacity */
    uint64_t base;               /* the file's offset of data[0] */
    int64_t size;                /* [byte] of the file; -1: a pipe */
    bool ended;                  /* nothing follows data[end] */
    int code;                    /* errno of a read that failed: it ends the stream */
} wcut_stream;

/* WCUT_OK; WCUT_NOT_FOUND, WCUT_BAD_FORMAT of a device (with a message), WCUT_NO_MEMORY (without): nothing to close */
wcut_status wcut_stream_open(const char *path, wcut_stream *stream, wcut_error *error);
wcut_status wcut_stream_open_memory(const void *bytes, size_t size, size_t window, wcut_stream *stream);
void wcut_stream_close(wcut_stream *stream);

/* read until n bytes (at most the capacity) are unread or the stream ends; gives how many are unread */
size_t wcut_stream_fill(wcut_stream *stream, size_t n);

/* leave n bytes out; false where the stream ends before */
bool wcut_stream_skip(wcut_stream *stream, uint64_t n);

/* where the first unread byte is in the file */
static inline uint64_t wcut_stream_offset(const wcut_stream *stream) { return stream->base + stream->at; }

/* unread bytes of a file, UINT64_MAX of a pipe */
static inline uint64_t wcut_stream_left(const wcut_stream *stream) {
    const uint64_t offset = wcut_stream_offset(stream);
    if (stream->size < 0) return UINT64_MAX;
    return (uint64_t)stream->size > offset ? (uint64_t)stream->size - offset : 0;
}

#endif
