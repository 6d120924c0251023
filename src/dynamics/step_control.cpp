// Bounds, accepts and adapts time steps.
#include "dynamics/step_control.hpp"

#include <algorithm>
#include <cmath>

#include "fibers/neighbour_list.hpp"

namespace fiberfate {
namespace {

constexpr double acceptance = 2.0;    // errors up to this many tolerances are kept
constexpr double safety = 0.9;        // aims a little below the tolerance
constexpr double least_factor = 0.3;  // a step shrinks at most to this
constexpr double most_factor = 1.25;  // a step grows at most to this
constexpr double event_slack = 1e-9;  // relative round-off of times

double factor(const StepParameters& parameters, double error) {
  if (!std::isfinite(error)) return least_factor;
  if (error <= 0) return most_factor;
  return std::clamp(safety * std::sqrt(parameters.tolerance / error), least_factor, most_factor);
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
  return step * std::min(factor(parameters, error), 0.7);
}

double next_proposal(const StepParameters& parameters, const StepChoice& accepted, double proposal,
                     double error) {
  if (parameters.control == StepControl::fixed) return parameters.initial;
  const double wanted = accepted.size * factor(parameters, error);
  // A step that an event cut short says nothing against the longer one that was proposed.
  const double next = accepted.limit == StepLimit::event ? std::max(wanted, proposal) : wanted;
  return std::clamp(next, parameters.minimum, parameters.maximum);
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
