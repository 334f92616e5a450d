/* The vouchers of result folders: what is shared by writing and verifying a set. */
#ifndef WCUT_IO_FILE_RESULTS_H
#define WCUT_IO_FILE_RESULTS_H

#include <wirecut/results.h>
#include <wirecut/status.h>

/* hexadecimal digits of a SHA-256, with the zero byte */
enum { WCUT_RESULT_HASH_SIZE = 65, WCUT_RESULTS_WAIT_S = 30 };

/* the state of a file of a folder by its hash; a file that cannot be read is an error, not a changed one */
wcut_status wcut_result_state_find(const char *folder, const char *name, const char *hash, wcut_result_state *state,
                                   wcut_error *error);

/* "FOLDER/NAME", or NULL where there is no memory; for wcut_free */
char *wcut_results_join(const char *folder, const char *name);

/* Lock an open folder and finish what a dead process left in it; *locked: whether there is a lock to let go of. */
wcut_status wcut_results_enter(const char *label, int folder, const char *temporary, int *locked, wcut_error *error);
void wcut_results_leave(int folder, int locked);

#endif
