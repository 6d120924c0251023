// Runs the study cluster.
#pragma once

#include "studies/cluster/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Packs the fibers and leaves them as a frame and a checkpoint.
[[nodiscard]] Outcome compute_cluster(const ClusterCase& values, Session& session);
/// Makes the report from the files of a result folder.
ReportDocument report_cluster(const ClusterCase& values, const ResultFolder& folder);

}  // namespace fiberfate
