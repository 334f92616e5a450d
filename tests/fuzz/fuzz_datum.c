/* Any bytes as datums: refused in one printable line, or pairs and faces that a registration takes. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include <wirecut/deviation_file.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

static void check_point(wcut_vec3 p) { check(fabs(p.x) <= 1e12 && fabs(p.y) <= 1e12 && fabs(p.z) <= 1e12); }

static void check_datums(const wcut_datums *d) {
    check(d->pairs >= 0 && d->faces >= 0 && d->pairs + d->faces > 0);
    for (int k = 0; k < d->pairs; k++) {
        check_point(d->pair[k].scan), check_point(d->pair[k].block);
        check(d->pair[k].sigma >= 0);
    }
    for (int k = 0; k < d->faces; k++) {
        const wcut_vec3 n = d->face[k].normal;
        check(d->face[k].count == 1 && n.x + n.y + n.z == 1 && d->face[k].sigma >= 0);
        check_point(*d->face[k].scan), check_point(d->face[k].point);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static char path[64];
    if (!path[0]) snprintf(path, sizeof path, "/tmp/wirecut-fuzz-datum-%d.csv", (int)getpid());
    FILE *file = fopen(path, "wb");
    if (!file) return 0;
    const int whole = fwrite(data, 1, size, file) == size;
    fclose(file);
    wcut_datums *datums = NULL;
    wcut_error error = {WCUT_OK, ""};
    const wcut_status status = whole ? wcut_datums_read(path, &datums, &error) : WCUT_NOT_FOUND;
    remove(path);
    check((status == WCUT_OK) == (datums != NULL));
    if (datums) check_datums(datums);
    if (whole && !datums) check(status == WCUT_BAD_FORMAT && error.text[0] != '\0');
    for (const char *p = error.text; *p; p++) check((unsigned char)*p >= 0x20 && *p != 0x7f);
    wcut_datums_destroy(datums);
    return 0;
}
