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

/// Keeps, for every pair of rods nearer than `range` + margins of both, an entry, until one of them has moved
/// relative to the fluid by more than its margin: that rod is listed anew, with all its pairs, and no other
/// pair ends. Rods that share a node, and rods of one fiber with less than `range` of it between them, are
/// left out.
///
/// A node lies where it was when it was last listed, carried with the fluid; the true one is never farther
/// from it than the margins of its rods. Of two rods the one that was listed later met the other as it lay.
///
/// A list bounds what can happen, it decides nothing: it may hold a pair more, never one less, and what is
/// summed over its pairs must be ordered by what they are. Travels are counted in quanta and rounded up. A
/// rod that is listed anew starts so far back that its earlier pairs never wake.
class NeighbourList {
 public:
  /// Makes the list for pairs nearer than `range` (m), with one margin a rod (m).
  void build(const FiberState& state, double range, const IndexedVector<RodIndex, double>& margin);

  /// Bounds how far every rod may travel relative to the fluid in the coming step, and tells whether every
  /// pair nearer than `range` is still listed, now and when they have travelled so far.
  [[nodiscard]] bool look_ahead(const FiberState& state, const Flow& flow, double step);
  /// The rods that the last look ahead found to leave their margins, all where these fibers are not listed.
  [[nodiscard]] std::span<const RodIndex> leaving() const { return leaving_; }
  /// Lists the leaving rods anew, with these margins (m; none counts as wider than the widest one of the
  /// list's making), and tells whether every pair is listed for the step that was last looked ahead to.
  [[nodiscard]] bool renew(const FiberState& state, const IndexedVector<RodIndex, double>& margin);
  /// Follows split_fibers(): gives all rods their new numbers; the rods of the parts leave their margins.
  void split(const FiberState& state, std::span<const NodeIndex> nodes);

  /// Accounts for an accepted step: `travelled` is the largest displacement of each rod relative to the
  /// fluid, m.
  void carry(const Flow& flow, double step, IndexedSpan<RodIndex, const double> travelled);

  /// Pairs in chunks, each to be worked on by one thread at a time.
  [[nodiscard]] std::span<RodPairs> chunks() { return chunks_; }
  /// Pairs in all chunks before each, to share them among threads.
  [[nodiscard]] std::span<const Index> pairs_before() const { return pairs_before_; }
  /// Travel of every rod, its share of the strain included, in quanta; see RodPairs::wake.
  [[nodiscard]] IndexedSpan<RodIndex, const std::int32_t> travel() const { return travel_; }
  /// The same at the end of the coming step.
  [[nodiscard]] IndexedSpan<RodIndex, const std::int32_t> reach() const { return reach_; }
  /// Travel of every rod in the coming step, its share of the strain included, m.
  [[nodiscard]] IndexedSpan<RodIndex, const float> ahead() const { return ahead_; }
  /// Unit of travels, m.
  [[nodiscard]] double quantum() const { return quantum_; }
  /// Gap beyond `range` that a pair may sleep for at most, m: what strain adds to travels is that of pairs as
  /// far apart as listed ones were, and a pair may have moved farther apart since.
  [[nodiscard]] double widest_gap() const { return farthest_ - range_; }
  [[nodiscard]] FiberIndex fiber_of(RodIndex rod) const { return fiber_of_[rod]; }
  /// Part of its fiber that every rod is: first_of_fiber, last_of_fiber (fibers/segment_block.hpp).
  [[nodiscard]] IndexedSpan<RodIndex, const std::uint8_t> part() const { return part_; }

 private:
  friend class PairCollector;

  /// Bounds what strain adds to the travels of a pair in a step of this size, a rod's share, m.
  [[nodiscard]] double strain_share(const Flow& flow, double step) const;
  [[nodiscard]] std::int32_t quanta(double length) const;
  /// What a coming step does to every rod.
  struct Outlook {
    double step = 0;          // s
    double strain_share = 0;  // m
    double stretch = 1;       // of the fluid by its end, since strain_ began
  };
  [[nodiscard]] bool look_ahead(const FiberState& state, FiberIndex fiber);
  void find_leaving(const FiberState& state);
  double name_fibers(const FiberState& state);
  void place_anew(const FiberState& state, RodIndex rod, double margin, const Mat3& back);
  void fill_grid(const Cell& cell);
  void renew_grid(const Cell& cell);
  void list_leaving(const IndexedVector<RodIndex, double>& rod_length);
  void count_pairs();
  [[nodiscard]] bool has_to_be_swept() const;
  void sweep();
  void start_account();
  /// The bins of a chunk.
  [[nodiscard]] IndexRange<RodGrid::Bin> bins(Index chunk) const;
  [[nodiscard]] Index chunk_of(RodGrid::Entry entry) const;
  /// How much longer the fluid has made a length at most since the grid was filled.
  [[nodiscard]] double stretch() const;
  /// Distance of midpoints within which a pair may be listed, m.
  [[nodiscard]] double widest() const { return (longest_ * stretch() + farthest_) * (1 + 1e-5); }
  /// The same, when the other rod may have strayed from its bin.
  [[nodiscard]] double reach_of_strayed() const;

  RodGrid grid_;
  std::vector<RodPairs> chunks_;
  std::vector<Index> rods_before_;         // each chunk, in all before it
  std::vector<Index> pairs_before_ = {0};  // the same
  PerThread<PairCandidates> candidates_;
  IndexedVector<RodIndex, FiberIndex> fiber_of_;
  IndexedVector<RodIndex, std::uint8_t> part_;  // of its fiber: small enough to stay in the cache
  IndexedVector<RodIndex, double> margin_;
  IndexedVector<RodIndex, double> stretch_at_listing_;  // of the fluid since strain_ began
  IndexedVector<RodIndex, std::int32_t> travel_;
  IndexedVector<RodIndex, std::int32_t> reach_;
  IndexedVector<RodIndex, float> ahead_;
  FiberNodes origin_;                    // the fibers as they were last listed, in the frame of the grid
  Cell frame_;                           // the cell when the grid was filled
  Mat3 deformation_ = Mat3::Identity();  // of the fluid since then
  double strain_ = 0;                    // integral of the largest principal rate of strain
  double strain_at_fill_ = 0;            // when the grid was filled
  IndexedVector<NodeIndex, std::uint8_t> is_leaving_;
  std::vector<RodIndex> leaving_;
  std::vector<RodGrid::Entry> to_list_;   // of the leaving rods, in order
  std::vector<std::size_t> chunk_begin_;  // in to_list_
  Outlook outlook_;
  double range_ = 0;
  double longest_ = 0;   // rod
  double rounding_ = 0;  // of distances in single precision, m
  double farthest_ = 0;  // largest distance of a listed pair
  double quantum_ = 1;   // of travel, m
  // Since pairs that never wake were last swept out:
  Index swept_pairs_ = 0;          // pairs then
  double travelled_ = 0;           // by the fastest rod of every step, m
  std::int32_t least_travel_ = 0;  // of all rods
};

}  // namespace fiberfate
