/* A run's files, put into their folder together or not at all: written in a hidden folder, moved out by a journal. */
#include <errno.h>
#include <fcntl.h>
#include <jansson.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <wirecut/report.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/folder.h"
#include "io/file/journal.h"
#include "io/file/read_file.h"
#include "io/file/results.h"
#include "io/file/text.h"

enum { VOUCHER_MAX = 256 << 20 }; /* bytes: a verb's whole result may stand in it */

typedef char result_name[WCUT_RESULTS_NAME_SIZE];

struct wcut_results {
    char *folder;                 /* as the caller gave it */
    int fd, inside;               /* descriptors: of the folder, and of the hidden one, whose lock says we live */
    char temporary[NAME_MAX + 1]; /* the hidden one within the folder */
    char *hidden;                 /* its path */
    char *path;                   /* the last that was asked for */
    int count, declared;
    result_name *name, *may; /* WCUT_RESULTS_MAX, declared: those taken in, those that the set may have */
};

/* ---- errors ---- */

static wcut_status fail_results_memory(wcut_error *error) {
    return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
}

static wcut_status fail_code(wcut_error *error, int code, const char *path, const char *what) {
    return wcut_fail_errno(error, code == ENOMEM ? WCUT_NO_MEMORY : WCUT_NOT_WRITTEN, code, path, what);
}

char *wcut_results_join(const char *folder, const char *name) {
    const size_t length = strlen(folder), size = length + strlen(name) + 2;
    char *path = wcut_alloc(size, 1);
    if (path) snprintf(path, size, "%s%s%s", folder, length && folder[length - 1] == '/' ? "" : "/", name);
    return path;
}

static wcut_status fail_name(wcut_error *error, const wcut_results *r, const char *name, int code, const char *what) {
    char *path = wcut_results_join(r->folder, name);
    const wcut_status status = path ? fail_code(error, code, path, what) : fail_results_memory(error);
    wcut_free(path);
    return status;
}

/* ---- the folder ---- */

static wcut_status refuse_folder(wcut_error *error, const char *path, const char *cause) {
    char shown[WCUT_QUOTE_SIZE];
    return wcut_fail(error, WCUT_NOT_WRITTEN, "%s: %s, expected a folder to write results to",
                     wcut_quote(shown, path, WCUT_LABEL_MAX, 1), cause);
}

/* one folder of the way; it may be there already */
static wcut_status make_folder(const char *path, wcut_error *error) {
    struct stat s;
    if (mkdir(path, 0777) == 0) return WCUT_OK;
    const int code = errno;
    if (stat(path, &s) != 0) return refuse_folder(error, path, strerror(code));
    return S_ISDIR(s.st_mode) ? WCUT_OK : refuse_folder(error, path, "found a file");
}

