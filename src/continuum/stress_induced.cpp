// Evaluates the stress-induced law and solves it for its constants.
#include "continuum/stress_induced.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

bool positive_and_finite(double x) {
  return x > 0 && std::isfinite(x);
}

void check_run(const SteadyAttrition& run) {
  if (!positive_and_finite(run.rate) || !positive_and_finite(run.viscosity) ||
      !positive_and_finite(run.relaxation.rate_constant) ||
      !positive_and_finite(run.relaxation.equilibrium_length))
    throw InputError("a run has a rate, viscosity, rate constant or final length that is not positive",
                     "give all four as positive numbers");
}

struct Point {
  double x, y;
};

/// Slope of ln y over ln x through two points.
double slope(const Point& first, const Point& second, const char* abscissa) {
  if (first.x == second.x)
    throw InputError(std::string("the two runs have the same ") + abscissa,
                     "an exponent needs runs at two different speeds");
  return std::log(first.y / second.y) / std::log(first.x / second.x);
}

}  // namespace

LengthRelaxation StressInduced::operator()(const LengthFlow& flow) const {
  const double ratio = flow.viscosity * flow.rate / strength;
  if (!(ratio > 0)) return {0, HUGE_VAL};
  return {k_0 * std::pow(ratio, beta), lambda * diameter * std::pow(ratio, -alpha)};
}

double interaction_coefficient(const SteadyAttrition& run, double alpha, double strength, double diameter) {
  check_run(run);
  require_number("alpha", alpha, any_finite);
  require_number("strength", strength, positive);
  require_number("diameter", diameter, positive);
  return run.relaxation.equilibrium_length / diameter /
         std::pow(strength / (run.viscosity * run.rate), alpha);
}

StressInduced solve_stress_induced(const std::array<SteadyAttrition, 2>& runs, double strength,
                                   double diameter) {
  for (const SteadyAttrition& run : runs) check_run(run);
  require_number("strength", strength, positive);
  require_number("diameter", diameter, positive);
  const auto& [first, second] = runs;
  const double stress = first.viscosity * first.rate;
  const double other_stress = second.viscosity * second.rate;
  const double alpha = -slope({stress, first.relaxation.equilibrium_length},
                              {other_stress, second.relaxation.equilibrium_length}, "shear stress");
  const double beta = slope({stress, first.relaxation.rate_constant},
                            {other_stress, second.relaxation.rate_constant}, "shear stress");
  const double k_0 = first.relaxation.rate_constant / std::pow(stress / strength, beta);
  return {interaction_coefficient(first, alpha, strength, diameter), alpha, k_0, beta, strength, diameter};
}

double rate_exponent(const std::array<SteadyAttrition, 2>& runs) {
  for (const SteadyAttrition& run : runs) check_run(run);
  return slope({runs[0].rate, runs[0].relaxation.rate_constant},
               {runs[1].rate, runs[1].relaxation.rate_constant}, "shear rate");
}

}  // namespace fiberfate
