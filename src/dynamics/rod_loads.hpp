// Collects the forces that act on rods at points along them: contacts, walls.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// Acts on a rod at the point x = (1 − lever) x_k + lever x_{k+1} with the force
///   force − resistance · w,   w = v − kappa·x at that point
/// so that a force law may be implicit in the velocity. resistance is symmetric: xx, yy, zz, yz, zx, xy.
struct RodLoad {
  double lever = 0;
  Vec3 force = Vec3::Zero();              ///< N
  std::array<double, 6> resistance = {};  ///< N s/m
};

/// All loads, grouped by rod (a rod is numbered by its first node), in a fixed order.
class RodLoads {
 public:
  /// No load on any rod of a state with `nodes` nodes.
  explicit RodLoads(Index nodes = 0) : begin_(static_cast<std::size_t>(nodes) + 1, 0) {}

  /// A load before its value is known: the rod, and a key that fixes its place among the rod's loads.
  struct Claim {
    Index rod = 0;
    std::uint64_t key = 0;
  };

  /// Makes one slot for each claim and tells the slots' numbers; their loads are then to be written, by any
  /// thread. Loads of a rod are ordered by key, in whatever order they are claimed, so that sums over them
  /// always round alike.
  void arrange(Index nodes, std::span<const Claim> claims, std::vector<Index>& slots);
  [[nodiscard]] RodLoad& slot(Index number) { return loads_[static_cast<std::size_t>(number)]; }

  [[nodiscard]] bool is_empty() const { return loads_.empty(); }
  [[nodiscard]] std::span<const RodLoad> of_rod(Index rod) const {
    const auto r = static_cast<std::size_t>(rod);
    if (loads_.empty()) return {};
    return {loads_.data() + begin_[r], static_cast<std::size_t>(begin_[r + 1] - begin_[r])};
  }

 private:
  void sort_rod(std::size_t rod, std::span<const Claim> claims);

  std::vector<Index> begin_;
  std::vector<Index> next_;
  std::vector<Index> order_;  // claims, grouped by rod
  std::vector<RodLoad> loads_;
};

}  // namespace fiberfate
