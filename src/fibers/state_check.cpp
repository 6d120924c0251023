// What a state of fibers must be before anything is computed with it.
#include "fibers/state_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"

namespace fiberfate {
namespace {

std::string name_of(const FiberState& state, FiberIndex fiber) {
  return "fiber " + std::to_string(state.birth_id[fiber]);
}

void require_cell(const Cell& cell) {
  if (!cell.lattice.allFinite() || !(cell.volume() > 0))
    throw InputError("the cell has no volume", "give three finite edges above zero");
}

void require_materials(const FiberState& state) {
  for (const FiberMaterial& material : state.materials) {
    if (!(material.radius > 0) || std::isinf(material.radius))
      throw InputError("a fiber's radius is not positive", "give its diameter");
    if (!(material.youngs_modulus >= 0) || std::isinf(material.youngs_modulus))
      throw InputError("a fiber's Young's modulus is not a number from zero on", "give it in Pa");
  }
  for (const std::uint16_t material : state.material_id) {
    if (material >= state.materials.size())
      throw InputError("a fiber has an unknown material", "name one of the materials that are defined");
  }
}

void require_fiber(const FiberState& state, FiberIndex fiber) {
  const char* remedy = "take a state that was written whole, or make the fibers anew";
  for (const NodeIndex node : state.nodes(fiber)) {
    if (!state.position[node].allFinite())
      throw InputError(name_of(state, fiber) + " has a node that is not finite", remedy);
    if (!state.relative_velocity[node].allFinite())
      throw InputError(name_of(state, fiber) + " has a velocity that is not finite", remedy);
  }
  for (const RodIndex rod : state.rods(fiber)) {
    if (!(state.rod_length[rod] > 0 && std::isfinite(state.rod_length[rod])))
      throw InputError(name_of(state, fiber) + " has a rod without a length", remedy);
  }
}

}  // namespace

void require_sound(const FiberState& state) {
  require_cell(state.cell);
  require_materials(state);
  for (const FiberIndex fiber : state.fibers()) require_fiber(state, fiber);
}

void require_few_images(const FiberState& state, double most) {
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (state.cell.boundary[i] == Boundary::periodic) lowest = std::min(lowest, state.cell.height(i));
  }
  for (const FiberIndex fiber : state.fibers()) {
    const double times = fiber_length(state, fiber) / lowest;
    if (times <= most) continue;
    throw InputError(name_of(state, fiber) + " is " + std::to_string(std::lround(times)) +
                         " times as long as the cell is high",
                     "make the cell larger or the fibers shorter: at most " +
                         std::to_string(std::lround(most)) + " times");
  }
}

}  // namespace fiberfate
