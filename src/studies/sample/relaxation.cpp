// Runs the dynamics on packed fibers until they are relaxed.
#include "studies/sample/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "dynamics/simulation.hpp"
#include "fibers/observables.hpp"
#include "studies/sample/start.hpp"

namespace fiberfate {
namespace {

constexpr int checks = 200;  ///< over the whole duration

/// Forgets that the fibers moved: the result is a beginning.
FiberState begin_again(FiberState state) {
  const FiberState fresh;
  std::fill(state.relative_velocity.begin(), state.relative_velocity.end(), Vec3::Zero());
  state.time = fresh.time;
  state.step_size = fresh.step_size;
  state.step = fresh.step;
  state.rod_steps = fresh.rod_steps;
  return state;
}

}  // namespace

const char* name(RelaxationEnd end) {
  switch (end) {
    case RelaxationEnd::met:
      return "met";
    case RelaxationEnd::time_over:
      return "time_over";
    case RelaxationEnd::orientation_bound:
      return "orientation_bound";
  }
  return "";
}

void describe_relaxation(KeyTable& table, RelaxationChoices& choices) {
  using Relaxation = RelaxationChoices;
  const KeyGroup<Relaxation> keys = {
      "relaxation",
      "Dynamics after packing: a slow shear with contact and without breakage, until no overlap and no bend "
      "is worse than wanted.",
      {
          key("duration", &Relaxation::duration, {"s", "ms"}, Range::positive(1000),
              "Most simulated time; not given: the packing is kept as it is.", optional("\"20 ms\""),
              "thesis sections 3.2.1 and 3.3.3"),
          key("rate", &Relaxation::rate, {"1/s"}, Range::between(0, 1e4),
              "Shear rate meanwhile; 0 lets the fibers come to rest."),
          key("viscosity", &Relaxation::viscosity, {"Pa s"}, {0, 1e9, Range::Ends::open_low},
              "Viscosity of the matrix meanwhile.", {}, "thesis table 3"),
          key("overlap", &Relaxation::overlap, {}, Range::positive(1),
              "Largest overlap of two fibers that ends it, in diameters."),
          key("minimum_radius", &Relaxation::minimum_radius, {"m", "um"}, Range::not_negative(),
              "Smallest radius of curvature that ends it; 0: any."),
          key("orientation_bound", &Relaxation::orientation_bound, {}, Range::positive(1),
              "Most that any component of the orientation tensor may change meanwhile."),
      }};
  describe(table, keys, choices);
}

void validate_relaxation(const RelaxationChoices& choices, CaseChecker& checker) {
  if (!choices.duration)
    checker.warn_unused({"relaxation.rate", "relaxation.viscosity", "relaxation.overlap",
                         "relaxation.minimum_radius", "relaxation.orientation_bound"},
                        "relaxation.duration");
}

RelaxedFibers relax_fibers(const RelaxationChoices& choices, const ContactParameters& contact,
                           const FiberState& start, const Session& session) {
  DynamicsParameters parameters;
  parameters.contact = contact;
  const double duration = choices.duration.value_or(0);
  parameters.step.maximum = std::min(parameters.step.maximum, duration / checks);
  parameters.step.initial = std::min(parameters.step.initial, parameters.step.maximum);
  Simulation simulation(parameters, FlowHistory::constant(choices.rate, choices.viscosity), start);
  const Mat3 orientation = orientation_tensor(start, Weighting::length);
  RelaxedFibers relaxed{start, RelaxationEnd::time_over, 0, 0};
  for (int check = 0; check <= checks; ++check) {
    const double until = duration * check / checks;
    while (simulation.state().time < until) {
      session.end_if_stopped(packing_stopped);
      static_cast<void>(simulation.advance(until));
    }
    const FiberState& state = simulation.state();
    const double drift = (orientation_tensor(state, Weighting::length) - orientation).cwiseAbs().maxCoeff();
    if (drift > choices.orientation_bound) {
      relaxed.end = RelaxationEnd::orientation_bound;
      break;
    }
    const double overlap = simulation.contact_statistics().max_overlap / 2, radius = minimum_radius(state);
    relaxed = {state, RelaxationEnd::time_over, state.time, drift};
    session.show([&] {
      return fmt::format(
          "relaxing: {:.4g} ms, largest overlap {:.3g} diameters, smallest radius {:.4g} um, "
          "orientation changed by {:.2g}",
          1e3 * state.time, overlap, 1e6 * radius, drift);
    });
    if (overlap > choices.overlap || radius < choices.minimum_radius) continue;
    relaxed.end = RelaxationEnd::met;
    break;
  }
  session.end_progress();
  relaxed.state = begin_again(std::move(relaxed.state));
  return relaxed;
}

}  // namespace fiberfate
