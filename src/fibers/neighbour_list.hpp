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
/// summed over its pairs must be ordered by what they are. Travels are kept in single precision and rounded
/// up.
class NeighbourList {
 public:
  /// Makes the list for pairs nearer than `range` (m), with one margin a rod (m).
  void build(const FiberState& state, double range, const IndexedVector<RodIndex, double>& margin);

  /// Bounds how far every rod may travel relative to the fluid in the coming step, and tells whether every
  /// pair nearer than `range` is still listed, now and when they have travelled so far.
  [[nodiscard]] bool look_ahead(const FiberState& state, const Flow& flow, double step);

  /// Accounts for an accepted step: `travelled` is the largest displacement of each rod relative to the
  /// fluid, m.
  void carry(const Flow& flow, double step, IndexedSpan<RodIndex, const double> travelled);

  /// Pairs in chunks, each to be worked on by one thread at a time.
  [[nodiscard]] std::span<RodPairs> chunks() { return chunks_; }
  /// Pairs in all chunks before each, to share them among threads.
  [[nodiscard]] std::span<const Index> pairs_before() const { return pairs_before_; }
  /// Travel of every rod since the list was made, its share of the strain included, m; see RodPairs::wake.
  [[nodiscard]] IndexedSpan<RodIndex, const float> travel() const { return travel_; }
  /// Travel of every rod in the coming step, its share of the strain included, m.
  [[nodiscard]] IndexedSpan<RodIndex, const float> ahead() const { return ahead_; }
  /// Gap beyond `range` that a pair may sleep for at most, m: what strain adds to travels is that of pairs as
  /// far apart as listed ones were, and a pair may have moved farther apart since.
  [[nodiscard]] double widest_gap() const { return farthest_ - range_; }
  /// Sum of both, m.
  [[nodiscard]] IndexedSpan<RodIndex, const float> reach() const { return reach_; }
  [[nodiscard]] FiberIndex fiber_of(RodIndex rod) const { return fiber_of_[rod]; }
  /// Part of its fiber that every rod is: first_of_fiber, last_of_fiber (fibers/segment_block.hpp).
  [[nodiscard]] IndexedSpan<RodIndex, const std::uint8_t> part() const { return part_; }

 private:
  friend class PairCollector;

  /// Bounds what strain adds to the travels of a pair in a step of this size, a rod's share, m.
  [[nodiscard]] double strain_share(const Flow& flow, double step) const;
  /// What a coming step does to every rod.
  struct Outlook {
    double step;          // s
    double strain_share;  // m
    double shrunk;        // what strain leaves of a distance at least
  };
  [[nodiscard]] bool look_ahead(const FiberState& state, FiberIndex fiber, const Outlook& outlook);
  double name_fibers(const FiberState& state);

  RodGrid grid_;
  std::vector<RodPairs> chunks_;
  std::vector<Index> rods_before_;         // each chunk, in all before it
  std::vector<Index> pairs_before_ = {0};  // the same
  PerThread<PairCandidates> candidates_;
  IndexedVector<RodIndex, FiberIndex> fiber_of_;
  IndexedVector<RodIndex, std::uint8_t> part_;  // of its fiber: small enough to stay in the cache
  IndexedVector<RodIndex, double> margin_;
  IndexedVector<RodIndex, float> travel_;
  IndexedVector<RodIndex, float> ahead_;
  IndexedVector<RodIndex, float> reach_;
  IndexedVector<NodeIndex, Vec3> origin_;             // positions when the list was made
  IndexedVector<FiberIndex, std::uint8_t> has_left_;  // some rod has used up its margin
  Mat3 deformation_ = Mat3::Identity();               // of the fluid since then
  double strain_ = 0;  // integral of the largest principal rate of strain since then
  double range_ = 0;
  double rounding_ = 0;  // of distances in single precision, m
  double farthest_ = 0;  // largest distance of a listed pair
};

}  // namespace fiberfate
