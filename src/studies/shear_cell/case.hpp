// A case of the study shear_cell: fibers in a periodic cell of sheared melt.
#pragma once

#include <vector>

#include "dynamics/parameters.hpp"
#include "keys/case_checker.hpp"
#include "microstructure/flow_history.hpp"
#include "studies/run_choices.hpp"
#include "studies/sample/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// How the flow develops.
enum class FlowKind { constant, ramp, table };

/// [flow]: simple shear u_x = rate · y.
struct FlowChoices {
  FlowKind kind = FlowKind::constant;
  std::optional<double> rate;       ///< 1/s
  std::optional<double> viscosity;  ///< of the matrix, Pa s
  double ramp_duration = 1;         ///< s
  int ramp_steps = 10;
  std::vector<std::vector<double>>
      table;  ///< rows (end time s, rate 1/s, viscosity Pa s); the last one lasts
};

/// [output]: what is kept, and how often.
struct OutputChoices : SeriesChoices {
  std::optional<double>
      frame_interval;  ///< simulated time between frames of result.vtkhdf, s; not given: duration/50
  double checkpoint_interval = 300;     ///< wall time between checkpoints, s
  std::vector<double> histogram_times;  ///< s; empty: the start and the end
  double length_bin = 0.1e-3;           ///< width of the bins of the length histogram, m
  double radius_bin = 25e-6;            ///< width of the bins of the histogram of radii of curvature, m
  double near_critical = 50e-6;         ///< hinges within this of the critical radius are counted, m
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
void validate_shear_cell(const ShearCellCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_shear_cell(const ShearCellCase& values);

/// What the motion of fibers takes, with the seed of the run.
[[nodiscard]] DynamicsParameters dynamics_parameters(const ShearCellCase& values);
/// Makes the flow history of a valid case.
[[nodiscard]] FlowHistory flow_history(const FlowChoices& flow);
/// Shear strain from the start until `time`, the integral of the rate.
[[nodiscard]] double shear_strain(const FlowHistory& flow, double time);
/// Radius of curvature that counts as critical: that of the law `fixed`, or the one below which the other
/// laws break every hinge, m.
[[nodiscard]] double critical_radius(const BreakageParameters& breakage);
/// The simulated time between frames of result.vtkhdf, s.
[[nodiscard]] double frame_interval(const ShearCellCase& values);

}  // namespace fiberfate
