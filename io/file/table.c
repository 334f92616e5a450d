/* Tables of columns: found by name, destroyed. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/table.h>

int wcut_table_locate(const wcut_table *table, const char *name) {
    for (int c = 0; table && name && c < table->columns; c++)
        if (strcmp(table->column[c].name, name) == 0) return c;
    return -1;
}

void wcut_table_destroy(wcut_table *table) {
    if (!table) return;
    for (int c = 0; c < table->columns; c++) {
        free(table->column[c].name);
        free(table->column[c].value);
        free(table->column[c].present);
    }
    free(table->column);
    free(table->line);
    free(table);
}
