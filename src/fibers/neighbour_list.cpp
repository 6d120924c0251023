// Makes the list of neighbours and lists anew what leaves its margins.
#include "fibers/neighbour_list.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/matrix_product.hpp"
#include "base/threads.hpp"
#include "fibers/pair_collector.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate {
namespace {

// Bins a chunk: small enough to balance threads, large enough to amortise their start.
constexpr Index chunk_size = 64;
// Bins of the grid are this share of the farthest midpoints: smaller ones hold fewer rods in vain, but make
// more runs.
constexpr double bin_share = 0.5;
// How far a rod may stray from its bin, as a share of the farthest midpoints.
constexpr double slack_share = 0.3;
// Rounding of coordinates in single precision, relative to the largest one.
constexpr double single_rounding = 4e-7;

// Quanta of travel in the range: fine enough to add next to nothing when rounded up.
constexpr double quanta_in_range = 1e5;
// How far a rod that is listed anew is set back: beyond all gaps, and little enough to be done many times.
constexpr std::int32_t set_back = 20'000'000;
constexpr std::int32_t most_set_backs = 40;
// Bits of NeighbourList::is_leaving_; that of a fiber stands at its first node. A node that has used up most
// of what it may move follows a neighbour that leaves, so that their rod is not listed twice.
constexpr std::uint8_t node_is_leaving = 1;
constexpr std::uint8_t node_follows = 2;
constexpr std::uint8_t fiber_is_leaving = 4;
constexpr double follow_share = 0.8;  // of the square
// Pairs that never wake are swept out once pairs have grown by this share.
constexpr double most_growth = 0.25;

/// What a node does that has moved so far (squared) of what it may.
std::uint8_t leave(double moved, double most) {
  return moved > most ? node_is_leaving : moved > follow_share * most ? node_follows : std::uint8_t{0};
}

/// Doubles the entries of the nodes (strictly increasing) that split_fibers() doubles.
template <class Entries>
void double_entries(Entries& entries, std::span<const NodeIndex> nodes) {
  Entries doubled;
  doubled.reserve(entries.size() + nodes.size());
  auto from = entries.begin();
  for (const NodeIndex node : nodes) {
    const auto to = entries.begin() + node.value() + 1;
    doubled.insert(doubled.end(), from, to);
    from = to - 1;
  }
  doubled.insert(doubled.end(), from, entries.end());
  entries.swap(doubled);
}

}  // namespace

double NeighbourList::name_fibers(const FiberState& state) {
  fiber_of_.resize(state.rod_length.size());
  part_.assign(fiber_of_.size(), 0);
  double longest = 0;
  for (const FiberIndex fiber : state.fibers()) {
    for (const RodIndex rod : state.rods(fiber)) {
      fiber_of_[rod] = fiber;
      longest = std::max(longest, state.rod_length[rod]);
    }
    part_[rod_after(state.begin_node(fiber))] |= first_of_fiber;
    part_[rod_before(state.last_node(fiber))] |= last_of_fiber;
  }
  return longest;
}

void NeighbourList::build(const FiberState& state, double range,
                          const IndexedVector<RodIndex, double>& margin) {
  margin_ = margin;
  travel_.assign(margin_.size(), 0);
  origin_.position = state.position;
  origin_.first_node = state.first_node;
  deformation_.setIdentity();
  strain_ = 0;
  strain_at_fill_ = 0;
  stretch_at_listing_.assign(margin_.size(), 1.0);
  range_ = range;
  quantum_ = range / quanta_in_range;
  farthest_ = range_ + 2 * *std::max_element(margin_.begin(), margin_.end());
  longest_ = name_fibers(state);
  chunks_.clear();
  fill_grid(state.cell);
  parallel_for_weighted(rods_before_, [&](Index c) {
    PairCollector(*this, state.rod_length, candidates_.mine()).list(bins(c), chunks_[c]);
  });
  start_account();
}

