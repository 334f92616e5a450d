/* "wirecut-rig/1": what a cell knows of its own rig. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/rig_prior_file.h>

#include "base/fail.h"
#include "io/file/json_read.h"
#include "io/file/read_file.h"
#include "io/process/rig_prior.h"

#define FORMAT "wirecut-rig/1"

enum { BYTES_MAX = 1 << 20 };

static bool read_rig_format(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)into;
    const char *name = json_string_value(at->value);
    return (name && strcmp(name, FORMAT) == 0) || wcut_refuse(reader, at, WCUT_BAD_FORMAT, "\"" FORMAT "\"");
}

static bool read_rig_name(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)into;
    return json_is_string(at->value) || wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a text");
}

/* one key for each kind of scatter, by the names that a diagnosis writes */
static bool read_scatter(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_field field[WCUT_SCATTER_COUNT];
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++)
        field[k] = (wcut_field){wcut_scatter_name((wcut_scatter_kind)k), false, wcut_read_positive,
                                offsetof(wcut_rig_prior, scatter) + (size_t)k * sizeof(double)};
    return wcut_read_object(reader, at, field, WCUT_SCATTER_COUNT, into);
}

static bool read_delay(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field field[] = {
        {"tension_s", false, wcut_read_positive, offsetof(wcut_rig_prior, tension_delay)},
        {"angle_s", false, wcut_read_positive, offsetof(wcut_rig_prior, angle_delay)}};
    return wcut_read_object(reader, at, field, sizeof field / sizeof *field, into);
}

wcut_status wcut_rig_prior_parse(const char *text, size_t length, const char *path, wcut_rig_prior *prior,
                                 wcut_error *error) {
    static const wcut_field field[] = {{"format", true, read_rig_format, 0},
                                       {"name", false, read_rig_name, 0},
                                       {"scatter", false, read_scatter, 0},
                                       {"delay", false, read_delay, 0}};
    wcut_reader reader = {path, error, WCUT_OK};
    json_t *root = wcut_json_load(&reader, text, length);
    if (!root) return reader.status;

    /* what the file does not name is usual */
    const wcut_place at = {NULL, NULL, 0, root};
    wcut_rig_prior made = wcut_rig_prior_default();
    if (wcut_read_object(&reader, &at, field, sizeof field / sizeof *field, &made)) *prior = made;
    json_decref(root);
    return reader.status;
}

wcut_status wcut_rig_prior_read(const char *path, wcut_rig_prior *prior, wcut_error *error) {
    if (!path || !prior) return wcut_fail(error, WCUT_BAD_ARGUMENT, "wcut_rig_prior_read: path or prior is NULL");
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_file_read(path, BYTES_MAX, &text, &length, error);
    if (status == WCUT_OK) status = wcut_rig_prior_parse(text, length, path, prior, error);
    free(text);
    return status;
}
