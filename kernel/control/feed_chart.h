/* The feed chart of a bow: largest steady feeds at which the wire bows by so much. */
#ifndef WCUT_CONTROL_FEED_CHART_H
#define WCUT_CONTROL_FEED_CHART_H

#include <wirecut/bow.h>

#include "cut/setup.h"

/* WCUT_FEED_CHART_HEATS rows for a bow that cuts `width` mm of foam; WCUT_BAD_ARGUMENT as wcut_bow_results_create */
wcut_status wcut_feed_chart_fill(const wcut_setup *setup, double width, const wcut_robot_limits *limits,
                                 wcut_feed_chart_row *chart);

#endif
