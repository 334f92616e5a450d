/* A CURVE in JSON, as jobs and files of curves have it. */
#ifndef WCUT_IO_PROCESS_CURVE_JSON_H
#define WCUT_IO_PROCESS_CURVE_JSON_H

#include "io/file/json_read.h"

/* wcut_read_value: `into` is a wcut_curve *, the caller's to wcut_curve_destroy */
bool wcut_read_curve(wcut_reader *reader, const wcut_place *at, void *into);

#endif
