/* The findings on a diagnosis's page: the channels as they are, what was found in the block, what to do next. */
#ifndef WCUT_IO_REPORT_REPORT_FINDINGS_H
#define WCUT_IO_REPORT_REPORT_FINDINGS_H

#include <wirecut/report_pages.h>

#include "io/report/page_memory.h"

/* measured and simulated over time: the worst cut, and another one that is held out; false: nothing to draw */
bool wcut_report_channels_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, wcut_report_section *section);

/* steps, and the files with their use */
bool wcut_report_next_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, wcut_report_section *section);

/* block, wire at the worst moment, what was found, the scan; false: nothing to see */
bool wcut_report_block_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, wcut_report_scene *scene);

#endif
