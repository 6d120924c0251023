// Lists the pairs of rods that may touch before the list is made anew.
#pragma once

#include <span>
#include <vector>

#include "base/threads.hpp"
#include "fibers/pair_candidates.hpp"
#include "fibers/rod_grid.hpp"
#include "fibers/rod_pairs.hpp"
#include "fibers/state.hpp"
#include "microstructure/flow.hpp"

namespace fiberfate {

/// Keeps, for every pair of rods nearer than `range` + margins of both, an entry, until some rod has moved
/// relative to the fluid by more than its margin. Rods that share a node, and rods of one fiber with less
/// than `range` of it between them, are left out.
///
/// A list bounds what can happen, it decides nothing: it may hold a pair more, never one less, and what is
/// summed over its pairs must be ordered by what they are. Arrays "one a rod" are indexed by the rod's first
/// node. Travels are kept in single precision and rounded up.
class NeighbourList {
 public:
  /// Makes the list for pairs nearer than `range` (m), with one margin a rod (m).
  void build(const FiberState& state, double range, const std::vector<double>& margin);

  /// Bounds how far every rod may travel relative to the fluid in the coming step, and tells whether every
  /// pair nearer than `range` is still listed, now and when they have travelled so far.
  [[nodiscard]] bool look_ahead(const FiberState& state, const Flow& flow, double step);

  /// Accounts for an accepted step: `travelled` is the largest displacement of each rod relative to the
  /// fluid, m.
  void carry(const Flow& flow, double step, std::span<const double> travelled);

  /// Pairs in chunks, each to be worked on by one thread at a time.
  [[nodiscard]] std::span<RodPairs> chunks() { return chunks_; }
  /// Pairs in all chunks before each, to share them among threads.
  [[nodiscard]] std::span<const Index> pairs_before() const { return pairs_before_; }
  /// Travel of every rod since the list was made, its share of the strain included, m; see RodPairs::wake.
  [[nodiscard]] std::span<const float> travel() const { return travel_; }
  /// Travel of every rod in the coming step, its share of the strain included, m.
  [[nodiscard]] std::span<const float> ahead() const { return ahead_; }
  /// Gap beyond `range` that a pair may sleep for at most, m: what strain adds to travels is that of pairs as
  /// far apart as listed ones were, and a pair may have moved farther apart since.
  [[nodiscard]] double widest_gap() const { return farthest_ - range_; }
  /// Sum of both, m.
  [[nodiscard]] std::span<const float> reach() const { return reach_; }
  [[nodiscard]] Index fiber_of(Index rod) const { return fiber_of_[static_cast<std::size_t>(rod)]; }
  /// Part of its fiber that every rod is: first_of_fiber, last_of_fiber (fibers/segment_block.hpp).
  [[nodiscard]] std::span<const std::uint8_t> part() const { return part_; }

 private:
  friend class PairCollector;

  /// Bounds what strain adds to the travels of a pair in a step of this size, a rod's share, m.
  [[nodiscard]] double strain_share(const Flow& flow, double step) const;
  [[nodiscard]] bool look_ahead(const FiberState& state, Index fiber, double step, double share,
                                double shrunk);
  double name_fibers(const FiberState& state);

  RodGrid grid_;
  std::vector<RodPairs> chunks_;
  std::vector<Index> rods_before_;         // each chunk, in all before it
  std::vector<Index> pairs_before_ = {0};  // the same
  PerThread<PairCandidates> candidates_;
  std::vector<Index> fiber_of_;
  std::vector<std::uint8_t> part_;  // of its fiber that every rod is: small enough to stay in the cache
  std::vector<double> margin_;
  std::vector<float> travel_;
  std::vector<float> ahead_;
  std::vector<float> reach_;
  std::vector<Vec3> origin_;             // positions when the list was made
  std::vector<std::uint8_t> has_left_;   // by fiber: some rod has used up its margin
  Mat3 deformation_ = Mat3::Identity();  // of the fluid since then
  double strain_ = 0;                    // integral of the largest principal rate of strain since then
  double range_ = 0;
  double rounding_ = 0;  // of distances in single precision, m
  double farthest_ = 0;  // largest distance of a listed pair
};

}  // namespace fiberfate
