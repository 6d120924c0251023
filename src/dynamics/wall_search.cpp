// Measures the height of nodes above the walls.
#include "dynamics/wall_search.hpp"

namespace fiberfate {
namespace {

// Nodes further from a wall than this many diameters cannot reach it in a step.
constexpr double diameters_away = 3;

/// One wall: points x with normal · x = offset.
struct Wall {
  Vec3 normal;
  double offset;
};

std::vector<Wall> walls_of(const Cell& cell) {
  std::vector<Wall> walls;
  for (int i = 0; i < 3; ++i) {
    if (cell.boundary[static_cast<std::size_t>(i)] != Boundary::walls) continue;
    const Vec3 normal = cell.lattice.inverse().row(i).transpose().normalized();
    walls.push_back({normal, 0});
    walls.push_back({-normal, -cell.height(i)});
  }
  return walls;
}

void add_fiber(const FiberState& state, const Wall& wall, Index fiber, std::vector<WallContact>& contacts) {
  const Index end = state.end_node(fiber);
  for (Index k = state.begin_node(fiber); k < end; ++k) {
    const Index rod = k + 1 < end ? k : k - 1;
    const double height = wall.normal.dot(state.position[static_cast<std::size_t>(k)]) - wall.offset;
    if (height < diameters_away * state.material(fiber).diameter())
      contacts.push_back({k, rod, wall.normal, height, state.material_id[static_cast<std::size_t>(fiber)]});
  }
}

}  // namespace

std::vector<WallContact> find_wall_contacts(const FiberState& state) {
  std::vector<WallContact> contacts;
  for (const Wall& wall : walls_of(state.cell)) {
    for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) add_fiber(state, wall, fiber, contacts);
  }
  return contacts;
}

}  // namespace fiberfate