static wcut_status make_folders(wcut_results *r, wcut_error *error) {
    const size_t length = strlen(r->folder);
    if (length == 0) return refuse_folder(error, r->folder, strerror(ENOENT));
    if (length >= PATH_MAX) return refuse_folder(error, r->folder, strerror(ENAMETOOLONG));
    char part[PATH_MAX];
    for (size_t i = 1; i <= length; i++) {
        if (r->folder[i] && r->folder[i] != '/') continue;
        memcpy(part, r->folder, i);
        part[i] = '\0';
        const wcut_status status = make_folder(part, error);
        if (status != WCUT_OK) return status;
    }
    r->fd = open(r->folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (r->fd < 0 || faccessat(r->fd, ".", W_OK | X_OK, AT_EACCESS) != 0)
        return refuse_folder(error, r->folder, strerror(errno));
    return WCUT_OK;
}

wcut_status wcut_results_enter(const char *label, int folder, const char *temporary, int *locked, wcut_error *error) {
    char shown[WCUT_QUOTE_SIZE];
    long owner = 0;

    /* take the folder's lock and undo or complete what an interrupted run left there */
    wcut_quote(shown, label, WCUT_LABEL_MAX, 1);
    int code = wcut_folder_lock(folder, WCUT_RESULTS_WAIT_S);
    *locked = code == 0;
    if (code == 0 || code == ENOLCK) code = wcut_journal_recover(folder, *locked, &owner);
    if (code == 0) return WCUT_OK;

    /* what was not possible, with the process that stands in the way where it is known */
    wcut_results_leave(folder, *locked);
    *locked = 0;

    /* no memory, a broken journal, other causes */
    if (code == ENOMEM) return fail_results_memory(error);
    if (code == EBADMSG)
        return wcut_fail(
            error, WCUT_NOT_WRITTEN,
            "%s: found a .wirecut-commit or .wirecut-undo that cannot be read, expected none, or that of an "
            "interrupted run",
            shown);
    if (code != EWOULDBLOCK && code != EBUSY)
        return fail_code(error, code, label, "the results of an interrupted run cannot be put in their place");

    /* the process that holds the folder */
    owner = wcut_journal_owner(folder, temporary);
    if (owner > 0)
        return wcut_fail(error, WCUT_NOT_WRITTEN,
                         "%s: process %ld is putting its results there, expected it to end within %d s", shown, owner,
                         WCUT_RESULTS_WAIT_S);
    return wcut_fail(error, WCUT_NOT_WRITTEN,
                     "%s: another process holds the folder's lock, expected it to let go within %d s", shown,
                     WCUT_RESULTS_WAIT_S);
}

void wcut_results_leave(int folder, int locked) {
    if (locked) flock(folder, LOCK_UN);
}

/* whether a name may be written */
static wcut_status check_name(wcut_results *r, const char *name, int *mode, wcut_error *error) {
    if (!wcut_result_name_is_fine(name)) {
        char shown[WCUT_QUOTE_SIZE];
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "%s: found a result's name \"%s\", expected 1 to %d bytes of UTF-8 without control characters "
                         "and slashes, no dot in front",
                         r->folder, wcut_quote(shown, name, WCUT_FOUND_MAX, 0), WCUT_RESULTS_NAME_SIZE - 1);
    }
    const int code = wcut_folder_check(r->fd, name, mode);
    if (code == 0) return WCUT_OK;
    return fail_name(error, r, name, code, code == EINVAL ? "not written, no regular file" : "not written");
}

/* ---- begin ---- */

static wcut_status results_begin(wcut_results *r, int count, const char *const *name, wcut_error *error) {
    int mode, locked;
    wcut_status status = make_folders(r, error);

    /* put right what dead processes left */
    if (status == WCUT_OK && wcut_journal_is_there(r->fd)) {
        status = wcut_results_enter(r->folder, r->fd, NULL, &locked, error);
        if (status == WCUT_OK) wcut_results_leave(r->fd, locked);
    }
    if (status == WCUT_OK) wcut_folder_sweep(r->fd);
    for (int k = 0; k < count && status == WCUT_OK; k++) status = check_name(r, name[k], &mode, error);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < count; k++) memcpy(r->may[r->declared++], name[k], strlen(name[k]) + 1);

    /* the hidden folder, in which the files are made */
    const int code = wcut_folder_make_temporary(r->fd, r->temporary, &r->inside);
    if (code) {
        r->temporary[0] = '\0';
        return refuse_folder(error, r->folder, strerror(code));
    }
    r->hidden = wcut_results_join(r->folder, r->temporary);

    return r->hidden ? WCUT_OK : fail_results_memory(error);
}

wcut_status wcut_results_create(const char *folder, int count, const char *const *name, wcut_results **results,
                                wcut_error *error) {
    /* names are declared before any of them is written */
    if (!folder || !results || count < 0 || count > WCUT_RESULTS_MAX || (count > 0 && !name))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    for (int k = 0; k < count; k++)
        if (!name[k]) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a result's name is NULL");
    wcut_results *r = wcut_alloc(1, sizeof *r);
    if (!r) return fail_results_memory(error);

    /* nothing is held yet, so that destroy is safe from here on */
    r->fd = r->inside = -1;
    r->folder = wcut_copy_text(folder);
    r->name = wcut_alloc(WCUT_RESULTS_MAX, sizeof *r->name);
    r->may = wcut_alloc((size_t)count, sizeof *r->may);

    /* the folder is looked at only once there is memory for all */
    const wcut_status status =
        r->folder && r->name && r->may ? results_begin(r, count, name, error) : fail_results_memory(error);
    if (status == WCUT_OK)
        *results = r;
    else
        wcut_results_destroy(r);

    return status;
}

