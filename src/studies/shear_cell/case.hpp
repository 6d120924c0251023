// A case of the study shear_cell: fibers in a periodic cell of sheared melt.
#pragma once

#include <vector>

#include "dynamics/parameters.hpp"
#include "keys/case_checker.hpp"
#include "studies/run_choices.hpp"
#include "studies/sample/case.hpp"
#include "studies/shear_cell/cell_flow.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// [output]: what is kept, and how often.
struct OutputChoices : SeriesChoices {
  std::optional<double>
      frame_interval;  ///< simulated time between frames of result.vtkhdf, s; not given: duration/50
  double checkpoint_interval = 300;     ///< wall time between checkpoints, s
  std::vector<double> histogram_times;  ///< s; empty: the start and the end
  double length_bin = 0.1e-3;           ///< width of the bins of the length histogram, m
  double radius_bin = 25e-6;            ///< width of the bins of the histogram of radii of curvature, m
  double near_critical = 50e-6;         ///< hinges within this of the critical radius are counted, m
  std::int64_t stress_steps = 50;       ///< steps between two readings of the particle stress; 0: no reading
  std::optional<double>
      stationary_from;  ///< start of the time over which stresses are averaged, s; not given: half
};

struct ShearCellCase {
  SampleCase sample;
  FlowChoices flow;
  BoundaryChoices boundary;
  DynamicsParameters dynamics;  ///< [drag], [contact], [breakage] and [step]; the seed is run.seed
  OutputChoices output;
  RunChoices run;
};

void describe_shear_cell(KeyTable& table, ShearCellCase& values);
/// The keys of [drag], [hinge], [contact], [breakage] and [step].
void describe_dynamics(KeyTable& table, DynamicsParameters& dynamics);
/// The keys of [output] that say how often runs are saved, and what of the stress is read and averaged.
[[nodiscard]] KeyRows<OutputChoices> checkpoint_rows();
[[nodiscard]] KeyRows<OutputChoices> stress_rows();
void validate_shear_cell(const ShearCellCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_shear_cell(const ShearCellCase& values);

/// What the motion of fibers takes, with the seed of the run.
[[nodiscard]] DynamicsParameters dynamics_parameters(const ShearCellCase& values);
/// Radius of curvature that counts as critical: that of the law `fixed`, or the one below which the other
/// laws break every hinge, m.
[[nodiscard]] double critical_radius(const BreakageParameters& breakage);
/// The simulated time between frames of result.vtkhdf, s.
[[nodiscard]] double frame_interval(const ShearCellCase& values);
/// The simulated time from which on stresses are averaged, s.
[[nodiscard]] double stationary_from(const ShearCellCase& values);

}  // namespace fiberfate
