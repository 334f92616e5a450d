/* Any bytes as CSV: never a crash, and a table whose numbers are finite and whose masks add up. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/recording.h>

#include "io/file/csv.h"

/* small, so that rows lie across its end */
enum { WINDOW = 200 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void check(int true_or_abort) {
    if (!true_or_abort) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *numeric[WCUT_CHANNEL_COUNT];
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) numeric[k] = wcut_channel_name((wcut_channel)k);
    wcut_table *table = NULL;
    wcut_error error = {WCUT_OK, ""};
    wcut_status status =
        wcut_csv_parse((const char *)data, size, WINDOW, "fuzz", WCUT_CHANNEL_COUNT, numeric, &table, &error);
    check((status == WCUT_OK) == (table != NULL) && (status == WCUT_OK || error.text[0] != '\0'));
    for (int c = 0; table && c < table->columns; c++) {
        const wcut_column *column = &table->column[c];
        int missing = 0;
        /* the first column of a name is found; columns without a name, and further ones of a name, are kept beside */
        const int at = wcut_table_locate(table, column->name);
        check(at >= 0 && at <= c && strcmp(table->column[at].name, column->name) == 0);
        for (int i = 0; i < table->rows; i++) {
            check(isfinite(column->value[i]));
            missing += column->present && !column->present[i];
            check(!(column->present && !column->present[i]) || column->value[i] == 0);
        }
        check(missing == column->missing && column->text <= missing);
    }
    for (int i = 1; table && i < table->rows; i++) check(table->line[i] > table->line[i - 1]);
    wcut_table_destroy(table);
    return 0;
}
