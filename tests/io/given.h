/* What the tests of io start from: job texts, a mesh, a history, a folder of their own. */
#ifndef WCUT_TESTS_IO_GIVEN_H
#define WCUT_TESTS_IO_GIVEN_H

#include <dirent.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <wirecut/history.h>
#include <wirecut/mesh.h>

#include "io/file/read_file.h"
#include "test.h"

static const char given_path_job[] =
    "{\n"
    "  \"format\": \"wirecut-job/1\",\n"
    "  \"name\": \"test cut\",\n"
    "  \"block\": {\"size_mm\": [400, 1200, 300.5], \"material\": \"EPS 15 kg/m3\"},\n"
    "  \"wire\": {\"diameter_mm\": 0.15, \"material\": \"Kanthal A\", \"nodes\": 121, \"length_mm\": 620.25},\n"
    "  \"process\": {\"heat_W_per_m\": 60.0, \"tension_N\": 2.0,\n"
    "    \"force_law\": {\"a_N_per_mm\": 0.1, \"b_m2_per_J\": 8.6e-4},\n"
    "    \"tension_law\": {\"a_N_per_mm\": 0.02, \"b_m2_per_J\": 4.0e-4, \"c_N_per_mm\": -0.001}},\n"
    "  \"path\": {\"mount_a_mm\": [[-110, 0, 150], [-110, 1.5, 150], [-110, 3, 150.125]],\n"
    "           \"mount_b_mm\": [[510, 0, 150], [510, 1.5, 150], [510, 3.0000000000000004, 150]]},\n"
    "  \"limits\": {\"speed_max_mm_s\": 80, \"speed_min_mm_s\": 0.5},\n"
    "  \"kerf\": {\"width_mm\": 0.8, \"per_J_m2_mm\": 1.6e-4},\n"
    "  \"excitation\": {\"speed\": [{\"amplitude\": 0.045, \"period_s\": 3.1, \"phase_rad\": 1.2}],\n"
    "                 \"heat\": [{\"from_s\": 12, \"to_s\": 21.5, \"factor\": 0.9},\n"
    "                          {\"from_s\": 21.5, \"to_s\": 30, \"factor\": 1.1}]},\n"
    "  \"effects\": [],\n"
    "  \"x-note\": {\"anything\": [1, null]}\n"
    "}\n";

static const char given_design_job[] =
    "{\"format\": \"wirecut-job/1\", \"name\": \"free form\", \"block\": {\"size_mm\": [400, 900, 300]},\n"
    " \"wire\": {\"diameter_mm\": 0.15, \"nodes\": 61},\n"
    " \"process\": {\"heat_W_per_m\": 60, \"tension_N\": 2, \"force_law\": {\"a_N_per_mm\": 0.1, \"b_m2_per_J\": "
    "8e-4}},\n"
    " \"design\": {\"edge_a\": {\"points_mm\": [[0, 0, 100], [0, 300, 130], [0, 600, 90], [0, 900, 100]]},\n"
    "   \"edge_b\": {\"degree\": 2, \"knots\": [0, 0, 0, 1, 1, 1],\n"
    "     \"control_points_mm\": [[400, 0, 100], [400, 450, 200], [400, 900, 100]], \"weights\": [1, 0.5, 1]},\n"
    "   \"stations\": 41, \"extra_length_mm\": [[0, 5], [0.5, 60], [1, 5]], \"clearance_mm\": 80}}\n";

/* text with its first `find` replaced, the caller's to free; `find` must be there */
static inline char *given_changed(const char *text, const char *find, const char *by) {
    const char *at = strstr(text, find);
    ck_assert_msg(at != NULL, "not in the text: %s", find);
    size_t size = strlen(text) + strlen(by) + 1;
    char *changed = calloc(size, 1);
    snprintf(changed, size, "%.*s%s%s", (int)(at - text), text, by, at + strlen(find));
    return changed;
}

/* ---- a folder, the process's working one, removed by leave_folder ---- */

static char given_folder[64];

