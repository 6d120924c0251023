// A case of the study orientation: fibers that turn in a homogeneous flow history.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continuum/orientation_history.hpp"
#include "keys/case_checker.hpp"
#include "keys/law_choice.hpp"
#include "studies/flow_choices.hpp"
#include "studies/run_choices.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// What the flow is.
enum class OrientationFlow { shear, planar, uniaxial, biaxial, mixed, gradient, table };

/// Whether the distribution function is solved beside the tensor equation.
enum class DistributionChoice { no, yes };

/// Whether the steady state is found beside the run.
enum class SteadyChoice { no, yes };

/// [flow].
struct OrientationFlowChoices {
  OrientationFlow kind = OrientationFlow::shear;
  std::optional<double> rate;  ///< sqrt(2 D:D) of shear or elongation, 1/s
  std::optional<double>
      elongation_rate;  ///< of kind mixed: stretching along x, shrinking along the gradient, 1/s
  ShearGradient shear_gradient = ShearGradient::y;
  std::vector<std::vector<double>> gradient;  ///< one row of nine numbers, 1/s
  std::vector<std::vector<double>> table;     ///< rows (time s, nine numbers 1/s)
  HistoryForm form = HistoryForm::steps;
  double temperature = 523.15;  ///< K, for [melt]
  double pressure = 0;          ///< Pa, for [melt]
};

/// [fibers].
struct OrientationFiberChoices {
  Mat3 orientation = Mat3::Identity() / 3;
  std::optional<double> aspect_ratio;     ///< not given: slender
  double potential = 0;                   ///< U_0
  std::optional<double> volume_fraction;  ///< with aspect_ratio gives the fiber term
  std::optional<double> fiber_term;       ///< phi N_p of the stress (thesis 2.12)
  std::optional<double> trouton_term;     ///< R of the informed viscosity (2.11); not given: the fiber term
};

/// [solution].
struct OrientationSolutionChoices {
  std::string closure = "ibof";
  double tolerance = 1e-8;
  DistributionChoice distribution = DistributionChoice::no;
  SteadyChoice steady = SteadyChoice::no;
  std::int64_t degree = 40;
};

struct OrientationCase {
  LawChoice diffusion = {"", {{"C_I", 0.01}}};  ///< 0.01 is in the middle of what is measured
  LawChoice retardation = {"none", {}};
  LawChoice melt;  ///< viscosity of the matrix; no name: stress is not computed
  OrientationFlowChoices flow;
  OrientationFiberChoices fibers;
  OrientationSolutionChoices solution;
  RunChoices run;  ///< duration
  SeriesChoices output;
};

void describe_orientation(KeyTable& table, OrientationCase& values);
void validate_orientation(const OrientationCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_orientation(const OrientationCase& values);

/// Lists the rotary diffusions, and the retardations, of their registry.
[[nodiscard]] const LawMenu& diffusion_menu();
[[nodiscard]] const LawMenu& retardation_menu();

/// phi N_p: as given, or of semi-dilute fibers of the given volume fraction and aspect ratio.
[[nodiscard]] double fiber_term(const OrientationFiberChoices& fibers);

/// Makes what a valid case asks for.
[[nodiscard]] OrientationModel orientation_model(const OrientationCase& values);
[[nodiscard]] FlowHistory gradient_history(const OrientationFlowChoices& flow);

}  // namespace fiberfate
