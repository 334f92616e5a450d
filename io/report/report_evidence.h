/* The evidence on a diagnosis's page: residuals of all models as maps and as lines. */
#ifndef WCUT_IO_REPORT_EVIDENCE_H
#define WCUT_IO_REPORT_EVIDENCE_H

#include <wirecut/report_pages.h>
#include "io/report/page_memory.h"

/* The residuals of every trace over time, before, recalibrated and after, with one colour limit, and what the rows are.
   False: there are no traces, or memory failed. */
bool wcut_report_evidence_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, wcut_report_section *section);

/* A cut's residuals as lines, mismatches shaded. False: it has no traces, or memory failed. */
bool wcut_report_residuals_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, int cut,
                                wcut_report_section *section);

#endif
