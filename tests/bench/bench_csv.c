/* How fast a recording is read: MB per CPU second, and the ratio to a memchr scan of the same bytes. 
   bench_csv [ROWS] */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <wirecut/recording.h>
#include <wirecut/recording_file.h>

#include "base/random.h"
#include "io/file/csv.h"
#include "io/file/read_file.h"

static const char *const scratch = "bench_csv.part.csv";

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* a recording as a machine writes it, or (exact) with the 17 digits of a program */
static int write_recording(int rows, int exact) {
    FILE *file = fopen(scratch, "w");
    if (!file) return 0;
    wcut_random random = wcut_random_seed(1);
    fputs(
        "time_s,station,speed_a_mm_s,speed_b_mm_s,tension_a_N,tension_b_N,alpha_a_deg,beta_a_deg,alpha_b_deg,"
        "beta_b_deg\n",
        file);
    for (int i = 0; i < rows; i++) {
        fprintf(file, "%.2f,%.3f", 0.05 * i, 0.01 * i);
        for (int c = 0; c < 8; c++) fprintf(file, exact ? ",%.17g" : ",%.3f", 20 + 3 * wcut_random_normal(&random));
        fputc('\n', file);
    }
    return fclose(file) == 0;
}

static double best_of(int rounds, int what, size_t *bytes) {
    double best = 1e99;
    for (int k = 0; k < rounds; k++) {
        char *text = NULL;
        size_t length = 0, feeds = 0;
        double start = now();
        if (what == 0) { /* read() and one memchr scan: the floor */
            if (wcut_file_read(scratch, (size_t)4 << 30, &text, &length, NULL) != WCUT_OK) exit(1);
            double read = now();
            for (char *p = text; (p = memchr(p, '\n', (size_t)(text + length - p))) != NULL; p++) feeds++;
            best = best < now() - read ? best : now() - read;
            *bytes = length;
        } else {
            wcut_recording *recording = NULL;
            if (wcut_recording_read(scratch, NULL, &recording, NULL) != WCUT_OK) exit(1);
            best = best < now() - start ? best : now() - start;
            wcut_recording_destroy(recording);
        }
        free(text);
        if (what == 0 && feeds == 0) exit(1);
    }
    return best;
}

int main(int argc, char **argv) {
    int rows = argc > 1 ? atoi(argv[1]) : 1000000;
    if (rows < 1) return 2;
    for (int exact = 0; exact < 2; exact++) {
        size_t bytes = 0;
        if (!write_recording(rows, exact)) return 1;
        double scan = best_of(3, 0, &bytes), read = best_of(3, 1, &bytes), mb = (double)bytes / 1e6;
        printf(
            "%-22s %d rows, %.0f MB: wcut_recording_read %.3f s = %.0f MB/s; memchr %.3f s = %.0f MB/s; ratio %.1f\n",
            exact ? "17 digits:" : "3 decimals:", rows, mb, read, mb / read, scan, mb / scan, read / scan);
        remove(scratch);
    }
    return 0;
}
