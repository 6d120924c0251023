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
    if (cell.boundary[i] != Boundary::walls) continue;
    const Vec3 normal = cell.lattice.inverse().row(i).transpose().normalized();
    walls.push_back({normal, 0});
    walls.push_back({-normal, -cell.height(i)});
  }
  return walls;
}

void add_fiber(const FiberState& state, const Wall& wall, FiberIndex fiber,
               std::vector<WallContact>& contacts) {
  for (const NodeIndex node : state.nodes(fiber)) {
    const RodIndex rod = node == state.last_node(fiber) ? rod_before(node) : rod_after(node);
    const double height = wall.normal.dot(state.position[node]) - wall.offset;
    if (height < diameters_away * state.material(fiber).diameter())
      contacts.push_back({node, rod, wall.normal, height, state.material_id[fiber]});
  }
}

}  // namespace

std::vector<WallContact> find_wall_contacts(const FiberState& state) {
  std::vector<WallContact> contacts;
  for (const Wall& wall : walls_of(state.cell)) {
    for (const FiberIndex fiber : state.fibers()) add_fiber(state, wall, fiber, contacts);
  }
  return contacts;
}

}  // namespace fiberfate
