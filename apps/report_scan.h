/* What a comparison's page says of the scan itself: its points, how it was moved, what it was made into. */
#ifndef APP_REPORT_SCAN_H
#define APP_REPORT_SCAN_H

#include "compare_run.h"
#include "page_memory.h"

/* What became of the points and, where the scan was moved, its motion with covariance and matrix. False: memory
   failed. */
bool app_fill_registration(app_memory *memory, const app_comparison *comparison, wcut_report_section *section);

/* The scan as a mesh: figures both ways, holes. False: memory failed. */
bool app_fill_reconstruction(app_memory *memory, const app_comparison *comparison, wcut_report_section *section);

#endif
