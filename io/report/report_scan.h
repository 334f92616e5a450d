/* What a comparison's page says of the scan itself: its points, how it was moved, what it was made into. */
#ifndef WCUT_IO_REPORT_REPORT_SCAN_H
#define WCUT_IO_REPORT_REPORT_SCAN_H

#include <stdbool.h>
#include <wirecut/deviation_file.h>
#include <wirecut/report.h>

#include "io/report/page_memory.h"

/* What became of the points and, where the scan was moved, its motion with covariance and matrix. False: memory
   failed. */
bool wcut_report_fill_registration(wcut_page_memory *memory, const wcut_compared *compared,
                                   wcut_report_section *section);

/* The scan as a mesh: figures both ways, holes. False: memory failed. */
bool wcut_report_fill_reconstruction(wcut_page_memory *memory, const wcut_compared *compared,
                                     wcut_report_section *section);

#endif