bool NeighbourList::renew(const FiberState& state, const IndexedVector<RodIndex, double>& margin) {
  const Mat3 back = deformation_.inverse();
  for (const RodIndex rod : leaving_) place_anew(state, rod, margin[rod], back);
  renew_grid(state.cell);
  list_leaving(state.rod_length);
  if (has_to_be_swept()) sweep();
  bool covers = true;
  FiberIndex looked_at(-1);
  for (const RodIndex rod : leaving_) {
    part_[rod] = static_cast<std::uint8_t>(part_[rod] & ~listed_anew);
    if (fiber_of_[rod] == looked_at) continue;
    looked_at = fiber_of_[rod];
    covers = look_ahead(state, looked_at) && covers;
  }
  return covers;
}

/// Takes note of where a leaving rod is now, and sets its travel back; `back` undoes the deformation.
void NeighbourList::place_anew(const FiberState& state, RodIndex rod, double margin, const Mat3& back) {
  double least = 0;  // a node that stays where it lay needs the margin that it had
  for (const NodeIndex node : {first_end(rod), second_end(rod)}) {
    if ((is_leaving_[node] & node_is_leaving) != 0)
      origin_.position[node] = product(back, state.position[node]);
    else
      least = margin_[rod];
  }
  margin_[rod] = std::min(std::max(margin, least), 0.5 * (farthest_ - range_));
  stretch_at_listing_[rod] = std::exp(strain_);
  travel_[rod] -= set_back;
  least_travel_ = std::min(least_travel_, travel_[rod]);
  part_[rod] |= listed_anew;
}

void NeighbourList::list_leaving(const IndexedVector<RodIndex, double>& rod_length) {
  to_list_.clear();
  for (const RodIndex rod : leaving_) to_list_.push_back(grid_.entry_of(rod));
  std::sort(to_list_.begin(), to_list_.end());
  chunk_begin_.clear();
  for (std::size_t i = 0; i < to_list_.size(); ++i) {
    if (i == 0 || chunk_of(to_list_[i]) != chunk_of(to_list_[i - 1])) chunk_begin_.push_back(i);
  }
  chunk_begin_.push_back(to_list_.size());
  candidates_.fit();
  parallel_for(std::ssize(chunk_begin_) - 1, [&](std::ptrdiff_t c) {
    const std::span entries(to_list_.data() + chunk_begin_[c], chunk_begin_[c + 1] - chunk_begin_[c]);
    PairCollector(*this, rod_length, candidates_.mine()).add(entries, chunks_[chunk_of(entries.front())]);
  });
  count_pairs();
}

/// Whether pairs that never wake are too many, or could soon be taken for others.
bool NeighbourList::has_to_be_swept() const {
  return pairs_before_.back() > (1 + most_growth) * swept_pairs_ || quanta(travelled_) > set_back / 8 ||
         least_travel_ < -most_set_backs * set_back;
}

/// Leaves out the pairs that never wake, and lets all travels begin anew.
void NeighbourList::sweep() {
  parallel_for_weighted(pairs_before_, [&](Index c) {
    RodPairs& pairs = chunks_[c];
    const auto asleep = [&](Index i) {
      return pairs.wake[i] - travel_[pairs.first[i]] - travel_[pairs.second[i]];
    };
    pairs.keep_if([&](Index i) { return asleep(i) < set_back / 2; });
    for (Index i = 0; i < pairs.size(); ++i) pairs.wake[i] = asleep(i);
    pairs.pad();
  });
  parallel_for(travel_.indices(), [&](RodIndex rod) { reach_[rod] -= std::exchange(travel_[rod], 0); });
  start_account();
}

/// Counts the pairs of a list without pairs that never wake.
void NeighbourList::start_account() {
  count_pairs();
  swept_pairs_ = pairs_before_.back();
  travelled_ = 0;
  least_travel_ = 0;
}

