// What the study shear_cell measures at every output time: the columns of series.csv and breaks.csv, the last
// values in summary.json, the charts of the report.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/simulation.hpp"
#include "fibers/observables.hpp"
#include "results/observable.hpp"
#include "studies/shear_cell/case.hpp"

namespace fiberfate {

/// A moment of a cell, with what several observables share.
struct CellMoment {
  const ShearCellCase& values;
  const FiberState& state;
  Flow flow;
  double rate = 0;    ///< of the flow's type, 1/s
  double strain = 0;  ///< the integral of the rate
  double hencky_strain = 0;
  MeanLengths lengths;
  ContactStatistics contacts;
  Mat3 a2, a2_number;                         ///< by length, and every fiber counting one
  Eigen::Matrix<double, 6, 6> a4, a4_number;  ///< likewise
  std::optional<ParticleStress> stress = {};  ///< mean since the row before; nothing where none was read
};

/// Measures the present moment; its contacts do not count as time of the run's phases.
[[nodiscard]] CellMoment moment_of(const ShearCellCase& values, const FlowHistory& flow,
                                   Simulation& simulation);

/// The rows of series.csv (docs/formats/series.md). A new observable is one more row.
[[nodiscard]] const Observables<CellMoment>& cell_observables();
[[nodiscard]] const std::vector<Chart>& cell_charts();
/// The rows of breaks.csv.
[[nodiscard]] const Observables<BreakEvent>& break_observables();

}  // namespace fiberfate
