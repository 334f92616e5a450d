/* How fast clouds are read, cleaned and given normals, and in how much memory.  bench_cloud [POINTS [STREAM]]
   POINTS (1000000): the size of the files read; STREAM (0): points of a file read once in pieces, its peak memory. */
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <wirecut/cloud.h>
#include <wirecut/cloud_file.h>

#include "base/random.h"

enum { PIECE = 4096 };

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double wall(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void *get(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory) exit(1);
    return memory;
}

/* a saddle over 400 x 1200 mm with a noise of 0.05 mm, in random order */
static wcut_vec3 *make_sheet(int count) {
    wcut_random random = wcut_random_seed(1);
    wcut_vec3 *p = get((size_t)count, sizeof *p);
    for (int k = 0; k < count; k++) {
        const double x = 400 * wcut_random_uniform(&random), y = 1200 * wcut_random_uniform(&random);
        p[k] = (wcut_vec3){x, y, 150 + (x - 200) * (y - 600) / 2000 + 0.05 * wcut_random_normal(&random)};
    }
    return p;
}

/* ---- files ---- */

typedef struct format {
    const char *name, *path;
    void (*write)(FILE *file, int count, const wcut_vec3 *p);
} format;

static void put_floats(FILE *f, const wcut_vec3 *p) {
    const float v[3] = {(float)p->x, (float)p->y, (float)p->z};
    fwrite(v, sizeof v, 1, f);
}

static void write_xyz(FILE *f, int n, const wcut_vec3 *p) {
    for (int k = 0; k < n; k++) fprintf(f, "%.4f %.4f %.4f\n", p[k].x, p[k].y, p[k].z);
}

static void write_long_xyz(FILE *f, int n, const wcut_vec3 *p) {
    for (int k = 0; k < n; k++) fprintf(f, "%.17g %.17g %.17g\n", p[k].x, p[k].y, p[k].z);
}

static void write_csv(FILE *f, int n, const wcut_vec3 *p) {
    fprintf(f, "x_mm,y_mm,z_mm,nx,ny,nz\n");
    for (int k = 0; k < n; k++) fprintf(f, "%.4f,%.4f,%.4f,0.12345,-0.23456,0.96422\n", p[k].x, p[k].y, p[k].z);
}

static void write_ply_ascii(FILE *f, int n, const wcut_vec3 *p) {
    fprintf(f, "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n", n);
    fprintf(f, "end_header\n");
    write_xyz(f, n, p);
}

static void write_ply(FILE *f, int n, const wcut_vec3 *p) {
    fprintf(f, "ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\n", n);
    fprintf(f, "property float z\nend_header\n");
    for (int k = 0; k < n; k++) put_floats(f, &p[k]);
}

static void write_pcd(FILE *f, int n, const wcut_vec3 *p) {
    fprintf(f, "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH %d\nHEIGHT 1\n", n);
    fprintf(f, "POINTS %d\nDATA binary\n", n);
    for (int k = 0; k < n; k++) put_floats(f, &p[k]);
}

static void write_stl(FILE *f, int n, const wcut_vec3 *p) {
    const unsigned facets = (unsigned)n / 3;
    const char head[80] = "binary", tail[2] = "";
    const float none[3] = {0, 0, 0};
    fwrite(head, sizeof head, 1, f);
    fwrite(&facets, sizeof facets, 1, f);
    for (unsigned k = 0; k < facets; k++) {
        fwrite(none, sizeof none, 1, f);
        for (unsigned c = 0; c < 3; c++) put_floats(f, &p[3 * k + c]);
        fwrite(tail, sizeof tail, 1, f);
    }
}

static void write_las(FILE *f, int n, const wcut_vec3 *p) {
    unsigned char head[227] = "LASF";
    const double scale[3] = {1e-4, 1e-4, 1e-4};
    const unsigned size = sizeof head, count = (unsigned)n;
    head[24] = 1, head[25] = 2, head[94] = sizeof head, head[105] = 20;
    memcpy(head + 96, &size, sizeof size);
    memcpy(head + 107, &count, sizeof count);
    memcpy(head + 131, scale, sizeof scale);
    fwrite(head, sizeof head, 1, f);
    for (int k = 0; k < n; k++) {
        const int v[5] = {(int)(p[k].x * 1e4), (int)(p[k].y * 1e4), (int)(p[k].z * 1e4), 0, 0};
        fwrite(v, sizeof v, 1, f);
    }
}

