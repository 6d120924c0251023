// Runs the study measurement.
#pragma once

#include "studies/measurement/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Evaluates the lists: tables histogram, distribution and directions.
[[nodiscard]] Outcome compute_measurement(const MeasurementCase& values, Session& session);
/// Makes the report from the files of a result folder.
ReportDocument report_measurement(const MeasurementCase& values, const ResultFolder& folder);

}  // namespace fiberfate
