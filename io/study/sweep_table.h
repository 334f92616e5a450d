/* The numbers and texts of all cases of a sweep, for its summary and its page. */
#ifndef WCUT_IO_STUDY_SWEEP_TABLE_H
#define WCUT_IO_STUDY_SWEEP_TABLE_H

#include <jansson.h>
#include <wirecut/sweep.h>

/* every case's numbers: parameters, then figures; NaN where there is none or it is no number */
typedef struct wcut_sweep_table {
    int cases, columns;
    double *number;       /* columns x cases */
    json_t ***text;       /* columns; of one that has texts cases, NULL where there is none; else NULL */
    unsigned char *state; /* cases, wcut_sweep_state */
    char (*hash)[WCUT_STUDY_HASH_SIZE];
    int best_count, *best; /* cases that have the figure of "best", from the best on */
} wcut_sweep_table;
wcut_status wcut_sweep_table_load(const wcut_sweep *sweep, wcut_sweep_table *table, wcut_error *error);
void wcut_sweep_table_free(wcut_sweep_table *table);

/* the folder of a sweep, absolute; borrowed */
const char *wcut_sweep_root(const wcut_sweep *sweep);

#endif
