/* A file that appears whole or not at all: temporary name beside the target, fsync, rename, fsync of the folder. */
#ifndef WCUT_IO_FILE_ATOMIC_H
#define WCUT_IO_FILE_ATOMIC_H

#include <stddef.h>
#include <stdint.h>
#include <wirecut/status.h>

/* an output under its temporary name; the first error of the system sticks to it and commit reports it */
typedef struct wcut_file wcut_file;

/* Begin `.NAME.wirecut-PID-N.part` beside the target; a symbolic link is followed, the temporaries in
   that folder whose lock nobody holds are removed. WCUT_OK; WCUT_NOT_WRITTEN (folder missing or not writable, the target is a folder, a device
   or write-protected), WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_file_create(const char *path, wcut_file **file, wcut_error *error);

/* append, let the next append begin elsewhere, or write at an offset; nothing is written once an error sticks */
void wcut_file_write(wcut_file *file, const void *data, size_t size);
void wcut_file_seek(wcut_file *file, uint64_t offset);
void wcut_file_write_at(wcut_file *file, uint64_t offset, const void *data, size_t size);

/* move a range towards the front (to < from), and cut the file off at a size */
void wcut_file_move(wcut_file *file, uint64_t to, uint64_t from, uint64_t size);
void wcut_file_truncate(wcut_file *file, uint64_t size);

/* WCUT_OK as long as no error sticks; WCUT_NOT_WRITTEN */
wcut_status wcut_file_check(const wcut_file *file, wcut_error *error);

/* Put the file in its place. WCUT_OK: wholly on disk; WCUT_NOT_WRITTEN: the target is as it was, also where the folder's
   fsync failed after the rename. (Where that file system knows one name a file only, there the new file stays, and the
   text says so.) */
wcut_status wcut_file_commit(wcut_file *file, wcut_error *error);

/* free; what was not committed is removed. NULL is allowed. */
void wcut_file_destroy(wcut_file *file);

/* all of it in one call */
wcut_status wcut_file_write_whole(const char *path, const void *data, size_t size, wcut_error *error);

#endif
