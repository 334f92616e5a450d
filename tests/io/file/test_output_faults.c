/* Every output on a full disk, beyond a size limit and where it may not be written: the old file stays, nothing is left
   beside it, and the message says path and cause. */
#include <errno.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <wirecut/job_file.h>
#include <wirecut/write.h>

#include "io/given.h"
#include "io/process/job.h"
#include "test.h"

static wcut_mesh mesh;
static wcut_history history;
static wcut_job *job;
static wcut_setup *cut_setup;
static wcut_vec3 ends[200];
static wcut_error error;

static void setup(void) {
    mesh = given_mesh(60, 60);
    history = given_history(200, 61);
    ck_assert_int_eq(wcut_job_parse(given_path_job, strlen(given_path_job), "given", &job, &error), WCUT_OK);
    ck_assert_int_eq(wcut_setup_create(job, NULL, &cut_setup, &error), WCUT_OK);
    /* enough stations for a file of some blocks */
    ck_assert_int_eq(wcut_job_resample(job, 3000), WCUT_OK);
    enter_folder();
}

static void teardown(void) {
    forget_mesh(&mesh);
    forget_history(&history);
    wcut_job_destroy(job);
    wcut_setup_destroy(cut_setup);
    leave_folder();
}

/* ---- the outputs ---- */

static wcut_status write_stl(const char *path) { return wcut_mesh_write_stl(&mesh, path, &error); }
static wcut_status write_obj(const char *path) { return wcut_mesh_write_obj(&mesh, path, &error); }
static wcut_status write_ply(const char *path) { return wcut_mesh_write_ply(&mesh, "force_N_per_mm", path, &error); }
static wcut_status write_glb(const char *path) { return wcut_mesh_write_glb(&mesh, path, &error); }
static wcut_status write_csv(const char *path) { return wcut_history_write_csv(&history, ends, ends, path, &error); }
static wcut_status write_vtp(const char *path) { return wcut_history_write_vtp(&history, path, &error); }
static wcut_status write_job(const char *path) { return wcut_job_write(job, path, &error); }

/* planned for more than come, so that the arrays are moved at the end */
static wcut_status write_stream(const char *path) {
    wcut_vtp_stream *stream = NULL;
    wcut_status status = wcut_vtp_stream_create(path, 250, history.nodes, &stream, &error);
    for (int j = 0; status == WCUT_OK && j < history.stations; j++) {
        size_t at = (size_t)j * (size_t)history.nodes;
        wcut_station s = {.index = j, .nodes = history.nodes, .position = history.position + at};
        s.force = history.force + at;
        s.force_line = history.force_line + at;
        s.speed = history.speed + at;
        s.tension = history.tension + at;
        if (j < history.stations - 1) status = wcut_vtp_stream_append(stream, &s, &error);
    }
    if (status == WCUT_OK) status = wcut_vtp_stream_commit(stream, &error);
    wcut_vtp_stream_destroy(stream);
    return status;
}

static const struct output {
    const char *name;
    wcut_status (*write)(const char *path);
} outputs[] = {{"a.stl", write_stl}, {"a.obj", write_obj}, {"a.ply", write_ply},    {"a.glb", write_glb},
               {"a.csv", write_csv}, {"a.vtp", write_vtp}, {"s.vtp", write_stream}, {"job.json", write_job}};
enum { OUTPUTS = sizeof outputs / sizeof *outputs };

/* Write under a size limit. It ends before anything is asserted: Check's own messages go through a file, too. */
static wcut_status write_within(const struct output *output, rlim_t limit) {
    const struct rlimit bound = {limit, RLIM_INFINITY}, none = {RLIM_INFINITY, RLIM_INFINITY};
    if (setrlimit(RLIMIT_FSIZE, &bound) != 0) return WCUT_INTERNAL;
    const wcut_status status = output->write(output->name);
    return setrlimit(RLIMIT_FSIZE, &none) == 0 ? status : WCUT_INTERNAL;
}

