/* The instruments and the rig on a diagnosis's page: what contradicts itself, and what differs from cut to cut. */
#ifndef WCUT_IO_REPORT_INSTRUMENTS_H
#define WCUT_IO_REPORT_INSTRUMENTS_H

#include <wirecut/report_pages.h>
#include "io/report/page_memory.h"

/* Tables of contradictions and of the rig's scatter. False: there is neither, or memory failed. */
bool wcut_report_instruments_fill(wcut_page_memory *memory, const wcut_report_diagnose *of,
                                  wcut_report_section *section);

#endif
