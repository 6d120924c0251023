// Runs the study calibration.
#pragma once

#include "studies/calibration/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Fits the case's law into an empty result folder: fit.csv, curves.csv, profile.csv, sweep.csv,
/// bootstrap.csv and summary.json (docs/formats/process.md).
StopReason run_calibration(const CalibrationCase& values, const RunOptions& options, ResultFolder& folder);
/// Runs it again: nothing is kept of an interrupted run.
StopReason resume_calibration(const CalibrationCase& values, const RunOptions& options, ResultFolder& folder);
/// Gathers what the report shows from the files of a result folder.
ReportDocument report_calibration(const CalibrationCase& values, const ResultFolder& folder);

}  // namespace fiberfate
