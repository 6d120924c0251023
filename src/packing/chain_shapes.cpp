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
  const FiberBlank& fiber = request_.fibers[chains_.fiber_count()];
  const FiberMaterial& material = request_.materials[fiber.material_id];
  const double length = fiber.length / unit_ / static_cast<double>(nodes.size() - 1);
  chains_.position.insert(chains_.position.end(), nodes.begin(), nodes.end());
  chains_.first_node.push_back(NodeIndex(chains_.position.size()));
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

Vec3 point_along(const Chains& chains, FiberIndex fiber, double x) {
  const std::span<const Vec3> nodes = chains.positions(fiber);
  const Index last = chains.rod_count(fiber);
  const auto node = [&](Index k) -> Vec3 {
    if (k < 0) return 2 * nodes[0] - nodes[1];
    if (k > last) return 2 * nodes[last] - nodes[last - 1];
    return nodes[k];
  };
  const double place = x * last;
  if (x < 0) return nodes[0] + place * (nodes[1] - nodes[0]);
  if (x > 1) return nodes[last] + (place - last) * (nodes[last] - nodes[last - 1]);
  const Index k = std::min(static_cast<Index>(place), last - 1);
  const double t = place - k;
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
    for (Index k = 0; k <= rods; ++k)
      nodes.push_back(point_along(chains, FiberIndex(f), static_cast<double>(k) / rods));
    maker.append(nodes);
  }
  return maker.take();
}

FiberState state_of(const Chains& chains, const PackingRequest& request) {
  const double unit = thickest_diameter(request);
  FiberState state;
  state.materials = request.materials;
  state.cell = request.cell;
  for (const FiberIndex f : chains.fibers()) {
    const FiberBlank& fiber = request.fibers[f.value()];
    std::vector<Vec3> nodes;
    for (const Vec3& x : chains.positions(f)) nodes.push_back(unit * x);
    append_fiber(state, {nodes, fiber.material_id});
    for (const RodIndex rod : chains.rods(f)) state.rod_length[rod] = fiber.length / fiber.rods;
  }
  wrap_fibers(state);
  return state;
}

double mean_radius(const Chains& chains) {
  double sum = 0;
  std::int64_t hinges = 0;
  for (const FiberIndex fiber : chains.fibers()) {
    const double squared = chains.rod_length[fiber] * chains.rod_length[fiber];
    for (const NodeIndex k : chains.hinges(fiber)) {
      sum += (chains.position[k + 1] - 2 * chains.position[k] + chains.position[k - 1]).norm() / squared;
      ++hinges;
    }
  }
  return sum > 0 ? static_cast<double>(hinges) / sum : std::numeric_limits<double>::infinity();
}

}  // namespace fiberfate
