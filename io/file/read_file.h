/* A whole file into memory, up to a limit; names of files relative to the one that names them. */
#ifndef WCUT_IO_FILE_READ_FILE_H
#define WCUT_IO_FILE_READ_FILE_H

#include <stddef.h>
#include <wirecut/status.h>

/* text: length bytes and a zero behind them, the caller's to free. WCUT_OK; WCUT_NOT_FOUND (cannot be read),
   WCUT_BAD_FORMAT (more than `max` bytes), WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_file_read(const char *path, size_t max, char **text, size_t *length, wcut_error *error);

/* bytes of a path up to its last slash, that included: its folder; 0: it has none */
size_t wcut_folder_length(const char *path);

/* `length` bytes of a folder, with its slash, and a name, for wcut_free; NULL: no memory */
char *wcut_path_join(const char *folder, size_t length, const char *name);

/* Whether an open file is a file or a pipe; a device has no end. WCUT_OK; WCUT_NOT_FOUND (a folder), WCUT_BAD_FORMAT. */
wcut_status wcut_file_check_kind(int fd, const char *path, wcut_error *error);

#endif
