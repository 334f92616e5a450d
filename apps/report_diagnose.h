/* The page of a diagnosis. */
#ifndef APP_REPORT_DIAGNOSE_H
#define APP_REPORT_DIAGNOSE_H

#include <wirecut/diagnosis.h>
#include <wirecut/wirecut.h>

/* what the page is of; everything is borrowed */
typedef struct app_diagnosed {
    const char *title; /* the case's name */
    const wcut_diagnosis *diagnosis;
    const char *const *cut_name; /* diagnosis->cuts */
    int said;
    const char *const *said_text; /* said: what of the case could not be read */
    int options;
    const wcut_report_fact *option;
    int sources;
    const wcut_report_source *source;
} app_diagnosed;

/* Write report.html to path. WCUT_OK; as wcut_report_write: nothing was written. */
wcut_status app_report_diagnose(const app_diagnosed *diagnosed, const char *path, wcut_error *error);

#endif
