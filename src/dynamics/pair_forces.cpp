// Deals the forces of contacts to their rods.
#include "dynamics/pair_forces.hpp"

#include <numeric>
#include <utility>

#include "base/threads.hpp"
#include "fibers/rod_pairs.hpp"

namespace fiberfate {
namespace {

std::int64_t key_of(Index other, std::int32_t image) {
  return static_cast<std::int64_t>(other) << 30 | image;
}

}  // namespace

void PairForces::deal(const ContactSet& contacts, Index nodes) {
  count_forces(contacts);
  const int dealers = thread_count();
  next_.resize(static_cast<std::size_t>(dealers));
  parallel_for(dealers, [&](std::ptrdiff_t dealer) {
    count_shares(contacts, static_cast<int>(dealer), static_cast<std::size_t>(nodes));
  });
  begin_shares(static_cast<std::size_t>(nodes));
  parallel_for(dealers, [&](std::ptrdiff_t dealer) { place_shares(contacts, static_cast<int>(dealer)); });
  sort_shares();
}

void PairForces::count_forces(const ContactSet& contacts) {
  chunk_begin_.resize(contacts.size() + 1);
  chunk_begin_[0] = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) chunk_begin_[c + 1] = chunk_begin_[c] + contacts[c].count;
  forces_.resize(static_cast<std::size_t>(chunk_begin_.back()));
  shares_.resize(2 * forces_.size());
}

PairForces::Chunks PairForces::chunks_of(int dealer) const {
  const auto dealers = static_cast<int>(next_.size());
  return {static_cast<std::size_t>(share_begin(chunk_begin_, dealer, dealers)),
          static_cast<std::size_t>(share_begin(chunk_begin_, dealer + 1, dealers))};
}

void PairForces::count_shares(const ContactSet& contacts, int dealer, std::size_t nodes) {
  std::vector<Index>& count = next_[static_cast<std::size_t>(dealer)];
  count.assign(nodes, 0);
  const Chunks mine = chunks_of(dealer);
  for (std::size_t c = mine.begin; c < mine.end; ++c) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(contacts[c].count); ++i) {
      ++count[static_cast<std::size_t>(contacts[c].first[i])];
      ++count[static_cast<std::size_t>(contacts[c].second[i])];
    }
  }
}

void PairForces::begin_shares(std::size_t nodes) {
  begin_.resize(nodes + 1);
  const std::size_t parts = next_.size();
  const auto part_begin = [&](std::size_t part) { return static_cast<std::ptrdiff_t>(nodes * part / parts); };
  part_begin_.assign(parts + 1, 0);
  parallel_for(static_cast<std::ptrdiff_t>(parts), [&](std::ptrdiff_t i) {
    const auto part = static_cast<std::size_t>(i);
    for (const std::vector<Index>& count : next_)
      part_begin_[part + 1] +=
          std::accumulate(count.begin() + part_begin(part), count.begin() + part_begin(part + 1), Index{0});
  });
  std::partial_sum(part_begin_.begin(), part_begin_.end(), part_begin_.begin());
  parallel_for(static_cast<std::ptrdiff_t>(parts), [&](std::ptrdiff_t i) {
    const auto part = static_cast<std::size_t>(i);
    Index at = part_begin_[part];
    for (auto rod = static_cast<std::size_t>(part_begin(part));
         rod < static_cast<std::size_t>(part_begin(part + 1)); ++rod) {
      begin_[rod] = at;
      for (std::vector<Index>& next : next_) at += std::exchange(next[rod], at);
    }
  });
  begin_[nodes] = part_begin_.back();
}

void PairForces::place_shares(const ContactSet& contacts, int dealer) {
  std::vector<Index>& next = next_[static_cast<std::size_t>(dealer)];
  const auto put = [&](Index rod, const Share& share) {
    shares_[static_cast<std::size_t>(next[static_cast<std::size_t>(rod)]++)] = share;
  };
  const Chunks mine = chunks_of(dealer);
  for (std::size_t c = mine.begin; c < mine.end; ++c) {
    const ContactChunk& chunk = contacts[c];
    Index number = 2 * chunk_begin_[c];
    for (std::size_t i = 0; i < static_cast<std::size_t>(chunk.count); ++i) {
      const std::int32_t image = chunk.image[i];
      const std::int32_t back = image == 0 ? 0 : pack_image(-unpack_image(image));
      put(chunk.first[i], {key_of(chunk.second[i], image), number++});
      put(chunk.second[i], {key_of(chunk.first[i], back), number++});
    }
  }
}

void PairForces::sort_shares() {
  parallel_for(static_cast<std::ptrdiff_t>(begin_.size()) - 1, [&](std::ptrdiff_t rod) {
    const auto r = static_cast<std::size_t>(rod);
    // Rods have a few shares at most: insertion is fastest.
    for (Index i = begin_[r] + 1; i < begin_[r + 1]; ++i) {
      const Share moved = shares_[static_cast<std::size_t>(i)];
      Index j = i;
      for (; j > begin_[r] && shares_[static_cast<std::size_t>(j) - 1].key > moved.key; --j)
        shares_[static_cast<std::size_t>(j)] = shares_[static_cast<std::size_t>(j) - 1];
      shares_[static_cast<std::size_t>(j)] = moved;
    }
  });
}

}  // namespace fiberfate