void wcut_results_destroy(wcut_results *results) {
    wcut_results *r = results;
    if (!r) return;
    if (r->temporary[0]) wcut_folder_remove_tree(r->fd, r->temporary, NULL);
    if (r->inside >= 0) close(r->inside);
    if (r->fd >= 0) close(r->fd);
    wcut_free(r->folder);
    wcut_free(r->hidden);
    wcut_free(r->path);
    wcut_free(r->name);
    wcut_free(r->may);
    wcut_free(r);
}

/* ---- the files ---- */

const char *wcut_results_path(wcut_results *results, const char *name) {
    if (!results || !name || !wcut_result_name_is_fine(name)) return NULL;
    wcut_free(results->path);
    results->path = wcut_results_join(results->hidden, name);
    return results->path;
}

wcut_status wcut_results_add(wcut_results *results, const char *name, wcut_error *error) {
    struct stat s;
    if (!results || !name || !wcut_result_name_is_fine(name) || results->count == WCUT_RESULTS_MAX - 1)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    for (int k = 0; k < results->count; k++)
        if (strcmp(results->name[k], name) == 0)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found a second time in the set of results, expected once",
                             name);
    if (fstatat(results->inside, name, &s, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(s.st_mode))
        return wcut_fail(error, WCUT_NOT_FOUND, "%s: found no file in the set of results, expected it written", name);
    memcpy(results->name[results->count++], name, strlen(name) + 1);
    return WCUT_OK;
}

void wcut_results_reword(const wcut_results *results, wcut_error *error) {
    if (!results || !results->hidden || !results->temporary[0] || !error) return;

    /* the hidden name may stand alone, where a long path was cut off in front */
    for (char *at; (at = strstr(error->text, results->temporary)) != NULL;) {
        const size_t size = strlen(results->temporary);
        const size_t gone = size + (at[size] == '/');
        memmove(at, at + gone, strlen(at + gone) + 1);
    }
}

/* ---- the voucher ---- */

/* the caller's object with the names and hashes of the set added, for free() */
static wcut_status print_voucher(wcut_results *r, const char *voucher, const char *text, char **whole,
                                 wcut_error *error) {
    /* the text has to be an object: find its closing brace */
    size_t length = strlen(text);
    while (length > 0 && strchr(" \t\r\n", text[length - 1])) length--;
    if (length < 2 || text[0] != '{' || text[length - 1] != '}')
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: expected the text of an object", voucher);

    /* is it empty? then no comma follows what it holds */
    for (length--; length > 1 && strchr(" \t\r\n", text[length - 1]);) length--;
    const char *comma = length > 1 ? ",\n  " : "\n  ";

    /* the names of all results, with the voucher itself */
    wcut_text out;
    if (!wcut_text_create(&out, NULL)) return fail_results_memory(error);
    wcut_text_put(&out, text, length);
    wcut_text_print(&out, "%s\"files\": [", comma);
    for (int k = 0; k < r->count; k++) {
        wcut_text_string(&out, r->name[k]);
        wcut_text_print(&out, ", ");
    }
    wcut_text_string(&out, voucher);

    /* the hash of each */
    wcut_text_print(&out, "],\n  \"sha256\": {");
    for (int k = 0; k < r->count; k++) {
        char hash[WCUT_RESULT_HASH_SIZE];
        const char *path = wcut_results_path(r, r->name[k]);
        const wcut_status status = path ? wcut_file_hash(path, hash, error) : fail_results_memory(error);
        if (status != WCUT_OK) {
            wcut_text_destroy(&out);
            return status == WCUT_NO_MEMORY ? status : WCUT_NOT_WRITTEN;
        }
        wcut_text_print(&out, "%s\n    ", k ? "," : "");
        wcut_text_string(&out, r->name[k]);
        wcut_text_print(&out, ": \"%s\"", hash);
    }

    /* the object is closed again */
    wcut_text_print(&out, "%s}\n}\n", r->count ? "\n  " : "");

    return wcut_text_finish(&out, whole, NULL) == WCUT_OK ? WCUT_OK : fail_results_memory(error);
}

/* ---- the end ---- */

