// Draws and carries out breaks.
#include "dynamics/breakage.hpp"

#include "dynamics/breakage_laws/breakage_registry.hpp"

namespace fiberfate {
namespace {

/// The sharpest hinge of a fiber that is to break.
struct Worst {
  Index node = -1;
  double radius = 0;
};

/// Whether a hinge breaks at the state's present check.
class HingeCheck {
 public:
  HingeCheck(const FiberState& state, const DynamicsParameters& parameters)
      : law_(breakage_law_named(parameters.breakage.law)),
        parameters_(parameters),
        check_(state.breakage_checks) {}
  [[nodiscard]] bool breaks(const HingeName& name, double radius) const {
    return law_.breaks(parameters_.breakage, {radius, name, check_, parameters_.seed});
  }

 private:
  const BreakageRow& law_;
  const DynamicsParameters& parameters_;
  std::int64_t check_;
};

Worst worst_breaking_hinge(const FiberState& state, const HingeCheck& check, Index fiber) {
  Worst worst;
  const auto f = static_cast<std::size_t>(fiber);
  for (Index k = state.begin_node(fiber) + 1; k + 1 < state.end_node(fiber); ++k) {
    const auto n = static_cast<std::size_t>(k);
    const double radius = hinge_radius(state.position[n - 1], state.position[n], state.position[n + 1]);
    if (worst.node >= 0 && radius >= worst.radius) continue;
    const auto offset = static_cast<std::uint32_t>(k - state.begin_node(fiber));
    const HingeName hinge{state.birth_id[f], state.birth_node[f] + offset};
    if (check.breaks(hinge, radius)) worst = {k, radius};
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

void check_breakage(FiberState& state, const DynamicsParameters& parameters,
                    std::vector<BreakEvent>& events) {
  const HingeCheck check(state, parameters);
  std::vector<Index> nodes;
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    const Worst worst = worst_breaking_hinge(state, check, fiber);
    if (worst.node < 0) continue;
    nodes.push_back(worst.node);
    events.push_back(event_of(state, fiber, worst));
  }
  split_fibers(state, nodes);
  ++state.breakage_checks;
}

}  // namespace fiberfate
