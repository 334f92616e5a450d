/* The page of recordings beside their predictions. */
#ifndef APP_REPORT_SCORE_H
#define APP_REPORT_SCORE_H

#include <wirecut/wirecut.h>

/* what the page is of; everything is borrowed */
typedef struct app_scored {
    const char *title;
    int cuts; /* at least one of them compared */
    const wcut_scored_cut *cut;
    int groups; /* rows of the table by case, or by cut where there is one case or none */
    const char *const *group_name;
    const wcut_scores *planned, *replayed; /* groups + 1 each: of every group, and at last of all cuts */
    const char *group_label;               /* "case" or "cut" */
    const wcut_comparison_options *options;
    int nodes; /* along the wire; 0: as the jobs say */
    int sources;
    const wcut_report_source *source;
} app_scored;

/* Write report.html to path. WCUT_OK; as wcut_report_write: nothing was written. */
wcut_status app_report_score(const app_scored *scored, const char *path, wcut_error *error);

#endif
