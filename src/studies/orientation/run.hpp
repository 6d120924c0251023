// Runs the study orientation.
#pragma once

#include "studies/orientation/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Follows the orientation tensor through the history of flow: table series.
[[nodiscard]] Outcome compute_orientation(const OrientationCase& values, Session& session);
/// Makes the report from the files of a result folder.
ReportDocument report_orientation(const OrientationCase& values, const ResultFolder& folder);

}  // namespace fiberfate
