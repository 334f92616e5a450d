/* "wirecut-case/1": the cuts of a case, and that none of its files lies outside its folder. */
#define _XOPEN_SOURCE 700 /* realpath */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/json_read.h"
#include "io/file/read_file.h"
#include "io/process/case.h"
#include "io/process/job.h"
#include "io/process/recording_format.h"

#define FORMAT "wirecut-case/1"

/* what is being filled, and the folder that names are relative to */
typedef struct filling {
    wcut_case *made;
    const char *folder; /* length bytes, with its slash */
    size_t length;
} filling;

/* a cut, with what reading its names needs */
typedef struct cut_filling {
    wcut_case_cut cut;
    const filling *of;
} cut_filling;

/* ---- names ---- */

/* whether a part of a name between slashes is ".." */
static bool has_parent(const char *name) {
    for (const char *part = name; part; part = strchr(part, '/')) {
        part += *part == '/';
        if (strncmp(part, "..", 2) == 0 && (part[2] == '/' || part[2] == '\0')) return true;
    }
    return false;
}

/* Whether a file that is there lies in the case's folder, whatever links lead to it, and is an ordinary one: a pipe or a
   device in it would be waited for, or read without end. What is not there is reported by who reads it. */
static bool check_inside(wcut_reader *reader, const wcut_place *at, const filling *of, const char *path) {
    struct stat s;
    char *folder = wcut_alloc(of->length + 2, 1);
    if (!folder) return wcut_refuse_memory(reader);
    memcpy(folder, of->length ? of->folder : ".", of->length ? of->length : 1);
    char *real_folder = realpath(folder, NULL), *real = realpath(path, NULL);
    free(folder);
    const size_t length = real_folder ? strlen(real_folder) : 0;
    const bool within =
        !real || !real_folder || (strncmp(real, real_folder, length) == 0 && (real[length] == '/' || length == 1));
    const bool ordinary = !real || stat(real, &s) != 0 || S_ISREG(s.st_mode) || S_ISDIR(s.st_mode);
    free(real_folder);
    free(real);
    if (!within)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT,
                           "a file inside the case's folder, not a link that leads out of it");
    return ordinary || wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "an ordinary file, not a pipe or a device");
}

/* the file that a name stands for, the caller's to free */
static bool read_name(wcut_reader *reader, const wcut_place *at, const filling *of, char **into) {
    const char *name = json_string_value(at->value);
    if (!name) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a file's name");
    if (!*name || *name == '/' || has_parent(name))
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT,
                           "a name inside the case's folder, without / before or .. in it");
    char *path = wcut_path_join(of->folder, of->length, name);
    if (!path) return wcut_refuse_memory(reader);
    *into = path;
    return check_inside(reader, at, of, path);
}

/* ---- values ---- */

static bool read_case_format(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)into;
    return wcut_read_format(reader, at, FORMAT);
}

static bool read_case_name(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_text(reader, at, &((filling *)into)->made->name);
}

static bool read_calibration(wcut_reader *reader, const wcut_place *at, void *into) {
    filling *of = into;
    return json_is_null(at->value) || read_name(reader, at, of, &of->made->calibration);
}

static bool read_case_columns(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_columns(reader, at, &((filling *)into)->made->format);
}

static bool read_case_period(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_period(reader, at, &((filling *)into)->made->format.period);
}

static bool read_cut_job(wcut_reader *reader, const wcut_place *at, void *into) {
    cut_filling *to = into;
    return read_name(reader, at, to->of, &to->cut.job);
}

static bool read_recording(wcut_reader *reader, const wcut_place *at, void *into) {
    cut_filling *to = into;
    return read_name(reader, at, to->of, &to->cut.recording);
}

static bool read_scan(wcut_reader *reader, const wcut_place *at, void *into) {
    cut_filling *to = into;
    return json_is_null(at->value) || read_name(reader, at, to->of, &to->cut.scan);
}

