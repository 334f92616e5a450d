/* Any bytes as force_law.json: refused in one printable line without a trace in the job, or a law that is one. */
#include <math.h>
#include <string.h>
#include <wirecut/job_file.h>

#include "file_fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size, "json");
    wcut_job job, before;
    wcut_error error = {WCUT_OK, ""};
    if (!path) return 0;
    memset(&job, 0, sizeof job);
    job.force_law.a = 0.1, job.force_law.b = 1e-3;
    memcpy(&before, &job, sizeof job);
    const wcut_status status = wcut_job_read_force_law(&job, path, &error);
    check_refusal(status, status == WCUT_OK, &error);
    check(status == WCUT_OK || memcmp(&job, &before, sizeof job) == 0);
    check(job.force_law.a > 0 && isfinite(job.force_law.a) && isfinite(job.force_law.b));
    remove(path);
    return 0;
}
