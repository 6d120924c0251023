// Makes the chains that are packed from a request, cuts them in other numbers of rods, and makes a state of
// them.
#include "packing/chain_shapes.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "base/random.hpp"

namespace fiberfate {
double thickest_diameter(const PackingRequest& request) {
  double thickest = 0;
  for (const FiberBlank& fiber : request.fibers)
    thickest = std::max(thickest, request.materials[fiber.material_id].diameter());
  return thickest;
}

ChainMaker::ChainMaker(const PackingRequest& request, const Cell& cell)
    : request_(request), unit_(thickest_diameter(request)) {
  chains_.cell = cell;
  for (const FiberMaterial& material : request.materials)
    stiffest_ = std::max(stiffest_, material.bending_stiffness());
}

void ChainMaker::append(std::span<const Vec3> nodes) {
  const FiberBlank& fiber = request_.fibers[static_cast<std::size_t>(chains_.fiber_count())];
  const FiberMaterial& material = request_.materials[fiber.material_id];
  const double length = fiber.length / unit_ / static_cast<double>(nodes.size() - 1);
  chains_.position.insert(chains_.position.end(), nodes.begin(), nodes.end());
  chains_.first_node.push_back(static_cast<Index>(chains_.position.size()));
  chains_.rod_length.push_back(length);
  chains_.radius.push_back(material.radius / unit_);
  chains_.swelling.push_back(1);
  chains_.firmness.push_back(1);
  const double stiffness = stiffest_ > 0 ? material.bending_stiffness() / stiffest_ : 1;
  chains_.bending_stiffness.push_back(stiffness / (length * length * length));
}

Chains straight_chains(const PackingRequest& request, std::span<const Vec3> directions) {
  const double unit = thickest_diameter(request);
  Cell cell = request.cell;
  cell.lattice /= unit;
  ChainMaker maker(request, cell);
  for (std::size_t f = 0; f < request.fibers.size(); ++f) {
    const auto u = uniform4(request.seed, RandomStream::position, {static_cast<std::uint32_t>(f), 0, 0});
    const Vec3 centre = cell.lattice * Vec3(u[0], u[1], u[2]);
    const Vec3 half = 0.5 * request.fibers[f].length / unit * directions[f];
    maker.append(std::array<Vec3, 2>{centre - half, centre + half});
  }
  return maker.take();
}

Vec3 point_along(const Chains& chains, std::size_t fiber, double x) {
  const auto begin = static_cast<std::ptrdiff_t>(chains.begin_node(fiber));
  const auto last = static_cast<std::ptrdiff_t>(chains.end_node(fiber)) - 1;
  const auto at = [&](std::ptrdiff_t i) { return chains.position[static_cast<std::size_t>(i)]; };
  const auto node = [&](std::ptrdiff_t k) -> Vec3 {
    if (k < begin) return 2 * at(begin) - at(begin + 1);
    if (k > last) return 2 * at(last) - at(last - 1);
    return at(k);
  };
  const double place = x * static_cast<double>(last - begin);
  if (x < 0) return at(begin) + place * (at(begin + 1) - at(begin));
  if (x > 1) return at(last) + (place - static_cast<double>(last - begin)) * (at(last) - at(last - 1));
  const std::ptrdiff_t k = std::min(begin + static_cast<std::ptrdiff_t>(place), last - 1);
  const double t = place - static_cast<double>(k - begin);
  const Vec3 a = node(k - 1), b = node(k), c = node(k + 1), d = node(k + 2);
  return b + 0.5 * t * ((c - a) + t * ((2 * a - 5 * b + 4 * c - d) + t * (3 * b - a - 3 * c + d)));
}

Chains divide_chains(const Chains& chains, const PackingRequest& request,
                     const std::function<Index(const FiberBlank&)>& rods_of) {
  ChainMaker maker(request, chains.cell);
  std::vector<Vec3> nodes;
  for (std::size_t f = 0; f < request.fibers.size(); ++f) {
    const Index rods = rods_of(request.fibers[f]);
    nodes.clear();
    for (Index k = 0; k <= rods; ++k) nodes.push_back(point_along(chains, f, static_cast<double>(k) / rods));
    maker.append(nodes);
  }
  return maker.take();
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
