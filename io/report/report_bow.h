/* The bow of a bow's wire on a cut's page: along the cut, on its face, and how fast it may go. */
#ifndef WCUT_IO_REPORT_BOW_H
#define WCUT_IO_REPORT_BOW_H

#include <wirecut/bow.h>
#include <wirecut/report.h>

enum { WCUT_REPORT_BOW_COLUMNS = 12 };

/* What the section points to; it borrows results, history and the abscissae. */
typedef struct wcut_report_bow {
    double *series; /* 4 x stations: bow, departure, force, closing */
    double *turned; /* nodes x stations: departures, with the node as the row; NULL: too many cells */
    double *node;   /* nodes */
    double chart[WCUT_REPORT_BOW_COLUMNS][WCUT_FEED_CHART_HEATS];
    wcut_report_series along[4], feed[2 * WCUT_FEED_CHART_BOWS];
    wcut_report_chart charts[4];
    wcut_report_map map;
    wcut_report_column column[WCUT_REPORT_BOW_COLUMNS];
    wcut_report_table table;
    char note[200];
} wcut_report_bow;

/* Fill the section "Bow of the wire"; time, station: abscissae, one a station. WCUT_NO_MEMORY: what was made is to clear. */
wcut_status wcut_report_bow_fill(wcut_report_bow *bow, const wcut_bow_results *results, const double *time,
                                 const double *station, wcut_report_section *section);

void wcut_report_bow_clear(wcut_report_bow *bow);

#endif
