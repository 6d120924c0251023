// Makes the chains that are packed from a request, cuts them in other numbers of rods, and makes a state of
// them.
#include "packing/chain_shapes.hpp"

#include <algorithm>
#include <limits>

#include "base/random.hpp"

namespace fiberfate {
namespace {

/// Point at share x of a fiber's length on the Catmull-Rom spline through its nodes, continued straight at
/// the ends.
Vec3 point_on(const Chains& chains, std::size_t fiber, double x) {
  const auto begin = static_cast<std::ptrdiff_t>(chains.begin_node(fiber));
  const auto last = static_cast<std::ptrdiff_t>(chains.end_node(fiber)) - 1;
  const auto node = [&](std::ptrdiff_t k) -> Vec3 {
    const auto at = [&](std::ptrdiff_t i) { return chains.position[static_cast<std::size_t>(i)]; };
    if (k < begin) return 2 * at(begin) - at(begin + 1);
    if (k > last) return 2 * at(last) - at(last - 1);
    return at(k);
  };
  const double place = x * static_cast<double>(last - begin);
  const std::ptrdiff_t k = std::min(begin + static_cast<std::ptrdiff_t>(place), last - 1);
  const double t = place - static_cast<double>(k - begin);
  const Vec3 a = node(k - 1), b = node(k), c = node(k + 1), d = node(k + 2);
  return b + 0.5 * t * ((c - a) + t * ((2 * a - 5 * b + 4 * c - d) + t * (3 * b - a - 3 * c + d)));
}

}  // namespace

double thickest_diameter(const PackingRequest& request) {
  double thickest = 0;
  for (const FiberBlank& fiber : request.fibers)
    thickest = std::max(thickest, request.materials[fiber.material_id].diameter());
  return thickest;
}

Chains straight_chains(const PackingRequest& request, std::span<const Vec3> directions) {
  const double unit = thickest_diameter(request);
  Chains chains;
  chains.cell = request.cell;
  chains.cell.lattice /= unit;
  for (std::size_t f = 0; f < request.fibers.size(); ++f) {
    const FiberBlank& fiber = request.fibers[f];
    const auto u = uniform4(request.seed, RandomStream::position, {static_cast<std::uint32_t>(f), 0, 0});
    const Vec3 centre = chains.cell.lattice * Vec3(u[0], u[1], u[2]);
    const Vec3 half = 0.5 * fiber.length / unit * directions[f];
    chains.position.push_back(centre - half);
    chains.position.push_back(centre + half);
    chains.first_node.push_back(static_cast<Index>(chains.position.size()));
    chains.rod_length.push_back(fiber.length / unit);
    chains.radius.push_back(request.materials[fiber.material_id].radius / unit);
    chains.bending_stiffness.push_back(0);
  }
  return chains;
}

Chains divide_chains(const Chains& chains, const PackingRequest& request,
                     const std::function<Index(const FiberBlank&)>& rods_of) {
  const double unit = thickest_diameter(request);
  double stiffest = 0;
  for (const FiberMaterial& material : request.materials)
    stiffest = std::max(stiffest, material.bending_stiffness());
  Chains divided;
  divided.cell = chains.cell;
  divided.radius = chains.radius;
  for (std::size_t f = 0; f < request.fibers.size(); ++f) {
    const FiberBlank& fiber = request.fibers[f];
    const Index rods = rods_of(fiber);
    for (Index k = 0; k <= rods; ++k)
      divided.position.push_back(point_on(chains, f, static_cast<double>(k) / rods));
    divided.first_node.push_back(static_cast<Index>(divided.position.size()));
    const double length = fiber.length / unit / rods;
    divided.rod_length.push_back(length);
    const double stiffness = request.materials[fiber.material_id].bending_stiffness();
    divided.bending_stiffness.push_back((stiffest > 0 ? stiffness / stiffest : 1) /
                                        (length * length * length));
  }
  return divided;
}

FiberState state_of(const Chains& chains, const PackingRequest& request) {
  const double unit = thickest_diameter(request);
  FiberState state;
  state.materials = request.materials;
  state.cell = request.cell;
  std::vector<Vec3> nodes;
  for (std::size_t f = 0; f < chains.rod_length.size(); ++f) {
    const FiberBlank& fiber = request.fibers[f];
    nodes.clear();
    for (std::size_t k = chains.begin_node(f); k < chains.end_node(f); ++k)
      nodes.push_back(unit * chains.position[k]);
    append_fiber(state, {nodes, fiber.material_id});
    for (std::size_t k = chains.begin_node(f); k + 1 < chains.end_node(f); ++k)
      state.rod_length[k] = fiber.length / fiber.rods;
  }
  wrap_fibers(state);
  return state;
}

double mean_radius(const Chains& chains) {
  double sum = 0;
  std::int64_t hinges = 0;
  for (std::size_t f = 0; f < chains.rod_length.size(); ++f) {
    const double squared = chains.rod_length[f] * chains.rod_length[f];
    for (std::size_t k = chains.begin_node(f) + 1; k + 1 < chains.end_node(f); ++k) {
      sum += (chains.position[k + 1] - 2 * chains.position[k] + chains.position[k - 1]).norm() / squared;
      ++hinges;
    }
  }
  return sum > 0 ? static_cast<double>(hinges) / sum : std::numeric_limits<double>::infinity();
}

}  // namespace fiberfate
