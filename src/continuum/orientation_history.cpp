// Integrates orientation laws through flow histories.
#include "continuum/orientation_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/principal_axes_steps.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/eigenframe.hpp"

namespace fiberfate {
namespace {

/// Weighs the components so that their Euclidean norm is that of the tensor, which no rotation changes.
Vec6 weighed(const Mat3& tensor) {
  return to_components(tensor).cwiseProduct(Eigen::Map<const Vec6>(multiplicity_of).cwiseSqrt());
}

Mat3 unweighed(const Vec6& components) {
  return to_matrix(components.cwiseQuotient(Eigen::Map<const Vec6>(multiplicity_of).cwiseSqrt()));
}

/// Principal values below this are left to the closure; round-off of planar states stays above.
constexpr double tolerated_negative_value = 1e-12;
/// Explicit steps of an interval after which a law that acts on principal values goes on with
/// PrincipalAxesSteps.
constexpr std::int64_t most_explicit_steps = 2000;

}  // namespace

OrientationIntegrator::OrientationIntegrator(OrientationLaw law, FlowHistory history,
                                             const OrientationState& start, IntegrationTolerance tolerance)
    : law_(std::move(law)), history_(std::move(history)), state_(start), tolerance_(tolerance) {
  require_steps(history_);
  require_number("tolerance.absolute", tolerance.absolute, not_negative);
  require_number("tolerance.relative", tolerance.relative, not_negative);
  require_number("tolerance", tolerance.absolute + tolerance.relative, positive);
  require_number("time", start.time, not_negative);
  const std::string fault = fault_of(start.second, 1e-6);
  if (!fault.empty())
    throw InputError("the initial orientation tensor is impossible: " + fault,
                     "give a symmetric tensor of unit trace without negative principal values");
  state_.second = nearest_admissible(start.second);
}

void OrientationIntegrator::advance_to(double time) {
  require_number("time", time, {.lower = state_.time});
  while (state_.time < time) {
    const double end = std::min(time, history_.next_change(state_.time));
    const Flow flow = history_.at(state_.time);
    const double span = end - state_.time;
    if (!advance_over(flow.gradient, span))
      throw SimulationFailure(
          fmt::format(
              "the orientation cannot be followed from {:g} s to {:g} s, {:.3g} units of strain, in {} "
              "steps within the tolerance",
              state_.time, end, span * flow.shear_rate(), tolerance_.most_steps),
          {.step = record_.accepted, .time = state_.time});
    state_.time = end;
  }
}

bool OrientationIntegrator::advance_over(const Mat3& gradient, double duration) {
  if (acts_on_principal_values(law_.model().retardation)) {
    const std::int64_t few = std::min(tolerance_.most_steps, most_explicit_steps);
    if (advance_explicitly(gradient, duration, few) || advance_axes(gradient, duration)) return true;
  }
  return advance_explicitly(gradient, duration, tolerance_.most_steps);
}

bool OrientationIntegrator::advance_explicitly(const Mat3& gradient, double duration,
                                               std::int64_t most_steps) {
  const auto slope = [&](const Vec6& a, Vec6& rate) {
    rate = weighed(law_.unchecked_rate(unweighed(a), gradient));
  };
  std::int64_t projections = 0;
  const auto settle = [&](Vec6& a) {
    const double drift = (a.head<3>().sum() - 1) / 3;
    a.head<3>().array() -= drift;
    const Mat3 second = unweighed(a);
    if (eigenframe(second).values[2] >= -tolerated_negative_value) return false;
    a = weighed(nearest_admissible(second));
    ++projections;
    return true;
  };
  IntegrationTolerance tolerance = tolerance_;
  tolerance.most_steps = most_steps;
  Vec6 a = weighed(state_.second);
  if (!integrate(slope, a, duration, tolerance, record_, settle) || !a.allFinite()) return false;
  projections_ += projections;
  state_.second = unweighed(a);
  return true;
}

bool OrientationIntegrator::advance_axes(const Mat3& gradient, double duration) {
  const double error = tolerance_.absolute + tolerance_.relative * state_.second.norm();
  PrincipalAxesSteps steps(law_.model(), gradient, error);
  Mat3 second = state_.second;
  if (!steps.advance(second, duration, tolerance_.most_steps)) return false;
  state_.second = second;
  record_.accepted += steps.accepted();
  record_.rejected += steps.rejected();
  record_.next_step = 0;  // explicit steps begin anew: they had become tiny
  projections_ += steps.put_back();
  return true;
}

}  // namespace fiberfate
