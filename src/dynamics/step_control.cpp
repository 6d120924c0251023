// Bounds, accepts and adapts time steps.
#include "dynamics/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fibers/neighbour_list.hpp"

namespace fiberfate {
namespace {

constexpr double acceptance = 2.0;    // errors up to this many tolerances are kept
constexpr double safety = 0.9;        // aims a little below the tolerance
constexpr double least_factor = 0.3;  // a step shrinks at most to this
constexpr double most_factor = 1.25;  // a step grows at most to this
constexpr double event_slack = 1e-9;  // relative round-off of times

/// The factor by which a step would have to change for its error to be the tolerance: the error is of
/// second order in its size.
double unbounded_factor(const StepParameters& parameters, double error) {
  if (!std::isfinite(error)) return 0;
  if (error <= 0) return std::numeric_limits<double>::infinity();
  return safety * std::sqrt(parameters.tolerance / error);
}

}  // namespace

StepChoice propose_step(const StepParameters& parameters, double proposal, const Flow& flow,
                        double to_event) {
  StepChoice choice{proposal, StepLimit::tolerance};
  if (parameters.control == StepControl::fixed) {
    choice = {parameters.initial, StepLimit::control};
  } else {
    const double rate = 2 * principal_rate(flow);
    if (rate * choice.size > parameters.maximum_strain)
      choice = {parameters.maximum_strain / rate, StepLimit::strain};
    if (choice.size > parameters.maximum) choice = {parameters.maximum, StepLimit::maximum};
  }
  if (std::isinf(to_event)) return choice;
  const double steps = std::max(1.0, std::ceil(to_event / choice.size - event_slack));
  if (steps < 1.5 && to_event < choice.size * (1 - event_slack)) choice.limit = StepLimit::event;
  choice.size = to_event / steps;
  return choice;
}

bool is_acceptable(const StepParameters& parameters, double error) {
  if (!std::isfinite(error)) return false;
  return parameters.control == StepControl::fixed || error <= acceptance * parameters.tolerance;
}

double shrunk_step(const StepParameters& parameters, double step, double error) {
  return step * std::clamp(unbounded_factor(parameters, error), least_factor, 0.7);
}

double next_proposal(const StepParameters& parameters, const StepChoice& accepted, double proposal,
                     double error) {
  if (parameters.control == StepControl::fixed) return parameters.initial;
  const double wanted = accepted.size * unbounded_factor(parameters, error);
  const bool says_nothing = accepted.limit == StepLimit::event;  // a step that an event cut short
  // Steps before an event are cut to equal parts: growth is bounded by what was proposed, not by the part, or
  // a proposal could never pass from four parts to three.
  const double begin = says_nothing ? accepted.size : std::max(proposal, accepted.size);
  const double next = std::clamp(wanted, least_factor * accepted.size, most_factor * begin);
  return std::clamp(says_nothing ? std::max(next, proposal) : next, parameters.minimum, parameters.maximum);
}

const char* name(StepLimit limit) {
  switch (limit) {
    case StepLimit::tolerance:
      return "tolerance";
    case StepLimit::strain:
      return "strain";
    case StepLimit::maximum:
      return "maximum";
    case StepLimit::event:
      return "event";
    default:
      return "fixed";
  }
}

}  // namespace fiberfate
