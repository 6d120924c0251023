// Runs the study shear_cell.
#pragma once

#include "studies/shear_cell/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Shears the cell: tables series and breaks, frames, checkpoints. Goes on from the last checkpoint where
/// the session does; the result is that of a run that was never interrupted. Raises SimulationFailure with
/// the state saved.
[[nodiscard]] Outcome compute_shear_cell(const ShearCellCase& values, Session& session);
/// Makes the report from the files of a result folder.
ReportDocument report_shear_cell(const ShearCellCase& values, const ResultFolder& folder);

}  // namespace fiberfate
