/* A file or a pipe read through a window of fixed size, so that no file is too long. */
#include "io/file/stream.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/read_file.h"

static wcut_status begin_stream(size_t window, wcut_stream *s) {
    s->data = wcut_alloc(window + 1, 1);
    s->capacity = window;
    return s->data ? WCUT_OK : WCUT_NO_MEMORY;
}

wcut_status wcut_stream_open(const char *path, wcut_stream *stream, wcut_error *error) {
    wcut_stream s = {.fd = open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY), .size = -1};
    struct stat about;
    if (s.fd < 0) return wcut_fail_errno(error, WCUT_NOT_FOUND, errno, path, "cannot be read");
    if (fstat(s.fd, &about) == 0 && S_ISREG(about.st_mode)) s.size = about.st_size;
    wcut_status status = wcut_file_check_kind(s.fd, path, error);
    if (status == WCUT_OK) status = begin_stream(WCUT_STREAM_WINDOW, &s);
    if (status == WCUT_OK)
        *stream = s;
    else
        close(s.fd);
    return status;
}

wcut_status wcut_stream_open_memory(const void *bytes, size_t size, size_t window, wcut_stream *stream) {
    wcut_stream s = {.fd = -1, .memory = bytes, .size = (int64_t)size};
    const wcut_status status = begin_stream(window, &s);
    if (status == WCUT_OK) *stream = s;
    return status;
}

void wcut_stream_close(wcut_stream *stream) {
    if (stream->fd >= 0) close(stream->fd); /* nothing was written: a failed close loses nothing */
    free(stream->data);
    *stream = (wcut_stream){.fd = -1};
}

/* read(2) from either kind; 0 at the end, -1 with errno */
static ssize_t read_stream_some(wcut_stream *s, unsigned char *to, size_t max) {
    if (s->fd >= 0) {
        ssize_t n;
        do n = read(s->fd, to, max);
        while (n < 0 && errno == EINTR);
        return n;
    }
    const uint64_t offset = s->base + s->end, left = (uint64_t)s->size - offset;
    const size_t n = left < max ? (size_t)left : max;
    memcpy(to, s->memory + offset, n);
    return (ssize_t)n;
}

size_t wcut_stream_fill(wcut_stream *s, size_t n) {
    if (s->end - s->at >= n || s->ended) return s->end - s->at;
    memmove(s->data, s->data + s->at, s->end - s->at);
    s->base += s->at;
    s->end -= s->at;
    s->at = 0;
    while (s->end < n && !s->ended) {
        const ssize_t got = read_stream_some(s, s->data + s->end, s->capacity - s->end);
        if (got < 0) s->code = errno;
        if (got <= 0) s->ended = true;
        if (got > 0) s->end += (size_t)got;
    }
    s->data[s->end] = 0;
    return s->end - s->at;
}

bool wcut_stream_skip(wcut_stream *s, uint64_t n) {
    if (n > wcut_stream_left(s)) return false;
    while (n > 0) {
        const size_t got = wcut_stream_fill(s, 1);
        const size_t step = n < got ? (size_t)n : got;
        if (got == 0) return false;
        s->at += step;
        n -= step;
    }
    return true;
}
