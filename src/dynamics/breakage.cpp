// Draws and carries out breaks.
#include "dynamics/breakage.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace fiberfate {
namespace {

/// Holds the sharpest hinge of a fiber that is to break.
struct Worst {
  Index node = -1;
  double radius = 0;
};

Worst worst_breaking_hinge(const FiberState& state, const DynamicsParameters& parameters, Index fiber) {
  Worst worst;
  const auto f = static_cast<std::size_t>(fiber);
  for (Index k = state.begin_node(fiber) + 1; k + 1 < state.end_node(fiber); ++k) {
    const auto n = static_cast<std::size_t>(k);
    const double radius = hinge_radius(state.position[n - 1], state.position[n], state.position[n + 1]);
    if (worst.node >= 0 && radius >= worst.radius) continue;
    const auto offset = static_cast<std::uint32_t>(k - state.begin_node(fiber));
    const HingeName hinge{state.birth_id[f], state.birth_node[f] + offset};
    if (breaks(parameters, hinge, state.breakage_checks, radius)) worst = {k, radius};
  }
  return worst;
}

BreakEvent event_of(const FiberState& state, Index fiber, const Worst& worst) {
  const auto f = static_cast<std::size_t>(fiber);
  double child = 0;
  for (Index k = state.begin_node(fiber); k < worst.node; ++k)
    child += state.rod_length[static_cast<std::size_t>(k)];
  const auto offset = static_cast<std::uint32_t>(worst.node - state.begin_node(fiber));
  return {state.time,   state.birth_id[f],          state.birth_node[f] + offset,
          worst.radius, fiber_length(state, fiber), child};
}

}  // namespace

double break_probability(const BreakageParameters& parameters, double radius) {
  const double x = std::clamp(
      (parameters.maximum_radius - radius) / (parameters.maximum_radius - parameters.minimum_radius), 0.0,
      1.0);
  return std::expm1(parameters.exponent * x) / std::expm1(parameters.exponent);
}

double critical_radius(const BreakageParameters& parameters, double u) {
  const double x = std::log1p(u * std::expm1(parameters.exponent)) / parameters.exponent;
  return parameters.maximum_radius - x * (parameters.maximum_radius - parameters.minimum_radius);
}

bool breaks(const DynamicsParameters& parameters, const HingeName& hinge, std::int64_t check, double radius) {
  const BreakageParameters& law = parameters.breakage;
  switch (law.law) {
    case BreakageLaw::none:
      return false;
    case BreakageLaw::fixed:
      return radius < law.critical_radius;
    case BreakageLaw::probability: {
      if (radius >= law.maximum_radius) return false;
      const RandomCounter counter{hinge.birth_id, hinge.birth_node, static_cast<std::uint32_t>(check)};
      return uniform(parameters.seed, RandomStream::breakage, counter) < break_probability(law, radius);
    }
    case BreakageLaw::strength: {
      if (radius >= law.maximum_radius) return false;
      const RandomCounter counter{hinge.birth_id, hinge.birth_node, 0};
      return radius < critical_radius(law, uniform(parameters.seed, RandomStream::hinge_strength, counter));
    }
  }
  return false;
}

void check_breakage(FiberState& state, const DynamicsParameters& parameters,
                    std::vector<BreakEvent>& events) {
  std::vector<Index> nodes;
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    const Worst worst = worst_breaking_hinge(state, parameters, fiber);
    if (worst.node < 0) continue;
    nodes.push_back(worst.node);
    events.push_back(event_of(state, fiber, worst));
  }
  split_fibers(state, nodes);
  ++state.breakage_checks;
}

}  // namespace fiberfate
