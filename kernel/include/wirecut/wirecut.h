/* wirecut/wirecut.h - the whole public API. */
#ifndef WCUT_WIRECUT_H
#define WCUT_WIRECUT_H

#include <wirecut/brep.h>
#include <wirecut/bounds.h>
#include <wirecut/calibration.h>
#include <wirecut/case.h>
#include <wirecut/cloud.h>
#include <wirecut/control.h>
#include <wirecut/curvature.h>
#include <wirecut/curve.h>
#include <wirecut/curve_measure.h>
#include <wirecut/cut.h>
#include <wirecut/edit.h>
#include <wirecut/effects.h>
#include <wirecut/equilibrium.h>
#include <wirecut/export.h>
#include <wirecut/force_density.h>
#include <wirecut/force_law.h>
#include <wirecut/history.h>
#include <wirecut/job.h>
#include <wirecut/loss.h>
#include <wirecut/mesh.h>
#include <wirecut/mould.h>
#include <wirecut/projection.h>
#include <wirecut/reconstruction.h>
#include <wirecut/read.h>
#include <wirecut/recording.h>
#include <wirecut/registration.h>
#include <wirecut/replay.h>
#include <wirecut/report.h>
#include <wirecut/reshape.h>
#include <wirecut/rig.h>
#include <wirecut/robot.h>
#include <wirecut/score.h>
#include <wirecut/status.h>
#include <wirecut/summary.h>
#include <wirecut/surface.h>
#include <wirecut/table.h>
#include <wirecut/vec3.h>
#include <wirecut/version.h>
#include <wirecut/write.h>

#endif