/* the floor: read() of the file, and one memchr of its bytes */
static double scan(const char *path, double *bytes) {
    static char block[1 << 18];
    int fd = open(path, O_RDONLY);
    size_t feeds = 0;
    ssize_t n;
    *bytes = 0;
    const double start = now();
    while ((n = read(fd, block, sizeof block)) > 0) {
        for (char *p = block; (p = memchr(p, '\n', (size_t)(block + n - p))) != NULL; p++) feeds++;
        *bytes += (double)n;
    }
    close(fd);
    return feeds < (size_t)-1 ? now() - start : 0;
}

static double read_pieces(const char *path, int *count) {
    static wcut_vec3 point[PIECE], normal[PIECE];
    wcut_cloud_source *source = NULL;
    wcut_error error;
    const double start = now();
    int got = 0;
    *count = 0;
    if (wcut_cloud_source_create(path, NULL, &source, &error) != WCUT_OK) exit((puts(error.text), 1));
    do {
        if (wcut_cloud_source_next(source, PIECE, point, normal, &got, &error) != WCUT_OK) exit((puts(error.text), 1));
        *count += got;
    } while (got > 0);
    wcut_cloud_source_destroy(source);
    return now() - start;
}

static void bench_formats(int count, const wcut_vec3 *p) {
    static const format formats[] = {{"XYZ, 4 decimals", "bench_cloud.part.xyz", write_xyz},
                                     {"XYZ, 17 digits", "bench_cloud.part.xyz", write_long_xyz},
                                     {"CSV with normals", "bench_cloud.part.csv", write_csv},
                                     {"PLY ascii", "bench_cloud.part.ply", write_ply_ascii},
                                     {"PLY binary float", "bench_cloud.part.ply", write_ply},
                                     {"PCD binary", "bench_cloud.part.pcd", write_pcd},
                                     {"STL binary", "bench_cloud.part.stl", write_stl},
                                     {"LAS 1.2", "bench_cloud.part.las", write_las}};
    for (size_t k = 0; k < sizeof formats / sizeof *formats; k++) {
        FILE *f = fopen(formats[k].path, "wb");
        if (!f) exit(1);
        formats[k].write(f, count, p);
        if (fclose(f) != 0) exit(1);
        double read = 1e99, floor_time = 1e99, bytes = 0;
        int got = 0;
        for (int round = 0; round < 3; round++) {
            floor_time = fmin(floor_time, scan(formats[k].path, &bytes));
            read = fmin(read, read_pieces(formats[k].path, &got));
        }
        printf("%-17s %6.1f MB  %.4f s per million points, %5.0f MB/s; read and memchr %.4f s, ratio %.1f\n",
               formats[k].name, bytes / 1e6, read / got * 1e6, bytes / 1e6 / read, floor_time / got * 1e6,
               read / floor_time);
        unlink(formats[k].path);
    }
}

/* ---- cleaning and normals ---- */