void NeighbourList::split(const FiberState& state, std::span<const NodeIndex> nodes) {
  IndexedVector<RodIndex, RodIndex> renumbered;
  auto next = nodes.begin();
  for (const FiberIndex fiber : origin_.fibers()) {
    const auto first = next;
    for (const NodeIndex node : origin_.nodes(fiber)) {
      if (next != nodes.end() && *next == node) ++next;
      renumbered.push_back(rod_after(node) + static_cast<Index>(next - nodes.begin()));
    }
    if (next == first) continue;
    for (const RodIndex rod : origin_.rods(fiber)) margin_[rod] = 0;
  }
  double_entries(origin_.position, nodes);
  double_entries(margin_, nodes);
  double_entries(travel_, nodes);
  double_entries(stretch_at_listing_, nodes);
  origin_.first_node = state.first_node;
  longest_ = name_fibers(state);
  grid_.renumber(renumbered, RodIndex(origin_.node_count()));
  parallel_for(std::ssize(chunks_), [&](Index c) { chunks_[c].renumber(renumbered); });
}

/// Bins the fibers as they lie, carried with the fluid to this cell.
void NeighbourList::fill_grid(const Cell& cell) {
  parallel_for(origin_.nodes(), [&](NodeIndex node) {
    origin_.position[node] = product(deformation_, origin_.position[node]);
  });
  deformation_.setIdentity();
  strain_at_fill_ = strain_;
  frame_ = cell;
  grid_.fill(origin_, cell, bin_share * widest(), margin_);
  // Of coordinates, and of places along nearly parallel rods.
  rounding_ = 2 * single_rounding *
              (cell.lattice.cwiseAbs().rowwise().sum().maxCoeff() + widest() + longest_ * longest_ / range_);
  const Index chunks = (grid_.bin_count() + chunk_size - 1) / chunk_size;
  if (std::ssize(chunks_) < chunks) chunks_.resize(chunks);
  rods_before_.clear();
  for (Index c = 0; c < std::ssize(chunks_); ++c)
    rods_before_.push_back(grid_.first_entry(bins(c).front()).value());
  rods_before_.push_back(origin_.rod_count());
  candidates_.fit();
}

/// Brings the leaving rods to where they are; once one has strayed too far from its bin, all are binned anew.
void NeighbourList::renew_grid(const Cell& cell) {
  const double slack = slack_share * widest();
  bool has_strayed = false;
  for (const RodIndex rod : leaving_) {
    const RodGrid::Entry entry = grid_.entry_of(rod);
    grid_.renew(entry, origin_.segment(rod), margin_[rod]);
    has_strayed = has_strayed || grid_.strayed(entry) > slack;
  }
  if (has_strayed) fill_grid(cell);
  grid_.flow_with(cell);
}

Index NeighbourList::chunk_of(RodGrid::Entry entry) const {
  const auto after = std::upper_bound(rods_before_.begin(), rods_before_.end(), entry.value());
  return static_cast<Index>(after - rods_before_.begin()) - 1;
}

IndexRange<RodGrid::Bin> NeighbourList::bins(Index chunk) const {
  const auto bound = [&](Index c) { return RodGrid::Bin(std::min(c * chunk_size, grid_.bin_count())); };
  return {bound(chunk), bound(chunk + 1)};
}

double NeighbourList::reach_of_strayed() const {
  return widest() + slack_share * widest() * stretch();
}

double NeighbourList::stretch() const {
  return std::exp(strain_ - strain_at_fill_);
}

void NeighbourList::count_pairs() {
  pairs_before_.assign(1, 0);
  for (const RodPairs& chunk : chunks_) pairs_before_.push_back(pairs_before_.back() + chunk.size());
}

