// Draws and carries out breaks.
#include "dynamics/breakage.hpp"

#include <optional>

#include "dynamics/breakage_laws/breakage_registry.hpp"

namespace fiberfate {
namespace {

/// The sharpest hinge of a fiber that is to break.
struct Worst {
  NodeIndex node;
  double radius;
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

HingeName name_of(const FiberState& state, FiberIndex fiber, NodeIndex node) {
  const auto offset = static_cast<std::uint32_t>(node - state.begin_node(fiber));
  return {state.birth_id[fiber], state.birth_node[fiber] + offset};
}

std::optional<Worst> worst_breaking_hinge(const FiberState& state, const HingeCheck& check,
                                          FiberIndex fiber) {
  std::optional<Worst> worst;
  for (const NodeIndex node : state.hinges(fiber)) {
    const double radius = hinge_radius(state, node);
    if (worst && radius >= worst->radius) continue;
    if (check.breaks(name_of(state, fiber, node), radius)) worst = {node, radius};
  }
  return worst;
}

BreakEvent event_of(const FiberState& state, FiberIndex fiber, const Worst& worst) {
  double child = 0;
  for (const RodIndex rod : state.rods(fiber)) {
    if (rod < rod_after(worst.node)) child += state.rod_length[rod];
  }
  const HingeName name = name_of(state, fiber, worst.node);
  return {state.time, name.birth_id, name.birth_node, worst.radius, fiber_length(state, fiber), child};
}

}  // namespace

std::vector<NodeIndex> check_breakage(FiberState& state, const DynamicsParameters& parameters,
                                      std::vector<BreakEvent>& events) {
  const HingeCheck check(state, parameters);
  std::vector<NodeIndex> nodes;
  for (const FiberIndex fiber : state.fibers()) {
    const auto worst = worst_breaking_hinge(state, check, fiber);
    if (!worst) continue;
    nodes.push_back(worst->node);
    events.push_back(event_of(state, fiber, *worst));
  }
  split_fibers(state, nodes);
  ++state.breakage_checks;
  return nodes;
}

}  // namespace fiberfate