/* a file of the set into the journal, with the permissions of the file that it replaces */
static wcut_status place(wcut_results *r, const char *name, wcut_journal *journal, wcut_error *error) {
    int mode;
    const wcut_status status = check_name(r, name, &mode, error);
    if (status != WCUT_OK) return status;
    if (mode >= 0 && fchmodat(r->inside, name, (mode_t)mode, 0) != 0)
        return fail_name(error, r, name, errno, "not written");
    memcpy(journal->entry[journal->count++].name, name, strlen(name) + 1);
    return WCUT_OK;
}

static bool is_in_set(const wcut_results *r, const char *name) {
    for (int k = 0; k < r->count; k++)
        if (strcmp(r->name[k], name) == 0) return true;
    return false;
}

static bool is_in_journal(const wcut_journal *journal, const char *name) {
    for (int k = 0; k < journal->count; k++)
        if (strcmp(journal->entry[k].name, name) == 0) return true;
    return false;
}

/* a file that goes away with the earlier set; one that is none stays. 0 or an errno */
static int drop_file(const wcut_results *r, const char *voucher, const char *name, wcut_journal *journal) {
    struct stat s;
    if (strcmp(name, voucher) == 0 || is_in_set(r, name) || is_in_journal(journal, name)) return 0;
    if (fstatat(r->fd, name, &s, AT_SYMLINK_NOFOLLOW) != 0) return errno == ENOENT ? 0 : errno;
    if (!S_ISREG(s.st_mode) || journal->count + r->count + 1 >= WCUT_JOURNAL_NAMES_MAX) return 0;
    journal->entry[journal->count].remove = true;
    memcpy(journal->entry[journal->count++].name, name, strlen(name) + 1);
    return 0;
}

/* the object of hashes of the earlier voucher, for json_decref; NULL where there is none */
static wcut_status load_earlier(const wcut_results *r, const char *voucher, json_t **hashes, wcut_error *error) {
    struct stat s;
    *hashes = NULL;
    if (fstatat(r->fd, voucher, &s, AT_SYMLINK_NOFOLLOW) != 0)
        return errno == ENOENT ? WCUT_OK : fail_name(error, r, voucher, errno, "cannot be read");
    if (!S_ISREG(s.st_mode)) return WCUT_OK;

    /* it is there: what cannot be read is not taken for nothing */
    char *path = wcut_results_join(r->folder, voucher), *text = NULL;
    size_t length = 0;
    wcut_status status = path ? wcut_file_read(path, VOUCHER_MAX, &text, &length, error) : fail_results_memory(error);
    wcut_free(path);
    if (status != WCUT_OK) return status == WCUT_NO_MEMORY ? status : WCUT_NOT_WRITTEN;
    json_error_t cause;
    memset(&cause, 0, sizeof cause);
    errno = 0;
    json_t *root = json_loadb(text, length, JSON_REJECT_DUPLICATES, &cause);
    const bool lacking = !root && (errno == ENOMEM || json_error_code(&cause) == json_error_out_of_memory);
    free(text);
    if (lacking) return fail_results_memory(error);

    /* a file of that name that lists nothing is no voucher */
    json_t *found = json_object_get(root, "sha256");
    if (json_is_object(found)) *hashes = json_incref(found);
    json_decref(root);

    return WCUT_OK;
}

/* a file of the earlier voucher with the hash that it lists; one that somebody changed, or keeps from us, stays */
static wcut_status drop_listed(const wcut_results *r, const char *voucher, const char *name, const char *hash,
                               wcut_journal *journal, wcut_error *error) {
    wcut_result_state state;
    if (is_in_set(r, name) || is_in_journal(journal, name)) return WCUT_OK;
    if (faccessat(r->fd, name, R_OK, AT_EACCESS) != 0)
        return errno == ENOENT || errno == EACCES ? WCUT_OK : fail_name(error, r, name, errno, "cannot be read");

    /* the bytes tell whose it is */
    const wcut_status status = wcut_result_state_find(r->folder, name, hash, &state, error);
    if (status != WCUT_OK) return status == WCUT_NO_MEMORY ? status : WCUT_NOT_WRITTEN;
    const int code = state == WCUT_RESULT_STATE_WHOLE ? drop_file(r, voucher, name, journal) : 0;
    return code ? fail_name(error, r, name, code, "cannot be read") : WCUT_OK;
}

