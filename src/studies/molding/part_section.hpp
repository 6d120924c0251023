// The picture of a part in its report.
#pragma once

#include "results/report_document.hpp"
#include "results/result_folder.hpp"
#include "studies/molding/case.hpp"

namespace fiberfate {

/// Shows the part while it fills, from result.vtkhdf, and what its last state holds: gates, places, weld
/// lines, orientation, layers, axes of stiffness. Raises StorageError.
[[nodiscard]] ShellSection part_section(const MoldingCase& values, const ResultFolder& folder);

}  // namespace fiberfate
