/* A user of the library of files: a job that is not there is refused with its name. */
#include <stdio.h>
#include <wirecut/job_file.h>

int main(int argc, char **argv) {
    wcut_job *job = NULL;
    wcut_error error = {0};
    if (argc != 2) return 2;
    if (wcut_job_read(argv[1], &job, &error) == WCUT_OK) wcut_job_destroy(job);
    return puts(error.text) < 0;
}
