/* A folder held open: its lock, the targets in it, and the temporaries that dead processes left there. */
#ifndef WCUT_IO_FILE_FOLDER_H
#define WCUT_IO_FILE_FOLDER_H

#include <limits.h>
#include <stdbool.h>

/* Functions that give an int give 0 or an errno. Names are within the folder, descriptors are of open folders. */

/* Whether a name may be replaced: it is free, or a regular file that the caller may write to. mode: of that file, bits
   of 0777 alone, -1 where the name is free. EISDIR, ELOOP (a symbolic link), EINVAL (a device or a pipe), EACCES. */
int wcut_folder_check(int folder, const char *name, int *mode);

/* ".STEM.wirecut-PID-K.part", or ".wirecut-PID-K.part" where the stem is empty */
void wcut_folder_name(char text[NAME_MAX + 1], const char *stem, int k);

/* the process in the name of a temporary; 0 where the name is none */
long wcut_folder_owner(const char *name);

/* Remove the temporaries, files and folders, whose lock nobody holds. The number of a process says nothing: another
   container, or the next life of this one, has the same. Where a file system has no locks, those of dead processes. */
void wcut_folder_sweep(int folder);

/* Lock an open temporary for as long as its descriptor lives. false: a sweeper took it before, try another name. */
bool wcut_folder_hold(int folder, const char *name, int fd);

/* make and hold a temporary folder inside; its descriptor at *fd */
int wcut_folder_make_temporary(int folder, char name[NAME_MAX + 1], int *fd);

/* remove a folder inside with what it holds, to a depth of two; `first`, or NULL, is removed before anything else */
int wcut_folder_remove_tree(int folder, const char *name, const char *first);

/* Lock the folder itself, waiting up to `seconds`. EWOULDBLOCK: another process held it all the time; ENOLCK: the file
   system has no locks. */
int wcut_folder_lock(int folder, double seconds);

/* fsync a folder; file systems that cannot (EINVAL) order the changes themselves */
int wcut_folder_sync(int folder);

#endif
