/* The page of a closed loop: speeds, tensions and angles with feedback and with the plan alone. */
#ifndef APP_REPORT_CONTROL_H
#define APP_REPORT_CONTROL_H

#include <wirecut/wirecut.h>

/* Write report.html to path. WCUT_OK; as wcut_report_write, wcut_file_hash: nothing was written. */
wcut_status app_report_control(const wcut_rig_summary *summary, const char *job_path, const char *path,
                               wcut_error *error);

#endif
