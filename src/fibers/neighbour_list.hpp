// Lists the pairs of rods that may touch before the list is made anew.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fibers/flow.hpp"
#include "fibers/rod_grid.hpp"
#include "fibers/state.hpp"

namespace fiberfate {

/// Names a rod and the image of a rod (possibly of itself) near it.
struct RodPair {
  Index first = 0;
  Index second = 0;
  std::array<std::int8_t, 3> image = {};  ///< second stands at x + H · image
  double wake = 0;  ///< the pair cannot matter before the travels of its two rods add up to this, m
};

/// Keeps, for every pair of rods nearer than `range` + margins of both, an entry, until some rod has moved
/// relative to the fluid by more than its margin. Rods that share a node, and rods of one fiber with less
/// than `range` of it between them, are left out.
///
/// A list bounds what can happen, it decides nothing: pairs are ordered by (first, second, image), whatever
/// the margins, so that forces summed in list order do not depend on when the list was made. Arrays "one a
/// rod" are indexed by the rod's first node.
class NeighbourList {
 public:
  /// Makes the list for pairs nearer than `range` (m), with one margin a rod (m).
  void build(const FiberState& state, double range, std::vector<double> margin);

  /// Accounts for an accepted step: `travelled` is the largest displacement of each rod relative to the
  /// fluid, m.
  void carry(const Flow& flow, double step, std::span<const double> travelled);

  /// Tells whether every pair nearer than `range` is still listed, now and when every rod goes on to travel
  /// by `ahead` (one a rod, m) in a step of the given size.
  [[nodiscard]] bool covers(const FiberState& state, const Flow& flow, double step,
                            std::span<const double> ahead) const;

  /// Pairs in chunks, each to be worked on by one thread at a time.
  [[nodiscard]] std::span<std::vector<RodPair>> chunks() { return chunks_; }
  /// Travel of every rod since the list was made, its share of the strain included, m; see RodPair::wake.
  [[nodiscard]] std::span<const double> travel() const { return travel_; }
  /// Bound of what strain adds to the travels of a pair in a step of this size, a rod's share, m.
  [[nodiscard]] double strain_share(const Flow& flow, double step) const;
  [[nodiscard]] Index fiber_of(Index rod) const { return fiber_of_[static_cast<std::size_t>(rod)]; }
  [[nodiscard]] std::size_t pair_count() const;

 private:
  friend class PairCollector;

  RodGrid grid_;
  std::vector<std::vector<RodPair>> chunks_;
  std::vector<Index> fiber_of_;
  std::vector<double> margin_;
  std::vector<double> travel_;
  std::vector<Vec3> origin_;             // positions when the list was made
  Mat3 deformation_ = Mat3::Identity();  // of the fluid since then
  double strain_ = 0;                    // integral of the largest principal rate of strain since then
  double range_ = 0;
  double rounding_ = 0;  // of coordinates in single precision, m
  double farthest_ = 0;  // largest distance of a listed pair
};

}  // namespace fiberfate
