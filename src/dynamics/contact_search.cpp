// Evaluates the awake pairs of the neighbour list, 64 at a time.
#include "dynamics/contact_search.hpp"

#include <algorithm>

#include "base/threads.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate {
namespace {

// Room that the kernels need beyond the pairs of a chunk.
constexpr std::size_t overrun = 16;

/// Works through the pairs of one chunk.
class ChunkSearch {
 public:
  ChunkSearch(const FiberState& state, const NeighbourList& neighbours, double range)
      : state_(state), neighbours_(neighbours), range_(range) {}

  void run(RodPairs& pairs, std::vector<Index>& awake, ContactChunk& contacts) {
    contacts.clear();
    const std::size_t room = pairs.size() + overrun;
    if (awake.size() < room) awake.resize(2 * room);
    const int count = find_awake_pairs(pairs, neighbours_.reach(), awake.data());
    if (count == 0) return;
    contacts.reserve(count);
    std::fill_n(awake.begin() + count, SegmentBlock::capacity / 8, awake[0]);
    for (int i = 0; i < count; i += SegmentBlock::capacity)
      evaluate(pairs,
               {awake.data() + i, static_cast<std::size_t>(std::min(SegmentBlock::capacity, count - i))},
               contacts);
  }

 private:
  void evaluate(RodPairs& pairs, std::span<const Index> which, ContactChunk& contacts) {
    const SegmentQuery query{
        numbers(pairs.first).data(),    numbers(pairs.second).data(), pairs.image.data(),
        state_.position.front().data(), state_.cell.lattice.data(),   neighbours_.travel().data(),
        neighbours_.ahead().data(),     neighbours_.part().data(),    range_,
        neighbours_.widest_gap(),       1 / neighbours_.quantum()};
    find_segment_distances(query, which.data(), static_cast<int>(which.size()), block_);
    for (std::size_t i = 0; i < which.size(); ++i) pairs.wake[which[i]] = block_.wake[i];
    for (int first = 0; first < static_cast<int>(which.size()); first += 8) {
      std::uint8_t& near = block_.near[first / 8];
      for (unsigned special = near & block_.special[first / 8]; special != 0; special &= special - 1) {
        const int lane = __builtin_ctz(special);
        if (!settle(first + lane)) near = static_cast<std::uint8_t>(near & ~(1U << lane));
      }
    }
    const int before = contacts.count;
    contacts.add(block_, static_cast<int>(which.size()));
    if (state_.materials.size() > 1) name_materials(contacts, before);
  }

  /// Decides whether a special pair is a contact; axes that cross get their normal for separation.
  [[nodiscard]] bool settle(int i) {
    const RodIndex first(block_.first[i]);
    const RodIndex second(block_.second[i]);
    if (second == first + 2 && block_.image[i] == 0 && is_exempt(second)) return false;
    if (block_.distance[i] > 0) return true;
    const Vec3 normal = normal_across(first, second);
    for (int d = 0; d < 3; ++d) block_.separation[d][i] = normal[d];
    return true;
  }

  void name_materials(ContactChunk& contacts, int begin) const {
    for (int i = begin; i < contacts.count; ++i) {
      contacts.first_material[i] = material_of(contacts.first[i]);
      contacts.second_material[i] = material_of(contacts.second[i]);
    }
  }

  [[nodiscard]] std::uint16_t material_of(RodIndex rod) const {
    return state_.material_id[neighbours_.fiber_of(rod)];
  }
  [[nodiscard]] bool is_exempt(RodIndex rod) const {
    return (neighbours_.part()[rod] & first_of_fiber) != 0 &&
           state_.touches_previous[neighbours_.fiber_of(rod)] != 0;
  }

  /// Unit vector along which axes that cross exactly are pushed apart: across both.
  [[nodiscard]] Vec3 normal_across(RodIndex first, RodIndex second) const {
    const Vec3 across = state_.axis(first).cross(state_.axis(second));
    return across.squaredNorm() > 0 ? across.normalized() : state_.axis(first).unitOrthogonal();
  }

  const FiberState& state_;
  const NeighbourList& neighbours_;
  double range_;
  SegmentBlock block_;
};

}  // namespace

void ContactSearch::find(const FiberState& state, NeighbourList& neighbours, double range) {
  const auto chunks = neighbours.chunks();
  contacts_.resize(chunks.size());
  awake_.fit();
  parallel_for_weighted(neighbours.pairs_before(), [&](std::size_t c) {
    ChunkSearch(state, neighbours, range).run(chunks[c], awake_.mine(), contacts_[c]);
  });
}

}  // namespace fiberfate
