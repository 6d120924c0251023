// Runs the study cluster.
#pragma once

#include "studies/cluster/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Runs a case into an empty result folder.
StopReason run_cluster(const ClusterCase& values, const RunOptions& options, ResultFolder& folder);
/// Continues from the folder's last checkpoint.
StopReason resume_cluster(const ClusterCase& values, const RunOptions& options, ResultFolder& folder);
/// Gathers what the report shows from the files of a result folder.
ReportDocument report_cluster(const ClusterCase& values, const ResultFolder& folder);

}  // namespace fiberfate
