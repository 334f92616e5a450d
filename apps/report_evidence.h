/* The evidence on a diagnosis's page: residuals of all models as maps and as lines. */
#ifndef APP_REPORT_EVIDENCE_H
#define APP_REPORT_EVIDENCE_H

#include "page_memory.h"
#include "report_diagnose.h"

/* The residuals of every trace over time, before, recalibrated and after, with one colour limit, and what the rows are.
   False: there are no traces, or memory failed. */
bool app_fill_evidence(app_memory *memory, const app_diagnosed *of, wcut_report_section *section);

/* A cut's residuals as lines, mismatches shaded. False: it has no traces, or memory failed. */
bool app_fill_residuals(app_memory *memory, const app_diagnosed *of, int cut, wcut_report_section *section);

#endif