static inline void enter_folder(void) {
    snprintf(given_folder, sizeof given_folder, "/tmp/wirecut-test-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(given_folder));
    ck_assert_int_eq(chmod(given_folder, 0777), 0);
    ck_assert_int_eq(chdir(given_folder), 0);
}

/* entries of a folder but "." and ".." */
static inline int count_entries(const char *folder) {
    DIR *list = opendir(folder);
    ck_assert_ptr_nonnull(list);
    int count = -2;
    while (readdir(list)) count++;
    closedir(list);
    return count;
}

static inline void leave_folder(void) {
    DIR *list = opendir(given_folder);
    for (struct dirent *entry = readdir(list); entry; entry = readdir(list)) {
        char path[400];
        snprintf(path, sizeof path, "%s/%s", given_folder, entry->d_name);
        if (unlink(path) != 0) rmdir(path);
    }
    closedir(list);
    rmdir(given_folder);
}

static inline void write_file(const char *path, const char *text) {
    FILE *file = fopen(path, "wb");
    ck_assert_ptr_nonnull(file);
    ck_assert(fwrite(text, 1, strlen(text), file) == strlen(text) && fclose(file) == 0);
}

/* a file's bytes, the caller's to free */
__attribute__((unused, noinline)) static char *read_back(const char *path, size_t *length) {
    char *text = NULL;
    ck_assert_int_eq(wcut_file_read(path, (size_t)1 << 30, &text, length, NULL), WCUT_OK);
    return text;
}

static inline void file_holds(const char *path, const char *expected) {
    size_t length;
    char *text = read_back(path, &length);
    ck_assert_str_eq(text, expected);
    free(text);
}

/* ---- a mesh: rows x columns vertices over a wavy patch ---- */

static inline wcut_mesh given_mesh(int rows, int columns) {
    wcut_mesh m = {rows * columns, 2 * (rows - 1) * (columns - 1), NULL, NULL, NULL, NULL, NULL};
    m.vertex = calloc((size_t)m.vertex_count, sizeof *m.vertex);
    m.normal = calloc((size_t)m.vertex_count, sizeof *m.normal);
    m.uv = calloc((size_t)m.vertex_count, 2 * sizeof *m.uv);
    m.scalar = calloc((size_t)m.vertex_count, sizeof *m.scalar);
    m.triangle = calloc((size_t)m.triangle_count, 3 * sizeof *m.triangle);
    for (int k = 0; k < m.vertex_count; k++) {
        int row = k / columns;
        double u = (k % columns) / (columns - 1.0), v = row / (rows - 1.0);
        m.vertex[k] = (wcut_vec3){400 * u, 1200 * v, 150 + 20 * sin(3 * u) * cos(2 * v)};
        double gx = -60 * cos(3 * u) * cos(2 * v) / 400, gy = 40 * sin(3 * u) * sin(2 * v) / 1200;
        double size = sqrt(gx * gx + gy * gy + 1);
        m.normal[k] = (wcut_vec3){gx / size, gy / size, 1 / size};
        m.uv[2 * k] = u;
        m.uv[2 * k + 1] = v;
        m.scalar[k] = 0.01 * u * (1 + v);
    }
    for (int k = 0, t = 0; k < (rows - 1) * columns; k++) {
        if (k % columns == columns - 1) continue;
        const int corner[6] = {k, k + 1, k + columns + 1, k, k + columns + 1, k + columns};
        memcpy(m.triangle + 3 * (size_t)t, corner, sizeof corner);
        t += 2;
    }
    return m;
}

static inline void forget_mesh(wcut_mesh *m) {
    free(m->vertex);
    free(m->normal);
    free(m->uv);
    free(m->scalar);
    free(m->triangle);
}

/* ---- a history: m stations of n nodes, every value its own ---- */

static inline void fill_row(wcut_history_row *r, int j) {
    *r = (wcut_history_row){.time = 0.1 * j,
                            .duration = j ? 0.1 : 0,
                            .speed_a = j ? 20.0 + j / 3.0 : 0,
                            .speed_b = j ? 19.0 + j / 7.0 : 0,
                            .tension_a = 2.0 - 1.0 / (j + 3),
                            .tension_b = 2.0 - 1.0 / (j + 5),
                            .alpha_a = 0.5 + 0.01 * j,
                            .beta_a = -0.1 + 0.003 * j,
                            .alpha_b = 0.45 + 0.01 * j,
                            .beta_b = 0.2 - 0.001 * j,
                            .engaged_length = 400.0 / (j + 1),
                            .residual = 1e-12 * (j + 1) / 3,
                            .iterations = 2 + j % 4,
                            .substeps = 1 + j % 2,
                            .phase = (wcut_phase)(j % 5),
                            .condition = (wcut_condition)(j % 3)};
}

static inline wcut_history given_history(int m, int n) {
    wcut_history h = {.stations = m, .planned = m + 2, .nodes = n};
    size_t count = (size_t)m * (size_t)n;
    h.row = calloc((size_t)m, sizeof *h.row);
    h.position = calloc(count, sizeof *h.position);
    h.force = calloc(count, sizeof *h.force);
    h.force_line = calloc(count, sizeof *h.force_line);
    h.speed = calloc(count, sizeof *h.speed);
    h.tension = calloc(count, sizeof *h.tension);
    for (int j = 0; j < m; j++) fill_row(&h.row[j], j);
    for (size_t i = 0; i < count; i++) {
        double s = (double)i;
        h.position[i] = (wcut_vec3){s / 3, s / 7, sqrt(s)};
        h.force[i] = (wcut_vec3){-s / 11, s / 13, -s / 17};
        h.force_line[i] = 0.006 + 1e-5 * s / 3;
        h.speed[i] = 20 + s / 19;
        h.tension[i] = 2 + s / 23;
    }
    return h;
}

static inline void forget_history(wcut_history *h) {
    free(h->row);
    free(h->position);
    free(h->force);
    free(h->force_line);
    free(h->speed);
    free(h->tension);
}

#endif
