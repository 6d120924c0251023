// Runs the study shear_cell.
#pragma once

#include "studies/shear_cell/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Runs a case into an empty result folder.
StopReason run_shear_cell(const ShearCellCase& values, const RunOptions& options, ResultFolder& folder);
/// Continues from the folder's last checkpoint.
StopReason resume_shear_cell(const ShearCellCase& values, const RunOptions& options, ResultFolder& folder);
/// Gathers what the report shows from the files of a result folder.
ReportDocument report_shear_cell(const ShearCellCase& values, const ResultFolder& folder);

}  // namespace fiberfate
