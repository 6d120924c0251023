// Makes small populations for the tests of module fibers.
#pragma once

#include <vector>

#include "fibers/state.hpp"

namespace fiberfate {

inline FiberState empty_state(const Vec3& cell_size = Vec3(1e-3, 1e-3, 1e-3)) {
  FiberState state;
  state.materials = {{9.5e-6, 73e9, 2550}};
  state.cell = rectangular_cell(cell_size);
  return state;
}

inline void append_straight(FiberState& state, const Vec3& begin, const Vec3& rod, int rods) {
  std::vector<Vec3> nodes;
  for (int k = 0; k <= rods; ++k) nodes.push_back(begin + k * rod);
  append_fiber(state, {nodes, 0});
}

}  // namespace fiberfate
