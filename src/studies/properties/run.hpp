// Runs the study properties.
#pragma once

#include "studies/properties/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Predicts the properties: table modulus.
[[nodiscard]] Outcome compute_properties(const PropertiesCase& values, Session& session);
/// Makes the report from the files of a result folder.
ReportDocument report_properties(const PropertiesCase& values, const ResultFolder& folder);

}  // namespace fiberfate