/* not written, for that cause, and the folder holds the old file alone */
static void fails(const struct output *output, rlim_t limit, const char *cause) {
    char line[200];
    error = (wcut_error){WCUT_OK, ""};
    const wcut_status status = write_within(output, limit);
    ck_assert_msg(status == WCUT_NOT_WRITTEN, "%s: %d %s", output->name, error.status, error.text);
    snprintf(line, sizeof line, "%s: not written: %s", output->name, cause);
    ck_assert_str_eq(error.text, line);
    ck_assert_int_eq(error.status, WCUT_NOT_WRITTEN);
    file_holds(output->name, "old");
    ck_assert_int_eq(count_entries("."), 1);
}

static size_t size_of(const struct output *output) {
    struct stat s;
    ck_assert_msg(output->write(output->name) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(stat(output->name, &s), 0);
    ck_assert_int_eq(unlink(output->name), 0);
    return (size_t)s.st_size;
}

TEST(beyond_the_size_limit_nothing_is_written) {
    setup();
    signal(SIGXFSZ, SIG_IGN); /* as the command does */
    for (int k = 0; k < OUTPUTS; k++) {
        size_t size = size_of(&outputs[k]);
        const size_t limit[] = {0, 1, 4096, size / 2, size - 1};
        write_file(outputs[k].name, "old");
        for (size_t i = 0; i < sizeof limit / sizeof *limit; i++) fails(&outputs[k], limit[i], strerror(EFBIG));
        ck_assert_int_eq(outputs[k].write(outputs[k].name), WCUT_OK); /* and with room it is */
        ck_assert_int_eq(unlink(outputs[k].name), 0);
    }
    teardown();
}

/* a disk of a few pages, mounted over the test's folder */
static int mount_tiny_disk(void) {
    if (mount("tiny", given_folder, "tmpfs", 0, "size=16k") != 0) {
        printf("no small disk can be mounted here (%s): full disks were tested by the size limit alone\n",
               strerror(errno));
        return 0;
    }
    ck_assert_int_eq(chdir(given_folder), 0); /* into the new one */
    return 1;
}

TEST(on_a_full_disk_nothing_is_written) {
    setup();
    if (mount_tiny_disk()) {
        for (int k = 0; k < OUTPUTS; k++) {
            write_file(outputs[k].name, "old");
            fails(&outputs[k], RLIM_INFINITY, strerror(ENOSPC));
            ck_assert_int_eq(unlink(outputs[k].name), 0);
        }
        ck_assert_int_eq(chdir("/"), 0);
        ck_assert_int_eq(umount(given_folder), 0);
    }
    teardown();
}

TEST(where_nothing_may_be_written_nothing_is) {
    setup();
    for (int k = 0; k < OUTPUTS; k++) {
        write_file(outputs[k].name, "old");
        ck_assert_int_eq(chmod(given_folder, 0555), 0);
        pid_t child = fork();
        if (child == 0) {
            if (geteuid() == 0) ck_assert_int_eq(setuid(65534), 0); /* root may write anywhere */
            ck_assert_int_eq(outputs[k].write("other"), WCUT_NOT_WRITTEN);
            ck_assert_str_eq(error.text, "other: not written: Permission denied");
            _exit(0);
        }
        int status;
        ck_assert_int_eq(waitpid(child, &status, 0), child);
        ck_assert_int_eq(status, 0);
        ck_assert_int_eq(chmod(given_folder, 0777), 0);
        ck_assert_int_eq(count_entries("."), 1);
        ck_assert_int_eq(unlink(outputs[k].name), 0);
    }
    teardown();
}

TEST(a_folder_in_the_way_is_named) {
    setup();
    ck_assert_int_eq(mkdir("there", 0777), 0);
    for (int k = 0; k < OUTPUTS; k++) {
        ck_assert_int_eq(outputs[k].write("there"), WCUT_NOT_WRITTEN);
        ck_assert_str_eq(error.text, "there: not written: Is a directory");
        ck_assert_int_eq(outputs[k].write("none/there"), WCUT_NOT_WRITTEN);
        ck_assert_str_eq(error.text, "none/there: not written: No such file or directory");
    }
    ck_assert_int_eq(count_entries("."), 1);
    teardown();
}
