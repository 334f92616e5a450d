/* A CURVE in JSON, as jobs and files of curves have it. */
#ifndef WCUT_IO_PROCESS_CURVE_JSON_H
#define WCUT_IO_PROCESS_CURVE_JSON_H

#include "io/file/json_read.h"

/* wcut_read_value: `into` is a wcut_curve *, the caller's to wcut_curve_destroy */
bool wcut_read_curve(wcut_reader *reader, const wcut_place *at, void *into);

/* two edges as text, for a refusal to show */
#define WCUT_CURVES_FORM_CSV "CSV: curve,x_mm,y_mm,z_mm / a,0,0,150 / a,0,900,136 / b,400,0,100 / b,400,900,128"
#define WCUT_CURVES_FORM_JSON                                                                   \
    "JSON: {\"edge_a\": {\"points_mm\": [[0,0,150],[0,900,136]]}, \"edge_b\": {\"points_mm\": " \
    "[[400,0,100],[400,900,128]]}}"

#endif
