/* Any bytes as a case: never a crash, and no name that leaves the folder. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "io/process/case.h"
#include "io/process/correction.h"
#include "io/process/rig_prior.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

/* below "folder/", and nowhere up */
static void check_name(const char *name) {
    if (!name) return;
    check(strncmp(name, "folder/", 7) == 0 && name[7] != '/' && name[7] != '\0');
    check(!strstr(name, "/../"));
    const size_t length = strlen(name);
    check(length < 3 || strcmp(name + length - 3, "/..") != 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    wcut_case *found = NULL;
    wcut_error error = {WCUT_OK, ""};
    char format[WCUT_FORMAT_SIZE];
    const wcut_status status = wcut_case_parse((const char *)data, size, "folder/case.json", &found, &error);
    check((status == WCUT_OK) == (found != NULL) && (status == WCUT_OK || error.text[0] != '\0'));
    for (int i = 0; found && i < found->cuts; i++) {
        check(found->cut[i].job && found->cut[i].recording);
        check_name(found->cut[i].job);
        check_name(found->cut[i].recording);
        check_name(found->cut[i].scan);
    }
    if (found) {
        check(found->name && found->cuts > 0);
        check_name(found->calibration);
        check(found->format.period >= 0 && found->format.maps <= WCUT_CHANNEL_COUNT);
        for (int k = 0; k < found->format.maps; k++) {
            const wcut_column_map *m = &found->format.map[k];
            check(m->column && m->column[0] && m->factor != 0 && isfinite(m->factor) && isfinite(m->offset));
        }
        check(wcut_format_parse((const char *)data, size, "folder/case.json", format, &error) == WCUT_OK);
        check(strcmp(format, "wirecut-case/1") == 0);
    }
    wcut_case_destroy(found);

    /* the same bytes as a text of columns */
    char *text = malloc(size + 1);
    if (text) {
        wcut_recording_format columns = {0};
        memcpy(text, data, size);
        text[size] = '\0';
        check((wcut_recording_format_parse(text, &columns, &error) == WCUT_OK) || columns.maps == 0);
        wcut_recording_format_clear(&columns);
        free(text);
    }

    /* a diagnosis is read for its correction alone */
    wcut_correction correction = {.effects = -1};
    const wcut_status read = wcut_correction_parse((const char *)data, size, "diagnosis.json", &correction, &error);
    check((read == WCUT_OK) == (correction.effects >= 0) && (read == WCUT_OK || error.text[0] != '\0'));

    /* what a cell knows of itself: widths that are positive, or nothing */
    wcut_rig_prior prior = {.tension_delay = -1};
    const wcut_status known = wcut_rig_prior_parse((const char *)data, size, "rig.json", &prior, &error);
    check((known == WCUT_OK) == (prior.tension_delay > 0) && (known == WCUT_OK || error.text[0] != '\0'));
    for (int k = 0; known == WCUT_OK && k < WCUT_SCATTER_COUNT; k++) check(prior.scatter[k] > 0);
    return 0;
}
