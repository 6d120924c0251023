// Runs the study orientation.
#pragma once

#include "studies/orientation/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Runs a case into an empty result folder: series.csv, summary.json.
StopReason run_orientation(const OrientationCase& values, const RunOptions& options, ResultFolder& folder);
/// Runs it again: it takes a moment, so that nothing is kept of an interrupted run.
StopReason resume_orientation(const OrientationCase& values, const RunOptions& options, ResultFolder& folder);
/// Gathers what the report shows from the files of a result folder.
ReportDocument report_orientation(const OrientationCase& values, const ResultFolder& folder);

}  // namespace fiberfate
