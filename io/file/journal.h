/* A set of files put into its folder as one: all of the new set, or all of the old one, whatever happens in between.

   Write-ahead journal (Gray and Reuter, Transaction Processing, 1993, 10) of renames. The states of a folder:

     no journal                the files are those of the last set, under its voucher
     .wirecut-PID-K.part/      a set in the making; of no meaning once its process is dead
     .wirecut-commit/          the new set is whole inside and counts; what is still in it has to be moved out
     .wirecut-undo/            a move failed; what is in its `.old` has to be moved back

   wcut_journal_begin        makes .wirecut-commit of a set in the making: the one moment at which the new set counts
   wcut_journal_finish       moves it out, or back where a move fails, and removes the journal
   wcut_journal_recover      the same for a journal whose process is dead

   Between the first and the last move there is no voucher in the folder: it is removed first and comes last. */
#ifndef WCUT_IO_FILE_JOURNAL_H
#define WCUT_IO_FILE_JOURNAL_H

#include <stdbool.h>
#include <wirecut/results.h>

enum { WCUT_JOURNAL_NAMES_MAX = 2 * WCUT_RESULTS_MAX, WCUT_RESULT_NAME_SIZE = WCUT_RESULTS_NAME_SIZE };

/* a name in a set */
typedef struct wcut_journal_entry {
    char name[WCUT_RESULT_NAME_SIZE];
    bool had;    /* the folder has a file of that name before */
    bool remove; /* that file belongs to the old set alone */
} wcut_journal_entry;

typedef struct wcut_journal {
    int count;
    wcut_journal_entry *entry; /* WCUT_JOURNAL_NAMES_MAX; the voucher is the last */
} wcut_journal;

/* whether a name may stand in a set: UTF-8 without control characters, no folder, not hidden */
bool wcut_result_name_is_fine(const char *name);

/* The functions below give 0 or an errno. `folder` is open and locked, where its file system has locks. */

/* Note the names and keep the old files inside `inside`, the open folder `temporary`; then let it count. On failure
   nothing has changed. */
int wcut_journal_begin(int folder, int inside, const char *temporary, wcut_journal *journal);

/* Move the set out. On failure the old set is back, unless *torn: then the journal stays for the next who comes. */
int wcut_journal_finish(int folder, const wcut_journal *journal, bool *torn);

/* Finish what a dead process began; locked: whether `folder` is. EBUSY: no lock says so, but its process lives.
   EBADMSG: the journal cannot be read. */
int wcut_journal_recover(int folder, bool locked, long *owner);

/* the process that holds a journal or makes a set in the folder, other than `temporary`; 0: none is seen */
long wcut_journal_owner(int folder, const char *temporary);

/* whether there is a journal */
bool wcut_journal_is_there(int folder);

#endif
