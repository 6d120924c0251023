// Runs the study rheometer.
#pragma once

#include "results/report_document.hpp"
#include "results/result_folder.hpp"
#include "studies/rheometer/case.hpp"

namespace fiberfate {

/// Runs every point and replica, and fits laws to their stresses: tables rheometer, a row a finished run,
/// curves and fits. Goes on within the run that was going at the last checkpoint where the session does; the
/// result is that of a run that was never interrupted. Raises SimulationFailure with the state saved.
[[nodiscard]] Outcome compute_rheometer(const RheometerCase& values, Session& session);
/// Makes the report from the files of a result folder.
[[nodiscard]] ReportDocument report_rheometer(const RheometerCase& values, const ResultFolder& folder);

}  // namespace fiberfate
