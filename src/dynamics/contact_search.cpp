// Evaluates the awake pairs of the neighbour list, 64 at a time.
#include "dynamics/contact_search.hpp"

#include <algorithm>

#include "base/threads.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate {
namespace {

bool begins_fiber(const FiberState& state, Index fiber, Index rod) {
  return rod == state.begin_node(fiber);
}
bool ends_fiber(const FiberState& state, Index fiber, Index rod) {
  return rod + 2 == state.end_node(fiber);
}

/// Names one rod of a pair and the place of the contact on it.
struct RodPlace {
  Index fiber, rod;
  double place;
};

/// Tells whether a contact at the end of a rod is seen by the rod beyond the hinge as well, and belongs to
/// that one: always at a rod's begin; at a rod's end when the next rod comes nearer. `other` leads to the
/// other rod.
bool belongs_to_neighbour(const FiberState& state, const RodPlace& at, const Vec3& other) {
  if (at.place <= 0) return !begins_fiber(state, at.fiber, at.rod);
  if (at.place < 1 || ends_fiber(state, at.fiber, at.rod)) return false;
  const auto n = static_cast<std::size_t>(at.rod);
  return (state.position[n + 2] - state.position[n + 1]).dot(other) > 0;
}

/// Works through the pairs of one chunk.
class ChunkSearch {
 public:
  ChunkSearch(const FiberState& state, const NeighbourList& neighbours, const ContactDemand& demand)
      : state_(state), neighbours_(neighbours), demand_(demand), travel_(neighbours.travel()) {}

  void run(std::vector<RodPair>& pairs, std::vector<Contact>& contacts) {
    contacts.clear();
    for (RodPair& pair : pairs) {
      if (approach(pair) < pair.wake || is_exempt(pair)) continue;
      gather(pair);
      if (count_ == SegmentBlock::capacity) evaluate(contacts);
    }
    if (count_ > 0) evaluate(contacts);
  }

 private:
  /// Travels of both rods so far and in the coming step.
  [[nodiscard]] double approach(const RodPair& pair) const {
    const auto i = static_cast<std::size_t>(pair.first);
    const auto j = static_cast<std::size_t>(pair.second);
    return travel_[i] + travel_[j] + coming(i, j);
  }
  [[nodiscard]] double coming(std::size_t i, std::size_t j) const {
    return demand_.ahead[i] + demand_.ahead[j] + 2 * demand_.strain_share;
  }

  [[nodiscard]] bool is_exempt(const RodPair& pair) const {
    if (pair.second != pair.first + 2) return false;
    const Index fiber = neighbours_.fiber_of(pair.second);
    return state_.touches_previous[static_cast<std::size_t>(fiber)] != 0 &&
           begins_fiber(state_, fiber, pair.second) && pair.image == std::array<std::int8_t, 3>{};
  }

  void gather(RodPair& pair) {
    block_.put(count_, state_, pair.first, pair.second, pair.image);
    source_[static_cast<std::size_t>(count_++)] = &pair;
  }

  void evaluate(std::vector<Contact>& contacts) {
    block_.fill_up(count_);
    find_segment_distances(block_, count_);
    for (int i = 0; i < count_; ++i) {
      RodPair& pair = *source_[static_cast<std::size_t>(i)];
      const auto first = static_cast<std::size_t>(pair.first);
      const auto second = static_cast<std::size_t>(pair.second);
      const double gap = block_.distance[i] - demand_.range;
      pair.wake = travel_[first] + travel_[second] + std::max(0.0, gap);
      if (gap < coming(first, second)) keep(i, contacts);
    }
    count_ = 0;
  }

  void keep(int i, std::vector<Contact>& contacts) const {
    const RodPair& pair = *source_[static_cast<std::size_t>(i)];
    const Index f = neighbours_.fiber_of(pair.first);
    const Index g = neighbours_.fiber_of(pair.second);
    const Vec3 separation(block_.separation[0][i], block_.separation[1][i], block_.separation[2][i]);
    if (belongs_to_neighbour(state_, {f, pair.first, block_.s[i]}, -separation)) return;
    if (belongs_to_neighbour(state_, {g, pair.second, block_.t[i]}, separation)) return;
    contacts.push_back({pair.first, pair.second, block_.s[i], block_.t[i], normal(i, separation),
                        block_.distance[i], pair.image, state_.material_id[static_cast<std::size_t>(f)],
                        state_.material_id[static_cast<std::size_t>(g)]});
  }

  /// Unit vector from the second rod to the first; axes that cross exactly are pushed apart across both.
  [[nodiscard]] Vec3 normal(int i, const Vec3& separation) const {
    if (block_.distance[i] > 0) return separation / block_.distance[i];
    const Vec3 u(block_.first[0][i], block_.first[1][i], block_.first[2][i]);
    const Vec3 v(block_.second[0][i], block_.second[1][i], block_.second[2][i]);
    const Vec3 across = u.cross(v);
    return across.squaredNorm() > 0 ? across.normalized() : u.unitOrthogonal();
  }

  const FiberState& state_;
  const NeighbourList& neighbours_;
  const ContactDemand& demand_;
  std::span<const double> travel_;
  SegmentBlock block_;
  std::array<RodPair*, SegmentBlock::capacity> source_{};
  int count_ = 0;
};

}  // namespace

void ContactSearch::find(const FiberState& state, NeighbourList& neighbours, const ContactDemand& demand) {
  const auto chunks = neighbours.chunks();
  by_chunk_.resize(chunks.size());
  parallel_for(static_cast<std::ptrdiff_t>(chunks.size()), [&](std::ptrdiff_t c) {
    const auto i = static_cast<std::size_t>(c);
    ChunkSearch(state, neighbours, demand).run(chunks[i], by_chunk_[i]);
  });
  contacts_.clear();
  for (const auto& chunk : by_chunk_) contacts_.insert(contacts_.end(), chunk.begin(), chunk.end());
}

}  // namespace fiberfate
