// Sorts the volume of fibers into columns.
#include "fibers/density_map.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"

namespace fiberfate {
namespace {

/// A rod is cut into so many pieces a bin that none is longer than a quarter of it.
constexpr double pieces_a_bin = 4;

/// Brings a fraction of a periodic direction into [0, 1); one beyond walls becomes negative.
double place_in_cell(double fraction, Boundary boundary) {
  if (boundary == Boundary::periodic) return fraction - std::floor(fraction);
  return fraction >= 0 && fraction < 1 ? fraction : -1;
}

/// The bin of a place, or a negative number outside.
int bin_of(double place, int bins) {
  return place < 0 ? -1 : std::min(static_cast<int>(place * bins), bins - 1);
}

void add_rod(DensityMap& map, const Cell& cell, const Vec3& from, const Vec3& step, double volume) {
  const double span = std::max(std::abs(step[map.across]), std::abs(step[map.up]));
  const int pieces = 1 + static_cast<int>(span * map.bins * pieces_a_bin);
  for (int k = 0; k < pieces; ++k) {
    const Vec3 at = from + (k + 0.5) / pieces * step;
    const auto bin = [&](int direction) {
      return bin_of(place_in_cell(at[direction], cell.boundary[static_cast<std::size_t>(direction)]),
                    map.bins);
    };
    const int column = bin(map.across), row = bin(map.up);
    if (column < 0 || row < 0) continue;
    map.volume_fraction[static_cast<std::size_t>(row * map.bins + column)] += volume / pieces;
  }
}

}  // namespace

DensityMap density_map(const FiberState& state, int along, int bins) {
  if (bins < 1) throw InputError("a map of the density without bins", "take at least one");
  if (along < 0 || along > 2) throw InputError("a cell has no such direction", "take 0, 1 or 2");
  const auto [across, up] = other_directions(along);
  DensityMap map{along, across, up, bins, {}};
  map.volume_fraction.assign(static_cast<std::size_t>(bins * bins), 0.0);
  const Mat3 inverse = state.cell.lattice.inverse();
  for (const FiberIndex fiber : state.fibers()) {
    const double radius = state.material(fiber).radius;
    const std::span<const Vec3> nodes = state.positions(fiber);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const Vec3 rod = nodes[i + 1] - nodes[i];
      add_rod(map, state.cell, inverse * nodes[i], inverse * rod, pi * radius * radius * rod.norm());
    }
  }
  const double column = state.cell.volume() / (bins * bins);
  for (double& share : map.volume_fraction) share /= column;
  return map;
}

}  // namespace fiberfate
