// Deals the forces of contacts to their rods.
#include "dynamics/pair_forces.hpp"

#include <numeric>
#include <utility>

#include "base/threads.hpp"
#include "fibers/rod_pairs.hpp"

namespace fiberfate {
namespace {

std::int64_t key_of(RodIndex other, std::int32_t image) {
  return static_cast<std::int64_t>(other.value()) << PairForces::image_bits | image;
}

}  // namespace

void PairForces::deal(const ContactSet& contacts, Index nodes) {
  count_forces(contacts);
  const int dealers = thread_count();
  next_.resize(dealers);
  parallel_for(dealers, [&](std::size_t dealer) { count_shares(contacts, dealer, nodes); });
  begin_shares(nodes);
  parallel_for(dealers, [&](std::size_t dealer) { place_shares(contacts, dealer); });
  sort_shares();
}

void PairForces::count_forces(const ContactSet& contacts) {
  chunk_begin_.resize(contacts.size() + 1);
  chunk_begin_[0] = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) chunk_begin_[c + 1] = chunk_begin_[c] + contacts[c].count;
  forces_.resize(chunk_begin_.back());
  shares_.resize(2 * forces_.size());
}

PairForces::Chunks PairForces::chunks_of(std::size_t dealer) const {
  // Not thread_count(): inside a parallel loop that is the count of a nested one (OMP_NUM_THREADS = "4,2").
  const auto dealers = static_cast<int>(next_.size());
  return {share_begin(chunk_begin_, dealer, dealers), share_begin(chunk_begin_, dealer + 1, dealers)};
}

void PairForces::count_shares(const ContactSet& contacts, std::size_t dealer, Index nodes) {
  RodCursors& count = next_[dealer];
  count.assign(nodes, ShareIndex(0));
  const Chunks mine = chunks_of(dealer);
  for (std::ptrdiff_t c = mine.begin; c < mine.end; ++c) {
    for (int i = 0; i < contacts[c].count; ++i) {
      ++count[contacts[c].first[i]];
      ++count[contacts[c].second[i]];
    }
  }
}

void PairForces::begin_shares(Index nodes) {
  begin_.resize(nodes + 1);
  const std::size_t parts = next_.size();
  const auto rods_of = [&](std::size_t part) -> IndexRange<RodIndex> {
    return {RodIndex(nodes * part / parts), RodIndex(nodes * (part + 1) / parts)};
  };
  part_begin_.assign(parts + 1, 0);
  parallel_for(parts, [&](std::size_t part) {
    for (const RodCursors& count : next_) {
      for (const RodIndex rod : rods_of(part)) part_begin_[part + 1] += count[rod].value();
    }
  });
  std::partial_sum(part_begin_.begin(), part_begin_.end(), part_begin_.begin());
  parallel_for(parts, [&](std::size_t part) {
    ShareIndex at(part_begin_[part]);
    for (const RodIndex rod : rods_of(part)) {
      begin_[rod] = at;
      for (RodCursors& next : next_) at = at + std::exchange(next[rod], at).value();
    }
  });
  begin_[RodIndex(nodes)] = ShareIndex(part_begin_.back());
}

void PairForces::place_shares(const ContactSet& contacts, std::size_t dealer) {
  RodCursors& next = next_[dealer];
  const Chunks mine = chunks_of(dealer);
  for (std::ptrdiff_t c = mine.begin; c < mine.end; ++c) {
    const ContactChunk& chunk = contacts[c];
    Index number = 2 * chunk_begin_[c];
    for (int i = 0; i < chunk.count; ++i) {
      const std::int32_t image = chunk.image[i];
      const std::int32_t back = image == 0 ? 0 : pack_image(-unpack_image(image));
      shares_[next[chunk.first[i]]++] = {key_of(chunk.second[i], image), number++};
      shares_[next[chunk.second[i]]++] = {key_of(chunk.first[i], back), number++};
    }
  }
}

void PairForces::sort_shares() {
  parallel_for(first_indices<RodIndex>(begin_.size() - 1), [&](RodIndex rod) {
    // Rods have a few shares at most: insertion is fastest.
    for (ShareIndex i = begin_[rod]; i < begin_[rod + 1]; ++i) {
      const Share moved = shares_[i];
      ShareIndex j = i;
      for (; j > begin_[rod] && shares_[j - 1].key > moved.key; j = j - 1) shares_[j] = shares_[j - 1];
      shares_[j] = moved;
    }
  });
}

}  // namespace fiberfate
