/* wirecut/wirecut.h - the whole public API.
 *
 * ABI. Two shared libraries carry one version: libwirecut (computation) and libwirecut-io (files: the headers
 * *_file.h, case.h, compare.h, exchange.h, read.h, report.h, report_pages.h, study.h, sweep.h, table.h, write.h).
 * Before 1.0 a minor version may change the ABI, so the soname has major and minor version; a patch version changes
 * neither a struct nor a function nor the order of an enumeration. Options structs are filled by their *_default
 * function: take it before setting members, so that members added later have their defaults. Exported symbols are
 * listed in kernel/symbols.txt; one that goes is announced in CHANGELOG.md. */
#ifndef WCUT_WIRECUT_H
#define WCUT_WIRECUT_H

#include <wirecut/angle.h>
#include <wirecut/bounds.h>
#include <wirecut/bow.h>
#include <wirecut/bow_file.h>
#include <wirecut/brep.h>
#include <wirecut/calibration.h>
#include <wirecut/calibration_file.h>
#include <wirecut/camera.h>
#include <wirecut/case.h>
#include <wirecut/cloud.h>
#include <wirecut/cloud_file.h>
#include <wirecut/compare.h>
#include <wirecut/compensation.h>
#include <wirecut/compensation_file.h>
#include <wirecut/control.h>
#include <wirecut/correction.h>
#include <wirecut/crossing.h>
#include <wirecut/curvature.h>
#include <wirecut/curve.h>
#include <wirecut/curve_loft.h>
#include <wirecut/curve_measure.h>
#include <wirecut/cut.h>
#include <wirecut/design.h>
#include <wirecut/design_file.h>
#include <wirecut/design_panels.h>
#include <wirecut/deviation.h>
#include <wirecut/deviation_file.h>
#include <wirecut/deviation_summary.h>
#include <wirecut/diagnosis.h>
#include <wirecut/diagnosis_file.h>
#include <wirecut/edit.h>
#include <wirecut/effects.h>
#include <wirecut/equilibrium.h>
#include <wirecut/exchange.h>
#include <wirecut/export.h>
#include <wirecut/facade.h>
#include <wirecut/facade_file.h>
#include <wirecut/face.h>
#include <wirecut/feasibility.h>
#include <wirecut/force_density.h>
#include <wirecut/force_law.h>
#include <wirecut/history.h>
#include <wirecut/intersect.h>
#include <wirecut/job.h>
#include <wirecut/job_file.h>
#include <wirecut/job_rig.h>
#include <wirecut/loss.h>
#include <wirecut/mesh.h>
#include <wirecut/mesh_tree.h>
#include <wirecut/mould.h>
#include <wirecut/mould_file.h>
#include <wirecut/offset.h>
#include <wirecut/overlay.h>
#include <wirecut/overlay_file.h>
#include <wirecut/plausible.h>
#include <wirecut/projection.h>
#include <wirecut/read.h>
#include <wirecut/reconstruction.h>
#include <wirecut/recording.h>
#include <wirecut/recording_file.h>
#include <wirecut/regions.h>
#include <wirecut/registration.h>
#include <wirecut/replay.h>
#include <wirecut/report.h>
#include <wirecut/report_pages.h>
#include <wirecut/reshape.h>
#include <wirecut/results.h>
#include <wirecut/rig.h>
#include <wirecut/rig_file.h>
#include <wirecut/rig_prior_file.h>
#include <wirecut/robot.h>
#include <wirecut/robot_file.h>
#include <wirecut/score.h>
#include <wirecut/score_file.h>
#include <wirecut/statistics.h>
#include <wirecut/status.h>
#include <wirecut/study.h>
#include <wirecut/summary.h>
#include <wirecut/surface.h>
#include <wirecut/surface_fit.h>
#include <wirecut/survey.h>
#include <wirecut/sweep.h>
#include <wirecut/table.h>
#include <wirecut/trimmed.h>
#include <wirecut/vec3.h>
#include <wirecut/version.h>
#include <wirecut/write.h>

#endif
