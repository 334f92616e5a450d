/* The page of a comparison of a scan with a face. */
#ifndef APP_REPORT_COMPARE_H
#define APP_REPORT_COMPARE_H

#include "compare_run.h"

/* Write report.html to path. WCUT_OK; as wcut_report_write: nothing was written. */
wcut_status app_report_compare(const app_comparison *comparison, const char *path, wcut_error *error);

#endif
