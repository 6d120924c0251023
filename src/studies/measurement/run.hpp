// Runs the study measurement.
#pragma once

#include "studies/measurement/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Runs a case into an empty result folder: summary.json, histogram.csv, distribution.csv, directions.csv.
StopReason run_measurement(const MeasurementCase& values, const RunOptions& options, ResultFolder& folder);
/// Runs it again: it takes a moment, so that nothing is kept of an interrupted run.
StopReason resume_measurement(const MeasurementCase& values, const RunOptions& options, ResultFolder& folder);
/// Gathers what the report shows from the files of a result folder.
ReportDocument report_measurement(const MeasurementCase& values, const ResultFolder& folder);

}  // namespace fiberfate
