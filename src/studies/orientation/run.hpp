// Runs the study orientation.
#pragma once

#include "studies/orientation/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Follows the orientation tensor through the history of flow: table series.
[[nodiscard]] Outcome compute_orientation(const OrientationCase& values, Session& session);
/// The memory that a run takes, the program with it, bytes.
[[nodiscard]] double orientation_bytes(const OrientationCase& values);
/// Foretells the wall seconds of compute_orientation from a trial of a fraction of a second.
[[nodiscard]] double orientation_seconds(const OrientationCase& values);
/// Makes the report from the files of a result folder.
ReportDocument report_orientation(const OrientationCase& values, const ResultFolder& folder);

}  // namespace fiberfate
