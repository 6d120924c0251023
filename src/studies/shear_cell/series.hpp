// Measures what series.csv of the study shear_cell records at every output time.
#pragma once

#include <string>
#include <vector>

#include "dynamics/simulation.hpp"
#include "studies/shear_cell/case.hpp"

namespace fiberfate {

/// Names the columns; each name ends in its unit (docs/formats/series.md).
[[nodiscard]] std::vector<std::string> shear_cell_columns();

/// Measures one row at the present time.
[[nodiscard]] std::vector<double> shear_cell_row(const ShearCellCase& values, const FlowHistory& flow,
                                                 Simulation& simulation);

/// Names the columns of breaks.csv and fills one row of it.
[[nodiscard]] std::vector<std::string> break_columns();
[[nodiscard]] std::vector<double> break_row(const BreakEvent& event);

/// Radius of curvature that counts as critical: the one below which the law breaks every hinge; without
/// breakage critical_radius, m.
[[nodiscard]] double critical_radius(const BreakageParameters& breakage);

/// Shear strain from the start until `time`, the integral of the rate.
[[nodiscard]] double shear_strain(const FlowHistory& flow, double time);

}  // namespace fiberfate
