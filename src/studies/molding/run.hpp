// Runs the study molding.
#pragma once

#include "studies/molding/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Runs a case into an empty result folder: series.csv, result.vtkhdf, layers.vtkhdf, properties.vtkhdf,
/// profiles.csv, places.csv, sweep.csv, summary.json, checkpoints. Raises SimulationFailure with the state
/// dumped.
StopReason run_molding(const MoldingCase& values, const RunOptions& options, ResultFolder& folder);
/// Continues from the folder's last checkpoint; the result is that of a run that was never interrupted.
StopReason resume_molding(const MoldingCase& values, const RunOptions& options, ResultFolder& folder);
/// Gathers what the report shows from the files of a result folder.
ReportDocument report_molding(const MoldingCase& values, const ResultFolder& folder);
/// Writes the part with its stiffness for a structural solver to `out`/part.inp and tells its path. Raises
/// InputError when the case follows no orientation or lengths.
std::string export_structure(const MoldingCase& values, const ResultFolder& folder, const std::string& out);

}  // namespace fiberfate
