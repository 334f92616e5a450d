/* A set of files put into its folder as one: the journal of moves, its way forward and its way back. */
#include "io/file/journal.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/alloc.h"
#include "io/file/folder.h"
#include "io/file/utf8.h"

#define FORWARD ".wirecut-commit"
#define BACK ".wirecut-undo"
#define MANIFEST ".manifest"
#define OLD ".old"
#define HEAD "wirecut-journal/1"
enum { MANIFEST_MAX = WCUT_JOURNAL_NAMES_MAX * (WCUT_RESULT_NAME_SIZE + 8) + 64, PIECE = 1 << 16 };

bool wcut_result_name_is_fine(const char *name) {
    const size_t length = strlen(name);
    return length > 0 && length < WCUT_RESULT_NAME_SIZE && name[0] != '.' && !strchr(name, '/') &&
           wcut_utf8_is_plain(name);
}

static bool file_is_there(int folder, const char *name) {
    struct stat s;
    return fstatat(folder, name, &s, AT_SYMLINK_NOFOLLOW) == 0;
}

/* the same where "cannot be seen" must not pass for "is not there" */
static int look_for(int folder, const char *name, bool *there) {
    struct stat s;
    *there = fstatat(folder, name, &s, AT_SYMLINK_NOFOLLOW) == 0;
    return *there || errno == ENOENT ? 0 : errno;
}

bool wcut_journal_is_there(int folder) { return file_is_there(folder, FORWARD) || file_is_there(folder, BACK); }

