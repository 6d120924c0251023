// Runs the study attrition.
#pragma once

#include "studies/attrition/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Runs a case into an empty result folder: series.csv, histogram.csv, summary.json.
StopReason run_attrition(const AttritionCase& values, const RunOptions& options, ResultFolder& folder);
/// Runs it again: it takes a moment, so that nothing is kept of an interrupted run.
StopReason resume_attrition(const AttritionCase& values, const RunOptions& options, ResultFolder& folder);
/// Gathers what the report shows from the files of a result folder.
ReportDocument report_attrition(const AttritionCase& values, const ResultFolder& folder);

}  // namespace fiberfate