/* What an earlier run left would lie beside another's results: files under names of ours that this run did not write, and
   what the earlier voucher lists (halves of another label). */
static wcut_status drop_earlier(const wcut_results *r, const char *voucher, wcut_journal *journal, wcut_error *error) {
    json_t *hashes, *hash;
    const char *name;
    for (int k = 0; k < r->declared; k++) {
        const int code = drop_file(r, voucher, r->may[k], journal);
        if (code) return fail_name(error, r, r->may[k], code, "cannot be read");
    }

    /* the earlier set's own list */
    wcut_status status = load_earlier(r, voucher, &hashes, error);
    if (status != WCUT_OK || !hashes) return status;
    json_object_foreach(hashes, name, hash) {
        if (status == WCUT_OK && json_is_string(hash) && wcut_result_name_is_fine(name))
            status = drop_listed(r, voucher, name, json_string_value(hash), journal, error);
    }
    json_decref(hashes);

    return status;
}

/* the folder is locked: what goes away, what comes, and the voucher last */
static wcut_status publish(wcut_results *r, const char *voucher, wcut_journal *journal, wcut_error *error) {
    wcut_status status = drop_earlier(r, voucher, journal, error);
    for (int k = 0; k < r->count && status == WCUT_OK; k++) status = place(r, r->name[k], journal, error);
    if (status == WCUT_OK) status = place(r, voucher, journal, error);
    if (status != WCUT_OK) return status;
    int code = wcut_journal_begin(r->fd, r->inside, r->temporary, journal);
    if (code == ENOTEMPTY || code == EEXIST) code = EBUSY; /* a journal without locks came between */
    if (code) return fail_code(error, code, r->folder, "the results are not written");

    /* the hidden folder is the journal now */
    bool torn;
    r->temporary[0] = '\0';
    code = wcut_journal_finish(r->fd, journal, &torn);
    if (code == 0) return WCUT_OK;
    return fail_code(error, code, r->folder,
                     torn ? "the results are partly in their place; the next run there, or wirecut verify, finishes it"
                          : "the results are not written, the earlier ones are back");
}

static wcut_status commit(wcut_results *r, const char *voucher, const char *text, char **whole, wcut_error *error) {
    wcut_journal journal = {0, wcut_alloc(WCUT_JOURNAL_NAMES_MAX, sizeof *journal.entry)};
    wcut_status status = journal.entry ? WCUT_OK : fail_results_memory(error);
    char *printed = NULL;
    int locked;

    /* the voucher is complete before anything is moved */
    if (status == WCUT_OK) status = print_voucher(r, voucher, text, &printed, error);
    if (status == WCUT_OK) {
        const char *path = wcut_results_path(r, voucher);
        status = path ? wcut_file_write_whole(path, printed, strlen(printed), error) : fail_results_memory(error);
    }

    /* all results take their places under the folder's lock */
    if (status == WCUT_OK) status = wcut_results_enter(r->folder, r->fd, r->temporary, &locked, error);
    if (status == WCUT_OK) {
        status = publish(r, voucher, &journal, error);
        wcut_results_leave(r->fd, locked);
    }

    /* the text is handed out where it is wanted */
    wcut_free(journal.entry);
    if (status == WCUT_OK && whole)
        *whole = printed;
    else
        free(printed);

    wcut_results_reword(r, error);

    return status;
}

wcut_status wcut_results_commit(wcut_results *results, const char *voucher, const char *text, char **whole,
                                wcut_error *error) {
    wcut_results *r = results;
    const size_t length = voucher ? strlen(voucher) : 0;
    if (!r || !text || !r->temporary[0] || length < 6 || strcmp(voucher + length - 5, ".json") != 0 ||
        !wcut_result_name_is_fine(voucher) || is_in_set(r, voucher))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    const wcut_status status = commit(r, voucher, text, whole, error);

    /* what did not come into its place is of no use to a second try */
    if (r->temporary[0]) wcut_folder_remove_tree(r->fd, r->temporary, NULL);
    r->temporary[0] = '\0';
    r->count = 0;
    return status;
}
