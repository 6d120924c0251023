// Collects the forces that act on rods at points along them: contacts, walls.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fibers/fiber_nodes.hpp"

namespace fiberfate {

/// Acts on a rod at the point x = (1 − lever) x_k + lever x_{k+1} with the force
///   force − resistance · w,   w = v − kappa·x at that point
/// so that a force law may be implicit in the velocity. resistance is symmetric: xx, yy, zz, yz, zx, xy.
struct RodLoad {
  double lever = 0;
  Vec3 force = Vec3::Zero();              ///< N
  std::array<double, 6> resistance = {};  ///< N s/m
};

/// All loads, grouped by rod, in a fixed order.
class RodLoads {
 public:
  /// The number of a load among all.
  using Slot = IndexOf<struct LoadSlotTag>;
  /// A load before its value is known: the rod, and a key that fixes its place among the rod's loads.
  struct Claim {
    RodIndex rod;
    std::uint64_t key = 0;
  };

  /// Makes one slot for each claim on a rod of a state with `nodes` nodes, and tells the slots; their loads
  /// are then to be written, by any thread. Loads of a rod are ordered by key, in whatever order they are
  /// claimed, so that sums over them always round alike.
  void arrange(Index nodes, std::span<const Claim> claims, std::vector<Slot>& slots);
  [[nodiscard]] RodLoad& slot(Slot slot) { return loads_[slot]; }
  [[nodiscard]] const RodLoad& at(Slot slot) const { return loads_[slot]; }

  [[nodiscard]] bool is_empty() const { return loads_.empty(); }
  [[nodiscard]] std::span<const RodLoad> of_rod(RodIndex rod) const {
    if (loads_.empty()) return {};
    return {loads_.data() + begin_[rod].value(), loads_.data() + begin_[rod + 1].value()};
  }

 private:
  void sort_rod(RodIndex rod, std::span<const Claim> claims);

  IndexedVector<RodIndex, Slot> begin_;
  IndexedVector<RodIndex, Slot> next_;
  IndexedVector<Slot, std::size_t> claim_;  // that holds the slot
  IndexedVector<Slot, RodLoad> loads_;
};

}  // namespace fiberfate
