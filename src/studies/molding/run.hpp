// Runs the study molding.
#pragma once

#include "molding/structural_input.hpp"
#include "studies/molding/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Fills the mold: tables series, profiles, places and sweep, frames result, layers and properties,
/// checkpoints. Goes on from the last checkpoint where the session does; the result is that of a run that was
/// never interrupted. Raises SimulationFailure with the state saved.
[[nodiscard]] Outcome compute_molding(const MoldingCase& values, Session& session);
/// Makes the report from the files of a result folder.
ReportDocument report_molding(const MoldingCase& values, const ResultFolder& folder);
/// Writes the part with its stiffness for a structural solver to `out`/part.inp. Raises InputError when the
/// case follows no orientation or lengths.
void export_structure(const MoldingCase& values, const ResultFolder& folder, const std::string& out,
                      StructuralSolver solver);

}  // namespace fiberfate
