// Runs the study attrition.
#pragma once

#include "studies/attrition/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Follows the lengths through the history of flow: tables series and histogram.
[[nodiscard]] Outcome compute_attrition(const AttritionCase& values, Session& session);
/// Makes the report from the files of a result folder.
ReportDocument report_attrition(const AttritionCase& values, const ResultFolder& folder);

}  // namespace fiberfate
