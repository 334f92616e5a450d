/* The process laws of "wirecut-force-law/1" in the place of a job's own. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/job_file.h>

#include "base/fail.h"
#include "io/file/json_read.h"
#include "io/file/read_file.h"
#include "io/process/job.h"

#define FORMAT "wirecut-force-law/1"
enum { BYTES_MAX = 64 << 20 };

/* "process" holds both laws as a job has them; the other keys tell how they were found */
static bool read_laws(wcut_reader *reader, const wcut_place *root, wcut_force_law *force, wcut_tension_law *tension) {
    const wcut_place format = wcut_place_member(root, "format"), process = wcut_place_member(root, "process");
    if (!wcut_read_format(reader, &format, FORMAT)) return false;
    if (!json_is_object(process.value))
        return wcut_refuse(reader, &process, WCUT_BAD_FORMAT, "an object with the laws");
    const wcut_place of_force = wcut_place_member(&process, "force_law");
    const wcut_place of_tension = wcut_place_member(&process, "tension_law");
    if (!wcut_read_force_law(reader, &of_force, force)) return false;
    return !of_tension.value || json_is_null(of_tension.value) || wcut_read_tension_law(reader, &of_tension, tension);
}

wcut_status wcut_job_read_force_law(wcut_job *job, const char *path, wcut_error *error) {
    if (!job || !path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));

    /* the whole file in memory, up to a limit */
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_file_read(path, BYTES_MAX, &text, &length, error);
    if (status != WCUT_OK) return status;

    /* parse it, and read both laws */
    wcut_reader reader = {path, error, WCUT_OK};
    json_t *json = wcut_json_load(&reader, text, length);
    free(text);
    if (!json) return reader.status;
    const wcut_place root = {NULL, NULL, 0, json};
    wcut_force_law force = {0};
    wcut_tension_law tension = {0};

    /* the job is changed only once both are read */
    if (read_laws(&reader, &root, &force, &tension)) {
        job->force_law = force;
        job->tension_law = tension;
    }
    json_decref(json);

    return reader.status;
}