static bool read_cuts(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {
        {"job", true, read_cut_job, 0}, {"recording", true, read_recording, 0}, {"scan", false, read_scan, 0}};
    filling *of = into;
    const size_t n = json_array_size(at->value);
    if (!json_is_array(at->value) || n < 1 || n > WCUT_CASE_CUTS_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an array of 1 to %d cuts", WCUT_CASE_CUTS_MAX);
    of->made->cut = wcut_alloc(n, sizeof *of->made->cut);
    if (!of->made->cut) return wcut_refuse_memory(reader);
    of->made->cuts = (int)n;
    for (size_t i = 0; i < n; i++) {
        const wcut_place place = {at, NULL, i, json_array_get(at->value, i)};
        cut_filling to = {.of = of};
        const bool whole = wcut_read_object(reader, &place, fields, sizeof fields / sizeof *fields, &to);
        of->made->cut[i] = to.cut; /* what was read is the case's to free, whole or not */
        if (!whole) return false;
    }
    return true;
}

static bool read_case(wcut_reader *reader, const wcut_place *at, filling *of) {
    static const wcut_field fields[] = {{"format", true, read_case_format, 0},
                                        {"name", true, read_case_name, 0},
                                        {"cuts", true, read_cuts, 0},
                                        {"calibration", false, read_calibration, 0},
                                        {"columns", false, read_case_columns, 0},
                                        {"period_s", false, read_case_period, 0}};
    /* the format before all else: another format has other keys */
    const wcut_place format = wcut_place_member(at, "format");
    if (json_is_object(at->value) && !read_case_format(reader, &format, NULL)) return false;
    return wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, of);
}

/* ---- the whole ---- */

wcut_status wcut_case_parse(const char *text, size_t length, const char *path, wcut_case **found, wcut_error *error) {
    wcut_reader reader = {path, error, WCUT_OK};
    json_t *root = wcut_json_load(&reader, text, length);
    if (!root) return reader.status;
    const wcut_place at = {NULL, NULL, 0, root};
    filling of = {wcut_alloc(1, sizeof(wcut_case)), path, wcut_folder_length(path)};
    const bool whole = of.made ? read_case(&reader, &at, &of) : wcut_refuse_memory(&reader);
    json_decref(root);
    if (!whole) {
        wcut_case_destroy(of.made);
        return reader.status;
    }
    *found = of.made;
    return WCUT_OK;
}

wcut_status wcut_format_parse(const char *text, size_t length, const char *path, char *format, wcut_error *error) {
    wcut_reader reader = {path, error, WCUT_OK};
    json_t *root = wcut_json_load(&reader, text, length);
    if (!root) return reader.status;
    const wcut_place at = {NULL, NULL, 0, root}, member = wcut_place_member(&at, "format");
    const char *name = json_string_value(member.value);
    const bool fits = name && strlen(name) < WCUT_FORMAT_SIZE;
    if (fits) memcpy(format, name, strlen(name) + 1);
    if (!fits) wcut_refuse(&reader, &member, WCUT_BAD_FORMAT, "the name of a format");
    json_decref(root);
    return reader.status;
}

wcut_status wcut_case_read(const char *path, wcut_case **found, wcut_error *error) {
    if (!path || !found) return wcut_fail(error, WCUT_BAD_ARGUMENT, "wcut_case_read: path or found is NULL");
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_file_read(path, WCUT_CASE_BYTES_MAX, &text, &length, error);
    if (status == WCUT_OK) status = wcut_case_parse(text, length, path, found, error);
    free(text);
    return status;
}

wcut_status wcut_format_read(const char *path, char *format, wcut_error *error) {
    if (!path || !format) return wcut_fail(error, WCUT_BAD_ARGUMENT, "wcut_format_read: path or format is NULL");
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_file_read(path, WCUT_JOB_BYTES_MAX, &text, &length, error);
    if (status == WCUT_OK) status = wcut_format_parse(text, length, path, format, error);
    free(text);
    return status;
}

const char *wcut_case_file(const wcut_case *found, int i) {
    if (i == 0 && found->calibration) return found->calibration;
    i -= found->calibration != NULL;

    /* those of each cut that has one */
    for (int k = 0; k < found->cuts; k++) {
        const wcut_case_cut *cut = &found->cut[k];
        const char *const name[] = {cut->job, cut->recording, cut->scan};
        for (size_t n = 0; n < sizeof name / sizeof *name; n++)
            if (name[n] && i-- == 0) return name[n];
    }
    return NULL;
}

void wcut_case_destroy(wcut_case *found) {
    if (!found) return;
    for (int i = 0; i < found->cuts; i++) {
        free(found->cut[i].job);
        free(found->cut[i].recording);
        free(found->cut[i].scan);
    }
    free(found->cut);
    free(found->calibration);
    wcut_recording_format_clear(&found->format);
    free(found->name);
    free(found);
}
