// Holds a case of the study shear_cell: fibers in a periodic cell of sheared melt.
#pragma once

#include <vector>

#include "dynamics/parameters.hpp"
#include "fibers/cell.hpp"
#include "fibers/flow.hpp"
#include "keys/case_checker.hpp"
#include "keys/key_table.hpp"
#include "studies/sample/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Names how the flow develops.
enum class FlowKind { constant, ramp, table };

/// Holds [flow]: simple shear u_x = rate · y.
struct FlowChoices {
  FlowKind kind = FlowKind::constant;
  std::optional<double> rate;       ///< 1/s
  std::optional<double> viscosity;  ///< of the matrix, Pa s
  double ramp_duration = 1;         ///< s
  int ramp_steps = 10;
  std::vector<std::vector<double>>
      table;  ///< rows (end time s, rate 1/s, viscosity Pa s); the last one lasts
};

/// Holds [output]: what is kept, and how often.
struct OutputChoices {
  std::optional<double> interval;  ///< simulated time between rows of series.csv, s; not given: duration/200
  std::optional<double>
      frame_interval;  ///< simulated time between frames of result.vtkhdf, s; not given: duration/50
  double checkpoint_interval = 300;     ///< wall time between checkpoints, s
  std::vector<double> histogram_times;  ///< s; empty: the start and the end
  double length_bin = 0.1e-3;           ///< width of the bins of the length histogram, m
  double radius_bin = 25e-6;            ///< width of the bins of the histogram of radii of curvature, m
  double near_critical = 50e-6;         ///< hinges within this of the critical radius are counted, m
};

/// Holds [run].
struct RunChoices {
  double duration = 0;  ///< simulated time, s
  int threads = 0;      ///< 0: all that the machine has
};

struct ShearCellCase {
  SampleCase sample;
  FlowChoices flow;
  Boundary boundary_y = Boundary::periodic;
  DynamicsParameters dynamics;  ///< [drag], [contact], [breakage], [step] and run.seed
  OutputChoices output;
  RunChoices run;
};

void describe_shear_cell(KeyTable& table, ShearCellCase& values);
void validate_shear_cell(const ShearCellCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_shear_cell(const ShearCellCase& values);

/// Makes the flow history of a valid case.
[[nodiscard]] FlowHistory flow_history(const FlowChoices& flow);
/// Tells the simulated time between rows of series.csv, s.
[[nodiscard]] double series_interval(const ShearCellCase& values);
/// Tells the simulated time between frames of result.vtkhdf, s.
[[nodiscard]] double frame_interval(const ShearCellCase& values);

}  // namespace fiberfate
