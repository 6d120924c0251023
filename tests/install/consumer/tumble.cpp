// Lets one fiber tumble in shear with an installed fiberfate and checks that it turned.
#include <cstdio>
#include <vector>

#include "dynamics/simulation.hpp"

int main() {
  using namespace fiberfate;
  FiberState state;
  state.cell = rectangular_cell(Vec3::Constant(1e-2));
  state.materials = {{.radius = 9.5e-6, .youngs_modulus = 73e9, .density = 2550}};
  const std::vector<Vec3> nodes = {Vec3(0, -5e-4, 0), Vec3(0, 0, 0), Vec3(0, 5e-4, 0)};
  append_fiber(state, {.nodes = nodes, .material_id = 0});
  Simulation simulation(DynamicsParameters{}, FlowHistory::constant(10, 200), state);
  while (simulation.state().time < 0.1) simulation.advance(0.1);
  // A slender fiber follows the fluid: after a strain of one it lies at 45 degrees.
  const Vec3 axis = simulation.state().position.back() - simulation.state().position.front();
  std::printf("%.3f\n", axis.x() / axis.y());
  return axis.x() / axis.y() > 0.9 && axis.x() / axis.y() < 1.1 ? 0 : 1;
}
