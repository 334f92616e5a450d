/* The page of a calibration, and the sentences it shares with the summary. */
#ifndef APP_REPORT_CALIBRATE_H
#define APP_REPORT_CALIBRATE_H

#include <wirecut/wirecut.h>

/* what the page is of; everything is borrowed */
typedef struct app_calibrated {
    const char *path;    /* of the table */
    const char *weights; /* the column they are from; NULL: all cuts count the same */
    int cuts;
    const wcut_test_cut *cut;
    const wcut_calibration_options *options;
    const wcut_calibration *fit;
    const wcut_calibration_point *point;
    int warnings;
    const char *const *warning; /* sentences: what to know before cutting by these numbers */
} app_calibrated;

enum { APP_SENTENCE = 256 };

/* How far cuts lie from a law: those it was fitted to, and those left out of the fit. */
void app_describe_scatter(const app_calibrated *of, const wcut_law_fit *fit, char sentence[APP_SENTENCE]);

/* Whether a law fits, and what it was tested against. */
void app_describe_lack(const wcut_law_fit *fit, char sentence[APP_SENTENCE]);

/* Write report.html to path. WCUT_OK; as wcut_report_write and wcut_file_hash: nothing was written. */
wcut_status app_report_calibrate(const app_calibrated *of, const char *path, wcut_error *error);

#endif
