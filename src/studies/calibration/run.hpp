// Runs the study calibration.
#pragma once

#include "studies/calibration/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Fits the case's law: tables fit, curves, profile, sweep, bootstrap and optimum (docs/formats/process.md).
[[nodiscard]] Outcome compute_calibration(const CalibrationCase& values, Session& session);
/// Foretells the wall seconds of compute_calibration without moldings, from a trial of a fraction of a
/// second.
[[nodiscard]] double calibration_seconds(const CalibrationCase& values);
/// Makes the report from the files of a result folder.
ReportDocument report_calibration(const CalibrationCase& values, const ResultFolder& folder);

}  // namespace fiberfate
