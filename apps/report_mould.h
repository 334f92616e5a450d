/* The page of a divided block. */
#ifndef APP_REPORT_MOULD_H
#define APP_REPORT_MOULD_H

#include <wirecut/wirecut.h>

/* what there is to say of a run beside its job and mould */
typedef struct app_moulded {
    const char *job_path;
    const char *stock_path;                         /* NULL: the job's block */
    const char *edges_path;                         /* NULL: the job's own, or none */
    double chord_tolerance, fit_tolerance, prolong; /* [mm] as asked for */
} app_moulded;

/* Write report.html to path. Statuses of wcut_report_write and wcut_file_hash: nothing was written. */
wcut_status app_report_mould(const app_moulded *run, const wcut_job *job, const wcut_history *history,
                             const wcut_mould *mould, const char *path, wcut_error *error);

#endif
