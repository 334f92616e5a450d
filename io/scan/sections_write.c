/* sections.csv: the profiles along the lines that a user lays over a face. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/survey.h>

#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/text.h"

static void put_section_row(wcut_text *t, const char *name, const wcut_section_row *r) {
    const double figure[] = {r->along, r->x, r->y};
    const double measured[] = {r->nominal, r->measured, r->deviation};
    wcut_text_put_word(t, name);
    for (size_t k = 0; k < 3; k++) {
        wcut_text_put_word(t, ",");
        wcut_text_number(t, figure[k]);
    }
    for (size_t k = 0; k < 3; k++) {
        wcut_text_put_word(t, ",");
        if (r->count > 0) wcut_text_number(t, measured[k]);
    }
    wcut_text_print(t, ",%d\n", r->count);
}

wcut_status wcut_sections_write(const wcut_survey_result *result, const char *path, wcut_error *error) {
    wcut_text t;
    if (!result || !result->of || !path || (result->of->sections > 0 && !result->section))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "sections: %s", wcut_status_text(WCUT_BAD_ARGUMENT));
    if (!wcut_text_create(&t, NULL)) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    wcut_text_put_word(&t, "section,along_mm,x_mm,y_mm,nominal_z_mm,measured_z_mm,deviation_mm,count\n");
    for (int k = 0; k < result->of->sections; k++)
        for (int row = 0; row < result->section[k].rows; row++)
            put_section_row(&t, result->of->section[k].name, &result->section[k].row[row]);

    /* the whole text, or the target as it was */
    char *text = NULL;
    wcut_status status = wcut_text_finish(&t, &text, NULL);
    if (status != WCUT_OK) return wcut_fail(error, status, "sections: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, strlen(text), error);
    free(text);
    return status;
}
