/* A folder for the time of a call. */
#ifndef APP_SCRATCH_H
#define APP_SCRATCH_H

#include <limits.h>

/* make an empty folder where temporary files go ($TMPDIR, /tmp); an exit code */
int app_scratch_make(char path[PATH_MAX]);

/* remove it with everything in it */
void app_scratch_remove(const char *path);

#endif
