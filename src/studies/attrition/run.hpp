// Runs the study attrition.
#pragma once

#include "studies/attrition/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Follows the lengths through the history of flow: tables series and histogram.
[[nodiscard]] Outcome compute_attrition(const AttritionCase& values, Session& session);
/// The memory that a run takes, the program with it, bytes.
[[nodiscard]] double attrition_bytes(const AttritionCase& values);
/// Foretells the wall seconds of compute_attrition from a trial of a fraction of a second.
[[nodiscard]] double attrition_seconds(const AttritionCase& values);
/// Makes the report from the files of a result folder.
ReportDocument report_attrition(const AttritionCase& values, const ResultFolder& folder);

}  // namespace fiberfate