static void bench_kernel(int count, const wcut_vec3 *p) {
    unsigned char *removal = get((size_t)count, 1);
    wcut_vec3 *normal = get((size_t)count, sizeof *normal);
    for (int threads = 1; threads <= 2; threads++) {
        wcut_clean_report r;
        wcut_normals_report found;
        double cpu = now(), start = wall();
        if (wcut_cloud_clean(count, p, NULL, threads, removal, &r) != WCUT_OK) exit(1);
        printf("clean, %d thread(s): %.2f s CPU, %.2f s; kept %d, duplicates %d, outliers %d, limit %.3f mm\n", threads,
               now() - cpu, wall() - start, r.removed[WCUT_REMOVAL_KEPT], r.removed[WCUT_REMOVAL_DUPLICATE],
               r.removed[WCUT_REMOVAL_OUTLIER], r.limit);
        cpu = now(), start = wall();
        if (wcut_cloud_normals(count, p, NULL, threads, normal, &found) != WCUT_OK) exit(1);
        printf("normals, %d thread(s): %.2f s CPU, %.2f s\n", threads, now() - cpu, wall() - start);
    }
    wcut_normals_options whole = wcut_normals_options_default();
    wcut_normals_report found;
    whole.steep = 1;
    const double cpu = now();
    if (wcut_cloud_normals(count, p, &whole, 1, normal, &found) != WCUT_OK) exit(1);
    printf("normals, the sheet turned as a whole: %.2f s CPU, %d propagated\n", now() - cpu, found.propagated);
    wcut_thinning *thinning = NULL;
    const double start = now();
    if (wcut_thinning_create(2, &thinning) != WCUT_OK) exit(1);
    if (wcut_thinning_add(thinning, count, p, removal) != WCUT_OK) exit(1);
    int kept = 0;
    for (int k = 0; k < count; k++) kept += removal[k];
    printf("thinning at 2 mm: %.2f s CPU, %d kept\n", now() - start, kept);
    wcut_thinning_destroy(thinning);
    free(removal);
    free(normal);
}

/* ---- a long file in a process of its own: what it needs at most ---- */

static void print_peak(const char *what, int count, double seconds) {
    struct rusage use;
    getrusage(RUSAGE_SELF, &use);
    printf("%s: %d points, %.1f s CPU, %.1f MiB at most\n", what, count, seconds, (double)use.ru_maxrss / 1024);
}

/* a sparse file of zeros: no disk, every byte is read all the same */
static void stream_file(int count) {
    const char *path = "bench_cloud.part.ply";
    FILE *f = fopen(path, "wb");
    int got = 0;
    if (!f) exit(1);
    fprintf(f, "ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\n", count);
    fprintf(f, "property float z\nend_header\n");
    fflush(f);
    if (ftruncate(fileno(f), ftell(f) + 12 * (off_t)count) != 0 || fclose(f) != 0) exit(1);
    const double seconds = read_pieces(path, &got);
    print_peak("PLY binary in pieces", got, seconds);
    unlink(path);
}

/* text through a pipe: another process writes the same lines again and again */
static void stream_pipe(int count) {
    int ends[2];
    if (pipe(ends) != 0) exit(1);
    const pid_t writer = fork();
    if (writer == 0) {
        static char block[1 << 16];
        size_t lines = 0, size = 0;
        for (; size < sizeof block - 64; lines++)
            size += (size_t)sprintf(block + size, "%.4f %.4f 150.1234\n", 1.37 * (double)(lines % 290),
                                    0.1 * (double)lines);
        const size_t line_count = lines;
        for (size_t done = 0; done < (size_t)count; done += line_count)
            for (size_t at = 0; at < size;) {
                const ssize_t n = write(ends[1], block + at, size - at);
                if (n <= 0) _exit(1);
                at += (size_t)n;
            }
        _exit(0);
    }
    close(ends[1]);
    char path[32];
    int got = 0;
    snprintf(path, sizeof path, "/dev/fd/%d", ends[0]);
    const double seconds = read_pieces(path, &got);
    print_peak("XYZ through a pipe", got, seconds);
    waitpid(writer, NULL, 0);
}

static void in_a_process(void (*what)(int), int count) {
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        what(count);
        fflush(stdout);
        _exit(0);
    }
    waitpid(child, NULL, 0);
}

int main(int argc, char **argv) {
    const int count = argc > 1 ? atoi(argv[1]) : 1000000, stream = argc > 2 ? atoi(argv[2]) : 0;
    if (count < 1000) return 2;
    if (stream > 0) {
        in_a_process(stream_file, stream);
        in_a_process(stream_pipe, stream);
    }
    wcut_vec3 *p = make_sheet(count);
    bench_formats(count, p);
    bench_kernel(count, p);
    free(p);
    return 0;
}
