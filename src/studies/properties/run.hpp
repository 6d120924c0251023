// Runs the study properties.
#pragma once

#include "studies/properties/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Runs a case into an empty result folder: summary.json, modulus.csv.
StopReason run_properties(const PropertiesCase& values, const RunOptions& options, ResultFolder& folder);
/// Runs it again: it takes a moment, so that nothing is kept of an interrupted run.
StopReason resume_properties(const PropertiesCase& values, const RunOptions& options, ResultFolder& folder);
/// Gathers what the report shows from the files of a result folder.
ReportDocument report_properties(const PropertiesCase& values, const ResultFolder& folder);

}  // namespace fiberfate