static int open_folder(int folder, const char *name) {
    return openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/* ---- the manifest: a head, and a line a name, "+" new, "=" replaces, "-" goes ---- */

static int write_all(int fd, const char *data, size_t size) {
    while (size > 0) {
        const ssize_t n = write(fd, data, size);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return n < 0 ? errno : ENOSPC;
        data += n;
        size -= (size_t)n;
    }
    return 0;
}

/* close a file that was written, after fsync */
static int close_written(int fd, int code) {
    if (code == 0 && fsync(fd) != 0) code = errno;
    close(fd);
    return code;
}

static int write_manifest(int inside, const wcut_journal *journal) {
    char *text = wcut_alloc(MANIFEST_MAX, 1);
    if (!text) return ENOMEM;
    size_t used = (size_t)snprintf(text, MANIFEST_MAX, HEAD " %ld\n", (long)getpid());
    for (int k = 0; k < journal->count; k++) {
        const wcut_journal_entry *e = &journal->entry[k];
        used += (size_t)snprintf(text + used, MANIFEST_MAX - used, "%c %s\n",
                                 e->remove ? '-'
                                 : e->had  ? '='
                                           : '+',
                                 e->name);
    }
    const int fd = openat(inside, MANIFEST, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    const int code = fd < 0 ? errno : close_written(fd, write_all(fd, text, used));
    wcut_free(text);
    return code;
}

/* a line of the manifest into an entry; gives what is behind it, NULL where it is none */
static char *read_entry(char *at, wcut_journal_entry *e) {
    char *end = strchr(at, '\n');
    if (!end || !strchr("+=-", at[0]) || at[1] != ' ') return NULL;
    *end = '\0';
    if (!wcut_result_name_is_fine(at + 2)) return NULL;
    memcpy(e->name, at + 2, strlen(at + 2) + 1);
    e->had = at[0] != '+';
    e->remove = at[0] == '-';
    return end + 1;
}

static int parse_manifest(char *text, wcut_journal *journal, long *owner) {
    char *at = text;
    if (strncmp(at, HEAD " ", strlen(HEAD) + 1) != 0) return EBADMSG;
    *owner = strtol(at + strlen(HEAD) + 1, &at, 10);
    if (*at++ != '\n' || *owner <= 0) return EBADMSG;
    for (journal->count = 0; *at; journal->count++) {
        if (journal->count == WCUT_JOURNAL_NAMES_MAX) return EBADMSG;
        at = read_entry(at, &journal->entry[journal->count]);
        if (!at) return EBADMSG;
    }
    return journal->count > 0 ? 0 : EBADMSG;
}

/* ENOENT: there is none, the journal was on its way out */
static int read_manifest(int inside, wcut_journal *journal, long *owner) {
    const int fd = openat(inside, MANIFEST, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) return errno;
    char *text = wcut_alloc(MANIFEST_MAX + 1, 1);
    size_t used = 0;
    ssize_t n = 1;
    while (text && used < MANIFEST_MAX && n != 0) {
        n = read(fd, text + used, MANIFEST_MAX - used);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) break;
        used += (size_t)n;
    }
    int code = !text ? ENOMEM : n < 0 ? errno : 0;
    if (code == 0) code = parse_manifest(text, journal, owner);
    wcut_free(text);
    close(fd);
    return code;
}

/* ---- the old files ---- */

static int copy_file(int from_folder, int to_folder, const char *name) {
    char *piece = wcut_alloc(PIECE, 1);
    const int from = openat(from_folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct stat s = {0};
    int code = !piece ? ENOMEM : from < 0 || fstat(from, &s) != 0 ? errno : 0;
    const int to = code ? -1 : openat(to_folder, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, s.st_mode & 0777);
    if (code == 0 && to < 0) code = errno;
    for (ssize_t n = 1; code == 0 && n != 0;) {
        n = read(from, piece, PIECE);
        if (n < 0 && errno == EINTR) continue;
        code = n < 0 ? errno : write_all(to, piece, (size_t)n);
    }
    if (to >= 0) code = close_written(to, code);
    if (from >= 0) close(from);
    wcut_free(piece);
    return code;
}

/* a second name for an old file; a copy where the file system knows one name a file only */
static int keep_file(int folder, int old, const char *name) {
    if (linkat(folder, name, old, name, 0) == 0) return 0;
    return errno == ENOSPC || errno == EDQUOT || errno == ENOENT || errno == EIO ? errno : copy_file(folder, old, name);
}

static int keep_old(int folder, int inside, const wcut_journal *journal) {
    if (mkdirat(inside, OLD, 0777) != 0) return errno;
    const int old = open_folder(inside, OLD);
    if (old < 0) return errno;
    int code = 0;
    for (int k = 0; k < journal->count && code == 0; k++)
        if (journal->entry[k].had) code = keep_file(folder, old, journal->entry[k].name);
    if (code == 0) code = wcut_folder_sync(old);
    close(old);
    return code;
}

int wcut_journal_begin(int folder, int inside, const char *temporary, wcut_journal *journal) {
    int code = 0;
    for (int k = 0; k < journal->count && code == 0; k++)
        code = look_for(folder, journal->entry[k].name, &journal->entry[k].had);

    /* everything that the way back needs is on disk before the set counts */
    if (code == 0) code = keep_old(folder, inside, journal);
    if (code == 0) code = write_manifest(inside, journal);
    if (code == 0) code = wcut_folder_sync(inside);
    if (code) return code;
    if (renameat(folder, temporary, folder, FORWARD) != 0) return errno;
    code = wcut_folder_sync(folder);

    /* what is not certain to last shall not count */
    if (code && renameat(folder, FORWARD, folder, temporary) != 0) return errno;
    return code;
}

/* ---- forward ---- */

/* a name that is not in the journal any more was moved before */
static int move_out(int journal, int folder, const char *name) {
    return renameat(journal, name, folder, name) == 0 || errno == ENOENT ? 0 : errno;
}

static int remove_file(int folder, const char *name) {
    return unlinkat(folder, name, 0) == 0 || errno == ENOENT ? 0 : errno;
}

static int go_forward(int folder, int inside, const wcut_journal *journal) {
    const wcut_journal_entry *voucher = &journal->entry[journal->count - 1];
    bool inside_still;
    int code = look_for(inside, voucher->name, &inside_still);
    if (code || !inside_still) return code; /* it comes last: all of it is out */

    code = remove_file(folder, voucher->name);
    for (int k = 0; k < journal->count - 1 && code == 0; k++) {
        const wcut_journal_entry *e = &journal->entry[k];
        code = e->remove ? remove_file(folder, e->name) : move_out(inside, folder, e->name);
    }
    if (code == 0) code = move_out(inside, folder, voucher->name);
    return code ? code : wcut_folder_sync(folder);
}

/* ---- back ---- */

static int go_back(int folder, int inside, const wcut_journal *journal) {
    const int old = open_folder(inside, OLD);
    int code = old < 0 && errno != ENOENT ? errno : 0;
    for (int k = 0; k < journal->count && code == 0; k++) {
        const wcut_journal_entry *e = &journal->entry[k];
        if (e->had)
            code = old < 0 ? 0 : move_out(old, folder, e->name);
        else {
            bool inside_still;
            code = look_for(inside, e->name, &inside_still);
            if (code == 0 && !inside_still) code = remove_file(folder, e->name);
        }
    }
    if (old >= 0) close(old);
    return code ? code : wcut_folder_sync(folder);
}

/* turn round; without the new name of the journal the way back could not be told from the way forward */
static int turn_back(int folder, int inside, const wcut_journal *journal) {
    if (renameat(folder, FORWARD, folder, BACK) != 0) return errno;
    int code = wcut_folder_sync(folder);
    if (code == 0) code = go_back(folder, inside, journal);
    if (code == 0) wcut_folder_remove_tree(folder, BACK, MANIFEST);
    return code;
}

int wcut_journal_finish(int folder, const wcut_journal *journal, bool *torn) {
    *torn = false;
    const int inside = open_folder(folder, FORWARD);
    if (inside < 0) return *torn = true, errno;
    const int code = go_forward(folder, inside, journal);

    /* the set is out: what cannot be removed of the journal is removed by the next who comes */
    if (code == 0)
        wcut_folder_remove_tree(folder, FORWARD, MANIFEST);
    else
        *torn = turn_back(folder, inside, journal) != 0;
    close(inside);
    return code;
}

/* ---- after a death ---- */

static int recover(int folder, const char *name, bool locked, long *owner) {
    wcut_journal journal = {0, wcut_alloc(WCUT_JOURNAL_NAMES_MAX, sizeof *journal.entry)};
    const int inside = open_folder(folder, name);
    int code = !journal.entry ? ENOMEM : inside < 0 ? errno : read_manifest(inside, &journal, owner);

    /* without a lock only the process itself tells whether it lives */
    if (code == 0 && !locked && (kill((pid_t)*owner, 0) == 0 || errno != ESRCH)) code = EBUSY;
    if (code == 0 && strcmp(name, BACK) == 0) code = go_back(folder, inside, &journal);
    if (code == 0 && strcmp(name, FORWARD) == 0) {
        code = go_forward(folder, inside, &journal);
        if (code) code = turn_back(folder, inside, &journal);
    }

    /* no manifest: it was on its way out */
    if (code == 0 || (code == ENOENT && inside >= 0)) code = wcut_folder_remove_tree(folder, name, MANIFEST);
    if (inside >= 0) close(inside);
    wcut_free(journal.entry);
    return code;
}

int wcut_journal_recover(int folder, bool locked, long *owner) {
    int code = 0;
    if (file_is_there(folder, BACK)) code = recover(folder, BACK, locked, owner);
    if (code == 0 && file_is_there(folder, FORWARD)) code = recover(folder, FORWARD, locked, owner);
    return code;
}

long wcut_journal_owner(int folder, const char *temporary) {
    /* the owner stands in the manifest, whether the set moves forward or back */
    long owner = 0;
    wcut_journal journal = {0, wcut_alloc(WCUT_JOURNAL_NAMES_MAX, sizeof *journal.entry)};
    const char *const name[] = {FORWARD, BACK};
    for (int k = 0; k < 2 && owner == 0 && journal.entry; k++) {
        const int inside = open_folder(folder, name[k]);
        if (inside >= 0 && read_manifest(inside, &journal, &owner) != 0) owner = 0;
        if (inside >= 0) close(inside);
    }
    wcut_free(journal.entry);

    /* a set in the making has its process in its name */
    const int fd = owner ? -1 : openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *list = fd < 0 ? NULL : fdopendir(fd);
    for (struct dirent *entry = list ? readdir(list) : NULL; entry && owner == 0; entry = readdir(list))
        if (!temporary || strcmp(entry->d_name, temporary) != 0) owner = wcut_folder_owner(entry->d_name);

    if (list)
        closedir(list);
    else if (fd >= 0)
        close(fd);

    return owner;
}
