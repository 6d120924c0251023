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
    const auto room = static_cast<std::size_t>(pairs.size()) + overrun;
    if (awake.size() < room) awake.resize(2 * room);
    const int count = find_awake_pairs(pairs, neighbours_.reach().data(), awake.data());
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
    const SegmentQuery query{pairs.first.data(),         pairs.second.data(),
                             pairs.image.data(),         state_.position[0].data(),
                             state_.cell.lattice.data(), neighbours_.travel().data(),
                             neighbours_.ahead().data(), range_,
                             neighbours_.widest_gap()};
    find_segment_distances(query, which.data(), static_cast<int>(which.size()), block_);
    for (std::size_t i = 0; i < which.size(); ++i)
      pairs.wake[static_cast<std::size_t>(which[i])] = block_.wake[i];
    for (std::size_t first = 0; first < which.size(); first += 8) {
      for (unsigned near = block_.near[first / 8]; near != 0; near &= near - 1) {
        const std::size_t i = first + static_cast<std::size_t>(__builtin_ctz(near));
        if (i < which.size()) keep(pairs, static_cast<std::size_t>(which[i]), i, contacts);
      }
    }
  }

  void keep(const RodPairs& pairs, std::size_t pair, std::size_t i, ContactChunk& contacts) const {
    const Index first = pairs.first[pair];
    const Index second = pairs.second[pair];
    if (second == first + 2 && pairs.image[pair] == 0 && is_exempt(second)) return;
    const Vec3 separation(block_.separation[0][i], block_.separation[1][i], block_.separation[2][i]);
    if (belongs_to_neighbour(first, block_.s[i], -separation)) return;
    if (belongs_to_neighbour(second, block_.t[i], separation)) return;
    contacts.add({first, second, block_.s[i], block_.t[i],
                  normal({first, second}, separation, block_.distance[i]), block_.distance[i],
                  pairs.image[pair], material_of(first), material_of(second)});
  }

  // Which fiber a rod belongs to lies far away in memory, and few contacts need it.
  [[nodiscard]] std::uint16_t material_of(Index rod) const {
    if (state_.materials.size() == 1) return 0;
    return state_.material_id[static_cast<std::size_t>(neighbours_.fiber_of(rod))];
  }
  [[nodiscard]] bool is_exempt(Index rod) const {
    return neighbours_.begins_fiber(rod) &&
           state_.touches_previous[static_cast<std::size_t>(neighbours_.fiber_of(rod))] != 0;
  }

  /// Tells whether a contact at the end of a rod is seen by the rod beyond the hinge as well, and belongs to
  /// that one: always at a rod's begin; at a rod's end when the next rod comes nearer. `other` leads to the
  /// other rod.
  [[nodiscard]] bool belongs_to_neighbour(Index rod, double place, const Vec3& other) const {
    if (place <= 0) return !neighbours_.begins_fiber(rod);
    if (place < 1 || neighbours_.ends_fiber(rod)) return false;
    const auto n = static_cast<std::size_t>(rod);
    return (state_.position[n + 2] - state_.position[n + 1]).dot(other) > 0;
  }

  /// Unit vector from the second rod to the first; axes that cross exactly are pushed apart across both.
  [[nodiscard]] Vec3 normal(const std::array<Index, 2>& rods, const Vec3& separation, double distance) const {
    if (distance > 0) return separation / distance;
    const auto axis = [this](Index rod) -> Vec3 {
      const auto n = static_cast<std::size_t>(rod);
      return state_.position[n + 1] - state_.position[n];
    };
    const Vec3 across = axis(rods[0]).cross(axis(rods[1]));
    return across.squaredNorm() > 0 ? across.normalized() : axis(rods[0]).unitOrthogonal();
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
  parallel_for_weighted(neighbours.chunk_entries(), [&](std::ptrdiff_t c) {
    const auto i = static_cast<std::size_t>(c);
    ChunkSearch(state, neighbours, range).run(chunks[i], awake_.mine(), contacts_[i]);
  });
}

}  // namespace fiberfate