void NeighbourList::carry(const Flow& flow, double step, IndexedSpan<RodIndex, const double> travelled) {
  const double share = strain_share(flow, step);
  parallel_for(travel_.indices(), [&](RodIndex rod) { travel_[rod] += quanta(travelled[rod] + share); });
  travelled_ += *std::max_element(travelled.begin(), travelled.end()) + share;
  if (has_to_be_swept()) sweep();
  deformation_ = flow_map(flow.gradient, step) * deformation_;
  strain_ += principal_rate(flow) * step;
}

bool NeighbourList::look_ahead(const FiberState& state, const Flow& flow, double step) {
  const std::size_t nodes = state.position.size();
  ahead_.resize(nodes);
  reach_.resize(nodes);
  is_leaving_.assign(nodes, 0);
  if (travel_.size() != nodes) {  // these fibers are not listed
    travel_.assign(nodes, 0);
    margin_.assign(nodes, 0.0);
    stretch_at_listing_.assign(nodes, 1.0);
    origin_.position = state.position;
  }
  outlook_ = {step, strain_share(flow, step), std::exp(strain_ + principal_rate(flow) * step)};
  parallel_for_weighted(state.first_node, [&](FiberIndex fiber) {
    if (!look_ahead(state, fiber)) is_leaving_[state.begin_node(fiber)] |= fiber_is_leaving;
  });
  find_leaving(state);
  return leaving_.empty();
}

bool NeighbourList::look_ahead(const FiberState& state, FiberIndex fiber) {
  bool covers = true;
  double moved_before = 0;
  double speed_before = 0;
  for (const NodeIndex node : state.nodes(fiber)) {
    const double moved = (state.position[node] - product(deformation_, origin_.position[node])).squaredNorm();
    const double speed = state.relative_velocity[node].norm();
    if (node > state.begin_node(fiber)) {
      const RodIndex rod = rod_before(node);
      const double ahead = outlook_.step * std::max(speed, speed_before);
      // What strain leaves of a distance at least.
      const double shrunk = stretch_at_listing_[rod] / outlook_.stretch;
      const double allowed = 0.5 * (shrunk * (range_ + 2 * margin_[rod]) - range_) - ahead;
      const double most = allowed > 0 ? allowed * allowed : -1;
      is_leaving_[node - 1] |= leave(moved_before, most);
      is_leaving_[node] |= leave(moved, most);
      covers = covers && moved <= most && moved_before <= most;
      ahead_[rod] = static_cast<float>((ahead + outlook_.strain_share) * (1 + 1e-6));
      reach_[rod] = travel_[rod] + quanta(ahead + outlook_.strain_share);
    }
    moved_before = moved;
    speed_before = speed;
  }
  return covers;
}

/// Lists the rods of the nodes that leave their margins, in order, and lets neighbours follow.
void NeighbourList::find_leaving(const FiberState& state) {
  const auto is_leaving = [&](NodeIndex node) { return (is_leaving_[node] & node_is_leaving) != 0; };
  const auto follow = [&](NodeIndex node, NodeIndex neighbour) {
    if (is_leaving(neighbour) && (is_leaving_[node] & node_follows) != 0)
      is_leaving_[node] |= node_is_leaving;
  };
  leaving_.clear();
  for (const FiberIndex fiber : state.fibers()) {
    if ((is_leaving_[state.begin_node(fiber)] & fiber_is_leaving) == 0) continue;
    for (NodeIndex node = state.last_node(fiber); node > state.begin_node(fiber); node = node - 1)
      follow(node - 1, node);
    for (const RodIndex rod : state.rods(fiber)) {
      follow(second_end(rod), first_end(rod));
      if (is_leaving(first_end(rod)) || is_leaving(second_end(rod))) leaving_.push_back(rod);
    }
  }
}

std::int32_t NeighbourList::quanta(double length) const {
  return 1 + static_cast<std::int32_t>(std::min(length / quantum_, 1e8));
}

double NeighbourList::strain_share(const Flow& flow, double step) const {
  return 0.5 * std::expm1(principal_rate(flow) * step) * farthest_;
}

}  // namespace fiberfate
