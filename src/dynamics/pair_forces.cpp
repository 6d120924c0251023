// Deals the forces of contacts to their rods.
#include "dynamics/pair_forces.hpp"

#include <atomic>

#include "base/threads.hpp"
#include "fibers/rod_pairs.hpp"

namespace fiberfate {
namespace {

std::int64_t key_of(Index other, std::int32_t image) {
  return static_cast<std::int64_t>(other) << 24 | image;
}

/// Adds one and returns what was there before; threads may do so at the same time.
Index take_one(Index& number, bool is_alone) {
  return is_alone ? number++ : std::atomic_ref<Index>(number).fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

void PairForces::deal(const ContactSet& contacts, Index nodes) {
  count_forces(contacts);
  count_shares(contacts, static_cast<std::size_t>(nodes));
  place_shares(contacts);
  sort_shares();
}

void PairForces::count_forces(const ContactSet& contacts) {
  chunk_begin_.resize(contacts.size() + 1);
  chunk_begin_[0] = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) chunk_begin_[c + 1] = chunk_begin_[c] + contacts[c].count;
  forces_.resize(static_cast<std::size_t>(chunk_begin_.back()));
  shares_.resize(2 * forces_.size());
}

void PairForces::count_shares(const ContactSet& contacts, std::size_t nodes) {
  count_.assign(nodes, 0);
  rank_.resize(shares_.size());
  const bool is_alone = thread_count() == 1;
  parallel_for(static_cast<std::ptrdiff_t>(contacts.size()), [&](std::ptrdiff_t c) {
    const ContactChunk& chunk = contacts[static_cast<std::size_t>(c)];
    auto share = static_cast<std::size_t>(2 * chunk_begin_[static_cast<std::size_t>(c)]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(chunk.count); ++i) {
      rank_[share++] = take_one(count_[static_cast<std::size_t>(chunk.first[i])], is_alone);
      rank_[share++] = take_one(count_[static_cast<std::size_t>(chunk.second[i])], is_alone);
    }
  });
  begin_.resize(nodes + 1);
  Index sum = 0;
  for (std::size_t rod = 0; rod < nodes; ++rod) {
    begin_[rod] = sum;
    sum += count_[rod];
  }
  begin_[nodes] = sum;
}

void PairForces::place_shares(const ContactSet& contacts) {
  const auto put = [&](Index rod, const Share& share) {
    const Index at = begin_[static_cast<std::size_t>(rod)] + rank_[static_cast<std::size_t>(share.number)];
    shares_[static_cast<std::size_t>(at)] = share;
  };
  parallel_for(static_cast<std::ptrdiff_t>(contacts.size()), [&](std::ptrdiff_t c) {
    const ContactChunk& chunk = contacts[static_cast<std::size_t>(c)];
    Index number = 2 * chunk_begin_[static_cast<std::size_t>(c)];
    for (std::size_t i = 0; i < static_cast<std::size_t>(chunk.count); ++i) {
      const std::int32_t image = chunk.image[i];
      const std::int32_t back = image == 0 ? 0 : pack_image(-unpack_image(image));
      put(chunk.first[i], {key_of(chunk.second[i], image), number++});
      put(chunk.second[i], {key_of(chunk.first[i], back), number++});
    }
  });
}

void PairForces::sort_shares() {
  parallel_for(static_cast<std::ptrdiff_t>(count_.size()), [&](std::ptrdiff_t rod) {
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
